// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

/// Triangles of the meshes that several tests make, without places for their vertices.
namespace testmeshes
{
using namespace flattening;

/// Rings of `columns` vertices around vertex 0, joined along `meridians` of their edges: closed
/// rings where there are as many, a fan where there is one vertex more.
inline Triangles ringTriangles(Index meridians, Index rings, Index columns)
{
  Triangles triangles;
  const auto id = [&](Index ring, Index k) { return 1 + ring * columns + k % columns; };
  for (Index k = 0; k < meridians; ++k)
  {
    triangles.push_back({ 0, id(0, k), id(0, k + 1) });
    for (Index ring = 1; ring < rings; ++ring)
    {
      triangles.push_back({ id(ring - 1, k), id(ring, k), id(ring, k + 1) });
      triangles.push_back({ id(ring - 1, k), id(ring, k + 1), id(ring - 1, k + 1) });
    }
  }
  return triangles;
}

/// Two triangles for each of columns x rows quads, whose diagonals run one way.
inline Triangles gridTriangles(Index columns, Index rows)
{
  Triangles triangles;
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const Index a = j * (columns + 1) + i;
      const Index d = a + columns + 1;
      triangles.push_back({ a, a + 1, d + 1 });
      triangles.push_back({ a, d + 1, d });
    }
  }
  return triangles;
}
}
