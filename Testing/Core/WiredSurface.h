// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Reference/SequentialAngleSolver.h"
#include "TestMeshes.h"
#include "Wires/KeyCurveLocks.h"

#include <complex>

namespace testmeshes
{
/// The stages up to the wire network of a surface whose cuts leave it in one piece. Angle problems
/// refer to it, so it must outlive them.
struct WiredSurface
{
  std::vector<FeatureCurve> curves;
  CutSurface cut;
  Piece piece;
  WireNetwork network;

  WiredSurface(const TriangleMesh& mesh, std::vector<FeatureCurve> featureCurves)
    : curves(std::move(featureCurves))
    , cut(cutSurface(mesh, curves))
    , piece(extractPieces(cut).front())
    , network(buildWireNetwork(piece))
  {
  }
  explicit WiredSurface(const Surface& surface)
    : WiredSurface(surface.mesh, surface.curves)
  {
  }

  NodeLocks locks() const
  {
    return lockKeyCurves(this->network, this->piece, this->cut, this->curves);
  }
  AngleProblem problem() const { return makeAngleProblem(this->network, this->locks()); }
  AngleSolution solve(AngleMethod method = AngleMethod::Newton) const
  {
    AngleSolverOptions options;
    options.method = method;
    return solveAngles(this->problem(), options, {});
  }
  /// The piece's first copy of a vertex of the surface before the cut.
  Index vertex(Index originalVertex) const
  {
    Index v = 0;
    while (this->original(v) != originalVertex)
    {
      ++v;
    }
    return v;
  }
  /// The nodes at the first copy of a vertex of the surface before the cut.
  Indices nodes(Index originalVertex) const
  {
    const Index host = this->network.hostOfVertex[this->vertex(originalVertex)];
    return { this->network.vertexNodes.begin() + this->network.vertexNodeBegin[host],
      this->network.vertexNodes.begin() + this->network.vertexNodeBegin[host + 1] };
  }
  /// The vertex of the surface before the cut.
  Index original(Index pieceVertex) const
  {
    return this->cut.originalVertex[this->piece.vertices[pieceVertex]];
  }
};

/// Largest distance between corresponding points after the rotation and translation, without
/// reflection, that bring the first set nearest to the second.
inline double rigidDistance(const Points2& first, const Points2& second)
{
  using Complex = std::complex<double>;
  Point2 centerA = Point2::Zero();
  Point2 centerB = Point2::Zero();
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    centerA += first[i] / static_cast<double>(first.size());
    centerB += second[i] / static_cast<double>(first.size());
  }
  auto toComplex = [](const Point2& p) { return Complex(p.x(), p.y()); };
  Complex turn(0.0, 0.0);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    turn += toComplex(second[i] - centerB) * std::conj(toComplex(first[i] - centerA));
  }
  turn /= std::abs(turn);
  double worst = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    worst = std::max(
      worst, std::abs(turn * toComplex(first[i] - centerA) - toComplex(second[i] - centerB)));
  }
  return worst;
}

inline double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double worst = a.size() == b.size() ? 0.0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    worst = std::max(worst, std::abs(a[i] - b[i]));
  }
  return worst;
}

/// The quarter-sphere with both arcs of Fig. 14: the one half-way between the poles and the middle
/// meridian.
inline Surface quarterSphereWithTwoArcs()
{
  Surface surface = quarterSphere();
  surface.curves.push_back(accessory("meridian", { 0, 3, 8, 13, 18, 23, 28, 33, 36 }));
  return surface;
}
}
