// What the standard streams cannot take ends no run, and is not hidden either.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <fstream>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
namespace fs = std::filesystem;

const Words membrane = {"indentation", "--models", "membrane", "--loads",  "disc", "--E",          "5", "--thickness",
                        "1",           "--nu",     "0.2",      "--radius", "60",   "--tip-radius", "6", "--depth-step",
                        "6",           "--out",    "run"};

/// Through a shell, for its redirections; `$V` is the program.
int in_shell(const std::string& line, const fs::path& folder) {
  const std::string command = "cd '" + folder.string() + "' && V='" VALIDATE_PROGRAM "' && " + line;
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string joined(const Words& words) {
  std::string line = "\"$V\"";
  for (const std::string& word : words) line += " '" + word + "'";
  return line;
}

/// A device that takes nothing, made for the test; empty where that is not allowed.
std::string full_device(const fs::path& folder) {
  const fs::path full = folder / "full";
  if (::mknod(full.c_str(), S_IFCHR | 0666, makedev(1, 7)) != 0 || ::open(full.c_str(), O_WRONLY) < 0) return {};
  return full.string();
}

void expect_finished(const fs::path& run, int exit_code) {
  std::ifstream in(run / ".validate-run");
  std::string first, second;
  std::getline(in, first);
  std::getline(in, second);
  EXPECT_EQ(second, "exit_code " + std::to_string(exit_code));
  EXPECT_TRUE(fs::exists(run / "report.html"));
  EXPECT_FALSE(fs::exists(run / "work"));
}

TEST(Streams, AClosedStandardErrorEndsNothing) {
  const WorkFolder folder;
  EXPECT_EQ(in_shell(joined(membrane) + " >/dev/null 2>&-", folder.path()), 0);
  expect_finished(folder.path() / "run", 0);
  EXPECT_EQ(in_shell("\"$V\" indentation --radius x 2>&-", folder.path()), 2);
}

TEST(Streams, AClosedStandardOutputIsToldAfterEverythingIsWritten) {
  const WorkFolder folder;
  EXPECT_EQ(in_shell(joined(membrane) + " >&- 2>said", folder.path()), 6);
  expect_finished(folder.path() / "run", 0);
  std::ifstream said(folder.path() / "said");
  const std::string text{std::istreambuf_iterator<char>(said), {}};
  EXPECT_NE(text.find("cannot write to stdout"), std::string::npos) << text;
}

/// A pipe that takes a page and does not wait: everything comes through all the same.
TEST(Streams, AnOutputThatDoesNotWaitGetsAll) {
  const WorkFolder folder;
  folder.write("pipe.py",
               "import fcntl, os, subprocess, sys, time\n"
               "read, write = os.pipe()\n"
               "fcntl.fcntl(write, 1031, 4096)  # F_SETPIPE_SZ\n"
               "os.set_blocking(write, False)\n"
               "child = subprocess.Popen([sys.argv[1], 'schema', 'summary'], stdout=write)\n"
               "os.close(write)\n"
               "time.sleep(0.5)\n"
               "open('came', 'wb').write(os.fdopen(read, 'rb').read())\n"
               "sys.exit(child.wait())\n");
  EXPECT_EQ(in_shell("\"$V\" schema summary >whole", folder.path()), 0);
  EXPECT_EQ(in_shell("python3 pipe.py \"$V\"", folder.path()), 0);
  EXPECT_GT(fs::file_size(folder.path() / "whole"), 10000u);
  EXPECT_EQ(fs::file_size(folder.path() / "came"), fs::file_size(folder.path() / "whole"));
}

TEST(Streams, AReaderThatHasGoneEndsNoRun) {
  const WorkFolder folder;
  in_shell(joined(membrane) + " 2>said | true", folder.path());
  expect_finished(folder.path() / "run", 0);
}

TEST(Streams, FullOnes) {
  const WorkFolder folder, devices;
  const std::string full = full_device(devices.path());
  if (full.empty()) GTEST_SKIP() << "nodes can only be made with privileges";
  EXPECT_EQ(in_shell(joined(membrane) + " >/dev/null 2>" + full, folder.path()), 0);
  expect_finished(folder.path() / "run", 0);
  for (const char* command : {"--help", "--version", "model", "indentation --help", "schema summary"})
    EXPECT_EQ(in_shell(std::string("\"$V\" ") + command + " 2>/dev/null >" + full, folder.path()), 6) << command;
}

}  // namespace
