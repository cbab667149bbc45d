// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/SuperLUFactorization.h"

#include "Base/Memory.h"
#include "Base/Types.h"

#ifdef FLATTENING_WITHOUT_SUPERLU
#include <Eigen/SparseLU>
#else
#include <slu_ddefs.h>
#endif

#include <algorithm>
#include <new>
#include <vector>

namespace flattening
{
namespace
{
bool isSound(const Eigen::SparseMatrix<double>& matrix)
{
  return matrix.rows() == matrix.cols() && isFinite(matrix.coeffs());
}
}

#ifdef FLATTENING_WITHOUT_SUPERLU
struct SuperLUFactorization::Factors
{
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
};

bool SuperLUFactorization::factorize(const Eigen::SparseMatrix<double>& matrix)
{
  this->Held.reset();
  if (!isSound(matrix))
  {
    return false;
  }
  this->Held = std::make_unique<Factors>();
  this->Held->lu.compute(matrix);
  return this->Held->lu.info() == Eigen::Success;
}

Eigen::MatrixXd SuperLUFactorization::solve(const Eigen::MatrixXd& rightHandSide) const
{
  return this->Held->lu.solve(rightHandSide);
}
#else
struct SuperLUFactorization::Factors
{
  SuperMatrix lower{};
  SuperMatrix upper{};
  std::vector<int> columnOrder;
  std::vector<int> rowOrder;
  Eigen::VectorXd rowScale;
  Eigen::VectorXd columnScale;

