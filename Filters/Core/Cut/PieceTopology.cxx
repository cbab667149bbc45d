// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/PieceTopology.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// In a message all of them are named, up to a number that can still be read.
constexpr std::size_t maxNamed = 20;

std::string counted(Index count, Index all, const char* one, const char* many)
{
  return std::to_string(count) + " of " + std::to_string(all) + " pieces " +
    (count == 1 ? one : many);
}

/// One piece that is the whole surface.
Status refusalOfWhole(const PieceDefect& defect)
{
  const std::string triangle = std::to_string(defect.triangle);
  return { defect.code(),
    defect.closed
      ? "the surface is closed (triangle " + triangle + " lies on a part without boundary)"
      : "the surface has " + std::to_string(defect.handles) + " handle(s) (the part of triangle " +
        triangle + ")",
    { ElementKind::Cells, Indices{ defect.triangle } },
    { defect.closed ? Remedy::CutOpen : Remedy::OpenHandles } };
}
}

StatusCode PieceDefect::code() const
{
  return this->closed ? StatusCode::ClosedSurface : StatusCode::Handle;
}

std::optional<PieceDefect> findDefect(const Piece& piece)
{
  const auto loops = static_cast<Index>(piece.mesh.boundaryLoops().size());
  PieceDefect defect;
  defect.closed = loops == 0;
  defect.handles = (2 - loops - eulerCharacteristic(piece.mesh)) / 2;
  if (!defect.closed && defect.handles == 0)
  {
    return {};
  }
  defect.triangle = piece.triangles.front();
  defect.triangles = piece.mesh.triangleCount();
  return defect;
}

std::vector<std::optional<PieceDefect>> findDefects(const std::vector<Piece>& pieces)
{
  std::vector<std::optional<PieceDefect>> defects(pieces.size());
  std::transform(pieces.begin(), pieces.end(), defects.begin(), findDefect);
  return defects;
}

Status refusalOf(const std::vector<std::optional<PieceDefect>>& defects)
{
  Indices closed;
  Indices handled;
  Indices all;
  for (const std::optional<PieceDefect>& defect : defects)
  {
    if (defect)
    {
      (defect->closed ? closed : handled).push_back(defect->triangle);
      all.push_back(defect->triangle);
    }
  }
  if (all.empty())
  {
    return {};
  }
  if (defects.size() == 1)
  {
    return refusalOfWhole(*defects.front());
  }
  const auto count = static_cast<Index>(defects.size());
  std::string message;
  SuggestedRemedies remedies;
  if (!closed.empty())
  {
    message += counted(static_cast<Index>(closed.size()), count, "has", "have") +
      " no boundary (triangles " + listIds(closed, maxNamed) + ")";
    remedies.emplace_back(Remedy::CutOpen);
  }
  if (!handled.empty())
  {
    message += (message.empty() ? "" : ", ") +
      counted(static_cast<Index>(handled.size()), count, "has", "have") + " handles (triangles " +
      listIds(handled, maxNamed) + ")";
    remedies.emplace_back(Remedy::OpenHandles);
  }
  if (all.size() < defects.size())
  {
    remedies.emplace_back(Remedy::SkipClosed);
  }
  return { closed.empty() ? StatusCode::Handle : StatusCode::ClosedSurface, message,
    { ElementKind::Cells, all }, remedies };
}

CutSurface withoutPieces(const CutSurface& cut, const std::vector<char>& leftOut)
{
  CutSurface kept;
  kept.originalVertexCount = cut.originalVertexCount;
  Indices pieceOf(leftOut.size(), none);
  for (std::size_t p = 0; p < leftOut.size(); ++p)
  {
    pieceOf[p] = leftOut[p] ? none : kept.pieceCount++;
  }
  Indices vertexOf(cut.mesh.vertexCount(), none);
  Indices triangleOf(cut.mesh.triangleCount(), none);
  Triangles triangles;
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    if (leftOut[cut.pieceOfTriangle[t]])
    {
      continue;
    }
    triangleOf[t] = static_cast<Index>(triangles.size());
    kept.keptTriangles.push_back(cut.originalTriangle(t));
    kept.pieceOfTriangle.push_back(pieceOf[cut.pieceOfTriangle[t]]);
    triangles.push_back(cut.mesh.triangle(t));
    for (Index v : cut.mesh.triangle(t))
    {
      vertexOf[v] = 0;
    }
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      kept.curveOfHalfedge.push_back(cut.curveOfHalfedge[h]);
    }
  }
  Points3 points;
  for (Index v = 0; v < cut.mesh.vertexCount(); ++v)
  {
    if (vertexOf[v] != none)
    {
      vertexOf[v] = static_cast<Index>(points.size());
      points.push_back(cut.mesh.point(v));
      kept.originalVertex.push_back(cut.originalVertex[v]);
    }
  }
  const auto halfedgeOf = [&triangleOf](Index h) { return 3 * triangleOf[h / 3] + h % 3; };
  Indices twins;
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    for (Index h = 3 * t; triangleOf[t] != none && h < 3 * t + 3; ++h)
    {
      const Index twin = cut.mesh.twin(h);
      twins.push_back(twin == none ? none : halfedgeOf(twin));
    }
  }
  for (Triangle& triangle : triangles)
  {
    for (Index& v : triangle)
    {
      v = vertexOf[v];
    }
  }
  for (const SeamPair& pair : cut.seamPairs)
  {
    // Where a piece is left out there is nothing to sew to.
    if (triangleOf[pair.first / 3] != none && triangleOf[pair.second / 3] != none)
    {
      kept.seamPairs.push_back({ halfedgeOf(pair.first), halfedgeOf(pair.second), pair.curve });
    }
  }
  kept.mesh = TriangleMesh(std::move(points), std::move(triangles), std::move(twins));
  return kept;
}
}
