#include "atomistic/protocol/job.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

using namespace atomistic;
namespace fs = std::filesystem;

class JobFile : public testing::Test {
 protected:
  fs::path file = fs::temp_directory_path() /
                  ("job-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".json");
  void TearDown() override { fs::remove(file); }
};

TEST_F(JobFile, ACurveSurvives) {
  Problem p;
  p.potential.pair_coeff = {"* * {file} C"};
  p.potential.file = "/a b/c";
  p.card.a0_A = 2.4192432769921406;
  p.radius_A = 30;
  p.biaxial_strain = 1e-3;
  p.load = DiscLoad{7.5};
  p.control = Control::force;
  p.levels = {0.1, 0.2};
  p.past_artefact = true;
  write_job({CurveJob{p, "/steps"}, "/log"}, file);
  const Job job = read_job(file);
  EXPECT_EQ(job.log_file, "/log");
  const CurveJob& curve = std::get<CurveJob>(job.work);
  EXPECT_EQ(curve.steps_folder, "/steps");
  EXPECT_EQ(curve.problem.potential.file, "/a b/c");
  EXPECT_EQ(curve.problem.potential.pair_coeff, p.potential.pair_coeff);
  EXPECT_EQ(curve.problem.card.a0_A, p.card.a0_A);
  EXPECT_EQ(curve.problem.radius_A, 30);
  EXPECT_EQ(curve.problem.biaxial_strain, 1e-3);
  EXPECT_EQ(std::get<DiscLoad>(curve.problem.load).radius_A, 7.5);
  EXPECT_EQ(curve.problem.control, Control::force);
  EXPECT_EQ(curve.problem.levels, p.levels);
  EXPECT_TRUE(curve.problem.past_artefact);
}

TEST_F(JobFile, ACardSurvives) {
  Potential potential;
  potential.pair_style = "rebo";
  write_job({CardJob{potential}, "/log"}, file);
  EXPECT_EQ(std::get<CardJob>(read_job(file).work).potential.pair_style, "rebo");
}

TEST_F(JobFile, BrokenFilesAreNamed) {
  std::ofstream(file) << "{\"log_file\": 1}";
  try {
    read_job(file);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos);
  }
  EXPECT_THROW(read_job("/nowhere/job.json"), std::runtime_error);
}

}  // namespace
