// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/SurfaceFlattening.h"

#include "Base/Memory.h"
#include "Base/Stopwatch.h"
#include "Flattening/ElasticSeams.h"
#include "Flattening/PieceArrangement.h"
#include "Flattening/PieceFlattening.h"
#include "Flattening/PiecePromises.h"
#include "Flattening/WireReport.h"
#include "Quality/SurfaceDevelopability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
Status checkOptions(const FlatteningOptions& options)
{
  struct Range
  {
    const char* name;
    double value;
    double most;
  };
  constexpr double large = std::numeric_limits<double>::max();
  for (const Range& range :
    { Range{ "closure tolerance", options.angles.closureTolerance, large },
      Range{ "optimality tolerance", options.angles.optimalityTolerance, large },
      Range{ "number of iterations", static_cast<double>(options.angles.maximumIterations), large },
      Range{ "number of isometric iterations",
        static_cast<double>(options.isometric.maximumIterations), large },
      Range{ "isometric tolerance", options.isometric.tolerance, large },
      Range{ "angle weight", options.isometric.angleWeight, 100.0 },
      Range{ "length tolerance", options.lengthTolerance, large },
      Range{ "spacing", options.spacing, 1e6 } })
  {
    if (!std::isfinite(range.value) || range.value < 0.0 || range.value > range.most)
    {
      return { StatusCode::InvalidOption,
        std::string("the ") + range.name + " is " + shortNumber(range.value), {},
        { { Remedy::Give,
          "a number from 0" +
            (range.most < large ? " to " + shortNumber(range.most) : std::string()) } } };
    }
  }
  return {};
}

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

/// The whole way, stage by stage.
class Flattening
{
public:
  Flattening(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
    const FlatteningOptions& options, const Execution& execution, FlatteningCache* cache)
    : Mesh(mesh)
    , Curves(curves)
    , Options(options)
    , Run(execution)
    , Keep(cache != nullptr)
    , Kept(cache ? *cache : this->Own)
  {
  }

  FlatteningResult run()
  {
    Stopwatch watch;
    Status valid = checkOptions(this->Options);
    if (!valid.ok())
    {
      return refusal(std::move(valid));
    }
    this->Run.report(0.0, "Cutting darts and seams");
    CurveLabels labels = labelHalfedges(this->Mesh, this->Curves);
    if (!labels.status.ok())
    {
      return refusal(std::move(labels.status));
    }
    if (!this->Keep || !this->Kept.serves(this->Mesh, labels, this->Options.skipClosed))
    {
      this->Kept.renew(this->Mesh, std::move(labels), this->Options.skipClosed, this->Keep);
    }
    if (!this->Kept.topology.ok())
    {
      return refusal(this->Kept.topology);
    }
    if (this->Run.cancelled())
    {
      return refusal(cancelled());
    }
    if (!this->flattenPieces())
    {
      return refusal(std::move(this->Result.status));
    }
    this->placePieces();
    Stopwatch qualityWatch;
    this->Run.report(0.9, "Measuring quality");
    if (this->Run.cancelled())
    {
      return refusal(cancelled());
    }
    this->measure();
    this->Result.cut = this->Kept.cut;
    this->Result.leftOut = this->Kept.leftOut;
    this->Result.seconds.quality = qualityWatch.seconds();
    this->Result.seconds.total = watch.seconds();
    this->Run.report(1.0, "Done");
    return std::move(this->Result);
  }

private:
  static Status cancelled() { return { StatusCode::Cancelled, "cancelled", {} }; }

  static FlatteningResult refusal(Status status)
  {
    FlatteningResult result;
    result.status = std::move(status);
    return result;
  }

  bool flattenPieces()
  {
    const double share = 0.8 / static_cast<double>(this->Kept.pieces.size());
    for (std::size_t p = 0; p < this->Kept.pieces.size(); ++p)
    {
      const double begin = 0.05 + share * static_cast<double>(p);
      if (!this->flattenPieceOf(p, {}, this->Run.part(begin, begin + share)))
      {
        return false;
      }
    }
    return this->agreeOnStretches();
  }

