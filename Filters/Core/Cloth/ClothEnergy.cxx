// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ClothEnergy.h"

#include "Base/ConvexPart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// The strain over half of which its stiffness changes.
constexpr double bendOfThread = 1e-3;
}

Curve2 threadEnergy(double strain, double compression)
{
  Curve2 sum{ 0.5 * compression * strain * strain, compression * strain, compression };
  if (compression < 1.0)
  {
    // Zero with its derivative where nothing is strained.
    const Curve2 atRest = smoothRamp(bendOfThread, 2.0 * bendOfThread);
    const Curve2 drawn = smoothRamp(strain + bendOfThread, 2.0 * bendOfThread);
    const double soft = 1.0 - compression;
    sum.value += soft * (drawn.value - atRest.value - atRest.first * strain);
    sum.first += soft * (drawn.first - atRest.first);
    sum.second += soft * drawn.second;
  }
  return sum;
}

namespace
{
/// Strains and shears over which stiffnesses change.
constexpr double bendOfLimit = 5e-3;
constexpr double bendOfLock = 5e-2;
/// Beyond a limit by more than this a strain costs in proportion, not by its square: exact lengths
/// that force it somewhere had better force little area far beyond than much a little.
constexpr double proportionalBeyond = 5e-2;

void add(Curve2& sum, const Curve2& part, double factor, double inner)
{
  sum.value += factor * part.value;
  sum.first += factor * inner * part.first;
  sum.second += factor * part.second;
}

/// What a value is beyond its limits.
Curve2 limitEnergy(double value, double least, double greatest, double bend)
{
  Curve2 sum;
  if (value > greatest)
  {
    add(sum, smoothRamp(value - greatest, bend), 1.0, 1.0);
  }
  else if (value < least)
  {
    add(sum, smoothRamp(least - value, bend), 1.0, -1.0);
  }
  return sum;
}

/// The same of a thread's strain.
Curve2 limitEnergy(double strain, const StrainLimits& limits)
{
  Curve2 sum = limitEnergy(strain, limits.least, limits.greatest, bendOfLimit);
  const Curve2 far = limitEnergy(strain, limits.least - proportionalBeyond,
    limits.greatest + proportionalBeyond, proportionalBeyond);
  add(sum, far, -1.0, 1.0);
  return sum;
}

/// Parts (q, p) to rows, half of what is orthogonal.
Eigen::Matrix4d makePartsToRows()
{
  Eigen::Matrix4d matrix;
  matrix << 0.5, 0.0, 0.5, 0.0, 0.0, -0.5, 0.0, 0.5, 0.0, 0.5, 0.0, 0.5, 0.5, 0.0, -0.5, 0.0;
  return matrix;
}

const Eigen::Matrix4d& partsToRows()
{
  static const Eigen::Matrix4d matrix = makePartsToRows();
  return matrix;
}
}

Eigen::Vector4d rowsOfMap(const Eigen::Vector4d& parts)
{
  return { 0.5 * (parts[0] + parts[2]), 0.5 * (parts[3] - parts[1]), 0.5 * (parts[1] + parts[3]),
    0.5 * (parts[0] - parts[2]) };
}

ClothEnergy::ClothEnergy(const ClothMaterial& material, double limitStiffness)
{
  const double scale = stiffestThread / std::max(material.warp, material.weft);
  this->Warp = { scale * material.warp, material.compression, material.warpLimits };
  this->Weft = { scale * material.weft, material.compression, material.weftLimits };
  this->Cross = scale * material.cross;
  this->Shear = scale * material.shear;
  this->ShearLimit = material.shearLimit;
  this->LimitStiffness = stiffestThread * limitStiffness;
}

double ClothEnergy::edgeModulus() const
{
  const double warp = this->Warp.stiffness;
  const double weft = this->Weft.stiffness;
  const auto compliance = [this](double along, double across) {
    return std::sqrt(2.0 / (along * across)) *
      std::sqrt(std::sqrt(along / across) + 0.5 * along / this->Shear);
  };
  // 1 where threads have 2 and the shear 1.
  return 1.0 / std::sqrt(compliance(warp, weft) * compliance(weft, warp));
}

