#include "atomistic/equilibrium/preconditioner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace atomistic {
namespace {

/// Adds the time until the end of its scope.
class Timed {
 public:
  explicit Timed(double& total_s) : total_s_(total_s) {}
  ~Timed() { total_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  double& total_s_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

void Preconditioner::factorise(const Eigen::VectorXd& positions, LoadTerm* load) {
  const Eigen::VectorXd x = positions.head(3 * sheet_.free_atoms);
  {
    const Timed timed(factor_s_);
    network_->set_up(positions, load ? load->stiffness(x) : std::vector<AtomStiffness>());
  }
  constraint_response_.resize(0);
  response_ = load ? load->given_back(x) : Eigen::VectorXd();
  if (response_.size() == 0) return;
  const Eigen::VectorXd k = response_;
  response_ = network_solve(k);
  response_ /= std::sqrt(std::max(1 - team_->sum(k.dot(response_)), 1e-6));
}

Eigen::VectorXd Preconditioner::network_solve(const Eigen::VectorXd& r) const {
  const Timed timed(solve_s_);
  ++solves_;
  return network_->solve(r);
}

const Eigen::VectorXd& Preconditioner::constraint_response(const Eigen::VectorXd& c) {
  if (c.size() && constraint_response_.size() == 0) constraint_response_ = solve(c);
  return constraint_response_;
}

Eigen::VectorXd Preconditioner::solve(const Eigen::VectorXd& r) const {
  Eigen::VectorXd s = network_solve(r);
  if (response_.size()) s += response_ * team_->sum(response_.dot(r));
  return s;
}

}  // namespace atomistic
