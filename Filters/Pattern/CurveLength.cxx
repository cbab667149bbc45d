// SPDX-License-Identifier: BSD-3-Clause
#include "CurveLength.h"

#include <Eigen/Dense>

namespace flattening
{
namespace pattern
{
CurveLength::CurveLength(const StretchCurve& curve, double from, double to, double wanted)
  : Wanted(wanted)
{
  const auto add = [&](double end) {
    integrate(from, end, [&](double t, double weight) {
      this->Slopes.emplace_back(curve.at(t, Derivative::Slope), weight);
    });
    from = end;
  };
  for (const double at : curve.basis().breaks())
  {
    if (at > from && at < to)
    {
      add(at);
    }
  }
  add(to);
}

double CurveLength::addRow(Eigen::Index row, const Eigen::VectorXd& x, Entries& entries) const
{
  double length = 0.0;
  for (const auto& [terms, weight] : this->Slopes)
  {
    const Point2 slope = sum(terms, x);
    const double speed = slope.norm();
    length += weight * speed;
    const Point2 unit = speed > 0.0 ? Point2(slope / speed) : Point2(Point2::Zero());
    for (const Term& term : terms)
    {
      for (Eigen::Index d = 0; d < 2; ++d)
      {
        entries.emplace_back(row, 2 * term.unknown + d, weight * term.factor * unit[d]);
      }
    }
  }
  return this->Wanted - length;
}

void CurveLength::addTension(double tension, const Eigen::VectorXd& x, Entries& entries) const
{
  for (std::size_t k = 0; k < this->Slopes.size();)
  {
    // All places of one span have the same unknowns.
    const Terms& first = this->Slopes[k].first;
    const auto size = static_cast<Eigen::Index>(first.size());
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(2 * size, 2 * size);
    for (; k < this->Slopes.size() && this->Slopes[k].first[1].unknown == first[1].unknown; ++k)
    {
      const auto& [terms, weight] = this->Slopes[k];
      const Point2 slope = sum(terms, x);
      const double speed = slope.norm();
      if (tension == 0.0 || !(speed > 0.0))
      {
        continue;
      }
      const Eigen::Matrix2d across =
        (Eigen::Matrix2d::Identity() - slope * slope.transpose() / (speed * speed)) *
        (tension * weight / speed);
      for (Eigen::Index a = 0; a < size; ++a)
      {
        for (Eigen::Index b = 0; b < size; ++b)
        {
          block.block<2, 2>(2 * a, 2 * b) += terms[static_cast<std::size_t>(a)].factor *
            terms[static_cast<std::size_t>(b)].factor * across;
        }
      }
    }
    const auto unknown = [&first](Eigen::Index at) {
      return 2 * first[static_cast<std::size_t>(at / 2)].unknown + at % 2;
    };
    for (Eigen::Index a = 0; a < block.rows(); ++a)
    {
      for (Eigen::Index b = 0; b < block.cols(); ++b)
      {
        entries.emplace_back(unknown(a), unknown(b), block(a, b));
      }
    }
  }
}
}
}
