// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Base/Execution.h"
#include "Cut/SurfaceCut.h"
#include "Isometric/IsometricSheet.h"
#include "Surface/RegionWeights.h"

#include <optional>
#include <vector>

namespace flattening
{
/// A cloth in the place of a sheet that is alike in all directions.
struct ClothSheet
{
  ClothMaterial material;
  /// Of what is beyond the material's limits, over that of its stiffer thread.
  double limitStiffness = 0.0;
  GrainHold hold;
};

struct IsometricOptions
{
  DistortionEnergy energy;
  std::optional<ClothSheet> cloth; ///< then the energy above does not count
  /// By triangle of the cut surface: the energy of each counts as if its area were multiplied by
  /// its weight over the piece's mean, at least by BoundaryFilling::share.
  RegionWeights weights;
  /// The solution is only where another run starts, or compared with others: it ends once little is
  /// left to gain, before the forces in the wires say how stiff each is.
  bool rough = false;
  /// One of many runs of a few steps, far from a minimum: with the convex part of the Hessian, and
  /// without leaving saddles.
  bool inRounds = false;
  /// Weight of the wires' bending against the sheet's energy, 0 to 100. Lengths alone would let
  /// wires buckle between their nodes; the larger it is, the nearer are the wires' angles to those
  /// on the surface. What a bend costs follows from the force that presses on the wire, the same on
  /// every mesh of a surface (WireStiffness).
  double angleWeight = 5.0;
  int maximumIterations = 100;
  /// Stop when lengths hold to `lengthTolerance` of the root of the mean triangle area (what is
  /// left is taken out at the end) and the gradient of the Lagrangian, relative to the root of the
  /// energy, is below the tolerance, or the energy that a further step promises, relative to the
  /// energy, below its square; or when a whole Newton step moved no vertex by more than 1e-10 of
  /// that and left lengths to 1e-8 of it.
  double tolerance = 1e-9;
  double lengthTolerance = 1e-10;
};

struct IsometricIteration
{
  double energy = 0.0;
  double constraint = 0.0; ///< largest length error, in roots of the mean triangle area
  double optimality = 0.0; ///< largest entry of the gradient of the Lagrangian
  double step = 0.0;       ///< largest move of a vertex, in the same unit
  bool exact = false;      ///< exact Hessian, or its convex part
};

struct IsometricSolution
{
  Points2 positions;
  std::vector<double> stretch;   ///< h per stretch group
  double distortionEnergy = 0.0; ///< sum of the density times area over the mean area
  double angleEnergy = 0.0;      ///< sum of stiffness (theta - alpha)^2
  std::vector<double> stiffness; ///< per wire-node, in the same unit; 0 for nodes without a term
  int iterations = 0;
  int factorizations = 0; ///< which take most of the time, those of the way from afar as well
  std::vector<IsometricIteration> history;
  /// Ok, NotConverged (the positions are the best found), Cancelled.
  Status status;
};

/// Solves for wires and interior together: all vertices move, every rigid wire edge keeps its
/// length.
///
/// Sequential quadratic programming from the given positions, which the other schemes provide: the
/// exact Hessian of the Lagrangian where it is convex on the tangent space of the constraints (read
/// from the inertia of the KKT matrix), its convex part where not, an L1 merit function with
/// second-order correction, and last a minimum-norm Newton iteration on the lengths alone. Wires
/// are equally stiff at first; once little is left to gain, the forces in them say how stiff each
/// stays, and the iteration goes on with that.
/// \param filling of the plane beside the piece, which must not turn over
IsometricSolution warpIsometrically(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& startStretch, const IsometricOptions& options,
  const Execution& execution, const BoundaryFilling& filling = {});

/// The same from positions that may miss the wires' lengths by far, but have no fold if the energy
/// knows a barrier, and get none: lengths and locked angles are sought by penalties that grow
/// (descend()), so that pressed wires have time to give way, before the iteration above ends it.
/// Its steps alone are counted and recorded.
IsometricSolution warpByPenaltyContinuation(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& startStretch, const IsometricOptions& options,
  const Execution& execution);
}
