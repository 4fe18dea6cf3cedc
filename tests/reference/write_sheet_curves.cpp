// Writes compare/verify_fit/sheet_curves.json to standard output.
#include <cstdio>
#include <vector>

#include "reference/sheet_curves.hpp"

namespace {

void write(const char* name, const std::vector<double>& values) {
  std::printf("\"%s\": [", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.13g", i == 0 ? "" : i % 8 == 0 ? ",\n  " : ", ", values[i]);
  std::printf("]");
}

}  // namespace

int main() {
  using namespace reference;
  std::printf("{\"Eh_N_per_m\": %g, \"nu\": %g, \"radius_nm\": %g, \"curves\": [", drum_Eh_N_per_m, drum_nu,
              drum_radius_nm);
  const char* before = "\n";
  for (const SheetCurve& curve : sheet_curves()) {
    std::printf("%s {\"tip\": \"%s\", \"tip_radius_nm\": %g, \"pretension_N_per_m\": %g,\n  ", before,
                curve.tip.c_str(), curve.tip_radius_nm, curve.pretension_N_per_m);
    write("depth_nm", curve.depth_nm);
    std::printf(",\n  ");
    write("force_nN", curve.force_nN);
    std::printf("}");
    before = ",\n";
  }
  std::printf("]}\n");
}
