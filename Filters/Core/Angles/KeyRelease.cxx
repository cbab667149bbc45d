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
/// The search for a least set ends after this many solutions; those are few where few keys clash.
constexpr std::size_t maxSolves = 100;
/// Of several least sets this many are compared by their objective.
constexpr std::size_t maxCompared = 32;

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

/// Sets of a size with one of each conflict.
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
  for (std::size_t k = 0; size > 0 && k < open->size() && found.size() < maxCompared; ++k)
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

class ReleaseSearch
{
public:
  ReleaseSearch(const Indices& keys, const ReleasedObjective& objective)
    : Keys(keys)
    , Objective(objective)
  {
    this->Tried[{}] = std::nullopt; // why the search began
  }

  KeyRelease run()
  {
    if (this->Keys.empty() || !this->works(this->Keys))
    {
      return {};
    }
    Indices released;
    while (released.empty() && this->Tried.size() < maxSolves)
    {
      released = this->tryLeastSets();
    }
    KeyRelease release;
    release.released = released.empty() ? this->keepWhatCanBe() : std::move(released);
    for (const Indices& conflict : this->Conflicts)
    {
      release.conflicting = joined(release.conflicting, conflict);
    }
    return release;
  }

private:
  std::optional<double> objectiveWithout(const Indices& released)
  {
    const auto known = this->Tried.find(released);
    return known != this->Tried.end() ? known->second
                                      : this->Tried[released] = this->Objective(released);
  }
  bool works(const Indices& released) { return this->objectiveWithout(released).has_value(); }
  bool agree(const Indices& kept) { return this->works(without(this->Keys, kept)); }

  /// Of the least sets that the known conflicts allow the one with the least objective; empty, and
  /// a conflict more, where none of them helps.
  Indices tryLeastSets()
  {
    Indices best;
    double least = 0.0;
    for (const Indices& set : leastSets(this->Conflicts))
    {
      const std::optional<double> objective = this->objectiveWithout(set);
      if (objective && (best.empty() || *objective < least))
      {
        best = set;
        least = *objective;
      }
      if (!objective && best.empty())
      {
        this->Conflicts.push_back(this->conflictIn({}, false, without(this->Keys, set)));
        break;
      }
    }
    return best;
  }

  /// A least part of `among` that cannot be kept beside `base` (QuickXplain, U. Junker, AAAI 2004).
  Indices conflictIn(const Indices& base, bool grown, const Indices& among)
  {
    if (grown && !this->agree(base))
    {
      return {};
    }
    if (among.size() == 1)
    {
      return { among.front() }; // gcc 14 warns, falsely, of the bounds of a copy
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
    while (!open.empty())
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
    return without(this->Keys, kept);
  }

  const Indices& Keys;
  const ReleasedObjective& Objective;
  std::map<Indices, std::optional<double>> Tried; ///< objective by released keys
  std::vector<Indices> Conflicts;
};

std::string clashText(const std::vector<FeatureCurve>& curves, const Indices& clashing)
{
  return clashing.size() == 1
    ? "the key curve " + quotedNames(curves, clashing) + " cannot keep its planar shape"
    : "the key curves " + quotedNames(curves, clashing) +
      " cannot keep their planar shapes together";
}
}

KeyRelease releaseKeys(const Indices& keys, const ReleasedObjective& objective)
{
  return ReleaseSearch(keys, objective).run();
}

Status describeRelease(
  const std::vector<FeatureCurve>& curves, const Indices& keys, const KeyRelease& release)
{
  const Indices& released = release.released;
  const Indices clashing = joined(release.conflicting, released);
  constexpr std::size_t most = 5;
  const Indices kept = without(keys, released);
  std::string text = clashText(curves, clashing) + "; here " + quotedNames(curves, released) +
    (released.size() == 1 ? " has" : " have") + " given up the shape";
  if (!kept.empty())
  {
    text += kept.size() > most
      ? ", the other " + std::to_string(kept.size()) + " keep theirs"
      : ", " + quotedNames(curves, kept) + (kept.size() == 1 ? " keeps its own" : " keep theirs");
  }
  return { StatusCode::IncompatibleKeys, text, { ElementKind::Curves, released },
    { { Remedy::MakeAccessory, quotedNames(curves, released) },
      { Remedy::ChangeKeyShapes, quotedNames(curves, clashing) } } };
}

Status describeClash(const std::vector<FeatureCurve>& curves, const Indices& keys)
{
  return { StatusCode::IncompatibleKeys,
    clashText(curves, keys) + ", and giving up all of them does not help alone",
    { ElementKind::Curves, keys },
    { { Remedy::MakeAccessory, quotedNames(curves, keys) }, Remedy::MendSlivers } };
}
}
