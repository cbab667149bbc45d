// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/LinearSolver.h"

#include "Base/Execution.h"
#include "Base/Memory.h"
#include "Base/Types.h"
#include "Sparse/LeadingElimination.h"
#include "Sparse/MultifrontalFactorization.h"
#include "Sparse/SuperLUFactorization.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace flattening
{
/// A factorization of Eigen that knows how much memory its factor takes. Eigen counts the entries
/// of a factor in int, and writes beyond its arrays where they are more.
template <typename Factorization>
class SimplicialFactorization : public Factorization
{
public:
  void analyzePattern(const Eigen::SparseMatrix<double>& matrix)
  {
    this->Factorization::analyzePattern(matrix);
    // Where columns start is counted in int and may have wrapped; how long each is has not.
    const int* starts = this->m_matrix.outerIndexPtr();
    std::int64_t count = 0;
    for (Eigen::Index column = 0; column < this->cols(); ++column)
    {
      count +=
        static_cast<std::uint32_t>(starts[column + 1]) - static_cast<std::uint32_t>(starts[column]);
    }
    this->Bytes = static_cast<std::size_t>(count) * (sizeof(double) + sizeof(int));
    if (count > std::numeric_limits<int>::max())
    {
      throwOutOfMemory(this->Bytes);
    }
  }
  void demandMemory(const Execution& execution) const
  {
    if (this->Bytes > execution.factorMemory)
    {
      throwOutOfMemory(this->Bytes);
    }
  }

private:
  std::size_t Bytes = 0;
};

namespace
{
/// The matrix with every diagonal entry stored, zero or not. SuperLU (up to 7.0) writes out of
/// bounds where elimination leaves a column without any stored entry to choose as pivot; a stored
/// diagonal rules that out for every matrix, and one that is singular is then told from the values.
SparseMatrix withDiagonal(const SparseMatrix& matrix)
{
  SparseMatrix diagonal(matrix.rows(), matrix.cols());
  diagonal.setIdentity();
  diagonal.coeffs().setZero();
  return matrix + diagonal;
}
}

/// What the methods have in common.
struct LinearSolver::Backend
{
  virtual ~Backend() = default;
  virtual void analyze(const SparseMatrix& matrix) = 0;
  virtual bool factorize(const SparseMatrix& matrix, const Execution& execution) = 0;
  virtual Eigen::MatrixXd solve(
    const Eigen::MatrixXd& rightHandSide, const Execution& execution) const = 0;
  /// Entries of D, or nothing.
  virtual Eigen::VectorXd diagonal() const { return {}; }
  virtual FactorPrecision precision() const { return FactorPrecision::Double; }
  virtual void keepDouble() {}
};

struct LinearSolver::CholeskyBackend : LinearSolver::Backend
{
  SimplicialFactorization<Eigen::SimplicialLLT<SparseMatrix>> solver;

  void analyze(const SparseMatrix& matrix) override { this->solver.analyzePattern(matrix); }
  bool factorize(const SparseMatrix& matrix, const Execution& execution) override
  {
    this->solver.demandMemory(execution);
    this->solver.factorize(matrix);
    return this->solver.info() == Eigen::Success;
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSide, const Execution&) const override
  {
    return this->solver.solve(rightHandSide);
  }
  Eigen::VectorXd diagonal() const override { return Eigen::VectorXd::Ones(this->solver.rows()); }
};

struct LinearSolver::SuperLUBackend : LinearSolver::Backend
{
  SuperLUFactorization solver;

  void analyze(const SparseMatrix& /*matrix*/) override {}
  bool factorize(const SparseMatrix& matrix, const Execution& /*execution*/) override
  {
    return this->solver.factorize(withDiagonal(matrix));
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSide, const Execution&) const override
  {
    return this->solver.solve(rightHandSide);
  }
};

struct LinearSolver::MultifrontalBackend : LinearSolver::Backend
{
  MultifrontalFactorization solver;
  Dissection dissection;

  void analyze(const SparseMatrix& matrix) override
  {
    if (static_cast<Eigen::Index>(this->dissection.order.size()) == matrix.rows())
    {
      this->solver.analyze(matrix, this->dissection);
    }
  }
  bool factorize(const SparseMatrix& matrix, const Execution& execution) override
  {
    return this->solver.factorize(matrix, execution);
  }
  Eigen::MatrixXd solve(
    const Eigen::MatrixXd& rightHandSide, const Execution& execution) const override
  {
    return this->solver.solve(rightHandSide, execution);
  }
  Eigen::VectorXd diagonal() const override { return this->solver.diagonal(); }
  FactorPrecision precision() const override { return this->solver.precision(); }
  void keepDouble() override { this->solver.setPrecision(FactorPrecision::Double); }
};

struct LinearSolver::LeadingBackend : LinearSolver::Backend
{
  /// So few columns cost less than to order them, even where they all become coupled.
  static constexpr Index fewColumns = 128;

  Index leading = 0;
  SimplicialFactorization<
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>>>
    solver;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> placeOfColumn; ///< empty: identity

  void analyze(const SparseMatrix& matrix) override
  {
    this->placeOfColumn.resize(0);
    if (matrix.cols() - this->leading > fewColumns)
    {
      const Indices order = leadingColumnsFirst(matrix, this->leading);
      this->placeOfColumn.resize(static_cast<Eigen::Index>(order.size()));
      for (std::size_t k = 0; k < order.size(); ++k)
      {
        this->placeOfColumn.indices()[order[k]] = static_cast<Index>(k);
      }
    }
    this->solver.analyzePattern(this->permuted(matrix));
  }
  bool factorize(const SparseMatrix& matrix, const Execution& execution) override
  {
    this->solver.demandMemory(execution);
    this->solver.factorize(this->permuted(matrix));
    return this->solver.info() == Eigen::Success;
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSide, const Execution&) const override
  {
    if (this->placeOfColumn.size() == 0)
    {
      return this->solver.solve(rightHandSide);
    }
    return this->placeOfColumn.transpose() *
      Eigen::MatrixXd(this->solver.solve(this->placeOfColumn * rightHandSide));
  }
  Eigen::VectorXd diagonal() const override { return this->solver.vectorD(); }

private:
  SparseMatrix permuted(const SparseMatrix& matrix) const
  {
    if (this->placeOfColumn.size() == 0)
    {
      return matrix;
    }
    SparseMatrix result(matrix.rows(), matrix.cols());
    result.selfadjointView<Eigen::Lower>() =
      matrix.selfadjointView<Eigen::Lower>().twistedBy(this->placeOfColumn);
    return result;
  }
};

namespace
{
bool allFinite(const SparseMatrix& matrix)
{
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
  {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (!std::isfinite(entry.value()))
      {
        return false;
      }
    }
  }
  return true;
}
}

