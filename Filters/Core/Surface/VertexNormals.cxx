// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/VertexNormals.h"

namespace flattening
{
Points3 vertexNormals(const TriangleMesh& mesh)
{
  Points3 normals(mesh.vertexCount(), Point3::Zero());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const Point3 normal =
      areaVector(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2])).normalized();
    for (int k = 0; k < 3; ++k)
    {
      normals[c[k]] += mesh.angle(3 * t + k) * normal;
    }
  }
  for (Point3& normal : normals)
  {
    normal.normalize();
  }
  return normals;
}
}
