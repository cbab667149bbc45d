// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/LeastSquaresConformalMap.h"

#include "Sparse/LinearSolver.h"
#include "Surface/TriangleFrame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
AngleStart conformalStart(
  const Piece& piece, const WireNetwork& network, const Execution& execution)
{
  AngleStart start;
  start.theta = network.alpha;
  for (const WireEdge& edge : network.edges)
  {
    start.length.push_back(edge.length);
  }
  const LeastSquaresConformalMap map = leastSquaresConformalMap(piece.mesh, {}, execution);
  if (!map.status.ok())
  {
    return start;
  }
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    start.length[e] = (map.positions[edge.to] - map.positions[edge.from]).norm();
  }
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    const bool tip = network.edge[i] == network.edge[network.previous[i]];
    start.theta[i] = tip ? 2.0 * pi
                         : interiorAngle(map.positions[network.vertex[network.previous[i]]],
                             map.positions[network.vertex[i]], map.positions[network.endVertex(i)]);
  }
  return start;
}

namespace
{
using TripletList = std::vector<Eigen::Triplet<double>>;

/// The conformal energy sum w |beta|^2 as a quadratic form of the free vertices.
class ConformalEnergy
{
public:
  ConformalEnergy(const TriangleMesh& mesh, bool areaNormalized)
    : Mesh(mesh)
  {
    double largest = 0.0;
    this->Frames.reserve(mesh.triangleCount());
    for (const Triangle& c : mesh.triangles())
    {
      this->Frames.emplace_back(mesh.points(), c, 1e-9);
      largest = std::max(largest, this->Frames.back().area);
    }
    // Levy's row of a triangle is 4 A beta, or that divided by sqrt(2 A).
    for (const TriangleFrame& frame : this->Frames)
    {
      const double a = frame.area;
      this->Weights.push_back(areaNormalized ? a : a * (a / largest));
    }
  }

  /// Hessian over the unknowns: x and y of vertex v are unknowns 2 column[v] and 2 column[v] + 1.
  SparseMatrix hessian(const Indices& column, Index unknowns) const
  {
    TripletList entries;
    entries.reserve(static_cast<std::size_t>(this->Mesh.triangleCount()) * 21);
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      const auto& g = this->Frames[t].gradient;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          const Index row = column[this->Mesh.triangle(t)[k]];
          const Index col = column[this->Mesh.triangle(t)[l]];
          if (row == none || col == none || row < col)
          {
            continue;
          }
          // d|beta|^2 along u_l, seen from u_k: conj(c_k) c_l as a 2 x 2 matrix
          const Complex m = this->Weights[t] * std::conj(g[k]) * g[l];
          entries.emplace_back(2 * row, 2 * col, m.real());
          entries.emplace_back(2 * row + 1, 2 * col + 1, m.real());
          entries.emplace_back(2 * row + 1, 2 * col, m.imag());
          if (row != col)
          {
            entries.emplace_back(2 * row, 2 * col + 1, -m.imag());
          }
        }
      }
    }
    SparseMatrix matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  /// Half the negative gradient, through beta of each triangle: this loses half the digits that
  /// hessian times positions would.
  Eigen::VectorXd descent(
    const std::vector<Complex>& positions, const Indices& column, Index unknowns) const
  {
    Eigen::VectorXd down = Eigen::VectorXd::Zero(unknowns);
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      const Triangle& c = this->Mesh.triangle(t);
      const Complex beta = this->Weights[t] *
        this->Frames[t].beta({ positions[c[0]], positions[c[1]], positions[c[2]] });
      for (int k = 0; k < 3; ++k)
      {
        if (column[c[k]] != none)
        {
          const Eigen::Index x = 2 * Eigen::Index(column[c[k]]);
          const Complex part = beta * std::conj(this->Frames[t].gradient[k]);
          down[x] -= part.real();
          down[x + 1] -= part.imag();
        }
      }
    }
    return down;
  }

private:
  const TriangleMesh& Mesh;
  TriangleFrames Frames;
  std::vector<double> Weights;
};

Status checkPins(const TriangleMesh& mesh, const std::array<Index, 2>& pins)
{
  for (Index pin : pins)
  {
    if (pin < 0 || pin >= mesh.vertexCount() || mesh.outgoing(pin) == none)
    {
      return { StatusCode::InvalidOption,
        "pin " + std::to_string(pin) + " is not a vertex of the surface",
        { ElementKind::Points, Indices{ pin } }, { Remedy::NamePins } };
    }
  }
  if (!((mesh.point(pins[0]) - mesh.point(pins[1])).norm() > 0.0))
  {
    return { StatusCode::InvalidOption, "the two pins are the same point",
      { ElementKind::Points, Indices{ pins[0], pins[1] } }, { Remedy::NamePins } };
  }
  return {};
}

/// Unknowns of the map: all vertices but the pins.
struct FreeVertices
{
  Indices column; ///< per vertex; none for pins and vertices that no triangle uses
  Index count = 0;

  FreeVertices(const TriangleMesh& mesh, const std::array<Index, 2>& pins)
    : column(mesh.vertexCount(), none)
  {
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      if (mesh.outgoing(v) != none && v != pins[0] && v != pins[1])
      {
        this->column[v] = this->count++;
      }
    }
  }
};

Indices boundaryHalfedges(const TriangleMesh& mesh)
{
  Indices boundary;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      boundary.push_back(h);
    }
  }
  return boundary;
}

