// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Cut/SurfaceCut.h"
#include "Sewing/BodyContact.h"
#include "Sewing/SewingLoads.h"
#include "Sewing/SewnMembrane.h"
#include "Sparse/NewtonKkt.h"
#include "Sparse/NewtonKktStep.h"

#include <memory>

namespace flattening
{
/// Flat cloth that is sewn together, as a problem: one mesh in space, whose triangles are flat
/// pieces at rest.
struct SewnCloth
{
  Points3 points; ///< the design, where held vertices stay
  Triangles triangles;
  std::vector<std::array<Point2, 3>> flat; ///< corners of each triangle at rest
  Indices twins;          ///< per half-edge the other one of its edge, also across a seam; none
  std::vector<char> held; ///< per vertex
  Points3 outwards;       ///< per vertex, of length 1; only where outsideBias is not 0

  /// Of a triangle at rest, and of all.
  double restArea(std::size_t triangle) const;
  double restArea() const;
};

/// How the cloth behaves.
struct ClothProperties
{
  double areaBias = 0.0;  ///< see evaluateIsotropicDensity()
  double thickness = 0.0; ///< of a plate that bends like it, in the unit of length
  double anchor = 0.0;    ///< see DesignAnchor
  double outsideBias = 0.0;
  double pressure = 0.0; ///< along the normals, over modulus; one over the unit of length
  /// That it does not go through; null: none.
  const TriangleMesh* body = nullptr;
  double gap = 0.0; ///< from the body, in the unit of length
  /// With threads, weft along x and warp along y of the rest; null: the isotropic sheet.
  const ClothMaterial* material = nullptr;
  /// Weight per area, over modulus; one over the unit of length.
  Point3 weight = Point3::Zero();
};

/// Cloth in space for Newton's method, in units of the root of the mean triangle area at rest.
///
/// Unknowns: x, y and z of every vertex that is not held. Minimized is the energy of SewnMembrane
/// and SheetBending, whose stiffness is that of a plate, modulus thickness^2 / 12, and that of
/// DesignAnchor, InnerPressure, ClothWeight and BodyContact. The modulus of a material is that of
/// its stiffer thread. There are no constraints. Where nothing is held or
/// anchored, three vertices are kept from moving the whole: six directions of the Newton step, no
/// force.
class SewingModel : public NewtonKktModel
{
public:
  /// \pre an area at rest above zero.
  SewingModel(const SewnCloth& cloth, const ClothProperties& properties);

  double unit() const { return this->Unit; }
  /// The unknowns where the vertices lie there.
  Eigen::VectorXd unknownsAt(const Points3& points) const;
  Points3 positions(const Eigen::VectorXd& x) const;

  struct Terms
  {
    double membrane = 0.0;
    double bending = 0.0;
    double anchor = 0.0;
    double pressure = 0.0;
    double weight = 0.0;
    double contact = 0.0;
  };
  /// In units of the mean triangle area times half the modulus.
  Terms terms(const Eigen::VectorXd& x, const Execution& execution) const;
  /// How the body pushes from now on; at first it does not.
  void push(ContactForce force, double stiffness) { this->Contact.push(force, stiffness); }
  bool hasBody() const { return this->Body != nullptr; }
  /// The least distance of a free vertex from the body, in the unit of length; infinite without.
  double leastDistance(const Eigen::VectorXd& x, const Execution& execution) const
  {
    return this->Unit * this->Contact.leastDistance(x, execution);
  }
  Dissection eliminationOrder() const;

  Index unknownCount() const override { return this->Count; }
  Index constraintCount() const override { return 0; }
  double objective(const Eigen::VectorXd& x, const Execution& execution) const override;
  Eigen::VectorXd constraints(const Eigen::VectorXd& /*x*/) const override { return {}; }
  Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
    Curvature curvature, double delta, const Execution& execution) override;
  bool hasConvexPart() const override { return true; }
  void shift(double tau) override;
  const SparseMatrix& kkt() const override { return this->Hessian.matrix(); }
  Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& /*multipliers*/) const override
  {
    return Eigen::VectorXd::Zero(this->Count);
  }

private:
  void chooseGauge();
  void holdMotion(const Eigen::VectorXd& x);

  Point3 Center;
  double Unit;
  SpaceUnknowns Unknowns;
  Index Count = 0;
  SewnMembrane Membrane;
  SheetBending Bending;
  DesignAnchor Anchor;
  InnerPressure Pressure;
  ClothWeight Weight;
  std::unique_ptr<ContactBody> Body;
  BodyContact Contact;
  std::array<Index, 3> Gauge{ none, none, none };
  SpaceMatrix Hessian;
};

/// When cloth is at rest.
struct RestOptions
{
  /// A further step promises to lower the energy by no more than this fraction of it, or no force
  /// on a vertex is more than rounding.
  double energyTolerance = 1e-9;
  int maximumIterations = 300;
  const char* phase = nullptr; ///< name in reports of progress; null: none are made
  std::function<void(const NewtonKktRecord&)> observe;
};

/// Goes from there to the minimum of the model next to it. A body pushes by a penalty first, and by
/// a barrier once no vertex is inside; where no penalty achieves that it stays with the last.
/// \param from per vertex of the cloth.
NewtonKktState bringToRest(
  SewingModel& model, const Points3& from, const RestOptions& options, const Execution& execution);

/// How the flat pieces are tested.
enum class SewingTest
{
  /// Each piece on its own, its boundary held where the design has it: what the sewer's hand does
  /// with a panel that is eased into its place.
  Panel,
  /// All that is sewn together, seams shared and hems free.
  Product,
};

/// Pieces that hang together, ready to come to rest.
struct SewnShape
{
  SewnCloth cloth;
  Indices triangles; ///< of the cut surface
  Indices vertices;  ///< per vertex of the cloth the first of the cut surface that is sewn to it
  Index pieces = 0;
  bool sewn = false; ///< at one edge at least
};

struct SewnTopology
{
  std::vector<SewnShape> shapes;
  Indices shapeOfTriangle;
  Indices vertexInShape; ///< per vertex of the cut surface; none: in no triangle
};

/// Divides the cut surface into what comes to rest together: Panel its pieces, Product what is sewn
/// together.
/// \param positions in the plane, per vertex of the cut surface.
SewnTopology sewnShapes(const CutSurface& cut, const Points2& positions, SewingTest test);
}
