#include "compare/documents/page/plot_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace validate {
namespace {

using Json = nlohmann::ordered_json;

/// Six digits are more than a drawing shows, and a third of what a double takes. What is not finite becomes null.
Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(fmt::format("{:.6g}", value));
}

Json rounded(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value));
  return list;
}

Json rounded(const std::optional<double>& value) { return value ? rounded(*value) : Json(nullptr); }

/// Lengths of strokes and gaps, as SVG takes them.
const char* strokes_of(Dash dash) {
  switch (dash) {
    case Dash::solid:
      return "";
    case Dash::dashed:
      return "7 4";
    case Dash::dotted:
      return "2 3";
    case Dash::long_dashed:
      return "12 5";
    case Dash::dash_dotted:
      return "8 3 2 3";
    case Dash::long_dash_dotted:
      return "13 4 2 4";
  }
  return "";
}

const char* word_of(Marker marker) {
  switch (marker) {
    case Marker::circle:
      return "circle";
    case Marker::square:
      return "square";
    case Marker::triangle:
      return "triangle";
    case Marker::diamond:
      return "diamond";
  }
  return "";
}

Json json_of(const PlotCurve& curve) {
  Json json = {{"name", curve.name}, {"colour", hex(curve.colour)}, {"legend", curve.in_legend}};
  json["x"] = rounded(curve.x);
  json["y"] = rounded(curve.y);
  if (!curve.y_high.empty()) json["high"] = rounded(curve.y_high);
  if (curve.strokes) json["strokes"] = true;
  if (curve.line) json["line"] = {{"dash", strokes_of(curve.line->dash)}, {"width", curve.line->width}};
  if (curve.points || (!curve.line && curve.y_high.empty())) {
    const Points points = curve.points.value_or(Points{});
    json["points"] = {{"marker", word_of(points.marker)}, {"size", points.size}, {"open", points.open}};
  }
  return json;
}

Json json_of(const Axis& axis) {
  return {{"text", axis_text(axis)},      {"label", axis.label},        {"unit", axis.unit},
          {"low", rounded(axis.low)},     {"high", rounded(axis.high)}, {"logarithmic", axis.logarithmic},
          {"categories", axis.categories}};
}

const char* word_of(Along along) { return along == Along::x ? "x" : "y"; }

Json json_of(const Panel& panel) {
  Json json = {{"title", panel.title}, {"x", json_of(panel.x)}, {"y", json_of(panel.y)}};
  for (const char* list : {"curves", "bars", "zones", "marks", "labels"}) json[list] = Json::array();
  for (const PlotCurve& curve : panel.curves) json["curves"].push_back(json_of(curve));
  for (const StackedBars& bars : panel.bars)
    json["bars"].push_back({{"name", bars.name}, {"colour", hex(bars.colour)}, {"y", rounded(bars.y)}});
  for (const Zone& zone : panel.zones)
    json["zones"].push_back({{"along", word_of(zone.along)},
                             {"from", rounded(zone.from)},
                             {"to", rounded(zone.to)},
                             {"colour", hex(zone.colour)},
                             {"name", zone.name},
                             {"edge", zone.edge}});
  for (const Mark& mark : panel.marks)
    json["marks"].push_back({{"along", word_of(mark.along)},
                             {"at", rounded(mark.at)},
                             {"dash", strokes_of(mark.dash)},
                             {"colour", hex(mark.colour)}});
  for (const TextLabel& label : panel.labels)
    json["labels"].push_back(
        {{"text", label.text}, {"x", rounded(label.x)}, {"y", rounded(label.y)}, {"colour", hex(label.colour)}});
  return json;
}

}  // namespace

bool is_chart(const Plot& plot) { return !plot.panels.empty() && std::ranges::none_of(plot.panels, is_map); }

std::string plot_json(const Plot& plot) {
  Json json = {
      {"title", plot.title}, {"columns", plot.columns}, {"shares", plot.row_shares}, {"panels", Json::array()}};
  for (const Panel& panel : plot.panels) json["panels"].push_back(json_of(panel));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace validate
