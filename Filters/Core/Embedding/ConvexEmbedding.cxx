// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/ConvexEmbedding.h"

#include "Base/Types.h"
#include "Sparse/LinearSolver.h"
#include "Surface/TriangleFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Weights of edges within these bounds, in cotangents: below, between obtuse angles, triangles
/// would collapse; above, beside slivers, digits are lost.
constexpr double smallestWeight = 0.05;
constexpr double largestWeight = 20.0;
/// Of flat over true area, least over largest: along a tube it falls as an exponential, and lengths
/// are found late, or not at all, from where little is left of triangles.
constexpr double smallestRatio = 1e-3;
/// In pockets of the boundary weights go too far: below this triangles fold by rounding (from 1e-12
/// on, on two of nine trees of cuts). Of maps above it a later one is the better start.
constexpr double safeRatio = 1e-10;
/// Flat triangles smaller than this share of their own area count as so large: positions are known
/// to fewer digits, and weights stay numbers after all reweightings.
constexpr double minShare = 1e-20;
constexpr int maxReweightings = 8;

struct WeightedEdge
{
  Index from;
  Index to;
  double weight;
};

std::vector<WeightedEdge> cotangentEdges(const TriangleMesh& mesh)
{
  std::vector<double> cotangents(mesh.halfedgeCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const TriangleFrame frame(mesh.points(), mesh.triangle(t));
    for (int k = 0; k < 3; ++k)
    {
      cotangents[3 * t + k] =
        -4.0 * frame.area * (frame.gradient[k] * std::conj(frame.gradient[(k + 1) % 3])).real();
    }
  }
  std::vector<WeightedEdge> edges;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index twin = mesh.twin(h);
    if (twin == none || h < twin)
    {
      const double sum = cotangents[h] + (twin == none ? 0.0 : cotangents[twin]);
      edges.push_back({ mesh.from(h), mesh.to(h), std::clamp(sum, smallestWeight, largestWeight) });
    }
  }
  return edges;
}

/// On a circle of the loop's length, anti-clockwise.
void placeOnCircle(const TriangleMesh& mesh, const Indices& loop, Points2& positions)
{
  double perimeter = 0.0;
  for (Index h : loop)
  {
    perimeter += mesh.length(h);
  }
  double along = 0.0;
  for (Index h : loop)
  {
    const double angle = 2.0 * pi * along / perimeter;
    positions[mesh.from(h)] = perimeter / (2.0 * pi) * Point2(std::cos(angle), std::sin(angle));
    along += mesh.length(h);
  }
}

/// Weights by which triangles far from the boundary are larger: each edge's over the roots of how
/// much too small the triangles at both of its ends are (after S. Yoshizawa, A. Belyaev, H.-P.
/// Seidel, "A fast and simple stretch-minimizing mesh parameterization", Shape Modeling
/// International 2004). \return flat over true area, least over largest
double reweigh(const TriangleMesh& mesh, const std::vector<Indices>& loops,
  const Points2& positions, std::vector<WeightedEdge>& edges)
{
  std::vector<double> area(positions.size(), 0.0);
  std::vector<double> flat(positions.size(), 0.0);
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const double there = mesh.area(t);
    const double here = std::max(minShare * there, 0.5 * cross(positions, c));
    least = std::min(least, here / there);
    most = std::max(most, here / there);
    for (Index v : c)
    {
      area[v] += there;
      flat[v] += here;
    }
  }
  for (std::size_t k = 1; k < loops.size(); ++k)
  {
    const std::size_t middle = positions.size() - loops.size() + k;
    for (Index h : loops[k])
    {
      area[middle] += area[mesh.from(h)];
      flat[middle] += flat[mesh.from(h)];
    }
  }
  for (WeightedEdge& edge : edges)
  {
    edge.weight /=
      std::sqrt(area[edge.from] / flat[edge.from]) * std::sqrt(area[edge.to] / flat[edge.to]);
  }
  return least / most;
}

bool placeInside(const std::vector<WeightedEdge>& edges, const std::vector<char>& fixed,
  Points2& positions, const Execution& execution)
{
  Indices row(positions.size(), none);
  Index rows = 0;
  for (std::size_t v = 0; v < row.size(); ++v)
  {
    row[v] = fixed[v] ? none : rows++;
  }
  if (rows == 0)
  {
    return true;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(rows, 2);
  const auto pull = [&](Index at, Index other, double weight) {
    if (row[at] == none)
    {
      return;
    }
    entries.emplace_back(row[at], row[at], weight);
    if (row[other] == none)
    {
      rhs.row(row[at]) += weight * positions[other].transpose();
    }
    else if (row[other] < row[at])
    {
      entries.emplace_back(row[at], row[other], -weight);
    }
  };
  for (const WeightedEdge& edge : edges)
  {
    pull(edge.from, edge.to, edge.weight);
    pull(edge.to, edge.from, edge.weight);
  }
  SparseMatrix matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  LinearSolver solver;
  if (!solver.factorize(matrix, execution) || solver.positive() != rows)
  {
    return false;
  }
  const Eigen::MatrixXd inside = solver.solve(rhs);
  if (inside.rows() != rows)
  {
    return false;
  }
  for (std::size_t v = 0; v < row.size(); ++v)
  {
    if (row[v] != none)
    {
      positions[v] = inside.row(row[v]).transpose();
    }
  }
  return true;
}
}

Points2 embedConvexly(const TriangleMesh& mesh, const Execution& execution)
{
  const std::vector<Indices> loops = mesh.boundaryLoops();
  if (loops.empty() || execution.cancelled())
  {
    return {};
  }
  const auto vertices = static_cast<std::size_t>(mesh.vertexCount());
  Points2 positions(vertices + loops.size() - 1, Point2::Zero());
  std::vector<char> fixed(positions.size(), 0);
  std::vector<WeightedEdge> edges = cotangentEdges(mesh);
  placeOnCircle(mesh, loops.front(), positions);
  for (Index h : loops.front())
  {
    fixed[mesh.from(h)] = 1;
  }
  for (std::size_t k = 1; k < loops.size(); ++k)
  {
    for (Index h : loops[k])
    {
      edges.push_back({ mesh.from(h), static_cast<Index>(vertices + k - 1), 1.0 });
    }
  }
  Points2 kept;
  double ratio = 0.0;
  for (int k = 0; k <= maxReweightings && ratio <= smallestRatio; ++k)
  {
    if (!placeInside(edges, fixed, positions, execution))
    {
      return {};
    }
    const double reached = reweigh(mesh, loops, positions, edges);
    if (reached > std::min(ratio, safeRatio))
    {
      ratio = reached;
      kept = positions;
    }
  }
  kept.resize(kept.empty() ? 0 : vertices);
  return kept;
}
}
