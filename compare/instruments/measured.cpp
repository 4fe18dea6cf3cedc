#include "compare/instruments/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/instruments/measured_columns.hpp"

namespace validate {
namespace {

constexpr double A_per_m = 1e10, nN_per_N = 1e9;

struct Stretch {
  std::size_t from = 0, to = 0;
};

/// The points of the first segment of a kind; where there is none, of the only segment.
Stretch segment_of(const Recording& recording, SegmentKind kind, std::vector<std::string>& notes) {
  std::size_t from = 0;
  for (const RecordedSegment& segment : recording.segments) {
    const std::size_t to = from + static_cast<std::size_t>(segment.points);
    if (segment.kind == kind) {
      if (recording.segments.size() > 1)
        notes.push_back(fmt::format("of {} segments the {} is fitted, {} points", recording.segments.size(),
                                    to_string(kind), segment.points));
      return {from, to};
    }
    from = to;
  }
  throw bad_input("{}: no segment of the kind {} (--segment)", recording.file, to_string(kind));
}

std::vector<double> taken(const RecordedColumn& column, const std::vector<std::size_t>& rows, double factor) {
  std::vector<double> values;
  for (const std::size_t i : rows) values.push_back(factor * column.values[i]);
  return values;
}

double mean_of(const std::vector<double>& values, std::size_t from, std::size_t to) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(from),
                         values.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
         static_cast<double>(std::max<std::size_t>(to - from, 1));
}

/// Forces in order of the depth.
std::vector<double> forces_along(const MeasuredCurve& curve, std::vector<double>* depths = nullptr) {
  std::vector<std::size_t> order(curve.depth_A.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return curve.depth_A[i]; });
  std::vector<double> forces;
  for (const std::size_t i : order) {
    forces.push_back(curve.force_eV_per_A[i]);
    if (depths) depths->push_back(curve.depth_A[i]);
  }
  return forces;
}

void turn(std::vector<double>& values) {
  for (double& value : values) value = -value;
}

/// A tip that presses is pushed back: the end that is far from the level of the rest is in the sheet, and the force
/// there is positive. Depths of a table are taken at their word, heights are turned to grow towards the sample.
void orient(MeasuredCurve& curve, bool depth_is_known) {
  constexpr std::size_t fewest = 4;
  const std::vector<double> forces = forces_along(curve);
  if (forces.size() < fewest) return;
  const std::size_t few = std::max<std::size_t>(forces.size() / 20, 1);
  std::vector<double> sorted = forces;
  std::ranges::sort(sorted);
  const double level = sorted[sorted.size() / 2];
  double shallow = mean_of(forces, 0, few) - level, deep = mean_of(forces, forces.size() - few, forces.size()) - level;
  if (!depth_is_known && std::abs(shallow) > std::abs(deep)) {
    turn(curve.depth_A);
    std::swap(shallow, deep);
  }
  // Of a table without a flat part the level lies in the middle: what counts is which end is higher.
  if (deep - shallow >= 0 || std::abs(deep) < std::abs(shallow)) return;
  turn(curve.force_eV_per_A);
  curve.notes.push_back("the force falls where the tip presses: its sign is turned");
}

/// First estimate of the contact: behind the last point that lies within five standard deviations of the first third.
double contact_of(const MeasuredCurve& curve) {
  std::vector<double> depths;
  const std::vector<double> forces = forces_along(curve, &depths);
  const std::size_t third = std::max<std::size_t>(forces.size() / 3, 1);
  std::vector<double> sorted(forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(third));
  std::ranges::sort(sorted);
  const double level = sorted[third / 2];
  for (double& force : sorted) force = std::abs(force - level);
  std::ranges::sort(sorted);
  const double spread = 1.4826 * sorted[third / 2], highest = std::ranges::max(forces) - level;
  const double far = std::max(5 * spread, 0.01 * highest);
  std::size_t at = forces.size() - 1;
  while (at > 0 && forces[at - 1] - level > far) --at;
  return depths[at];
}

std::vector<std::size_t> finite_rows(const MeasuredColumns& columns, Stretch stretch, std::vector<std::string>& notes) {
  std::vector<std::size_t> rows;
  for (std::size_t i = stretch.from; i < stretch.to; ++i)
    if (std::isfinite(columns.depth.values[i]) && std::isfinite(columns.force.values[i])) rows.push_back(i);
  const std::size_t skipped = stretch.to - stretch.from - rows.size();
  if (skipped > 0) notes.push_back(fmt::format("{} rows without a finite depth and force are skipped", skipped));
  return rows;
}

void take_sigmas(MeasuredCurve& curve, const MeasuredColumns& columns, const std::vector<std::size_t>& rows) {
  if (columns.sigma) {
    curve.sigma_eV_per_A = taken(*columns.sigma, rows, nN_per_N / nN_per_eV_per_A);
    curve.sigma_column = columns.sigma_name;
    if (!std::ranges::all_of(curve.sigma_eV_per_A, [](double s) { return s > 0; }))
      throw bad_input("{}: column '{}' holds a standard deviation that is not > 0", curve.file.string(),
                      curve.sigma_column);
  }
  if (columns.sigma_depth) curve.sigma_depth_A = taken(*columns.sigma_depth, rows, A_per_m);
}

MeasuredCurve measured(const Recording& recording, const MeasuredRequest& request, bool several) {
  MeasuredCurve curve;
  curve.file = several ? fmt::format("{}, curve {}", recording.file, recording.index) : recording.file;
  curve.remarks = recording.remarks;
  curve.notes = recording.notes;
  const MeasuredColumns columns = measured_columns(recording, request.columns);
  const std::vector<std::size_t> rows =
      finite_rows(columns, segment_of(recording, request.segment, curve.notes), curve.notes);
  curve.depth_A = taken(columns.depth, rows, A_per_m);
  curve.force_eV_per_A = taken(columns.force, rows, nN_per_N / nN_per_eV_per_A);
  curve.depth_column = columns.depth.heading.empty() ? "height" : columns.depth.heading;
  curve.force_column = columns.force.heading.empty() ? "force" : columns.force.heading;
  take_sigmas(curve, columns, rows);
  curve.depth_from_height = columns.source == DepthSource::height;
  const double k = recording.metadata.spring_constant_N_per_m;
  if (std::isfinite(k)) curve.spring_constant_eV_per_A2 = k / N_per_m_per_eV_per_A2;
  orient(curve, columns.source == DepthSource::depth);
  curve.zeros_unknown = columns.source != DepthSource::depth && recording.headings.empty();
  if (curve.zeros_unknown && !curve.depth_A.empty()) {
    const double contact = contact_of(curve);
    for (double& depth : curve.depth_A) depth -= contact;
    curve.notes.push_back(fmt::format("heights begin at the first estimate of the contact, {:.6g} nm", contact / 10));
  }
  return curve;
}

}  // namespace

std::vector<MeasuredCurve> read_measured(const std::filesystem::path& file, const MeasuredRequest& request) {
  const auto recordings = open_recordings(file, request.calibration);
  std::vector<MeasuredCurve> curves;
  std::vector<int> missing = request.curves, there;
  for (std::size_t i = 0; i < recordings->size(); ++i) {
    const Recording recording = recordings->read(i);
    there.push_back(recording.index);
    std::erase(missing, recording.index);
    if (request.curves.empty() || std::ranges::find(request.curves, recording.index) != request.curves.end())
      curves.push_back(measured(recording, request, recordings->size() > 1));
  }
  if (!missing.empty())
    throw bad_input("--run: {} has no curve {}; it has {}", file.string(), missing.front(), fmt::join(there, ", "));
  return curves;
}

}  // namespace validate