double ClothEnergy::density(const Eigen::Vector4d& parts) const
{
  const Eigen::Vector4d rows = rowsOfMap(parts);
  const double det = rows[0] * rows[3] - rows[1] * rows[2];
  const ThreadStrain strain = threadStrain(rows.head<2>(), rows.tail<2>());
  return isPossible(strain) ? det * this->strainEnergy(strain)
                            : std::numeric_limits<double>::infinity();
}

double ClothEnergy::strainEnergy(const ThreadStrain& strain) const
{
  double sum = this->Warp.stiffness * threadEnergy(strain.warp, this->Warp.compression).value +
    this->Weft.stiffness * threadEnergy(strain.weft, this->Weft.compression).value +
    this->Cross * strain.warp * strain.weft + 0.5 * this->Shear * strain.shear * strain.shear;
  if (this->LimitStiffness > 0.0)
  {
    sum += this->LimitStiffness *
      (limitEnergy(strain.warp, this->Warp.limits).value +
        limitEnergy(strain.weft, this->Weft.limits).value +
        limitEnergy(strain.shear, -this->ShearLimit, this->ShearLimit, bendOfLock).value);
  }
  return sum;
}

/// What the energy is made of at a map.
struct ClothEnergy::Measures
{
  Eigen::Vector2d a; ///< rows of the map
  Eigen::Vector2d b;
  double det;
  ThreadStrain strain;
  // The energy of z = (warp, weft, shear) over det J and its derivatives.
  double energy;
  Eigen::Vector3d byStrain;
  Eigen::Matrix3d byStrain2;
  /// z by y = (|a|, |b|, det J, a . b).
  Eigen::Matrix<double, 3, 4> strainByMeasure;
  Eigen::Vector4d pulled; ///< energy over det J by y
  /// y by the rows.
  Eigen::Matrix4d measureByRows;

  /// det J times the energy by y.
  Eigen::Vector4d byMeasure() const
  {
    Eigen::Vector4d result = this->det * this->pulled;
    result[2] += this->energy;
    return result;
  }
};

std::optional<ClothEnergy::Measures> ClothEnergy::measure(const Eigen::Vector4d& parts) const
{
  const Eigen::Vector4d rows = rowsOfMap(parts);
  Measures m;
  m.a = rows.head<2>();
  m.b = rows.tail<2>();
  m.det = cross(m.a, m.b);
  m.strain = threadStrain(m.a, m.b);
  if (!isPossible(m.strain))
  {
    return std::nullopt;
  }
  const ThreadStrain& strain = m.strain;
  Curve2 warp = threadEnergy(strain.warp, this->Warp.compression);
  Curve2 weft = threadEnergy(strain.weft, this->Weft.compression);
  Curve2 shear{ 0.5 * strain.shear * strain.shear, strain.shear, 1.0 };
  const auto scaled = [this](Curve2& curve, double stiffness, const Curve2& limit) {
    curve.value = stiffness * curve.value + this->LimitStiffness * limit.value;
    curve.first = stiffness * curve.first + this->LimitStiffness * limit.first;
    curve.second = stiffness * curve.second + this->LimitStiffness * limit.second;
  };
  scaled(warp, this->Warp.stiffness, limitEnergy(strain.warp, this->Warp.limits));
  scaled(weft, this->Weft.stiffness, limitEnergy(strain.weft, this->Weft.limits));
  scaled(
    shear, this->Shear, limitEnergy(strain.shear, -this->ShearLimit, this->ShearLimit, bendOfLock));
  m.energy = warp.value + weft.value + shear.value + this->Cross * strain.warp * strain.weft;
  m.byStrain = { warp.first + this->Cross * strain.weft, weft.first + this->Cross * strain.warp,
    shear.first };
  m.byStrain2 = Eigen::Vector3d(warp.second, weft.second, shear.second).asDiagonal();
  m.byStrain2(0, 1) = m.byStrain2(1, 0) = this->Cross;

  const double lengthA = m.a.norm();
  const double lengthB = m.b.norm();
  const double dot = m.a.dot(m.b);
  const double inverse = 1.0 / m.det;
  const double square = 1.0 / (m.det * m.det + dot * dot);
  m.strainByMeasure << inverse, 0.0, -lengthA * inverse * inverse, 0.0, //
    0.0, inverse, -lengthB * inverse * inverse, 0.0,                    //
    0.0, 0.0, -dot * square, m.det * square;
  m.pulled = m.strainByMeasure.transpose() * m.byStrain;
  const Eigen::Vector2d alongA = m.a / lengthA;
  const Eigen::Vector2d alongB = m.b / lengthB;
  m.measureByRows << alongA.x(), alongA.y(), 0.0, 0.0, //
    0.0, 0.0, alongB.x(), alongB.y(),                  //
    m.b.y(), -m.b.x(), -m.a.y(), m.a.x(),              //
    m.b.x(), m.b.y(), m.a.x(), m.a.y();
  return m;
}

