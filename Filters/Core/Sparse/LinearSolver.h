// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/NestedDissection.h"

#include <Eigen/SparseCore>

#include <memory>

namespace flattening
{
using SparseMatrix = Eigen::SparseMatrix<double>;

enum class LinearMethod
{
  SuperLU,      ///< LU with partial pivoting by the SuperLU library; any square matrix
  SparseLU,     ///< LU with partial pivoting by Eigen; any square matrix
  LDLT,         ///< L D L^T without pivoting; symmetric, quasi-definite or definite
  Cholesky,     ///< L L^T; symmetric positive definite
  Multifrontal, ///< LDLT by dense blocks on several threads; for large systems
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
/// factorize() calls it where it has not been called yet. Nothing throws.
class LinearSolver
{
public:
  explicit LinearSolver(LinearMethod method);
  /// Multifrontal with an order of elimination that the caller knows to be good, of the columns of
  /// the matrix; by itself it takes that of minimum degree, column by column.
  explicit LinearSolver(Dissection order);
  explicit LinearSolver(LeadingColumns leading);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  LinearMethod method() const { return this->Method; }

  /// Finds an elimination order for the pattern of the matrix. False where it is not square.
  bool analyze(const SparseMatrix& matrix);
  /// Factors a matrix of the pattern given to analyze(). False where a pivot is zero, an entry not
  /// finite, for Cholesky not positive definite, or where memory runs out.
  bool factorize(const SparseMatrix& matrix, const Execution& execution = {});
  bool ok() const { return this->Factorized; }

  /// Solves for every column of the right-hand side. Empty (no rows) where there is no
  /// factorization or the result is not finite.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSide) const;
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
  struct SuperLUBackend;
  struct MultifrontalBackend;
  struct LeadingBackend;

  LinearMethod Method;
  std::unique_ptr<Backend> Solver;
  Eigen::Index Size = 0;
  bool Analyzed = false;
  bool Factorized = false;

  bool symmetric() const
  {
    return this->Method == LinearMethod::LDLT || this->Method == LinearMethod::Cholesky ||
      this->Method == LinearMethod::Multifrontal;
  }
  Index count(int sign) const;
};
}