  bool flattenPieceOf(std::size_t p, const CurveRules& rules, const Execution& execution)
  {
    execution.report(0.0, "Flattening pieces");
    if (execution.cancelled())
    {
      this->Result.status = cancelled();
      return false;
    }
    this->Flat.resize(this->Kept.pieces.size());
    FlatPiece& flat = this->Flat[p];
    flat = flattenPiece(this->Kept.pieces[p],
      { *this->Kept.cut, this->Curves, this->Options, rules, this->Keep }, execution);
    this->Result.seconds.wires += flat.secondsWires;
    this->Result.seconds.interior += flat.secondsInterior;
    if (flat.report.status.refused())
    {
      this->Result.status = flat.report.status;
      return false;
    }
    return true;
  }

  /// Pieces that share elastic curves are flattened anew with common lengths.
  bool agreeOnStretches()
  {
    std::vector<CurveStretches> stretches;
    if (this->Options.scheme == Scheme::Conformal)
    {
      return true;
    }
    for (std::size_t p = 0; p < this->Flat.size(); ++p)
    {
      const Points2& positions = this->Flat[p].positions;
      stretches.push_back(stretchesIn(this->networkOf(p), positions, this->Curves));
    }
    CurveRules decided;
    decided.stretch = flattening::agreeOnStretches(stretches);
    for (std::size_t p = 0; p < this->Flat.size() && !decided.stretch.empty(); ++p)
    {
      bool shares = false;
      for (std::size_t c = 0; c < this->Curves.size(); ++c)
      {
        shares = shares || (decided.stretch[c] && stretches[p][c]);
      }
      if (shares && !this->flattenPieceOf(p, decided, this->Run.part(0.85, 0.85)))
      {
        return false;
      }
    }
    return true;
  }

  const WireNetwork& networkOf(std::size_t p) const
  {
    return this->Flat[p].joinedNetwork ? *this->Flat[p].joinedNetwork
                                       : *this->Kept.pieces[p].network;
  }

  void placePieces()
  {
    const CutSurface& cut = *this->Kept.cut;
    this->Result.wires = traceWires(this->Mesh, cut, this->Curves);
    std::vector<Points2> placed;
    if (this->Options.arrange)
    {
      std::vector<ArrangementPiece> arrangement(this->Kept.pieces.size());
      Indices local(cut.mesh.vertexCount(), none);
      for (std::size_t p = 0; p < this->Kept.pieces.size(); ++p)
      {
        for (std::size_t k = 0; k < this->Kept.pieces[p].piece.vertices.size(); ++k)
        {
          local[this->Kept.pieces[p].piece.vertices[k]] = static_cast<Index>(k);
        }
        arrangement[p].positions = std::move(this->Flat[p].positions);
        arrangement[p].grain = findGrain(this->Result.wires, static_cast<Index>(p), local);
      }
      placed = arrangePieces(arrangement, this->Options.spacing);
    }
    else
    {
      for (FlatPiece& flat : this->Flat)
      {
        placed.push_back(std::move(flat.positions));
      }
    }
    this->Result.positions.assign(cut.mesh.vertexCount(), Point2::Zero());
    this->Result.patchOfTriangle.assign(cut.mesh.triangleCount(), none);
    Index firstPatch = 0;
    for (std::size_t p = 0; p < this->Kept.pieces.size(); ++p)
    {
      const Piece& piece = this->Kept.pieces[p].piece;
      const WireNetwork& network = this->networkOf(p);
      for (std::size_t k = 0; k < piece.vertices.size(); ++k)
      {
        this->Result.positions[piece.vertices[k]] = placed[p][k];
      }
      for (std::size_t t = 0; t < piece.triangles.size(); ++t)
      {
        this->Result.patchOfTriangle[piece.triangles[t]] = firstPatch + network.patchOfTriangle[t];
      }
      for (Index& patch : this->Flat[p].report.warpingOrder)
      {
        patch += firstPatch;
      }
      firstPatch += network.patchCount;
      const std::vector<Wire> connectors = traceConnectors(network, piece, static_cast<Index>(p));
      this->Result.wires.insert(this->Result.wires.end(), connectors.begin(), connectors.end());
    }
  }

