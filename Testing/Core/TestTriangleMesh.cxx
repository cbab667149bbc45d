// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CompressedRows.h"
#include "Base/Types.h"
#include "ClosedMeshes.h"
#include "Surface/VertexFan.h"

#include <set>

using namespace flattening;
using namespace testmeshes;

TEST(TriangleMesh, BoundaryLoopsAreClosedChainsWithTheLongestFirst)
{
  const TriangleMesh mesh = revolved(9, 1, 0.0, [](double share) { return 1.0 + share; });
  const std::vector<Indices> loops = mesh.boundaryLoops();
  ASSERT_EQ(loops.size(), 2U);
  for (const Indices& loop : loops)
  {
    ASSERT_EQ(loop.size(), 9U);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      EXPECT_EQ(mesh.twin(loop[k]), none);
      EXPECT_EQ(mesh.to(loop[k]), mesh.from(loop[(k + 1) % loop.size()]));
    }
  }
  EXPECT_GE(mesh.from(loops.front().front()), 9) << "the outer circle has the later vertices";
  EXPECT_EQ(eulerCharacteristic(mesh), 0);
}

TEST(TriangleMesh, EulerCharacteristicCountsOnlyVerticesThatTrianglesUse)
{
  const TriangleMesh tetrahedron(
    { Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1), Point3(9, 9, 9) },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  EXPECT_EQ(eulerCharacteristic(tetrahedron), 2);
  EXPECT_TRUE(tetrahedron.boundaryLoops().empty());
  EXPECT_FALSE(tetrahedron.onBoundary(0));
  EXPECT_EQ(tetrahedron.outgoing(4), none);
}

TEST(TriangleMesh, AFanHoldsEachHalfEdgeThatLeavesAVertexOnceWhereverItLies)
{
  const TriangleMesh mesh = flatPatch(4, 3).mesh;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    std::set<Index> expected;
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      if (mesh.from(h) == v)
      {
        expected.insert(h);
      }
    }
    Indices found;
    for (Index h : VertexFan(mesh, v))
    {
      found.push_back(h);
    }
    EXPECT_EQ(std::set<Index>(found.begin(), found.end()), expected) << v;
    EXPECT_EQ(found.size(), expected.size()) << v;
    // Counter-clockwise: the triangle of one half-edge leads to the next, to the left of the first.
    for (std::size_t k = 0; k + 1 < found.size(); ++k)
    {
      EXPECT_EQ(mesh.to(found[k + 1]), mesh.from(TriangleMesh::previous(found[k]))) << v;
    }
    if (!mesh.onBoundary(v))
    {
      Indices shifted;
      for (Index h : VertexFan::startingAt(mesh, found[1]))
      {
        shifted.push_back(h);
      }
      std::rotate(found.begin(), found.begin() + 1, found.end());
      EXPECT_EQ(shifted, found) << v;
    }
  }
}
