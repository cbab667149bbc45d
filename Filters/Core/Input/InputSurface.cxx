// SPDX-License-Identifier: BSD-3-Clause
#include "Input/InputSurface.h"

#include "Base/Types.h"
#include "Input/StatusWords.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{
bool isInsideOut(const TriangleMesh& mesh)
{
  double volume = 0.0;
  const Point3& origin = mesh.point(0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      if (mesh.twin(h) == none)
      {
        return false;
      }
    }
    volume +=
      (mesh.point(c[0]) - origin).dot((mesh.point(c[1]) - origin).cross(mesh.point(c[2]) - origin));
  }
  return volume < 0.0;
}

/// "(first: 5, 88, 103)", or all of a few.
std::string firstOf(const std::vector<std::string>& ids)
{
  constexpr std::size_t most = 3;
  std::string text = ids.size() > most ? " (first: " : " (";
  for (std::size_t k = 0; k < std::min(most, ids.size()); ++k)
  {
    text += (k == 0 ? "" : ", ") + ids[k];
  }
  return text + ")";
}

/// Gives the triangles of the input that healing left the places that they have in the mesh.
void keepHealed(LoadedSurface& surface)
{
  const HealedSurface& healed = surface.prepared;
  std::vector<std::int64_t> cells;
  for (const Index t : healed.originalTriangle)
  {
    cells.push_back(surface.input.cellOfTriangle[t]);
  }
  surface.input.cellOfTriangle = std::move(cells);
  surface.input.triangles = healed.mesh.triangles();
  for (Triangle& t : surface.input.triangles)
  {
    t = { healed.originalPoint[t[0]], healed.originalPoint[t[1]], healed.originalPoint[t[2]] };
  }
}
}

std::string describe(const Mending& mending)
{
  std::vector<std::string> ids;
  const std::vector<std::int64_t>& values = mending.ids.values;
  const bool pairs = mending.ids.kind == ElementKind::Edges;
  for (std::size_t k = 0; k < values.size(); k += pairs ? 2 : 1)
  {
    ids.push_back(
      std::to_string(values[k]) + (pairs ? "-" + std::to_string(values[k + 1]) : std::string()));
  }
  const bool one = ids.size() == 1;
  const char* const was = one ? " was" : " were";
  const auto counted = [&](const std::string& thing) {
    return std::to_string(ids.size()) + ' ' + thing + (one ? "" : "s");
  };
  std::string text;
  switch (mending.defect)
  {
    case SurfaceDefect::CollapsedPoints:
      text =
        counted("point") + was + " joined with a neighbor within a millionth of the edges there";
      break;
    case SurfaceDefect::FlatTriangles:
      text = counted("triangle") + " without area" + was + " taken out";
      break;
    case SurfaceDefect::DoubledTriangles:
      text = counted("triangle") + " with the corners of another" + was + " taken out";
      break;
    case SurfaceDefect::Fins:
      text = counted("triangle") + " standing on an edge of others" + was + " taken out";
      break;
    case SurfaceDefect::OneSidedEdges:
      text = "the surface is one-sided, as a Moebius band, and was opened at " + counted("edge");
      break;
    case SurfaceDefect::CrowdedEdges:
      text = "the surface was separated at " + counted("edge") + " of more than two triangles";
      break;
    case SurfaceDefect::PinchedPoints:
      text = counted("point") + " in which parts touch" + was + " doubled";
      break;
    case SurfaceDefect::Specks:
      text = std::to_string(mending.parts) + (mending.parts == 1 ? " part" : " parts") +
        " below 0.1 % of the largest part's area " + (mending.parts == 1 ? "was" : "were") +
        " left out: " + counted("triangle");
      break;
    case SurfaceDefect::ReversedTriangles:
      text = counted("triangle") + was + " turned over to agree with the others";
      break;
  }
  return text + firstOf(ids);
}

Status checkSize(std::int64_t points, std::int64_t corners)
{
  constexpr std::int64_t maxTriangles = std::numeric_limits<Index>::max() / 3;
  if (corners <= maxTriangles && points <= maxTriangles)
  {
    return {};
  }
  return { StatusCode::InvalidOption,
    "the surface has more than " + std::to_string(maxTriangles) + " points or corners", {},
    { Remedy::DivideInput } };
}

LoadedSurface loadSurface(SurfaceTriangles input, CoincidentPoints coincident, Defects defects)
{
  LoadedSurface result;
  result.input = std::move(input);
  result.outcome = result.input.outcome;
  if (!result.outcome.ok())
  {
    return result;
  }
  result.prepared = healSurface(result.input.points, result.input.triangles, coincident, defects);
  const Status& status = result.prepared.status;
  // Its points are the input's.
  result.outcome =
    status.ids.kind == ElementKind::Cells ? inInput(status, result.input.cellOfTriangle) : status;
  if (!result.outcome.ok())
  {
    return result;
  }
  for (Mending& mending : result.prepared.mendings)
  {
    if (mending.ids.kind == ElementKind::Cells)
    {
      for (std::int64_t& id : mending.ids.values)
      {
        id = result.input.cellOfTriangle[id];
      }
    }
    result.mendings.push_back(describe(mending));
  }
  if (!result.prepared.originalTriangle.empty())
  {
    keepHealed(result);
  }
  return result;
}

LoadedBody loadBody(SurfaceTriangles body)
{
  LoadedBody result;
  const LoadedSurface surface =
    loadSurface(std::move(body), CoincidentPoints::Automatic, Defects::Heal);
  result.outcome = surface.outcome;
  if (!result.outcome.ok())
  {
    // Ids would be taken for those of the surface.
    result.outcome.message = "the body: " + result.outcome.message;
    result.outcome.ids = {};
    return result;
  }
  result.mesh = surface.prepared.mesh;
  result.given = true;
  if (isInsideOut(result.mesh))
  {
    Triangles turned = result.mesh.triangles();
    for (Triangle& c : turned)
    {
      std::swap(c[1], c[2]);
    }
    result.mesh = TriangleMesh(result.mesh.points(), std::move(turned));
  }
  return result;
}
}