  void measure()
  {
    const CutSurface& cut = *this->Kept.cut;
    if (this->Kept.pieces.size() > 1)
    {
      this->Result.triangles.resize(cut.mesh.triangleCount());
    }
    this->Result.developability.assign(cut.mesh.vertexCount(), 0.0);
    for (Wire& wire : this->Result.wires)
    {
      measureWire(cut, this->Result.positions, wire);
    }
    this->Result.curves = summarizeCurves(this->Mesh, cut, this->Curves, this->Result.wires);
    for (std::size_t p = 0; p < this->Kept.pieces.size(); ++p)
    {
      this->measurePiece(p);
      const std::vector<double>& sensitivity = this->Flat[p].report.advice.sensitivity;
      for (std::size_t c = 0; c < sensitivity.size(); ++c)
      {
        this->Result.curves[c].sensitivity += sensitivity[c];
      }
      for (Index c : this->Flat[p].report.released)
      {
        this->Result.curves[c].released = true;
      }
      for (Index h : this->Flat[p].report.closedEdges)
      {
        // Both banks are in the list.
        this->Result.curves[cut.curveOfHalfedge[h]].closedLength += 0.5 * cut.mesh.length(h);
      }
      noteClosedEdges(cut.mesh, this->Flat[p].report.closedEdges, this->Result.wires);
    }
    for (FlatPiece& flat : this->Flat)
    {
      this->Result.pieces.push_back(std::move(flat.report));
      judgeLastPiece(cut, this->Curves, this->Options, this->Result);
      const Status& status = this->Result.pieces.back().status;
      if (severity(status.code) > severity(this->Result.status.code))
      {
        this->Result.status = status;
      }
    }
    measureCuts(cut, this->Result.pieces);
  }

  void measurePiece(std::size_t p)
  {
    WiredPiece& wired = this->Kept.pieces[p];
    const Piece& piece = wired.piece;
    if (!wired.measures)
    {
      wired.measures = measureSurface(piece.mesh, this->Run);
    }
    const std::vector<double> developability =
      surfaceDevelopability(piece.mesh, wired.measures->angles);
    for (std::size_t k = 0; k < piece.vertices.size(); ++k)
    {
      this->Result.developability[piece.vertices[k]] = developability[k];
    }
    Points2 positions;
    positions.reserve(piece.vertices.size());
    for (Index v : piece.vertices)
    {
      positions.push_back(this->Result.positions[v]);
    }
    const Indices edges = rigidHalfedges(this->networkOf(p), this->Curves);
    FlatteningQuality quality =
      measureFlattening(piece.mesh, *wired.measures, positions, edges, this->Run);
    if (this->Kept.pieces.size() == 1)
    {
      this->Result.triangles = std::move(quality.triangles);
    }
    else
    {
      for (std::size_t t = 0; t < piece.triangles.size(); ++t)
      {
        this->Result.triangles[piece.triangles[t]] = quality.triangles[t];
      }
    }
    for (Index& t : quality.summary.flipped)
    {
      t = piece.triangles[t];
    }
    this->Flat[p].report.quality = std::move(quality.summary);
    // Each piece by itself: where pieces are not arranged they may well lie on each other.
    BoundaryOverlaps& overlaps = this->Flat[p].report.overlaps;
    overlaps = countBoundaryOverlaps(piece.mesh, positions, mostListedOverlaps);
    for (auto& pair : overlaps.listed)
    {
      const auto halfedge = [&piece](Index h) { return 3 * piece.triangles[h / 3] + h % 3; };
      pair = { halfedge(pair[0]), halfedge(pair[1]) };
    }
  }

  const TriangleMesh& Mesh;
  const std::vector<FeatureCurve>& Curves;
  const FlatteningOptions& Options;
  const Execution& Run;
  const bool Keep;
  FlatteningCache Own;
  FlatteningCache& Kept;
  std::vector<FlatPiece> Flat;
  FlatteningResult Result;
};
}

FlatteningResult flattenSurface(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, FlatteningCache* cache)
{
  FlatteningResult result =
    withinMemory([&] { return Flattening(mesh, curves, options, execution, cache).run(); });
  if (result.status.code == StatusCode::OutOfMemory && cache)
  {
    *cache = {}; // it may hold the half of something
  }
  return result;
}
}
