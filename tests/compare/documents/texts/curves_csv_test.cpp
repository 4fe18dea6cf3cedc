#include "compare/documents/texts/curves_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "tests/compare/results/sample_result.hpp"

using namespace validate;

namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

struct Table {
  Row comments;
  std::vector<Row> rows;
};

Table parse(const std::string& text) {
  Table table;
  std::vector<std::string> header;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ")) {
      const auto colon = line.find(": ");
      EXPECT_NE(colon, std::string::npos) << line;
      table.comments[line.substr(2, colon - 2)] = line.substr(colon + 2);
    } else if (header.empty()) {
      header = split(line);
    } else {
      const auto cells = split(line);
      EXPECT_EQ(cells.size(), header.size()) << line;
      Row& row = table.rows.emplace_back();
      for (std::size_t i = 0; i < std::min(cells.size(), header.size()); ++i) row[header[i]] = cells[i];
    }
  }
  return table;
}

TEST(CurvesCsv, OneRowPerRunAndDepth) {
  const Result result = sample::full();
  const Table table = parse(curves_csv(result));
  std::size_t row = 0;
  for (std::size_t r = 0; r < result.runs.size(); ++r) {
    const validate::Run& run = result.runs[r];
    for (std::size_t i = 0; i < run.depth_A.size(); ++i, ++row) {
      ASSERT_LT(row, table.rows.size());
      const Row& cells = table.rows[row];
      EXPECT_EQ(cells.at("run"), std::to_string(r));
      EXPECT_EQ(cells.at("model"), to_string(run.model));
      EXPECT_EQ(cells.at("load"), to_string(run.load));
      EXPECT_EQ(std::stod(cells.at("depth_A")), run.depth_A[i]);
      EXPECT_EQ(std::stod(cells.at("force_eV_per_A")), run.force_eV_per_A[i]);
      EXPECT_NEAR(std::stod(cells.at("force_nN")) / run.force_eV_per_A[i], 1.602176634, 1e-12);
      const bool atoms = run.model == Model::atomistic;
      EXPECT_EQ(cells.at("longest_bond_A").empty(), !atoms && run.constants != Constants::calibrated);
      EXPECT_EQ(cells.at("newton_iterations").empty(), atoms);
      const std::string flag = !atoms ? "" : run.atoms().artefact[i] ? "1" : "0";
      EXPECT_EQ(cells.at("artefact"), flag);
    }
  }
  EXPECT_EQ(row, table.rows.size());
}

TEST(CurvesCsv, CommentsNameUnitsConstantsAndRadii) {
  const Table table = parse(curves_csv(sample::full()));
  EXPECT_EQ(table.comments.at("column.depth_A"), "depth of record (Å)");
  EXPECT_EQ(table.comments.at("run.3.a_A"), "111.048");
  EXPECT_EQ(table.comments.at("run.3.constants"), "card");
  EXPECT_EQ(table.comments.at("run.5.Eh_eV_per_A2").substr(0, 7), "8.03368");
  EXPECT_TRUE(table.comments.contains("run.5.Eh_N_per_m"));
  // each column is explained, but for the four that identify the row
  for (const auto& [name, cell] : table.rows.front()) {
    if (name == "run" || name == "model" || name == "load" || name == "constants") continue;
    EXPECT_TRUE(table.comments.contains("column." + name)) << name;
  }
}

TEST(CurvesCsv, WhatIsNotKnownIsAnEmptyCell) {
  Result result = sample::atoms_failed();
  result.runs[1].force_eV_per_A[0] = not_known;
  const Table table = parse(curves_csv(result));
  EXPECT_EQ(table.comments.at("run.0.nu"), "");
  EXPECT_EQ(table.rows.at(0).at("force_eV_per_A"), "");
  EXPECT_EQ(table.rows.at(0).at("force_nN"), "");
}

}  // namespace
