// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorPatch.h"

#include "Base/CompressedRows.h"

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

PatchMatrix::PatchMatrix(const InteriorPatch& patch)
  : Matrix(patch.freeCount, patch.freeCount)
  , EdgePlace(patch.triangles.size(), Triangle{ none, none, none })
{
  // An inner edge comes from two triangles, so each vertex has at most this many neighbours.
  const auto eachEdge = [&patch](const auto& visit) {
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index a = patch.triangles[t][(k + 1) % 3];
        const Index b = patch.triangles[t][(k + 2) % 3];
        if (std::max(a, b) < patch.freeCount)
        {
          visit(t, k, std::min(a, b), std::max(a, b));
        }
      }
    }
  };
  CompressedRows higher = groupMembers(patch.freeCount, [&eachEdge](const auto& visit) {
    eachEdge([&visit](std::size_t, int, Index low, Index high) { visit(low, high); });
  });
  const Indices& begin = higher.begin;
  Indices& rows = higher.members;

  // Column v: the diagonal first, then each higher neighbour once, in ascending order.
  Indices inner;
  inner.reserve(rows.size() / 2 + 2 * static_cast<std::size_t>(patch.freeCount));
  Indices outer(patch.freeCount + 1, 0);
  for (Index v = 0; v < patch.freeCount; ++v)
  {
    std::sort(rows.begin() + begin[v], rows.begin() + begin[v + 1]);
    const auto last = std::unique(rows.begin() + begin[v], rows.begin() + begin[v + 1]);
    inner.push_back(v);
    inner.insert(inner.end(), rows.begin() + begin[v], last);
    outer[v + 1] = static_cast<Index>(inner.size());
  }
  eachEdge([&](std::size_t t, int k, Index low, Index high) {
    const auto found =
      std::lower_bound(inner.begin() + outer[low], inner.begin() + outer[low + 1], high);
    this->EdgePlace[t][k] = static_cast<Index>(found - inner.begin());
  });
  this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(outer.begin(), outer.end(), this->Matrix.outerIndexPtr());
  std::copy(inner.begin(), inner.end(), this->Matrix.innerIndexPtr());
}

const SparseMatrix& PatchMatrix::assemble(
  const InteriorPatch& patch, const std::vector<EdgeWeights>& weights)
{
  double* values = this->Matrix.valuePtr();
  std::fill(values, values + this->Matrix.nonZeros(), 0.0);
  const auto* outer = this->Matrix.outerIndexPtr();
  for (std::size_t t = 0; t < weights.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double weight = weights[t][k];
      for (int end = 1; end <= 2; ++end)
      {
        const Index v = patch.triangles[t][(k + end) % 3];
        if (v < patch.freeCount)
        {
          values[outer[v]] += weight;
        }
      }
      if (this->EdgePlace[t][k] != none)
      {
        values[this->EdgePlace[t][k]] -= weight;
      }
    }
  }
  return this->Matrix;
}
}
