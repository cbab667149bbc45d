// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ContinuedWarping.h"

#include "Angles/AngleProblem.h"
#include "Quality/FlatteningQuality.h"

namespace flattening
{
namespace
{
/// A vertex lies where the mean of its triangles has it.
Points2 startOf(const PieceContext& context)
{
  const TriangleMesh& mesh = context.piece.mesh;
  Points2 positions(mesh.vertexCount(), Point2::Zero());
  std::vector<double> count(mesh.vertexCount(), 0.0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const FlatCorners& corners =
      context.options.start[context.cut.originalTriangle(context.piece.triangles[t])];
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const Index v = mesh.triangle(t)[k];
      positions[v] += corners[k];
      count[v] += 1.0;
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    positions[v] /= count[v];
  }
  return positions;
}
}

std::optional<PlacedWires> warpFromGivenStart(const PieceContext& context, const CurveRules& rules)
{
  const FlatteningOptions& options = context.options;
  if (options.start.empty() || options.scheme != Scheme::Isometric || options.cloth)
  {
    return std::nullopt;
  }
  PlacedWires flat;
  flat.wires.rules = rules;
  flat.wires.problem =
    makeWireProblem(context.network, context.piece, context.cut, context.curves, rules);
  if (flat.wires.locks() || !flat.wires.problem.groups.empty())
  {
    return std::nullopt;
  }
  const Points2 start = startOf(context);
  if (countFlipped(context.piece.mesh, start) > 0)
  {
    return std::nullopt;
  }
  flat.wires.angles.theta = planarAngles(flat.wires.problem, start);
  flat.wires.angles.length = flat.wires.problem.length;
  IsometricSolution solution = warpIsometrically(
    context.piece, flat.wires.problem, start, {}, options.isometric, context.execution);
  if (!solution.status.ok() || countFlipped(context.piece.mesh, solution.positions) > 0)
  {
    return std::nullopt;
  }
  flat.placed.positions = solution.positions;
  flat.placed.isometric = std::move(solution);
  flat.placed.energyUsed = options.isometric.energy.kind;
  flat.placed.fromGivenStart = true;
  return flat;
}
}
