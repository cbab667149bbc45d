// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/DistortionEnergy.h"

#include "Base/ConvexPart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// The rotation of a collapsed triangle is undefined; below this |q| it is taken as it comes.
constexpr double smallestLength = 1e-12;

/// The direction of a vector of known length; any where it has none.
Eigen::Vector2d unitAlong(const Eigen::Vector2d& vector, double length)
{
  return length > smallestLength ? Eigen::Vector2d(vector / length) : Eigen::Vector2d::UnitX();
}

Eigen::Vector4d rigidGradient(double bias, const Eigen::Vector4d& parts)
{
  const Eigen::Vector2d q = parts.head<2>();
  const double length = std::max(q.norm(), smallestLength);
  Eigen::Vector4d gradient;
  gradient << (1.0 + bias) * (length - 2.0) * unitAlong(q, length), (1.0 - bias) * parts.tail<2>();
  return gradient;
}

DistortionEnergyValue evaluateRigid(double bias, const Eigen::Vector4d& parts, bool convex)
{
  const Eigen::Vector2d q = parts.head<2>();
  const Eigen::Vector2d p = parts.tail<2>();
  const double length = std::max(q.norm(), smallestLength);
  const Eigen::Vector2d along = unitAlong(q, length);
  const Eigen::Vector2d across(-along.y(), along.x());
  const double stiffArea = 1.0 + bias;
  const double stiffAngle = 1.0 - bias;

  DistortionEnergyValue result;
  result.value =
    0.5 * stiffArea * (length - 2.0) * (length - 2.0) + 0.5 * stiffAngle * p.squaredNorm();
  result.gradient = rigidGradient(bias, parts);
  // Turning a compressed triangle is the one direction of negative curvature.
  double turning = 1.0 - 2.0 / length;
  turning = convex ? std::max(0.0, turning) : std::max(-1e3, turning);
  result.hessian.setZero();
  result.hessian.topLeftCorner<2, 2>() =
    stiffArea * (along * along.transpose() + turning * (across * across.transpose()));
  result.hessian.bottomRightCorner<2, 2>() = stiffAngle * Eigen::Matrix2d::Identity();
  return result;
}

/// |J|^2 (1 + 1 / det^2) - 4 as a sum of squares, since it is nearly zero where little is deformed.
/// \param difference (S - s)^2
double dirichletDensity(double difference, double det)
{
  return difference * (1.0 + 1.0 / (det * det)) + 2.0 * (det - 1.0) * (det - 1.0) / det;
}

DistortionEnergyValue evaluateDirichlet(const Eigen::Vector4d& parts, bool convex)
{
  const double u = parts.head<2>().squaredNorm();
  const double v = parts.tail<2>().squaredNorm();
  const double norm = 0.5 * (u + v);
  const double det = 0.25 * (u - v); // |J^-1|^2 = |J|^2 / det^2
  if (!(det > 0.0))
  {
    DistortionEnergyValue collapsed;
    collapsed.value = std::numeric_limits<double>::infinity();
    collapsed.gradient.setZero();
    collapsed.hessian.setIdentity();
    return collapsed;
  }
  const double inverse = 1.0 / det;
  const double inverse2 = inverse * inverse;
  NormDetDensity density;
  density.value = dirichletDensity(v, det);
  density.byNorm = 1.0 + inverse2;
  density.byDet = -2.0 * norm * inverse2 * inverse;
  density.byNormDet = -2.0 * inverse2 * inverse;
  density.byDet2 = 6.0 * norm * inverse2 * inverse2;
  return expandNormDet(density, parts, convex);
}
}

Eigen::Matrix<double, 4, 6> mapPartsDerivative(const TriangleFrame& frame)
{
  // q = 2 alpha and p = 2 beta: multiplication by 2 conj(gradient) and by 2 gradient.
  Eigen::Matrix<double, 4, 6> derivative;
  for (int k = 0; k < 3; ++k)
  {
    const double x = 2.0 * frame.gradient[k].real();
    const double y = 2.0 * frame.gradient[k].imag();
    derivative.block<2, 2>(0, 2 * k) << x, y, -y, x;
    derivative.block<2, 2>(2, 2 * k) << x, -y, y, x;
  }
  return derivative;
}

DistortionEnergyValue expandNormDet(
  const NormDetDensity& density, const Eigen::Vector4d& parts, bool convex)
{
  DistortionEnergyValue result;
  result.value = density.value;
  Eigen::Vector4d gradDet = 0.5 * parts;
  gradDet.tail<2>() *= -1.0;
  result.gradient = density.byNorm * parts + density.byDet * gradDet;

  // The density depends on |q| and |p| alone: along them the Hessian couples both, across them it
  // has its eigenvectors.
  const double q = parts.head<2>().norm();
  const double p = parts.tail<2>().norm();
  const Eigen::Vector2d alongQ = unitAlong(parts.head<2>(), q);
  const Eigen::Vector2d alongP = unitAlong(parts.tail<2>(), p);
  double acrossQ = density.byNorm + 0.5 * density.byDet;
  double acrossP = density.byNorm - 0.5 * density.byDet;
  Eigen::Matrix2d along;
  along(0, 0) = acrossQ + q * q * (density.byNormDet + 0.25 * density.byDet2);
  along(1, 1) = acrossP + p * p * (0.25 * density.byDet2 - density.byNormDet);
  along(0, 1) = along(1, 0) = -0.25 * q * p * density.byDet2;
  if (convex)
  {
    acrossQ = std::max(0.0, acrossQ);
    acrossP = std::max(0.0, acrossP);
    along = withoutNegativeEigenvalues(along);
  }
  const Eigen::Matrix2d radialQ = alongQ * alongQ.transpose();
  const Eigen::Matrix2d radialP = alongP * alongP.transpose();
  result.hessian.topLeftCorner<2, 2>() =
    along(0, 0) * radialQ + acrossQ * (Eigen::Matrix2d::Identity() - radialQ);
  result.hessian.bottomRightCorner<2, 2>() =
    along(1, 1) * radialP + acrossP * (Eigen::Matrix2d::Identity() - radialP);
  result.hessian.topRightCorner<2, 2>() = along(0, 1) * alongQ * alongP.transpose();
  result.hessian.bottomLeftCorner<2, 2>() = result.hessian.topRightCorner<2, 2>().transpose();
  return result;
}

DistortionEnergyValue evaluateDistortionEnergy(
  const DistortionEnergy& energy, const Eigen::Vector4d& parts, bool convex)
{
  return energy.kind == DistortionEnergyKind::SymmetricDirichlet
    ? evaluateDirichlet(parts, convex)
    : evaluateRigid(energy.bias, parts, convex);
}

Eigen::Vector4d distortionEnergyGradient(
  const DistortionEnergy& energy, const Eigen::Vector4d& parts)
{
  return energy.kind == DistortionEnergyKind::SymmetricDirichlet
    ? evaluateDirichlet(parts, false).gradient
    : rigidGradient(energy.bias, parts);
}

double distortionEnergyDensity(const DistortionEnergy& energy, const Eigen::Vector4d& parts)
{
  const double u = parts.head<2>().squaredNorm();
  const double v = parts.tail<2>().squaredNorm();
  if (energy.kind == DistortionEnergyKind::SymmetricDirichlet)
  {
    const double det = 0.25 * (u - v);
    return det > 0.0 ? dirichletDensity(v, det) : std::numeric_limits<double>::infinity();
  }
  const double excess = std::sqrt(u) - 2.0;
  return 0.5 * (1.0 + energy.bias) * excess * excess + 0.5 * (1.0 - energy.bias) * v;
}
}
