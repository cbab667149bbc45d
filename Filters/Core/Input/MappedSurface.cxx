// SPDX-License-Identifier: BSD-3-Clause
#include "Input/MappedSurface.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace flattening
{
namespace
{
using Coordinates = std::array<double, 3>;

Coordinates coordinatesOf(const DataSet& data, std::int64_t point)
{
  const Point3& x = (*data.points)[static_cast<std::size_t>(point)];
  return { x.x(), x.y(), x.z() };
}

Status readFlatPositions(const DataSet& surface, const DataSet* flat, MappedSurface& result)
{
  const auto found = std::find_if(surface.pointArrays.begin(), surface.pointArrays.end(),
    [](const Column& column) { return column.role == ArrayRole::TextureCoordinates; });
  const Column* const coordinates = found == surface.pointArrays.end() ? nullptr : &*found;
  if (flat &&
    (flat->points->size() != surface.points->size() || flat->faces.size() != surface.faces.size() ||
      flat->strips.size() != surface.strips.size()))
  {
    return invalidOption(
      "the flat surface has not as many points and cells as the surface", "the same surface, flat");
  }
  if (!flat &&
    (!coordinates || coordinates->components < 2 || coordinates->rows() < surface.points->size()))
  {
    return invalidOption(
      "there are no flat positions", "the flat surface on port 1, or texture coordinates");
  }
  Indices bad;
  for (const Index p : result.surface.prepared.originalPoint)
  {
    const auto row = static_cast<std::size_t>(p);
    result.positions.push_back(flat
        ? Point2((*flat->points)[row].head<2>())
        : Point2(coordinates->number(row, 0), coordinates->number(row, 1)));
    if (!isFinite(result.positions.back()))
    {
      bad.push_back(p);
    }
  }
  if (!bad.empty())
  {
    return { StatusCode::NonFinitePoint,
      "the flat positions of points " + listIds(bad) + " are not finite numbers",
      { ElementKind::Points, bad }, { Remedy::MendPoints } };
  }
  return {};
}

void turnFaceUp(MappedSurface& result)
{
  double twiceArea = 0.0;
  for (const Triangle& t : result.surface.prepared.mesh.triangles())
  {
    twiceArea += cross(result.positions, t);
  }
  result.mirrored = twiceArea < 0.0;
  if (result.mirrored)
  {
    for (Point2& position : result.positions)
    {
      position.x() = -position.x();
    }
  }
}

/// Finds the half-edges that run between points with the coordinates of a data set's lines.
class EdgeFinder
{
public:
  /// \param coordinates per vertex of the mesh
  EdgeFinder(const TriangleMesh& mesh, const std::vector<Coordinates>& coordinates)
    : Mesh(mesh)
  {
    std::map<Coordinates, Index>& first = this->FirstVertex;
    for (std::size_t v = 0; v < coordinates.size(); ++v)
    {
      const auto found = first.insert({ coordinates[v], static_cast<Index>(v) }).first;
      this->Place.push_back(found->second);
    }
  }

  Status find(const DataSet& lines, Indices& edges) const
  {
    using Pair = std::pair<Index, Index>;
    // With the points that ask for it.
    std::map<Pair, std::pair<std::int64_t, std::int64_t>> wanted;
    std::vector<std::int64_t> unknown;
    for (std::size_t k = 0; k < lines.lines.size(); ++k)
    {
      const std::int64_t* const ids = lines.lines.begin(k);
      Index last = none;
      for (std::ptrdiff_t i = 0; i < lines.lines.end(k) - ids; ++i)
      {
        const Index place = this->placeOf(lines, ids[i]);
        if (place == none)
        {
          unknown.push_back(ids[i]);
        }
        else if (last != none && place != last)
        {
          wanted.insert({ std::minmax(last, place), { ids[i - 1], ids[i] } });
        }
        last = place;
      }
    }
    if (!unknown.empty())
    {
      return { StatusCode::CurvePointOffSurface,
        "points " + listIds(unknown) + " of the edges are not points of the surface",
        { ElementKind::CurvePoints, unknown }, { Remedy::TakeEdges } };
    }
    std::set<Pair> met;
    for (Index h = 0; h < this->Mesh.halfedgeCount(); ++h)
    {
      const Pair pair = std::minmax(this->Place[this->Mesh.from(h)], this->Place[this->Mesh.to(h)]);
      if (this->Mesh.twin(h) < h && wanted.count(pair) != 0)
      {
        edges.push_back(h);
        met.insert(pair);
      }
    }
    for (const auto& entry : wanted)
    {
      if (met.count(entry.first) == 0)
      {
        return { StatusCode::CurveNotOnEdges,
          "there is no edge of the surface between points " + std::to_string(entry.second.first) +
            " and " + std::to_string(entry.second.second) + " of the edges",
          { ElementKind::CurvePoints,
            std::vector<std::int64_t>{ entry.second.first, entry.second.second } },
          { Remedy::TakeEdges } };
      }
    }
    return {};
  }

private:
  Index placeOf(const DataSet& lines, std::int64_t point) const
  {
    if (point < 0 || point >= static_cast<std::int64_t>(lines.points->size()))
    {
      return none;
    }
    const Coordinates coordinates = coordinatesOf(lines, point);
    for (const double x : coordinates)
    {
      if (!std::isfinite(x))
      {
        return none; // it would break the order of the map
      }
    }
    const auto found = this->FirstVertex.find(coordinates);
    return found == this->FirstVertex.end() ? none : found->second;
  }

  const TriangleMesh& Mesh;
  std::map<Coordinates, Index> FirstVertex;
  Indices Place; ///< per vertex the first one with its coordinates
};

Status findEdges(const DataSet* flat, const DataSet* edges, MappedSurface& result)
{
  const TriangleMesh& mesh = result.surface.prepared.mesh;
  if (!edges)
  {
    for (const Indices& loop : mesh.boundaryLoops())
    {
      result.edges.insert(result.edges.end(), loop.begin(), loop.end());
    }
    return {};
  }
  std::vector<Coordinates> inSpace;
  for (const Point3& p : mesh.points())
  {
    inSpace.push_back({ p.x(), p.y(), p.z() });
  }
  Status outcome = EdgeFinder(mesh, inSpace).find(*edges, result.edges);
  if (outcome.ok() || !flat)
  {
    return outcome;
  }
  std::vector<Coordinates> inPlane;
  for (const Index p : result.surface.prepared.originalPoint)
  {
    inPlane.push_back(coordinatesOf(*flat, p));
  }
  result.edges.clear();
  return EdgeFinder(mesh, inPlane).find(*edges, result.edges).ok() ? Status() : outcome;
}
}

MappedSurface loadMappedSurface(const DataSet& surface, const DataSet* flat, const DataSet* edges)
{
  MappedSurface result;
  result.surface = loadSurface(readTriangles(surface), CoincidentPoints::Keep, Defects::HealParts);
  result.outcome = result.surface.outcome;
  if (result.outcome.ok())
  {
    result.outcome = readFlatPositions(surface, flat, result);
  }
  if (result.outcome.ok())
  {
    turnFaceUp(result);
    result.outcome = findEdges(flat, edges, result);
  }
  return result;
}
}
