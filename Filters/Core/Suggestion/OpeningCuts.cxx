// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/OpeningCuts.h"

#include "Base/CompressedRows.h"
#include "Cut/PieceTopology.h"
#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Paths/PlaneSection.h"
#include "Paths/StraightPath.h"
#include "Surface/EdgePaths.h"
#include "Surface/SurfacePoint.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace flattening
{
namespace
{
Polyline seamAlong(const SurfacePath& path)
{
  Polyline line;
  line.type = CurveType::Seam;
  line.points = positionsOf(path.points);
  return line;
}

/// The closed curves of the surface's section with a plane.
std::vector<Polyline> sectionLoops(const TriangleMesh& mesh, const SymmetryPlane& plane)
{
  std::vector<Polyline> loops;
  for (const PlaneSection& section : planeSections(mesh, plane.offset * plane.normal, plane.normal))
  {
    if (section.closed)
    {
      loops.push_back(seamAlong(section.path));
    }
  }
  return loops;
}

/// An edge under its two vertices.
using Edge = std::pair<Index, Index>;

Edge edgeBetween(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Edges in no tree.
Indices generators(const TriangleMesh& mesh, const EdgePaths& paths)
{
  std::set<Edge> inTree;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (paths.reaches(v) && paths.before(v) != v)
    {
      inTree.insert(edgeBetween(v, paths.before(v)));
    }
  }
  // A boundary loop counts as one more triangle.
  Index count = mesh.triangleCount();
  std::vector<Index> outside(mesh.halfedgeCount(), none);
  for (const Indices& loop : mesh.boundaryLoops())
  {
    for (Index h : loop)
    {
      outside[h] = count;
    }
    ++count;
  }
  Indices edges;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none || h < mesh.twin(h))
    {
      edges.push_back(h);
    }
  }
  // Those that would close the longest loops first, so that the short ones are left.
  const auto around = [&](Index h) {
    return paths.distance(mesh.from(h)) + paths.distance(mesh.to(h)) + mesh.length(h);
  };
  std::stable_sort(
    edges.begin(), edges.end(), [&](Index a, Index b) { return around(a) > around(b); });
  JoinedSets faces(count);
  Indices left;
  for (Index h : edges)
  {
    const Index twin = mesh.twin(h);
    const Index outer = twin == none ? outside[h] : twin / 3;
    if (inTree.count(edgeBetween(mesh.from(h), mesh.to(h))) == 0)
    {
      if (faces.find(h / 3) == faces.find(outer))
      {
        left.push_back(h);
      }
      faces.join(h / 3, outer);
    }
  }
  return left;
}

/// The parts of a way whose edges no cut has yet, boundary edges apart.
void addUnused(
  const TriangleMesh& mesh, const Indices& way, std::set<Edge>& used, std::vector<Polyline>& lines)
{
  bool open = false;
  for (std::size_t k = 1; k < way.size(); ++k)
  {
    const Index a = way[k - 1];
    const Index b = way[k];
    const bool inside = mesh.find(a, b) != none && mesh.find(b, a) != none;
    if (!inside || !used.insert(edgeBetween(a, b)).second)
    {
      open = false;
      continue;
    }
    if (!open)
    {
      lines.emplace_back();
      lines.back().type = CurveType::Seam;
      lines.back().points.push_back(mesh.point(a));
    }
    open = true;
    lines.back().points.push_back(mesh.point(b));
  }
}

std::vector<Polyline> handleLoops(const TriangleMesh& mesh)
{
  const EdgePaths paths(mesh, { mesh.triangle(0)[0] }, {}, EdgePaths::Through::Boundary);
  std::set<Edge> used;
  std::vector<Polyline> lines;
  for (Index h : generators(mesh, paths))
  {
    Indices ring = paths.path(mesh.from(h));
    const Indices back = paths.path(mesh.to(h));
    ring.insert(ring.end(), back.rbegin(), back.rend());
    addUnused(mesh, ring, used, lines);
  }
  return lines;
}

/// Joins loops that are no mere holes to the longest one, each by the shortest way to what is
/// joined already, as long as there is one that meets no barred vertex.
std::vector<Polyline> joinLoops(const TriangleMesh& mesh, const std::vector<char>& barred)
{
  const std::vector<Indices> loops = mesh.boundaryLoops();
  const std::vector<char> holes = findHoles(mesh, loops);
  std::vector<Indices> joined;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    if (!holes[l])
    {
      joined.push_back(loops[l]);
    }
  }
  const PathGraph graph(mesh);
  std::vector<Polyline> lines;
  for (const Indices& path : joiningPaths(mesh, std::move(joined), barred))
  {
    const SurfacePoint start = vertexPoint(mesh, path.front());
    lines.push_back(seamAlong(straightPath(graph, start, vertexPoint(mesh, path.back())).path));
  }
  return lines;
}
}

std::vector<Polyline> openingCuts(const TriangleMesh& mesh,
  const std::optional<SymmetryPlane>& mirror, const std::vector<char>& barred)
{
  const auto loops = static_cast<Index>(mesh.boundaryLoops().size());
  const Index handles = (2 - loops - eulerCharacteristic(mesh)) / 2;
  if (handles > 0)
  {
    return handleLoops(mesh);
  }
  return loops == 0 ? sectionLoops(mesh, mirror ? *mirror : flattestPlane(mesh))
                    : joinLoops(mesh, barred);
}

bool laysOpen(const TriangleMesh& mesh, const std::vector<Polyline>& curves)
{
  const ImprintedSurface imprinted = imprintCurves(mesh, curves, {});
  if (!imprinted.status.ok())
  {
    return false;
  }
  const std::vector<Piece> parts = extractPieces(cutSurface(imprinted.mesh, imprinted.curves));
  return std::none_of(
    parts.begin(), parts.end(), [](const Piece& part) { return findDefect(part).has_value(); });
}

std::vector<char> findHoles(const TriangleMesh& mesh, const std::vector<Indices>& loops)
{
  const auto lengthOf = [&](const Indices& loop) {
    return std::accumulate(
      loop.begin(), loop.end(), 0.0, [&](double sum, Index h) { return sum + mesh.length(h); });
  };
  std::vector<char> holes(loops.size(), 0);
  for (std::size_t l = 1; l < loops.size(); ++l)
  {
    const bool hole = lengthOf(loops[l]) <= shortLoop * lengthOf(loops[0]) ||
      turnOf(mesh, loops[l]) <= -minHoleTurn * 2.0 * pi;
    holes[l] = hole ? 1 : 0;
  }
  return holes;
}
}
