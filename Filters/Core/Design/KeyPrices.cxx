// SPDX-License-Identifier: BSD-3-Clause
#include "Design/KeyPrices.h"

#include "Base/Memory.h"
#include "Flattening/SurfaceFlattening.h"

#include <algorithm>

namespace flattening
{
namespace
{
KeyTrial trialOf(const FlatteningResult& flat)
{
  KeyTrial trial;
  trial.status = flat.status.code;
  if (flat.status.refused() || flat.pieces.empty())
  {
    return trial;
  }
  trial.areaError = 0.0;
  trial.strainP95 = 0.0;
  for (const PieceReport& piece : flat.pieces)
  {
    trial.areaError = std::max(trial.areaError, piece.quality.areaError);
    trial.strainP95 = std::max(trial.strainP95, piece.quality.strainP95);
  }
  for (std::size_t c = 0; c < flat.curves.size(); ++c)
  {
    if (flat.curves[c].released)
    {
      trial.released.push_back(static_cast<Index>(c));
    }
  }
  const auto broken = std::find_if(flat.pieces.begin(), flat.pieces.end(),
    [](const PieceReport& piece) { return !piece.status.ok(); });
  trial.status = broken == flat.pieces.end() ? StatusCode::Ok : broken->status.code;
  return trial;
}

class Pricing
{
public:
  Pricing(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
    const FlatteningOptions& options, const Execution& execution)
    : Mesh(mesh)
    , Curves(curves)
    , Options(options)
    , Run(execution)
  {
    this->Options.arrange = false;
    this->Options.tryReleases = false;
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      if (curves[c].type == CurveType::Key)
      {
        this->Keys.push_back(static_cast<Index>(c));
      }
    }
  }

  KeyPrices run()
  {
    KeyPrices prices;
    if (this->Keys.empty())
    {
      prices.status = { StatusCode::InvalidCurve, "there is no key curve that could have a price",
        {}, { { Remedy::Give, "at least one curve of type key" } } };
      return prices;
    }
    const FlatteningResult whole = this->flattened(this->Keys, this->Run.part(0.0, 0.1));
    if (whole.status.refused())
    {
      prices.status = whole.status;
      return prices;
    }
    prices.all = trialOf(whole);
    // Without each, each alone, none.
    std::vector<Indices> kept;
    for (const Index key : this->Keys)
    {
      kept.push_back(this->Keys);
      kept.back().erase(std::find(kept.back().begin(), kept.back().end(), key));
    }
    for (const Index key : this->Keys)
    {
      kept.push_back({ key });
    }
    kept.emplace_back();
    const std::vector<KeyTrial> trials = this->tryAll(kept);
    if (this->Run.cancelled())
    {
      prices.status = { StatusCode::Cancelled, "cancelled while trying key curves" };
      return prices;
    }
    const std::size_t count = this->Keys.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      prices.keys.push_back({ this->Keys[k], prices.all.areaError - trials[k].areaError, trials[k],
        trials[count + k] });
    }
    prices.none = trials.back();
    std::stable_sort(
      prices.keys.begin(), prices.keys.end(), [](const KeyPrice& a, const KeyPrice& b) {
        const std::size_t first = a.without.released.size();
        const std::size_t second = b.without.released.size();
        return first != second ? first < second : a.price > b.price;
      });
    return prices;
  }

private:
  FlatteningResult flattened(const Indices& kept, const Execution& execution) const
  {
    std::vector<FeatureCurve> curves = this->Curves;
    for (const Index key : this->Keys)
    {
      if (std::find(kept.begin(), kept.end(), key) == kept.end())
      {
        curves[key].type = CurveType::Accessory;
        curves[key].keyShape = KeyShape::Surface;
        curves[key].planarShape.clear();
      }
    }
    return flattenSurface(this->Mesh, curves, this->Options, execution);
  }

  /// With two keys "without A" is "B alone".
  std::vector<KeyTrial> tryAll(const std::vector<Indices>& kept) const
  {
    std::vector<Indices> distinct = kept;
    sortUnique(distinct);
    std::vector<KeyTrial> tried(distinct.size());
    const Execution inner = this->Run.nestedExecution();
    this->Run.forEachTask(static_cast<Index>(distinct.size()), [&](Index k) {
      tried[k] = inner.cancelled() ? KeyTrial() : trialOf(this->flattened(distinct[k], inner));
    });
    std::vector<KeyTrial> trials;
    for (const Indices& keys : kept)
    {
      const auto at = std::lower_bound(distinct.begin(), distinct.end(), keys);
      trials.push_back(tried[static_cast<std::size_t>(at - distinct.begin())]);
    }
    return trials;
  }

  const TriangleMesh& Mesh;
  const std::vector<FeatureCurve>& Curves;
  FlatteningOptions Options;
  const Execution& Run;
  Indices Keys;
};
}

KeyPrices priceKeys(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution)
{
  return withinMemory([&] { return Pricing(mesh, curves, options, execution).run(); });
}
}
