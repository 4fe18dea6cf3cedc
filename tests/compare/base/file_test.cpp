#include "compare/base/file.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "compare/base/errors.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

ExitCode exit_code_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.exit_code();
  }
  return ExitCode::success;
}

TEST(File, ReplacesTheWholeContent) {
  const TemporaryFolder folder;
  write_file(folder / "a", "a long first content");
  write_file(folder / "a", "second");
  EXPECT_EQ(folder.read("a"), "second");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(File, IsNotThereBeforeTheCommit) {
  const TemporaryFolder folder;
  {
    PendingFile pending(folder / "a");
    pending.write("content");
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    EXPECT_EQ(pending.path().parent_path(), folder.path());
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(File, KeepsTheOldContentWhenTheNewOneIsAbandoned) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  { PendingFile(folder / "a").write("half of the n"); }
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(File, FailsWithItsNameAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  EXPECT_EQ(exit_code_of([&] { write_file(folder / "no/such/folder", "x"); }), ExitCode::file_failed);
  std::filesystem::create_directory(folder / "taken");
  std::filesystem::create_directory(folder / "taken/inside");
  EXPECT_EQ(exit_code_of([&] { write_file(folder / "taken", "x"); }), ExitCode::file_failed);
  EXPECT_EQ(folder.entries(), 1u);
  try {
    write_file(folder / "taken", "x");
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((folder / "taken").string()), std::string::npos);
  }
}

}  // namespace
