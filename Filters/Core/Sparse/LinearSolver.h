// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/FactorBlocks.h"
#include "Sparse/NestedDissection.h"

#include <Eigen/SparseCore>

#include <memory>

namespace flattening
{
using SparseMatrix = Eigen::SparseMatrix<double>;

/// On the diagonal of constraints that may depend on each other, with entries about 1: it gives
/// them a pivot, and is small enough for refinement to take it out again.
inline constexpr double regularization = 1e-8;

/// How many columns are eliminated first, in their order. The others follow in the order of minimum
/// degree of what is left: where the first are unknowns of a saddle point system, each constraint
/// comes after some of its unknowns, and its pivot is not its small regularization.
struct LeadingColumns
{
  Index count = 0;
};

/// What factorizing a system of a planar mesh takes, in what it takes per unknown of a small one.
double factorizationWork(double unknowns);

/// L D L^T without pivoting of sparse symmetric matrices that are definite or quasi-definite.
///
/// Only the lower triangle of a matrix is read. analyze() is the symbolic part, which one sparsity
/// pattern needs once; factorize() calls it where it has not been called yet. Where memory runs
/// out, std::bad_alloc or OutOfMemory is thrown; nothing else throws.
class LinearSolver
{
public:
  /// Column by column, for small systems.
  explicit LinearSolver(LeadingColumns leading = {});
  /// By dense blocks on several threads, for large systems. \param order of elimination of all
  /// columns of the matrix.
  explicit LinearSolver(Dissection order, FactorPrecision precision = FactorPrecision::Double);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Finds an elimination order for the pattern of a compressed matrix. False where it is not
  /// square.
  bool analyze(const SparseMatrix& matrix);
  /// Factors a matrix of the pattern given to analyze(). False where a pivot is zero, an entry not
  /// finite, or the run is cancelled.
  bool factorize(const SparseMatrix& matrix, const Execution& execution = {});
  bool ok() const { return this->Factorized; }
  /// How factors are kept.
  FactorPrecision precision() const;
  /// Keeps the next factors in double precision.
  void keepDouble();

  /// Solves for every column of the right-hand side. Empty (no rows) where there is no
  /// factorization or the result is not finite.
  Eigen::MatrixXd solve(
    const Eigen::MatrixXd& rightHandSide, const Execution& execution = {}) const;
  /// The same followed by one step of iterative refinement with the given matrix, which may differ
  /// from the factored one by a small perturbation (the -delta I block of a regularized KKT
  /// system).
  Eigen::MatrixXd solveRefined(
    const SparseMatrix& matrix, const Eigen::MatrixXd& rightHandSide) const;

  /// Inertia: how many eigenvalues are positive, negative and zero, by the signs of D (Sylvester's
  /// law of inertia). none where there is no factorization.
  Index positive() const { return this->count(1); }
  Index negative() const { return this->count(-1); }
  Index zero() const { return this->count(0); }

private:
  struct Backend;
  struct SimplicialBackend;
  struct MultifrontalBackend;

  std::unique_ptr<Backend> Solver;
  Eigen::Index Size = 0;
  bool Analyzed = false;
  bool Factorized = false;

  Index count(int sign) const;
};

/// Of all x for which |matrix x - right| is least the shortest, by a complete orthogonal
/// decomposition: rows may depend on each other and contradict each other.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
}
