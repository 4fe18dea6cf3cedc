// Reference numbers for the tests of the sources, each with its tolerance and origin. reference_table_test
// computes every one anew on each run. Lengths and forces are per the quantities named beside each group.
#pragma once

#include <array>
#include <stdexcept>
#include <string_view>

namespace reference {

struct Number {
  std::string_view name;
  double value;
  double tolerance;  ///< relative: how well the number itself is known
  std::string_view origin;
};

// One number a line.
// clang-format off
inline constexpr auto numbers = std::to_array<Number>({
    // Point load, clamped, Föppl–von Kármán: F = alpha E·h delta³/a² + beta π N0 delta.
    Number{"point_alpha.nu_0", 0.860979695033, 1e-9, "independent solver: foppl_point"},
    Number{"point_alpha.nu_0.165", 0.937698538415, 1e-9, "independent solver: foppl_point"},
    Number{"point_alpha.nu_0.19", 0.951548280872, 1e-9, "independent solver: foppl_point"},
    Number{"point_alpha.nu_0.3", 1.0220616919, 1e-9, "independent solver: foppl_point"},
    Number{"point_alpha.nu_1/3", 1.0471975512, 1e-9, "closed form: π/3 (Schwerin 1929)"},
    Number{"point_beta.nu_0", 0.714454175492, 1e-9, "independent solver: foppl_point"},
    Number{"point_beta.nu_0.165", 0.692508247588, 1e-9, "independent solver: foppl_point"},
    Number{"point_beta.nu_0.19", 0.688920613543, 1e-9, "independent solver: foppl_point"},
    Number{"point_beta.nu_0.3", 0.672125794497, 1e-9, "independent solver: foppl_point"},
    Number{"point_beta.nu_1/3", 0.666666666667, 1e-9, "closed form: 2/3"},
    // Disc load, the same: alpha at c/a, delta at the centre.
    Number{"disc_alpha.nu_0.19.c_0.01a", 1.02773251586, 1e-9, "independent solver: foppl_disc"},
    Number{"disc_alpha.nu_0.19.c_0.05a", 1.19889371111, 1e-9, "independent solver: foppl_disc"},
    Number{"disc_alpha.nu_0.19.c_10/110a", 1.35188124233, 1e-9, "independent solver: foppl_disc"},
    // Finite St Venant–Kirchhoff under a disc, or a point (c = 1e-7 a). Depths of the centre.
    // case2: a = 110 Å, E·h = 5.864 × 1.37 eV/Å², nu = 0.19, no pretension, disc of 10 Å; forces in eV/Å.
    // Of record: the same radius, E·h = 8.03368 eV/Å², nu = 0.19, N0 = 0.02 eV/Å², disc of 11 Å.
    // figure1: a = 500 nm, E·h = 342 N/m, nu = 0.165, N0 = 0.34 N/m; depths in nm.
    Number{"case2_disc10.depth_at_20_eV/A", 28.1125949077, 1e-9, "independent solver: svk_disc"},
    Number{"case2_disc10.force_at_10_A", 0.897970300372, 1e-9, "independent solver: svk_disc"},
    Number{"case2_disc10.force_at_30_A", 24.3123122977, 1e-9, "independent solver: svk_disc"},
    Number{"case2_disc10.force_at_60_A", 195.376671789, 1e-9, "independent solver: svk_disc"},
    Number{"case2_disc10.rim_force_at_30_A", 0.160912269574, 1e-9, "independent solver: svk_disc"},
    Number{"case2_point.depth_at_20_eV/A", 31.6197716743, 1e-8, "independent solver: svk_disc"},
    Number{"disc_of_record.depth_at_20_eV/A", 27.162739174, 1e-9, "independent solver: svk_disc"},
    Number{"figure1.c_1e-4a.depth_at_1500_nN", 103.370810974, 1e-9, "independent solver: svk_disc"},
    Number{"figure1.c_16.5_nm.depth_at_1500_nN", 97.5817052895, 1e-9, "independent solver: svk_disc"},
    // Rigid frictionless sphere of radius Rt on the sheet of figure1: force in nN, contact radius in nm.
    Number{"sphere_16.5_nm.force_at_20_nm", 25.3941763141, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_16.5_nm.force_at_50_nm", 212.438291417, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_16.5_nm.force_at_100_nm", 1501.11604714, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_16.5_nm.contact_at_100_nm", 8.3471894519, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_27.5_nm.force_at_20_nm", 25.7691760987, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_27.5_nm.force_at_50_nm", 217.468530164, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_27.5_nm.force_at_100_nm", 1553.24126432, 1e-9, "independent solver: svk_sphere"},
    Number{"sphere_27.5_nm.contact_at_100_nm", 12.7441720837, 1e-9, "independent solver: svk_sphere"},
    // Sheet with bending, D = κ/(E·h a²), nu = 0.19, disc of c = a/11: depth of the centre / a at F/(E·h a).
    Number{"plate_depth.D_1e-3.F_1e-3", 0.01910502892, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-3.F_1e-2", 0.1235201414, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-4.F_1e-4", 0.01735716055, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-4.F_1e-2", 0.1802610699, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-5.F_1e-4", 0.03655454998, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-5.F_1e-2", 0.1918946091, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-6.F_1e-4", 0.0409292893, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-6.F_1e-2", 0.1940357302, 1e-8, "independent solver: plate"},
    Number{"plate_depth.D_1e-5.F_1e-4.N0_1e-3", 0.02375885916, 1e-8, "independent solver: plate"},
    // Clamped disc under pressure: w0 = C a (pa/E·h)^(1/3).
    Number{"hencky_C.nu_0.19", 0.679686524021, 1e-9, "independent solver: hencky (power series)"},
    Number{"hencky_C.nu_0.3", 0.653443344693, 1e-9, "independent solver: hencky (power series)"},
    // Finite St Venant–Kirchhoff, following pressure, clamped: w0/a at pa/E·h.
    Number{"svk_pressure_height.nu_0.19.load_1e-4", 0.0315554195456, 1e-9,
           "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.19.load_1e-3", 0.0680403908852, 1e-9,
           "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.19.load_1e-2", 0.14715508603, 1e-9, "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.19.load_1e-1", 0.322848159809, 1e-9, "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.3.load_1e-4", 0.0303361483828, 1e-9, "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.3.load_1e-3", 0.0654043748997, 1e-9, "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.3.load_1e-2", 0.141384569509, 1e-9, "independent solver: svk_pressure"},
    Number{"svk_pressure_height.nu_0.3.load_1e-1", 0.309515381929, 1e-9, "independent solver: svk_pressure"},
    // Mylar balloon: half thickness and inflated radius per flat radius.
    Number{"mylar_height", 0.456946581044, 1e-9, "closed form: Paulsen, Am. Math. Monthly 101 (1994) 953"},
    Number{"mylar_radius", 0.762759763502, 1e-9, "closed form: Paulsen, Am. Math. Monthly 101 (1994) 953"},
    // Annulus torsion, nu = 0, wrinkled: T/(E·h theta a²) at hub radius a, rim radius b.
    Number{"annulus_torque.b_1.5a", 5.37683644158, 1e-9, "independent solver: annulus_torsion_by_shooting"},
    Number{"annulus_torque.b_2a", 3.67804492873, 1e-9, "independent solver: annulus_torsion_by_shooting"},
    Number{"annulus_torque.b_3a", 2.70797353413, 1e-9, "independent solver: annulus_torsion_by_shooting"},
    // Stretched strip in bending: b/H, and κ E·h H²/P.
    Number{"bent_strip_band.M_0.2PH", 0.1, 1e-9, "closed form: Stein & Hedgepeth, NASA TN D-813 (1961)"},
    Number{"bent_strip_band.M_0.3PH", 0.4, 1e-9, "closed form: Stein & Hedgepeth, NASA TN D-813 (1961)"},
    Number{"bent_strip_band.M_0.4PH", 0.7, 1e-9, "closed form: Stein & Hedgepeth, NASA TN D-813 (1961)"},
    Number{"bent_strip_curvature.M_0.2PH", 2.46913580247, 1e-9,
           "closed form: Stein & Hedgepeth, NASA TN D-813 (1961)"},
    Number{"bent_strip_curvature.M_0.3PH", 5.55555555556, 1e-9,
           "closed form: Stein & Hedgepeth, NASA TN D-813 (1961)"},
    Number{"bent_strip_curvature.M_0.4PH", 22.2222222222, 1e-9,
           "closed form: Stein & Hedgepeth, NASA TN D-813 (1961)"},
    // Simple shear γ = 0.1, wrinkled: S1/(E·h).
    Number{"simple_shear_force.shear_0.1", 0.0525624609863, 1e-9,
           "closed form: larger principal value of E = ½[0 γ; γ γ²]"},
});
// clang-format on

/// The number of that name. Throws std::out_of_range for an unknown one: in a constant, the compiler refuses
/// it.
constexpr const Number& number(std::string_view name) {
  for (const Number& candidate : numbers) {
    if (candidate.name == name) return candidate;
  }
  throw std::out_of_range("no reference number of this name");
}

}  // namespace reference
