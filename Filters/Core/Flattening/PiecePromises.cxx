// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PiecePromises.h"

#include <algorithm>

namespace flattening
{
namespace
{
Status lengthError(double error)
{
  return { StatusCode::LengthError,
    "a wire edge misses its length by the fraction " + shortNumber(error) +
      "; release a feature curve",
    {} };
}

Status flippedTriangles(const Indices& flipped)
{
  return { StatusCode::FlippedTriangles,
    std::to_string(flipped.size()) + " triangle(s) are flipped: " + listIds(flipped) +
      "; add darts or release curves there",
    flipped };
}

/// The cuts with a bank vertex on an edge that crosses another one.
Indices crossingCuts(const CutSurface& cut, const PieceReport& report)
{
  const TriangleMesh& mesh = cut.mesh;
  std::vector<char> crossing(mesh.vertexCount(), 0);
  for (const auto& pair : report.overlaps.listed)
  {
    for (Index h : pair)
    {
      crossing[mesh.from(h)] = crossing[mesh.to(h)] = 1;
    }
  }
  Indices curves;
  for (const SeamPair& pair : cut.seamPairs)
  {
    if (crossing[mesh.from(pair.first)] || crossing[mesh.to(pair.first)] ||
      crossing[mesh.from(pair.second)] || crossing[mesh.to(pair.second)])
    {
      curves.push_back(pair.curve);
    }
  }
  std::sort(curves.begin(), curves.end());
  curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  return curves;
}

Status overlap(const CutSurface& cut, const std::vector<FeatureCurve>& curves, bool closeCuts,
  const PieceReport& report)
{
  Indices triangles;
  for (const auto& pair : report.overlaps.listed)
  {
    triangles.push_back(pair[0] / 3);
    triangles.push_back(pair[1] / 3);
  }
  std::string message = "the piece overlaps itself at triangles " + listIds(triangles);
  const Indices cuts = crossingCuts(cut, report);
  if (!cuts.empty())
  {
    message += ", where the banks of " + quotedNames(curves, cuts) + " cross";
  }
  message += !cuts.empty() && !closeCuts
    ? "; close cuts where they cross (option close cuts), or divide the piece there by a seam"
    : "; divide it by a seam";
  return { StatusCode::Overlap, message, triangles };
}

/// A piece that is not at a minimum: what is wrong with it, and what fits it as a way out.
void explain(const FlatteningOptions& options, PieceReport& report)
{
  Status& status = report.status;
  const bool sequential = options.angles.method == AngleMethod::Sequential;
  if (report.boundaryLoops > 1)
  {
    status.message += ", or cut it open by a seam from one boundary loop to the next";
  }
  if (report.wired && !sequential)
  {
    status.message += ", or release a feature curve";
  }
  const Indices& flipped = report.quality.flipped;
  status.ids = flipped;
  if (!flipped.empty())
  {
    status.message +=
      " (" + std::to_string(flipped.size()) + " triangle(s) are flipped: " + listIds(flipped) + ")";
  }
}
}

void judgePiece(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, PieceReport& report)
{
  if (report.status.code == StatusCode::NotConverged)
  {
    explain(options, report);
  }
  if (!report.status.ok())
  {
    return;
  }
  const QualitySummary& quality = report.quality;
  if (options.scheme != Scheme::Conformal &&
    !(quality.maximumEdgeLengthError <= options.lengthTolerance))
  {
    report.status = lengthError(quality.maximumEdgeLengthError);
  }
  else if (!quality.flipped.empty())
  {
    report.status = flippedTriangles(quality.flipped);
  }
  else if (report.overlaps.count > 0)
  {
    report.status = overlap(cut, curves, options.closeCuts, report);
  }
}
}
