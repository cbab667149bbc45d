// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorSystem.h"

#include "Base/CompressedRows.h"
#include "Base/Types.h"

#include <algorithm>

namespace flattening
{
std::vector<InteriorPatch> collectInteriorPatches(const Piece& piece, const WireNetwork& network)
{
  const TriangleMesh& mesh = piece.mesh;
  const CompressedRows byPatch = groupBy(network.patchCount, network.patchOfTriangle);
  std::vector<InteriorPatch> patches;
  Indices local(mesh.vertexCount(), none);
  Indices pinned;
  for (Index k = 0; k < network.patchCount; ++k)
  {
    InteriorPatch patch;
    patch.patch = k;
    pinned.clear();
    for (Index t : byPatch[k])
    {
      for (Index v : mesh.triangle(t))
      {
        if (local[v] == none)
        {
          local[v] = 0;
          (network.hostOfVertex[v] == none ? patch.vertices : pinned).push_back(v);
        }
      }
    }
    patch.freeCount = static_cast<Index>(patch.vertices.size());
    if (patch.freeCount > 0)
    {
      std::sort(patch.vertices.begin(), patch.vertices.end());
      std::sort(pinned.begin(), pinned.end());
      patch.vertices.insert(patch.vertices.end(), pinned.begin(), pinned.end());
      for (std::size_t i = 0; i < patch.vertices.size(); ++i)
      {
        local[patch.vertices[i]] = static_cast<Index>(i);
      }
      for (Index t : byPatch[k])
      {
        const Triangle& c = mesh.triangle(t);
        const Triangle corners{ local[c[0]], local[c[1]], local[c[2]] };
        if (*std::min_element(corners.begin(), corners.end()) < patch.freeCount)
        {
          patch.triangles.push_back(corners);
        }
      }
    }
    // Wire vertices belong to several patches.
    for (Index v : pinned)
    {
      local[v] = none;
    }
    if (patch.freeCount > 0)
    {
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

InteriorPatch restrictedTo(const InteriorPatch& patch, const std::vector<char>& marked)
{
  const auto free = [&](Index v) { return v < patch.freeCount && marked[v]; };
  InteriorPatch part;
  part.patch = patch.patch;
  Indices local(patch.vertices.size(), none);
  const auto take = [&](Index v) {
    local[v] = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(patch.vertices[v]);
  };
  for (Index v = 0; v < patch.freeCount; ++v)
  {
    if (free(v))
    {
      take(v);
    }
  }
  part.freeCount = static_cast<Index>(part.vertices.size());
  for (const Triangle& c : patch.triangles)
  {
    if (std::any_of(c.begin(), c.end(), free))
    {
      for (Index v : c)
      {
        if (local[v] == none)
        {
          take(v);
        }
      }
      part.triangles.push_back({ local[c[0]], local[c[1]], local[c[2]] });
    }
  }
  return part;
}

namespace
{
/// Triangles slimmer than this (height to longest edge) count as that high: beyond, their stiffness
/// would cost the others their digits.
constexpr double slimmest = 1e-6;
/// In larger patches planes make much less fill-in than the pattern's levels, which is worth more
/// than an order that stays when vertices move.
constexpr Index largePatch = 20000;

/// Calls visit(t, k, a, b) for the edge opposite to each corner k of a triangle, from a to b.
template <class Visit>
void forEdges(const InteriorPatch& patch, const Visit& visit)
{
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      visit(t, k, patch.triangles[t][(k + 1) % 3], patch.triangles[t][(k + 2) % 3]);
    }
  }
}

/// Interior vertices of the patch that are coupled.
Triangles couplings(const InteriorPatch& patch)
{
  Triangles cliques;
  cliques.reserve(patch.triangles.size());
  for (const Triangle& t : patch.triangles)
  {
    Triangle clique{ none, none, none };
    int count = 0;
    for (Index v : t)
    {
      if (v < patch.freeCount)
      {
        clique[count++] = v;
      }
    }
    if (count > 1)
    {
      clique[2] = count == 3 ? clique[2] : clique[0];
      cliques.push_back(clique);
    }
  }
  return cliques;
}
}

void InteriorSystem::update(InteriorPatch patch, const TriangleMesh& mesh)
{
  const bool samePattern =
    patch.freeCount == this->Patch.freeCount && patch.triangles == this->Patch.triangles;
  Points3 points;
  points.reserve(patch.vertices.size());
  for (Index v : patch.vertices)
  {
    points.push_back(mesh.point(v));
  }
  const bool samePoints = samePattern && sameBits(points, this->Points);
  this->Patch = std::move(patch);
  if (samePoints)
  {
    return;
  }
  this->Points = std::move(points);
  this->Frames.clear();
  for (Factor& factor : this->Factors)
  {
    factor.current = false;
  }
  if (!samePattern || this->Patch.freeCount > largePatch)
  {
    this->forgetFactors();
  }
}

const TriangleFrames& InteriorSystem::frames()
{
  if (this->Frames.empty())
  {
    this->Frames.reserve(this->Patch.triangles.size());
    for (const Triangle& t : this->Patch.triangles)
    {
      this->Frames.emplace_back(this->Points, t, slimmest);
    }
  }
  return this->Frames;
}

void InteriorSystem::forgetFactors()
{
  this->Factors = {};
  this->Assembler.reset();
}

std::vector<EdgeWeights> InteriorSystem::edgeWeights(InteriorWeights weights)
{
  std::vector<EdgeWeights> result(this->Patch.triangles.size());
  const TriangleFrame* const frame =
    weights == InteriorWeights::Cotangent ? this->frames().data() : nullptr;
  forEdges(this->Patch, [&](std::size_t t, int k, Index a, Index b) {
    if (frame)
    {
      const Complex& from = frame[t].gradient[(k + 1) % 3];
      const Complex& to = frame[t].gradient[(k + 2) % 3];
      result[t][k] = -4.0 * frame[t].area * (from.real() * to.real() + from.imag() * to.imag());
    }
    else
    {
      // Half of 1 / |v_i v_j| from each triangle at the edge.
      result[t][k] = 0.5 / (this->Points[a] - this->Points[b]).norm();
    }
  });
  return result;
}

/// Sum over the edges of w (e_i - e_j)(e_i - e_j)^T, the weight of an edge being the sum of those
/// that its triangles give it.
const SparseMatrix& InteriorSystem::assemble(const std::vector<EdgeWeights>& weights)
{
  const Index free = this->Patch.freeCount;
  if (!this->Assembler)
  {
    this->Assembler = std::make_unique<SymmetricAssembler>(free);
    this->Assembler->reserve(free + 3 * this->Patch.triangles.size());
    for (Index v = 0; v < free; ++v)
    {
      this->Assembler->declare(v, v);
    }
    forEdges(this->Patch, [&](std::size_t, int, Index a, Index b) {
      if (std::max(a, b) < free)
      {
        this->Assembler->declare(a, b);
      }
    });
    this->Assembler->finish();
  }
  this->Assembler->clear();
  Index entry = free; // those before it are on the diagonal
  forEdges(this->Patch, [&](std::size_t t, int k, Index a, Index b) {
    for (Index v : { a, b })
    {
      if (v < free)
      {
        this->Assembler->add(v, weights[t][k]);
      }
    }
    if (std::max(a, b) < free)
    {
      this->Assembler->add(entry++, -weights[t][k]);
    }
  });
  return this->Assembler->matrix();
}

const LinearSolver* InteriorSystem::factor(InteriorWeights weights, const Execution& execution)
{
  Factor& factor = this->factorOf(weights);
  if (!factor.current)
  {
    factor.edges = this->edgeWeights(weights);
    const SparseMatrix& matrix = this->assemble(factor.edges);
    if (!factor.solver)
    {
      const Triangles cliques = couplings(this->Patch);
      factor.solver = std::make_unique<LinearSolver>(this->Patch.freeCount > largePatch
          ? dissect(cliques, { this->Points.begin(), this->Points.begin() + this->Patch.freeCount })
          : dissect(cliques, this->Patch.freeCount));
    }
    factor.current = factor.solver->factorize(matrix, execution) &&
      factor.solver->positive() == this->Patch.freeCount;
  }
  return factor.current ? factor.solver.get() : nullptr;
}

bool InteriorSystem::solve(
  InteriorWeights weights, const Execution& execution, Eigen::MatrixXd& positions)
{
  const LinearSolver* const solver = this->factor(weights, execution);
  if (!solver)
  {
    return false;
  }
  const Index free = this->Patch.freeCount;
  const std::vector<EdgeWeights>& edges = this->factorOf(weights).edges;
  Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(free, 2);
  forEdges(this->Patch, [&](std::size_t t, int k, Index a, Index b) {
    if (a < free && b >= free)
    {
      pull.row(a) += edges[t][k] * positions.row(b);
    }
    if (b < free && a >= free)
    {
      pull.row(b) += edges[t][k] * positions.row(a);
    }
  });
  const Eigen::MatrixXd solution = solver->solve(pull, execution);
  if (solution.rows() != free)
  {
    return false;
  }
  positions.topRows(free) = solution;
  return true;
}
}
