#include "compare/base/child_process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

using Words = std::vector<std::string>;

ChildCommand shell(const std::string& script) { return {.words = {"sh", "-c", script}}; }

ExitCode code_of_starting(const ChildCommand& command) {
  try {
    ChildProcess child(command);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(command.words.front()), std::string::npos) << error.what();
    return error.exit_code();
  }
  return ExitCode::success;
}

TEST(ChildProcess, TellsHowItEnded) {
  ChildProcess good(shell("exit 0")), code(shell("exit 7")), killed(shell("kill -9 $$"));
  EXPECT_TRUE(good.wait().good());
  EXPECT_EQ(code.wait().exit_code, 7);
  EXPECT_FALSE(code.wait().good());
  EXPECT_EQ(killed.wait().signal, SIGKILL);
  EXPECT_FALSE(killed.wait().good());
}

TEST(ChildProcess, HandsOutWholeLinesAsTheyCome) {
  ChildProcess child(shell("printf 'one\\ntwo\\nhal'; sleep 0.2; printf 'f\\nrest'"));
  Words lines;
  while (child.output() >= 0)
    for (const std::string& line : child.read_lines()) lines.push_back(line);
  EXPECT_EQ(lines, (Words{"one", "two", "half"}));
}

TEST(ChildProcess, IsReadToTheEndWithTheUnfinishedLineAndMixedErrors) {
  ChildProcess child(shell("echo out; echo err >&2; printf rest"));
  EXPECT_EQ(child.read_to_end(), "out\nerr\nrest");
  EXPECT_TRUE(child.wait().good());
}

TEST(ChildProcess, KeepsItsStandardErrorInAFileAndRunsInItsFolder) {
  const TemporaryFolder folder;
  ChildCommand command = shell("pwd; echo wrong >&2; cat");  // cat: standard input is empty
  command.folder = folder.path();
  command.standard_error = folder / "errors";
  ChildProcess child(command);
  EXPECT_EQ(child.read_to_end(), std::filesystem::canonical(folder.path()).string() + "\n");
  EXPECT_EQ(folder.read("errors"), "wrong\n");
}

TEST(ChildProcess, VariablesAreDefaultsThatTheUsersOwnValuesWin) {
  ::setenv("VALIDATE_TEST_MINE", "mine", 1);
  ChildCommand command = shell("printf \"$VALIDATE_TEST_MINE $VALIDATE_TEST_OTHER\"");
  command.environment = {{"VALIDATE_TEST_MINE", "theirs"}, {"VALIDATE_TEST_OTHER", "default"}};
  EXPECT_EQ(ChildProcess(command).read_to_end(), "mine default");
}

TEST(ChildProcess, WhatCannotBeStartedIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(code_of_starting({.words = {"no-such-program-at-all"}}), ExitCode::atomistic_failed);
  ChildCommand other{.words = {"no-such-program-at-all"}};
  other.if_not_started = ExitCode::file_failed;
  EXPECT_EQ(code_of_starting(other), ExitCode::file_failed);
  std::ofstream(folder / "text") << "no program\n";
  EXPECT_EQ(code_of_starting({.words = {(folder / "text").string()}}), ExitCode::atomistic_failed);
  ChildCommand nowhere = shell("true");
  nowhere.words.front() = std::filesystem::path("/bin/sh").string();
  nowhere.folder = folder / "missing";
  EXPECT_EQ(code_of_starting(nowhere), ExitCode::atomistic_failed);
}

TEST(ChildProcess, StopEndsTheWholeGroupAlsoWhereItDoesNotListen) {
  const TemporaryFolder folder;
  const auto script = "trap '' TERM; sleep 60 & echo $!; while :; do sleep 0.1; done";
  ChildProcess child(shell(script));
  pid_t grandchild = 0;
  while (grandchild == 0)
    for (const std::string& line : child.read_lines()) grandchild = std::stoi(line);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(child.stop().signal, SIGKILL);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  // It may stay for a moment as a zombie of whoever takes orphans.
  const auto gone = [&] {
    std::ifstream in("/proc/" + std::to_string(grandchild) + "/stat");
    std::string id, name, state;
    return !(in >> id >> name >> state) || state == "Z";
  };
  for (int i = 0; i < 100 && !gone(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(gone());
}

TEST(ChildProcess, IsStoppedWithTheObject) {
  pid_t id = 0;
  {
    ChildProcess child(shell("echo $$; exec sleep 60"));
    while (id == 0)
      for (const std::string& line : child.read_lines()) id = std::stoi(line);
  }
  EXPECT_EQ(::kill(id, 0), -1);
}

/// Of three descriptors of this program the child has what it is given.
TEST(ChildProcess, MayLetLocksGo) {
  const int held = ::open("/", O_RDONLY | O_DIRECTORY);
  ChildCommand command = shell("test -e /proc/self/fd/" + std::to_string(held));
  EXPECT_EQ(ChildProcess(command).wait().exit_code, 0);
  command.holds_locks = false;
  EXPECT_EQ(ChildProcess(command).wait().exit_code, 1);
  ::close(held);
}

}  // namespace
