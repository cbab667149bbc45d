// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/OverlapFreeWarping.h"

#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"
#include "Quality/IntrinsicDelaunay.h"
#include "Surface/PolygonTriangulation.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{
/// Of Newton's method until the filling is made anew: then it resists.
constexpr int stepsOfRound = 4;
constexpr int mostRounds = 150;
constexpr double leastGain = 1e-3; ///< of the energy, in a round
constexpr int idleRounds = 3;      ///< with less
constexpr int halvings = 8;        ///< of a step that overlaps
/// In mean edges of the boundary: wider openings stay open, since with triangles there it could not
/// bulge out. Where a step overlaps there nevertheless they are filled, up to the widest.
constexpr double leastOpening = 4.0;
constexpr double mostOpening = 1e6;
constexpr double widening = 4.0;
/// Height of a triangle or a pocket of the plane over its longest edge, below which it is left out.
constexpr double slim = 1e-7;
/// What lengths may miss in the model's units where the last round ended.
constexpr double lengthsKeptWithin = 1e-6;

/// The places in a loop of the corners of its convex hull, in the loop's order, by sorted points
/// (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979).
/// \pre the loop is simple, so that it passes the corners in the hull's order
Indices hullCorners(const Indices& loop, const Points2& positions)
{
  Indices sorted(loop.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  const auto at = [&](Index k) -> const Point2& { return positions[loop[k]]; };
  std::sort(sorted.begin(), sorted.end(), [&](Index a, Index b) {
    return std::make_pair(at(a).x(), at(a).y()) < std::make_pair(at(b).x(), at(b).y());
  });
  Indices hull;
  for (const bool lower : { true, false })
  {
    const std::size_t begin = hull.size();
    for (const Index k : sorted)
    {
      while (hull.size() > begin + 1 &&
        cross(at(hull.back()) - at(hull[hull.size() - 2]), at(k) - at(hull.back())) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(k);
    }
    hull.pop_back(); // the other half begins with it
    if (lower)
    {
      std::reverse(sorted.begin(), sorted.end());
    }
  }
  std::sort(hull.begin(), hull.end());
  return hull;
}

/// The polygons between an outer boundary and its convex hull.
std::vector<Indices> pocketsOf(const Indices& loop, const Points2& positions)
{
  std::vector<Indices> pockets;
  const Indices hull = hullCorners(loop, positions);
  const auto count = static_cast<Index>(loop.size());
  for (std::size_t k = 0; k < hull.size() && hull.size() > 2; ++k)
  {
    const Index from = hull[k];
    const Index to = hull[(k + 1) % hull.size()];
    const Index edges = (to - from + count) % count;
    const Point2& start = positions[loop[from]];
    const Point2 chord = positions[loop[to]] - start;
    Indices pocket{ loop[from] };
    double deepest = 0.0;
    for (Index n = edges; n > 0; --n)
    {
      pocket.push_back(loop[(from + n) % count]);
      deepest = std::max(deepest, cross(chord, positions[pocket.back()] - start));
    }
    if (pocket.size() > 2 && deepest > slim * chord.squaredNorm())
    {
      pockets.push_back(std::move(pocket));
    }
  }
  return pockets;
}

/// Triangles of a polygon, with as few slim ones as there can be.
Triangles triangulate(const Indices& polygon, const Points2& positions, double widest)
{
  Points3 corners;
  Indices own;
  for (const Index v : polygon)
  {
    own.push_back(static_cast<Index>(own.size()));
    corners.emplace_back(positions[v].x(), positions[v].y(), 0.0);
  }
  const TriangleMesh ears(corners, triangulatePolygon(corners, own));
  const TriangleMesh mesh(corners, intrinsicDelaunay(ears).triangles);
  // From the hull inwards what lies behind a wide opening is left out.
  std::vector<char> open(static_cast<std::size_t>(mesh.triangleCount()), 0);
  Indices exposed{ mesh.find(0, 1) };
  while (!exposed.empty())
  {
    const Index h = exposed.back();
    exposed.pop_back();
    if (h == none || open[h / 3] || mesh.length(h) <= widest)
    {
      continue;
    }
    open[h / 3] = 1;
    exposed.push_back(mesh.twin(TriangleMesh::next(h)));
    exposed.push_back(mesh.twin(TriangleMesh::previous(h)));
  }
  Triangles triangles;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const double longest =
      std::max({ mesh.length(3 * t), mesh.length(3 * t + 1), mesh.length(3 * t + 2) });
    if (!open[t] && 2.0 * mesh.area(t) > slim * longest * longest)
    {
      triangles.push_back({ polygon[c[0]], polygon[c[1]], polygon[c[2]] });
    }
  }
  return triangles;
}

/// Where the boundary is near to itself, in front of it and in holes.
/// \param opening in mean edges of the boundary, the widest that is filled
BoundaryFilling fillingOf(const TriangleMesh& mesh, const Points2& positions, double opening)
{
  BoundaryFilling filling;
  filling.rest = positions;
  for (const Indices& halfedges : mesh.boundaryLoops())
  {
    Indices loop;
    double area = 0.0;
    double length = 0.0;
    for (const Index h : halfedges)
    {
      loop.push_back(mesh.from(h));
      area += cross(positions[mesh.from(h)], positions[mesh.to(h)]);
      length += (positions[mesh.to(h)] - positions[mesh.from(h)]).norm();
    }
    std::vector<Indices> polygons{ { loop.rbegin(), loop.rend() } };
    double widest = std::numeric_limits<double>::infinity();
    if (area > 0.0)
    {
      polygons = pocketsOf(loop, positions);
      widest = opening * length / static_cast<double>(loop.size());
    }
    for (const Indices& polygon : polygons)
    {
      const Triangles triangles = triangulate(polygon, positions, widest);
      filling.triangles.insert(filling.triangles.end(), triangles.begin(), triangles.end());
    }
  }
  return filling;
}

bool isBijective(const TriangleMesh& mesh, const Points2& positions)
{
  return countFlipped(mesh, positions) == 0 && findBoundaryOverlaps(mesh, positions, 1).empty();
}

/// As far from one map to another as it stays a bijection. \return what share of the way that is
double goTowards(const TriangleMesh& mesh, const Points2& goal, Points2& positions)
{
  double share = 1.0;
  for (int k = 0; k <= halvings; ++k, share /= 2.0)
  {
    Points2 next = positions;
    for (std::size_t v = 0; v < next.size(); ++v)
    {
      next[v] += share * (goal[v] - next[v]);
    }
    if (isBijective(mesh, next))
    {
      positions = std::move(next);
      return share;
    }
  }
  return 0.0;
}
}

