// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshTriangles.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

/// Small graphs of every shape, for the tests of sparse systems.
namespace testgraphs
{
using namespace flattening;

struct Graph
{
  std::string name;
  Index count = 0;   ///< of its vertices
  Triangles cliques; ///< an edge a - b as a, b, a

  void join(Index a, Index b) { this->cliques.push_back({ a, b, a }); }
};

inline Graph path(Index count)
{
  Graph graph{ "path of " + std::to_string(count), count, {} };
  for (Index v = 1; v < count; ++v)
  {
    graph.join(v - 1, v);
  }
  return graph;
}

inline Graph star(Index leaves)
{
  Graph graph{ "star of " + std::to_string(leaves), leaves + 1, {} };
  for (Index v = 1; v <= leaves; ++v)
  {
    graph.join(0, v);
  }
  return graph;
}

/// Rings around a hub, as triangles: a wheel, a dome.
inline Graph dome(Index meridians, Index parallels)
{
  return { "dome of " + std::to_string(meridians) + " by " + std::to_string(parallels),
    1 + meridians * parallels, testmeshes::ringTriangles(meridians, parallels, meridians) };
}

inline Graph complete(Index count)
{
  Graph graph{ "complete graph of " + std::to_string(count), count, {} };
  for (Index a = 0; a < count; ++a)
  {
    for (Index b = 0; b < a; ++b)
    {
      graph.join(a, b);
    }
  }
  return graph;
}

/// A path with a path of so many at each of its vertices.
inline Graph comb(Index teeth, Index length)
{
  Graph graph{ "comb of " + std::to_string(teeth) + " by " + std::to_string(length), teeth * length,
    {} };
  for (Index tooth = 0; tooth < teeth; ++tooth)
  {
    if (tooth > 0)
    {
      graph.join((tooth - 1) * length, tooth * length);
    }
    for (Index k = 1; k < length; ++k)
    {
      graph.join(tooth * length + k - 1, tooth * length + k);
    }
  }
  return graph;
}

inline Graph grid(Index columns, Index rows)
{
  return { "grid of " + std::to_string(columns) + " by " + std::to_string(rows), columns * rows,
    testmeshes::gridTriangles(columns - 1, rows - 1) };
}

inline Graph together(const std::vector<Graph>& parts)
{
  Graph graph;
  for (const Graph& part : parts)
  {
    graph.name += (graph.name.empty() ? "" : " and ") + part.name;
    for (const Triangle& t : part.cliques)
    {
      graph.cliques.push_back({ graph.count + t[0], graph.count + t[1], graph.count + t[2] });
    }
    graph.count += part.count;
  }
  return graph;
}

inline Graph random(Index count, Index edges, std::mt19937& generator)
{
  Graph graph{ "random graph of " + std::to_string(count), count, {} };
  std::uniform_int_distribution<Index> any(0, count - 1);
  for (Index k = 0; k < edges; ++k)
  {
    graph.join(any(generator), any(generator));
  }
  return graph;
}

inline Graph renumbered(Graph graph, std::mt19937& generator)
{
  Indices number(graph.count);
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), generator);
  for (Triangle& t : graph.cliques)
  {
    for (Index& v : t)
    {
      v = number[v];
    }
  }
  graph.name += ", renumbered";
  return graph;
}

/// One of each kind, as it is made and renumbered.
inline std::vector<Graph> graphs()
{
  std::mt19937 generator(1);
  std::vector<Graph> result{ path(1), path(2), path(13), path(200), star(12), star(13), star(250),
    dome(3, 1), dome(12, 1), dome(13, 1), dome(13, 2), dome(32, 6), dome(200, 1), dome(100, 2),
    complete(2), complete(13), complete(60), comb(30, 6), comb(6, 30), grid(14, 14), grid(2, 90),
    grid(3, 60), random(100, 60, generator), random(100, 200, generator),
    random(60, 600, generator), Graph{ "vertices alone", 40, {} },
    together({ star(70), path(40), Graph{ "one vertex", 1, {} }, dome(30, 2) }),
    together({ star(60), star(60), complete(20) }) };
  const std::size_t kinds = result.size();
  for (std::size_t k = 0; k < kinds; ++k)
  {
    result.push_back(renumbered(result[k], generator));
  }
  return result;
}

/// Stiffness of a grid of springs, positive definite.
inline Eigen::SparseMatrix<double> gridLaplacian(int side)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto at = [side](int i, int j) { return i * side + j; };
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      entries.emplace_back(at(i, j), at(i, j), 4.1 + 0.3 * std::sin(i + 2.0 * j));
      if (i + 1 < side)
      {
        entries.emplace_back(at(i, j), at(i + 1, j), -1.0);
        entries.emplace_back(at(i + 1, j), at(i, j), -1.0);
      }
      if (j + 1 < side)
      {
        entries.emplace_back(at(i, j), at(i, j + 1), -1.0);
        entries.emplace_back(at(i, j + 1), at(i, j), -1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
}