Eigen::Vector4d ClothEnergy::gradient(const Eigen::Vector4d& parts) const
{
  const std::optional<Measures> m = this->measure(parts);
  return m
    ? Eigen::Vector4d(partsToRows().transpose() * (m->measureByRows.transpose() * m->byMeasure()))
    : Eigen::Vector4d::Zero();
}

/// Of det J times the energy, by the rows.
Eigen::Matrix4d ClothEnergy::hessian(const Measures& m)
{
  const Eigen::Vector3d& byStrain = m.byStrain;
  const double lengthA = m.a.norm();
  const double lengthB = m.b.norm();
  const double dot = m.a.dot(m.b);
  const double inverse = 1.0 / m.det;
  const double square = 1.0 / (m.det * m.det + dot * dot);
  Eigen::Matrix4d H = m.det * (m.strainByMeasure.transpose() * m.byStrain2 * m.strainByMeasure);
  H(0, 2) -= byStrain[0] * inverse;
  H(2, 0) -= byStrain[0] * inverse;
  H(1, 2) -= byStrain[1] * inverse;
  H(2, 1) -= byStrain[1] * inverse;
  const double bend = 2.0 * dot * m.det * square * square;
  H(2, 2) += 2.0 * inverse * inverse * (byStrain[0] * lengthA + byStrain[1] * lengthB) +
    m.det * byStrain[2] * bend;
  H(3, 3) -= m.det * byStrain[2] * bend;
  const double twist = m.det * byStrain[2] * (dot * dot - m.det * m.det) * square * square;
  H(2, 3) += twist;
  H(3, 2) += twist;
  H.row(2) += m.pulled.transpose();
  H.col(2) += m.pulled;

  const Eigen::Vector4d byMeasure = m.byMeasure();
  const auto across = [](const Eigen::Vector2d& row) {
    return Eigen::Matrix2d(Eigen::Matrix2d::Identity() - row * row.transpose() / row.squaredNorm());
  };
  Eigen::Matrix4d result = m.measureByRows.transpose() * H * m.measureByRows;
  result.topLeftCorner<2, 2>() += byMeasure[0] / lengthA * across(m.a);
  result.bottomRightCorner<2, 2>() += byMeasure[1] / lengthB * across(m.b);
  Eigen::Matrix2d mixed;
  mixed << byMeasure[3], byMeasure[2], -byMeasure[2], byMeasure[3];
  result.topRightCorner<2, 2>() += mixed;
  result.bottomLeftCorner<2, 2>() += mixed.transpose();
  return result;
}

