// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolution.h"
#include "Cloth/ClothMaterial.h"
#include "Embedding/InteriorEmbedding.h"
#include "Embedding/LeastSquaresConformalMap.h"
#include "Flattening/CurveEase.h"
#include "Isometric/IsometricWarping.h"

namespace flattening
{
enum class Scheme
{
  Progressive,           ///< patch by patch, Algorithm 2
  Global,                ///< all patches together, Eq. 13
  Isometric,             ///< wires and interior together
  LeastSquaresConformal, ///< LSCM, for comparison: keeps no length
};

/// Which lengths of the boundary are kept.
enum class BoundaryMode
{
  Exact, ///< all
  Free,  ///< those that accessory and key curves name, which only the isometric scheme can
};

/// How the two legs of a dart lie in the plane.
enum class DartLegs
{
  Free,     ///< each as it distorts least: sewn they fit, folded they may miss each other
  Straight, ///< both straight; those of a dart with two tips as Mirrored, since straight ones close
            ///< it
  Mirrored, ///< both the mean of the two curves that free legs are, mirror images of each other
};

/// How a piece lies on its cloth.
enum class GrainKind
{
  Upright, ///< by the angle from the piece's upright
  Curve,   ///< by the angle from one of its curves
  Free,    ///< where the cloth is strained least
};

/// The cloth that pieces are cut from, and how.
struct ClothOptions
{
  ClothMaterial material;
  GrainKind grain = GrainKind::Upright;
  /// Curve: names; of each piece the first that lies in it, from its start to its end. A piece
  /// without any is laid by its upright, and its report says so.
  std::vector<std::string> grainCurves;
  /// Curve: one for each of them, from it to the warp, counter-clockwise in the plane, in radians.
  std::vector<double> grainAngles;
  /// The same from the upright, where that counts. Upright is the first key curve, else the long
  /// side of the smallest rectangle around the piece, as it lies without the material.
  double grainAngle = 0.0;
};

/// Where the corners of a triangle lie in the plane.
using FlatCorners = std::array<Point2, 3>;

/// All defaults of the project are these and those of the options inside, but for dartLegs, which
/// Options/OptionTable sets to Mirrored: filters, command, Python package and plugin take them over
/// or are tested for it.
struct FlatteningOptions
{
  Scheme scheme = Scheme::Isometric;
  BoundaryMode boundary = BoundaryMode::Exact;
  /// Free: keep the boundary from crossing itself (see warpWithoutOverlap()).
  bool preventOverlap = false;
  /// With that, of pieces on trial: the strain on 95 % of the area that is enough. They are kept
  /// from overlapping from `start` on, or from a convex map, and without wires no further than to
  /// there, or until that is out of reach. 0: to a minimum.
  double enoughStrain = 0.0;
  /// How far each stretch of the boundary between ends of other wires may go from its length on the
  /// surface, as a fraction in [0, 1); 0 is rigid.
  double boundaryTolerance = 0.0;
  /// Isometric scheme: by triangle where it lay before more of the surface was cut. Pieces that
  /// lengths alone hold go on from there, which is quicker than from the wires' angles, to the same
  /// minimum or one beside it (see warpFromGivenStart()). Empty: all start from their angles.
  std::vector<FlatCorners> start;
  AngleSolverOptions angles;
  InteriorOptions interior;
  IsometricOptions isometric;
  LeastSquaresConformalOptions conformal; ///< pins are vertices of the surface before the cut
  /// The isometric scheme takes its energy; others only measure what it would have to do. Without a
  /// value pieces lie on nothing and no thread is measured.
  std::optional<ClothOptions> cloth;
  /// Close cuts where their sides would overlap (see closeCuts()).
  bool closeCuts = false;
  /// Whether darts are to fold, leg on leg.
  DartLegs dartLegs = DartLegs::Free;
  /// Whether legs are held to fold: with a free boundary none are.
  bool foldsDarts() const
  {
    return this->dartLegs != DartLegs::Free && this->boundary == BoundaryMode::Exact;
  }
  /// Curves that are longer in one of their pieces than in the other (see decideEases()).
  std::vector<CurveEase> eases;
  /// Leave out pieces without boundary or with handles instead of refusing the surface for them.
  bool skipClosed = false;
  /// Treat key curves as accessory curves.
  bool releaseKeys = false;
  /// Flatten a piece that lies poorly without each of up to six curves, to advise on releases;
  /// otherwise curves are ranked by their sensitivity alone.
  bool tryReleases = true;
  /// How much work these trials may take, as factorizations of the isometric scheme times triangles
  /// of the piece: about two seconds on a core of 2024. Counted, not timed: the same on any
  /// machine.
  double trialWork = 2.5e6;
  /// Lay the pieces beside each other, each upright (see arrangePieces()); otherwise each stays
  /// where its first wire edge put it.
  bool arrange = true;
  /// Space between the bounding boxes of arranged pieces, as a fraction of the largest side of one,
  /// 0 to 1e6.
  double spacing = 0.05;
  /// A wire edge whose relative length error is larger is a LengthError.
  double lengthTolerance = 1e-9;
};

/// With the energy that Automatic stands for.
FlatteningOptions withEnergy(FlatteningOptions options);

/// InvalidOption where a number of the options lies outside its range or the material is unknown or
/// without meaning; numbers of the interior are checked where it is placed.
Status checkOptions(const FlatteningOptions& options);
}
