// What a bulge run produced, and its documents.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/input/bulge_case.hpp"
#include "compare/results/result.hpp"
#include "compare/results/sheet_columns.hpp"
#include "compare/study/bulge_atoms.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// One pressure.
struct BulgePoint {
  double pressure_eV_per_A3 = 0, depth_A = 0, volume_A3 = 0, energy_eV = 0;
  bool converged = false;
  double wrinkled_area_fraction = 0, slack_area_fraction = 0;
  double edge_pull_in_A = not_known;  ///< of the middle of an edge, towards the centre; sliding edges
  double stress_1_max_eV_per_A3 = 0;  ///< largest of the larger principal Cauchy stress
  double stress_2_min_eV_per_A3 = 0, stress_2_max_eV_per_A3 = 0;  ///< range of the smaller one
  int newton_iterations = 0;
};

template <class Self, class Visitor>
requires SameStruct<Self, BulgePoint>
void describe(Self& p, Visitor&& visit) {
  visit(Field{"pressure", unit::stress, "follower pressure"}, p.pressure_eV_per_A3);
  visit(Field{"depth", unit::length, "height of the bulge's centre"}, p.depth_A);
  visit(Field{"volume", unit::volume, "volume under the bulge, full sheet"}, p.volume_A3);
  visit(Field{"energy", unit::energy, "stretching energy, full sheet"}, p.energy_eV);
  visit(Field{"converged", unit::none, "whether the solver reached equilibrium"}, p.converged);
  visit(Field{"wrinkled_area_fraction", unit::none, "share of the area in uniaxial tension"}, p.wrinkled_area_fraction);
  visit(Field{"slack_area_fraction", unit::none, "share of the area without tension"}, p.slack_area_fraction);
  visit(Field{"edge_pull_in", unit::length, "way of an edge's middle towards the centre"}, p.edge_pull_in_A);
  visit(Field{"stress_1_max", unit::stress, "largest larger principal Cauchy stress"}, p.stress_1_max_eV_per_A3);
  visit(Field{"stress_2_min", unit::stress, "least smaller principal Cauchy stress"}, p.stress_2_min_eV_per_A3);
  visit(Field{"stress_2_max", unit::stress, "largest smaller principal Cauchy stress"}, p.stress_2_max_eV_per_A3);
  visit(Field{"newton_iterations", unit::none, "Newton steps"}, p.newton_iterations);
}

struct BulgeResult {
  BulgeCase resolved;
  std::vector<BulgePoint> points;
  std::vector<SheetPicture> pictures;  ///< one a point
  bool converged = false;
  std::string ended_reason;
  int triangles = 0, factorisations = 0;
  double wall_s = 0;
  std::optional<BulgeAtoms> atoms;  ///< where a potential was given; resolved then holds the card's constants
  Provenance provenance;
};

/// One point from a step and its fields.
BulgePoint bulge_point(const membrane::Step& step, const SheetPicture& picture);

/// The resolved case as JSON.
nlohmann::ordered_json bulge_case_document(const BulgeCase& c);
nlohmann::ordered_json bulge_document(const BulgeResult& result);

/// run.h5, curves.csv, summary.json, membrane.pvd with its VTU files, figure.svg and .png; with atoms also atoms.csv,
/// atoms.svg and .png. Throws Error (file failed).
void write_bulge(const BulgeResult& result, const std::filesystem::path& folder);

std::string bulge_table(const BulgeResult& result);

}  // namespace validate
