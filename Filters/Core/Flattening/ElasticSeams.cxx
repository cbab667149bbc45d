// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ElasticSeams.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
CurveStretches stretchesIn(
  const WireNetwork& network, const Points2& positions, const std::vector<FeatureCurve>& curves)
{
  std::vector<double> rest(curves.size(), 0.0);
  std::vector<double> flat(curves.size(), 0.0);
  for (const WireEdge& edge : network.edges)
  {
    if (edge.curve != none && curves[edge.curve].tolerance > 0.0)
    {
      rest[edge.curve] += edge.length;
      flat[edge.curve] += (positions[edge.to] - positions[edge.from]).norm();
    }
  }
  CurveStretches stretches(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (rest[c] > 0.0)
    {
      stretches[c] = std::clamp(flat[c] / rest[c] - 1.0, -curves[c].tolerance, curves[c].tolerance);
    }
  }
  return stretches;
}

CurveStretches agreeOnStretches(const std::vector<CurveStretches>& pieces)
{
  CurveStretches decided(pieces.empty() ? 0 : pieces.front().size());
  bool agree = true;
  for (std::size_t c = 0; c < decided.size(); ++c)
  {
    std::vector<double> stretches;
    for (const CurveStretches& piece : pieces)
    {
      if (piece[c])
      {
        stretches.push_back(*piece[c]);
      }
    }
    if (stretches.size() < 2)
    {
      continue;
    }
    const auto [least, most] = std::minmax_element(stretches.begin(), stretches.end());
    double sum = 0.0;
    for (double h : stretches)
    {
      sum += h;
    }
    decided[c] = sum / static_cast<double>(stretches.size());
    // What rounding leaves of one length is no disagreement.
    agree = agree && *most - *least <= 1e-13;
  }
  return agree ? CurveStretches() : decided;
}
}
