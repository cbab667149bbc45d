// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/LinearSolver.h"

#include "Base/CompressedRows.h"
#include "Base/Execution.h"
#include "Base/Memory.h"
#include "Base/Types.h"
#include "Sparse/MultifrontalFactorization.h"

#include <Eigen/OrderingMethods>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

namespace flattening
{
namespace
{
/// So few columns cost less than to order them, even where they all become coupled.
constexpr Index fewColumns = 128;

/// The place of each column: the first stay, the others follow in the order of minimum degree of
/// what is left of the graph without the first, whose elimination couples all neighbors of each
/// connected part of them. Empty where all stay.
Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> leadingColumnsFirst(
  const SparseMatrix& lower, Index leading)
{
  const auto size = static_cast<Index>(lower.cols());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place;
  if (size - leading <= fewColumns)
  {
    return place;
  }
  place.resize(size);
  place.setIdentity();
  JoinedSets parts(leading);
  std::vector<Eigen::Triplet<double>> couplings;
  const auto forEntries = [&lower](Index begin, Index end, const auto& visit) {
    for (Index column = begin; column < end; ++column)
    {
      for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
      {
        if (entry.row() >= column)
        {
          visit(static_cast<Index>(entry.row()), column);
        }
      }
    }
  };
  forEntries(0, leading, [&](Index row, Index column) {
    if (row < leading)
    {
      parts.join(row, column);
    }
  });
  forEntries(0, leading, [&](Index row, Index column) {
    if (row >= leading)
    {
      couplings.emplace_back(parts.find(column), row - leading, 1.0);
    }
  });
  SparseMatrix neighbors(leading, size - leading);
  neighbors.setFromTriplets(couplings.begin(), couplings.end());
  couplings.clear();
  forEntries(leading, size, [&](Index row, Index column) {
    couplings.emplace_back(row - leading, column - leading, 1.0);
    couplings.emplace_back(column - leading, row - leading, 1.0);
  });
  SparseMatrix rest(size - leading, size - leading);
  rest.setFromTriplets(couplings.begin(), couplings.end());
  rest += SparseMatrix(neighbors.transpose() * neighbors);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(rest, order);
  for (Index k = leading; k < size; ++k)
  {
    place.indices()[leading + order.indices()[k - leading]] = k;
  }
  return place;
}
}

/// What the methods have in common. Matrices are compressed.
struct LinearSolver::Backend
{
  virtual ~Backend() = default;
  virtual void analyze(const SparseMatrix& matrix) = 0;
  virtual bool factorize(const SparseMatrix& matrix, const Execution& execution) = 0;
  virtual Eigen::MatrixXd solve(
    const Eigen::MatrixXd& rightHandSide, const Execution& execution) const = 0;
  /// Entries of D.
  virtual Eigen::VectorXd diagonal() const = 0;
  virtual FactorPrecision precision() const { return FactorPrecision::Double; }
  virtual void keepDouble() {}
};

/// Eigen counts the entries of a factor in int, and would write beyond its arrays where they are
/// more.
struct LinearSolver::SimplicialBackend : LinearSolver::Backend
{
  explicit SimplicialBackend(Index leadingColumns)
    : Leading(leadingColumns)
  {
  }

