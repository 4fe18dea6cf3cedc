#include "atomistic/multigrid/multigrid.hpp"

#include <stdexcept>

#ifdef VALIDATE_HYPRE

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>

#include <algorithm>
#include <string>
#include <vector>

namespace atomistic {
namespace {

// The coarsest grid is solved directly; all else are products with matrices, on any number of ranks the same.
constexpr HYPRE_Int hmis = 10, extended_i = 6, chebyshev = 16, w_cycle = 2;
constexpr HYPRE_Int interpolated_from = 4;  // entries of a row of the interpolation at most

// A W-cycle comes to each coarser grid twice as often, and each time costs messages: below this size a grid is not
// worth them, every rank has all of it.
constexpr HYPRE_Int solved_directly = 300;
constexpr HYPRE_Int factorised = 99,
                    coarsest = 3;  // LAPACK's factor, made once; hypre's own elimination (9) makes it anew

/// hypre counts its errors in a global number.
void check(const char* doing) {
  const HYPRE_Int error = HYPRE_GetError();
  if (error == 0) return;
  char words[256] = {};
  HYPRE_DescribeError(error, words);
  HYPRE_ClearAllErrors();
  throw std::runtime_error(std::string("multigrid: ") + doing + ": " + words);
}

HYPRE_Solver one_cycle() {
  HYPRE_Solver solver = nullptr;
  HYPRE_BoomerAMGCreate(&solver);
  HYPRE_BoomerAMGSetPrintLevel(solver, 0);
  HYPRE_BoomerAMGSetNumFunctions(solver, 3);
  HYPRE_BoomerAMGSetCoarsenType(solver, hmis);
  HYPRE_BoomerAMGSetInterpType(solver, extended_i);
  HYPRE_BoomerAMGSetPMaxElmts(solver, interpolated_from);
  HYPRE_BoomerAMGSetRelaxType(solver, chebyshev);
  HYPRE_BoomerAMGSetCycleType(solver, w_cycle);
  HYPRE_BoomerAMGSetMaxCoarseSize(solver, solved_directly);
  HYPRE_BoomerAMGSetCycleRelaxType(solver, factorised, coarsest);
  HYPRE_BoomerAMGSetTol(solver, 0);
  HYPRE_BoomerAMGSetMaxIter(solver, 1);
  return solver;
}

/// Hands over some block rows at a time: hypre wants a scalar column for each number.
void fill(HYPRE_IJMatrix matrix, const BlockRows& rows, HYPRE_BigInt first) {
  constexpr int at_once = 4096;
  std::vector<HYPRE_Int> counts;
  std::vector<HYPRE_BigInt> numbers, columns;
  for (int begin = 0; begin < rows.rows(); begin += at_once) {
    const int end = std::min(begin + at_once, rows.rows());
    counts.clear(), numbers.clear(), columns.clear();
    for (int i = begin; i < end; ++i)
      for (int r = 0; r < 3; ++r) {
        numbers.push_back(first + 3 * i + r);
        counts.push_back(static_cast<HYPRE_Int>(3 * (rows.start[i + 1] - rows.start[i])));
        for (long b = rows.start[i]; b < rows.start[i + 1]; ++b)
          for (int c = 0; c < 3; ++c) columns.push_back(3 * rows.number_of(rows.column[b]) + c);
      }
    HYPRE_IJMatrixSetValues(matrix, static_cast<HYPRE_Int>(numbers.size()), counts.data(), numbers.data(),
                            columns.data(), rows.values.data() + 9 * rows.start[begin]);
  }
}

}  // namespace

struct Multigrid::Hierarchy {
  MPI_Comm communicator;
  HYPRE_Solver solver = nullptr;
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_IJVector right = nullptr, left = nullptr;
  HYPRE_ParCSRMatrix rows = nullptr;
  HYPRE_ParVector b = nullptr, x = nullptr;
  HYPRE_BigInt first = 0, last = -1;  ///< this rank's scalars

  ~Hierarchy() { release(); }

  void release() {
    if (solver) HYPRE_BoomerAMGDestroy(solver);
    if (right) HYPRE_IJVectorDestroy(right);
    if (left) HYPRE_IJVectorDestroy(left);
    if (matrix) HYPRE_IJMatrixDestroy(matrix);
    solver = nullptr, matrix = nullptr, right = left = nullptr;
  }

