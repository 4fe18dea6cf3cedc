#include "compare/instruments/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/instruments/measured_columns.hpp"
#include "compare/instruments/prepare.hpp"

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

/// A tip that presses is pushed back: the end that is far from the level of the rest is in the sheet, and the force
/// there is positive. Depths of a table are taken at their word, heights are turned to grow towards the sample.
void orient(MeasuredCurve& curve, bool depth_is_known) {
  constexpr std::size_t fewest = 4;
  const std::size_t n = curve.depth_A.size(), few = std::max<std::size_t>(n / 20, 1);
  if (n < fewest) return;
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return curve.depth_A[i]; });
  std::vector<double> sorted = curve.force_eV_per_A;
  std::ranges::sort(sorted);
  const double level = sorted[n / 2];
  double shallow = 0, deep = 0;
  for (std::size_t i = 0; i < few; ++i) {
    shallow += (curve.force_eV_per_A[order[i]] - level) / static_cast<double>(few);
    deep += (curve.force_eV_per_A[order[n - 1 - i]] - level) / static_cast<double>(few);
  }
  if (!depth_is_known && std::abs(shallow) > std::abs(deep)) {
    for (double& depth : curve.depth_A) depth = -depth;
    std::swap(shallow, deep);
  }
  // Of a table without a flat part the level lies in the middle: what counts is which end is higher.
  if (deep - shallow >= 0 || std::abs(deep) < std::abs(shallow)) return;
  for (double& force : curve.force_eV_per_A) force = -force;
  curve.notes.push_back("the force falls where the tip presses: its sign is turned");
}

std::vector<std::size_t> finite_rows(const MeasuredColumns& columns, Stretch stretch, std::vector<std::string>& notes) {
  std::vector<std::size_t> rows;
  for (std::size_t i = stretch.from; i < stretch.to; ++i)
    if (std::isfinite(columns.depth.values[i]) && std::isfinite(columns.force.values[i])) rows.push_back(i);
  const std::size_t skipped = stretch.to - stretch.from - rows.size();
  if (skipped > 0) notes.push_back(fmt::format("{} rows without a finite depth and force are skipped", skipped));
  return rows;
}

/// The retract of a cycle whose approach is fitted; empty where there is none.
WayBack way_back(const Recording& recording, const MeasuredColumns& columns, SegmentKind fitted) {
  std::size_t from = 0;
  for (const RecordedSegment& segment : recording.segments) {
    const std::size_t to = from + static_cast<std::size_t>(segment.points);
    if (fitted == SegmentKind::approach && segment.kind == SegmentKind::retract) {
      std::vector<std::string> ignored;
      const std::vector<std::size_t> rows = finite_rows(columns, {from, to}, ignored);
      return {taken(columns.depth, rows, A_per_m), taken(columns.force, rows, nN_per_N / nN_per_eV_per_A)};
    }
    from = to;
  }
  return {};
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
  curve.source = recording.file;
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
  // A table's zeros are taken at their word, but not those of forces that were made of its deflections.
  curve.zeros_unknown = columns.source != DepthSource::depth &&
                        (recording.headings.empty() || (recording.columns.force && columns.force.heading.empty()));
  if (curve.zeros_unknown || request.baseline)
    prepare(curve, request.baseline.value_or(Baseline::tilt), way_back(recording, columns, request.segment));
  else
    orient(curve, columns.source == DepthSource::depth);
  return curve;
}

}  // namespace

MeasuredFile::MeasuredFile(const std::filesystem::path& file, MeasuredRequest request)
    : file_(file), request_(std::move(request)), recordings_(open_recordings(file, request_.calibration)) {}

std::size_t MeasuredFile::size() const { return recordings_->size(); }

std::string MeasuredFile::name(std::size_t i) const {
  return size() > 1 ? fmt::format("{}, curve {}", file_.string(), i) : file_.string();
}

std::optional<MeasuredCurve> MeasuredFile::read(std::size_t i) {
  const Recording recording = recordings_->read(i);
  there_.push_back(recording.index);
  if (!request_.curves.empty() && std::ranges::find(request_.curves, recording.index) == request_.curves.end())
    return std::nullopt;
  MeasuredCurve curve = measured(recording, request_, size() > 1);
  curve.index = recording.index;
  curve.x_nm = 1e9 * recording.metadata.position_x_m;
  curve.y_nm = 1e9 * recording.metadata.position_y_m;
  return curve;
}

void MeasuredFile::check_all_were_there() const {
  for (const int asked : request_.curves)
    if (std::ranges::find(there_, asked) == there_.end())
      throw bad_input("--run: {} has no curve {}; it has {}", file_.string(), asked, fmt::join(there_, ", "));
}

std::vector<MeasuredCurve> read_measured(const std::filesystem::path& path, const MeasuredRequest& request) {
  MeasuredFile file(path, request);
  std::vector<MeasuredCurve> curves;
  for (std::size_t i = 0; i < file.size(); ++i)
    if (auto curve = file.read(i)) curves.push_back(std::move(*curve));
  file.check_all_were_there();
  return curves;
}

}  // namespace validate
