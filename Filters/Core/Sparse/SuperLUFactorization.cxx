// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/SuperLUFactorization.h"

#include "Base/Memory.h"

#include <slu_ddefs.h>

#include <vector>

namespace flattening
{
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
/// SuperLU ends the program where it has no memory for its small arrays; only that of the factors
/// it asks for with care. So the former are asked for here first, with a part of the latter.
void demandMemory(std::size_t size, std::size_t entries)
{
  const std::size_t bytes = 128 * size + 128 * entries;
  try
  {
    const std::vector<char> probe(bytes);
  }
  catch (const std::bad_alloc&)
  {
    refuseMemory(bytes);
  }
}
}

SuperLUFactorization::SuperLUFactorization() = default;
SuperLUFactorization::~SuperLUFactorization() = default;

bool SuperLUFactorization::factorize(Eigen::SparseMatrix<double> matrix)
{
  matrix.makeCompressed();
  const auto size = static_cast<int>(matrix.rows());
  demandMemory(static_cast<std::size_t>(size), static_cast<std::size_t>(matrix.nonZeros()));
  this->Held = std::make_unique<Factors>(size);
  Factors& factors = *this->Held;

  SuperMatrix a{};
  dCreate_CompCol_Matrix(&a, size, size, static_cast<int>(matrix.nonZeros()), matrix.valuePtr(),
    matrix.innerIndexPtr(), matrix.outerIndexPtr(), SLU_NC, SLU_D, SLU_GE);
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
    refuseMemory(static_cast<std::size_t>(info) - static_cast<std::size_t>(size));
  }
  return info == 0;
}

Eigen::MatrixXd SuperLUFactorization::solve(const Eigen::MatrixXd& rightHandSide) const
{
  Factors& factors = *this->Held;
  Eigen::MatrixXd x = factors.rowScale.asDiagonal() * rightHandSide;
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
}
