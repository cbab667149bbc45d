// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/SurfaceMeasuring.h"

#include "Flattening/PieceReports.h"
#include "Flattening/WireReport.h"
#include "Quality/SurfaceDevelopability.h"

#include <algorithm>
#include <map>

namespace flattening
{
namespace
{
/// Half-edges of the piece's wires whose length is promised, one an edge.
Indices rigidHalfedges(
  const WireNetwork& network, const std::vector<FeatureCurve>& curves, bool freeBoundary)
{
  Indices edges;
  for (const WireEdge& edge : network.edges)
  {
    const bool elastic = edge.curve != none && curves[edge.curve].tolerance > 0.0;
    if (holdsLength(edge, curves, freeBoundary) && !elastic)
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

/// Which triangles are out of limit, and the wire along which most of their area lies.
void noteLimits(const Piece& piece, const std::vector<TriangleFrame>& frames, ClothReport& report)
{
  std::map<Index, double> along; // by curve, none: the boundary
  for (std::size_t t = 0; t < piece.triangles.size(); ++t)
  {
    if (!report.threads.outOfLimit[t])
    {
      continue;
    }
    report.outOfLimit.push_back(piece.triangles[t]);
    for (Index h = 3 * static_cast<Index>(t); h < 3 * static_cast<Index>(t) + 3; ++h)
    {
      const Index curve = piece.curveOfHalfedge[h];
      if (curve != none || piece.mesh.twin(h) == none)
      {
        along[curve] += frames[t].area;
      }
    }
  }
  const auto most = std::max_element(
    along.begin(), along.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != along.end())
  {
    report.limitingCurve = most->first;
    report.limitedByBoundary = most->first == none;
  }
  if (report.threads.worstTriangle != none)
  {
    const Index worst = piece.triangles[report.threads.worstTriangle];
    const auto place = std::find(report.outOfLimit.begin(), report.outOfLimit.end(), worst);
    std::rotate(report.outOfLimit.begin(), place, place + 1);
  }
}

/// What the threads of a piece do, which lies on its cloth.
void measureCloth(const WiredPiece& wired, const Points2& positions, const ClothOptions& options,
  ClothReport& report, std::vector<ThreadStrain>& all)
{
  const Piece& piece = wired.piece;
  const std::vector<ThreadStrain> strains =
    measureThreads(wired.measures->frames, piece.mesh.triangles(), positions);
  scatter(strains, piece.triangles, all);
  report.threads = summarizeThreads(wired.measures->frames, strains, options.material);
  noteLimits(piece, wired.measures->frames, report);
}

void measurePiece(const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution, bool only, WiredPiece& wired, PieceSolution& flat,
  FlatteningResult& result)
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
  const Indices edges =
    rigidHalfedges(networkOf(wired, flat), curves, options.boundary == BoundaryMode::Free);
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
  if (flat.report.cloth)
  {
    measureCloth(wired, positions, *options.cloth, *flat.report.cloth, result.threads);
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
  std::vector<PieceSolution>& flat, FlatteningResult& result)
{
  const CutSurface& cut = *result.cut;
  const bool only = pieces.size() == 1;
  if (!only)
  {
    result.triangles.resize(cut.mesh.triangleCount());
  }
  if (options.cloth)
  {
    result.threads.resize(cut.mesh.triangleCount());
  }
  result.developability.assign(cut.mesh.vertexCount(), 0.0);
  for (Wire& wire : result.wires)
  {
    measureWire(cut, result.positions, wire);
  }
  result.curves = summarizeCurves(mesh, cut, curves, result.wires);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    measurePiece(curves, options, execution, only, pieces[p], flat[p], result);
    addToCurves(flat[p].report, result);
  }
  for (PieceSolution& piece : flat)
  {
    const auto p = static_cast<Index>(result.pieces.size());
    result.pieces.push_back(std::move(piece.report));
    judgePiece(cut, curves, options, p, result);
    const Status& status = result.pieces[p].status;
    if (severity(status.code) > severity(result.status.code))
    {
      result.status = status;
    }
  }
  measureCuts(cut, result.pieces);
}
}
