// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace flattening
{
/// A wire-node as a hinge between its two edges.
struct WireHinge
{
  double length = 0.0;          ///< mean of the two edges
  double angle = 0.0;           ///< on the surface
  bool sheetOnBothSides = true; ///< of both edges
};

/// How stiff the wires of a piece are against bending.
///
/// A wire keeps its length, so the sheet that would shorten it presses on it, and what is pressed
/// buckles. The sheet holds it: a wire of bending energy B (kappa - kappa_0)^2 per length on a
/// sheet of modulus E wrinkles at the least force N where N q^2 = 2 B q^4 + c q has a solution, c
/// about 2 E / 3 at an edge of the sheet and twice that inside, so at B = (N / 2.4)^3 / c^2. So B
/// grows with the cube of the pressing force, from a small least value on; wires in tension keep
/// that. Forces belong to the surface and B to the length, not to the mesh: a hinge of length l
/// costs B / l times the square of its angle's change, and a finer mesh of the same surface gives
/// the same shape.
///
/// Energies and lengths are those of IsometricModel.
class WireStiffness
{
public:
  /// \param weight of all terms. \param sheetArea of the piece. \param sheetModulus over that of
  /// the rigid energy.
  WireStiffness(double weight, double sheetArea, double sheetModulus);

  /// Where forces are not known yet.
  double unknownForce(const WireHinge& hinge) const;
  /// Under a force that presses (positive) or draws.
  double underForce(const WireHinge& hinge, double force) const;

private:
  double ofBending(const WireHinge& hinge, double bending) const;

  double Weight;
  double Area;
  double Modulus;
};
}
