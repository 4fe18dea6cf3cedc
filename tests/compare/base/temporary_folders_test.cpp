#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <memory>

#include "compare/base/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using Folder = validate::TemporaryFolder;

/// The system's temporary folder for one test.
class TemporaryFolders : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "validate-test-XXXXXX").string();
    place_ = ::mkdtemp(name.data());
    ::setenv("TMPDIR", place_.c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("TMPDIR");
    fs::remove_all(place_);
  }
  long entries() const { return std::distance(fs::directory_iterator(place_), {}); }
  fs::path place_;
};

TEST_F(TemporaryFolders, GoWithTheirOwner) {
  { const Folder one("mine"), other("mine"); }
  EXPECT_EQ(entries(), 0);
}

TEST_F(TemporaryFolders, OfKilledProgramsGoAndThoseInUseStay) {
  const pid_t child = ::fork();
  if (child == 0) {
    const Folder left("mine");
    std::ofstream(left.path() / "log") << "half";
    ::_exit(0);  // as a kill: nothing is tidied
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(entries(), 1);
  fs::create_directory(place_ / "mine-of-the-user");
  const Folder one("mine");
  EXPECT_EQ(entries(), 2) << "the new one and the user's";
  const Folder other("mine");
  EXPECT_EQ(entries(), 3);
}

TEST_F(TemporaryFolders, KeptOnesStayForADay) {
  std::make_unique<Folder>("mine")->keep();
  { const Folder next("mine"); }
  EXPECT_EQ(entries(), 1);
  const fs::path kept = fs::directory_iterator(place_)->path() / "kept";
  fs::last_write_time(kept, fs::file_time_type::clock::now() - std::chrono::hours(25));
  { const Folder next("mine"); }
  EXPECT_EQ(entries(), 0);
}

}  // namespace
