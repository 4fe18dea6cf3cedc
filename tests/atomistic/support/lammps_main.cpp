// MPI lives as long as the test program.
#include <gtest/gtest.h>

#include "atomistic/lammps/lammps.hpp"
#include "tests/atomistic/support/lammps_session.hpp"

namespace {
const atomistic::MpiSession* session = nullptr;
}

const atomistic::MpiSession& lammps_session() { return *session; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const atomistic::MpiSession mpi(&argc, &argv);
  session = &mpi;
  return RUN_ALL_TESTS();
}
