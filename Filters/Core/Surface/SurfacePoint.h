// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfaceLocator.h"
#include "Surface/TriangleMesh.h"

#include <unordered_map>

namespace flattening
{
/// The smallest element of the mesh that a point of the surface lies on.
enum class SurfacePointType
{
  Vertex,
  Edge,
  Face,
};

/// A point of the surface, tied to the mesh by ids, not by coordinates alone.
struct SurfacePoint
{
  SurfacePointType type = SurfacePointType::Vertex;
  /// A vertex; a half-edge, the smaller one of its edge; a triangle.
  Index id = none;
  /// Weights of the vertex; of from() and to() of the half-edge; of the corners of the triangle.
  std::array<double, 3> weights{ 1.0, 0.0, 0.0 };
  Point3 position = Point3::Zero();
};

/// How near to an element of the mesh a point has to be to move onto it: a fraction of the mean
/// edge length, or of the longest edge of the triangles there where that is less.
class SnapDistance
{
public:
  SnapDistance(const TriangleMesh& mesh, double fraction);

  /// No distance is greater, where no triangle was enlarged.
  double greatest() const { return this->Fraction * this->Mean; }
  double ofVertex(Index vertex) const;
  double ofEdge(Index halfedge) const;
  double ofFace(Index triangle) const;
  /// Snaps more in a triangle so thin that its parts would have no area.
  void enlarge(Index triangle);

private:
  double longestEdge(Index triangle) const;

  const TriangleMesh& Mesh;
  double Fraction;
  double Mean = 0.0;
  std::unordered_map<Index, double> Factors;
};

/// The smaller half-edge of an edge stands for both.
Index edgeOf(const TriangleMesh& mesh, Index halfedge);
SurfacePoint vertexPoint(const TriangleMesh& mesh, Index vertex);
/// At a fraction of a half-edge.
SurfacePoint edgePoint(const TriangleMesh& mesh, Index halfedge, double fraction);
/// The same, or the vertex of an end that it is next to but for rounding: nearer than 1e-13 of the
/// edge.
SurfacePoint crossingPoint(const TriangleMesh& mesh, Index halfedge, double fraction);
/// The point with what lies within the snap distance taken for its type.
SurfacePoint snapToMesh(
  const TriangleMesh& mesh, const SnapDistance& snap, const ClosestPoint& closest);

/// The point of the boundary that is nearest to one; that one where there is no boundary.
Point3 nearestOnBoundary(const TriangleMesh& mesh, const Point3& point);

Points3 positionsOf(const std::vector<SurfacePoint>& points);

/// Whether two points have the same type, id and weights.
bool samePlace(const SurfacePoint& a, const SurfacePoint& b);

/// The triangles around a point: one, two, or a vertex's fan.
Indices trianglesAround(const TriangleMesh& mesh, const SurfacePoint& point);
/// True where the point lies in the closed triangle.
bool contains(const TriangleMesh& mesh, Index triangle, const SurfacePoint& point);
/// True where the point lies on the closed edge of the half-edge.
bool edgeHolds(const TriangleMesh& mesh, Index halfedge, const SurfacePoint& point);
/// Whether it is a vertex of the boundary or lies on an edge of it.
bool onBoundary(const TriangleMesh& mesh, const SurfacePoint& point);
/// A half-edge whose closed edge holds both points; none if there is none.
Index commonEdge(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);
/// A triangle that holds both points; none if there is none.
Index commonTriangle(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);
/// Unit normal; at vertices the mean of the triangles' normals weighted by their angles.
Point3 normalAt(const TriangleMesh& mesh, const SurfacePoint& point);
Point3 triangleNormal(const TriangleMesh& mesh, Index triangle);
}
