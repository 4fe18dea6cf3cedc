#include "compare/base/read_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <fstream>

#include "compare/base/errors.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

ExitCode exit_code_of(const std::filesystem::path& file) {
  try {
    read_file(file);
  } catch (const Error& error) {
    return error.exit_code();
  }
  return ExitCode::success;
}

TEST(ReadFile, AFifoThatNobodyWritesIntoIsEmpty) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(read_file(folder / "fifo"), "");
  EXPECT_EQ(read_if_there(folder / "fifo"), std::nullopt);
}

TEST(ReadFile, AFifoIsReadToItsEnd) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string text(30000, 'x');
  ASSERT_EQ(::write(ends[1], text.data(), text.size()), 30000);
  ::close(ends[1]);
  EXPECT_EQ(read_file("/proc/self/fd/" + std::to_string(ends[0])), text);
  ::close(ends[0]);
}

TEST(ReadFile, DevicesAreNoFiles) {
  const TemporaryFolder folder;
  if (::mknod((folder / "zero").c_str(), S_IFCHR | 0666, makedev(1, 5)) != 0)
    GTEST_SKIP() << "nodes can only be made with privileges";
  EXPECT_EQ(exit_code_of(folder / "zero"), ExitCode::bad_input);
}

TEST(ReadFile, MoreThanMemoryShouldHoldIsRefused) {
  const TemporaryFolder folder;
  std::ofstream(folder / "sparse") << "x";
  std::filesystem::resize_file(folder / "sparse", std::uintmax_t{1} << 40);
  EXPECT_EQ(exit_code_of(folder / "sparse"), ExitCode::file_failed);
}

TEST(ReadFile, WhatCannotBeLookedAt) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_EQ(exit_code_of(folder / "loop"), ExitCode::file_failed);
  EXPECT_EQ(exit_code_of(folder / std::string(300, 'x')), ExitCode::bad_input);
  EXPECT_EQ(exit_code_of(folder / "none"), ExitCode::bad_input);
  EXPECT_EQ(exit_code_of(folder.path()), ExitCode::bad_input);
}

}  // namespace
