// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/DrawingSurface.h"

#include "Imprint/ImprintedSurface.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
DrawingSurface::DrawingSurface(TriangleMesh mesh)
  : Mesh(std::move(mesh))
  , Graph(this->Mesh)
  , Locator(this->Mesh)
  , Snap(this->Mesh, ImprintOptions().snap)
{
  for (const Indices& loop : this->Mesh.boundaryLoops())
  {
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const Index before = loop[k];
      const Index after = loop[(k + 1) % loop.size()];
      const Point3& vertex = this->Mesh.point(this->Mesh.to(before));
      if (angleBetween(vertex - this->Mesh.point(this->Mesh.from(before)),
            this->Mesh.point(this->Mesh.to(after)) - vertex) > cornerTurn)
      {
        this->Corners.push_back(this->Mesh.to(before));
      }
    }
    this->Boundary.insert(this->Boundary.end(), loop.begin(), loop.end());
  }
}

SurfacePoint DrawingSurface::pointNear(const Point3& point) const
{
  return snapToMesh(this->Mesh, this->Snap, this->Locator.closest(point));
}

SurfacePath DrawingSurface::pathThrough(const Points3& points) const
{
  SurfacePath path;
  for (const Point3& point : points)
  {
    const SurfacePoint next = this->pointNear(point);
    if (!path.points.empty())
    {
      const Index triangle = commonTriangle(this->Mesh, path.points.back(), next);
      if (triangle == none)
      {
        return {};
      }
      path.triangles.push_back(triangle);
    }
    path.points.push_back(next);
  }
  path.arrived = path.points.size() > 1;
  return path;
}
}
