// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/VertexFan.h"

namespace flattening
{
double angleSum(const TriangleMesh& mesh, Index vertex)
{
  double sum = 0.0;
  for (Index h : VertexFan(mesh, vertex))
  {
    sum += mesh.angle(h);
  }
  return sum;
}

double vertexArea(const TriangleMesh& mesh, Index vertex)
{
  double area = 0.0;
  for (Index h : VertexFan(mesh, vertex))
  {
    area += mesh.area(h / 3) / 3.0;
  }
  return area;
}

double turnOf(const TriangleMesh& mesh, const Indices& loop)
{
  double turn = 0.0;
  for (Index h : loop)
  {
    turn += pi - angleSum(mesh, mesh.from(h));
  }
  return turn;
}
}