DistortionEnergyValue ClothEnergy::evaluate(const Eigen::Vector4d& parts, bool convex) const
{
  DistortionEnergyValue result;
  const std::optional<Measures> m = this->measure(parts);
  if (!m)
  {
    result.value = std::numeric_limits<double>::infinity();
    result.gradient.setZero();
    result.hessian.setIdentity();
    return result;
  }
  Eigen::Matrix4d rowsHessian = hessian(*m);
  if (convex)
  {
    rowsHessian = withoutNegativeEigenvalues(rowsHessian);
  }
  const Eigen::Matrix4d& toRows = partsToRows();
  result.value = m->det * m->energy;
  result.gradient = toRows.transpose() * (m->measureByRows.transpose() * m->byMeasure());
  result.hessian = toRows.transpose() * rowsHessian * toRows;
  return result;
}

namespace
{
/// Of shareOver5Percent.
constexpr double noticeable = 0.05;
/// A strain that is beyond its limit by less is rounding of one that lies on it.
constexpr double rounding = 1e-9;

/// By how many times the width of the limits a strain is beyond them; 0 within.
double excess(double strain, const StrainLimits& limits)
{
  if (strain > limits.greatest + rounding)
  {
    return (strain - limits.greatest) / limits.greatest;
  }
  return strain < limits.least - rounding ? (limits.least - strain) / -limits.least : 0.0;
}

double excess(const ThreadStrain& strain, const ClothMaterial& material)
{
  const double lock = material.shearLimit;
  if (!isPossible(strain))
  {
    return largestThreadStrain / rounding;
  }
  return std::max({ excess(strain.warp, material.warpLimits),
    excess(strain.weft, material.weftLimits), excess(strain.shear, { -lock, lock }) });
}
}

std::vector<ThreadStrain> measureThreads(
  const TriangleFrames& frames, const Triangles& triangles, const Points2& positions)
{
  std::vector<ThreadStrain> strains(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (!(frames[t].area > 0.0))
    {
      continue; // without extent it has no strain
    }
    Eigen::Vector2d a = Eigen::Vector2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      // From the first corner, which keeps the digits of pieces far from the origin.
      const Point2 d = positions[triangles[t][k]] - positions[triangles[t][0]];
      const Eigen::Vector2d gradient(frames[t].gradient[k].real(), frames[t].gradient[k].imag());
      a += 2.0 * d.x() * gradient;
      b += 2.0 * d.y() * gradient;
    }
    strains[t] = threadStrain(a, b);
  }
  return strains;
}

ClothSummary summarizeThreads(const TriangleFrames& frames,
  const std::vector<ThreadStrain>& strains, const ClothMaterial& material)
{
  ClothSummary summary;
  summary.outOfLimit.assign(strains.size(), 0);
  double area = 0.0;
  double whole = 0.0;
  double worst = 0.0;
  for (std::size_t t = 0; t < strains.size(); ++t)
  {
    const ThreadStrain& strain = strains[t];
    const double weight = frames[t].area;
    const double beyond = weight > 0.0 ? excess(strain, material) : 0.0;
    area += weight;
    if (beyond > 0.0)
    {
      summary.outOfLimit[t] = 1;
      summary.shareOutOfLimit += weight;
    }
    if (beyond > worst)
    {
      worst = beyond;
      summary.worstTriangle = static_cast<Index>(t);
    }
    if (std::max(std::abs(strain.warp), std::abs(strain.weft)) > noticeable)
    {
      summary.shareOver5Percent += weight;
    }
    if (!(std::abs(strain.shear) < material.shearLimit - rounding))
    {
      summary.shareLocked += weight;
    }
    if (isPossible(strain))
    {
      whole += weight;
      summary.warpRms += weight * strain.warp * strain.warp;
      summary.weftRms += weight * strain.weft * strain.weft;
      summary.shearRms += weight * strain.shear * strain.shear;
    }
  }
  for (double* rms : { &summary.warpRms, &summary.weftRms, &summary.shearRms })
  {
    *rms = whole > 0.0 ? std::sqrt(*rms / whole) : 0.0;
  }
  for (double* share :
    { &summary.shareOutOfLimit, &summary.shareOver5Percent, &summary.shareLocked })
  {
    *share = area > 0.0 ? std::min(1.0, *share / area) : 0.0;
  }
  return summary;
}
}
