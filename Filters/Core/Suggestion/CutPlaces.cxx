// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutPlaces.h"

#include "Quality/VertexClusters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{
constexpr Index mostTips = 140;
/// Darts inside join the places with most curvature.
constexpr std::size_t mostSites = 24;
/// Tips are also the vertices with most curvature, in radians.
constexpr double apexDefect = 0.3;
constexpr std::size_t mostApexes = 16;

std::vector<double> angleDefects(const TriangleMesh& mesh)
{
  std::vector<double> defects(mesh.vertexCount(), 2.0 * pi);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    defects[mesh.from(h)] -= mesh.angle(h);
  }
  return defects;
}
}

CutPlaces cutPlaces(const TriangleMesh& mesh, const std::vector<char>& barred)
{
  Indices inside;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.outgoing(v) != none && !mesh.onBoundary(v) && !barred[v])
    {
      inside.push_back(v);
    }
  }
  const Indices cluster = clusterVertices(mesh, inside, mostTips);
  const Index count = std::min<Index>(mostTips, static_cast<Index>(inside.size()));
  std::vector<Point3> center(count, Point3::Zero());
  std::vector<double> members(count, 0.0);
  for (Index v : inside)
  {
    center[cluster[v]] += mesh.point(v);
    members[cluster[v]] += 1.0;
  }
  Indices tips(count, none);
  const auto miss = [&](Index v) {
    return (mesh.point(v) - center[cluster[v]] / members[cluster[v]]).squaredNorm();
  };
  for (Index v : inside)
  {
    Index& tip = tips[cluster[v]];
    tip = tip == none || miss(v) < miss(tip) ? v : tip;
  }
  const std::vector<double> defects = angleDefects(mesh);
  std::vector<std::pair<double, Index>> curved(count, { 0.0, none });
  for (Index v : inside)
  {
    curved[cluster[v]].first -= defects[v];
    curved[cluster[v]].second = tips[cluster[v]];
  }
  std::sort(curved.begin(), curved.end());
  // Where curvature is concentrated a dart has to end exactly there.
  Indices apexes = inside;
  const auto sharper = [&](
                         Index a, Index b) { return std::abs(defects[a]) > std::abs(defects[b]); };
  std::stable_sort(apexes.begin(), apexes.end(), sharper);
  apexes.resize(std::min(apexes.size(), mostApexes));
  for (Index v : apexes)
  {
    if (std::abs(defects[v]) > apexDefect && std::find(tips.begin(), tips.end(), v) == tips.end())
    {
      tips.push_back(v);
    }
  }
  CutPlaces places;
  for (const auto& [defect, tip] : curved)
  {
    if (defect < 0.0 && places.sites.size() < mostSites)
    {
      places.sites.push_back(tip);
    }
  }
  tips.erase(std::remove(tips.begin(), tips.end(), none), tips.end());
  places.tips = std::move(tips);
  return places;
}
}
