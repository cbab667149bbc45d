// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/SewnMembrane.h"
#include "Surface/SurfaceLocator.h"

namespace flattening
{
/// A surface that cloth does not go through, its normals outwards. What lies beyond its boundary,
/// where it has one, is free.
class ContactBody
{
public:
  explicit ContactBody(TriangleMesh mesh);
  ContactBody(const ContactBody&) = delete;
  ContactBody& operator=(const ContactBody&) = delete;

  /// How far a point lies outside, less than zero inside, and the direction in which that grows.
  struct Place
  {
    double distance = 0.0;
    Point3 outwards = Point3::Zero();
  };
  /// By the normal of the nearest triangle, edge or vertex (see vertexNormals()).
  Place locate(const Point3& point) const;

private:
  Point3 normalOf(Index triangle, const std::array<double, 3>& weights, bool& atBoundary) const;

  TriangleMesh Mesh;
  SurfaceLocator Locator;
  Points3 FaceNormals;
  Points3 VertexNormals;
};

/// How contact is kept up.
enum class ContactForce
{
  None,
  Penalty, ///< 1/2 stiffness (gap - distance)^2 an area, also inside
  Barrier, ///< -stiffness (gap - distance)^2 ln(distance / gap) an area, infinite inside
};

/// What cloth is pushed with that is nearer to a body than a gap: C2 at the gap (the barrier is
/// that of M. Li et al., "Incremental potential contact", ACM Transactions on Graphics 39(4),
/// 2020). Vertices touch, not the triangles between them.
class BodyContact
{
public:
  /// \param sheet its triangles and their rest, in a unit in which the mean area is 1.
  /// \param body in the same unit; null: there is none.
  BodyContact(
    const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const ContactBody* body, double gap);

  void push(ContactForce force, double stiffness)
  {
    this->Force = force;
    this->Stiffness = stiffness;
  }
  double energy(const Eigen::VectorXd& x, const Execution& execution) const;
  /// Adds gradient and the convex part of the Hessian at x.
  void add(const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient,
    const Execution& execution) const;
  /// The least distance of a free vertex from the body; infinite without one.
  double leastDistance(const Eigen::VectorXd& x, const Execution& execution) const;

private:
  struct Touch
  {
    Index first; ///< unknown of x; those of y and z follow
    double area;
  };
  std::vector<ContactBody::Place> places(
    const Eigen::VectorXd& x, const Execution& execution) const;

  const ContactBody* Body;
  double Gap;
  ContactForce Force = ContactForce::None;
  double Stiffness = 0.0;
  std::vector<Touch> Touches;
};
}
