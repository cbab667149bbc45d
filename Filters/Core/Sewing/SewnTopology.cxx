// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SewnTopology.h"

#include "Base/CompressedRows.h"

namespace flattening
{
namespace
{
/// Numbers sets in the order of their names; \param shapeOf filled per member.
Index numbered(JoinedSets& sets, Index count, Indices& shapeOf)
{
  Index next = 0;
  shapeOf.assign(count, none);
  for (Index k = 0; k < count; ++k)
  {
    const Index name = sets.find(k);
    shapeOf[k] = name == k ? next++ : shapeOf[name];
  }
  return next;
}
}

SewnTopology sewnShapes(const CutSurface& cut, const Points2& positions, SewingTest test)
{
  const TriangleMesh& mesh = cut.mesh;
  const bool product = test == SewingTest::Product;
  JoinedSets vertices(mesh.vertexCount());
  JoinedSets pieces(cut.pieceCount);
  std::vector<char> sewn(cut.pieceCount, 0);
  Indices twins(mesh.halfedgeCount());
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    twins[h] = mesh.twin(h);
  }
  for (const SeamPair& pair : cut.seamPairs)
  {
    if (product)
    {
      vertices.join(mesh.from(pair.first), mesh.to(pair.second));
      vertices.join(mesh.to(pair.first), mesh.from(pair.second));
      pieces.join(cut.pieceOfTriangle[pair.first / 3], cut.pieceOfTriangle[pair.second / 3]);
      sewn[cut.pieceOfTriangle[pair.first / 3]] = 1;
      twins[pair.first] = pair.second;
      twins[pair.second] = pair.first;
    }
  }

  SewnTopology result;
  Indices shapeOfPiece;
  result.shapes.resize(numbered(pieces, cut.pieceCount, shapeOfPiece));
  for (Index p = 0; p < cut.pieceCount; ++p)
  {
    SewnShape& shape = result.shapes[shapeOfPiece[p]];
    ++shape.pieces;
    shape.sewn = shape.sewn || sewn[p];
  }
  result.vertexInShape.assign(mesh.vertexCount(), none);
  Indices triangleInShape(mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    result.shapeOfTriangle.push_back(shapeOfPiece[cut.pieceOfTriangle[t]]);
    SewnShape& shape = result.shapes[result.shapeOfTriangle.back()];
    Triangle corners{};
    std::array<Point2, 3> flat;
    for (int k = 0; k < 3; ++k)
    {
      const Index copy = mesh.triangle(t)[k];
      const Index vertex = vertices.find(copy);
      if (result.vertexInShape[vertex] == none)
      {
        result.vertexInShape[vertex] = static_cast<Index>(shape.vertices.size());
        shape.vertices.push_back(vertex);
        shape.cloth.points.push_back(mesh.point(vertex));
        shape.cloth.held.push_back(!product && mesh.onBoundary(vertex) ? 1 : 0);
      }
      result.vertexInShape[copy] = result.vertexInShape[vertex];
      corners[k] = result.vertexInShape[vertex];
      flat[k] = positions[copy];
    }
    triangleInShape[t] = static_cast<Index>(shape.triangles.size());
    shape.triangles.push_back(t);
    shape.cloth.triangles.push_back(corners);
    shape.cloth.flat.push_back(flat);
  }
  for (SewnShape& shape : result.shapes)
  {
    for (Index t : shape.triangles)
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = twins[h];
        shape.cloth.twins.push_back(twin == none ? none : 3 * triangleInShape[twin / 3] + twin % 3);
      }
    }
  }
  return result;
}
}
