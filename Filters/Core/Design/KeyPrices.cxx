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

/// The flattening that keeps the shapes of some keys alone.
FlatteningResult flattened(const TriangleMesh& mesh, std::vector<FeatureCurve> curves,
  const Indices& kept, const FlatteningOptions& options, const Execution& execution)
{
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (curves[c].type == CurveType::Key &&
      std::find(kept.begin(), kept.end(), static_cast<Index>(c)) == kept.end())
    {
      curves[c].type = CurveType::Accessory;
      curves[c].keyShape = KeyShape::Surface;
      curves[c].planarShape.clear();
    }
  }
  return flattenSurface(mesh, curves, options, execution);
}

KeyPrices pricesOf(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  FlatteningOptions options, const Execution& execution)
{
  KeyPrices prices;
  options.arrange = false;
  options.tryReleases = false;
  Indices keys;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (curves[c].type == CurveType::Key)
    {
      keys.push_back(static_cast<Index>(c));
    }
  }
  if (keys.empty())
  {
    prices.status = { StatusCode::InvalidCurve, "there is no key curve that could have a price", {},
      { { Remedy::Give, "at least one curve of type key" } } };
    return prices;
  }
  const FlatteningResult whole = flattened(mesh, curves, keys, options, execution.part(0.0, 0.1));
  if (whole.status.refused())
  {
    prices.status = whole.status;
    return prices;
  }
  prices.all = trialOf(whole);
  // Without each, each alone, none.
  std::vector<Indices> kept;
  for (const Index key : keys)
  {
    kept.push_back(keys);
    kept.back().erase(std::find(kept.back().begin(), kept.back().end(), key));
  }
  for (const Index key : keys)
  {
    kept.push_back({ key });
  }
  kept.emplace_back();
  // With two keys "without A" is "B alone".
  std::vector<Indices> distinct = kept;
  sortUnique(distinct);
  std::vector<KeyTrial> tried(distinct.size());
  const Execution inner = execution.nestedExecution();
  execution.forEachTask(static_cast<Index>(distinct.size()), [&](Index k) {
    tried[k] = inner.cancelled() ? KeyTrial()
                                 : trialOf(flattened(mesh, curves, distinct[k], options, inner));
  });
  if (execution.cancelled())
  {
    prices.status = { StatusCode::Cancelled, "cancelled while trying key curves" };
    return prices;
  }
  const auto trialWith = [&](const Indices& some) {
    return tried[std::lower_bound(distinct.begin(), distinct.end(), some) - distinct.begin()];
  };
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    const KeyTrial without = trialWith(kept[k]);
    prices.keys.push_back({ keys[k], prices.all.areaError - without.areaError, without,
      trialWith(kept[keys.size() + k]) });
  }
  prices.none = trialWith(kept.back());
  std::stable_sort(
    prices.keys.begin(), prices.keys.end(), [](const KeyPrice& a, const KeyPrice& b) {
      const std::size_t first = a.without.released.size();
      const std::size_t second = b.without.released.size();
      return first != second ? first < second : a.price > b.price;
    });
  return prices;
}
}

KeyPrices priceKeys(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution)
{
  return withinMemory([&] { return pricesOf(mesh, curves, options, execution); });
}
}
