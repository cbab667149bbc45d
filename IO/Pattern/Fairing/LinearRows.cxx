// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/LinearRows.h"

#include <algorithm>
#include <set>

namespace flattening
{
namespace pattern
{
void LinearRows::addPoint(const Terms& terms, const Point2& value)
{
  for (Eigen::Index d = 0; d < 2; ++d)
  {
    Row& row = this->Rows.emplace_back();
    row.value = value[d];
    for (const Term& term : terms)
    {
      row.factors.emplace_back(2 * term.unknown + d, term.factor);
    }
  }
}

void LinearRows::addHeld(const Points2& points)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    this->addPoint({ { static_cast<Eigen::Index>(k), 1.0 } }, points[k]);
  }
}

void LinearRows::addHooksAndRings(const std::vector<StretchCurve>& curves)
{
  for (const StretchCurve& curve : curves)
  {
    const FairStretch& stretch = curve.stretch();
    for (const FairHook& hook : stretch.hooks)
    {
      Terms terms = curve.at(hook.at, Derivative::Place);
      terms.push_back({ static_cast<Eigen::Index>(hook.node), -1.0 });
      this->addPoint(terms, Point2::Zero());
    }
    if (stretch.smoothEnds)
    {
      Terms terms = curve.at(0.0, Derivative::Slope);
      for (const Term& term : curve.at(stretch.length(), Derivative::Slope))
      {
        terms.push_back({ term.unknown, -term.factor });
      }
      this->addPoint(terms, Point2::Zero());
    }
  }
}

void LinearRows::addMirror(const FairNetwork& network, const std::vector<StretchCurve>& curves)
{
  const FairMirror& mirror = network.mirror;
  // The image of a point p is at + F (p - at).
  const Eigen::Matrix2d image =
    2.0 * mirror.along * mirror.along.transpose() - Eigen::Matrix2d::Identity();
  const Point2 shift = mirror.at - image * mirror.at;
  const Point2 across(mirror.along.y(), -mirror.along.x());
  std::set<std::array<Eigen::Index, 2>> known; // nodes are of two stretches
  for (const FairImages& pair : mirror.stretches)
  {
    const std::vector<Eigen::Index> points = curves[pair.one].unknowns();
    std::vector<Eigen::Index> images = curves[pair.other].unknowns();
    if (pair.backwards)
    {
      std::reverse(images.begin(), images.end());
    }
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Eigen::Index a = std::min(points[k], images[k]);
      const Eigen::Index b = std::max(points[k], images[k]);
      const bool stays = network.held && a < static_cast<Eigen::Index>(network.nodes.size());
      if (stays || !known.insert({ a, b }).second)
      {
        continue;
      }
      if (a == b)
      {
        this->Rows.push_back(
          { { { 2 * a, across.x() }, { 2 * a + 1, across.y() } }, across.dot(mirror.at) });
        continue;
      }
      for (Eigen::Index d = 0; d < 2; ++d)
      {
        this->Rows.push_back(
          { { { 2 * b + d, 1.0 }, { 2 * a, -image(d, 0) }, { 2 * a + 1, -image(d, 1) } },
            shift[d] });
      }
    }
  }
}

void LinearRows::add(const Eigen::VectorXd& x, std::vector<Eigen::Triplet<double>>& entries,
  Eigen::VectorXd& missing) const
{
  for (Eigen::Index r = 0; r < this->size(); ++r)
  {
    const Row& row = this->Rows[static_cast<std::size_t>(r)];
    missing[r] = row.value;
    for (const auto& [coordinate, factor] : row.factors)
    {
      entries.emplace_back(r, coordinate, factor);
      missing[r] -= factor * x[coordinate];
    }
  }
}
}
}
