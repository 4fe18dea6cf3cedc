// What a curve of points says of a sheet: the likelihood of E·h, pretension and zeros, with noise in force and depth.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compare/fitting/force_model.hpp"

namespace validate {

/// Noise of the points, normal and independent. What is not known is estimated with the rest.
struct Noise {
  std::vector<double> force_weight;      ///< σ_F of each point over `force_eV_per_A`; empty: all 1
  std::optional<double> force_eV_per_A;  ///< σ_F, or what it is a multiple of
  std::optional<double> depth_A = 0;     ///< σ_d; of the piezo's position where there is a cantilever
};

struct CurvePoints {
  std::vector<double> depth_A, force_eV_per_A;  ///< as they stand in the file, before and after the contact
  Noise noise;
  /// 1/k of the cantilever that the depths are made with, d = z − F/k (Å²/eV), F's error in both; 0: depths of their
  /// own.
  double compliance_A2_per_eV = 0;
};

/// These points of a curve.
CurvePoints selected(const CurvePoints& points, const std::vector<std::size_t>& which);

/// What is free beside E·h and σ0·h.
struct FreeZeros {
  bool contact = false;     ///< depth where the sheet is touched; before it the force is the baseline's
  bool force_zero = false;  ///< force of the baseline at the contact
  bool slope = false;       ///< of the baseline
};

/// An input that is known with a standard error: the sheet with that input larger by it.
struct UncertainInput {
  std::string name;
  ForceModel larger;
};

/// −2 ln L of parameters θ = [E·h, σ0·h, contact?, force zero?, slope?, one z per input, σ_F²?, σ_d²?], in eV and Å, z
/// in standard errors. Each point stands for the place on the curve that its errors make most likely (orthogonal
/// distance, one projection); there the curve is a line, and the miss r = F − b − F(d) has the variance v = σ_F² +
/// F′² σ_d²; its mean from the curve's bend is taken off. Depths made with a cantilever are turned back into positions
/// z of the piezo, and F(z) is that of sheet and cantilever in series: contact and slope of the baseline are along z
/// then. −2 ln L = Σ r²/v + Σ z² + Σ ln v, the last with slopes that are held (take_slopes): a slope that lowered its
/// own ln v would be drawn down, by σ_d²/d² of a straight line. Fuller, Measurement Error Models, 1987, §§ 1.3, 3.2.
class Likelihood {
 public:
  Likelihood(CurvePoints points, ForceModel model, FreeZeros free, std::vector<UncertainInput> inputs = {});

  struct At {
    double minus_two_log = 0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd information;  ///< variance of the gradient, halved
    Eigen::MatrixXd excess;       ///< what the points' places along the curve, estimated each, have in it: the expected
                                  ///< Hessian is information − excess
  };
  /// Not finite where a parameter is out of its range.
  At at(const Eigen::VectorXd& theta) const;

  /// Holds the slopes of ln v, and what the bend adds to the mean, at those of the curve there. Before that the slopes
  /// are the curve's own, which the gradient leaves out, and nothing is added.
  void take_slopes(const Eigen::VectorXd& theta);

  int parameter_count() const { return count_; }
  int contact_index() const { return contact_; }
  int force_zero_index() const { return force_zero_; }
  /// Depth of the contact among the points' depths, at a contact and force zero of θ.
  double contact_depth(const Eigen::VectorXd& theta) const;
  int slope_index() const { return slope_; }
  int first_input() const { return first_input_; }
  int force_noise_index() const { return force_noise_; }  ///< −1: known
  int depth_noise_index() const { return depth_noise_; }
  const CurvePoints& points() const { return points_; }
  const std::vector<UncertainInput>& inputs() const { return inputs_; }

  /// How far each point is from the curve, and the standard deviation of that.
  struct Prediction {
    std::vector<double> miss, sigma;
  };
  Prediction prediction(const Eigen::VectorXd& theta) const;

  /// Parameters to start from: those of a cubic with a linear term (linear least squares at each of a row of contacts).
  Eigen::VectorXd start() const;

 private:
  struct Local;
  struct Mean;
  struct Sheets;
  Sheets sheets(const Eigen::VectorXd& theta) const;
  Mean mean(double depth, const Eigen::VectorXd& theta, const Sheets& sheets) const;
  Local local(std::size_t point, const Eigen::VectorXd& theta, const Sheets& sheets) const;

  CurvePoints points_;
  std::vector<double> along_;  ///< what the curve is over: depth, or the piezo's position
  ForceModel model_;
  std::vector<UncertainInput> inputs_;
  int count_ = 2, contact_ = -1, force_zero_ = -1, slope_ = -1, first_input_ = -1, force_noise_ = -1, depth_noise_ = -1;
  double deepest_ = 0, contact_width_ = 0, rounding_ = 0;
  std::vector<double> slopes_;  ///< of ln v; empty: the curve's own
  std::vector<double> bends_;   ///< what the mean over the errors of the depth is larger by; empty: nothing
};

struct LikelihoodMaximum {
  bool converged = false;
  std::string reason;  ///< why not
  int iterations = 0;
  Eigen::VectorXd theta;
  double minus_two_log = 0;
  Eigen::MatrixXd information;  ///< as Likelihood::At has it there
  Eigen::MatrixXd
      covariance;  ///< of the parameters, inputs included: H⁻¹ (variance of the gradient) H⁻¹, H the Hessian
  Eigen::VectorXd widening;  ///< of a parameter's variance over that of the Hessian alone: 1 without errors of depth
};

/// The most likely parameters from the likelihood's own start; takes its slopes.
LikelihoodMaximum most_likely(Likelihood& likelihood);

/// By damped Fisher scoring from `start`, by Newton's method where that is slow; the ones in `held` stay. A variance
/// that would fall below 0 stays there. Ends where −2 ln L, whose natural scale is 1, can fall by half of `negligible`
/// only.
LikelihoodMaximum maximise(const Likelihood& likelihood, const Eigen::VectorXd& start,
                           const std::vector<int>& held = {}, double negligible = 1e-12);

/// Ends of the profile-likelihood interval of a parameter: where −2 ln L, least over all others, has grown by
/// `threshold` times the parameter's widening (White, Econometrica 50, 1, 1982). An end not found within 100 standard
/// errors is infinite.
std::array<double, 2> profile_interval(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter,
                                       double threshold);

/// How much −2 ln L grows to the end of an interval of this confidence: χ² with one degree of freedom where the noise
/// is known, else what gives Student's interval for a linear model.
double profile_threshold(const Likelihood& likelihood, double confidence);

}  // namespace validate
