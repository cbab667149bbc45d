// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/WireStiffness.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
// All per unit of weight, chosen by 49 pieces of garments and shoes at a weight of 5.

/// Bending stiffness over the area to the power 1.5. The least one spreads the bend that a wire's
/// end makes in another over about a thirtieth of the piece; the first holds wires nearly in their
/// shape while forces are found; beyond the largest the wires' own stiffness makes the forces.
constexpr double leastBending = 7.3e-6;
constexpr double firstBending = 2e-5;
constexpr double largestBending = 8e-5;
/// Bending stiffness over the cube of the force: seven times what keeps the edge of a sheet from
/// wrinkling, which is 1.9 times the force.
constexpr double bendingByForce = 0.06;
/// Inside, the sheet holds four times as much (c^2), and two hinges bend together.
constexpr double shareInside = 1.0 / 8.0;
/// Wires that meet, and corners, bend in one point: least stiffness there, in triangles of mean
/// area, so that what finer meshes smooth over is no kink in coarser ones. It fades out where the
/// angle nears a straight one, from a turn of 37 degrees on.
constexpr double cornerStiffness = 0.2;
constexpr double cornerSlope = 5.0;
}

WireStiffness::WireStiffness(double weight, double sheetArea, double sheetModulus)
  : Weight(weight)
  , Area(sheetArea)
  , Modulus(sheetModulus)
{
}

double WireStiffness::ofBending(const WireHinge& hinge, double bending) const
{
  const double corner =
    cornerStiffness * std::min(1.0, cornerSlope * (1.0 + std::cos(hinge.angle)));
  return this->Weight * this->Modulus * std::max(bending / hinge.length, corner);
}

double WireStiffness::unknownForce(const WireHinge& hinge) const
{
  return this->ofBending(hinge, firstBending * std::pow(this->Area, 1.5));
}

double WireStiffness::underForce(const WireHinge& hinge, double force) const
{
  const double unit = std::pow(this->Area, 1.5);
  const double pressing = std::max(0.0, force) / this->Modulus;
  const double needed =
    (hinge.sheetOnBothSides ? shareInside : 1.0) * bendingByForce * std::pow(pressing, 3);
  return this->ofBending(hinge, std::clamp(needed, leastBending * unit, largestBending * unit));
}
}
