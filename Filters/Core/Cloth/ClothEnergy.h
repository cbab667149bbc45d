// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMaterial.h"
#include "Embedding/DistortionEnergy.h"
#include "Surface/TriangleFrame.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace flattening
{
/// A function of one variable with two derivatives.
struct Curve2
{
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

/// Half the square of what x is above 0, but with a second derivative that rises to 1 over [0,
/// width] along 3 t^2 - 2 t^3 instead of a jump.
inline Curve2 smoothRamp(double x, double width)
{
  if (!(x > 0.0))
  {
    return {};
  }
  const double t = x / width;
  if (t < 1.0)
  {
    const double t3 = t * t * t;
    return { width * width * t3 * t * (0.25 - 0.1 * t), width * t3 * (1.0 - 0.5 * t),
      t * t * (3.0 - 2.0 * t) };
  }
  const double beyond = x - 0.5 * width;
  return { 0.5 * beyond * beyond + width * width / 40.0, beyond, 1.0 };
}

/// Strains of a cloth that lies in the plane, weft along x and warp along y, when it is put onto
/// the surface by the inverse of the linear map J of a triangle. With the rows a and b of J, the
/// gradients of x and y on the triangle, a weft thread of length 1 becomes |b| / det J long there
/// and a warp thread |a| / det J, at right angles less asin(a . b / (|a| |b|)).
struct ThreadStrain
{
  double warp = 0.0;  ///< |a| / det J - 1
  double weft = 0.0;  ///< |b| / det J - 1
  double shear = 0.0; ///< change of the angle between the threads, in radians
};

/// No strain counts as more than this; a triangle that is turned over or has collapsed, which no
/// cloth does, has it in both threads.
constexpr double largestThreadStrain = 100.0;

inline ThreadStrain threadStrain(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  constexpr double rightAngle = 1.57079632679489661923;
  const double det = cross(a, b);
  const double warp = a.norm();
  const double weft = b.norm();
  if (!(det > 0.0 && std::max(warp, weft) < largestThreadStrain * det))
  {
    return { largestThreadStrain, largestThreadStrain, rightAngle };
  }
  return { warp / det - 1.0, weft / det - 1.0, std::atan2(a.dot(b), det) };
}

/// Whether a cloth can have it.
inline bool isPossible(const ThreadStrain& strain)
{
  return strain.warp < largestThreadStrain;
}

/// Stiffness of a material's stiffer thread in its energies, as |J - R|^2 has it for a stretch in
/// one direction; the other stiffnesses are in proportion.
inline constexpr double stiffestThread = 2.0;

/// Half the square of a thread's strain, times compression where it is shorter than at rest; the
/// second derivative passes from one to the other over two parts in a thousand.
Curve2 threadEnergy(double strain, double compression);

/// What it costs a cloth to take the shape of the surface, per area of the surface:
///   det J (k_v f(e_v) + k_u f(e_u) + k_uv e_u e_v + k_s g^2 / 2 + limits),
/// with the strains e_v of the warp, e_u of the weft and the shear g of ThreadStrain, f(e) = e^2 /
/// 2 where a thread is drawn and the softer r e^2 / 2 where it is compressed, joined with two
/// derivatives, and limits the half squares of what strains and shear are beyond the material's
/// limits, of strains that are 5 % beyond in proportion from there on. The factor det J makes it an
/// energy of the cloth, which lies in the plane. It is without bound where a triangle collapses.
///
/// Stiffnesses are scaled so that the stiffer thread has 2: then a sheet with k_u = k_v = 2 k_s
/// costs |J - R|^2 to second order.
class ClothEnergy
{
public:
  /// \param material that checkMaterial() lets pass. \param limitStiffness of what is beyond a
  /// limit, over that of the stiffer thread; 0: limits do not count.
  ClothEnergy(const ClothMaterial& material, double limitStiffness);

  /// For the map with these parts (see DistortionEnergyValue), weft along x and warp along y.
  /// \param convex replace the Hessian by the nearest positive semidefinite one.
  DistortionEnergyValue evaluate(const Eigen::Vector4d& parts, bool convex) const;
  /// The same gradient alone, which takes a tenth of the time.
  Eigen::Vector4d gradient(const Eigen::Vector4d& parts) const;
  double density(const Eigen::Vector4d& parts) const;

  /// How hard an edge of the sheet is to bend inwards, over that of |J - R|^2: of an orthotropic
  /// half-plane with the threads along and across its edge, the mean of both ways (its surface
  /// compliance is in Lekhnitskii, "Anisotropic plates", 1968). Soft shear makes it soft.
  double edgeModulus() const;

private:
  struct Thread
  {
    double stiffness;
    double compression;
    StrainLimits limits;
  };

  struct Measures;

  double strainEnergy(const ThreadStrain& strain) const;
  /// No value where no cloth can have the map.
  std::optional<Measures> measure(const Eigen::Vector4d& parts) const;
  static Eigen::Matrix4d hessian(const Measures& m);

  Thread Warp;
  Thread Weft;
  double Cross;
  double Shear;
  double ShearLimit;
  double LimitStiffness;
};

/// Rows of J, one after the other, of a map given by its parts (q, p).
Eigen::Vector4d rowsOfMap(const Eigen::Vector4d& parts);

/// What the threads of a flat piece have to do on the surface. Means and shares are by area on the
/// surface; triangles that are turned over or have no area do not count in means, and those that
/// are turned over count as out of limit.
struct ClothSummary
{
  double warpRms = 0.0; ///< root mean square of the strain
  double weftRms = 0.0;
  double shearRms = 0.0; ///< in radians
  double shareOutOfLimit = 0.0;
  double shareOver5Percent = 0.0; ///< of warp or weft, drawn or compressed
  double shareLocked = 0.0;       ///< sheared to the material's limit or beyond
  std::vector<char> outOfLimit;   ///< per triangle
  Index worstTriangle = none;     ///< of those out of limit, the one farthest out
};

/// \param outline planar positions of the corners, per triangle, weft along x and warp along y.
std::vector<ThreadStrain> measureThreads(
  const TriangleFrames& frames, const Triangles& triangles, const Points2& positions);

ClothSummary summarizeThreads(const TriangleFrames& frames,
  const std::vector<ThreadStrain>& strains, const ClothMaterial& material);
}
