// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/SurfaceMeasuring.h"

#include "Flattening/PiecePromises.h"
#include "Flattening/WireReport.h"
#include "Quality/SurfaceDevelopability.h"

namespace flattening
{
namespace
{
/// Half-edges of the piece's wires whose length is promised, one an edge.
Indices rigidHalfedges(const WireNetwork& network, const std::vector<FeatureCurve>& curves)
{
  Indices edges;
  for (const WireEdge& edge : network.edges)
  {
    const bool elastic = edge.curve != none && curves[edge.curve].tolerance > 0.0;
    if (!edge.connector && !elastic)
    {
      edges.push_back(network.halfedge[edge.side]);
    }
  }
  return edges;
}

/// Values per element of a piece, to those of the cut surface.
template <class Value>
void scatter(const std::vector<Value>& values, const Indices& elements, std::vector<Value>& all)
{
  for (std::size_t k = 0; k < elements.size(); ++k)
  {
    all[elements[k]] = values[k];
  }
}

/// Each piece by itself: where pieces are not arranged they may well lie on each other.
BoundaryOverlaps overlapsOf(const Piece& piece, const Points2& positions)
{
  BoundaryOverlaps overlaps = countBoundaryOverlaps(piece.mesh, positions, mostListedOverlaps);
  const auto onCutSurface = [&piece](Index h) { return 3 * piece.triangles[h / 3] + h % 3; };
  for (auto& pair : overlaps.listed)
  {
    pair = { onCutSurface(pair[0]), onCutSurface(pair[1]) };
  }
  return overlaps;
}

void measurePiece(const std::vector<FeatureCurve>& curves, const Execution& execution, bool only,
  WiredPiece& wired, FlatPiece& flat, FlatteningResult& result)
{
  const Piece& piece = wired.piece;
  if (!wired.measures)
  {
    wired.measures = measureSurface(piece.mesh, execution);
  }
  scatter(surfaceDevelopability(piece.mesh, wired.measures->angles), piece.vertices,
    result.developability);
  Points2 positions;
  positions.reserve(piece.vertices.size());
  for (Index v : piece.vertices)
  {
    positions.push_back(result.positions[v]);
  }
  const Indices edges = rigidHalfedges(networkOf(wired, flat), curves);
  FlatteningQuality quality =
    measureFlattening(piece.mesh, *wired.measures, positions, edges, execution);
  if (only)
  {
    result.triangles = std::move(quality.triangles);
  }
  else
  {
    scatter(quality.triangles, piece.triangles, result.triangles);
  }
  for (Index& t : quality.summary.flipped)
  {
    t = piece.triangles[t];
  }
  flat.report.quality = std::move(quality.summary);
  flat.report.overlaps = overlapsOf(piece, positions);
}

/// What the report of a piece says of curves.
void addToCurves(const PieceReport& report, FlatteningResult& result)
{
  const CutSurface& cut = *result.cut;
  const std::vector<double>& sensitivity = report.advice.sensitivity;
  for (std::size_t c = 0; c < sensitivity.size(); ++c)
  {
    result.curves[c].sensitivity += sensitivity[c];
  }
  for (Index c : report.released)
  {
    result.curves[c].released = true;
  }
  for (Index h : report.closedEdges)
  {
    // Both banks are in the list.
    result.curves[cut.curveOfHalfedge[h]].closedLength += 0.5 * cut.mesh.length(h);
  }
  noteClosedEdges(cut.mesh, report.closedEdges, result.wires);
}
}

void measureResult(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, std::vector<WiredPiece>& pieces,
  std::vector<FlatPiece>& flat, FlatteningResult& result)
{
  const CutSurface& cut = *result.cut;
  const bool only = pieces.size() == 1;
  if (!only)
  {
    result.triangles.resize(cut.mesh.triangleCount());
  }
  result.developability.assign(cut.mesh.vertexCount(), 0.0);
  for (Wire& wire : result.wires)
  {
    measureWire(cut, result.positions, wire);
  }
  result.curves = summarizeCurves(mesh, cut, curves, result.wires);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    measurePiece(curves, execution, only, pieces[p], flat[p], result);
    addToCurves(flat[p].report, result);
  }
  for (FlatPiece& piece : flat)
  {
    result.pieces.push_back(std::move(piece.report));
    judgeLastPiece(cut, curves, options, result);
    const Status& status = result.pieces.back().status;
    if (severity(status.code) > severity(result.status.code))
    {
      result.status = status;
    }
  }
  measureCuts(cut, result.pieces);
}
}
