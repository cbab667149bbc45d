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

/// Methods that find an order of elimination by themselves.
enum class LinearMethod
{
  SuperLU,  ///< LU with partial pivoting by the SuperLU library; any square matrix
  Cholesky, ///< L L^T; symmetric positive definite
};

/// How many columns an LDLT eliminates first, in the order that the caller has chosen well; the
/// others follow in the order of minimum degree of what is left.
struct LeadingColumns
{
  Index count;
};

/// One face for the direct solvers of sparse linear systems.
///
/// The symmetric methods read the lower triangle of the matrix only. analyze() is the symbolic
/// part, which one sparsity pattern needs once (SuperLU redoes it in every factorize());
/// factorize() calls it where it has not been called yet. Where memory runs out, std::bad_alloc or
/// OutOfMemory is thrown; nothing else throws.
class LinearSolver
{
public:
  explicit LinearSolver(LinearMethod method);
  /// L D L^T without pivoting by dense blocks on several threads, for large symmetric systems that
  /// are quasi-definite or definite. \param order of elimination of all columns of the matrix.
  explicit LinearSolver(Dissection order, FactorPrecision precision = FactorPrecision::Double);
  /// The same column by column, for small systems.
  explicit LinearSolver(LeadingColumns leading);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Finds an elimination order for the pattern of the matrix. False where it is not square.
  bool analyze(const SparseMatrix& matrix);
  /// Factors a matrix of the pattern given to analyze(). False where a pivot is zero, an entry not
  /// finite, or for Cholesky not positive definite, or the run is cancelled.
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
  /// law of inertia). Cholesky: all are positive. none where the method does not tell (LU) or there
  /// is no factorization.
  Index positive() const { return this->count(1); }
  Index negative() const { return this->count(-1); }
  Index zero() const { return this->count(0); }

private:
  struct Backend;
  struct CholeskyBackend;
  struct SuperLUBackend;
  struct MultifrontalBackend;
  struct LeadingBackend;

  bool Symmetric;
  std::unique_ptr<Backend> Solver;
  Eigen::Index Size = 0;
  bool Analyzed = false;
  bool Factorized = false;

  Index count(int sign) const;
};
}
