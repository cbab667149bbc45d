// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/SurfaceFlattening.h"

#include "Base/Memory.h"
#include "Base/Stopwatch.h"
#include "Flattening/ElasticSeams.h"
#include "Flattening/OptionChecks.h"
#include "Flattening/PieceFlattening.h"
#include "Flattening/SurfaceMeasuring.h"
#include "Flattening/SurfacePlacement.h"
#include "Flattening/WireReport.h"

namespace flattening
{
namespace
{
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
    if (!this->Keep || !this->Kept.isValidFor(this->Mesh, labels, this->Options.skipClosed))
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
    this->Result.cut = this->Kept.cut;
    this->Result.leftOut = this->Kept.leftOut;
    this->Result.wires = traceWires(this->Mesh, *this->Kept.cut, this->Curves);
    placePieces(this->Kept.pieces, this->Options, this->Flat, this->Result);
    Stopwatch qualityWatch;
    this->Run.report(0.9, "Measuring quality");
    if (this->Run.cancelled())
    {
      return refusal(cancelled());
    }
    measureResult(this->Mesh, this->Curves, this->Options, this->Run, this->Kept.pieces, this->Flat,
      this->Result);
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
    std::vector<const Piece*> pieces;
    for (const WiredPiece& wired : this->Kept.pieces)
    {
      pieces.push_back(&wired.piece);
    }
    this->Result.status =
      decideEases(this->Options.eases, this->Curves, *this->Kept.cut, pieces, this->Eased);
    if (!this->Result.status.ok())
    {
      return false;
    }
    const double share = 0.8 / static_cast<double>(this->Kept.pieces.size());
    for (std::size_t p = 0; p < this->Kept.pieces.size(); ++p)
    {
      const double begin = 0.05 + share * static_cast<double>(p);
      if (!this->flattenPieceOf(p, this->rulesOf(p, {}), this->Run.part(begin, begin + share)))
      {
        return false;
      }
    }
    return this->agreeOnStretches();
  }

  /// Stretches that are decided, and those of its eased curves.
  CurveRules rulesOf(std::size_t p, std::vector<std::optional<double>> decided) const
  {
    CurveRules rules;
    rules.stretch = std::move(decided);
    for (std::size_t c = 0; !this->Eased.empty() && c < this->Curves.size(); ++c)
    {
      rules.stretch.resize(this->Curves.size());
      if (this->Eased[p][c])
      {
        rules.stretch[c] = this->Eased[p][c];
      }
    }
    return rules;
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
    if (this->Options.scheme == Scheme::LeastSquaresConformal)
    {
      return true;
    }
    for (std::size_t p = 0; p < this->Flat.size(); ++p)
    {
      const Points2& positions = this->Flat[p].positions;
      stretches.push_back(
        stretchesIn(networkOf(this->Kept.pieces[p], this->Flat[p]), positions, this->Curves));
    }
    for (std::size_t p = 0; p < this->Eased.size(); ++p)
    {
      for (std::size_t c = 0; c < this->Curves.size(); ++c)
      {
        if (this->Eased[p][c])
        {
          stretches[p][c].reset(); // decided already
        }
      }
    }
    const CurveStretches decided = flattening::agreeOnStretches(stretches);
    for (std::size_t p = 0; p < this->Flat.size() && !decided.empty(); ++p)
    {
      bool shares = false;
      for (std::size_t c = 0; c < this->Curves.size(); ++c)
      {
        shares = shares || (decided[c] && stretches[p][c]);
      }
      if (shares && !this->flattenPieceOf(p, this->rulesOf(p, decided), this->Run.part(0.85, 0.85)))
      {
        return false;
      }
    }
    return true;
  }

  const TriangleMesh& Mesh;
  const std::vector<FeatureCurve>& Curves;
  const FlatteningOptions& Options;
  const Execution& Run;
  const bool Keep;
  FlatteningCache Own;
  FlatteningCache& Kept;
  std::vector<FlatPiece> Flat;
  PieceStretches Eased;
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
