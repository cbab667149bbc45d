// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathRelaxation.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// The path is relaxed in 2, 4 and 8 parts, as long as each has so many points.
constexpr std::size_t fewestPoints = 8;
constexpr int mostRelaxations = 6;
/// Rounds that gain less are not worth their time.
constexpr double leastShortening = 1e-6;

/// Sections through points of the path at equal parts of its length, or half-way between these; not
/// arrived where one of them does not, or they come to be longer than the path.
SurfacePath joinedBySections(const TriangleMesh& mesh, const SnapDistance& snap,
  const SurfacePath& path, double length, std::size_t parts, bool between)
{
  SurfacePath joined;
  joined.points.push_back(path.points.front());
  double joinedLength = 0.0;
  double done = 0.0;
  double next = (between ? 0.5 : 1.0) / static_cast<double>(parts);
  for (std::size_t i = 1; i < path.points.size(); ++i)
  {
    done += (path.points[i].position - path.points[i - 1].position).norm();
    if (i + 1 < path.points.size() && (done < next * length || next > 1.0 - 1e-9))
    {
      continue;
    }
    const SurfacePath section =
      traceSegment(mesh, snap, joined.points.back(), path.points[i], length - joinedLength);
    joinedLength += lengthOf(section);
    if (!section.arrived)
    {
      return {};
    }
    joined.points.insert(joined.points.end(), section.points.begin() + 1, section.points.end());
    joined.triangles.insert(
      joined.triangles.end(), section.triangles.begin(), section.triangles.end());
    next += 1.0 / static_cast<double>(parts);
  }
  joined.arrived = true;
  return joined;
}
}

SurfacePath relaxed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path)
{
  double length = lengthOf(path);
  for (const std::size_t parts : { 2, 4, 8 })
  {
    int idle = 0;
    const double before = length;
    for (int round = 0; round < mostRelaxations && idle < 2; ++round)
    {
      if (path.points.size() < parts * fewestPoints)
      {
        return path;
      }
      SurfacePath joined = joinedBySections(mesh, snap, path, length, parts, round % 2 == 1);
      const double joinedLength = lengthOf(joined);
      const bool gained = joined.arrived && joinedLength < (1.0 - leastShortening) * length;
      idle = gained ? 0 : idle + 1;
      if (gained)
      {
        path = std::move(joined);
        length = joinedLength;
      }
    }
    if (length == before)
    {
      break;
    }
  }
  return path;
}
}