LinearSolver::LinearSolver(LinearMethod method)
  : Symmetric(method == LinearMethod::Cholesky)
{
  if (method == LinearMethod::SuperLU)
  {
    this->Solver = std::make_unique<SuperLUBackend>();
  }
  else
  {
    this->Solver = std::make_unique<CholeskyBackend>();
  }
}

LinearSolver::LinearSolver(Dissection order, FactorPrecision precision)
  : Symmetric(true)
{
  auto backend = std::make_unique<MultifrontalBackend>();
  backend->solver.setPrecision(precision);
  backend->dissection = std::move(order);
  this->Solver = std::move(backend);
}

LinearSolver::LinearSolver(LeadingColumns leading)
  : Symmetric(true)
{
  auto backend = std::make_unique<LeadingBackend>();
  backend->leading = leading.count;
  this->Solver = std::move(backend);
}

LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

FactorPrecision LinearSolver::precision() const
{
  return this->Solver->precision();
}

void LinearSolver::keepDouble()
{
  if (this->precision() != FactorPrecision::Double)
  {
    this->Factorized = false;
    this->Solver->keepDouble();
  }
}

bool LinearSolver::analyze(const SparseMatrix& matrix)
{
  this->Analyzed = false;
  this->Factorized = false;
  this->Size = matrix.rows();
  if (matrix.rows() != matrix.cols())
  {
    return false;
  }
  if (this->Size > 0)
  {
    this->Solver->analyze(matrix);
  }
  this->Analyzed = true;
  return true;
}

bool LinearSolver::factorize(const SparseMatrix& matrix, const Execution& execution)
{
  this->Factorized = false;
  if (!this->Analyzed && !this->analyze(matrix))
  {
    return false;
  }
  if (matrix.rows() != this->Size || matrix.cols() != this->Size || !allFinite(matrix))
  {
    return false;
  }
  this->Factorized = this->Size == 0 || this->Solver->factorize(matrix, execution);
  return this->Factorized;
}

Eigen::MatrixXd LinearSolver::solve(
  const Eigen::MatrixXd& rightHandSide, const Execution& execution) const
{
  if (!this->Factorized || rightHandSide.rows() != this->Size)
  {
    return {};
  }
  if (rightHandSide.size() == 0)
  {
    return rightHandSide;
  }
  Eigen::MatrixXd solution = this->Solver->solve(rightHandSide, execution);
  return isFinite(solution) ? solution : Eigen::MatrixXd();
}

Eigen::MatrixXd LinearSolver::solveRefined(
  const SparseMatrix& matrix, const Eigen::MatrixXd& rightHandSide) const
{
  Eigen::MatrixXd solution = this->solve(rightHandSide);
  if (solution.rows() == 0 || matrix.rows() != this->Size || matrix.cols() != this->Size)
  {
    return solution;
  }
  Eigen::MatrixXd residual = rightHandSide;
  if (this->Symmetric)
  {
    residual -= matrix.selfadjointView<Eigen::Lower>() * solution;
  }
  else
  {
    residual -= matrix * solution;
  }
  const Eigen::MatrixXd correction = this->solve(residual);
  if (correction.rows() > 0)
  {
    solution += correction;
  }
  return solution;
}

Index LinearSolver::count(int sign) const
{
  if (!this->Factorized || !this->Symmetric)
  {
    return none;
  }
  if (this->Size == 0)
  {
    return 0;
  }
  const Eigen::VectorXd diagonal = this->Solver->diagonal();
  return static_cast<Index>(std::count_if(
    diagonal.begin(), diagonal.end(), [sign](double d) { return (d > 0.0) - (d < 0.0) == sign; }));
}
}
