// The flags of `validate fit` as they were typed, and what they say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/cli/flags.hpp"
#include "compare/fitting/measured_options.hpp"
#include "compare/instruments/measured.hpp"
#include "compare/potential/potential_card.hpp"

namespace validate {

/// The flags as they were typed; a key of the file's remarks stands in for one that was not.
struct FitFlags {
  std::vector<std::string> files;
  std::string radius, nu, tip, tip_radius, bending, model, weights;
  std::string depth_column, force_column, sigma_column;
  std::string depth_min, depth_max, baseline, contact;
  std::string potential, third_order;
  std::string sigma_force, sigma_depth, spring_constant, sensitivity, sensitivity_error, segment, curves;
  std::string settings;
  bool fit_force_zero = false, fit_slope = false, resume = false, quiet = false;
  int bootstrap = 0;
  unsigned seed = 1;
  OutputOptions output;
  std::string json;
};

/// The keys of --settings; their texts are those of the flags.
void describe(SameStruct<FitFlags> auto& f, auto&& visit) {
  const auto key = [&](std::string_view table, std::string_view name, auto& value) {
    visit(Field{.name = name, .table = table, .top_too = true}, value);
  };
  key("hole", "radius", f.radius);
  key("tip", "tip", f.tip);
  key("tip", "tip-radius", f.tip_radius);
  key("cantilever", "spring-constant", f.spring_constant);
  key("cantilever", "sensitivity", f.sensitivity);
  key("cantilever", "sensitivity-error", f.sensitivity_error);
  key("sheet", "nu", f.nu);
  key("sheet", "bending", f.bending);
  key("sheet", "potential", f.potential);
  key("sheet", "third-order", f.third_order);
  key("fit", "model", f.model);
  key("fit", "weights", f.weights);
  key("fit", "depth-column", f.depth_column);
  key("fit", "force-column", f.force_column);
  key("fit", "sigma-column", f.sigma_column);
  key("fit", "sigma-force", f.sigma_force);
  key("fit", "sigma-depth", f.sigma_depth);
  key("fit", "depth-min", f.depth_min);
  key("fit", "depth-max", f.depth_max);
  key("fit", "baseline", f.baseline);
  key("fit", "contact", f.contact);
  key("fit", "segment", f.segment);
  key("fit", "run", f.curves);
  key("fit", "fit-force-zero", f.fit_force_zero);
  key("fit", "fit-slope", f.fit_slope);
}

/// Takes what --settings says where no flag does. Throws Error (bad input) with file and line.
void take_settings(FitFlags& flags);

/// What is read of the files. A spring constant makes forces of deflections where a file has none of its own. Throws
/// Error (bad input) that names the flag.
MeasuredRequest request_of(const FitFlags& flags);

/// What is said about the experiment of a curve, with the card of the potential whose sheet is fitted. Throws Error
/// (bad input) that names the flag, or the file and its remark.
MeasuredOptions options_of(const FitFlags& flags, const MeasuredCurve& curve, const std::optional<PotentialCard>& card);

}  // namespace validate
