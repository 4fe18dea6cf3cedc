// Atoms and membranes at every depth, kept in run.h5 and read back.
#include "compare/documents/bytes/trajectory_h5.hpp"

#include <gtest/gtest.h>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/bytes/run_h5_read.hpp"
#include "tests/compare/results/complete_result.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

AtomsTrajectory trajectory() {
  return {.load = "disc",
          .atoms = 2,
          .free_atoms = 1,
          .depth_A = {0, 1.5, 3},
          .force_eV_per_A = {0, 2, 9},
          .positions_A = {0, 0, 0, 1, 0, 0, 0, 0, -1.5F, 1, 0, 0, 0, 0, -3, 1, 0.25F, 0}};
}

TEST(TrajectoryH5, ComesBackAsItWas) {
  const TemporaryFolder folder;
  write_run_h5(sample::full(), folder / "run.h5", {trajectory()});
  const std::vector<AtomsTrajectory> read = read_trajectories(folder / "run.h5");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].load, "disc");
  EXPECT_EQ(read[0].atoms, 2u);
  EXPECT_EQ(read[0].free_atoms, 1u);
  EXPECT_EQ(read[0].depth_A, trajectory().depth_A);
  EXPECT_EQ(read[0].force_eV_per_A, trajectory().force_eV_per_A);
  EXPECT_EQ(read[0].positions_A, trajectory().positions_A);
  EXPECT_EQ(read_run_h5(folder / "run.h5").runs.size(), sample::full().runs.size()) << "the result beside it";
}

TEST(TrajectoryH5, MayBeMissing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_trajectories(folder / "run.h5").empty());
  write_run_h5(sample::full(), folder / "run.h5");
  EXPECT_TRUE(read_trajectories(folder / "run.h5").empty());
}

TEST(TrajectoryH5, LengthsThatDoNotFitAreRefused) {
  const TemporaryFolder folder;
  AtomsTrajectory wrong = trajectory();
  wrong.force_eV_per_A.pop_back();
  write_run_h5(sample::full(), folder / "run.h5", {wrong});
  EXPECT_THROW(read_trajectories(folder / "run.h5"), Error);
}

TEST(FieldsH5, EarlierShapesComeBack) {
  const TemporaryFolder folder;
  Result result = sample::full();
  SheetPicture picture = sample::picture();
  picture.earlier = {{1, 2, std::vector<float>(12, 0.5F), {1, 2}, {0, 1}},
                     {2, 8, std::vector<float>(12, 1), {3, 4}, {1, 2}}};
  result.runs[3].continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(1, picture);
  write_run_h5(result, folder / "run.h5");
  const Result back = read_run_h5(folder / "run.h5");
  const auto& read = back.runs[3].continuum().pictures->back().earlier;
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].depth_A, picture.earlier[i].depth_A);
    EXPECT_EQ(read[i].force_eV_per_A, picture.earlier[i].force_eV_per_A);
    EXPECT_EQ(read[i].displacement_A, picture.earlier[i].displacement_A);
    EXPECT_EQ(read[i].cauchy_1_eV_per_A3, picture.earlier[i].cauchy_1_eV_per_A3);
    EXPECT_EQ(read[i].state, picture.earlier[i].state);
  }
}

}  // namespace
