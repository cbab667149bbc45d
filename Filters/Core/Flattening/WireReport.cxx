// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/WireReport.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Where the edges of a surface are after its cut.
class EdgeCopies
{
public:
  EdgeCopies(const TriangleMesh& original, const CutSurface& cut)
    : Original(original)
    , Cut(cut.mesh)
  {
    if (!cut.keptTriangles.empty())
    {
      this->TriangleOf.assign(original.triangleCount(), none);
    }
    for (std::size_t t = 0; t < cut.keptTriangles.size(); ++t)
    {
      this->TriangleOf[cut.keptTriangles[t]] = static_cast<Index>(t);
    }
  }

  /// The copies of one segment of a curve: one, or two where it was cut, or none where its piece
  /// was left out.
  std::vector<std::array<Index, 2>> of(Index from, Index to) const
  {
    std::vector<std::array<Index, 2>> copies;
    const Index forward = this->find(from, to);
    const Index backward = this->find(to, from);
    if (forward != none)
    {
      copies.push_back({ this->Cut.from(forward), this->Cut.to(forward) });
    }
    if (backward != none)
    {
      const std::array<Index, 2> copy{ this->Cut.to(backward), this->Cut.from(backward) };
      if (copies.empty() || copies.front() != copy)
      {
        copies.push_back(copy);
      }
    }
    return copies;
  }

private:
  /// The half-edge of the cut surface.
  Index find(Index from, Index to) const
  {
    const Index h = this->Original.find(from, to);
    if (h == none || this->TriangleOf.empty())
    {
      return h;
    }
    const Index triangle = this->TriangleOf[h / 3];
    return triangle == none ? none : 3 * triangle + h % 3;
  }

  const TriangleMesh& Original;
  const TriangleMesh& Cut;
  Indices TriangleOf; ///< by triangle before the cut; empty: all have kept their ids
};

Index pieceOfVertex(const CutSurface& cut, Index vertex)
{
  return cut.pieceOfTriangle[cut.mesh.outgoing(vertex) / 3];
}

void traceCurve(const EdgeCopies& copies, const CutSurface& cut, const FeatureCurve& curve,
  Index id, std::vector<Wire>& wires)
{
  std::vector<std::size_t> open; // wires that the next segment may go on
  for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k)
  {
    std::vector<std::size_t> stillOpen;
    for (const auto& copy : copies.of(curve.vertices[k], curve.vertices[k + 1]))
    {
      const auto goesOn = std::find_if(open.begin(), open.end(),
        [&](std::size_t w) { return wires[w].vertices.back() == copy[0]; });
      std::size_t at = wires.size();
      if (goesOn != open.end())
      {
        at = *goesOn;
        open.erase(goesOn);
      }
      else
      {
        Wire wire;
        wire.type = curve.type;
        wire.curve = id;
        wire.piece = pieceOfVertex(cut, copy[0]);
        wire.vertices.push_back(copy[0]);
        wires.push_back(std::move(wire));
      }
      wires[at].vertices.push_back(copy[1]);
      stillOpen.push_back(at);
    }
    open = std::move(stillOpen);
  }
}

void traceBoundary(const CutSurface& cut, std::vector<Wire>& wires)
{
  for (const Indices& loop : cut.mesh.boundaryLoops())
  {
    // Start where a stretch begins, so that none is met in two parts.
    std::size_t start = 0;
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      if (cut.curveOfHalfedge[loop[k]] != none)
      {
        start = k + 1;
        break;
      }
    }
    bool going = false;
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const Index h = loop[(start + k) % loop.size()];
      if (cut.curveOfHalfedge[h] != none)
      {
        going = false;
        continue;
      }
      if (!going)
      {
        Wire wire;
        wire.piece = cut.pieceOfTriangle[h / 3];
        wire.vertices.push_back(cut.mesh.from(h));
        wires.push_back(std::move(wire));
        going = true;
      }
      wires.back().vertices.push_back(cut.mesh.to(h));
    }
  }
}

/// Whether it bounds its piece, and its length.
void completeWire(const TriangleMesh& cut, Wire& wire)
{
  wire.boundary = true;
  forEachEdge(wire.vertices, [&](Index a, Index b) {
    wire.boundary = wire.boundary && (cut.find(a, b) == none || cut.find(b, a) == none);
    wire.restLength += (cut.point(b) - cut.point(a)).norm();
  });
}
}

