// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/FeatureCurve.h"

#include <map>
#include <optional>
#include <set>

namespace flattening
{
/// Looks for the least set of key curves whose release makes the others compatible, among several
/// the one with the least objective (of 32 that are compared). Where that takes more than 100
/// solutions, as it does where many keys clash with each other: a set of which no curve can be
/// kept.
///
/// It solves nothing itself: it asks for a set to try and is told what came of it.
///
///     KeyReleaseSearch search(keys);
///     while (std::optional<Indices> released = search.next())
///     {
///       ... solve without the shapes of these ...
///       search.tell(*released, objective or none where there is no solution);
///     }
///
/// A conflict is a set of keys that cannot be kept together, though each smaller part of it can; a
/// set whose release helps has one key of each. So the search goes from one conflict to the next,
/// and does not depend on how many keys there are beside them.
class KeyReleaseSearch
{
public:
  /// \param keys ascending; that there is no solution with all of them is known
  explicit KeyReleaseSearch(Indices keys);

  /// The next keys to release for a trial; none when the search is over.
  std::optional<Indices> next();
  void tell(const Indices& released, std::optional<double> objective);

  /// After the search: the keys to release, empty where no release helps.
  const Indices& found() const { return this->Found; }
  /// Keys that cannot be kept together with others, as far as they are known.
  Indices concerned() const;

private:
  bool works(const Indices& released);
  bool agree(const Indices& kept);
  Indices search();
  Indices tryLeastSets();
  Indices conflictIn(const Indices& base, bool grown, const Indices& among);
  Indices keepWhatCanBe();

  Indices Keys;
  std::map<Indices, std::optional<double>> Tried; ///< objective by released keys
  std::set<Indices> Used; ///< of them those that this pass of the search has looked at
  std::vector<Indices> Conflicts;
  std::optional<Indices> Asked; ///< what this pass has to know to go on
  Indices Found;
};

/// IncompatibleKeys with the names of the key curves that clash and of those that were released
/// (ids: curves).
Status describeRelease(
  const std::vector<FeatureCurve>& curves, const Indices& keys, const KeyReleaseSearch& search);
/// IncompatibleKeys where no release helps, with the names of all keys (ids: curves).
Status describeClash(const std::vector<FeatureCurve>& curves, const Indices& keys);
}
