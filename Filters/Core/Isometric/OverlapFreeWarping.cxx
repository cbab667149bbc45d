// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/OverlapFreeWarping.h"

#include "Base/Orientation.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"
#include "Quality/IntrinsicDelaunay.h"
#include "Surface/PolygonTriangulation.h"
#include "Surface/TriangleFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// Of Newton's method until the filling is made anew: then it resists.
constexpr int stepsOfRound = 4;
constexpr int maxRounds = 150;
constexpr double minGain = 1e-3; ///< of the energy, in a round
constexpr int idleRounds = 2;    ///< with less
/// The symmetric Dirichlet energy, over its area, of what a triangle is deformed by at once. Parts
/// of a convex map can be 1e9 times smaller than on the surface: a matrix that holds both is
/// singular to rounding. Of 7, 10, 18 and 40, 10 took the least work on trees of one statue.
constexpr double mostDeformed = 10.0;
/// No more than which Newton's method gets along with.
constexpr double littleDeformed = 100.0;
/// Where shapes between leave out no less than this share of what they did, in this number of
/// rounds, or nothing is gained in one, they lead no further.
constexpr double leadsOn = 0.9;
constexpr int leadingRounds = 6;
constexpr int shapeHalvings = 20;
constexpr int halvings = 8; ///< of a step that overlaps
/// In mean edges of the boundary: wider openings stay open, since with triangles there it could not
/// bulge out. Where a step overlaps there nevertheless they are filled, up to the widest.
constexpr double minOpening = 4.0;
constexpr double maxOpening = 1e6;
constexpr double widening = 4.0;
/// Height of a triangle or a pocket of the plane over its longest edge, below which it is left out.
constexpr double slim = 1e-7;
/// Where a strain is enough: in this number of rounds that on 95 % of the area has to come nearer
/// to it by this share, or the piece is given up: in trials of one tree that came to rest above it
/// the last ten of 30 rounds brought less.
constexpr std::size_t nearingRounds = 4;
constexpr double nearingShare = 0.1;
/// Of the energy, the change in a round below which a strain is judged: before, most of it may be
/// near a seam that has just been sewn, on less than a twentieth of the area. Where it comes no
/// nearer it is judged sooner.
constexpr double rest = 1e-2;
constexpr double nearRest = 0.1;
/// What lengths may miss in the model's units where the last round ended.
constexpr double lengthsKeptWithin = 1e-6;

