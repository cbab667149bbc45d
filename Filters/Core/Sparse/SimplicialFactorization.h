// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Base/Memory.h"

#include <Eigen/SparseCholesky>

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
      refuseMemory(this->Bytes);
    }
  }
  void demandMemory(const Execution& execution) const
  {
    if (this->Bytes > execution.factorMemory)
    {
      refuseMemory(this->Bytes);
    }
  }

private:
  std::size_t Bytes = 0;
};
}