IsometricSolution warpWithoutOverlap(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const IsometricOptions& options, const Execution& execution)
{
  const TriangleMesh& mesh = piece.mesh;
  const std::vector<double> rigid(problem.groups.size(), 0.0);
  IsometricOptions round = options;
  round.maximumIterations = stepsOfRound;
  Points2 positions = start;
  double energy = std::numeric_limits<double>::infinity();
  double opening = leastOpening;
  int factorizations = 0;
  int idle = 0;
  for (int k = 0; k < mostRounds && idle < idleRounds; ++k)
  {
    IsometricSolution next = warpIsometrically(
      piece, problem, positions, rigid, round, execution, fillingOf(mesh, positions, opening));
    factorizations += next.factorizations;
    if (next.status.refused())
    {
      return next;
    }
    const double share = goTowards(mesh, next.positions, positions);
    if (share == 0.0 && opening == mostOpening)
    {
      break;
    }
    opening = share < 1.0 ? std::min(widening * opening, mostOpening)
                          : std::max(opening / widening, leastOpening);
    const bool gains = next.distortionEnergy < (1.0 - leastGain) * energy;
    idle = share < 1.0 || gains ? 0 : idle + 1;
    energy = share < 1.0 ? std::numeric_limits<double>::infinity() : next.distortionEnergy;
  }
  // What it is without the filling, where it lies.
  round.maximumIterations = 0;
  IsometricSolution result = warpIsometrically(piece, problem, positions, rigid, round, execution);
  if (result.status.refused())
  {
    return result;
  }
  result.factorizations += factorizations;
  const bool kept = result.history.empty() || result.history.back().constraint < lengthsKeptWithin;
  result.status = kept && isBijective(mesh, result.positions)
    ? Status()
    : Status{ StatusCode::NotConverged,
        "no map was found that keeps the lengths of the curves and does not overlap", {}, {} };
  return result;
}
}
