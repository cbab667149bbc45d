// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ClothPromises.h"

#include "Base/Planar.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
std::string quoted(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "\"" : ", \"") + name + "\"";
  }
  return text;
}

Status missingGrain(
  const std::vector<FeatureCurve>& curves, const ClothOptions& cloth, const GrainReport& grain)
{
  const char* const none =
    cloth.grainCurves.size() == 1 ? " is no curve of the piece" : " are no curves of the piece";
  Status status{ StatusCode::MissingGrain,
    quoted(cloth.grainCurves) + none + " that its grain can follow; its warp lies by its upright",
    {}, {} };
  if (!grain.candidates.empty())
  {
    constexpr std::size_t most = 5;
    const auto named = static_cast<std::ptrdiff_t>(std::min(most, grain.candidates.size()));
    status.waysOut.emplace_back(Remedy::NameGrain,
      quotedNames(curves, { grain.candidates.begin(), grain.candidates.begin() + named }));
  }
  status.waysOut.emplace_back(Remedy::GiveGrainAngle);
  return status;
}

/// By how much one measure is beyond its limits, over the limit.
struct Excess
{
  std::string text;
  double size = 0.0;
};

void consider(const std::string& thread, double strain, const StrainLimits& limits, Excess& worst)
{
  const bool drawn = strain > 0.0;
  const double limit = drawn ? limits.greatest : limits.least;
  const double size = strain / limit - 1.0;
  if (size > worst.size)
  {
    worst = { thread + (drawn ? " drawn by " : " compressed by ") + percent(std::abs(strain)) +
        " where " + percent(std::abs(limit)) + " is allowed",
      size };
  }
}

/// Of the triangle farthest out.
std::string describeWorst(const ThreadStrain& strain, const ClothMaterial& material)
{
  if (!isPossible(strain))
  {
    return "turned over";
  }
  Excess worst;
  consider("its warp", strain.warp, material.warpLimits, worst);
  consider("its weft", strain.weft, material.weftLimits, worst);
  const double shear = std::abs(strain.shear);
  if (shear / material.shearLimit - 1.0 > worst.size)
  {
    worst.text = "its threads sheared by " + shortNumber(shear / degree) + " degrees where " +
      shortNumber(material.shearLimit / degree) + " are allowed";
  }
  return worst.text;
}

Status beyondLimits(const std::vector<FeatureCurve>& curves, const ClothOptions& cloth,
  const FlatteningResult& result)
{
  const ClothReport& report = *result.pieces.back().cloth;
  const Index worst = report.outOfLimit.front();
  std::string wire;
  if (report.limitingCurve != none)
  {
    wire = ", most of it along " + quotedNames(curves, { report.limitingCurve });
  }
  else if (report.limitedByBoundary)
  {
    wire = ", most of it along the boundary";
  }
  Status status{ StatusCode::BeyondLimits,
    percent(report.threads.shareOutOfLimit) +
      " of its area is beyond the limits of the material \"" + cloth.material.name + "\"" + wire +
      ": triangles " + listIds(report.outOfLimit) + ", the first of them farthest, " +
      describeWorst(result.threads[worst], cloth.material),
    { ElementKind::Cells, report.outOfLimit }, { Remedy::AddDarts, Remedy::DivideBySeam } };
  if (report.limitingCurve != none)
  {
    status.waysOut.emplace_back(
      Remedy::ReleaseCurves, quotedNames(curves, { report.limitingCurve }));
  }
  status.waysOut.emplace_back(Remedy::TakeSofterCloth);
  return status;
}
}

std::vector<Status> brokenClothPromises(const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const FlatteningResult& result)
{
  std::vector<Status> broken;
  if (!options.cloth)
  {
    return broken;
  }
  const auto& report = result.pieces.back().cloth;
  if (report && report->grain.missing)
  {
    broken.push_back(missingGrain(curves, *options.cloth, report->grain));
  }
  if (report && report->threads.shareOutOfLimit > toleratedShareOutOfLimit)
  {
    broken.push_back(beyondLimits(curves, *options.cloth, result));
  }
  return broken;
}
}