/// The two boundary vertices that are farthest apart, of several pairs the one with the smallest
/// ids. No distance exceeds the sum of both distances from a center, which ends the search early.
std::array<Index, 2> farthestPins(const TriangleMesh& mesh, const Indices& boundary)
{
  constexpr double tie = 1e-12;
  Point3 center = Point3::Zero();
  for (const Index h : boundary)
  {
    center += mesh.point(mesh.from(h)) / static_cast<double>(boundary.size());
  }
  std::vector<std::pair<double, Index>> vertices;
  for (const Index h : boundary)
  {
    vertices.emplace_back(-(mesh.point(mesh.from(h)) - center).norm(), mesh.from(h));
  }
  std::sort(vertices.begin(), vertices.end());
  double most = 0.0;
  std::array<Index, 2> pins{ none, none };
  const auto mayBeFarthest = [&most](double a, double b) { return -a - b >= most * (1.0 - tie); };
  for (auto a = vertices.begin();
       a != vertices.end() && mayBeFarthest(a->first, vertices.front().first); ++a)
  {
    for (auto b = vertices.begin(); b != a && mayBeFarthest(a->first, b->first); ++b)
    {
      const auto [low, high] = std::minmax(a->second, b->second);
      const std::array<Index, 2> pair{ low, high };
      const double distance = (mesh.point(low) - mesh.point(high)).norm();
      if (low != high &&
        (distance > most * (1.0 + tie) || (distance >= most * (1.0 - tie) && pair < pins)))
      {
        most = std::max(most, distance);
        pins = pair;
      }
    }
  }
  return pins;
}

/// Moves the free vertices to the least energy. False where that fails or is cancelled.
bool minimizeConformalEnergy(const TriangleMesh& mesh, const ConformalEnergy& energy,
  const FreeVertices& free, const Execution& execution, std::vector<Complex>& positions)
{
  // The first pass solves, the others refine: normal equations square the condition number, but
  // their residual does not where it is computed row by row.
  constexpr int passes = 3;
  const Index unknowns = 2 * free.count;
  LinearSolver solver(dissect(mesh.triangles(), mesh.points()).ofUnknowns(2, [&free](Index v) {
    return free.column[v] == none ? none : 2 * free.column[v];
  }));
  const SparseMatrix hessian = energy.hessian(free.column, unknowns);
  if (execution.cancelled() || !solver.analyze(hessian) || execution.cancelled() ||
    !solver.factorize(hessian, execution))
  {
    return false;
  }
  for (int pass = 0; pass < passes; ++pass)
  {
    if (execution.cancelled())
    {
      return false;
    }
    const Eigen::VectorXd step =
      solver.solve(energy.descent(positions, free.column, unknowns), execution);
    if (step.rows() != unknowns)
    {
      return false;
    }
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      if (free.column[v] != none)
      {
        const Eigen::Index x = 2 * Eigen::Index(free.column[v]);
        positions[v] += Complex(step[x], step[x + 1]);
      }
    }
  }
  return true;
}

/// What makes the perimeter that of the surface.
double perimeterScale(
  const TriangleMesh& mesh, const Indices& boundary, const std::vector<Complex>& positions)
{
  double perimeter = 0.0;
  double flat = 0.0;
  for (Index h : boundary)
  {
    perimeter += mesh.length(h);
    flat += std::abs(positions[mesh.to(h)] - positions[mesh.from(h)]);
  }
  return perimeter / flat;
}
}

LeastSquaresConformalMap leastSquaresConformalMap(
  const TriangleMesh& mesh, const LeastSquaresConformalOptions& options, const Execution& execution)
{
  LeastSquaresConformalMap map;
  const Indices boundary = boundaryHalfedges(mesh);
  if (boundary.empty())
  {
    map.status = { mesh.triangleCount() == 0 ? StatusCode::EmptySurface : StatusCode::ClosedSurface,
      "the surface has no boundary", {}, { Remedy::CutOpen } };
    return map;
  }
  const bool chosen = options.pins[0] != none || options.pins[1] != none;
  const std::array<Index, 2> pins = chosen ? options.pins : farthestPins(mesh, boundary);
  map.status = checkPins(mesh, pins);
  if (!map.status.ok())
  {
    return map;
  }
  std::vector<Complex> positions(mesh.vertexCount());
  positions[pins[1]] = (mesh.point(pins[1]) - mesh.point(pins[0])).norm();
  const ConformalEnergy energy(mesh, options.areaNormalized);
  const bool solved =
    minimizeConformalEnergy(mesh, energy, FreeVertices(mesh, pins), execution, positions);
  if (!solved && execution.cancelled())
  {
    map.status = { StatusCode::Cancelled, "cancelled while mapping conformally", {} };
    return map;
  }
  const double scale = solved ? perimeterScale(mesh, boundary, positions) : HUGE_VAL;
  if (!std::isfinite(scale))
  {
    map.status = { StatusCode::NumericalFailure,
      "the conformal map could not be computed; slivers and parts that hang on one vertex are in "
      "its way",
      {}, { Remedy::MendSlivers } };
    return map;
  }
  map.positions.reserve(positions.size());
  for (const Complex& p : positions)
  {
    map.positions.emplace_back(scale * p.real(), scale * p.imag());
  }
  return map;
}
}
