// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace flattening
{
/// L U of a square matrix with partial pivoting by the SuperLU library: equilibrated, columns in
/// the order of COLAMD. A build without SuperLU takes Eigen's SparseLU instead.
///
/// Calls the library's steps one by one. Its driver for all of them, dgssvx, keeps memory for ever
/// where the matrix is singular (up to SuperLU 5.3), also when Eigen calls it.
class SuperLUFactorization
{
public:
  SuperLUFactorization();
  ~SuperLUFactorization();
  SuperLUFactorization(const SuperLUFactorization&) = delete;
  SuperLUFactorization& operator=(const SuperLUFactorization&) = delete;

  /// False where the matrix is singular, not square or an entry not finite.
  /// \pre the matrix is compressed.
  bool factorize(const Eigen::SparseMatrix<double>& matrix);
  /// \pre factorize() has succeeded.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSide) const;

private:
  struct Factors;
  std::unique_ptr<Factors> Held;
};
}
