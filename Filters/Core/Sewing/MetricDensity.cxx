// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/MetricDensity.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// A triangle that is thinner than this has no normal plane to derive by.
constexpr double thinnest = 1e-12;

struct Invariants
{
  double det; ///< S s
  double sum; ///< S + s
};

Invariants invariantsOf(const Eigen::Vector3d& metric)
{
  const double det =
    std::sqrt(std::max(metric[0] * metric[1] - metric[2] * metric[2], thinnest * thinnest));
  return { det, std::sqrt(metric[0] + metric[1] + 2.0 * det) };
}

/// As sums of squares of differences, which are small where strains are.
double densityOf(double bias, const Eigen::Vector3d& metric, const Invariants& invariants)
{
  const double spread = metric[0] - metric[1];
  const double difference2 =
    (spread * spread + 4.0 * metric[2] * metric[2]) / (invariants.sum * invariants.sum);
  const double det2 = metric[0] * metric[1] - metric[2] * metric[2];
  const double excess = ((metric[0] - 1.0) + (metric[1] - 1.0) +
                          2.0 * (std::max(det2, 0.0) - 1.0) / (invariants.det + 1.0)) /
    (invariants.sum + 2.0);
  return 0.5 * (1.0 + bias) * excess * excess + 0.5 * (1.0 - bias) * difference2;
}
}

double isotropicDensity(double bias, const Eigen::Vector3d& metric)
{
  return densityOf(bias, metric, invariantsOf(metric));
}

MetricDensity evaluateIsotropicDensity(double bias, const Eigen::Vector3d& metric)
{
  const Invariants invariants = invariantsOf(metric);
  const double det = invariants.det;
  const double sum = invariants.sum;
  // det^2 = C11 C22 - C12^2 and sum^2 = C11 + C22 + 2 det.
  const Eigen::Vector3d byDet2(metric[1], metric[0], -2.0 * metric[2]);
  Eigen::Matrix3d det2Hessian = Eigen::Matrix3d::Zero();
  det2Hessian(0, 1) = det2Hessian(1, 0) = 1.0;
  det2Hessian(2, 2) = -2.0;
  const Eigen::Vector3d detGradient = byDet2 / (2.0 * det);
  const Eigen::Matrix3d detHessian =
    (0.5 * det2Hessian - detGradient * detGradient.transpose()) / det;
  const Eigen::Vector3d trace(1.0, 1.0, 0.0);
  const Eigen::Vector3d sumGradient = (trace + 2.0 * detGradient) / (2.0 * sum);
  const Eigen::Matrix3d sumHessian = (detHessian - sumGradient * sumGradient.transpose()) / sum;

  // (S - s)^2 = 2 (C11 + C22) - sum^2.
  MetricDensity density;
  const double bySum = 2.0 * bias * sum - 2.0 * (1.0 + bias);
  density.value = densityOf(bias, metric, invariants);
  density.gradient = (1.0 - bias) * trace + bySum * sumGradient;
  density.hessian = 2.0 * bias * (sumGradient * sumGradient.transpose()) + bySum * sumHessian;
  return density;
}
}
