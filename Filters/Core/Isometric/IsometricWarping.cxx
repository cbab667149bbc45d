// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricWarping.h"

#include "Base/Ending.h"
#include "Embedding/WireLayout.h"
#include "Sparse/NewtonKkt.h"

namespace flattening
{
namespace
{
/// In the model's unit of length; correctWireLengths() takes out what is left of the lengths'
/// errors.
constexpr double lengthTolerance = 1e-10;
constexpr double stillMove = 1e-10;
constexpr double stillLengthTolerance = 1e-8;
/// Far from the minimum the exact Hessian is seldom convex; it pays once no vertex moves by
/// that unit.
constexpr double exactWithin = 1.0;
/// Wires nearly close where the scheme starts and multipliers change little; with the margin of the
/// directions form, 1.5, hard pieces take up to half as many steps more.
constexpr double penaltyMargin = 1.2;
/// Torques of locked angles are many times the forces of lengths.
constexpr double penaltyShare = 0.1;
/// A key's locked angles add up along it and bend its far end off the linear step.
constexpr int corrections = 5;
/// Forces change so little from there on that the piece does not: with 1e-1 and 1e-5 all measures
/// of 72 pieces are the same to three digits.
constexpr double settlePromise = 1e-3;
constexpr double settleConstraint = 1e-2;
/// A piece that has not come near a minimum by then may do so with other wires.
constexpr int settleBy = 30;

NewtonKktOptions newtonOptions(const IsometricOptions& options)
{
  NewtonKktOptions newton;
  newton.maximumIterations = options.maximumIterations;
  newton.constraintTolerance = lengthTolerance;
  newton.optimalityTolerance = options.tolerance;
  newton.promiseTolerance = options.tolerance * options.tolerance;
  newton.stillMove = stillMove;
  newton.stillConstraintTolerance = stillLengthTolerance;
  newton.exactWithin = exactWithin;
  newton.penaltyMargin = penaltyMargin;
  newton.penaltyShare = penaltyShare;
  newton.corrections = corrections;
  newton.settlePromise = settlePromise;
  newton.settleConstraint = settleConstraint;
  newton.settleBy = settleBy;
  newton.phase = "Warping wires and interior together";
  return newton;
}

IsometricSolution minimized(IsometricModel& model, const Eigen::VectorXd& start,
  const IsometricOptions& options, const Execution& execution)
{
  IsometricSolution solution;
  NewtonKktOptions newton = newtonOptions(options);
  newton.observe = [&](const NewtonKktRecord& record) {
    solution.history.push_back(
      { record.objective, record.violation, record.optimality, record.largestMove, record.exact });
    solution.iterations = record.iteration;
  };
  const NewtonKktState end =
    minimize(model, { start, {} }, LinearSolver(model.eliminationOrder(start)), newton, execution);
  if (end.cancelled())
  {
    solution = {};
    solution.status = { StatusCode::Cancelled, "cancelled while solving for the piece", {} };
    return solution;
  }
  const IsometricModel::Terms terms = model.terms(end.x, execution);
  solution.positions = model.positions(end.x);
  solution.stretch = model.stretches(end.x);
  solution.distortionEnergy = terms.sheet;
  solution.angleEnergy = terms.angles;
  solution.stiffness = model.stiffness();
  if (!end.converged())
  {
    const bool exhausted = end.ending == Ending::Exhausted;
    const std::string iterations = std::to_string(solution.iterations) + " iterations";
    solution.status = { StatusCode::NotConverged,
      exhausted ? "the isometric scheme did not converge in " + iterations
                : "the isometric scheme stopped short of a minimum after " + iterations +
          ", and more would change nothing",
      {}, exhausted ? WaysOut{ Remedy::AllowIsometricIterations } : WaysOut{} };
  }
  return solution;
}
}

IsometricSolution warpIsometrically(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& startStretch, const IsometricOptions& options,
  const Execution& execution)
{
  IsometricModel model(piece, problem, options.energy, options.angleWeight);
  IsometricSolution solution =
    minimized(model, model.unknowns(start, startStretch), options, execution);
  if (!solution.status.refused())
  {
    const WireNetwork& network = *problem.network;
    std::vector<double> length = problem.length;
    for (Index e = 0; e < network.edgeCount(); ++e)
    {
      const Index group = problem.stretchGroup[e];
      if (network.edges[e].connector)
      {
        length[e] =
          (solution.positions[network.edges[e].to] - solution.positions[network.edges[e].from])
            .norm();
      }
      else if (group != none)
      {
        length[e] *= 1.0 + solution.stretch[group];
      }
    }
    correctWireLengths(network, length, solution.positions);
  }
  return solution;
}
}
