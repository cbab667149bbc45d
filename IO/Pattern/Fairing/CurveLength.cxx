// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/CurveLength.h"

#include <Eigen/Dense>

#include <algorithm>

namespace flattening
{
namespace pattern
{
CurveLength::CurveLength(const StretchCurve& curve, double from, double to, double wanted)
  : Wanted(wanted)
{
  const auto add = [&](double end) {
    Part& part = this->Parts.emplace_back();
    integrate(from, end, [&](double t, double weight) {
      const Terms slope = curve.at(t, Derivative::Slope);
      std::array<double, 4>& factors = part.factors.emplace_back();
      for (std::size_t k = 0; k < slope.size(); ++k)
      {
        factors[k] = slope[k].factor;
      }
      part.weights.push_back(weight);
      part.unknowns = part.weights.size() == 1 ? slope : part.unknowns;
    });
    from = end;
  };
  const std::vector<double>& breaks = curve.basis().breaks();
  for (auto at = std::upper_bound(breaks.begin(), breaks.end(), from);
       at != breaks.end() && *at < to; ++at)
  {
    add(*at);
  }
  add(to);
}

Point2 CurveLength::Part::slope(std::size_t place, const Eigen::VectorXd& x) const
{
  Point2 slope = Point2::Zero();
  for (std::size_t k = 0; k < this->unknowns.size(); ++k)
  {
    slope += this->factors[place][k] * x.segment<2>(2 * this->unknowns[k].unknown);
  }
  return slope;
}

double CurveLength::addRow(Eigen::Index row, const Eigen::VectorXd& x, Entries& entries) const
{
  double length = 0.0;
  for (const Part& part : this->Parts)
  {
    std::array<Point2, 4> derivative{ Point2::Zero(), Point2::Zero(), Point2::Zero(),
      Point2::Zero() };
    for (std::size_t place = 0; place < part.weights.size(); ++place)
    {
      const Point2 slope = part.slope(place, x);
      const double speed = slope.norm();
      length += part.weights[place] * speed;
      const Point2 unit = speed > 0.0 ? Point2(slope / speed) : Point2(Point2::Zero());
      for (std::size_t k = 0; k < part.unknowns.size(); ++k)
      {
        derivative[k] += part.weights[place] * part.factors[place][k] * unit;
      }
    }
    for (std::size_t k = 0; k < part.unknowns.size(); ++k)
    {
      for (Eigen::Index d = 0; d < 2; ++d)
      {
        entries.emplace_back(row, 2 * part.unknowns[k].unknown + d, derivative[k][d]);
      }
    }
  }
  return this->Wanted - length;
}

void CurveLength::addTension(double tension, const Eigen::VectorXd& x, Entries& entries) const
{
  for (const Part& part : this->Parts)
  {
    const auto size = static_cast<Eigen::Index>(part.unknowns.size());
    Eigen::Matrix<double, 8, 8> block = Eigen::Matrix<double, 8, 8>::Zero();
    for (std::size_t place = 0; tension != 0.0 && place < part.weights.size(); ++place)
    {
      const Point2 slope = part.slope(place, x);
      const double speed = slope.norm();
      if (!(speed > 0.0))
      {
        continue;
      }
      const Eigen::Matrix2d across =
        (Eigen::Matrix2d::Identity() - slope * slope.transpose() / (speed * speed)) *
        (tension * part.weights[place] / speed);
      const std::array<double, 4>& factors = part.factors[place];
      for (Eigen::Index a = 0; a < size; ++a)
      {
        for (Eigen::Index b = 0; b < size; ++b)
        {
          block.block<2, 2>(2 * a, 2 * b) +=
            factors[static_cast<std::size_t>(a)] * factors[static_cast<std::size_t>(b)] * across;
        }
      }
    }
    const auto unknown = [&part](Eigen::Index at) {
      return 2 * part.unknowns[static_cast<std::size_t>(at / 2)].unknown + at % 2;
    };
    for (Eigen::Index a = 0; a < 2 * size; ++a)
    {
      for (Eigen::Index b = 0; b < 2 * size; ++b)
      {
        entries.emplace_back(unknown(a), unknown(b), block(a, b));
      }
    }
  }
}
}
}
