// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Embedding/InteriorSystem.h"

namespace flattening
{
/// Places the interior vertices of one wire-patch as rigidly as possible, those on its wires being
/// pinned: least sum of A_t |J_t - R_t|^2 over the triangles, R_t the rotation nearest to J_t (L.
/// Liu et al., "A local/global approach to mesh parameterization", Computer Graphics Forum 27(5),
/// 2008).
///
/// With J = (alpha, beta) as in TriangleFrame the energy is 2 A_t ((|alpha| - 1)^2 + |beta|^2),
/// whose Hessian is at hand (its eigensystem: B. Smith, F. de Goes, T. Kim, "Analytic eigensystems
/// for isotropic distortion energies", ACM TOG 38(1), 2019). Newton's method with conjugate
/// gradients on the exact Hessian, truncated at negative curvature, converges quadratically. The
/// preconditioner is the cotangent matrix of the local/global method, factored once: it bounds the
/// Hessian from above, so that its steps always descend, and with pinned wires also from below
/// within a small factor (Korn's inequality), so that a few conjugate gradients suffice. For the
/// same reason its step alone is enough where the gradient has become small in its norm.
class RigidEmbedding
{
public:
  enum class State
  {
    Running,
    Converged,
    Failed, ///< no step lowers the energy, though its gradient is not zero
  };

  /// Only refers to the system, whose cotangent factor must be there for iterate(). \param
  /// positions of the patch's vertices; the interior ones are the start.
  RigidEmbedding(InteriorSystem& system, const LinearSolver* preconditioner,
    const Eigen::MatrixXd& positions, const Execution& execution);

  /// One Newton step. Converged where the energy falls by less than this fraction of itself.
  State iterate(double energyTolerance);

  const Eigen::MatrixXd& positions() const { return this->Positions; }

private:
  struct Linearized;

  LargeArray<Linearized> linearize() const;
  /// Half of the sum of A_t |J_t - R_t|^2.
  double energy(const Eigen::MatrixXd& positions) const;
  /// Its gradient by the interior positions, and its second derivative along a direction of them.
  Eigen::MatrixXd gradient(const LargeArray<Linearized>& state) const;
  Eigen::MatrixXd curvature(
    const LargeArray<Linearized>& state, const Eigen::MatrixXd& direction) const;
  struct Direction
  {
    Eigen::MatrixXd step;
    bool last = false; ///< the energy cannot fall by more than what was enough
  };
  Direction newtonDirection(
    const LargeArray<Linearized>& state, const Eigen::MatrixXd& descent, double enough) const;

  const InteriorPatch* Patch;
  const TriangleFrames* Frames;
  const LinearSolver* Preconditioner;
  Execution Run;
  double Area = 0.0;
  Eigen::MatrixXd Positions;
};
}
