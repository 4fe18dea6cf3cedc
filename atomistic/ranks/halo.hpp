// Numbers that one rank has and another one needs: of atoms, three for each.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace atomistic {

/// An atom as its owner knows it.
struct Place {
  int rank = 0, index = 0;
};

/// Which atoms of others this rank needs, and which of its own they need. All ranks construct and use it together; they
/// talk to those alone who have something for each other.
class Halo {
 public:
  Halo() = default;

  /// In the order in which fetch() and give_back() have them.
  explicit Halo(const std::vector<Place>& needed);

  int needed() const { return needed_; }

  /// Of the needed atoms: what their owners have in `own`.
  Eigen::VectorXd fetch(const Eigen::VectorXd& own) const;

  /// Puts numbers of the needed atoms into their owners' `own`.
  void give_back(const Eigen::VectorXd& numbers, Eigen::VectorXd& own) const;

 private:
  struct Peer {
    int rank = 0;
    std::vector<int> atoms;  ///< places in fetch()'s order, or own ones
  };

  static void exchange(const std::vector<Peer>& out, const Eigen::VectorXd& from, const std::vector<Peer>& in,
                       Eigen::VectorXd& to);

  int needed_ = 0;
  std::vector<Peer> wanted_, asked_;  ///< needed from whom; own that whom asks for
};

}  // namespace atomistic
