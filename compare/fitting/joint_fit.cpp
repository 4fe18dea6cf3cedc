#include "compare/fitting/joint_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace validate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr const char* of_a_drum = "radius";  ///< the input that every drum has its own of

/// Which of a curve's parameters are shared, and as which of the joint ones.
struct Shared {
  std::vector<int> own, joint;
};

/// E·h and the inputs' z: how many there are, and whose.
class SharedParameters {
 public:
  explicit SharedParameters(const std::vector<JointCurve>& curves) : uses_(1, 0) {
    names_.emplace_back();
    for (const JointCurve& curve : curves) {
      Shared shared{{0}, {0}};
      const auto& inputs = curve.likelihood.inputs();
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        const int drum = inputs[k].name == of_a_drum ? curve.drum : -1;
        const auto [found, is_new] = places_.try_emplace({inputs[k].name, drum}, static_cast<int>(names_.size()));
        if (is_new) {
          names_.push_back(inputs[k].name);
          uses_.push_back(0);
        }
        ++uses_[static_cast<std::size_t>(found->second)];
        shared.own.push_back(curve.likelihood.first_input() + static_cast<int>(k));
        shared.joint.push_back(found->second);
      }
      of_curve_.push_back(std::move(shared));
    }
  }

  int count() const { return static_cast<int>(names_.size()); }
  const std::string& name(int i) const { return names_[static_cast<std::size_t>(i)]; }
  /// By how many curves a z is counted more often than once.
  double repeated(int i) const { return i == 0 ? 0 : uses_[static_cast<std::size_t>(i)] - 1.0; }
  const Shared& of(std::size_t curve) const { return of_curve_[curve]; }

 private:
  std::vector<std::string> names_;
  std::vector<int> uses_;
  std::map<std::pair<std::string, int>, int> places_;
  std::vector<Shared> of_curve_;
};

/// What a curve says of the shared parameters when its own are the most likely.
struct Seen {
  VectorXd gradient;
  MatrixXd information;
  bool good = false;
};

Seen seen_by(JointCurve& curve, const Shared& shared, const VectorXd& joint) {
  VectorXd theta = curve.start;
  for (std::size_t i = 0; i < shared.own.size(); ++i) theta[shared.own[i]] = joint[shared.joint[i]];
  const LikelihoodMaximum best = maximise(curve.likelihood, theta, shared.own, 1e-8);
  if (!best.converged) return {};
  curve.start = best.theta;
  const Likelihood::At at = curve.likelihood.at(best.theta);
  const auto is_noise = [&](int i) {
    return i == curve.likelihood.force_noise_index() || i == curve.likelihood.depth_noise_index();
  };
  std::vector<int> own;
  for (int i = 0; i < best.theta.size(); ++i)  // a variance at its border is held there
    if (std::ranges::find(shared.own, i) == shared.own.end() && !(is_noise(i) && best.theta[i] <= 0)) own.push_back(i);
  const MatrixXd hessian = at.information - at.excess;
  const MatrixXd across = hessian(shared.own, own);
  const VectorXd solved = hessian(own, own).ldlt().solve(at.gradient(own));
  return {at.gradient(shared.own) - across * solved,
          hessian(shared.own, shared.own) - across * hessian(own, own).ldlt().solve(across.transpose()), true};
}

class JointSearch {
 public:
  JointSearch(std::vector<JointCurve> curves, const ForAll& for_all)
      : curves_(std::move(curves)), for_all_(for_all), shared_(curves_) {}

  std::string run() {
    constexpr int most = 20;
    constexpr double negligible = 1e-6;
    theta_ = VectorXd::Zero(shared_.count());
    double weight = 0;
    for (const JointCurve& curve : curves_) theta_[0] += curve.start[0], ++weight;
    theta_[0] /= weight;
    for (int pass = 0; pass < most; ++pass) {
      for (JointCurve& curve : curves_)
        if (pass == 0) curve.likelihood.take_slopes(curve.start);
      if (!gather()) return "a curve has no maximum at the common E·h";
      const VectorXd step = -information_.ldlt().solve(gradient_);
      if (-gradient_.dot(step) < negligible) return {};
      theta_ += step;
    }
    return "the joint fit did not converge";
  }

  JointFit result(double numerical) const {
    JointFit fit;
    fit.curves = static_cast<int>(curves_.size());
    fit.Eh_eV_per_A2 = theta_[0];
    std::map<std::string, JointSource> sources;
    sources["noise"] = {"noise", std::sqrt(2 / information_(0, 0)), true};
    for (int i = 1; i < shared_.count(); ++i) {
      JointSource& source = sources[shared_.name(i)];
      source.name = shared_.name(i);
      source.Eh_eV_per_A2 = std::hypot(source.Eh_eV_per_A2, information_(0, i) / information_(0, 0));
    }
    sources["numerical"] = {"numerical", numerical * theta_[0], false};
    for (auto& [name, source] : sources) fit.sources.push_back(std::move(source));
    std::ranges::sort(fit.sources, std::greater{}, &JointSource::Eh_eV_per_A2);
    const double variance = 2 * information_.inverse()(0, 0);
    fit.Eh_stderr_eV_per_A2 = std::hypot(std::sqrt(variance), numerical * theta_[0]);
    constexpr double quantile = 1.959964;
    fit.Eh_interval_eV_per_A2 = {theta_[0] - quantile * fit.Eh_stderr_eV_per_A2,
                                 theta_[0] + quantile * fit.Eh_stderr_eV_per_A2};
    return fit;
  }

 private:
  bool gather() {
    std::vector<Seen> seen(curves_.size());
    for_all_(curves_.size(), [&](std::size_t i) { seen[i] = seen_by(curves_[i], shared_.of(i), theta_); });
    const int n = shared_.count();
    gradient_ = VectorXd::Zero(n);
    information_ = MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (!seen[i].good) return false;
      const std::vector<int>& at = shared_.of(i).joint;
      gradient_(at) += seen[i].gradient;
      information_(at, at) += seen[i].information;
    }
    for (int i = 1; i < n; ++i) {
      gradient_[i] -= 2 * shared_.repeated(i) * theta_[i];
      information_(i, i) -= 2 * shared_.repeated(i);
    }
    return true;
  }

  std::vector<JointCurve> curves_;
  const ForAll& for_all_;
  SharedParameters shared_;
  VectorXd theta_, gradient_;
  MatrixXd information_;
};

}  // namespace

JointOutcome joint_fit(std::vector<JointCurve> curves, double numerical, const ForAll& for_all) {
  int drums = 0;
  for (const JointCurve& curve : curves) drums = std::max(drums, curve.drum + 1);
  JointSearch search(std::move(curves), for_all);
  JointOutcome outcome;
  outcome.reason = search.run();
  outcome.fit = search.result(numerical);
  outcome.fit.drums = drums;
  for (JointSource& source : outcome.fit.sources)
    source.falls = source.falls || (source.name == of_a_drum && drums > 1);
  return outcome;
}

}  // namespace validate
