// SPDX-License-Identifier: BSD-3-Clause
#include "BodyInput.h"

#include "SurfaceInput.h"

#include "vtkPolyData.h"

namespace flattening
{
namespace bridge
{
namespace
{
bool isInsideOut(const TriangleMesh& mesh)
{
  double volume = 0.0;
  const Point3& origin = mesh.point(0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      if (mesh.twin(h) == none)
      {
        return false;
      }
    }
    volume +=
      (mesh.point(c[0]) - origin).dot((mesh.point(c[1]) - origin).cross(mesh.point(c[2]) - origin));
  }
  return volume < 0.0;
}
}

LoadedBody loadBody(vtkPolyData* body)
{
  LoadedBody result;
  if (!body)
  {
    return result;
  }
  const LoadedSurface surface = loadSurface(body, CoincidentPoints::Automatic, Defects::Heal);
  result.outcome = surface.outcome;
  if (!result.outcome.ok())
  {
    // Ids would be taken for those of the surface.
    result.outcome.message = "the body: " + result.outcome.message;
    result.outcome.ids = {};
    return result;
  }
  result.mesh = surface.prepared.mesh;
  result.given = true;
  if (isInsideOut(result.mesh))
  {
    Triangles turned = result.mesh.triangles();
    for (Triangle& c : turned)
    {
      std::swap(c[1], c[2]);
    }
    result.mesh = TriangleMesh(result.mesh.points(), std::move(turned));
  }
  return result;
}
}
}
