// SPDX-License-Identifier: BSD-3-Clause
#include "SeamTemplate.h"

#include "CurveList.h"
#include "InputError.h"
#include "Paths/PlaneSection.h"
#include "Report/FlatteningData.h"
#include "Surface/SurfacePreparation.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
using flattening::Point3;

constexpr int usualGores = 6;
constexpr double pi = 3.14159265358979323846;

/// Up is of y and z the axis along which the surface is larger, as patterns have it.
struct Axes
{
  Point3 center;
  Point3 up;
  Point3 across; ///< the longer side that is level
  Point3 ahead;  ///< the shorter one
};

Axes axesOf(const flattening::TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Point3& point : mesh.points())
  {
    box.extend(point);
  }
  const Point3 sides = box.sizes();
  const int up = sides.y() > sides.z() ? 1 : 2;
  const int other = 3 - up;
  const bool wide = sides.x() >= sides[other];
  return { box.center(), Point3::Unit(up), Point3::Unit(wide ? 0 : other),
    Point3::Unit(wide ? other : 0) };
}

/// Normals of the planes.
std::vector<Point3> planesOf(const SeamTemplate& seams, const Axes& axes)
{
  if (seams.name == "front-back")
  {
    return { axes.ahead };
  }
  const int gores = seams.pieces > 0 ? seams.pieces : usualGores;
  std::vector<Point3> normals;
  for (int k = 0; k < gores / 2; ++k)
  {
    const double angle = (2 * k + 1) * pi / gores; // so that a gore is in front
    normals.emplace_back(std::cos(angle) * axes.across + std::sin(angle) * axes.ahead);
  }
  return normals;
}
}

DataSet seamsOf(const SeamTemplate& seams, const DataSet& surface)
{
  DataSet healed;
  const bool mended = !flattening::healData(surface, healed).empty();
  const flattening::SurfaceTriangles read = flattening::readTriangles(mended ? healed : surface);
  const flattening::PreparedSurface prepared =
    flattening::prepareSurface(read.points, read.triangles);
  if (!prepared.status.ok())
  {
    throw InputError("--template: " + prepared.status.message);
  }
  const Axes axes = axesOf(prepared.mesh);
  Points3 places;
  CurveList curves;
  for (const Point3& normal : planesOf(seams, axes))
  {
    for (const flattening::PlaneSection& section :
      flattening::planeSections(prepared.mesh, axes.center, normal))
    {
      std::vector<std::int64_t> ids;
      for (const flattening::SurfacePoint& point : section.path.points)
      {
        ids.push_back(static_cast<std::int64_t>(places.size()));
        places.push_back(point.position);
      }
      ids.back() = section.closed ? ids.front() : ids.back();
      curves.add(ids, { *curveKindOf("seam"), seams.name == "gores" ? "gore" : "side" });
    }
  }
  if (curves.empty())
  {
    throw InputError("--template " + seams.name + ": no plane meets the surface");
  }
  return curves.over(std::make_shared<const Points3>(std::move(places)));
}
}
