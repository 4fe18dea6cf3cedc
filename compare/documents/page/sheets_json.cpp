#include "compare/documents/page/sheets_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/base/units.hpp"
#include "compare/documents/page/packed.hpp"
#include "compare/documents/plots/colours.hpp"
#include "compare/documents/plots/sheet_maps.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;
using Whole = std::vector<std::int32_t>;

/// Steps of positions: fine enough for the lengths of bonds, coarser for large sheets, whose numbers must fit.
double quantum_for(double largest_A) { return std::max(0.004, largest_A / 1e8); }

/// Zero for what is no number.
std::int32_t whole(double value, double quantum) {
  const double steps = std::round(value / quantum);
  return std::isfinite(steps) ? static_cast<std::int32_t>(std::clamp(steps, -1e8, 1e8)) : 0;
}

double largest_of(const float* values, std::size_t count) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max<double>(largest, std::abs(values[i]));
  return largest;
}

/// Places of a frame, component by component, or how far they are from the flat ones.
Whole components(const float* frame, const float* flat, std::size_t count, double quantum) {
  Whole all(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double from = flat ? static_cast<double>(flat[3 * i + c]) : 0;
      all[c * count + i] = whole(static_cast<double>(frame[3 * i + c]) - from, quantum);
    }
  return all;
}

/// The deepest frame, and of the others every `stride`-th from there; the flat sheet always.
std::vector<std::size_t> kept_frames(std::size_t frames, std::size_t stride) {
  std::vector<std::size_t> kept;
  for (std::size_t back = 0; back + 1 < frames; back += stride) kept.push_back(frames - 1 - back);
  kept.push_back(0);
  std::ranges::reverse(kept);
  return kept;
}

Json atoms_json(const AtomsTrajectory& t, std::size_t stride) {
  const double quantum = quantum_for(largest_of(t.positions_A.data(), t.positions_A.size()));
  const float* const flat = t.positions_A.data();
  Json json = {{"count", t.atoms}, {"free", t.free_atoms}, {"quantum", quantum}, {"every", stride}};
  std::vector<Whole> frames;
  for (const std::size_t f : kept_frames(t.depth_A.size(), stride)) {
    json["depth"].push_back(t.depth_A[f]);
    json["force"].push_back(t.force_eV_per_A[f]);
    frames.push_back(components(flat + 3 * t.atoms * f, flat, t.atoms, quantum));
  }
  json["flat"] = packed({components(flat, nullptr, t.atoms, quantum)});
  json["frames"] = packed(frames);
  return json;
}

bool has_column(const std::vector<SheetColumn>& columns, const std::string& key, std::size_t length) {
  const auto found = std::ranges::find(columns, key, &SheetColumn::key);
  return found != columns.end() && found->values.size() == length;
}

/// Whether a picture, which a file may have held, has all that is drawn of it.
bool is_complete(const SheetPicture& picture) {
  const auto known = [&](const char* key) {
    const auto found = std::ranges::find(picture.totals, key, &SheetTotal::key);
    return found != picture.totals.end() && std::isfinite(found->value);
  };
  const std::size_t triangles = picture.mesh.triangles.size();
  return triangles > 0 && picture.displacement.size() == 3 * picture.mesh.nodes.size() && known("depth_A") &&
         known("force_eV_per_A") && has_column(picture.triangles, "cauchy_1_eV_per_A3", triangles) &&
         has_column(picture.triangles, "state", triangles);
}

/// Shapes of a membrane from the flat one on, which has no stress here: what it was built with is small.
std::vector<SheetShape> shapes_of(const std::vector<SheetPicture>& pictures, std::size_t stride) {
  std::vector<SheetShape> shapes(1), kept;
  shapes[0].displacement_A.resize(3 * pictures.back().mesh.nodes.size());
  shapes[0].cauchy_1_eV_per_A3.resize(pictures.back().mesh.triangles.size());
  shapes[0].state.resize(pictures.back().mesh.triangles.size());
  for (const SheetShape& shape : pictures.back().earlier) shapes.push_back(shape);
  for (const SheetPicture& picture : pictures)
    if (is_complete(picture) && picture.mesh.nodes.size() == pictures.back().mesh.nodes.size() &&
        picture.mesh.triangles.size() == pictures.back().mesh.triangles.size())
      shapes.push_back(shape_of(picture));
  for (const std::size_t i : kept_frames(shapes.size(), stride)) kept.push_back(std::move(shapes[i]));
  return kept;
}

