// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/ClothRest.h"

#include "Sewing/SheetDensity.h"

namespace flattening
{
namespace
{
/// Far from rest the exact Hessian is seldom convex; it pays once no vertex moves by that many
/// roots of the mean triangle area.
constexpr double exactWithin = 0.3;
/// A step that moves a vertex farther could turn triangles over.
constexpr double maximumMove = 1.0;
/// Nothing moves any more, in roots of the mean triangle area.
constexpr double stepTolerance = 1e-11;
/// Of the body beside that of the cloth, an area, where lengths are in roots of the mean triangle
/// area: first soft, then, while a vertex is inside, ten times as hard.
constexpr double firstPush = 1.0;
constexpr double hardening = 10.0;
constexpr int mostHardenings = 4;
}

NewtonKktState bringToRest(
  SewingModel& model, const Points3& from, const RestOptions& options, const Execution& execution)
{
  NewtonKktOptions newton;
  newton.maximumIterations = options.maximumIterations;
  newton.optimalityTolerance = isotropicModulus * options.forceTolerance;
  newton.reductionTolerance = options.energyTolerance;
  newton.stepTolerance = stepTolerance;
  newton.exactWithin = exactWithin;
  newton.maximumMove = maximumMove;
  newton.phase = options.phase;
  newton.observe = options.observe;
  const auto minimumFrom = [&](const Eigen::VectorXd& x) {
    return minimize(model, { x, {} }, LinearSolver(model.eliminationOrder()), newton, execution);
  };
  if (!model.hasBody())
  {
    return minimumFrom(model.unknownsAt(from));
  }
  NewtonKktState state{ model.unknownsAt(from), {} };
  double stiffness = firstPush;
  for (int k = 0; k <= mostHardenings; ++k)
  {
    model.push(ContactForce::Penalty, stiffness);
    state = minimumFrom(state.x);
    if (state.cancelled())
    {
      return state;
    }
    if (model.leastDistance(state.x, execution) > 0.0)
    {
      model.push(ContactForce::Barrier, stiffness);
      return minimumFrom(state.x);
    }
    stiffness *= hardening;
  }
  return state;
}
}
