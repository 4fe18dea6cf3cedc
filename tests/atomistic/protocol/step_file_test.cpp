#include "atomistic/protocol/step_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace {

using namespace atomistic;
namespace fs = std::filesystem;

class StepFile : public testing::Test {
 protected:
  fs::path folder = fs::temp_directory_path() /
                    ("steps-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  void SetUp() override { fs::remove_all(folder), fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  static Step step(int level) {
    Step s;
    s.level = level;
    s.target = 3.5;
    s.converged = true;
    s.depth_A = 1.25;
    s.force_eV_per_A = 0.1 + level;
    s.longest_bond_A = 1.5;
    s.evaluations = 9;
    s.positions = Eigen::VectorXd::Random(12);
    s.forces = Eigen::VectorXd::Random(12);
    s.factorised_at = Eigen::VectorXd::Random(12);
    return s;
  }
};

TEST_F(StepFile, EveryMemberSurvivesToTheLastBit) {
  Step before = step(3);
  before.unloading = true;
  before.broken = true;
  before.virials = Eigen::VectorXd::Random(24);
  write_step(before, folder);
  const Step after = read_step(folder / step_file_name(3));
  EXPECT_EQ(after.level, 3);
  EXPECT_TRUE(after.unloading);
  EXPECT_FALSE(after.search);
  EXPECT_TRUE(after.broken);
  EXPECT_EQ(after.target, before.target);
  EXPECT_TRUE(after.converged);
  EXPECT_EQ(after.depth_A, before.depth_A);
  EXPECT_EQ(after.force_eV_per_A, before.force_eV_per_A);
  EXPECT_EQ(after.longest_bond_A, before.longest_bond_A);
  EXPECT_EQ(after.evaluations, 9);
  EXPECT_EQ(after.positions, before.positions);
  EXPECT_EQ(after.forces, before.forces);
  EXPECT_EQ(after.factorised_at, before.factorised_at);
  EXPECT_EQ(after.virials, before.virials);
}

TEST_F(StepFile, FinishedStepsEndAtTheFirstGap) {
  for (int level : {0, 1, 3}) write_step(step(level), folder);
  EXPECT_EQ(read_finished_steps(folder).size(), 2u);
  EXPECT_EQ(read_way_there(folder).back().level, 1);
  Step back = step(2);
  back.unloading = true;
  write_step(back, folder);
  fs::remove(folder / step_file_name(3));
  EXPECT_EQ(read_finished_steps(folder).size(), 3u);
  EXPECT_EQ(read_way_there(folder).back().level, 1) << "the way back is not the deepest";
  Step search = step(3);
  search.search = true;
  write_step(search, folder);
  EXPECT_TRUE(read_step(folder / step_file_name(3)).search);
  EXPECT_EQ(read_way_there(folder).back().level, 1) << "nor is a search";
  EXPECT_TRUE(read_way_there(folder / "nowhere").empty());
}

/// A path of a large sheet would not fit into the memory otherwise.
TEST_F(StepFile, OldStepsAreReadWithoutTheirVectors) {
  for (int level = 0; level < 10; ++level) write_step(step(level), folder);
  const std::vector<Step> steps = read_finished_steps(folder);
  ASSERT_EQ(steps.size(), 10u);
  EXPECT_EQ(steps[2].positions.size(), 0);
  EXPECT_EQ(steps[2].force_eV_per_A, step(2).force_eV_per_A);
  EXPECT_EQ(steps[8].factorised_at.size(), 0);
  for (int level : {7, 8, 9}) EXPECT_EQ(steps[level].positions.size(), step(level).positions.size());
  EXPECT_EQ(steps[9].factorised_at.size(), step(9).factorised_at.size());
  const std::vector<Step> there = read_way_there(folder);
  EXPECT_EQ(there.back().forces.size(), step(9).forces.size());
  EXPECT_EQ(there[2].positions, read_step(folder / step_file_name(2)).positions);
  EXPECT_EQ(there[2].forces.size(), 0);
}

TEST_F(StepFile, AFileCutShortIsRefusedByName) {
  write_step(step(0), folder);
  const fs::path file = folder / step_file_name(0);
  for (const auto size : {fs::file_size(file) - 8, std::uintmax_t{10}}) {
    fs::resize_file(file, size);
    try {
      read_step(file);
      FAIL() << size;
    } catch (const std::runtime_error& e) {
      EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos);
    }
  }
}

/// Every byte of the first kilobyte, in the header and in the vectors.
TEST_F(StepFile, OneFlippedBitIsSeen) {
  for (int level : {0, 1, 2}) write_step(step(level), folder);
  const fs::path file = folder / step_file_name(1);
  for (std::uintmax_t at = 0; at < std::min<std::uintmax_t>(fs::file_size(file), 1000); ++at) {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekg(static_cast<std::streamoff>(at));
    const int before = bytes.get();
    bytes.seekp(static_cast<std::streamoff>(at)).put(static_cast<char>(before ^ 1 << at % 8)).flush();
    EXPECT_THROW(read_step(file), std::runtime_error) << at;
    EXPECT_EQ(read_finished_steps(folder).size(), 1u) << at;
    bytes.seekp(static_cast<std::streamoff>(at)).put(static_cast<char>(before)).flush();
  }
  EXPECT_EQ(read_finished_steps(folder).size(), 3u);
}

/// Lengths whose sum is that of the file only because it wraps around.
TEST_F(StepFile, LengthsThatNoFileHasAreRefused) {
  write_step(step(0), folder);
  const fs::path file = folder / step_file_name(0);
  const auto header_bytes =
      fs::file_size(file) - sizeof(double) * 3 * static_cast<std::size_t>(step(0).positions.size());
  for (const std::int64_t length : {std::int64_t{1} << 61, std::int64_t{1} << 62, std::int64_t{-1}}) {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(header_bytes - 5 * 8));
    for (int i = 0; i < 4; ++i) bytes.write(reinterpret_cast<const char*>(&length), sizeof length);
    bytes.flush();
    EXPECT_THROW(read_step(file), std::runtime_error) << length;
  }
}

TEST_F(StepFile, AnUnfinishedWriteIsNotSeen) {
  std::ofstream(folder / (step_file_name(0).string() + ".part")) << "half";
  EXPECT_TRUE(read_finished_steps(folder).empty());
}

TEST_F(StepFile, AFullDiskIsReportedAndLeavesNothing) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  fs::create_symlink("/dev/full", folder / (step_file_name(0).string() + ".part"));
  EXPECT_THROW(write_step(step(0), folder), std::system_error);
  EXPECT_FALSE(fs::exists(folder / step_file_name(0)));
}

}  // namespace
