// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NestedDissection.h"

#include "Sparse/PlaneDissector.h"

namespace flattening
{
Dissection dissect(const Triangles& cliques, const Points3& positions, Separators separators)
{
  return PlaneDissector(cliques, positions, separators).run();
}

Dissection dissect(const Triangles& cliques, Index count)
{
  return LevelDissector(cliques, count).run();
}
}
