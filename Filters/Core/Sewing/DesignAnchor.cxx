// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/DesignAnchor.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{
/// Beyond it a step inwards is far below what can be seen, and the system badly conditioned.
constexpr double hardest = 1e4;

double stiffnessAgainstInwards(double stiffness, double bias)
{
  return bias < 1.0 ? std::min(hardest, stiffness * bias / (1.0 - bias)) : hardest;
}
}

DesignAnchor::DesignAnchor(const SpaceUnknowns& unknowns, const SewnMembrane& sheet,
  double stiffness, double outsideBias, const Points3& outwards)
{
  if (!(stiffness > 0.0))
  {
    return;
  }
  const std::vector<double> areas = sheet.vertexAreas();
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  const bool biased = outsideBias > 0.0;
  const double againstInwards = stiffnessAgainstInwards(stiffness, outsideBias);
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    if (unknowns.first[v] != none && areas[v] > 0.0)
    {
      const double share = areas[v] / sum;
      this->Springs.push_back(
        { unknowns.first[v], unknowns.points[v], biased ? outwards[v] : Point3::Zero(),
          stiffness * share, biased ? againstInwards * share : 0.0 });
    }
  }
}

double DesignAnchor::inwards(const Spring& spring, const Point3& moved)
{
  return std::min(0.0, spring.outwards.dot(moved));
}

double DesignAnchor::energy(const Eigen::VectorXd& x) const
{
  double sum = 0.0;
  for (const Spring& spring : this->Springs)
  {
    const Point3 moved = x.segment<3>(spring.first) - spring.design;
    const double in = inwards(spring, moved);
    sum += spring.stiffness * moved.squaredNorm() + spring.againstInwards * in * in;
  }
  return sum;
}

void DesignAnchor::add(
  const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const
{
  for (const Spring& spring : this->Springs)
  {
    const Point3 moved = x.segment<3>(spring.first) - spring.design;
    const double in = inwards(spring, moved);
    const Point3& out = spring.outwards;
    gradient.segment<3>(spring.first) +=
      2.0 * spring.stiffness * moved + 2.0 * spring.againstInwards * in * out;
    const double across = in < 0.0 ? 2.0 * spring.againstInwards : 0.0;
    matrix.addOwn(spring.first,
      2.0 * spring.stiffness * Eigen::Matrix3d::Identity() + across * out * out.transpose());
  }
}
}