  void place(int block_rows) {
    HYPRE_BigInt own = 3 * static_cast<HYPRE_BigInt>(block_rows), end = 0;
    MPI_Scan(&own, &end, 1, MPI_INT, MPI_SUM, communicator);
    first = end - own;
    last = end - 1;
  }

  HYPRE_ParVector vector(HYPRE_IJVector& holder) const {
    HYPRE_IJVectorCreate(communicator, first, last, &holder);
    HYPRE_IJVectorSetObjectType(holder, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(holder);
    HYPRE_IJVectorAssemble(holder);
    void* object = nullptr;
    HYPRE_IJVectorGetObject(holder, &object);
    return static_cast<HYPRE_ParVector>(object);
  }

  void put(const Eigen::VectorXd& right_hand_side) const {
    HYPRE_IJVectorSetValues(right, static_cast<HYPRE_Int>(right_hand_side.size()), nullptr, right_hand_side.data());
    HYPRE_ParVectorSetConstantValues(x, 0);
  }

  Eigen::VectorXd answer() const {
    Eigen::VectorXd values(last - first + 1);
    HYPRE_IJVectorGetValues(left, last - first + 1, nullptr, values.data());
    return values;
  }

  /// With the numbers of entries on this rank and beyond known, hypre writes into its final arrays.
  void take(const BlockRows& given) {
    place(given.rows());
    HYPRE_IJMatrixCreate(communicator, first, last, first, last, &matrix);
    HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
    std::vector<HYPRE_Int> here, beyond;
    for (int i = 0; i < given.rows(); ++i) {
      const auto own = std::count_if(given.column.begin() + given.start[i], given.column.begin() + given.start[i + 1],
                                     [&](int c) { return c < given.rows(); });
      const auto all = given.start[i + 1] - given.start[i];
      here.insert(here.end(), 3, static_cast<HYPRE_Int>(3 * own));
      beyond.insert(beyond.end(), 3, static_cast<HYPRE_Int>(3 * (all - own)));
    }
    HYPRE_IJMatrixSetDiagOffdSizes(matrix, here.data(), beyond.data());
    HYPRE_IJMatrixInitialize(matrix);
    fill(matrix, given, first);
    HYPRE_IJMatrixAssemble(matrix);
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(matrix, &object);
    rows = static_cast<HYPRE_ParCSRMatrix>(object);
  }
};

Multigrid::Multigrid(Ranks ranks) : hierarchy_(std::make_unique<Hierarchy>()) {
  static const HYPRE_Int started = HYPRE_Init();  // once in a process; it ends with it
  static_cast<void>(started);
  hierarchy_->communicator = ranks == Ranks::all ? MPI_COMM_WORLD : MPI_COMM_SELF;
}

Multigrid::~Multigrid() = default;

void Multigrid::set_up(const BlockRows& rows) {
  Hierarchy& h = *hierarchy_;
  h.release();
  h.take(rows);
  check("taking the matrix");
  h.b = h.vector(h.right);
  h.x = h.vector(h.left);
  h.solver = one_cycle();
  HYPRE_BoomerAMGSetup(h.solver, h.rows, h.b, h.x);
  check("making the hierarchy");
}

Eigen::VectorXd Multigrid::cycle(const Eigen::VectorXd& right_hand_side) const {
  const Hierarchy& h = *hierarchy_;
  h.put(right_hand_side);
  HYPRE_BoomerAMGSolve(h.solver, h.rows, h.b, h.x);
  HYPRE_ClearError(HYPRE_ERROR_CONV);  // one cycle is asked for, no tolerance
  check("a cycle");
  return h.answer();
}

}  // namespace atomistic

#else

namespace atomistic {

struct Multigrid::Hierarchy {};

Multigrid::Multigrid(Ranks) { throw std::runtime_error("this program was built without hypre: it has no multigrid"); }
Multigrid::~Multigrid() = default;
void Multigrid::set_up(const BlockRows&) {}
Eigen::VectorXd Multigrid::cycle(const Eigen::VectorXd& right_hand_side) const { return right_hand_side; }

}  // namespace atomistic

#endif
