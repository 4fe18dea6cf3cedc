// run.h5 read back: nothing is lost on the way there and back.
#include "compare/documents/bytes/run_h5_read.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/texts/json.hpp"
#include "tests/compare/results/complete_result.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

Result there_and_back(const Result& result) {
  const TemporaryFolder folder;
  write_run_h5(result, folder / "run.h5");
  return read_run_h5(folder / "run.h5");
}

class RunH5Read : public testing::TestWithParam<Command> {};

TEST_P(RunH5Read, GivesBackEveryMember) {
  const Result result = sample::complete(GetParam());
  EXPECT_EQ(json_text(there_and_back(result)), json_text(result));
}

TEST_P(RunH5Read, GivesBackNothingWhereThereWasNothing) {
  Result result;
  result.command = GetParam();
  if (GetParam() == Command::potential) result.card.emplace();
  EXPECT_EQ(json_text(there_and_back(result)), json_text(result));
}

INSTANTIATE_TEST_SUITE_P(Commands, RunH5Read,
                         testing::Values(Command::indentation, Command::bulge, Command::fit, Command::potential,
                                         Command::figure, Command::verify, Command::batch, Command::published,
                                         Command::curve, Command::design),
                         [](const auto& test) { return std::string(to_string(test.param)); });

TEST(RunH5ReadMore, IncompleteResultsToo) {
  for (const Result& result : {sample::full(), sample::membrane_only(), sample::atoms_failed()})
    EXPECT_EQ(json_text(there_and_back(result)), json_text(result));
}

void expect_same(const std::vector<SheetColumn>& a, const std::vector<SheetColumn>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].key, b[i].key);
    EXPECT_EQ(a[i].unit, b[i].unit);
    EXPECT_EQ(a[i].meaning, b[i].meaning);
    EXPECT_EQ(a[i].components, b[i].components);
    EXPECT_EQ(a[i].values, b[i].values);
  }
}

TEST(RunH5ReadMore, PicturesOfSheets) {
  const Result read = there_and_back(sample::complete(Command::bulge));
  const SheetPicture written = sample::picture();
  int sheets = 0;
  for (const auto& run : read.runs) {
    if (run.is_atomistic()) continue;
    ASSERT_TRUE(run.continuum().pictures);
    ASSERT_EQ(run.continuum().pictures->size(), 2u);
    for (const SheetPicture& picture : *run.continuum().pictures) {
      ++sheets;
      EXPECT_EQ(picture.mesh.nodes, written.mesh.nodes);
      ASSERT_EQ(picture.mesh.triangles.size(), written.mesh.triangles.size());
      for (std::size_t i = 0; i < written.mesh.triangles.size(); ++i)
        EXPECT_EQ(picture.mesh.triangles[i].nodes, written.mesh.triangles[i].nodes);
      EXPECT_EQ(picture.mesh.copies, written.mesh.copies);
      EXPECT_EQ(picture.level, written.level);
      EXPECT_EQ(picture.thickness_A, written.thickness_A);
      EXPECT_EQ(picture.displacement, written.displacement);
      expect_same(picture.nodes, written.nodes);
      expect_same(picture.triangles, written.triangles);
      ASSERT_EQ(picture.totals.size(), written.totals.size());
      for (const SheetTotal& t : written.totals) EXPECT_EQ(total(picture.totals, t.key), t.value);
    }
  }
  EXPECT_EQ(sheets, 4);  // of the membrane and of the sheet that bends
}

TEST(RunH5ReadMore, HoldsTheWayBackAndWhyThereIsNoLaw) {
  Result result = sample::full();
  result.unloading = {{.load = LoadKind::disc,
                       .hysteresis_relative = 0.002,
                       .depth_A = {4, 2},
                       .conjugate_depth_A = {3.9, 1.95},
                       .force_eV_per_A = {1, 0.25}}};
  result.law.reset();
  result.law_missing = "12 values do not determine 33 coefficients";
  const Result read = there_and_back(result);
  ASSERT_EQ(read.unloading.size(), 1u);
  EXPECT_EQ(read.unloading[0].load, LoadKind::disc);
  EXPECT_EQ(read.unloading[0].hysteresis_relative, 0.002);
  EXPECT_EQ(read.unloading[0].depth_A, result.unloading[0].depth_A);
  EXPECT_EQ(read.unloading[0].force_eV_per_A, result.unloading[0].force_eV_per_A);
  EXPECT_EQ(read.law_missing, result.law_missing);
}

TEST(RunH5ReadMore, KeepsTheFitsAndTheirWarnings) {
  Result result = sample::full();
  Fit& first = result.runs[1].fits.at(0);
  first.warnings = {"one", "two: κ"};
  first.sources = {{"noise", 0.1, 0.002}, {"radius", 0.05, 0}};
  first.contact_nm = 3.2;
  const Result read = there_and_back(result);
  ASSERT_EQ(read.runs[1].fits.size(), result.runs[1].fits.size());
  const Fit& back = read.runs[1].fits[0];
  EXPECT_EQ(back.warnings, first.warnings);
  ASSERT_EQ(back.sources.size(), 2u);
  EXPECT_EQ(back.sources[1].name, "radius");
  EXPECT_EQ(back.sources[1].Eh_eV_per_A2, 0.05);
  EXPECT_EQ(back.contact_nm, 3.2);
  EXPECT_EQ(back.scan.depth_max_A, first.scan.depth_max_A);
  EXPECT_EQ(recommended_fit(read.runs[1].fits)->model, recommended_fit(result.runs[1].fits)->model);
}

TEST(RunH5ReadMore, RefusesWhatIsNoRun) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::filesystem::path& file) -> std::string {
    try {
      read_run_h5(file);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refusal(folder / "none.h5").find("there is no file"), std::string::npos);
  std::ofstream(folder / "text.h5") << "no HDF5";
  EXPECT_NE(refusal(folder / "text.h5").find("not an HDF5 file"), std::string::npos);
  write_run_h5(sample::full(), folder / "run.h5");
  const std::string content = folder.read("run.h5");
  for (const std::size_t part : {2, 3, 10, 100}) {
    std::ofstream(folder / "cut.h5", std::ios::binary) << content.substr(0, content.size() / part);
    EXPECT_NE(refusal(folder / "cut.h5"), "accepted") << part;
  }
}

}  // namespace
