// SPDX-License-Identifier: BSD-3-Clause
// Parts of a sparse symmetric matrix that are declared and filled by one type each: what is
// declared in a SymmetricAssembler and what is later added there come from the same loop over the
// same unknowns, so that pattern and values cannot drift apart. Rows and columns that are none have
// no entries.
#pragma once

#include "Sparse/SymmetricAssembler.h"

#include <Eigen/Core>

#include <array>

namespace flattening
{
/// A dense symmetric block, its lower triangle.
template <int N>
class SymmetricBlock
{
public:
  SymmetricBlock() = default;
  /// Declares the entries.
  SymmetricBlock(SymmetricAssembler& assembler, const std::array<Index, N>& unknowns)
    : Unknowns(unknowns)
  {
    forEach(this->Unknowns, [&](int a, int b) {
      const Index entry = assembler.declare(unknowns[a], unknowns[b]);
      this->First = this->First == none ? entry : this->First;
    });
  }
  const std::array<Index, N>& unknowns() const { return this->Unknowns; }
  /// \param values a matrix or whatever gives a number for (row, column), row >= column.
  template <class Values>
  void add(SymmetricAssembler& assembler, const Values& values) const
  {
    Index entry = this->First;
    forEach(this->Unknowns, [&](int a, int b) { assembler.add(entry++, values(a, b)); });
  }
  /// Adds the block's part of a vector to the whole.
  template <class Part>
  void scatter(const Part& part, Eigen::VectorXd& whole) const
  {
    for (int a = 0; a < N; ++a)
    {
      if (this->Unknowns[a] != none)
      {
        whole[this->Unknowns[a]] += part[a];
      }
    }
  }

private:
  template <class Visit>
  static void forEach(const std::array<Index, N>& unknowns, const Visit& visit)
  {
    for (int a = 0; a < N; ++a)
    {
      for (int b = 0; b <= a; ++b)
      {
        if (unknowns[a] != none && unknowns[b] != none)
        {
          visit(a, b);
        }
      }
    }
  }

  std::array<Index, N> Unknowns{};
  Index First = none; ///< entry; the others follow
};

/// A dense block of rows that come after all its columns: a part of a Jacobian in a KKT matrix.
template <int Rows, int Columns>
class JacobianBlock
{
public:
  JacobianBlock() = default;
  /// Declares the entries of so many rows from the first on.
  JacobianBlock(
    SymmetricAssembler& assembler, Index firstRow, const std::array<Index, Columns>& columns)
    : Unknowns(columns)
  {
    forEach(columns, [&](int r, int c) {
      const Index entry = assembler.declare(firstRow + r, columns[c]);
      this->First = this->First == none ? entry : this->First;
    });
  }
  /// \param values a matrix or whatever gives a number for (row, column).
  template <class Values>
  void add(SymmetricAssembler& assembler, const Values& values) const
  {
    Index entry = this->First;
    forEach(this->Unknowns, [&](int r, int c) { assembler.add(entry++, values(r, c)); });
  }
  /// Adds the transposed block times the multipliers of its rows to a vector of the unknowns.
  template <class Values, class Multipliers>
  void addTransposedTimes(
    const Values& values, const Multipliers& multipliers, Eigen::VectorXd& product) const
  {
    forEach(this->Unknowns,
      [&](int r, int c) { product[this->Unknowns[c]] += multipliers[r] * values(r, c); });
  }

private:
  template <class Visit>
  static void forEach(const std::array<Index, Columns>& columns, const Visit& visit)
  {
    for (int c = 0; c < Columns; ++c)
    {
      for (int r = 0; r < Rows && columns[c] != none; ++r)
      {
        visit(r, c);
      }
    }
  }

  std::array<Index, Columns> Unknowns{};
  Index First = none; ///< entry; the others follow
};

/// Entries on the diagonal, of unknowns that follow each other.
class DiagonalBlock
{
public:
  DiagonalBlock() = default;
  /// Declares the entries.
  DiagonalBlock(SymmetricAssembler& assembler, Index firstUnknown, Index count)
  {
    for (Index k = 0; k < count; ++k)
    {
      const Index entry = assembler.declare(firstUnknown + k, firstUnknown + k);
      this->First = k == 0 ? entry : this->First;
    }
  }
  /// \param k counted from the first unknown.
  void add(SymmetricAssembler& assembler, Index k, double value) const
  {
    assembler.add(this->First + k, value);
  }

private:
  Index First = none; ///< entry; the others follow
};
}
