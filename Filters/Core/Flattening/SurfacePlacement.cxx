// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/SurfacePlacement.h"

#include "Flattening/PieceArrangement.h"
#include "Flattening/WireReport.h"

namespace flattening
{
namespace
{
/// Indices in a piece of the two ends of its grainline: of the wires of its first key curve the one
/// with the most vertices.
std::array<Index, 2> findGrain(
  const std::vector<Wire>& wires, Index pieceId, const Indices& localVertex)
{
  const Wire* grain = nullptr;
  for (const Wire& wire : wires)
  {
    if (wire.piece == pieceId && wire.curve != none && wire.type == CurveType::Key &&
      (!grain || (wire.curve == grain->curve && wire.vertices.size() > grain->vertices.size())))
    {
      grain = &wire;
    }
  }
  if (!grain || grain->vertices.front() == grain->vertices.back())
  {
    return { none, none };
  }
  return { localVertex[grain->vertices.front()], localVertex[grain->vertices.back()] };
}

/// The positions of all pieces where they end up.
std::vector<Points2> finalPositions(const std::vector<WiredPiece>& pieces,
  const FlatteningOptions& options, const FlatteningResult& result, std::vector<FlatPiece>& flat)
{
  std::vector<ArrangementPiece> arrangement(pieces.size());
  Indices local(result.cut->mesh.vertexCount(), none);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Indices& vertices = pieces[p].piece.vertices;
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      local[vertices[k]] = static_cast<Index>(k);
    }
    arrangement[p].positions = std::move(flat[p].positions);
    arrangement[p].upright = flat[p].report.cloth.has_value(); // on its cloth
    arrangement[p].grain = findGrain(result.wires, static_cast<Index>(p), local);
  }
  if (options.arrange)
  {
    return arrangePieces(arrangement, options.spacing);
  }
  std::vector<Points2> placed;
  for (ArrangementPiece& piece : arrangement)
  {
    placed.push_back(std::move(piece.positions));
  }
  return placed;
}
}

void placePieces(const std::vector<WiredPiece>& pieces, const FlatteningOptions& options,
  std::vector<FlatPiece>& flat, FlatteningResult& result)
{
  const TriangleMesh& mesh = result.cut->mesh;
  const std::vector<Points2> placed = finalPositions(pieces, options, result, flat);
  result.positions.assign(mesh.vertexCount(), Point2::Zero());
  result.patchOfTriangle.assign(mesh.triangleCount(), none);
  Index firstPatch = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Piece& piece = pieces[p].piece;
    const WireNetwork& network = networkOf(pieces[p], flat[p]);
    for (std::size_t k = 0; k < piece.vertices.size(); ++k)
    {
      result.positions[piece.vertices[k]] = placed[p][k];
    }
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    {
      result.patchOfTriangle[piece.triangles[t]] = firstPatch + network.patchOfTriangle[t];
    }
    for (Index& patch : flat[p].report.warpingOrder)
    {
      patch += firstPatch;
    }
    firstPatch += network.patchCount;
    const std::vector<Wire> connectors = traceConnectors(network, piece, static_cast<Index>(p));
    result.wires.insert(result.wires.end(), connectors.begin(), connectors.end());
  }
}
}
