#include "membrane/check_discretisation.hpp"

#include <cmath>
#include <limits>

#include "membrane/base/refusal.hpp"

namespace membrane {
namespace {

struct WidestOn {
  const Sheet& sheet;
  /// There must be room for a ring of triangles outside.
  Widest operator()(const Triangles&) const {
    constexpr double share = 0.98;
    return {share * inner_radius_A(sheet), share * inner_radius_A(sheet)};
  }
  Widest operator()(const Meridian&) const { return {inner_radius_A(sheet), std::numeric_limits<double>::infinity()}; }
};

/// A meridian stands for all others only where none differs.
struct RoundSheet {
  void operator()(const DiscSheet& disc) const {
    if (disc.rings != DiscSheet{}.rings)
      refuse("sheet.rings", disc.rings, "is of triangles: the elements of a meridian follow discretisation.refinement");
    if (disc.spacing != DiscSheet{}.spacing)
      refuse("sheet.spacing", "uniform", "is of triangles: the elements of a meridian follow the load");
  }
  void operator()(const AnnulusSheet&) const { refuse("sheet", "an annulus", needs_disc); }
  void operator()(const RectangleSheet&) const { refuse("sheet", "a rectangle", needs_disc); }

  static constexpr const char* needs_disc = "a meridian is that of a disc: solve it on Triangles";
};

struct LoadOnMeridian {
  const Problem& problem;
  void operator()(const CentreForce&) const { beside_pressure(); }
  void operator()(const SpreadForce&) const { beside_pressure(); }
  void operator()(const RigidSphere&) const { beside_pressure(); }
  void operator()(const FollowerPressure&) const {
    if (problem.control != Control::force)
      refuse("control", "conjugate_depth",
             "must be force: a meridian has pressures by their value; volumes need Triangles");
  }
  void operator()(const EdgeMotion&) const {
    refuse("load", "a moved edge", "is no load of a meridian: solve it on Triangles");
  }

 private:
  void beside_pressure() const {
    if (problem.pressure_eV_per_A3 != 0 && problem.control == Control::force)
      refuse("control", "force", "must be conjugate_depth on a meridian beside a pressure; forces need Triangles");
  }
};

struct CheckOn {
  const Problem& problem;

  void operator()(const Triangles& triangles) const {
    if (const auto* disc = std::get_if<DiscSheet>(&problem.sheet); disc && disc->slope_margin_A != 0)
      refuse("sheet.slope_margin_A", disc->slope_margin_A, "is of a meridian: clamped triangles do not turn");
    if (!(triangles.relative_residual > 0))
      refuse("discretisation.relative_residual", triangles.relative_residual, "must be positive");
    if (triangles.most_iterations < 1)
      refuse("discretisation.most_iterations", triangles.most_iterations, "must be at least 1");
  }

  void operator()(const Meridian& meridian) const {
    if (!(meridian.refinement >= 0.1 && meridian.refinement <= 100))
      refuse("discretisation.refinement", meridian.refinement, "must lie between 0.1 and 100");
    std::visit(RoundSheet{}, problem.sheet);
    if (!is_isotropic(problem.law))
      refuse("law", "with directions",
             "must be isotropic on a meridian: a sheet that differs from side to side is not round");
    const Eigen::Matrix2d& p = problem.prestress_eV_per_A2;
    if (p(0, 0) != p(1, 1) || p(0, 1) != 0)
      refuse("prestress_eV_per_A2", p.reshaped().transpose(), "must be the same all round on a meridian");
    const DiscSheet& disc = std::get<DiscSheet>(problem.sheet);
    if (!problem.bending && disc.slope_margin_A != 0)
      refuse("sheet.slope_margin_A", disc.slope_margin_A, "is of a sheet that bends: a membrane has no slope to hold");
    if (problem.bending && disc.rim != Support::clamped)
      refuse("sheet.rim", "sliding",
             "must be clamped on a meridian that bends: it has no Gaussian term, which counts where a rim may turn");
    std::visit(LoadOnMeridian{problem}, action_of(problem.load));
    for (double level : problem.levels)
      if (!(level > 0)) refuse("levels", level, "every level must be positive on a meridian");
  }
};

}  // namespace

Widest widest_load(const Problem& problem) { return std::visit(WidestOn{problem.sheet}, problem.discretisation); }

void check_discretisation(const Problem& problem) { std::visit(CheckOn{problem}, problem.discretisation); }

}  // namespace membrane
