// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/InteriorRelaxation.h"

#include "Base/CompressedRows.h"
#include "Embedding/InteriorSystem.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
Status checkOptions(const InteriorOptions& options)
{
  if (!std::isfinite(options.relaxation) || options.relaxation <= 0.0 || options.relaxation >= 2.0)
  {
    return invalidOption(
      "the relaxation factor lies outside its range", "a number between 0 and 2, both excluded");
  }
  if (options.minimumIterations < 0 || options.maximumIterations < 1 ||
    options.minimumIterations > options.maximumIterations || !std::isfinite(options.movement) ||
    options.movement < 0.0)
  {
    return { StatusCode::InvalidOption,
      "the relaxation cannot be run with these numbers of iterations, or this movement", {},
      { Remedy::OrderRelaxation } };
  }
  return {};
}

double meanWireEdge(const WireNetwork& network)
{
  double sum = 0.0;
  for (const WireEdge& edge : network.edges)
  {
    sum += edge.length;
  }
  return network.edges.empty() ? 0.0 : sum / static_cast<double>(network.edges.size());
}

/// Neighbors of the interior vertices of a patch. All edges at such a vertex have two triangles
/// here: one sees the edge leave the vertex, the other arrive, so those that leave are all, once.
CompressedRows collectNeighbors(const InteriorPatch& patch)
{
  return groupMembers(patch.freeCount, [&patch](const auto& visit) {
    for (const Triangle& c : patch.triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (c[k] < patch.freeCount)
        {
          visit(c[k], c[(k + 1) % 3]);
        }
      }
    }
  });
}

struct Relaxed
{
  int iterations = 0;
  bool converged = false;
};

/// \param smallest a sweep that moves no vertex farther is the last.
Relaxed relaxPatch(const InteriorPatch& patch, const TriangleMesh& mesh,
  const InteriorOptions& options, double smallest, Points2& positions)
{
  const CompressedRows near = collectNeighbors(patch);
  const auto at = [&](Index v) -> Point2& { return positions[patch.vertices[v]]; };
  std::vector<double> weight(near.members.size()); // of Eq. 11
  for (Index v = 0; v < patch.freeCount; ++v)
  {
    for (Index i = near.begin[v]; i < near.begin[v + 1]; ++i)
    {
      weight[i] =
        1.0 / (mesh.point(patch.vertices[v]) - mesh.point(patch.vertices[near.members[i]])).norm();
    }
  }
  const auto count = static_cast<Index>(patch.vertices.size());
  Point2 center = Point2::Zero();
  for (Index v = patch.freeCount; v < count; ++v)
  {
    center += at(v) / static_cast<double>(count - patch.freeCount);
  }
  for (Index v = 0; v < patch.freeCount; ++v)
  {
    at(v) = center;
  }
  Relaxed result;
  while (result.iterations < options.maximumIterations && !result.converged)
  {
    ++result.iterations;
    double most = 0.0;
    for (Index v = 0; v < patch.freeCount; ++v)
    {
      Point2 sum = Point2::Zero();
      double total = 0.0;
      for (Index i = near.begin[v]; i < near.begin[v + 1]; ++i)
      {
        sum += weight[i] * at(near.members[i]);
        total += weight[i];
      }
      const Point2 move = options.relaxation * (sum / total - at(v));
      at(v) += move;
      most = std::max(most, move.norm());
    }
    result.converged = result.iterations >= options.minimumIterations && most < smallest;
  }
  return result;
}
}

InteriorResult relaxInterior(const Piece& piece, const WireNetwork& network,
  const InteriorOptions& options, const Execution& execution, Points2& positions)
{
  InteriorResult result;
  result.status = checkOptions(options);
  if (!result.status.ok())
  {
    return result;
  }
  const std::vector<InteriorPatch> patches = collectInteriorPatches(piece, network);
  std::vector<Relaxed> relaxed(patches.size());
  const double smallest = options.movement * meanWireEdge(network);
  Points2 moved = positions;
  execution.forEachTask(static_cast<Index>(patches.size()),
    [&](Index k) { relaxed[k] = relaxPatch(patches[k], piece.mesh, options, smallest, moved); });
  if (execution.cancelled())
  {
    result.status = { StatusCode::Cancelled, "cancelled while placing the interior", {} };
    return result;
  }
  positions = std::move(moved);
  Indices moving;
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    result.iterations = std::max(result.iterations, relaxed[k].iterations);
    if (!relaxed[k].converged)
    {
      moving.push_back(patches[k].patch);
    }
  }
  if (!moving.empty())
  {
    result.status = { StatusCode::NotConverged,
      "the relaxation of the inside of wire-patch " + listIds(moving) +
        " did not come to rest in the iterations that are allowed",
      { ElementKind::WirePatches, moving }, { Remedy::AllowRelaxationIterations } };
  }
  return result;
}

InteriorResult placeInterior(const Piece& piece, const WireNetwork& network,
  const InteriorOptions& options, const Execution& execution, Points2& positions,
  InteriorSystems* kept)
{
  return options.method == InteriorMethod::Relaxation
    ? relaxInterior(piece, network, options, execution, positions)
    : embedInterior(piece, network, options, execution, positions, kept);
}
}
