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

/// Paths are bytes.
TEST_F(JobFile, APathNeedNotBeText) {
  CardJob card;
  card.potential.name = "caf\xe9";
  card.potential.file = "/a\nb/\xff\xfe\x80/\xc3\xa9/\"'";
  write_job({card, "/log\xc3"}, file);
  const Job job = read_job(file);
  EXPECT_EQ(job.log_file, "/log\xc3");
  EXPECT_EQ(std::get<CardJob>(job.work).potential.file, card.potential.file);
  EXPECT_EQ(std::get<CardJob>(job.work).potential.name, card.potential.name);
}

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
  p.preconditioning = Preconditioning::multigrid;
  p.ripple_A = 0.25;
  p.ripple_seed = 5;
  p.virials = true;
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
  EXPECT_EQ(curve.problem.preconditioning, Preconditioning::multigrid);
  EXPECT_EQ(curve.problem.ripple_A, 0.25);
  EXPECT_EQ(curve.problem.ripple_seed, 5u);
  EXPECT_TRUE(curve.problem.virials);
}

TEST_F(JobFile, EveryLoadAndTheSheetsFormSurvive) {
  Problem p;
  p.unload = true;
  p.form = {.shape = Shape::square,
            .edge = Edge::sliding,
            .centre = Centre::atom,
            .rotation_deg = 12.5,
            .vacancies = {{1, 2}},
            .stone_wales = {{3, -4}, {5, 6}}};
  const Load loads[] = {PointLoad{}, DiscLoad{7.5}, SphereLoad{.radius_A = 30, .stiffness_eV_per_A3 = 50},
                        PressureLoad{false}};
  for (const Load& load : loads) {
    p.load = load;
    write_job({CurveJob{p, "/steps"}, "/log"}, file);
    const Problem back = std::get<CurveJob>(read_job(file).work).problem;
    ASSERT_EQ(back.load.index(), load.index());
    EXPECT_TRUE(back.unload);
    EXPECT_EQ(back.form.shape, Shape::square);
    EXPECT_EQ(back.form.edge, Edge::sliding);
    EXPECT_EQ(back.form.centre, Centre::atom);
    EXPECT_EQ(back.form.rotation_deg, 12.5);
    EXPECT_EQ(back.form.vacancies, p.form.vacancies);
    EXPECT_EQ(back.form.stone_wales, p.form.stone_wales);
    if (const auto* sphere = std::get_if<SphereLoad>(&back.load)) {
      EXPECT_EQ(sphere->radius_A, 30);
      EXPECT_EQ(sphere->stiffness_eV_per_A3, 50);
    }
    if (const auto* pressure = std::get_if<PressureLoad>(&back.load)) {
      EXPECT_FALSE(pressure->following);
    }
  }
}

TEST_F(JobFile, ACardSurvives) {
  Potential potential;
  potential.pair_style = "rebo";
  write_job({CardJob{potential}, "/log"}, file);
  EXPECT_EQ(std::get<CardJob>(read_job(file).work).potential.pair_style, "rebo");
}

TEST_F(JobFile, PositionsToProbeKeepAllDigits) {
  const Eigen::VectorXd one = Eigen::Vector3d(0.1, 1.0 / 3, -2), two = Eigen::Vector3d(1e-17, 0, 5);
  write_job({ForcesJob{{.pair_style = "rebo"}, {one, two}}, "/log"}, file);
  const Job job = read_job(file);
  const auto& back = std::get<ForcesJob>(job.work);
  EXPECT_EQ(back.potential.pair_style, "rebo");
  ASSERT_EQ(back.positions.size(), 2u);
  EXPECT_EQ(back.positions[0], one);
  EXPECT_EQ(back.positions[1], two);
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
