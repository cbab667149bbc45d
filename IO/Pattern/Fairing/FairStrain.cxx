// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairStrain.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace flattening
{
namespace pattern
{
double strainQuantile(const DrawingSource& all, std::size_t piece, const Points2& positions)
{
  const PatternSource& source = all.source;
  std::vector<std::array<double, 2>> strains; // with the areas
  double total = 0.0;
  for (std::size_t t = 0; t < source.triangles.size() && !source.inSpace.empty(); ++t)
  {
    if (source.pieceOfTriangle[t] != static_cast<Index>(piece))
    {
      continue;
    }
    const Triangle& corners = source.triangles[t];
    const auto side = [&](std::size_t k) {
      return Point3(all.scale() * (source.inSpace[corners[k]] - source.inSpace[corners[0]]));
    };
    const auto flatSide = [&](std::size_t k) {
      return Point2(positions[static_cast<std::size_t>(corners[k])] -
        positions[static_cast<std::size_t>(corners[0])]);
    };
    const double length = side(1).norm();
    const double area = side(1).cross(side(2)).norm() / 2.0;
    if (!(area > 0.0))
    {
      continue;
    }
    Eigen::Matrix2d onSurface;
    onSurface << length, side(1).dot(side(2)) / length, 0.0, 2.0 * area / length;
    Eigen::Matrix2d inPlane;
    inPlane << flatSide(1), flatSide(2);
    const Eigen::Vector2d stretches =
      Eigen::JacobiSVD<Eigen::Matrix2d>(inPlane * onSurface.inverse()).singularValues();
    const double least = std::max(stretches[1], 1e-300);
    strains.push_back(
      { std::max(std::abs(std::log(stretches[0])), std::abs(std::log(least))), area });
    total += area;
  }
  std::sort(strains.begin(), strains.end());
  double below = 0.0;
  for (const auto& [strain, area] : strains)
  {
    below += area;
    if (below >= 0.95 * total)
    {
      return strain;
    }
  }
  return 0.0;
}

Points2 followBorders(const DrawingSource& all, std::size_t piece, const Points2& moved)
{
  const PatternSource& source = all.source;
  std::unordered_set<Index> held;
  for (const Indices& loop : all.loops[piece])
  {
    held.insert(loop.begin(), loop.end());
  }
  for (const SourceWire& wire : source.wires)
  {
    held.insert(wire.points.begin(), wire.points.end());
  }
  std::unordered_map<Index, Eigen::Index> unknown;
  Indices free;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    for (const Index v : source.triangles[t])
    {
      if (source.pieceOfTriangle[t] == static_cast<Index>(piece) && held.count(v) == 0 &&
        unknown.emplace(v, static_cast<Eigen::Index>(free.size())).second)
      {
        free.push_back(v);
      }
    }
  }
  Points2 result = moved;
  if (free.empty())
  {
    return result;
  }
  const auto count = static_cast<Eigen::Index>(free.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    for (std::size_t k = 0; source.pieceOfTriangle[t] == static_cast<Index>(piece) && k < 6; ++k)
    {
      const Index v = source.triangles[t][k % 3];
      const Index neighbour = source.triangles[t][(k + (k < 3 ? 1 : 2)) % 3];
      const auto own = unknown.find(v);
      if (own == unknown.end())
      {
        continue;
      }
      entries.emplace_back(own->second, own->second, 1.0);
      const auto other = unknown.find(neighbour);
      if (other != unknown.end())
      {
        entries.emplace_back(own->second, other->second, -1.0);
        continue;
      }
      const Point2 way = moved[static_cast<std::size_t>(neighbour)] -
        all.scale() * source.positions[static_cast<std::size_t>(neighbour)];
      right.row(own->second) += way.transpose();
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  const Eigen::MatrixX2d ways = factor.solve(right);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const auto v = static_cast<std::size_t>(free[static_cast<std::size_t>(k)]);
    result[v] = all.scale() * source.positions[v] + Point2(ways.row(k).transpose());
  }
  return result;
}
}
}
