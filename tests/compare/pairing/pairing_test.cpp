// Each assumption that makes two runs one experiment, against numbers of its own.
#include "compare/pairing/pairing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/compare/pairing/sample_material.hpp"

using namespace validate;

namespace {

Case of_radius(double radius_A, std::vector<LoadKind> loads) {
  Case c;
  c.radius_A = radius_A;
  c.tip_radius_A = 5;
  c.loads = std::move(loads);
  return c;
}

/// The problem, which is to be on triangles, or on a meridian.
const membrane::Problem& triangles(const ContinuumExperiment& e) {
  EXPECT_TRUE(std::holds_alternative<membrane::Triangles>(e.problem.discretisation));
  return e.problem;
}
const membrane::Problem& rings(const ContinuumExperiment& e) {
  EXPECT_TRUE(std::holds_alternative<membrane::Meridian>(e.problem.discretisation));
  return e.problem;
}
double radius_of(const membrane::Problem& problem) { return std::get<membrane::DiscSheet>(problem.sheet).radius_A; }
double bending_of(const membrane::Problem& problem) { return problem.bending ? problem.bending->mean_eV : 0; }

/// Atoms of a hexagonal lattice about the middle of a hexagon, counted one by one.
int atoms_within_by_counting(double radius_A, double bond_A) {
  const double a = std::numbers::sqrt3 * bond_A;
  int count = 0;
  for (int i = -60; i <= 60; ++i)
    for (int k = -60; k <= 60; ++k)
      for (const double along : {1.0, 2.0}) {  // the two atoms of a cell lie a bond and two bonds from its corner
        const double x = a * (i + 0.5 * k), y = std::numbers::sqrt3 / 2 * a * k + along * bond_A;
        count += std::hypot(x, y) <= radius_A;
      }
  return count;
}

double radius_of_area_of(int atoms, double bond_A) {
  return std::sqrt(atoms * 3 * std::numbers::sqrt3 / 4 * bond_A * bond_A / std::numbers::pi);
}

TEST(Pairing, TheClampIsAMarginBeyondTheFreeAtomsArea) {
  sample::Pairing pairing(of_radius(20, {LoadKind::disc}));
  const PairedLoad& load = pairing.loads().at(0);
  const double a = radius_of_area_of(atoms_within_by_counting(20, 1.42), 1.42) + 0.44 * 1.42;
  EXPECT_NEAR(load.atoms->run.a_A, a, 1e-12);
  for (const Purpose purpose : {Purpose::like_for_like, Purpose::calibrated_membrane, Purpose::calibrated_sheet,
                                Purpose::paired_radii, Purpose::bending})
    EXPECT_NEAR(load.find(purpose)->run.a_A, a, 1e-12);
  EXPECT_NEAR(std::get<membrane::DiscSheet>(triangles(*load.find(Purpose::like_for_like)).sheet).radius_A, a, 1e-12);
  EXPECT_NEAR(radius_of(rings(*load.find(Purpose::calibrated_sheet))), a, 1e-12);
  EXPECT_EQ(load.atoms->problem.radius_A, 20);
  for (const Purpose nominal : {Purpose::paper, Purpose::nominal_radii}) EXPECT_EQ(load.find(nominal)->run.a_A, 20);
  EXPECT_EQ(radius_of(rings(*load.find(Purpose::nominal_radii))), 20);
}

TEST(Pairing, ASheetThatBendsTurnsAtItsClamp) {
  sample::Pairing pairing(of_radius(20, {LoadKind::disc}));
  const PairedLoad& load = pairing.loads().at(0);
  const auto margin = [&](Purpose purpose) {
    return std::get<membrane::DiscSheet>(rings(*load.find(purpose)).sheet).slope_margin_A;
  };
  for (const Purpose bent : {Purpose::bending, Purpose::calibrated_sheet})
    EXPECT_NEAR(margin(bent), 0.37 * 1.42, 1e-12);
  for (const Purpose limp : {Purpose::calibrated_membrane, Purpose::paired_radii, Purpose::nominal_radii})
    EXPECT_EQ(margin(limp), 0);
}

TEST(Pairing, DefectsDoNotMoveTheClamp) {
  Case c = of_radius(20, {LoadKind::disc});
  const double whole = sample::Pairing(c).sheet().effective_radius_A();
  c.vacancies_A = {3, 4, -8, 2};
  const sample::Pairing holed(c);
  EXPECT_LT(holed.sheet().sheet().free_atoms, atoms_within_by_counting(20, 1.42));
  EXPECT_DOUBLE_EQ(holed.sheet().effective_radius_A(), whole);
}

/// Area of the free atoms between the margins; across x and across y rows of atoms end at different places.
TEST(Pairing, AClampedSquareHasTheFreeAtomsAreaAndAMargin) {
  Case c = of_radius(20, {LoadKind::pressure});
  c.shape = Shape::square;
  c.pressures_eV_per_A3 = {1e-3};
  const sample::Pairing pairing(c);
  const Eigen::Vector2d half = pairing.sheet().half_A().array() - 0.44 * 1.42;
  const double area = 3 * std::numbers::sqrt3 / 4 * 1.42 * 1.42 * pairing.sheet().sheet().free_atoms;
  EXPECT_NEAR(4 * half.x() * half.y(), area, 1e-9 * area);
  EXPECT_NEAR(half.x(), 20, 0.75 * 1.42);
  EXPECT_NEAR(half.y(), 20, 0.75 * 1.42);
}

TEST(Pairing, TheTipIsADiscOfTheLoadedAtomsArea) {
  sample::Pairing pairing(of_radius(20, {LoadKind::disc, LoadKind::point}));
  const double disc = radius_of_area_of(atoms_within_by_counting(5, 1.42), 1.42), point = radius_of_area_of(6, 1.42);
  for (const auto& [load, tip] : {std::pair(&pairing.loads()[0], disc), std::pair(&pairing.loads()[1], point)}) {
    EXPECT_NEAR(load->atoms->run.tip_A, tip, 1e-12);
    const ContinuumExperiment &twin = *load->find(Purpose::like_for_like),
                              &sheet = *load->find(Purpose::calibrated_sheet);
    EXPECT_NEAR(std::get<membrane::DiscLoad>(triangles(twin).load).radius_A, tip, 1e-12);
    EXPECT_NEAR(std::get<membrane::DiscLoad>(rings(sheet).load).radius_A, tip, 1e-12);
  }
  EXPECT_EQ(pairing.loads()[0].find(Purpose::paper)->run.tip_A, 5);
  EXPECT_TRUE(std::holds_alternative<membrane::PointLoad>(triangles(*pairing.loads()[1].find(Purpose::paper)).load));
  EXPECT_TRUE(
      std::holds_alternative<membrane::PointLoad>(rings(*pairing.loads()[1].find(Purpose::nominal_radii)).load));
  EXPECT_EQ(std::get<atomistic::DiscLoad>(pairing.loads()[0].atoms->problem.load).radius_A, 5);
}

TEST(Pairing, ARigidSphereIsTheSameSphere) {
  sample::Pairing pairing(of_radius(20, {LoadKind::sphere}));
  const PairedLoad& load = pairing.loads()[0];
  EXPECT_EQ(std::get<atomistic::SphereLoad>(load.atoms->problem.load).radius_A, 5);
  EXPECT_EQ(std::get<membrane::SphereLoad>(triangles(*load.find(Purpose::like_for_like)).load).radius_A, 5);
  EXPECT_EQ(std::get<membrane::SphereLoad>(rings(*load.find(Purpose::calibrated_sheet)).load).radius_A, 5);
}

TEST(Pairing, TheDepthIsTakenAtOneBondBesideAtomsAndAtTheCentreAlone) {
  sample::Pairing pairing(of_radius(20, {LoadKind::disc}));
  const PairedLoad& load = pairing.loads()[0];
  EXPECT_DOUBLE_EQ(load.atoms->run.record_radius_A, 1.42);
  EXPECT_DOUBLE_EQ(triangles(*load.find(Purpose::like_for_like)).record_radius_A, 1.42);
  EXPECT_DOUBLE_EQ(rings(*load.find(Purpose::calibrated_sheet)).record_radius_A, 1.42);
  EXPECT_EQ(triangles(*load.find(Purpose::paper)).record_radius_A, 0);
}

TEST(Pairing, ConstantsAreTheCardsOrThePapers) {
  sample::Pairing pairing(of_radius(20, {LoadKind::disc}));
  const PairedLoad& load = pairing.loads()[0];
  const auto svk = [](const membrane::Law& law) { return std::get<membrane::StVenantKirchhoff>(law); };
  const ContinuumExperiment &twin = *load.find(Purpose::like_for_like), &paper = *load.find(Purpose::paper);
  EXPECT_DOUBLE_EQ(twin.run.Eh_eV_per_A2, 18.75);
  EXPECT_DOUBLE_EQ(twin.run.nu, 0.25);
  EXPECT_DOUBLE_EQ(svk(triangles(twin).law).sheet_modulus_eV_per_A2, 18.75);
  EXPECT_TRUE(triangles(twin).relaxed);
  EXPECT_NEAR(paper.run.Eh_eV_per_A2, 5.864 * 1.37, 1e-12);
  EXPECT_EQ(paper.run.nu, 0.19);
  EXPECT_EQ(paper.thickness_A, 1.37);
  EXPECT_EQ(twin.thickness_A, 3.35);
  EXPECT_DOUBLE_EQ(load.atoms->run.Eh_eV_per_A2, 18.75);
  for (const Purpose plain : {Purpose::nominal_radii, Purpose::paired_radii}) {
    EXPECT_TRUE(rings(*load.find(plain)).relaxed);
    EXPECT_EQ(bending_of(rings(*load.find(plain))), 0);
    EXPECT_DOUBLE_EQ(svk(rings(*load.find(plain)).law).sheet_modulus_eV_per_A2, 18.75);
  }
  for (const Purpose bent : {Purpose::bending, Purpose::calibrated_sheet}) {  // bending is what limits compression
    EXPECT_FALSE(rings(*load.find(bent)).relaxed);
    EXPECT_DOUBLE_EQ(bending_of(rings(*load.find(bent))), 1.5);
  }
  EXPECT_EQ(bending_of(rings(*load.find(Purpose::calibrated_membrane))), 0);
  EXPECT_TRUE(rings(*load.find(Purpose::calibrated_membrane)).relaxed);
}

TEST(Pairing, TheCasesLawIsThatOfTheLikeForLikeMembraneAlone) {
  Case c = of_radius(20, {LoadKind::disc});
  c.law.name = "lee";
  sample::Pairing pairing(c);
  const PairedLoad& load = pairing.loads()[0];
  const ContinuumExperiment& twin = *load.find(Purpose::like_for_like);
  const auto lee = std::get<membrane::LeeGraphene>(twin.problem.law);
  EXPECT_DOUBLE_EQ(lee.sheet_modulus_eV_per_A2, 18.75);
  EXPECT_DOUBLE_EQ(lee.nu, 0.25);
  EXPECT_EQ(twin.run.law, "lee");
  for (const Purpose plain : {Purpose::paper, Purpose::nominal_radii, Purpose::paired_radii, Purpose::bending}) {
    EXPECT_TRUE(std::holds_alternative<membrane::StVenantKirchhoff>(load.find(plain)->problem.law));
    EXPECT_EQ(load.find(plain)->run.law, "svk");
  }
  for (const Purpose own : {Purpose::calibrated_membrane, Purpose::calibrated_sheet})
    EXPECT_EQ(load.find(own)->run.law, "");
}

TEST(Pairing, PretensionIsAStrainOfTheAtomsAndTheLawsAnswerToIt) {
  Case c = of_radius(20, {LoadKind::disc});
  c.pretension_eV_per_A2 = 0.5;
  sample::Pairing pairing(c);
  const PairedLoad& load = pairing.loads()[0];
  const double strain = 0.5 * (1 - 0.25) / 18.75, stretch = 1 + strain, green = (stretch * stretch - 1) / 2;
  EXPECT_NEAR(load.atoms->problem.biaxial_strain, strain, 1e-15);
  const double bond = 1.42 * stretch;
  EXPECT_NEAR(load.atoms->run.a_A, radius_of_area_of(atoms_within_by_counting(20, bond), bond) + 0.44 * bond, 1e-12);
  const Eigen::Matrix2d prestress = triangles(*load.find(Purpose::like_for_like)).prestress_eV_per_A2;
  EXPECT_TRUE(prestress.isApprox(0.5 * Eigen::Matrix2d::Identity()));
  EXPECT_EQ(rings(*load.find(Purpose::bending)).prestress_eV_per_A2(0, 0), 0.5);

  // W = (C11 + C12)/4 I² + (C11 − C12) q² + c3 I³ gives S = (C11 + C12)/2 I + 3 c3 I² at I = 2 E, q = 0.
  const auto answer = [](double E) { return 12.5 * 2 * E + 3 * sample::c3 * 4 * E * E; };
  const ContinuumExperiment& sheet = *load.find(Purpose::calibrated_sheet);
  EXPECT_NEAR(rings(sheet).prestress_eV_per_A2(0, 0), answer(green), 1e-12);
  EXPECT_EQ(sheet.run.pretension_eV_per_A2, rings(sheet).prestress_eV_per_A2(0, 0));
  EXPECT_NEAR(bending_of(rings(sheet)), 1.5 / (stretch * stretch), 1e-12);
  EXPECT_NEAR(sheet.stretch, stretch, 1e-15);
  // Counted from the stretched sheet, Ē stands for the strain λ² Ē of the lattice: the forces must be the same.
  const auto& law = std::get<membrane::CauchyBorn>(rings(sheet).law);
  for (const double more : {0.0, 0.01, 0.05}) {
    const double from_stretched = green / (stretch * stretch) + more;
    EXPECT_NEAR(law({from_stretched, from_stretched, 0}).force_eV_per_A2[0], answer(green + stretch * stretch * more),
                1e-12);
  }
}

std::vector<Purpose> purposes(const PairedLoad& load) {
  std::vector<Purpose> all;
  for (const ContinuumExperiment& e : load.continua) all.push_back(e.purpose);
  return all;
}

TEST(Pairing, EveryModelThatIsAskedForAndNoOther) {
  using P = Purpose;
  Case c = of_radius(20, {LoadKind::disc});
  EXPECT_EQ(purposes(sample::Pairing(c).loads()[0]),
            (std::vector{P::like_for_like, P::paper, P::calibrated_membrane, P::calibrated_sheet, P::nominal_radii,
                         P::paired_radii, P::bending}));
  EXPECT_EQ(purposes(sample::Pairing(c, false).loads()[0]), (std::vector{P::like_for_like, P::paper}));  // no law
  EXPECT_TRUE(sample::Pairing(c).loads()[0].guide);
  EXPECT_FALSE(sample::Pairing(c, false).loads()[0].guide);
  c.vacancies_A = {3, 4};
  EXPECT_FALSE(sample::Pairing(c).loads()[0].guide);  // rings do not describe it
  c.vacancies_A.clear();
  c.models = Models::membrane;
  EXPECT_FALSE(sample::Pairing(c).loads()[0].atoms);
  EXPECT_FALSE(sample::Pairing(c).loads()[0].continua.empty());
  c.models = Models::atomistic;
  EXPECT_TRUE(sample::Pairing(c).loads()[0].atoms);
  EXPECT_TRUE(sample::Pairing(c).loads()[0].continua.empty());
}

TEST(Pairing, UnderAPressureThereIsNoPapersDiscAndNothingIsExplained) {
  Case c = of_radius(20, {LoadKind::pressure});
  c.pressures_eV_per_A3 = {1e-3};
  sample::Pairing pairing(c);
  const PairedLoad& load = pairing.loads()[0];
  EXPECT_EQ(purposes(load), (std::vector{Purpose::like_for_like, Purpose::calibrated_sheet}));
  EXPECT_TRUE(std::holds_alternative<atomistic::PressureLoad>(load.atoms->problem.load));
  EXPECT_EQ(load.atoms->problem.control, atomistic::Control::force);
  EXPECT_EQ(triangles(*load.find(Purpose::like_for_like)).control, membrane::Control::force);
  EXPECT_TRUE(std::isnan(load.atoms->run.tip_A));
}

TEST(Pairing, ASquareThatSlidesEndsWhereItsOutermostAtomsAre) {
  Case c = of_radius(20, {LoadKind::pressure});
  c.shape = Shape::square;
  c.edge = Edge::sliding;
  c.pressures_eV_per_A3 = {1e-3};
  sample::Pairing pairing(c);
  const auto& sheet =
      std::get<membrane::RectangleSheet>(triangles(*pairing.loads()[0].find(Purpose::like_for_like)).sheet);
  double x = 0, y = 0;
  for (int i = 0; i < pairing.sheet().sheet().free_atoms; ++i) {
    x = std::max(x, std::abs(pairing.sheet().sheet().position(i).x()));
    y = std::max(y, std::abs(pairing.sheet().sheet().position(i).y()));
  }
  EXPECT_NEAR(sheet.length_x_A, 2 * x, 2 * 1.42);
  EXPECT_NEAR(sheet.length_y_A, 2 * y, 2 * 1.42);
  EXPECT_LE(sheet.length_x_A, 2 * x + 1e-9);
  EXPECT_LE(sheet.length_y_A, 2 * y + 1e-9);
  EXPECT_EQ(sheet.left, membrane::Support::sliding);
  EXPECT_EQ(purposes(pairing.loads()[0]), std::vector{Purpose::like_for_like});  // one dimension is for discs
}

TEST(Pairing, GivenConstantsAreAMembraneOfNominalRadiiAlone) {
  Case c = of_radius(5000, {LoadKind::disc, LoadKind::point});
  c.models = Models::membrane;
  c.E_eV_per_A3 = 6, c.thickness_A = 3, c.nu = 0.2;
  const std::vector<PairedLoad> loads = pair(c);
  ASSERT_EQ(loads.size(), 2u);
  for (const PairedLoad& load : loads) {
    EXPECT_FALSE(load.atoms);
    ASSERT_EQ(purposes(load), std::vector{Purpose::given});
    EXPECT_EQ(load.continua[0].run.constants, Constants::given);
    EXPECT_EQ(load.continua[0].run.a_A, 5000);
    EXPECT_DOUBLE_EQ(load.continua[0].run.Eh_eV_per_A2, 18);
    EXPECT_EQ(load.continua[0].thickness_A, 3);
    EXPECT_EQ(triangles(load.continua[0]).record_radius_A, 0);
  }
}

TEST(Pairing, ForcesAreHeldInEveryModel) {
  Case c = of_radius(20, {LoadKind::disc});
  EXPECT_EQ(sample::Pairing(c).loads()[0].atoms->problem.control, atomistic::Control::conjugate_depth);
  c.forces_eV_per_A = {1, 2};
  sample::Pairing pairing(c);
  EXPECT_EQ(pairing.loads()[0].atoms->problem.control, atomistic::Control::force);
  EXPECT_EQ(triangles(*pairing.loads()[0].find(Purpose::like_for_like)).control, membrane::Control::force);
  EXPECT_EQ(rings(*pairing.loads()[0].find(Purpose::bending)).control, membrane::Control::force);
}

}  // namespace
