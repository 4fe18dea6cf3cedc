#include "atomistic/ranks/mpi_team.hpp"

#include <mpi.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace atomistic {

MpiTeam::MpiTeam() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
}

double MpiTeam::sum(double own) const {
  double all = 0;
  MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

double MpiTeam::largest(double own) const {
  double all = 0;
  MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return all;
}

std::vector<int> MpiTeam::owners(const std::vector<int>& claimed, int count) const {
  std::vector<int> owner(static_cast<std::size_t>(count), -1);
  for (const int number : claimed)
    if (number < count) owner[static_cast<std::size_t>(number)] = rank_;
  MPI_Allreduce(MPI_IN_PLACE, owner.data(), count, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (std::ranges::find(owner, -1) != owner.end()) throw std::runtime_error("an atom is on no rank");
  return owner;
}

std::vector<int> MpiTeam::starts(int own) const {
  std::vector<int> starts(static_cast<std::size_t>(ranks_) + 1, 0);
  MPI_Allgather(&own, 1, MPI_INT, starts.data() + 1, 1, MPI_INT, MPI_COMM_WORLD);
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

void MpiTeam::gather(const Eigen::VectorXd& own, const std::vector<int>& ids, Eigen::VectorXd& whole) const {
  const auto atoms = static_cast<int>(ids.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks_)), starts(counts.size());
  MPI_Gather(&atoms, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  const int all = rank_ == 0 ? starts.back() + counts.back() : 0;
  std::vector<int> all_ids(static_cast<std::size_t>(all));
  MPI_Gatherv(ids.data(), atoms, MPI_INT, all_ids.data(), counts.data(), starts.data(), MPI_INT, 0, MPI_COMM_WORLD);
  MPI_Datatype three = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(3, MPI_DOUBLE, &three);
  MPI_Type_commit(&three);
  Eigen::VectorXd numbers(3 * static_cast<Eigen::Index>(all));
  MPI_Gatherv(own.data(), atoms, three, numbers.data(), counts.data(), starts.data(), three, 0, MPI_COMM_WORLD);
  MPI_Type_free(&three);
  for (int k = 0; k < all; ++k)
    whole.segment<3>(3 * static_cast<Eigen::Index>(all_ids[k])) = numbers.segment<3>(3 * static_cast<Eigen::Index>(k));
}

}  // namespace atomistic
