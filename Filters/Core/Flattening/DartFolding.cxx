// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/DartFolding.h"

#include "Base/Types.h"
#include "Quality/FlatteningQuality.h"
#include "Wires/DartBanks.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
class DartFolding
{
public:
  DartFolding(const PieceContext& context, const CurveRules& rules)
    : Context(context)
    , Rules(rules)
    , Banks(findDartBanks(context.network, context.piece, context.cut, context.curves))
  {
  }

  FoldedWires run()
  {
    FoldedWires result;
    result.flat = flattenWires(this->Context, this->Rules);
    if (this->Banks.empty() || result.flat.status.refused() || result.flat.placed.positions.empty())
    {
      return result;
    }
    this->findTurns(result.flat.placed.positions, result.free);
    Indices folding;
    for (std::size_t c = 0; c < this->Turns.size(); ++c)
    {
      if (!this->Turns[c].empty())
      {
        folding.push_back(static_cast<Index>(c));
      }
    }
    if (folding.empty() || this->fold(folding, result.flat))
    {
      return result;
    }
    Indices folded;
    for (const Index dart : folding)
    {
      folded.push_back(dart);
      const bool alone = folding.size() == 1; // tried already
      if (alone || this->Context.execution.cancelled() || !this->fold(folded, result.flat))
      {
        folded.pop_back();
        result.free.push_back(dart);
      }
    }
    std::sort(result.free.begin(), result.free.end());
    return result;
  }

private:
  /// The legs' turning angles from the piece with free legs.
  void findTurns(const Points2& positions, Indices& branching)
  {
    const auto curves = this->Context.curves.size();
    std::vector<Points2> sums(curves); // of the left and the right bank
    std::vector<Index> found(curves, 0);
    std::vector<char> aroundHole(curves, 0);
    for (const DartBankVertex& bank : this->Banks)
    {
      const auto c = static_cast<std::size_t>(bank.curve);
      const Point2& at = positions[this->Context.network.hostVertices[bank.host]];
      const Point2 in = at - positions[bank.before];
      const Point2 out = positions[bank.after] - at;
      sums[c].resize(this->Context.curves[c].vertices.size(), Point2::Zero());
      sums[c][bank.place][bank.onLeft ? 0 : 1] = std::atan2(cross(in, out), in.dot(out));
      ++found[c];
      aroundHole[c] = aroundHole[c] || this->Context.network.interior[bank.host];
    }
    this->Turns.resize(curves);
    for (std::size_t c = 0; c < curves; ++c)
    {
      const auto inner = static_cast<Index>(this->Context.curves[c].vertices.size()) - 2;
      if (found[c] == 0)
      {
        continue;
      }
      if (found[c] != 2 * inner)
      {
        branching.push_back(static_cast<Index>(c));
        continue;
      }
      const bool straight = this->Context.options.dartLegs == DartLegs::Straight && !aroundHole[c];
      for (const Point2& both : sums[c])
      {
        this->Turns[c].push_back(straight ? 0.0 : both.sum() / 2.0);
      }
    }
  }

  /// Whether a piece with these darts folding is as good as the one with free legs, which it then
  /// replaces.
  bool fold(const Indices& darts, FlatWires& flat) const
  {
    CurveRules rules = this->Rules;
    rules.legTurns.resize(this->Context.curves.size());
    for (const Index dart : darts)
    {
      rules.legTurns[dart] = this->Turns[dart];
    }
    FlatWires folded = flattenWires(this->Context, rules);
    const TriangleMesh& mesh = this->Context.piece.mesh;
    const bool good = !folded.status.refused() && !folded.placed.positions.empty() &&
      (folded.status.ok() || folded.status.code == flat.status.code) &&
      folded.wires.rules.released.size() <= flat.wires.rules.released.size() &&
      countFlipped(mesh, folded.placed.positions) <= countFlipped(mesh, flat.placed.positions);
    folded.secondsWires += flat.secondsWires;
    folded.secondsInterior += flat.secondsInterior;
    if (good)
    {
      flat = std::move(folded);
    }
    return good;
  }

  const PieceContext& Context;
  const CurveRules& Rules;
  const std::vector<DartBankVertex> Banks;
  std::vector<std::vector<double>> Turns; ///< as in CurveRules
};
}

FoldedWires flattenWithFoldingDarts(const PieceContext& context, const CurveRules& rules)
{
  const bool free = context.options.dartLegs == DartLegs::Free ||
    context.options.scheme == Scheme::LeastSquaresConformal || context.network.status.refused();
  if (free)
  {
    return { flattenWires(context, rules), {} };
  }
  return DartFolding(context, rules).run();
}
}
