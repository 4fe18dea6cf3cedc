// Every column of real files beside what other programs read in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/instruments/archive.hpp"
#include "compare/instruments/format.hpp"
#include "compare/instruments/jpk_channel.hpp"

namespace validate {
namespace {

using Json = nlohmann::json;
const std::filesystem::path samples = INSTRUMENT_DATA;

/// The samples, and the folder of more files where one is given.
std::vector<std::filesystem::path> folders() {
  std::vector<std::filesystem::path> all = {samples};
  const char* more = std::getenv("VALIDATE_AFM_REFERENCE");
  const std::string folder = more ? more : AFM_REFERENCE;
  if (!folder.empty()) all.emplace_back(folder);
  return all;
}

Json expected_in(const std::filesystem::path& folder) {
  std::ifstream in(folder / "expected.json");
  return in ? Json::parse(in) : Json{};
}

std::optional<double> number(const Json& object, const char* key) {
  return object.contains(key) ? std::optional(object[key].get<double>()) : std::nullopt;
}

class Beside {
 public:
  Beside(const Json& expected, const std::vector<double>& values, double relative)
      : expected_(expected),
        values_(values),
        relative_(relative),
        absolute_(1e-9 * std::max(std::abs(expected["min"].get<double>()), std::abs(expected["max"].get<double>()))) {}

  void check(const std::vector<std::size_t>& segments) const {
    ASSERT_FALSE(values_.empty());
    near(values_.front(), expected_["first"], "first");
    near(values_.back(), expected_["last"], "last");
    near(std::ranges::min(values_), expected_["min"], "min");
    near(std::ranges::max(values_), expected_["max"], "max");
    near(mean(0, values_.size()), expected_["mean"], "mean");
    for (const Json& sample : expected_["samples"]) near(values_.at(sample[0].get<std::size_t>()), sample[1], "sample");
    if (!expected_.contains("by segment")) return;
    std::size_t from = 0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const Json& part = expected_["by segment"][s];
      near(values_.at(from), part["first"], "first of a segment");
      near(values_.at(from + segments[s] - 1), part["last"], "last of a segment");
      near(mean(from, from + segments[s]), part["mean"], "mean of a segment");
      from += segments[s];
    }
  }

 private:
  double mean(std::size_t from, std::size_t to) const {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += values_[i];
    return sum / static_cast<double>(to - from);
  }
  void near(double value, double expected, const char* what) const {
    EXPECT_LE(std::abs(value - expected), relative_ * std::abs(expected) + absolute_)
        << what << ": " << value << " for " << expected;
  }

