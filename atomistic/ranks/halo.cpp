#include "atomistic/ranks/halo.hpp"

#include <mpi.h>

#include <map>

namespace atomistic {
namespace {

constexpr int numbers_tag = 1, atoms_tag = 2;

int ranks() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

}  // namespace

Halo::Halo(const std::vector<Place>& needed) : needed_(static_cast<int>(needed.size())) {
  std::map<int, std::vector<int>> places, indices;
  for (int k = 0; k < needed_; ++k) {
    places[needed[k].rank].push_back(k);
    indices[needed[k].rank].push_back(needed[k].index);
  }
  for (auto& [rank, atoms] : places) wanted_.push_back({rank, std::move(atoms)});
  std::vector<int> wanted(static_cast<std::size_t>(ranks()), 0), asked(wanted.size(), 0);
  for (const Peer& peer : wanted_) wanted[peer.rank] = static_cast<int>(peer.atoms.size());
  MPI_Alltoall(wanted.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, MPI_COMM_WORLD);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
    if (asked[rank] > 0) asked_.push_back({static_cast<int>(rank), std::vector<int>(asked[rank])});
  std::vector<MPI_Request> requests;
  for (Peer& peer : asked_)
    MPI_Irecv(peer.atoms.data(), static_cast<int>(peer.atoms.size()), MPI_INT, peer.rank, atoms_tag, MPI_COMM_WORLD,
              &requests.emplace_back());
  for (auto& [rank, list] : indices)
    MPI_Isend(list.data(), static_cast<int>(list.size()), MPI_INT, rank, atoms_tag, MPI_COMM_WORLD,
              &requests.emplace_back());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

void Halo::exchange(const std::vector<Peer>& out, const Eigen::VectorXd& from, const std::vector<Peer>& in,
                    Eigen::VectorXd& to) {
  std::vector<Eigen::VectorXd> sent, received;
  std::vector<MPI_Request> requests;
  for (const Peer& peer : in) received.emplace_back(3 * static_cast<Eigen::Index>(peer.atoms.size()));
  for (const Peer& peer : out) {
    Eigen::VectorXd& numbers = sent.emplace_back(3 * static_cast<Eigen::Index>(peer.atoms.size()));
    for (std::size_t k = 0; k < peer.atoms.size(); ++k)
      numbers.segment<3>(3 * static_cast<Eigen::Index>(k)) =
          from.segment<3>(3 * static_cast<Eigen::Index>(peer.atoms[k]));
  }
  for (std::size_t p = 0; p < in.size(); ++p)
    MPI_Irecv(received[p].data(), static_cast<int>(received[p].size()), MPI_DOUBLE, in[p].rank, numbers_tag,
              MPI_COMM_WORLD, &requests.emplace_back());
  for (std::size_t p = 0; p < out.size(); ++p)
    MPI_Isend(sent[p].data(), static_cast<int>(sent[p].size()), MPI_DOUBLE, out[p].rank, numbers_tag, MPI_COMM_WORLD,
              &requests.emplace_back());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (std::size_t p = 0; p < in.size(); ++p)
    for (std::size_t k = 0; k < in[p].atoms.size(); ++k)
      to.segment<3>(3 * static_cast<Eigen::Index>(in[p].atoms[k])) =
          received[p].segment<3>(3 * static_cast<Eigen::Index>(k));
}

Eigen::VectorXd Halo::fetch(const Eigen::VectorXd& own) const {
  Eigen::VectorXd numbers(3 * static_cast<Eigen::Index>(needed_));
  exchange(asked_, own, wanted_, numbers);
  return numbers;
}

void Halo::give_back(const Eigen::VectorXd& numbers, Eigen::VectorXd& own) const {
  exchange(wanted_, numbers, asked_, own);
}

}  // namespace atomistic