std::vector<Wire> traceWires(
  const TriangleMesh& original, const CutSurface& cut, const std::vector<FeatureCurve>& curves)
{
  std::vector<Wire> wires;
  const EdgeCopies copies(original, cut);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    traceCurve(copies, cut, curves[c], static_cast<Index>(c), wires);
  }
  traceBoundary(cut, wires);
  for (Wire& wire : wires)
  {
    completeWire(cut.mesh, wire);
  }
  return wires;
}

void noteClosedEdges(const TriangleMesh& cut, const Indices& closedEdges, std::vector<Wire>& wires)
{
  const auto isClosed = [&](Index halfedge) {
    return halfedge != none && std::binary_search(closedEdges.begin(), closedEdges.end(), halfedge);
  };
  if (closedEdges.empty())
  {
    return;
  }
  for (Wire& wire : wires)
  {
    forEachEdge(wire.vertices, [&](Index a, Index b) {
      wire.boundary = wire.boundary && !isClosed(cut.find(a, b)) && !isClosed(cut.find(b, a));
    });
  }
}

std::vector<Wire> traceConnectors(const WireNetwork& network, const Piece& piece, Index pieceId)
{
  std::vector<Wire> wires;
  for (const WireEdge& edge : network.edges)
  {
    if (!edge.connector)
    {
      continue;
    }
    Wire wire;
    wire.connector = true;
    wire.piece = pieceId;
    wire.vertices = { piece.vertices[edge.from], piece.vertices[edge.to] };
    wires.push_back(std::move(wire));
  }
  return wires;
}

void measureWire(const CutSurface& cut, const Points2& positions, Wire& wire)
{
  wire.restLength = wire.flatLength = wire.maximumEdgeError = wire.resolvedEdgeError = 0.0;
  forEachEdge(wire.vertices, [&](Index a, Index b) {
    const EdgeLengthError error = edgeLengthError(cut.mesh, positions, a, b);
    wire.restLength += (cut.mesh.point(b) - cut.mesh.point(a)).norm();
    wire.flatLength += (positions[b] - positions[a]).norm();
    wire.maximumEdgeError = std::max(wire.maximumEdgeError, error.measured);
    wire.resolvedEdgeError = std::max(wire.resolvedEdgeError, error.resolved);
  });
}

void measureCuts(const CutSurface& cut, std::vector<PieceReport>& pieces)
{
  for (const SeamPair& pair : cut.seamPairs)
  {
    PieceReport& one = pieces[cut.pieceOfTriangle[pair.first / 3]];
    PieceReport& other = pieces[cut.pieceOfTriangle[pair.second / 3]];
    // Only cuts within a piece are ever closed.
    const Indices& closed = one.closedEdges;
    if (!std::binary_search(closed.begin(), closed.end(), pair.first))
    {
      const double length = cut.mesh.length(pair.first);
      one.cutLength += length;
      other.cutLength += &other == &one ? 0.0 : length;
    }
  }
}

std::vector<CurveReport> summarizeCurves(const TriangleMesh& original, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const std::vector<Wire>& wires)
{
  std::vector<CurveReport> reports(curves.size());
  for (const Wire& wire : wires)
  {
    if (wire.curve != none)
    {
      reports[wire.curve].restLength += wire.restLength;
      reports[wire.curve].flatLength += wire.flatLength;
      reports[wire.curve].error = std::max(reports[wire.curve].error, wire.maximumEdgeError);
    }
  }
  const EdgeCopies copies(original, cut);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    CurveReport& report = reports[c];
    report.name = curves[c].name;
    report.type = curves[c].type;
    report.tolerance = curves[c].tolerance;
    double length = 0.0;
    forEachEdge(curves[c].vertices, [&](Index a, Index b) {
      if (cut.keptTriangles.empty() || !copies.of(a, b).empty())
      {
        length += (original.point(b) - original.point(a)).norm();
      }
    });
    if (report.restLength > 0.0)
    {
      // Both sides of a cut are wires, but the curve is one.
      report.flatLength *= length / report.restLength;
      report.restLength = length;
    }
  }
  return reports;
}
}