  explicit Factors(int size)
    : columnOrder(size)
    , rowOrder(size)
    , rowScale(Eigen::VectorXd::Ones(size))
    , columnScale(Eigen::VectorXd::Ones(size))
  {
  }
  ~Factors()
  {
    if (this->lower.Store)
    {
      Destroy_SuperNode_Matrix(&this->lower);
    }
    if (this->upper.Store)
    {
      Destroy_CompCol_Matrix(&this->upper);
    }
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  /// Scales rows and columns of the matrix where their sizes differ much.
  void equilibrate(SuperMatrix& matrix)
  {
    Eigen::VectorXd rows(this->rowScale.size());
    Eigen::VectorXd columns(rows.size());
    double rowCondition = 0.0;
    double columnCondition = 0.0;
    double largest = 0.0;
    int info = 0;
    dgsequ(&matrix, rows.data(), columns.data(), &rowCondition, &columnCondition, &largest, &info);
    if (info != 0)
    {
      return;
    }
    char scaled = 'N';
    dlaqgs(&matrix, rows.data(), columns.data(), rowCondition, columnCondition, largest, &scaled);
    if (scaled == 'R' || scaled == 'B')
    {
      this->rowScale = rows;
    }
    if (scaled == 'C' || scaled == 'B')
    {
      this->columnScale = columns;
    }
  }
};

namespace
{
/// What the library takes beside the arrays that are counted, and what they are rounded up by.
constexpr std::size_t slack = std::size_t{ 1 } << 20U;

/// SuperLU ends the program where it has no memory for its small arrays; only that of the growing
/// factors it asks for with care. So the memory of each of its steps is asked for here first.
void demandMemory(std::size_t bytes)
{
  void* const probe = ::operator new(bytes + slack, std::nothrow);
  if (!probe)
  {
    throwOutOfMemory(bytes);
  }
  ::operator delete(probe);
}

/// Of COLAMD and the elimination tree.
std::size_t bytesOfOrder(std::size_t size, std::size_t entries)
{
  return 128 * size + 128 * entries;
}

/// Of the first guess of the factors, which it takes whole or, where it is not there, in such a
/// part that nothing may be left for its small arrays; and of these.
std::size_t bytesOfFactors(std::size_t size, std::size_t entries)
{
  const auto fill = static_cast<std::size_t>(sp_ienv(6));
  const auto panel = static_cast<std::size_t>(sp_ienv(1));
  const auto block = static_cast<std::size_t>(sp_ienv(3)) + static_cast<std::size_t>(sp_ienv(4));
  const std::size_t guess = fill * entries * (2 * sizeof(int) + 2 * sizeof(double));
  const std::size_t integers = (2 * panel + 24) * size * sizeof(int);
  const std::size_t numbers = (panel * size + std::max(size, block * panel)) * sizeof(double);
  return guess + integers + numbers;
}

/// The matrix with every diagonal entry stored, zero or not. SuperLU (up to 7.0) writes out of
/// bounds where elimination leaves a column without any stored entry to choose as pivot; a stored
/// diagonal rules that out for every matrix, and one that is singular is then told from the values.
Eigen::SparseMatrix<double> withDiagonal(const Eigen::SparseMatrix<double>& matrix)
{
  Eigen::SparseMatrix<double> diagonal(matrix.rows(), matrix.cols());
  diagonal.setIdentity();
  diagonal.coeffs().setZero();
  return matrix + diagonal;
}

/// What dgstrf() leaves where its memory ran out: the factors so far.
void freeUnfinished(GlobalLU_t& factors)
{
  for (void* array : { static_cast<void*>(factors.xsup), static_cast<void*>(factors.supno),
         static_cast<void*>(factors.lsub), static_cast<void*>(factors.xlsub),
         static_cast<void*>(factors.lusup), static_cast<void*>(factors.xlusup),
         static_cast<void*>(factors.ucol), static_cast<void*>(factors.usub),
         static_cast<void*>(factors.xusub), static_cast<void*>(factors.expanders) })
  {
    superlu_free(array);
  }
}
}

bool SuperLUFactorization::factorize(const Eigen::SparseMatrix<double>& matrix)
{
  this->Held.reset();
  if (!isSound(matrix))
  {
    return false;
  }
  Eigen::SparseMatrix<double> scaled = withDiagonal(matrix);
  const auto size = static_cast<int>(scaled.rows());
  const auto entries = static_cast<std::size_t>(scaled.nonZeros());
  demandMemory(bytesOfOrder(static_cast<std::size_t>(size), entries) +
    bytesOfFactors(static_cast<std::size_t>(size), entries));
  this->Held = std::make_unique<Factors>(size);
  Factors& factors = *this->Held;

  SuperMatrix a{};
  dCreate_CompCol_Matrix(&a, size, size, static_cast<int>(scaled.nonZeros()), scaled.valuePtr(),
    scaled.innerIndexPtr(), scaled.outerIndexPtr(), SLU_NC, SLU_D, SLU_GE);
  factors.equilibrate(a);
  superlu_options_t options{};
  set_default_options(&options);
  get_perm_c(COLAMD, &a, factors.columnOrder.data());
  std::vector<int> tree(size);
  SuperMatrix permuted{};
  sp_preorder(&options, &a, factors.columnOrder.data(), tree.data(), &permuted);

  SuperLUStat_t statistics{};
  StatInit(&statistics);
  GlobalLU_t workspace{};
  int info = 0;
  dgstrf(&options, &permuted, sp_ienv(2), sp_ienv(1), tree.data(), nullptr, 0,
    factors.columnOrder.data(), factors.rowOrder.data(), &factors.lower, &factors.upper, &workspace,
    &statistics, &info);
  StatFree(&statistics);
  Destroy_CompCol_Permuted(&permuted);
  Destroy_SuperMatrix_Store(&a);
  if (info != 0)
  {
    this->Held.reset();
  }
  if (info > size) // by as many bytes as it had when memory ran out
  {
    freeUnfinished(workspace);
    throwOutOfMemory(static_cast<std::size_t>(info) - static_cast<std::size_t>(size));
  }
  return info == 0;
}

Eigen::MatrixXd SuperLUFactorization::solve(const Eigen::MatrixXd& rightHandSide) const
{
  Factors& factors = *this->Held;
  Eigen::MatrixXd x = factors.rowScale.asDiagonal() * rightHandSide;
  demandMemory(static_cast<std::size_t>(x.size() + x.rows()) * sizeof(double));
  const auto rows = static_cast<int>(x.rows());
  SuperMatrix b{};
  dCreate_Dense_Matrix(&b, rows, static_cast<int>(x.cols()), x.data(), rows, SLU_DN, SLU_D, SLU_GE);
  SuperLUStat_t statistics{};
  StatInit(&statistics);
  int info = 0;
  dgstrs(NOTRANS, &factors.lower, &factors.upper, factors.columnOrder.data(),
    factors.rowOrder.data(), &b, &statistics, &info);
  StatFree(&statistics);
  Destroy_SuperMatrix_Store(&b);
  return factors.columnScale.asDiagonal() * x;
}
#endif

SuperLUFactorization::SuperLUFactorization() = default;
SuperLUFactorization::~SuperLUFactorization() = default;
}
