#include "compare/base/file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <functional>
#include <thread>

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

TEST(File, KeepsToItsNameWhateverIsThere) {
  const TemporaryFolder folder;
  write_file(folder / "precious", "mine");
  std::filesystem::create_symlink(folder / "precious", folder / "link");
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  for (const char* name : {"link", "fifo"}) {
    write_file(folder / name, "new");
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(folder / name))) << name;
  }
  EXPECT_EQ(folder.read("precious"), "mine");
}

TEST(File, ANameThatNoFileCanHaveIsBadInput) {
  const TemporaryFolder folder;
  EXPECT_EQ(exit_code_of([&] { write_file(folder / std::string(300, 'x'), "x"); }), ExitCode::bad_input);
  EXPECT_EQ(exit_code_of([&] { write_users_file(folder / std::string(300, 'x'), "x"); }), ExitCode::bad_input);
  write_file(folder / std::string(255, 'x'), "as long as a name may be");
  EXPECT_EQ(folder.entries(), 1u);
}

/// Left by a killed program whose process id is ours: it neither stays nor stands in the way.
TEST(File, TemporariesOfKilledProgramsGo) {
  const TemporaryFolder folder;
  for (int count = 0; count < 2000; ++count)
    std::ofstream(folder / (".a." + std::to_string(::getpid()) + "-" + std::to_string(count) + ".tmp")) << "half";
  std::ofstream(folder / ".a.mine.tmp") << "of the user's";
  std::ofstream(folder / ".b.1-1.tmp") << "another target's";
  write_file(folder / "a", "whole");
  EXPECT_EQ(folder.read("a"), "whole");
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(File, TemporariesOfLivingProgramsStay) {
  const TemporaryFolder folder;
  PendingFile first(folder / "a"), second(folder / "a");
  first.write("first");
  second.write("second");
  EXPECT_NE(first.path(), second.path());
  second.commit();
  first.commit();
  EXPECT_EQ(folder.read("a"), "first");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(UsersFile, LinksAreFollowedAndPermissionsStay) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "deep");
  write_file(folder / "deep/file", "old");
  ::chmod((folder / "deep/file").c_str(), 0640);
  std::filesystem::create_symlink("deep/second", folder / "first");
  std::filesystem::create_symlink("file", folder / "deep/second");
  std::filesystem::create_symlink("deep/new", folder / "dangling");
  std::filesystem::create_symlink("loop", folder / "loop");
  write_users_file(folder / "first", "new");
  EXPECT_EQ(folder.read("deep/file"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "first"));
  EXPECT_EQ(std::filesystem::status(folder / "deep/file").permissions(), std::filesystem::perms(0640));
  check_users_file(folder / "dangling");
  EXPECT_FALSE(std::filesystem::exists(folder / "deep/new"));
  write_users_file(folder / "dangling", "made");
  EXPECT_EQ(folder.read("deep/new"), "made");
  EXPECT_EQ(exit_code_of([&] { write_users_file(folder / "loop", "x"); }), ExitCode::file_failed);
  EXPECT_EQ(exit_code_of([&] { check_users_file(folder / "deep"); }), ExitCode::file_failed);
}

TEST(UsersFile, FifosAndOpenFilesAreWrittenInto) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  check_users_file(folder / "fifo");
  std::string got;
  std::thread reader([&] { got = folder.read("fifo"); });
  write_users_file(folder / "fifo", "through");
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "fifo"));

  std::ofstream(folder / "open") << "first, ";
  const int open_file = ::open((folder / "open").c_str(), O_WRONLY);
  write_users_file("/proc/self/fd/" + std::to_string(open_file), "second");
  EXPECT_EQ(folder.read("open"), "first, second");
  ::close(open_file);
}

TEST(UsersFile, DevicesStayDevices) {
  const TemporaryFolder folder;
  const auto null = folder / "null", full = folder / "full";
  if (::mknod(null.c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0 || ::mknod(full.c_str(), S_IFCHR | 0666, makedev(1, 7)))
    GTEST_SKIP() << "nodes can only be made with privileges";
  std::filesystem::create_symlink("null", folder / "link");
  if (::access(null.c_str(), W_OK) != 0 || !std::ofstream(null)) GTEST_SKIP() << "a file system without devices";
  for (const char* name : {"null", "link"}) {
    check_users_file(folder / name);
    write_users_file(folder / name, "gone");
  }
  EXPECT_EQ(exit_code_of([&] { write_users_file(full, "too much"); }), ExitCode::file_failed);
  EXPECT_TRUE(std::filesystem::is_character_file(null));
  EXPECT_TRUE(std::filesystem::is_character_file(full));
  EXPECT_EQ(folder.entries(), 3u);
}

}  // namespace
