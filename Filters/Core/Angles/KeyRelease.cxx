// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/KeyRelease.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

namespace flattening
{
namespace
{
/// The search for a least set ends after so many solutions; those are few where few keys clash.
constexpr std::size_t mostSolves = 100;
/// Of several least sets so many are compared by their objective.
constexpr std::size_t mostCompared = 32;

Indices without(const Indices& all, const Indices& left)
{
  Indices rest;
  std::set_difference(all.begin(), all.end(), left.begin(), left.end(), std::back_inserter(rest));
  return rest;
}

Indices joined(const Indices& a, const Indices& b)
{
  Indices all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

/// The halves of a set.
std::array<Indices, 2> halves(const Indices& all)
{
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  return { Indices(all.begin(), middle), Indices(middle, all.end()) };
}

/// Sets of so many curves with one of each conflict.
void hitConflicts(const std::vector<Indices>& conflicts, std::size_t size, const Indices& chosen,
  std::set<Indices>& found)
{
  const auto open = std::find_if(conflicts.begin(), conflicts.end(), [&](const Indices& conflict) {
    return std::none_of(conflict.begin(), conflict.end(),
      [&](Index c) { return std::binary_search(chosen.begin(), chosen.end(), c); });
  });
  if (open == conflicts.end())
  {
    found.insert(chosen);
    return;
  }
  for (std::size_t k = 0; size > 0 && k < open->size() && found.size() < mostCompared; ++k)
  {
    hitConflicts(conflicts, size - 1, joined(chosen, { (*open)[k] }), found);
  }
}

/// Least sets with one curve of each conflict.
std::set<Indices> leastSets(const std::vector<Indices>& conflicts)
{
  std::set<Indices> found;
  for (std::size_t size = 0; found.empty(); ++size)
  {
    hitConflicts(conflicts, size, {}, found);
  }
  return found;
}

/// Looks for keys to release. A conflict is a set of keys that cannot be kept together, though each
/// smaller part of it can; a set whose release helps has one key of each. So the search goes from
/// one conflict to the next, and does not depend on how many keys there are beside them.
class KeySearch
{
public:
  using Try = std::function<AngleSolution(const Indices& released)>;

  KeySearch(Indices keys, Try attempt)
    : Keys(std::move(keys))
    , Attempt(std::move(attempt))
  {
    this->Tried[{}] = -1.0; // why the search began
  }

  /// \return the keys to release, empty where no release helps or the run was cancelled
  Indices run()
  {
    if (this->Keys.empty() || !this->works(this->Keys))
    {
      return {};
    }
    while (!this->Cancelled && this->Tried.size() <= mostSolves)
    {
      Indices found = this->tryLeastSets();
      if (!found.empty())
      {
        return found;
      }
    }
    return this->Cancelled ? Indices() : this->keepWhatCanBe();
  }

  bool cancelled() const { return this->Cancelled; }
  /// Keys that cannot be kept together with others, as far as they are known.
  Indices concerned() const
  {
    Indices all;
    for (const Indices& conflict : this->Conflicts)
    {
      all = joined(all, conflict);
    }
    return all;
  }

private:
  /// Whether there is a solution without these keys.
  bool works(const Indices& released)
  {
    const auto known = this->Tried.find(released);
    if (known != this->Tried.end() || this->Cancelled)
    {
      return !this->Cancelled && known->second >= 0.0;
    }
    const AngleSolution solution = this->Attempt(released);
    this->Cancelled = solution.status.code == StatusCode::Cancelled;
    this->Tried[released] = solution.status.ok() ? std::max(0.0, solution.objective) : -1.0;
    return solution.status.ok();
  }

  bool agree(const Indices& kept) { return this->works(without(this->Keys, kept)); }

  /// Of the least sets that the known conflicts allow the one with the least objective; empty, and
  /// a conflict more, where none of them helps.
  Indices tryLeastSets()
  {
    Indices best;
    for (const Indices& set : leastSets(this->Conflicts))
    {
      const bool helps = this->works(set);
      if (helps && (best.empty() || this->Tried[set] < this->Tried[best]))
      {
        best = set;
      }
      if (!helps && best.empty())
      {
        const Indices kept = without(this->Keys, set);
        this->Conflicts.push_back(this->conflictIn({}, false, kept));
        break;
      }
    }
    return best;
  }

  /// A least part of `among` that cannot be kept beside `base` (QuickXplain).
  Indices conflictIn(const Indices& base, bool grown, const Indices& among)
  {
    if (grown && !this->agree(base))
    {
      return {};
    }
    if (among.size() == 1)
    {
      return among;
    }
    const std::array<Indices, 2> half = halves(among);
    const Indices second = this->conflictIn(joined(base, half[0]), true, half[1]);
    const Indices first = this->conflictIn(joined(base, second), !second.empty(), half[0]);
    return joined(first, second);
  }

  /// Takes keys back, many at a time, until none of the others can be kept.
  Indices keepWhatCanBe()
  {
    Indices kept;
    std::vector<Indices> open{ this->Keys };
    while (!open.empty() && !this->Cancelled)
    {
      const Indices next = std::move(open.back());
      open.pop_back();
      if (this->agree(joined(kept, next)))
      {
        kept = joined(kept, next);
      }
      else if (next.size() > 1)
      {
        const std::array<Indices, 2> half = halves(next);
        open.push_back(half[1]);
        open.push_back(half[0]);
      }
    }
    return this->Cancelled ? Indices() : without(this->Keys, kept);
  }

  Indices Keys;
  Try Attempt;
  std::map<Indices, double> Tried; ///< objective by set of released keys, -1 where that fails
  std::vector<Indices> Conflicts;
  bool Cancelled = false;
};
}

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

namespace
{
std::string describe(const std::vector<FeatureCurve>& curves, const Indices& keys,
  const Indices& clashing, const Indices& released)
{
  constexpr std::size_t most = 5;
  const Indices kept = without(keys, released);
  std::string text = clashing.size() == 1
    ? "the key curve " + quotedNames(curves, clashing) + " cannot keep its planar shape"
    : "the key curves " + quotedNames(curves, clashing) +
      " cannot keep their planar shapes together";
  text += "; release " + quotedNames(curves, released) +
    " into accessory curves (done here for a usable result";
  if (!kept.empty())
  {
    text += kept.size() > most ? "; the other " + std::to_string(kept.size()) + " keep their shapes"
                               : "; kept: " + quotedNames(curves, kept);
  }
  return text + ")";
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
  KeySearch search(keys, [&](const Indices& released) { return solve(locksWithout(released)); });
  KeyRelease result;
  result.released = search.run();
  result.locks = locksWithout(result.released);
  if (search.cancelled())
  {
    result.solution.status = { StatusCode::Cancelled, "cancelled", {} };
    result.status = result.solution.status;
  }
  else if (result.released.empty())
  {
    result.solution = failed;
    result.status = failed.status;
    if (failed.status.code == StatusCode::IncompatibleKeys)
    {
      result.status.ids = keys;
    }
  }
  else
  {
    result.solution = solve(result.locks);
    result.status = { StatusCode::IncompatibleKeys,
      describe(curves, keys, joined(search.concerned(), result.released), result.released),
      result.released };
  }
  return result;
}
}
