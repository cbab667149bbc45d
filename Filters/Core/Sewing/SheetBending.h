// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/SewnMembrane.h"

namespace flattening
{
/// What bending a sheet costs that is flat at rest, by the squared jumps of its slope across its
/// edges: 1/2 stiffness sum_e |sum_k K_k x_k|^2 / A_e over the edges between two triangles, with
/// K_k = 2 A grad(phi_k) . grad(phi_opposite) of both triangles and A_e the sum of their areas (M.
/// Bergou, M. Wardetzky, D. Harmon, D. Zorin, E. Grinspun, "A quadratic bending model for
/// inextensible surfaces", 2006). |sum K_k x_k| is 2 l sin(angle / 2) for an edge of length l. A
/// third of the weight there, which is three times the energy of a cylinder on a regular grid,
/// where every third edge takes all of its bending; here it is that of the cylinder. Isometric
/// motions change no weight, so the Hessian is constant.
class SheetBending
{
public:
  /// \param sheet its triangles and their rest. Two triangles at an edge bend it, whether they were
  /// sewn together there or hang together: a seam is as stiff as the cloth.
  /// \param twins per half-edge the other one of its edge in the sewn sheet, or none.
  SheetBending(const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const Indices& twins,
    double stiffness);

  double energy(const Eigen::VectorXd& x) const;
  void declare(SpaceMatrix& matrix);
  /// Adds gradient and Hessian at x.
  void add(const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const;
  /// Vertices that it couples, for an order of elimination.
  void addCliques(Triangles& cliques) const;

private:
  struct Hinge
  {
    std::array<Index, 4> vertices; ///< ends of the edge, then the corners opposite to it
    Eigen::Vector4d weights;
    double stiffness;
    std::array<SymmetricBlock<4>, 3> blocks; ///< of x, y and z
  };
  Point3 bend(const Hinge& hinge, const Eigen::VectorXd& x) const;

  const SpaceUnknowns& Unknowns;
  std::vector<Hinge> Hinges;
};
}
