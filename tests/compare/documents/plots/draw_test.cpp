#include "compare/documents/plots/draw.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "compare/base/errors.hpp"
#include "compare/documents/plots/force_depth.hpp"
#include "compare/documents/plots/gnuplot.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

std::optional<std::string> write_figure(const Result& result, const std::filesystem::path& folder) {
  return write_plot(force_depth_plot(result), folder, "figure");
}

// PATH for the length of a test.
class SearchPath {
 public:
  explicit SearchPath(const std::string& value) : old_(::getenv("PATH")) { ::setenv("PATH", value.c_str(), 1); }
  ~SearchPath() { ::setenv("PATH", old_.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;

 private:
  std::string old_;
};

// Big-endian width and height behind the signature and the IHDR tag.
std::array<unsigned, 2> png_size(const std::string& png) {
  const auto number = [&png](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(png.at(at + i));
    return value;
  };
  return {number(16), number(20)};
}

// Smallest red value in a rectangle of the picture, rows counted from the top; gnuplot reads its own PNG.
int darkest(const TemporaryFolder& folder, int left, int top, int right, int bottom) {
  const std::string table = (folder / "pixels").string();
  std::ofstream(folder / "pixels.gnuplot") << "set table '" << table << "'\nplot '" << (folder / "figure.png").string()
                                           << "' binary filetype=png every 1:1:" << left << ':' << top << ':' << right
                                           << ':' << bottom << " with rgbimage\n";
  const auto report = run_gnuplot(folder / "pixels.gnuplot");
  if (!report || !report->succeeded) return -1;
  int smallest = 256;
  std::ifstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);
    int x, y, red;
    if (columns >> x >> y >> red) smallest = std::min(smallest, red);
  }
  return smallest;
}

TEST(Draw, MakesPicturesAndTheirDataAndNothingElse) {
  const TemporaryFolder folder;
  const auto warning = write_figure(sample::full(), folder.path());
  EXPECT_FALSE(warning) << *warning;
  EXPECT_EQ(folder.entries(), 4u);
  const std::string png = folder.read("figure.png"), svg = folder.read("figure.svg");
  EXPECT_EQ(folder.read("figure.pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png_size(png), (std::array{1800u, 1360u}));
  for (const char* text : {"<svg", "force (eV/Å)", "depth (Å)", "airebo, R = 110 Å", "disc load",
                           "membrane, paper constants", "Eq. 16, card constants", "artefact zone", "AGREEMENT"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

TEST(Draw, ThePngHoldsText) {
  const TemporaryFolder folder;
  write_figure(sample::full(), folder.path());
  // These strips hold nothing but the title and the axes' labels: without fonts they are blank.
  EXPECT_LT(darkest(folder, 500, 10, 1400, 90), 100);
  EXPECT_LT(darkest(folder, 0, 300, 70, 1000), 100);
  EXPECT_LT(darkest(folder, 500, 1220, 1400, 1279), 100);
  EXPECT_EQ(darkest(folder, 0, 0, 20, 20), 255);  // the corner is blank, and found to be
}

TEST(Draw, DrawsEveryKindOfResult) {
  for (const Result& result : {sample::membrane_only(), sample::atoms_failed(), Result{}}) {
    const TemporaryFolder folder;
    EXPECT_NO_THROW(write_figure(result, folder.path()));
    EXPECT_EQ(folder.entries(), 4u);
  }
}

TEST(Draw, DrawsAZoneWithoutASinglePointOutsideIt) {
  Result torn;
  torn.runs = {sample::atomistic_run(LoadKind::point, 1, 0)};
  torn.runs[0].atoms().artefact.assign(torn.runs[0].depth_A.size(), true);
  torn.runs[0].converged.assign(torn.runs[0].depth_A.size(), false);
  const TemporaryFolder folder;
  EXPECT_NO_THROW(write_figure(torn, folder.path()));
  EXPECT_EQ(folder.entries(), 4u);
}

TEST(Draw, SurvivesQuotesInNames) {
  const TemporaryFolder folder;
  Result result = sample::full();
  result.resolved.potential = "my 'own' \"potential\" `date` $(x)";
  EXPECT_NO_THROW(write_figure(result, folder.path()));
  std::filesystem::create_directory(folder / "it's here");
  EXPECT_NO_THROW(write_figure(result, folder / "it's here"));
  EXPECT_TRUE(std::filesystem::exists(folder / "it's here/figure.png"));
}

TEST(Draw, AMissingGnuplotIsAWarning) {
  const TemporaryFolder folder, empty;
  const SearchPath path(empty.path().string());
  const auto warning = write_figure(sample::full(), folder.path());
  ASSERT_TRUE(warning);
  EXPECT_NE(warning->find("gnuplot is not installed"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_TRUE(std::filesystem::exists(folder / "figure.csv"));  // which needs no gnuplot
}

TEST(Draw, AFailingGnuplotIsQuoted) {
  const TemporaryFolder folder, programs;
  std::ofstream(programs / "gnuplot") << "#!/bin/sh\necho 'no such terminal' >&2\nexit 1\n";
  std::filesystem::permissions(programs / "gnuplot", std::filesystem::perms::owner_all);
  const SearchPath path(programs.path().string());
  try {
    write_figure(sample::full(), folder.path());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::file_failed);
    EXPECT_NE(std::string(error.what()).find("no such terminal"), std::string::npos);
  }
  EXPECT_EQ(folder.entries(), 1u);  // the data
}

TEST(Draw, AnEmptyPictureIsAnError) {
  const TemporaryFolder folder, programs;
  std::ofstream(programs / "gnuplot") << "#!/bin/sh\nexit 0\n";
  std::filesystem::permissions(programs / "gnuplot", std::filesystem::perms::owner_all);
  const SearchPath path(programs.path().string());
  EXPECT_THROW(write_figure(sample::full(), folder.path()), Error);
  EXPECT_EQ(folder.entries(), 1u);  // the data
}

TEST(Draw, NothingToDrawMakesNoFiles) {
  const TemporaryFolder folder;
  EXPECT_FALSE(write_plot(Plot{}, folder.path(), "nothing"));
  EXPECT_FALSE(draw(Plot{}, folder.path(), "nothing"));
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Draw, MakesTheOnePictureAskedFor) {
  const TemporaryFolder folder;
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png})
    draw(force_depth_plot(sample::membrane_only()), folder.path(), format == PictureFormat::svg ? "a" : "b", {format});
  EXPECT_TRUE(std::filesystem::exists(folder / "a.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "b.png"));
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(Draw, TheDataMayHaveANameOfTheirOwn) {
  const TemporaryFolder folder;
  write_plot(force_depth_plot(sample::membrane_only()), folder.path(), "atoms", "atoms-figure");
  for (const char* name : {"atoms.svg", "atoms.png", "atoms.pdf", "atoms-figure.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.entries(), 4u);
}

TEST(Draw, WhatTheUserHasSetUpChangesNothing) {
  const TemporaryFolder folder, home;
  std::ofstream(home / ".gnuplot") << "set print '" << (home / "was-read").string() << "'\nprint 1\n";
  const std::string before = std::getenv("HOME") ? std::getenv("HOME") : "";
  ::setenv("HOME", home.path().c_str(), 1);
  draw(force_depth_plot(sample::membrane_only()), folder.path(), "a", {PictureFormat::svg});
  ::setenv("HOME", before.c_str(), 1);
  EXPECT_FALSE(std::filesystem::exists(home / "was-read"));
  EXPECT_TRUE(std::filesystem::exists(folder / "a.svg"));
}

}  // namespace