  const Json& expected_;
  const std::vector<double>& values_;
  double relative_, absolute_;
};

std::vector<std::size_t> check_segments(const Recording& curve, const Json& expected) {
  std::vector<std::size_t> points;
  EXPECT_EQ(curve.segments.size(), expected["segments"].size());
  for (std::size_t s = 0; s < std::min(curve.segments.size(), expected["segments"].size()); ++s) {
    EXPECT_EQ(to_string(curve.segments[s].kind), expected["segments"][s]["kind"].get<std::string>());
    EXPECT_EQ(curve.segments[s].points, expected["segments"][s]["points"].get<int>());
    points.push_back(static_cast<std::size_t>(curve.segments[s].points));
  }
  return points;
}

void check_metadata(const RecordingMetadata& m, const Json& expected) {
  const auto near = [&](double value, const char* key) {
    if (const auto wanted = number(expected, key)) {
      EXPECT_NEAR(value, *wanted, 1e-8 * std::abs(*wanted)) << key;
    }
  };
  near(m.spring_constant_N_per_m, "spring constant");
  near(m.sensitivity_m_per_V, "sensitivity");
  near(m.setpoint, "setpoint");
  near(m.position_x_m, "position x");
  near(m.position_y_m, "position y");
  near(m.speed_approach_m_per_s, "speed approach");
  near(m.speed_retract_m_per_s, "speed retract");
  near(m.grid_center_x_m, "grid center x");
  near(m.grid_center_y_m, "grid center y");
  near(m.grid_size_x_m, "grid size x");
  near(m.grid_size_y_m, "grid size y");
  near(m.duration_s, "duration");
  near(m.z_range_m, "z range");
  if (expected.contains("grid index x")) {
    EXPECT_EQ(m.grid_index_x, expected["grid index x"].get<int>());
  }
  if (expected.contains("grid index y")) {
    EXPECT_EQ(m.grid_index_y, expected["grid index y"].get<int>());
  }
  if (expected.contains("date")) {
    EXPECT_EQ(m.date, expected["date"].get<std::string>());
  }
  if (expected.contains("time")) {
    EXPECT_EQ(m.time, expected["time"].get<std::string>());
  }
  if (expected.contains("imaging mode")) {
    EXPECT_EQ(m.imaging_mode, expected["imaging mode"].get<std::string>());
  }
}

void check_columns(const Recording& curve, const Json& expected, double force_tolerance) {
  const std::vector<std::size_t> segments = check_segments(curve, expected);
  for (const auto& [name, numbers] : expected["data"].items()) {
    SCOPED_TRACE(name);
    const RecordedColumn* column = nullptr;
    describe(curve.columns, [&, &wanted = name](const Field& field, const std::optional<RecordedColumn>& one) {
      if (field.name == wanted && one) column = &*one;
    });
    ASSERT_NE(column, nullptr);
    EXPECT_EQ(column->unit, numbers["unit"].get<std::string>());
    EXPECT_EQ(column->values.size(), expected["points"].get<std::size_t>());
    Beside(numbers, column->values, name == "force" ? force_tolerance : 1e-8).check(segments);
  }
}

/// Every binary channel of every segment in every slot, as the file alone defines it.
void check_channels(const std::filesystem::path& file, const Json& expected, int index, bool map) {
  const auto archive = open_zip(file);
  const std::string shared_name = "shared-data/header.properties";
  const Properties shared = archive->has(shared_name) ? Properties(archive->read(shared_name), "shared") : Properties();
  for (const auto& [name, segments] : expected["channels"].items())
    for (const Json& part : segments) {
      const std::string folder =
          (map ? fmt::format("index/{}/", index) : "") + fmt::format("segments/{}/", part["segment"].get<int>());
      SCOPED_TRACE(folder + name);
      Properties header(archive->read(folder + "segment-header.properties"), folder);
      header.resolve(shared);
      const JpkChannel channel(*archive, folder, header, name, header.count("force-segment-header.num-points").value(),
                               folder);
      EXPECT_EQ(channel.slots().size(), part["slots"].size());
      for (const auto& [slot, numbers] : part["slots"].items()) {
        ASSERT_NE(channel.slot(slot), nullptr) << slot;
        EXPECT_EQ(channel.slot(slot)->unit, numbers["unit"].get<std::string>());
        const std::vector<double> values = channel.in(slot);
        Beside(numbers, values, 1e-8).check({});
      }
    }
}

TEST(InstrumentReference, EveryColumnOfEveryFile) {
  for (const std::filesystem::path& folder : folders()) {
    const Json all = expected_in(folder);
    ASSERT_TRUE(all.contains("files")) << folder;
    for (const auto& [name, expected] : all["files"].items()) {
      SCOPED_TRACE(name);
      const Json& given = expected["calibration given by the caller"];
      const auto curves =
          open_recordings(folder / name, {number(given, "spring constant"), number(given, "sensitivity")});
      ASSERT_EQ(curves->size(), expected["curves"].size());
      for (std::size_t i = 0; i < curves->size(); ++i) {
        SCOPED_TRACE(i);
        const Recording curve = curves->read(i);
        const Json& one = expected["curves"][i];
        check_columns(curve, one, name.ends_with(".ibw") ? 1e-6 : 1e-8);
        check_metadata(curve.metadata, one["metadata"]);
        if (one.contains("channels")) check_channels(folder / name, one, curve.index, name.ends_with("map"));
      }
    }
  }
}

TEST(InstrumentReference, WithoutCalibrationTheDeflectionStaysInVolts) {
  const auto curves =
      open_recordings(samples / "fmt-jpk-cl_calibration_force-save-2015.02.04-11.25.21.294.jpk-force", {});
  const Recording curve = curves->read(0);
  EXPECT_FALSE(curve.columns.force);
  ASSERT_TRUE(curve.columns.deflection);
  EXPECT_EQ(curve.columns.deflection->unit, "V");
  EXPECT_EQ(curve.metadata.setpoint_unit, "V");
  EXPECT_NEAR(curve.metadata.setpoint, 0.2, 1e-12);
}

TEST(InstrumentReference, TheFilesOwnCalibrationIsNotOverruledInSilence) {
  const Recording curve =
      open_recordings(samples / "fmt-jpk-fd_spot3-0192.jpk-force", {.spring_constant_N_per_m = 1})->read(0);
  EXPECT_NEAR(curve.metadata.spring_constant_N_per_m, 0.04349366641, 1e-10);
  ASSERT_EQ(curve.notes.size(), 1u);
  EXPECT_NE(curve.notes[0].find("--spring-constant 1"), std::string::npos);
}

}  // namespace
}  // namespace validate
