// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/LargeArray.h"
#include "Base/Types.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>

// Parts of a sparse symmetric matrix that are declared and filled by one type each: what is
// declared in a SymmetricAssembler and what is later added there come from the same loop over the
// same unknowns, so that pattern and values cannot drift apart. Rows and columns that are none have
// no entries.

namespace flattening
{
/// Fills the lower triangle of a symmetric sparse matrix again and again in one pattern.
///
/// Entries are declared once, in the order in which their values come later; values of entries at
/// one place add up.
class SymmetricAssembler
{
public:
  explicit SymmetricAssembler(Index size)
    : Size(size)
  {
  }
  /// Makes room for entries.
  void reserve(std::size_t count)
  {
    this->Rows.reserve(count);
    this->Columns.reserve(count);
  }
  /// Declares an entry; the larger index is its row. Returns its number.
  Index declare(Index i, Index j) { return this->declareRows(std::max(i, j), 1, std::min(i, j)); }
  /// Declares the entries of two rows, which follow each other, in a column that is none after
  /// them, as one.
  Index declarePair(Index row, Index column) { return this->declareRows(row, 2, column); }
  /// Finds the pattern of all declared entries.
  void finish();

  void clear() { std::fill_n(this->Matrix.valuePtr(), this->Matrix.nonZeros(), 0.0); }
  void add(Index entry, double value) { this->Matrix.valuePtr()[this->Slots[entry]] += value; }
  void addPair(Index entry, double first, double second)
  {
    double* const values = this->Matrix.valuePtr() + this->Slots[entry];
    values[0] += first;
    values[1] += second;
  }
  const Eigen::SparseMatrix<double>& matrix() const { return this->Matrix; }

private:
  Index declareRows(Index first, Index count, Index column)
  {
    this->Rows.push_back(2 * first + count - 1);
    this->Columns.push_back(column);
    return static_cast<Index>(this->Rows.size()) - 1;
  }

  Index Size;
  LargeArray<Index> Rows; ///< twice the first, and 1 where a second one follows
  LargeArray<Index> Columns;
  LargeArray<Index> Slots;
  Eigen::SparseMatrix<double> Matrix;
};

/// A dense symmetric block, its lower triangle. An unknown may stand in it twice.
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
    forEach(this->Unknowns, [&](int a, int b) {
      const bool twice = a != b && this->Unknowns[a] == this->Unknowns[b];
      assembler.add(entry++, twice ? 2.0 * values(a, b) : values(a, b));
    });
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

/// A dense symmetric block of the coordinates x and y, unknowns 2 v and 2 v + 1, of N
/// different vertices: its entries are known by the first, so that blocks in a row need no memory.
template <int N>
class PointsBlock
{
public:
  static constexpr Index entryCount = N * (N + 1);
  using Vertices = std::array<Index, N>;

  /// Declares the entries. \return the first; the others follow
  static Index declare(SymmetricAssembler& assembler, const Vertices& v)
  {
    Index first = none;
    for (int p = 0; p < N; ++p)
    {
      const Index own = assembler.declarePair(2 * v[p], 2 * v[p]);
      assembler.declare(2 * v[p] + 1, 2 * v[p] + 1);
      first = p == 0 ? own : first;
      for (int q = 0; q < p; ++q)
      {
        const auto [column, row] = std::minmax(v[p], v[q]);
        assembler.declarePair(2 * row, 2 * column);
        assembler.declarePair(2 * row, 2 * column + 1);
      }
    }
    return first;
  }
  /// \param values gives a number for (row, column), row >= column, of x and y in turn.
  template <class Values>
  static void add(
    SymmetricAssembler& assembler, Index first, const Vertices& v, const Values& values)
  {
    Index entry = first;
    for (int p = 0; p < N; ++p)
    {
      assembler.addPair(entry++, values(2 * p, 2 * p), values(2 * p + 1, 2 * p));
      assembler.add(entry++, values(2 * p + 1, 2 * p + 1));
      for (int q = 0; q < p; ++q)
      {
        // Across the diagonal where the vertices stand the other way round.
        const bool turned = v[p] < v[q];
        const double upper = values(2 * p, 2 * q + 1);
        const double lower = values(2 * p + 1, 2 * q);
        assembler.addPair(entry++, values(2 * p, 2 * q), turned ? upper : lower);
        assembler.addPair(entry++, turned ? lower : upper, values(2 * p + 1, 2 * q + 1));
      }
    }
  }
  /// Adds the block's part of a vector to the whole.
  template <class Part>
  static void scatter(const Vertices& v, const Part& part, Eigen::VectorXd& whole)
  {
    for (int p = 0; p < N; ++p)
    {
      whole[2 * v[p]] += part[2 * p];
      whole[2 * v[p] + 1] += part[2 * p + 1];
    }
  }
};

/// A dense block of rows that come after all its columns: a part of a Jacobian in a KKT matrix.
template <int Rows, int Columns>
class JacobianBlock
{
public:
  JacobianBlock() = default;
  /// Declares the entries of some rows from the first on.
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
