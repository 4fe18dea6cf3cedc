#include "compare/fitting/models/list.hpp"

#include <fmt/format.h>
#include <gsl/gsl_sf_lambert.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/models/foeppl.hpp"

namespace validate {
namespace {

using std::numbers::pi;

/// cubic E·h δ³ + linear σ0h δ + constant δ
AnyCurveModel cubic_and_linear(double cubic, double linear, double constant = 0) {
  return {2, [=](double d, std::span<const double> p) { return d * (d * d * cubic * p[0] + linear * p[1] + constant); },
          [=](double d, std::span<const double>, std::span<double> g) {
            g[0] = cubic * d * d * d;
            g[1] = linear * d;
          }};
}

double relative_tip(const ModelGeometry& m) { return m.tip_A / m.a_A; }

AnyCurveModel eq16(const ModelGeometry& m) { return any_model(Eq16{m.a_A, m.nu}); }

AnyCurveModel first_order(const ModelGeometry& m, double tip) {
  const auto curve = foeppl_curve(m.nu, tip);
  return cubic_and_linear(curve->alpha() / (m.a_A * m.a_A), curve->beta() * pi);
}
AnyCurveModel point(const ModelGeometry& m) { return first_order(m, 0); }
AnyCurveModel disc(const ModelGeometry& m) { return first_order(m, relative_tip(m)); }

/// F = E·h δ³/a² g(η), η = σ0h a²/(E·h δ²)
AnyCurveModel foeppl(const ModelGeometry& m) {
  const auto curve = foeppl_curve(m.nu, relative_tip(m));
  const double a = m.a_A;
  return {2,
          [=](double d, std::span<const double> p) {
            return p[0] * d * d * d / (a * a) * curve->g(p[1] * a * a / (p[0] * d * d));
          },
          [=](double d, std::span<const double> p, std::span<double> g) {
            const double eta = p[1] * a * a / (p[0] * d * d), slope = curve->slope(eta);
            g[0] = d * d * d / (a * a) * (curve->g(eta) - eta * slope);
            g[1] = d * slope;
          }};
}

AnyCurveModel tip_pretension(const ModelGeometry& m) {
  return cubic_and_linear(foeppl_curve(m.nu, relative_tip(m))->alpha() / (m.a_A * m.a_A),
                          2 * pi / (std::log(m.a_A / m.tip_A) + 0.5));
}

/// b² from δ = (b²/Rt)(ln(a/b) + ½), b the radius of the contact, which grows with δ until b = a: with u = 1 −
/// ln(b²/a²) that is u e^{−u} = 2 δ Rt/(e a²), and u ≥ 1 Lambert's lower branch.
double sphere_contact_area(double depth, double a, double Rt) {
  const double x = 2 * depth * Rt / (a * a);
  return a * a * (x < 1 ? std::exp(1 + gsl_sf_lambert_Wm1(-x / std::numbers::e)) : 1);
}

AnyCurveModel sphere_pretension(const ModelGeometry& m) {
  const double a = m.a_A, Rt = m.tip_A;
  const auto slope = [=](double d) {
    return d == 0 ? 0 : std::copysign(2 * pi * sphere_contact_area(std::abs(d), a, Rt) / Rt, d);
  };
  const double alpha = foeppl_curve(m.nu, 0)->alpha() / (a * a);
  return {2, [=](double d, std::span<const double> p) { return alpha * p[0] * d * d * d + p[1] * slope(d); },
          [=](double d, std::span<const double>, std::span<double> g) {
            g[0] = alpha * d * d * d;
            g[1] = slope(d);
          }};
}

AnyCurveModel plate(const ModelGeometry& m) {
  const auto curve = foeppl_curve(m.nu, relative_tip(m));
  return cubic_and_linear(curve->alpha() / (m.a_A * m.a_A), curve->beta() * pi, plate_stiffness(m));
}

/// A disc of the sheet's own size is a pressure: p = F/(π a²).
AnyCurveModel hencky(const ModelGeometry& m) {
  const double area = pi * m.a_A * m.a_A;
  return cubic_and_linear(foeppl_curve(m.nu, 1)->alpha() / (m.a_A * m.a_A) / area, 4 / (m.a_A * m.a_A));
}

constexpr std::array forms = {
    ClosedForm{"disc", "F = α(ν, c/a) E·h δ³/a² + β(ν, c/a) π σ0h δ",
               "uniform load on r ≤ c; exact coefficients of shallow membrane theory, first order in the pretension",
               "Föppl–von Kármán equations solved here; Vella & Davidovitch, Soft Matter 13 (2017) 2264",
               TipShape::disc, false, disc},
    ClosedForm{"eq16", "F = E·h q³ δ³/a² + π σ0h δ, q = 1/(1.05 − 0.15 ν − 0.16 ν²)",
               "a point load at large depth, ν ≥ 0: q³ within 1 % of exact; the pretension term holds for no point "
               "load "
               "(exact: 0.67 to 0.69 of it) and a tip of finite size is stiffer",
               "Gil et al., J. Phys.: Condens. Matter 22 (2010) 145302, Eq. 16; Lee et al., Science 321 (2008) 385",
               TipShape::none, false, eq16},
    ClosedForm{"foeppl", "F = E·h δ³/a² g(σ0h a²/(E·h δ²); ν, c/a)",
               "uniform load on r ≤ c (or a point) and any pretension; slopes small against 1 (δ/a below 0.25 costs "
               "less than 0.5 % in force), no bending",
               "Föppl–von Kármán equations solved here, tabulated on demand", TipShape::disc, false, foeppl},
    ClosedForm{"hencky", "p = E·h w³/(C³ a⁴) + 4 σ0h w/a², C(ν) = (π/α(ν, 1))^{1/3}",
               "clamped disc under pressure, shallow; each term exact where the other vanishes",
               "Hencky, Z. Math. Phys. 63 (1915) 311; C(0.3) = 0.6534", TipShape::none, true, hencky},
    ClosedForm{"plate", "F = 64π κ δ/(a² (4 − 4ĉ² ln(1/ĉ) − 3ĉ²)) + β π σ0h δ + α E·h δ³/a², ĉ = c/a",
               "clamped plate, uniform load on r ≤ c; the sum of its limits, low by up to 17 % between them",
               "Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, § 19", TipShape::disc, false, plate},
    ClosedForm{"point", "F = α(ν) E·h δ³/a² + β(ν) π σ0h δ, α(1/3) = π/3, β(1/3) = 2/3",
               "a point load; exact coefficients of shallow membrane theory (α(1/3) for any depth), first "
               "order in the "
               "pretension",
               "Schwerin, Z. Angew. Math. Mech. 9 (1929) 482; Föppl–von Kármán equations solved here", TipShape::none,
               false, point},
    ClosedForm{"sphere-pretension", "F = 2π σ0h b²/Rt + α(ν) E·h δ³/a², δ = (b²/Rt)(ln(a/b) + ½)",
               "frictionless sphere of radius Rt, contact radius b; the pretension term is exact where E·h δ²/a² is "
               "small against σ0h, the cubic one where the contact is small",
               "Vella & Davidovitch, Soft Matter 13 (2017) 2264", TipShape::sphere, false, sphere_pretension},
    ClosedForm{"tip-pretension", "F = 2π σ0h δ/(ln(a/c) + ½) + α(ν, c/a) E·h δ³/a²",
               "uniform load on r ≤ c; each term exact where the other vanishes",
               "Laplace's equation for the taut sheet; Vella & Davidovitch, Soft Matter 13 (2017) 2264", TipShape::disc,
               false, tip_pretension},
};

}  // namespace

double plate_stiffness(const ModelGeometry& m) {
  const double c = relative_tip(m), shape = c > 0 ? 4 - 4 * c * c * std::log(1 / c) - 3 * c * c : 4;
  return 64 * pi * m.bending_eV / (shape * m.a_A * m.a_A);
}

std::span<const ClosedForm> closed_forms() { return forms; }

const ClosedForm& closed_form(std::string_view name, std::string_view label) {
  std::vector<std::string_view> names;
  for (const ClosedForm& form : forms) {
    if (form.name == name) return form;
    names.push_back(form.name);
  }
  throw bad_input("{}: unknown model '{}'; allowed: {}{}", label, name, fmt::join(names, ", "),
                  did_you_mean(name, names));
}

}  // namespace validate
