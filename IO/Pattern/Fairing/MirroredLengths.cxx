// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/OutlineMirror.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double enough = 4.0 * std::numeric_limits<double>::epsilon();
constexpr int projections = 1000;

/// Two intervals that are sewn to each other.
struct Sewn
{
  PlannedInterval* one = nullptr;
  PlannedInterval* other = nullptr;
  double ratio = 1.0; ///< of their lengths, which differ where one is eased
  bool holds = false; ///< the first keeps its length
};

bool isRaw(const PlannedChain& chain, std::size_t interval)
{
  const auto found = std::find_if(chain.stretches.begin(), chain.stretches.end(),
    [interval](const PlannedStretch& stretch) { return interval < stretch.endInterval; });
  return found != chain.stretches.end() && found->form == StretchForm::Raw;
}

std::vector<Sewn> sewnIntervals(std::vector<PlannedChain>& plan)
{
  std::vector<Sewn> sewn;
  for (std::size_t c = 0; c < plan.size(); ++c)
  {
    for (std::size_t k = 0; k < plan[c].intervals.size(); ++k)
    {
      const std::array<std::size_t, 2> own{ c, k };
      const std::array<std::size_t, 2> partner = plan[c].intervals[k].partner;
      if (partner[0] == PlannedInterval::none ||
        plan[partner[0]].intervals[partner[1]].partner != own)
      {
        continue;
      }
      const bool holds = isRaw(plan[c], k);
      const bool otherHolds = isRaw(plan[partner[0]], partner[1]);
      if (holds ? !otherHolds : !otherHolds && own < partner)
      {
        PlannedInterval& one = plan[c].intervals[k];
        PlannedInterval& other = plan[partner[0]].intervals[partner[1]];
        sewn.push_back({ &one, &other, one.length / other.length, holds });
      }
    }
  }
  return sewn;
}

double lengthOf(const PlannedChain& chain, std::size_t s)
{
  double length = 0.0;
  for (std::size_t k = chain.stretches[s].firstInterval; k < chain.stretches[s].endInterval; ++k)
  {
    length += chain.intervals[k].length;
  }
  return length;
}

void scale(PlannedChain& chain, std::size_t s, double factor)
{
  for (std::size_t k = chain.stretches[s].firstInterval; k < chain.stretches[s].endInterval; ++k)
  {
    chain.intervals[k].length *= factor;
  }
}
}

void equalizeMirroredLengths(
  const std::vector<OutlineMirror>& mirrors, std::vector<PlannedChain>& plan)
{
  const bool any = std::any_of(
    mirrors.begin(), mirrors.end(), [](const OutlineMirror& mirror) { return mirror.found(); });
  const std::vector<Sewn> sewn = any ? sewnIntervals(plan) : std::vector<Sewn>();
  double change = any ? 1.0 : 0.0;
  // Projections onto one condition after the other come to lengths that meet all of them. S.
  // Kaczmarz, Angenaeherte Aufloesung von Systemen linearer Gleichungen, 1937.
  for (int round = 0; round < projections && change > enough; ++round)
  {
    change = 0.0;
    for (const OutlineMirror& mirror : mirrors)
    {
      for (const MirroredStretches& pair : mirror.stretches)
      {
        PlannedChain& one = plan[pair.one.chain];
        PlannedChain& other = plan[pair.other.chain];
        const double length = lengthOf(one, pair.one.stretch);
        const double mean = (length + lengthOf(other, pair.other.stretch)) / 2.0;
        if (!pair.own() && mean != length)
        {
          change = std::max(change, std::abs(mean / length - 1.0));
          scale(other, pair.other.stretch, mean / (2.0 * mean - length));
          scale(one, pair.one.stretch, mean / length);
        }
      }
    }
    for (const Sewn& pair : sewn)
    {
      const double one = pair.one->length;
      const double wanted = pair.holds ? one : (one + pair.ratio * pair.other->length) / 2.0;
      change = std::max(change, std::abs(wanted / one - 1.0));
      pair.one->length = wanted;
      pair.other->length = wanted / pair.ratio;
    }
  }
}
}
}