  void analyze(const SparseMatrix& matrix) override
  {
    this->PlaceOfColumn = leadingColumnsFirst(matrix, this->Leading);
    SparseMatrix numbered = matrix;
    this->Stored = numbered.nonZeros();
    std::iota(numbered.valuePtr(), numbered.valuePtr() + this->Stored, 0.0);
    SparseMatrix lower(matrix.rows(), matrix.cols());
    lower.selfadjointView<Eigen::Lower>() =
      numbered.selfadjointView<Eigen::Lower>().twistedBy(this->PlaceOfColumn);
    this->Ordered.resize(matrix.rows(), matrix.cols());
    this->Ordered.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>();
    this->Source.resize(this->Ordered.nonZeros());
    std::transform(this->Ordered.valuePtr(), this->Ordered.valuePtr() + this->Ordered.nonZeros(),
      this->Source.begin(), [](double number) { return static_cast<Index>(number); });
    this->Solver.analyzePattern(this->Ordered);
    const std::int64_t entries = this->Solver.factorEntries();
    this->Bytes = static_cast<std::size_t>(entries) * (sizeof(double) + sizeof(int));
    if (entries > std::numeric_limits<int>::max())
    {
      throwOutOfMemory(this->Bytes);
    }
  }
  bool factorize(const SparseMatrix& matrix, const Execution& execution) override
  {
    if (this->Bytes > execution.factorMemory)
    {
      throwOutOfMemory(this->Bytes);
    }
    if (matrix.nonZeros() != this->Stored)
    {
      return false;
    }
    const double* const values = matrix.valuePtr();
    std::transform(this->Source.begin(), this->Source.end(), this->Ordered.valuePtr(),
      [values](Index stored) { return values[stored]; });
    this->Solver.factorize(this->Ordered);
    return this->Solver.info() == Eigen::Success;
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSide, const Execution&) const override
  {
    if (this->PlaceOfColumn.size() == 0)
    {
      return this->Solver.solve(rightHandSide);
    }
    return this->PlaceOfColumn.transpose() *
      Eigen::MatrixXd(this->Solver.solve(this->PlaceOfColumn * rightHandSide));
  }
  Eigen::VectorXd diagonal() const override { return this->Solver.vectorD(); }

private:
  struct Factorization
    : Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>>
  {
    std::int64_t factorEntries() const
    {
      // Where columns start may have wrapped; how long each is has not.
      const int* const starts = this->m_matrix.outerIndexPtr();
      std::int64_t count = 0;
      for (Eigen::Index column = 0; column < this->cols(); ++column)
      {
        count += static_cast<std::uint32_t>(starts[column + 1]) -
          static_cast<std::uint32_t>(starts[column]);
      }
      return count;
    }
  };

  Index Leading;
  Factorization Solver;
  std::size_t Bytes = 0; ///< of the factor
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> PlaceOfColumn;
  SparseMatrix Ordered; ///< the upper triangle, which Eigen takes without another copy
  Indices Source;       ///< of each of its entries, where it is stored in the matrix
  Eigen::Index Stored = 0;
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

LinearSolver::LinearSolver(LeadingColumns leading)
  : Solver(std::make_unique<SimplicialBackend>(leading.count))
{
}

LinearSolver::LinearSolver(Dissection order, FactorPrecision precision)
{
  auto backend = std::make_unique<MultifrontalBackend>();
  backend->solver.setPrecision(precision);
  backend->dissection = std::move(order);
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

double factorizationWork(double unknowns)
{
  // Up to here assembly and what is linear otherwise take more; with nested dissection operations
  // grow as the power 3/2.
  constexpr double linearUntil = 2000.0;
  return unknowns * std::sqrt(std::max(1.0, unknowns / linearUntil));
}

bool LinearSolver::factorize(const SparseMatrix& matrix, const Execution& execution)
{
  this->Factorized = false;
  if (!matrix.isCompressed())
  {
    SparseMatrix compressed = matrix;
    compressed.makeCompressed();
    return this->factorize(compressed, execution);
  }
  if (!this->Analyzed && !this->analyze(matrix))
  {
    return false;
  }
  if (matrix.rows() != this->Size || matrix.cols() != this->Size || !isFinite(matrix.coeffs()))
  {
    return false;
  }
  if (execution.factorized)
  {
    *execution.factorized += std::llround(factorizationWork(static_cast<double>(this->Size)));
  }
  this->Factorized = this->Size == 0 || this->Solver->factorize(matrix, execution);
  return this->Factorized;
}

Eigen::MatrixXd LinearSolver::solve(
  const Eigen::MatrixXd& rightHandSide, const Execution& execution) const
{
  if (!this->Factorized || rightHandSide.rows() != this->Size)
  {
    return Eigen::MatrixXd(0, rightHandSide.cols()); // a vector can be made of it
  }
  if (rightHandSide.size() == 0)
  {
    return rightHandSide;
  }
  Eigen::MatrixXd solution = this->Solver->solve(rightHandSide, execution);
  return isFinite(solution) ? solution : Eigen::MatrixXd(0, rightHandSide.cols());
}

Eigen::MatrixXd LinearSolver::solveRefined(
  const SparseMatrix& matrix, const Eigen::MatrixXd& rightHandSide) const
{
  Eigen::MatrixXd solution = this->solve(rightHandSide);
  if (solution.rows() == 0 || matrix.rows() != this->Size || matrix.cols() != this->Size)
  {
    return solution;
  }
  const Eigen::MatrixXd residual =
    rightHandSide - matrix.selfadjointView<Eigen::Lower>() * solution;
  const Eigen::MatrixXd correction = this->solve(residual);
  if (correction.rows() > 0)
  {
    solution += correction;
  }
  return solution;
}

Index LinearSolver::count(int sign) const
{
  if (!this->Factorized)
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

Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right)
{
  return matrix.completeOrthogonalDecomposition().solve(right);
}
}
