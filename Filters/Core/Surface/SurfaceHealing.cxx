// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceHealing.h"

#include "Base/CompressedRows.h"
#include "Base/Memory.h"
#include "Surface/SheetSeparation.h"
#include "Surface/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace flattening
{
namespace
{
/// Of the mean edge at one of its ends: an edge that is none.
constexpr double collapsedEdge = 1e-6;
/// Of the largest part's area: parts that are left out, and parts, or single triangles, that are
/// fins of others.
constexpr double speckArea = 1e-3;
constexpr double finArea = 1e-2;
constexpr double singleFinArea = 1e-1;
/// How much two triangles may bend at a crowded edge that go on with each other, and by how much
/// more all others have to that share one with them.
constexpr double largestBend = 60.0 * degree;
constexpr double clearBend = 30.0 * degree;
constexpr int maxRounds = 64;

/// The surface while it is mended: triangles over the input's points, and over those behind them,
/// which are copies.
struct Draft
{
  Points3 points;
  Indices source; ///< per point that of the input
  Triangles triangles;
  Indices origin; ///< per triangle that of the input
};

/// Takes out the triangles for which a predicate of their place holds. \return their origins
template <typename Predicate>
Indices takeOut(Draft& draft, const Predicate& isTaken)
{
  Indices taken;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < draft.triangles.size(); ++t)
  {
    if (isTaken(static_cast<Index>(t)))
    {
      taken.push_back(draft.origin[t]);
      continue;
    }
    draft.triangles[kept] = draft.triangles[t];
    draft.origin[kept++] = draft.origin[t];
  }
  draft.triangles.resize(kept);
  draft.origin.resize(kept);
  return taken;
}

void joinCorners(Draft& draft, JoinedSets& places)
{
  for (Triangle& t : draft.triangles)
  {
    t = { places.find(t[0]), places.find(t[1]), places.find(t[2]) };
  }
}

/// Unites the ends of edges that are none. \return the points that were joined to another
Indices joinCollapsed(const Draft& draft, JoinedSets& places)
{
  std::vector<double> length(draft.points.size(), 0.0);
  Indices count(draft.points.size(), 0);
  const auto forEachEdge = [&draft](const auto& visit) {
    for (const Triangle& t : draft.triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index a = t[k];
        const Index b = t[(k + 1) % 3];
        if (a != b)
        {
          visit(a, b, (draft.points[a] - draft.points[b]).norm());
        }
      }
    }
  };
  forEachEdge([&](Index a, Index b, double edge) {
    for (const Index p : { a, b })
    {
      length[p] += edge;
      ++count[p];
    }
  });
  Indices joined;
  forEachEdge([&](Index a, Index b, double edge) {
    if (edge <= collapsedEdge * std::max(length[a] / count[a], length[b] / count[b]))
    {
      places.join(a, b);
      joined.insert(joined.end(), { a, b });
    }
  });
  sortUnique(joined);
  eraseIf(joined, [&places](Index p) { return places.find(p) == p; });
  return joined;
}

/// The corner between the others of a triangle with all three in a line.
int middleCorner(const Points3& points, const Triangle& t)
{
  std::array<double, 3> opposite{};
  for (int k = 0; k < 3; ++k)
  {
    opposite[k] = (points[t[(k + 1) % 3]] - points[t[(k + 2) % 3]]).norm();
  }
  return static_cast<int>(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
}

/// Divides the triangles behind the longest edge of flat ones and takes these out; each point is
/// touched once, so that the order of the triangles does not matter. \return those to be looked at
/// after it: flat ones that had to wait, and parts of divided ones
Indices divideBehind(Draft& draft, const Indices& flat)
{
  Triangles& triangles = draft.triangles;
  std::vector<char> near(draft.points.size(), 0);
  for (const Index t : flat)
  {
    near[triangles[t][0]] = near[triangles[t][1]] = near[triangles[t][2]] = 1;
  }
  std::map<std::pair<Index, Index>, Indices> atEdge;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index a = triangles[t][k];
      const Index b = triangles[t][(k + 1) % 3];
      if (near[a] && near[b])
      {
        atEdge[std::minmax(a, b)].push_back(static_cast<Index>(t));
      }
    }
  }
  std::vector<char> touched(draft.points.size(), 0);
  const auto isTouched = [&](Index t) {
    const Triangle& c = triangles[t];
    return touched[c[0]] || touched[c[1]] || touched[c[2]];
  };
  const auto touch = [&touched](
                       const Triangle& c) { touched[c[0]] = touched[c[1]] = touched[c[2]] = 1; };
  Indices next;
  std::vector<char> taken(triangles.size(), 0);
  for (const Index t : flat)
  {
    const Triangle corners = triangles[t];
    const int m = middleCorner(draft.points, corners);
    const Index middle = corners[m];
    const Index from = corners[(m + 1) % 3];
    const Index to = corners[(m + 2) % 3];
    const Indices& behind = atEdge[std::minmax(from, to)];
    if (std::any_of(behind.begin(), behind.end(), isTouched))
    {
      next.push_back(t);
      continue;
    }
    taken[t] = 1;
    for (const Index other : behind)
    {
      const Triangle whole = triangles[other];
      touch(whole);
      if (std::find(whole.begin(), whole.end(), middle) != whole.end()) // itself, or it twice
      {
        taken[other] = 1;
        continue;
      }
      Triangle second = whole;
      std::replace(triangles[other].begin(), triangles[other].end(), to, middle);
      std::replace(second.begin(), second.end(), from, middle);
      next.insert(next.end(), { other, static_cast<Index>(triangles.size()) });
      triangles.push_back(second);
      draft.origin.push_back(draft.origin[other]);
      taken.push_back(0);
    }
  }
  Indices placeOf(triangles.size(), none);
  Index kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    placeOf[t] = taken[t] ? none : kept++;
  }
  takeOut(draft, [&taken](Index t) { return taken[t] != 0; });
  Indices waiting;
  for (const Index t : next)
  {
    if (placeOf[t] != none)
    {
      waiting.push_back(placeOf[t]);
    }
  }
  return waiting;
}

