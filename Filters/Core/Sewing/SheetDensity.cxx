// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SheetDensity.h"

#include "Cloth/ClothEnergy.h"

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

namespace
{
/// Threads that are shorter than this share, or nearer to each other than this angle, have no
/// direction to derive by.
constexpr double shortest = 1e-6;
}

ThreadStrain threadStrainOf(const Eigen::Vector3d& metric)
{
  const double det2 = metric[0] * metric[1] - metric[2] * metric[2];
  return { std::sqrt(std::max(metric[1], 0.0)) - 1.0, std::sqrt(std::max(metric[0], 0.0)) - 1.0,
    std::atan2(metric[2], std::sqrt(std::max(det2, shortest * shortest * shortest * shortest))) };
}

SheetDensity::SheetDensity(double areaBias)
  : Bias(areaBias)
{
}

SheetDensity::SheetDensity(const ClothMaterial& material)
{
  const double scale = stiffestThread / std::max(material.warp, material.weft);
  this->Threads = { scale * material.warp, scale * material.weft, scale * material.cross,
    scale * material.shear, material.compression };
}

double SheetDensity::threadValue(const ThreadStrain& strain) const
{
  const ThreadStiffness& k = *this->Threads;
  return k.warp * threadEnergy(strain.warp, k.compression).value +
    k.weft * threadEnergy(strain.weft, k.compression).value + k.cross * strain.warp * strain.weft +
    0.5 * k.shear * strain.shear * strain.shear;
}

double SheetDensity::value(const Eigen::Vector3d& metric) const
{
  return this->Threads ? this->threadValue(threadStrainOf(metric))
                       : isotropicDensity(this->Bias, metric);
}

MetricDensity SheetDensity::evaluate(const Eigen::Vector3d& metric) const
{
  return this->Threads ? this->evaluateThreads(metric)
                       : evaluateIsotropicDensity(this->Bias, metric);
}

MetricDensity SheetDensity::evaluateThreads(const Eigen::Vector3d& metric) const
{
  const ThreadStiffness& k = *this->Threads;
  const ThreadStrain strain = threadStrainOf(metric);
  const double c11 = std::max(metric[0], shortest * shortest);
  const double c22 = std::max(metric[1], shortest * shortest);
  const double lengthX = std::sqrt(c11);
  const double lengthY = std::sqrt(c22);
  const Curve2 warp = threadEnergy(strain.warp, k.compression);
  const Curve2 weft = threadEnergy(strain.weft, k.compression);

  // d sqrt(C) = dC / (2 sqrt(C)).
  const Eigen::Vector3d warpGradient(0.0, 0.5 / lengthY, 0.0);
  const Eigen::Vector3d weftGradient(0.5 / lengthX, 0.0, 0.0);
  const double byWarp = k.warp * warp.first + k.cross * strain.weft;
  const double byWeft = k.weft * weft.first + k.cross * strain.warp;

  // sin g = C12 C11^(-1/2) C22^(-1/2).
  const double product = 1.0 / (lengthX * lengthY);
  const double sine = std::sin(strain.shear);
  const double cosine = std::cos(strain.shear);
  const Eigen::Vector3d sineGradient(-0.5 * sine / c11, -0.5 * sine / c22, product);
  Eigen::Matrix3d sineHessian;
  const double mixed = 0.25 * sine / (c11 * c22);
  sineHessian << 0.75 * sine / (c11 * c11), mixed, -0.5 * product / c11, //
    mixed, 0.75 * sine / (c22 * c22), -0.5 * product / c22,              //
    -0.5 * product / c11, -0.5 * product / c22, 0.0;
  const Eigen::Vector3d shearGradient = sineGradient / cosine;
  const Eigen::Matrix3d shearHessian =
    (sineHessian + sine * (shearGradient * shearGradient.transpose())) / cosine;

  MetricDensity density;
  density.value = this->threadValue(strain);
  density.gradient =
    byWarp * warpGradient + byWeft * weftGradient + k.shear * strain.shear * shearGradient;
  density.hessian =
    k.shear * (shearGradient * shearGradient.transpose() + strain.shear * shearHessian) +
    k.warp * warp.second * (warpGradient * warpGradient.transpose()) +
    k.weft * weft.second * (weftGradient * weftGradient.transpose()) +
    k.cross * (warpGradient * weftGradient.transpose() + weftGradient * warpGradient.transpose());
  density.hessian(1, 1) -= 0.25 * byWarp / (c22 * lengthY);
  density.hessian(0, 0) -= 0.25 * byWeft / (c11 * lengthX);
  return density;
}
}
