// SPDX-License-Identifier: BSD-3-Clause
#include "SeamTemplate.h"

#include "CurveList.h"
#include "InputError.h"
#include "Paths/PlaneSection.h"
#include "Surface/SurfacePreparation.h"
#include "TriangleList.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cmath>
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

vtkSmartPointer<vtkPolyData> seamsOf(const SeamTemplate& seams, vtkPolyData* surface)
{
  const vtkNew<vtkPolyData> healed;
  vtkFlatteningAlgorithm::Heal(surface, healed);
  const TriangleList list = listTriangles(healed->GetNumberOfCells() > 0 ? healed.Get() : surface);
  flattening::Points3 points;
  for (vtkIdType k = 0; list.points && k < list.points->GetNumberOfPoints(); ++k)
  {
    points.emplace_back(Eigen::Map<const Point3>(list.points->GetPoint(k)));
  }
  flattening::Triangles triangles;
  for (const ListedTriangle& triangle : list.triangles)
  {
    const auto corner = [&triangle](std::size_t k) {
      return static_cast<flattening::Index>(triangle.corners[k]);
    };
    triangles.push_back({ corner(0), corner(1), corner(2) });
  }
  const flattening::PreparedSurface prepared = flattening::prepareSurface(points, triangles);
  if (!prepared.status.ok())
  {
    throw InputError("--template: " + prepared.status.message);
  }
  const Axes axes = axesOf(prepared.mesh);
  const vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  CurveList curves;
  for (const Point3& normal : planesOf(seams, axes))
  {
    for (const flattening::PlaneSection& section :
      flattening::planeSections(prepared.mesh, axes.center, normal))
    {
      std::vector<vtkIdType> ids;
      for (const flattening::SurfacePoint& point : section.path.points)
      {
        ids.push_back(places->InsertNextPoint(point.position.data()));
      }
      ids.back() = section.closed ? ids.front() : ids.back();
      curves.add(ids, { *curveKindOf("seam"), seams.name == "gores" ? "gore" : "side" });
    }
  }
  if (curves.empty())
  {
    throw InputError("--template " + seams.name + ": no plane meets the surface");
  }
  return curves.polyData(places);
}
}
