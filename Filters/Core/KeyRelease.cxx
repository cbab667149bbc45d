// SPDX-License-Identifier: BSD-3-Clause
#include "KeyRelease.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// Sets of more curves than this are not searched; then all are released.
constexpr std::size_t largestSearchedSet = 2;

/// Key curves with an edge in the network.
Indices keyCurves(const WireNetwork& network, const std::vector<FeatureCurve>& curves)
{
  Indices keys;
  for (const WireEdge& edge : network.edges)
  {
    if (edge.curve != none && curves[edge.curve].type == CurveType::Key)
    {
      keys.push_back(edge.curve);
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// All sets of a given size.
std::vector<Indices> subsets(const Indices& all, std::size_t size)
{
  std::vector<Indices> result;
  std::vector<char> chosen(all.size(), 0);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(size), 1);
  do
  {
    Indices set;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (chosen[i])
      {
        set.push_back(all[i]);
      }
    }
    result.push_back(std::move(set));
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return result;
}
}

KeyRelease releaseKeys(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& failed,
  const std::function<AngleSolution(const NodeLocks&)>& solve)
{
  const Indices keys = keyCurves(network, curves);
  auto locksWithout = [&](const Indices& released) {
    std::vector<FeatureCurve> changed = curves;
    for (Index c : released)
    {
      changed[c].type = CurveType::Accessory;
    }
    return lockKeyCurves(network, piece, cut, changed);
  };
  KeyRelease result;
  result.solution = failed;
  result.status = failed.status;
  result.locks = locksWithout({});
  if (failed.status.code == StatusCode::IncompatibleKeys)
  {
    result.status.ids = keys;
  }
  for (std::size_t size = 1; size <= keys.size(); ++size)
  {
    if (size > largestSearchedSet)
    {
      size = keys.size();
    }
    for (const Indices& set : subsets(keys, size))
    {
      AngleSolution solution = solve(locksWithout(set));
      if (solution.status.code == StatusCode::Cancelled)
      {
        result.solution = std::move(solution);
        result.status = result.solution.status;
        return result;
      }
      const bool better = result.released.empty() || solution.objective < result.solution.objective;
      if (solution.status.ok() && better)
      {
        result.solution = std::move(solution);
        result.released = set;
      }
    }
    if (!result.released.empty())
    {
      result.locks = locksWithout(result.released);
      result.status = { StatusCode::IncompatibleKeys,
        "the key curves " + quotedNames(curves, keys) +
          " cannot keep their planar shapes together; release " +
          quotedNames(curves, result.released) +
          " into accessory curves (done here for a usable result)",
        result.released };
      return result;
    }
  }
  return result;
}
}
