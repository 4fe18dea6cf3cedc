// Faults that test builds can switch on, to show that verification finds them. In every other build broken()
// is false at compile time, and nothing is left of it.
#pragma once

#include <string_view>

namespace membrane {

enum class Fault {
  none,
  no_contraction,
  no_prestress,
  double_turning,
  wrinkled_as_taut,
  half_shear,
  no_stress_stiffness,
  shape_gradient_sign,
  dead_pressure,
  no_pressure_stiffness,
  double_contact,
  open_mirror,
  constant_thickness,
  uneven_load,
};

#ifdef VALIDATE_FAULTS

inline Fault present_fault = Fault::none;
inline bool broken(Fault fault) { return present_fault == fault; }

struct NamedFault {
  std::string_view name;
  Fault fault;
};

inline constexpr NamedFault named_faults[] = {
    {"no-contraction", Fault::no_contraction},                // nu dropped from the relaxed law
    {"no-prestress", Fault::no_prestress},                    // the offset strain is zero
    {"double-turning", Fault::double_turning},                // factor 2 in the wrinkled tangent
    {"wrinkled-as-taut", Fault::wrinkled_as_taut},            // no relaxation
    {"half-shear", Fault::half_shear},                        // E12 for 2 E12
    {"no-stress-stiffness", Fault::no_stress_stiffness},      // material stiffness only
    {"shape-gradient-sign", Fault::shape_gradient_sign},      // of one corner
    {"dead-pressure", Fault::dead_pressure},                  // pressure keeps to z
    {"no-pressure-stiffness", Fault::no_pressure_stiffness},  // the follower term dropped from the Hessian
    {"double-contact", Fault::double_contact},                // of the sphere on the sheet
    {"open-mirror", Fault::open_mirror},                      // the sheet may pass through its mirror image
    {"constant-thickness", Fault::constant_thickness},        // in Cauchy stresses
    {"uneven-load", Fault::uneven_load},                      // a disc's density rises with the radius
};

#else

constexpr bool broken(Fault) { return false; }

#endif

}  // namespace membrane