/// Larger principal force, N/m, in 255 steps; the largest 0.5 % of the deepest shape's, where a point presses, count as
/// the step below.
Json stress_json(const std::vector<SheetShape>& shapes, double thickness_A) {
  const double unit = thickness_A * N_per_m_per_eV_per_A2;
  double low = 0, top = 0;
  for (const SheetShape& shape : shapes)
    for (const float value : shape.cauchy_1_eV_per_A3)
      low = std::min<double>(low, value), top = std::max<double>(top, value);
  std::vector<float> deepest = shapes.back().cauchy_1_eV_per_A3;
  const auto cut = deepest.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(deepest.size() - 1));
  std::ranges::nth_element(deepest, cut);
  const double high = std::max<double>(*cut, low + 1e-9 + 0.2 * (top - low));
  std::vector<Whole> frames;
  for (const SheetShape& shape : shapes) {
    Whole& frame = frames.emplace_back();
    for (const float value : shape.cauchy_1_eV_per_A3)
      frame.push_back(whole(255 * std::clamp((value - low) / (high - low), 0.0, 1.0), 1));
  }
  return {
      {"low", low * unit}, {"high", high * unit}, {"unit", "N/m"}, {"clipped", top > high}, {"values", packed(frames)}};
}

/// Corner by corner, how the node's number differs from the triangle before: neighbours have near numbers.
Whole corners_of(const membrane::Mesh& mesh) {
  Whole corners;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::int32_t before = 0; const auto& triangle : mesh.triangles) {
      corners.push_back(triangle.nodes[c] - before);
      before = triangle.nodes[c];
    }
  return corners;
}

Json membrane_json(const Run& run, std::size_t stride) {
  const std::vector<SheetPicture>& pictures = *run.continuum().pictures;
  const membrane::Mesh& mesh = pictures.back().mesh;
  const std::vector<SheetShape> shapes = shapes_of(pictures, stride);
  std::vector<float> flat;
  for (const auto& X : mesh.nodes)
    flat.insert(flat.end(), {static_cast<float>(X.x()), static_cast<float>(X.y()), 0.0F});
  const double quantum = quantum_for(largest_of(flat.data(), flat.size()));
  Json json = {{"name", run.constants ? fmt::format("{} constants", *run.constants) : std::string()},
               {"nodes", mesh.nodes.size()},
               {"triangles", mesh.triangles.size()},
               {"mirrored", mesh.copies > 1},
               {"quantum", quantum},
               {"every", stride}};
  std::vector<Whole> frames, states;
  for (const SheetShape& shape : shapes) {
    json["depth"].push_back(shape.depth_A);
    json["force"].push_back(shape.force_eV_per_A);
    frames.push_back(components(shape.displacement_A.data(), nullptr, mesh.nodes.size(), quantum));
    Whole& state = states.emplace_back();
    for (const float value : shape.state) state.push_back(whole(std::clamp(value, 0.0F, 2.0F), 1));
  }
  json["flat"] = packed({components(flat.data(), nullptr, mesh.nodes.size(), quantum)});
  json["frames"] = packed(frames);
  json["corners"] = packed({corners_of(mesh)});
  json["stress"] = stress_json(shapes, pictures.back().thickness_A);
  json["state"] = packed(states);
  return json;
}

bool is_drawn(const Run& run) {
  return run.model == Model::membrane && run.continuum().pictures && !run.continuum().pictures->empty() &&
         is_complete(run.continuum().pictures->back());
}

/// The membrane beside the atoms of this load.
const Run* membrane_of(const Result& result, LoadKind load) {
  for (const std::optional<Constants> wanted : {std::optional(Constants::card), std::optional(Constants::given), {}})
    for (const Run& run : result.runs)
      if (run.load == load && is_drawn(run) && (!wanted || run.constants == *wanted)) return &run;
  return nullptr;
}

Json all_loads(const Result& result, const std::vector<AtomsTrajectory>& atoms, std::size_t stride) {
  Json loads = Json::array();
  for (const LoadKind load : result.resolved.loads) {
    Json one = {{"load", to_string(load)}};
    const auto found = std::ranges::find(atoms, to_string(load), &AtomsTrajectory::load);
    if (found != atoms.end() && found->depth_A.size() > 1) one["atoms"] = atoms_json(*found, stride);
    if (const Run* membrane = membrane_of(result, load)) one["membrane"] = membrane_json(*membrane, stride);
    if (one.size() > 1) loads.push_back(std::move(one));
  }
  return loads;
}

}  // namespace

std::string sheets_json(const Result& result, const std::vector<AtomsTrajectory>& atoms, std::size_t budget_bytes) {
  std::string text;
  for (std::size_t stride = 1; stride <= 64; stride *= 2) {
    Json json = {{"scale", scale_of_fields()}, {"states", Json::array()}, {"loads", all_loads(result, atoms, stride)}};
    for (const auto& state : scale_of_states().classes) json["states"].push_back(hex(state.colour));
    if (json["loads"].empty()) return {};
    for (std::size_t i = 0; i < json["loads"].size(); ++i)
      if (json["loads"][i]["load"] == to_string(result.resolved.judged_load)) json["shown"] = i;
    text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() <= budget_bytes) return text;
  }
  return {};
}

}  // namespace validate