/// Triangles without area of the candidates, ordered by their corners.
Indices flatOf(const Draft& draft, const Indices& candidates)
{
  std::vector<std::pair<Triangle, Index>> flat;
  for (const Index t : candidates)
  {
    if (hasNoArea(draft.points, draft.triangles[t]))
    {
      Triangle sorted = draft.triangles[t];
      std::sort(sorted.begin(), sorted.end());
      flat.emplace_back(sorted, t);
    }
  }
  std::sort(flat.begin(), flat.end());
  Indices ids;
  for (const auto& entry : flat)
  {
    ids.push_back(entry.second);
  }
  return ids;
}

/// Takes out triangles without area. \return whether it could
bool takeFlat(Draft& draft, Indices& taken)
{
  // Those whose corners are all in one place are points rather than triangles.
  const std::size_t before = draft.triangles.size();
  taken = takeOut(draft, [&draft](Index t) {
    const Triangle& c = draft.triangles[t];
    return c[0] == c[1] && c[1] == c[2];
  });
  const std::size_t whole = before - taken.size();
  const std::size_t points = taken.size();
  const Indices thin =
    takeOut(draft, [&draft](Index t) { return repeatsCorner(draft.triangles[t]); });
  taken.insert(taken.end(), thin.begin(), thin.end());
  Indices all(draft.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  Indices flat = flatOf(draft, all);
  for (const Index t : flat)
  {
    taken.push_back(draft.origin[t]);
  }
  if (2 * (taken.size() - points) >= whole)
  {
    return false;
  }
  for (int round = 0; round < maxRounds && !flat.empty(); ++round)
  {
    flat = flatOf(draft, divideBehind(draft, flat));
  }
  return flat.empty();
}

/// How much the surface bends between two triangles at their edge, in radians.
double bendAt(const Draft& draft, Index h, Index g)
{
  const auto inward = [&draft](Index side) -> Point3 {
    const Triangle& t = draft.triangles[side / 3];
    const Point3& a = draft.points[t[side % 3]];
    const Point3 along = (draft.points[t[(side + 1) % 3]] - a).normalized();
    const Point3 toThird = draft.points[t[(side + 2) % 3]] - a;
    return toThird - toThird.dot(along) * along;
  };
  return pi - angleBetween(inward(h), inward(g));
}

/// The parts that half-edges with partners hang together to.
struct Parts
{
  Indices ofTriangle;
  Indices triangleCount;
  std::vector<double> area;
  double largest = 0.0;

  Parts(const Draft& draft, const Indices& partner)
  {
    JoinedSets sets(static_cast<Index>(draft.triangles.size()));
    for (std::size_t h = 0; h < partner.size(); ++h)
    {
      if (partner[h] != none)
      {
        sets.join(static_cast<Index>(h / 3), partner[h] / 3);
      }
    }
    for (const Triangle& c : draft.triangles)
    {
      const auto t = static_cast<Index>(this->ofTriangle.size());
      const Index first = sets.find(t);
      if (first == t)
      {
        this->ofTriangle.push_back(static_cast<Index>(this->area.size()));
        this->area.push_back(0.0);
        this->triangleCount.push_back(0);
      }
      else
      {
        this->ofTriangle.push_back(this->ofTriangle[first]);
      }
      this->area[this->ofTriangle[t]] += 0.5 * areaVector(draft.points, c).norm();
      ++this->triangleCount[this->ofTriangle[t]];
    }
    this->largest = *std::max_element(this->area.begin(), this->area.end());
  }

  bool isFin(Index part) const
  {
    const double share = this->triangleCount[part] == 1 ? singleFinArea : finArea;
    return this->area[part] < share * this->largest;
  }
  bool isSpeck(Index part) const { return this->area[part] < speckArea * this->largest; }
};

/// The two triangles of a crowded edge that go on evenly, if they do more clearly than all others.
/// \param alike only triangles that are oriented alike
std::pair<Index, Index> clearPair(const Draft& draft, const Indices& edge, bool alike)
{
  const auto start = [&draft](Index h) { return draft.triangles[h / 3][h % 3]; };
  struct Bend
  {
    double angle;
    Index h;
    Index g;
  };
  std::vector<Bend> bends;
  for (std::size_t i = 0; i < edge.size(); ++i)
  {
    for (std::size_t j = i + 1; j < edge.size(); ++j)
    {
      if (!alike || start(edge[i]) != start(edge[j]))
      {
        bends.push_back({ bendAt(draft, edge[i], edge[j]), edge[i], edge[j] });
      }
    }
  }
  const auto best = std::min_element(
    bends.begin(), bends.end(), [](const Bend& a, const Bend& b) { return a.angle < b.angle; });
  if (best == bends.end() || best->angle > largestBend)
  {
    return { none, none };
  }
  for (auto bend = bends.begin(); bend != bends.end(); ++bend)
  {
    const bool shares =
      bend->h == best->h || bend->h == best->g || bend->g == best->h || bend->g == best->g;
    if (bend != best && shares && bend->angle < best->angle + clearBend)
    {
      return { none, none };
    }
  }
  return { best->h, best->g };
}

/// Decides which triangles go on with each other at a crowded edge. \param parts with all such
/// edges cut. \return whether it is clear
bool pairAtEdge(const Draft& draft, const Parts& parts, Indices edge, Indices& partner)
{
  const auto partOf = [&parts](Index h) { return parts.ofTriangle[h / 3]; };
  const auto pair = [&partner](Index h, Index g) {
    partner[h] = g;
    partner[g] = h;
  };
  Indices large;
  std::copy_if(edge.begin(), edge.end(), std::back_inserter(large),
    [&](Index h) { return !parts.isFin(partOf(h)); });
  if (large.size() == 2)
  {
    pair(large[0], large[1]);
    return true;
  }
  edge = large.size() > 2 ? large : edge;
  std::map<Index, Indices> byPart;
  for (const Index h : edge)
  {
    byPart[partOf(h)].push_back(h);
  }
  for (const auto& [part, own] : byPart)
  {
    if (own.size() == 2)
    {
      pair(own[0], own[1]);
    }
  }
  const auto takePaired = [&] {
    eraseIf(edge, [&partner](Index h) { return partner[h] != none; });
  };
  takePaired();
  while (edge.size() > 2)
  {
    auto [h, g] = clearPair(draft, edge, true);
    if (h == none)
    {
      std::tie(h, g) = clearPair(draft, edge, false); // parts may be turned over
    }
    if (h == none)
    {
      return large.size() < 2; // all but that one come off
    }
    pair(h, g);
    takePaired();
  }
  if (edge.size() == 2)
  {
    pair(edge[0], edge[1]);
  }
  return true;
}

void report(HealedSurface& result, SurfaceDefect defect, ElementKind kind, Indices ids)
{
  std::sort(ids.begin(), ids.end());
  if (!ids.empty())
  {
    result.mendings.push_back({ defect, { kind, ids } });
  }
}

/// Leaves out fins and specks, separates the rest where parts touch. The status is that of an edge
/// where it is not clear which triangles go on with each other.
Status separateParts(Draft& draft, Defects defects, HealedSurface& result)
{
  const std::vector<HalfedgeKey> sides = sortedSides(draft.triangles, draft.points.size());
  const std::vector<Indices> crowded = crowdedEdges(sides);
  Indices partner = pairSides(sides);
  for (const Indices& edge : crowded)
  {
    for (const Index h : edge)
    {
      partner[h] = none;
    }
  }
  if (!crowded.empty())
  {
    const Parts sheets(draft, partner);
    for (const Indices& edge : crowded)
    {
      if (!pairAtEdge(draft, sheets, edge, partner) && defects != Defects::Separate)
      {
        Indices around;
        for (const Index h : edge)
        {
          around.push_back(draft.origin[h / 3]);
        }
        const auto [low, high] = endsOf(draft.triangles, edge.front());
        return crowdedEdge(low, high, around);
      }
    }
  }
  const Indices oneSided =
    defects == Defects::Separate ? partOneSided(draft.triangles, crowded, partner) : Indices{};
  Indices band;
  for (const Index h : oneSided)
  {
    const auto [low, high] = endsOf(draft.triangles, h);
    band.insert(band.end(), { low, high });
  }
  const Parts parts(draft, partner);
  std::vector<char> cameOff(parts.area.size(), 0);
  for (const Indices& edge : crowded)
  {
    for (const Index h : edge)
    {
      if (partner[h] == none)
      {
        cameOff[parts.ofTriangle[h / 3]] = 1;
      }
    }
  }
  Indices fins;
  Indices specks;
  Index speckCount = 0;
  std::vector<char> leftOut(parts.area.size(), 0);
  for (std::size_t part = 0; part < parts.area.size(); ++part)
  {
    const Index p = static_cast<Index>(part);
    const bool fin = cameOff[part] && parts.isFin(p);
    leftOut[part] = fin || (defects != Defects::HealParts && parts.isSpeck(p)) ? 1 : 0;
    speckCount += leftOut[part] && !fin ? 1 : 0;
    cameOff[part] = fin ? 1 : 0;
  }
  Indices separated;
  for (const Indices& edge : crowded)
  {
    Index kept = 0;
    for (const Index h : edge)
    {
      kept += leftOut[parts.ofTriangle[h / 3]] ? 0 : 1;
    }
    if (kept > 2)
    {
      const auto [low, high] = endsOf(draft.triangles, edge.front());
      separated.insert(separated.end(), { low, high });
    }
  }
  if (std::any_of(leftOut.begin(), leftOut.end(), [](char out) { return out != 0; }))
  {
    Indices placeOf(draft.triangles.size(), none);
    Index kept = 0;
    for (std::size_t t = 0; t < draft.triangles.size(); ++t)
    {
      const Index part = parts.ofTriangle[t];
      if (leftOut[part])
      {
        (cameOff[part] ? fins : specks).push_back(draft.origin[t]);
        continue;
      }
      placeOf[t] = kept++;
    }
    // A triangle keeps its partners or none of them.
    Indices ofKept;
    for (std::size_t h = 0; h < partner.size(); ++h)
    {
      if (placeOf[h / 3] != none)
      {
        const Index g = partner[h];
        ofKept.push_back(g == none ? none : 3 * placeOf[g / 3] + g % 3);
      }
    }
    partner = std::move(ofKept);
    takeOut(draft, [&placeOf](Index t) { return placeOf[t] == none; });
  }
  const Indices opened =
    partAtEnds(draft.triangles, draft.points.size(), !oneSided.empty(), partner);
  separated.insert(separated.end(), opened.begin(), opened.end());
  Indices pinched = splitFans(draft.triangles, draft.points, draft.source, partner);
  Indices onEdges = separated;
  onEdges.insert(onEdges.end(), band.begin(), band.end());
  std::sort(onEdges.begin(), onEdges.end());
  eraseIf(pinched, [&](Index p) { return std::binary_search(onEdges.begin(), onEdges.end(), p); });
  report(result, SurfaceDefect::Fins, ElementKind::Cells, fins);
  if (!separated.empty())
  {
    result.mendings.push_back({ SurfaceDefect::CrowdedEdges, { ElementKind::Edges, separated } });
  }
  if (!band.empty())
  {
    result.mendings.push_back({ SurfaceDefect::OneSidedEdges, { ElementKind::Edges, band } });
  }
  report(result, SurfaceDefect::PinchedPoints, ElementKind::Points, pinched);
  report(result, SurfaceDefect::Specks, ElementKind::Cells, specks);
  if (!specks.empty())
  {
    result.mendings.back().parts = speckCount;
  }
  return {};
}

/// Whether an edge may be none: it is far shorter than another of its triangle.
bool hasNeedle(const TriangleMesh& mesh)
{
  constexpr double needle = 1e-10; // of squares; at an end of the edge there may be longer ones
  return std::any_of(mesh.triangles().begin(), mesh.triangles().end(), [&](const Triangle& t) {
    const double a = (mesh.point(t[1]) - mesh.point(t[0])).squaredNorm();
    const double b = (mesh.point(t[2]) - mesh.point(t[1])).squaredNorm();
    const double c = (mesh.point(t[0]) - mesh.point(t[2])).squaredNorm();
    return std::min({ a, b, c }) <= needle * std::max({ a, b, c });
  });
}

bool hasSpeck(const TriangleMesh& mesh)
{
  Indices partOf;
  const Index count = connectedParts(mesh, {}, partOf);
  if (count == 1)
  {
    return false;
  }
  std::vector<double> areas(count, 0.0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    areas[partOf[t]] += mesh.area(t);
  }
  const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
  return *least < speckArea * *most;
}

/// What prepareSurface() made of the draft, in the numbers of the input.
void finish(const Draft& draft, HealedSurface& result)
{
  PreparedSurface prepared = prepareSurface(draft.points, draft.triangles, CoincidentPoints::Keep);
  static_cast<PreparedSurface&>(result) = std::move(prepared);
  for (Index& p : result.originalPoint)
  {
    p = draft.source[p];
  }
  for (std::int64_t& id : result.status.ids.values)
  {
    id = result.status.ids.kind == ElementKind::Cells ? draft.origin[id] : draft.source[id];
  }
  for (Index& t : result.reversedTriangles)
  {
    t = draft.origin[t];
  }
}

HealedSurface heal(
  const Points3& points, const Triangles& triangles, CoincidentPoints coincident, Defects defects)
{
  HealedSurface sound;
  static_cast<PreparedSurface&>(sound) = prepareSurface(points, triangles, coincident);
  if (defects == Defects::Refuse)
  {
    return sound;
  }
  const StatusCode code = sound.status.code;
  const bool ok = code == StatusCode::Ok;
  const bool hasSpecks = ok && defects != Defects::HealParts && hasSpeck(sound.mesh);
  const bool mendable = hasSpecks || (ok && hasNeedle(sound.mesh)) ||
    code == StatusCode::DegenerateTriangle || code == StatusCode::NonManifoldEdge ||
    code == StatusCode::NonManifoldVertex ||
    (code == StatusCode::NotOrientable && defects == Defects::Separate);
  if (!mendable)
  {
    report(sound, SurfaceDefect::ReversedTriangles, ElementKind::Cells, sound.reversedTriangles);
    return sound;
  }
  Draft draft{ points, Indices(points.size()), triangles, Indices(triangles.size()) };
  std::iota(draft.source.begin(), draft.source.end(), 0);
  std::iota(draft.origin.begin(), draft.origin.end(), 0);
  JoinedSets places(static_cast<Index>(points.size()));
  const Indices first = firstInPlace(points, triangles, coincident);
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    places.join(static_cast<Index>(p), first[p]);
  }
  joinCorners(draft, places);
  HealedSurface result;
  result.joinedPoints = joinCollapsed(draft, places);
  Indices flat;
  joinCorners(draft, places);
  const bool joins = !result.joinedPoints.empty();
  if ((ok && !hasSpecks && !joins) || !takeFlat(draft, flat))
  {
    report(sound, SurfaceDefect::ReversedTriangles, ElementKind::Cells, sound.reversedTriangles);
    return sound;
  }
  report(result, SurfaceDefect::FlatTriangles, ElementKind::Cells, flat);
  const Indices doubled =
    doubledTriangles(draft.triangles, sortedSides(draft.triangles, points.size()));
  report(result, SurfaceDefect::DoubledTriangles, ElementKind::Cells,
    takeOut(draft,
      [&doubled](Index t) { return std::binary_search(doubled.begin(), doubled.end(), t); }));
  result.status = separateParts(draft, defects, result);
  if (!result.status.ok())
  {
    return result;
  }
  finish(draft, result);
  if (!result.status.ok())
  {
    return result;
  }
  result.vertexOfPoint.resize(points.size(), none);
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    result.vertexOfPoint[p] = result.vertexOfPoint[places.find(static_cast<Index>(p))];
  }
  Indices& joined = result.joinedPoints; // to a point that is left
  eraseIf(joined, [&result](Index p) { return result.vertexOfPoint[p] == none; });
  if (!joined.empty())
  {
    result.mendings.insert(
      result.mendings.begin(), { SurfaceDefect::CollapsedPoints, { ElementKind::Points, joined } });
  }
  report(result, SurfaceDefect::ReversedTriangles, ElementKind::Cells, result.reversedTriangles);
  result.originalTriangle = std::move(draft.origin);
  return result;
}
}

HealedSurface healSurface(
  const Points3& points, const Triangles& triangles, CoincidentPoints coincident, Defects defects)
{
  return withinMemory([&] { return heal(points, triangles, coincident, defects); });
}
}
