// Every number of compare/verify/reference_numbers.hpp, computed anew.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <string_view>

#include "compare/verify/reference_numbers.hpp"
#include "reference/annulus_torsion.hpp"
#include "reference/bent_strip.hpp"
#include "reference/foppl_disc.hpp"
#include "reference/foppl_point.hpp"
#include "reference/hencky.hpp"
#include "reference/mylar_balloon.hpp"
#include "reference/plate.hpp"
#include "reference/sheet_states.hpp"
#include "reference/svk_disc.hpp"
#include "reference/svk_pressure.hpp"
#include "reference/svk_sphere.hpp"

namespace reference {
namespace {

using Computations = std::map<std::string_view, std::function<double()>>;

// Gil et al. 2010: figure 2 (Å, eV) and figure 1 (nm, N/m, nN), the latter with the averages of Lee et al.
// 2008.
const SvkSheet softer_graphene{5.864 * 1.37, 0.19};
const SvkSheet graphene{342, 0.165, 0.34};

void add_foppl(Computations& all) {
  all["point_alpha.nu_0"] = [] { return foppl_point(0).alpha; };
  all["point_alpha.nu_0.165"] = [] { return foppl_point(0.165).alpha; };
  all["point_alpha.nu_0.19"] = [] { return foppl_point(0.19).alpha; };
  all["point_alpha.nu_0.3"] = [] { return foppl_point(0.3).alpha; };
  all["point_alpha.nu_1/3"] = [] { return std::numbers::pi / 3; };
  all["point_beta.nu_0"] = [] { return foppl_point(0).beta; };
  all["point_beta.nu_0.165"] = [] { return foppl_point(0.165).beta; };
  all["point_beta.nu_0.19"] = [] { return foppl_point(0.19).beta; };
  all["point_beta.nu_0.3"] = [] { return foppl_point(0.3).beta; };
  all["point_beta.nu_1/3"] = [] { return 2.0 / 3; };
  const auto disc_alpha = [](double c) { return std::pow(foppl_disc({0.19, c}, 1).centre, -3); };
  all["disc_alpha.nu_0.19.c_0.01a"] = [=] { return disc_alpha(0.01); };
  all["disc_alpha.nu_0.19.c_0.05a"] = [=] { return disc_alpha(0.05); };
  all["disc_alpha.nu_0.19.c_10/110a"] = [=] { return disc_alpha(10.0 / 110); };
}

void add_svk_discs(Computations& all) {
  const SvkDisc disc10{softer_graphene, 110, 10}, point{softer_graphene, 110, 1.1e-5};
  const SvkDisc of_record{{8.03368, 0.19, 0.02}, 110, 11};
  all["case2_disc10.depth_at_20_eV/A"] = [=] { return svk_disc_at_force(disc10, 20).centre_depth; };
  all["case2_disc10.force_at_10_A"] = [=] { return svk_disc_at_depth(disc10, 10).force; };
  all["case2_disc10.force_at_30_A"] = [=] { return svk_disc_at_depth(disc10, 30).force; };
  all["case2_disc10.force_at_60_A"] = [=] { return svk_disc_at_depth(disc10, 60).force; };
  all["case2_disc10.rim_force_at_30_A"] = [=] { return svk_disc_at_depth(disc10, 30).rim_force; };
  all["case2_point.depth_at_20_eV/A"] = [=] { return svk_disc_at_force(point, 20).centre_depth; };
  all["disc_of_record.depth_at_20_eV/A"] = [=] { return svk_disc_at_force(of_record, 20).centre_depth; };
  const auto figure1 = [](double c) { return svk_disc_at_force({graphene, 500, c}, 1500).centre_depth; };
  all["figure1.c_1e-4a.depth_at_1500_nN"] = [=] { return figure1(0.05); };
  all["figure1.c_16.5_nm.depth_at_1500_nN"] = [=] { return figure1(16.5); };
}

void add_spheres(Computations& all) {
  const SvkSphere small{graphene, 500, 16.5}, large{graphene, 500, 27.5};
  all["sphere_16.5_nm.force_at_20_nm"] = [=] { return svk_sphere_at_depth(small, 20).force; };
  all["sphere_16.5_nm.force_at_50_nm"] = [=] { return svk_sphere_at_depth(small, 50).force; };
  all["sphere_16.5_nm.force_at_100_nm"] = [=] { return svk_sphere_at_depth(small, 100).force; };
  all["sphere_16.5_nm.contact_at_100_nm"] = [=] { return svk_sphere_at_depth(small, 100).contact_radius; };
  all["sphere_27.5_nm.force_at_20_nm"] = [=] { return svk_sphere_at_depth(large, 20).force; };
  all["sphere_27.5_nm.force_at_50_nm"] = [=] { return svk_sphere_at_depth(large, 50).force; };
  all["sphere_27.5_nm.force_at_100_nm"] = [=] { return svk_sphere_at_depth(large, 100).force; };
  all["sphere_27.5_nm.contact_at_100_nm"] = [=] { return svk_sphere_at_depth(large, 100).contact_radius; };
}

void add_plates(Computations& all) {
  const auto depth = [](double bending, double force, double pretension = 0) {
    return plate({0.19, 1.0 / 11, bending, pretension}, force).centre_depth;
  };
  all["plate_depth.D_1e-3.F_1e-3"] = [=] { return depth(1e-3, 1e-3); };
  all["plate_depth.D_1e-3.F_1e-2"] = [=] { return depth(1e-3, 1e-2); };
  all["plate_depth.D_1e-4.F_1e-4"] = [=] { return depth(1e-4, 1e-4); };
  all["plate_depth.D_1e-4.F_1e-2"] = [=] { return depth(1e-4, 1e-2); };
  all["plate_depth.D_1e-5.F_1e-4"] = [=] { return depth(1e-5, 1e-4); };
  all["plate_depth.D_1e-5.F_1e-2"] = [=] { return depth(1e-5, 1e-2); };
  all["plate_depth.D_1e-6.F_1e-4"] = [=] { return depth(1e-6, 1e-4); };
  all["plate_depth.D_1e-6.F_1e-2"] = [=] { return depth(1e-6, 1e-2); };
  all["plate_depth.D_1e-5.F_1e-4.N0_1e-3"] = [=] { return depth(1e-5, 1e-4, 1e-3); };
}

void add_pressure(Computations& all) {
  all["hencky_C.nu_0.19"] = [] { return hencky(0.19).height; };
  all["hencky_C.nu_0.3"] = [] { return hencky(0.3).height; };
  const auto height = [](double nu, double load) { return svk_pressure({1, nu}, 1, load, Rim::clamped).height; };
  all["svk_pressure_height.nu_0.19.load_1e-4"] = [=] { return height(0.19, 1e-4); };
  all["svk_pressure_height.nu_0.19.load_1e-3"] = [=] { return height(0.19, 1e-3); };
  all["svk_pressure_height.nu_0.19.load_1e-2"] = [=] { return height(0.19, 1e-2); };
  all["svk_pressure_height.nu_0.19.load_1e-1"] = [=] { return height(0.19, 1e-1); };
  all["svk_pressure_height.nu_0.3.load_1e-4"] = [=] { return height(0.3, 1e-4); };
  all["svk_pressure_height.nu_0.3.load_1e-3"] = [=] { return height(0.3, 1e-3); };
  all["svk_pressure_height.nu_0.3.load_1e-2"] = [=] { return height(0.3, 1e-2); };
  all["svk_pressure_height.nu_0.3.load_1e-1"] = [=] { return height(0.3, 1e-1); };
  all["mylar_height"] = [] { return mylar_balloon().height; };
  all["mylar_radius"] = [] { return mylar_balloon().radius; };
}

void add_plane(Computations& all) {
  all["annulus_torque.b_1.5a"] = [] { return annulus_torsion_by_shooting(1.5).torque; };
  all["annulus_torque.b_2a"] = [] { return annulus_torsion_by_shooting(2).torque; };
  all["annulus_torque.b_3a"] = [] { return annulus_torsion_by_shooting(3).torque; };
  all["bent_strip_band.M_0.2PH"] = [] { return bent_strip_band(0.2); };
  all["bent_strip_band.M_0.3PH"] = [] { return bent_strip_band(0.3); };
  all["bent_strip_band.M_0.4PH"] = [] { return bent_strip_band(0.4); };
  all["bent_strip_curvature.M_0.2PH"] = [] { return bent_strip_curvature(0.2); };
  all["bent_strip_curvature.M_0.3PH"] = [] { return bent_strip_curvature(0.3); };
  all["bent_strip_curvature.M_0.4PH"] = [] { return bent_strip_curvature(0.4); };
  all["simple_shear_force.shear_0.1"] = [] { return simple_shear_wrinkled_force(0.1); };
}

Computations computations() {
  Computations all;
  add_foppl(all);
  add_svk_discs(all);
  add_spheres(all);
  add_pressure(all);
  add_plates(all);
  add_plane(all);
  return all;
}

TEST(ReferenceTable, HoldsWhatTheSolversSay) {
  const Computations all = computations();
  for (const Number& number : numbers) {
    SCOPED_TRACE(std::string(number.name));
    const auto computation = all.find(number.name);
    if (computation == all.end()) {
      ADD_FAILURE() << "nothing computes it";
      continue;
    }
    EXPECT_NEAR(computation->second() / number.value, 1, number.tolerance);
  }
}

TEST(ReferenceTable, LeavesNoComputationOut) {
  for (const auto& [name, computation] : computations()) EXPECT_NO_THROW(reference::number(name)) << name;
  EXPECT_EQ(computations().size(), numbers.size());
}

}  // namespace
}  // namespace reference
