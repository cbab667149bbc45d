// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceContext.h"

namespace flattening
{
/// What the grain of a piece is measured from, in every shape that the piece takes in the plane:
/// the line from the start of one of its curves to its end, or the upright of the piece as it lies
/// without a material, turned with it by the rotation that fits it best.
class GrainReference
{
public:
  /// By the curve of the options that lies in the piece, or by the upright: its first key curve,
  /// else the long side of the smallest rectangle around it. \param positions without a material.
  GrainReference(const PieceContext& context, const Points2& positions);

  Index curve() const { return this->Curve; }
  /// The angle of the grain that the options ask for.
  double asked() const { return this->Asked; }

  /// From the reference to the warp, which lies along y, counter-clockwise, in (-pi, pi].
  double angle(const Points2& positions) const;
  /// What became of it. \param context as before.
  GrainReport report(const PieceContext& context, const Points2& positions) const;
  /// The piece turned around its first vertex so that the grain has the angle.
  Points2 turned(double angle, const Points2& positions) const;
  /// Keeps the angle of the grain that the piece has: of a curve the direction of its line, of the
  /// upright that of the piece as a whole, which no vertex feels more than others.
  GrainHold hold(const Points2& positions) const;

private:
  void takeCurve(const PieceContext& context, Index curve);
  double direction(const Points2& positions) const;
  double bend(const Points2& positions) const;

  Indices Line; ///< the curve's vertices in the piece, in its order; two at least, or none
  Index Curve = none;
  bool Missing = false;
  double Asked = 0.0;
  Points2 Plain;             ///< where the upright was taken
  double Upright = 0.0;      ///< direction there
  std::vector<double> Share; ///< of each vertex in the area
};
}