/// The polygons between an outer boundary and its convex hull.
/// \pre it does not cross itself, so that it passes the corners of the hull in the hull's order
std::vector<Indices> pocketsOf(const Indices& loop, const Points2& positions)
{
  std::vector<Indices> pockets;
  Points2 places;
  for (const Index v : loop)
  {
    places.push_back(positions[v]);
  }
  Indices hull = convexHull(places);
  std::sort(hull.begin(), hull.end());
  const auto count = static_cast<Index>(loop.size());
  for (std::size_t k = 0; k < hull.size() && hull.size() > 2; ++k)
  {
    const Index from = hull[k];
    const Index to = hull[(k + 1) % hull.size()];
    const Index edges = (to - from + count) % count;
    const Point2& start = places[from];
    const Point2 chord = places[to] - start;
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

/// Shapes of triangles between those on the surface and those in a map (Liu, Ye, Ni and Fu,
/// Progressive Parameterizations, 2018), as sides from their first corners. Empty where the map
/// deforms none by much.
/// \param left is set to the sum of the shares of their strains that are left out
std::vector<std::array<Point2, 2>> shapesBetween(
  const TriangleMesh& mesh, const Points2& positions, double& left)
{
  constexpr double least = 1e-150; // so that no energy density overflows
  std::vector<std::array<Point2, 2>> shapes;
  left = 0.0;
  double worst = 0.0;
  for (const Triangle& c : mesh.triangles())
  {
    std::array<Complex, 3> corner;
    for (int k = 0; k < 3; ++k)
    {
      corner[k] = Complex(positions[c[k]].x(), positions[c[k]].y());
    }
    const TriangleFrame frame(mesh.points(), c);
    const Complex alpha = frame.alpha(corner);
    const Complex beta = frame.beta(corner);
    const double large = std::max(std::abs(alpha) + std::abs(beta), least);
    const double small = std::max(std::abs(alpha) - std::abs(beta),
      std::max(least, std::numeric_limits<double>::epsilon() * large));
    const Point2 strain(std::log(large), std::log(small));
    const auto density = [&strain](double share) {
      return 2.0 * (std::cosh(2.0 * share * strain.x()) + std::cosh(2.0 * share * strain.y()));
    };
    worst = std::max(worst, density(1.0));
    double share = 1.0;
    double kept = density(1.0) > mostDeformed ? 0.0 : 1.0;
    for (int k = 0; kept < 1.0 && k < shapeHalvings; ++k)
    {
      const double middle = 0.5 * (kept + share);
      (density(middle) > mostDeformed ? share : kept) = middle;
    }
    left += 1.0 - kept;
    // The sides along the principal directions in the map, with this share of the strain taken out.
    const Complex turn = std::polar(1.0, -0.5 * (std::arg(alpha) + std::arg(beta)));
    const auto side = [&](int k) {
      const Complex e = turn * (corner[k] - corner[0]);
      return Point2(
        e.real() * std::exp(-kept * strain.x()), e.imag() * std::exp(-kept * strain.y()));
    };
    shapes.push_back({ side(1), side(2) });
  }
  return worst > littleDeformed ? shapes : std::vector<std::array<Point2, 2>>();
}

bool isBijective(const TriangleMesh& mesh, const Points2& positions)
{
  return countFlipped(mesh, positions) == 0 && findBoundaryOverlaps(mesh, positions, 1).empty();
}

/// A map, and the stretch of elastic curves in it.
struct FlatMap
{
  Points2 positions;
  std::vector<double> stretch;
};

/// As far from one map to another as it stays a bijection. \return what share of the way that is
double goTowards(const TriangleMesh& mesh, const IsometricSolution& goal, FlatMap& map)
{
  double share = 1.0;
  for (int k = 0; k <= halvings; ++k, share /= 2.0)
  {
    Points2 next = map.positions;
    for (std::size_t v = 0; v < next.size(); ++v)
    {
      next[v] += share * (goal.positions[v] - next[v]);
    }
    if (isBijective(mesh, next))
    {
      map.positions = std::move(next);
      for (std::size_t g = 0; g < map.stretch.size(); ++g)
      {
        map.stretch[g] += share * (goal.stretch[g] - map.stretch[g]);
      }
      return share;
    }
  }
  return 0.0;
}
}

IsometricSolution warpWithoutOverlap(const Piece& piece, const AngleProblem& problem,
  const Points2& start, double enough, const IsometricOptions& options, const Execution& execution)
{
  const TriangleMesh& mesh = piece.mesh;
  IsometricOptions round = options;
  round.inRounds = true;
  FlatMap map{ start, std::vector<double>(problem.groups.size(), 0.0) };
  double energy = std::numeric_limits<double>::infinity();
  double least = energy; // that shapes between have left out, and the rounds since
  int leading = 0;
  double opening = minOpening;
  int steps = stepsOfRound;
  int factorizations = 0;
  int idle = 0;
  bool stuck = false;
  std::vector<double> strains; // by round, where one is enough
  const SurfaceMeasures surface =
    enough > 0.0 ? measureSurface(mesh, execution) : SurfaceMeasures();
  for (int k = 0; k < maxRounds && idle < idleRounds; ++k)
  {
    round.maximumIterations = steps;
    BoundaryFilling filling = fillingOf(mesh, map.positions, opening);
    if (leading < leadingRounds)
    {
      double left = 0.0;
      filling.shapes = shapesBetween(mesh, map.positions, left);
      leading = left < leadsOn * least ? 0 : leading + 1;
      least = leading == 0 ? left : least;
    }
    const bool between = !filling.shapes.empty();
    IsometricSolution next =
      warpIsometrically(piece, problem, map.positions, map.stretch, round, execution, filling);
    factorizations += next.factorizations;
    if (next.status.refused())
    {
      return next;
    }
    const double share = goTowards(mesh, next, map);
    stuck = share == 0.0 && opening == maxOpening && steps == 1;
    if (stuck)
    {
      break;
    }
    // Between the ends of several steps triangles may turn over, of one they do not.
    steps = share < 1.0 ? 1 : std::min(2 * steps, stepsOfRound);
    opening = share < 1.0 ? std::min(widening * opening, maxOpening)
                          : std::max(opening / widening, minOpening);
    const bool gains = next.distortionEnergy < (1.0 - minGain) * energy;
    const double before = energy;
    idle = share < 1.0 || gains || between ? 0 : idle + 1;
    leading = between && share == 1.0 && !gains ? leadingRounds : leading;
    energy = share < 1.0 ? std::numeric_limits<double>::infinity() : next.distortionEnergy;
    if (enough > 0.0)
    {
      const auto rests = [&](double change) {
        return std::isfinite(before) && std::isfinite(energy) &&
          std::abs(energy - before) <= change * before;
      };
      strains.push_back(
        measureFlattening(mesh, surface, map.positions, {}, execution).summary.strainP95);
      const double excess = strains.back() - enough;
      if ((excess <= 0.0 && rests(rest)) ||
        (strains.size() > nearingRounds && rests(nearRest) &&
          strains[strains.size() - 1 - nearingRounds] - strains.back() < nearingShare * excess))
      {
        break;
      }
    }
  }
  // What it is without the filling, where it lies.
  round.inRounds = false;
  round.maximumIterations = 0;
  IsometricSolution result =
    warpIsometrically(piece, problem, map.positions, map.stretch, round, execution);
  if (result.status.refused())
  {
    return result;
  }
  result.factorizations += factorizations;
  const bool kept = result.history.empty() || result.history.back().constraint < lengthsKeptWithin;
  result.status = {};
  if (!kept || !isBijective(mesh, result.positions))
  {
    result.status = { StatusCode::NotConverged,
      "no map was found that keeps the lengths of the curves and does not overlap", {}, {} };
  }
  else if (stuck)
  {
    result.status = { StatusCode::NotConverged,
      "the free boundary stopped short of a minimum, where every further step would overlap", {},
      {} };
  }
  return result;
}
}
