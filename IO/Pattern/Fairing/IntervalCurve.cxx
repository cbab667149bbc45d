// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/IntervalCurve.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
IntervalCurve::IntervalCurve(const std::vector<FairSpan>& spans, const PlannedInterval& interval)
  : Start(interval.places[0])
  , End(interval.places[1])
{
  const double least = sameBreak * (this->End - this->Start);
  const double start = this->Start + least;
  for (auto span = std::partition_point(
         spans.begin(), spans.end(), [start](const FairSpan& one) { return one.to <= start; });
       span != spans.end() && span->from < this->End - least; ++span)
  {
    this->Parts.push_back(
      partOf(*span, std::max(span->from, this->Start), std::min(span->to, this->End)));
  }
  for (const FairSpan& part : this->Parts)
  {
    this->Length += part.length();
  }
}

std::vector<double> IntervalCurve::breaks(bool fromEnd) const
{
  std::vector<double> breaks;
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < this->Parts.size(); ++k)
  {
    length += this->Parts[k].length();
    breaks.push_back(fromEnd ? 1.0 - length / this->Length : length / this->Length);
  }
  return breaks;
}

double IntervalCurve::placeAt(double share) const
{
  double left = share * this->Length;
  if (left < sameBreak * this->Length)
  {
    return this->Start;
  }
  for (const FairSpan& part : this->Parts)
  {
    const double length = part.length();
    if (std::abs(left - length) < sameBreak * this->Length)
    {
      return &part == &this->Parts.back() ? this->End : part.to;
    }
    if (left < length)
    {
      double low = part.from;
      double high = part.to;
      for (int step = 0; step < 50; ++step)
      {
        const double middle = (low + high) / 2.0;
        (partOf(part, part.from, middle).length() < left ? low : high) = middle;
      }
      return low;
    }
    left -= length;
  }
  return this->End;
}
}
}
