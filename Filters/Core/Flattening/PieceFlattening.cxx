// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceFlattening.h"

#include "Base/Stopwatch.h"
#include "Cut/CutClosure.h"
#include "Flattening/DartFolding.h"
#include "Flattening/PieceReporting.h"
#include "Flattening/ReleaseTrials.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// A piece with banks of its cuts joined, flattened.
struct ClosedPiece
{
  std::unique_ptr<WiredPiece> wired = std::make_unique<WiredPiece>(); ///< solutions refer to it
  Indices place; ///< per vertex of the piece before, its vertex now
  FlatWires flat;
  Indices freeDarts; ///< FoldedWires::free
  Indices edges;     ///< half-edges of the closed banks
};

PieceContext contextOf(
  WiredPiece& wired, const PieceSettings& settings, const Execution& execution, bool keep)
{
  if (!wired.network)
  {
    wired.network = buildWireNetwork(wired.piece, wired.disk);
  }
  // A conformal map keeps no length that would want room, and a start says that there is some.
  const bool wanted =
    settings.options.start.empty() && settings.options.scheme != Scheme::LeastSquaresConformal;
  if (wanted && !(wired.area && wired.area->known))
  {
    wired.area = forecastArea(wired.piece.mesh, execution);
  }
  return { wired.piece, *wired.network, settings.cut, settings.curves, settings.options, execution,
    keep ? &wired.interiors : nullptr, wanted ? &*wired.area : nullptr };
}

/// Positions per vertex of the piece before its cuts were closed.
Points2 spread(const ClosedPiece& closed)
{
  Points2 positions;
  for (Index v : closed.place)
  {
    positions.push_back(closed.flat.placed.positions[v]);
  }
  return positions;
}

/// Flattens the piece with more and more of its cuts closed, until none cross. Without a value
/// where there is nothing to close, or closing does not help.
std::optional<ClosedPiece> closeCuts(const PieceContext& context, const PieceSettings& settings,
  const FlatWires& open, FlatPiece& result)
{
  const Index flipped = countFlipped(context.piece.mesh, open.placed.positions);
  const Execution execution = context.execution.part(1.0, 1.0);
  std::optional<ClosedPiece> closed;
  CutClosing closing(context.piece, context.cut);
  Points2 positions = open.placed.positions;
  const Indices* joined = closing.next(&positions);
  while (joined)
  {
    JoinedPiece joinedPiece = joinVertices(context.piece, *joined);
    closed.emplace();
    closed->place = std::move(joinedPiece.place);
    closed->wired->piece = std::move(joinedPiece.piece);
    const PieceContext inner = contextOf(*closed->wired, settings, execution, false);
    FoldedWires folded = flattenWithFoldingDarts(inner, settings.rules);
    closed->flat = std::move(folded.flat);
    closed->freeDarts = std::move(folded.free);
    result.secondsWires += closed->flat.secondsWires;
    result.secondsInterior += closed->flat.secondsInterior;
    const Status& status = closed->flat.status;
    if (status.code == StatusCode::Cancelled)
    {
      return closed;
    }
    const bool good = (status.ok() || status.code == open.status.code) &&
      countFlipped(inner.piece.mesh, closed->flat.placed.positions) <= flipped;
    positions = good ? spread(*closed) : Points2();
    joined = closing.next(good ? &positions : nullptr);
  }
  if (!closed || !closing.closed())
  {
    return std::nullopt;
  }
  closed->edges = closing.closedEdges();
  return closed->edges.empty() ? std::nullopt : std::move(closed);
}

/// The network of a closed piece with edges between vertices of the piece before.
WireNetwork networkBefore(const ClosedPiece& closed)
{
  Indices vertexOf(closed.wired->piece.vertices.size());
  for (std::size_t v = 0; v < closed.place.size(); ++v)
  {
    vertexOf[closed.place[v]] = static_cast<Index>(v);
  }
  WireNetwork network = *closed.wired->network;
  for (WireEdge& edge : network.edges)
  {
    edge.from = vertexOf[edge.from];
    edge.to = vertexOf[edge.to];
  }
  return network;
}

/// Half-edges of the piece as those of the cut surface, ascending.
Indices onCutSurface(const Piece& piece, const Indices& edges)
{
  Indices all;
  for (Index h : edges)
  {
    all.push_back(3 * piece.triangles[h / 3] + h % 3);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void finish(
  const PieceContext& context, const FlatWires& flat, const Indices& freeDarts, FlatPiece& result)
{
  result.report = reportPiece(context, flat);
  if (!freeDarts.empty())
  {
    result.report.fallbacks.push_back("darts whose legs cannot be made to fold on each other keep "
                                      "free ones: " +
      quotedNames(context.curves, freeDarts));
  }
  Stopwatch watch;
  result.report.advice = adviseByTrials(context, flat);
  result.secondsWires += watch.seconds();
}
}

FlatPiece flattenPiece(WiredPiece& wired, const PieceSettings& settings, const Execution& execution)
{
  const PieceContext context = contextOf(wired, settings, execution, settings.keep);
  FoldedWires folded = flattenWithFoldingDarts(context, settings.rules);
  FlatWires& flat = folded.flat;
  FlatPiece result;
  result.secondsWires = flat.secondsWires;
  result.secondsInterior = flat.secondsInterior;
  std::optional<ClosedPiece> closed;
  if (settings.options.closeCuts && !flat.status.refused())
  {
    closed = closeCuts(context, settings, flat, result);
  }
  if (!closed)
  {
    finish(context, flat, folded.free, result);
    result.positions = std::move(flat.placed.positions);
    return result;
  }
  if (closed->flat.status.refused())
  {
    result.report.status = closed->flat.status;
    return result;
  }
  finish(
    contextOf(*closed->wired, settings, execution, false), closed->flat, closed->freeDarts, result);
  result.report.vertices = wired.piece.mesh.vertexCount();
  result.report.closedEdges = onCutSurface(wired.piece, closed->edges);
  result.positions = spread(*closed);
  result.joinedNetwork = networkBefore(*closed);
  return result;
}
}
