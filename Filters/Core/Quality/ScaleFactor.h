// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/LinearSolver.h"
#include "Surface/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{
/// What a cut would do, without flattening anything.
struct CutForecast
{
  /// Drop of ScaleFactor::energy(); negative where it would rise.
  double gain = 0.0;
  /// Curvature, in radians, that the cut takes up, point by point of the path; their arc lengths
  /// from the path's first vertex. Vertices that are fixed already take up none and are left out.
  std::vector<double> swallowed;
  std::vector<double> arc;

  /// Width at arc length s of a dart whose mouth is the path's first vertex: each point further in
  /// opens the dart by its curvature times its distance. Negative: the sides overlap there.
  double opening(double s) const;
  /// The least opening at the points of the path and its first vertex, and the greatest.
  double leastOpening() const;
  double greatestOpening() const;
};

struct ScaleFactorOptions
{
  /// How much distortion matters, by vertex; empty: everywhere alike.
  std::vector<double> weight;
  /// Vertices beside those of the boundary where lengths are kept.
  Indices fixed;
  /// Up to this number free vertices count by themselves; of more only means over as many clusters
  /// are known. 0: what a cut would do is not asked for.
  Index maxSites = 600;
};

/// How much larger than flat cloth a surface is, by Yamabe's equation: the surface is scaled by
/// exp(-u) to be flat where
///
///     L u = K  inside,    u = 0  on the boundary,
///
/// L the cotangent Laplacian (of the intrinsic Delaunay triangulation), K the angle defects (B.
/// Springborn, P. Schroeder, U. Pinkall, "Conformal equivalence of triangle meshes", ACM
/// Transactions on Graphics 27(3), 2008, to first order). u > 0: flat cloth with the boundary's
/// exact lengths is too small there. The energy is int w u^2, w the weight.
///
/// A cut along a path g makes its sides wires of exact length: to first order it adds the condition
/// u_g = 0. With G = L^-1 and E_g the path's columns of the identity, the multipliers of that
/// condition are
///
///     q = (E_g^T G E_g)^-1 u_g,    the new factor is  v = u - G E_g q,
///
/// and since L v = K - E_g q, q is the curvature that the cut takes up: what the path's corners may
/// open. Gain and opening follow by sums. G is computed once, so a path of p points costs p^3 / 3
/// for q and p multiplications a vertex.
///
/// Surfaces with more vertices than `maxSites` are looked at through clusters: columns of E are
/// then means over clusters instead of single vertices, G is E^T L^-1 E with the L of all vertices,
/// and a path makes the means over the clusters that it runs through zero.
class ScaleFactor
{
public:
  ScaleFactor(
    const TriangleMesh& mesh, const ScaleFactorOptions& options, const Execution& execution);

  /// False where there is nothing to fix the scale (a closed surface), the system cannot be solved,
  /// or the run was cancelled.
  bool ok() const { return this->Ok; }
  /// u by vertex.
  const std::vector<double>& values() const { return this->Values; }
  /// Of some vertices those where |u| is largest, apart from each other.
  Indices peaks(Indices vertices, double apart, std::size_t most) const;
  /// int w u^2, by the means over clusters.
  double energy() const { return this->Energy; }
  /// What a cut along a path of vertices, each joined to the next by an edge, would do.
  CutForecast forecast(const Indices& path) const;
  /// The same of a cut that ends inside at both ends: there its sides, whose lengths are the same,
  /// have to meet. What it takes up is then the nearest q, by the energy of its u, with
  ///
  ///     sum q_i = 0  (the sides turn alike),    sum q_i s_i = 0  (they end in one point).
  CutForecast forecastInside(const Indices& path) const;

private:
  bool solve(const TriangleMesh& mesh, const std::vector<double>& areas,
    const ScaleFactorOptions& options, const Execution& execution);
  bool solveBetweenSites(
    const LinearSolver& solver, const SparseMatrix& means, const Execution& execution);
  CutForecast forecast(const Indices& path, bool inside) const;
  void integrate(const std::vector<double>& areas, const std::vector<double>& weight);

  Points3 Points;
  Indices SiteOfVertex;      ///< none: u = 0
  Eigen::VectorXd SiteArea;  ///< of the surface, times the weight
  Eigen::VectorXd SiteValue; ///< mean of u
  Eigen::MatrixXd Green;     ///< G between sites
  std::vector<double> Values;
  double Energy = 0.0;
  bool Ok = false;
};

/// Shares vertices among at most this many seeds that lie far from each other: each next seed is
/// the vertex farthest, along edges, from those before, and a vertex goes to the nearest seed.
/// Every vertex is a cluster of its own where there are no more.
/// \param members vertices to share, ascending; paths run through them alone.
/// \return per vertex its cluster, none for others than members
Indices clusterVertices(const TriangleMesh& mesh, const Indices& members, Index most);
}
