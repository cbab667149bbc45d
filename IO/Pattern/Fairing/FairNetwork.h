// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/FairSpan.h"

#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

namespace flattening::pattern
{
/// Cubic B-splines over ascending breaks, continuously differentiable at those within, which are
/// double knots, with as many knots at both ends as make the curve end in its first and last
/// coefficient. After L. Piegl, W. Tiller, The NURBS Book, 2nd ed., Springer 1997, algorithms A2.1
/// and A2.3.
class CubicBasis
{
public:
  explicit CubicBasis(const std::vector<double>& breaks);

  std::size_t size() const { return this->Knots.size() - 4; }
  const std::vector<double>& breaks() const { return this->Breaks; }

  /// The four functions that are not zero at a place, the first of them being number `first`.
  struct Values
  {
    std::size_t first = 0;
    std::array<double, 4> value{};
    std::array<double, 4> slope{};
    std::array<double, 4> bend{}; ///< second derivative
  };
  Values at(double t) const;
  /// The same at a place of a span, its ends included.
  Values at(std::size_t span, double t) const;

private:
  std::vector<double> Breaks;
  std::vector<double> Knots;
};

/// A part of a stretch whose length is prescribed: from notch to notch, say.
struct FairInterval
{
  double end = 0.0;     ///< along the stretch
  double length = 0.0;  ///< that it must have
  bool follows = false; ///< it has that if others have theirs, whose mirror image it is
};

/// A node that a stretch runs through.
struct FairHook
{
  double at = 0.0; ///< along the stretch
  std::size_t node = 0;
};

/// What is to be drawn as one smooth curve, between two nodes or, closed, from a node to itself.
struct FairStretch
{
  std::size_t from = 0;
  std::size_t to = 0;
  bool smoothEnds = false; ///< from == to, and the curve is smooth there
  bool straight = false;   ///< a segment; its intervals divide it by their lengths
  std::vector<double> arc; ///< along the stretch, ascending from 0, of the points within its ends
  Points2 points;          ///< where it ran before
  std::vector<double> weights; ///< of the points, 1 for what is usual
  std::array<double, 2> endWeights{ 1.0, 1.0 };
  std::vector<double> breaks; ///< along it, between which it is one cubic curve, its ends included
  std::vector<FairInterval> intervals; ///< the last one ends where the stretch does
  std::vector<FairHook> hooks;

  double length() const { return this->intervals.back().end; }
};

/// Two stretches whose curves are to be mirror images of each other, so that one runs the other
/// way; or one, twice, that is to be its own.
struct FairImages
{
  std::size_t one = 0;
  std::size_t other = 0;
};

/// An axis and stretches that are mirrored at it.
struct FairMirror
{
  Point2 at = Point2::Zero();
  Point2 along = Point2(0.0, 1.0);   ///< of length 1
  std::vector<FairImages> stretches; ///< with breaks that are mirrored as well
};

/// The borders and feature curves of a flat piece that hang together at nodes.
struct FairNetwork
{
  Points2 nodes;     ///< where they were before
  bool held = false; ///< they stay there
  std::vector<FairStretch> stretches;
  FairMirror mirror;
  double* work = nullptr; ///< products that may still be computed; null: no limit
};

/// A linear combination of unknown points.
struct Term
{
  Eigen::Index unknown = 0;
  double factor = 0.0;
};
using Terms = std::vector<Term>;

Point2 sum(const Terms& terms, const Eigen::VectorXd& x);

enum class Derivative
{
  Place,
  Slope,
  Bend,
};

/// A stretch as a curve of unknown points: its nodes, and the coefficients between them.
class StretchCurve
{
public:
  /// The stretch stays the caller's.
  /// \param next the first unknown that is free; those taken are counted
  StretchCurve(const FairStretch& stretch, Eigen::Index& next);

  const FairStretch& stretch() const { return this->Stretch; }
  const CubicBasis& basis() const { return this->Basis; }
  /// The unknown points that it depends on, from its first node to its last.
  std::vector<Eigen::Index> unknowns() const;
  Terms at(double t, Derivative derivative) const;
  std::vector<FairSpan> spans(const Eigen::VectorXd& x) const;
  /// Of the points across the curve, along which they may slide, between those of its ends.
  std::vector<double> deviation(
    const Points2& nodes, const Eigen::VectorXd& x, std::vector<double>& nearest) const;

private:
  const FairStretch& Stretch;
  CubicBasis Basis;
  Eigen::Index First = 0;
};

/// The condition that a part of a curve has a length, with its derivatives by the unknowns.
class CurveLength
{
public:
  using Entries = std::vector<Eigen::Triplet<double>>;

  /// \param from along the stretch \param to where the part ends \param wanted its length
  CurveLength(const StretchCurve& curve, double from, double to, double wanted);

  double wanted() const { return this->Wanted; }
  /// Adds its derivative as a row. \return what is missing to the length
  double addRow(Eigen::Index row, const Eigen::VectorXd& x, Entries& entries) const;
  /// Adds its second derivative, times a tension. Entries are the same whatever that is.
  void addTension(double tension, const Eigen::VectorXd& x, Entries& entries) const;

private:
  /// What lies in one span of the curve, so that all its places have the same unknowns.
  struct Part
  {
    Terms unknowns;                             ///< of the first place
    std::vector<std::array<double, 4>> factors; ///< of the slopes at the places of its integral
    std::vector<double> weights;

    Point2 slope(std::size_t place, const Eigen::VectorXd& x) const;
  };

  double Wanted;
  std::vector<Part> Parts;
};

/// Linear conditions of unknown points: a row for each coordinate.
class LinearRows
{
public:
  /// Points stay, of which these are the first unknowns.
  void addHeld(const Points2& points);
  /// Stretches end in the nodes that they are hooked to, and rings are smooth where they close.
  void addHooksAndRings(const std::vector<StretchCurve>& curves);
  /// Curves are mirror images of each other; nodes that stay are so already.
  /// \param curves of all stretches of the network
  void addMirror(const FairNetwork& network, const std::vector<StretchCurve>& curves);

  Eigen::Index size() const { return static_cast<Eigen::Index>(this->Rows.size()); }
  /// Adds all rows from the row 0 on. \param missing what is missing to them
  void add(const Eigen::VectorXd& x, std::vector<Eigen::Triplet<double>>& entries,
    Eigen::VectorXd& missing) const;

private:
  struct Row
  {
    std::vector<std::pair<Eigen::Index, double>> factors; ///< of coordinates
    double value = 0.0;
  };

  void addPoint(const Terms& terms, const Point2& value);

  std::vector<Row> Rows;
};
}
