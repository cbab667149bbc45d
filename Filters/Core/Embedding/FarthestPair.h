// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace flattening
{
/// The two of some vertices that are farthest apart, of several pairs the one with the smallest
/// ids: by boxes of vertices, of which few pairs can hold a distance as large as one that is known.
class FarthestPair
{
public:
  FarthestPair(const TriangleMesh& mesh, Indices vertices)
    : Mesh(mesh)
    , Vertices(std::move(vertices))
  {
    if (this->Vertices.size() > 1)
    {
      this->build(0, this->Vertices.size());
      this->visit(0, 0);
    }
  }

  const std::array<Index, 2>& pair() const { return this->Best; }

private:
  static constexpr double tie = 1e-12;
  static constexpr std::size_t leafSize = 8;

  struct Box
  {
    std::size_t begin = 0;
    std::size_t end = 0;
    Point3 low = Point3::Zero();
    Point3 high = Point3::Zero();
    std::size_t left = 0; ///< 0: a leaf
    std::size_t right = 0;
  };

  std::size_t build(std::size_t begin, std::size_t end)
  {
    Box box;
    box.begin = begin;
    box.end = end;
    box.low = box.high = this->Mesh.point(this->Vertices[begin]);
    for (std::size_t k = begin; k < end; ++k)
    {
      box.low = box.low.cwiseMin(this->Mesh.point(this->Vertices[k]));
      box.high = box.high.cwiseMax(this->Mesh.point(this->Vertices[k]));
    }
    const std::size_t number = this->Boxes.size();
    this->Boxes.push_back(box);
    if (end - begin > leafSize)
    {
      int axis = 0;
      (box.high - box.low).maxCoeff(&axis);
      const std::size_t middle = (begin + end) / 2;
      const auto first = this->Vertices.begin();
      std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
        first + static_cast<std::ptrdiff_t>(middle), first + static_cast<std::ptrdiff_t>(end),
        [&](Index a, Index b) {
          const double x = this->Mesh.point(a)[axis];
          const double y = this->Mesh.point(b)[axis];
          return x < y || (x == y && a < b);
        });
      const std::size_t left = this->build(begin, middle);
      const std::size_t right = this->build(middle, end);
      this->Boxes[number].left = left;
      this->Boxes[number].right = right;
    }
    return number;
  }

  double mostBetween(std::size_t a, std::size_t b) const
  {
    const Box& one = this->Boxes[a];
    const Box& other = this->Boxes[b];
    return (one.high - other.low).cwiseAbs().cwiseMax((other.high - one.low).cwiseAbs()).norm();
  }

  void visit(std::size_t a, std::size_t b)
  {
    if (this->mostBetween(a, b) < this->Most * (1.0 - tie))
    {
      return;
    }
    const Box one = this->Boxes[a];
    const Box other = this->Boxes[b];
    if (one.left == 0 && other.left == 0)
    {
      this->compare(one, other);
      return;
    }
    const bool divideOne =
      other.left == 0 || (one.left != 0 && one.end - one.begin >= other.end - other.begin);
    std::vector<std::array<std::size_t, 2>> pairs;
    if (a == b)
    {
      pairs = { { one.left, one.right }, { one.left, one.left }, { one.right, one.right } };
    }
    else if (divideOne)
    {
      pairs = { { one.left, b }, { one.right, b } };
    }
    else
    {
      pairs = { { a, other.left }, { a, other.right } };
    }
    // The farther first, which leaves less to look at.
    std::stable_sort(pairs.begin(), pairs.end(), [this](const auto& p, const auto& q) {
      return this->mostBetween(p[0], p[1]) > this->mostBetween(q[0], q[1]);
    });
    for (const auto& pair : pairs)
    {
      this->visit(pair[0], pair[1]);
    }
  }

  void compare(const Box& one, const Box& other)
  {
    for (std::size_t i = one.begin; i < one.end; ++i)
    {
      for (std::size_t j = other.begin; j < other.end; ++j)
      {
        const auto [low, high] = std::minmax(this->Vertices[i], this->Vertices[j]);
        const std::array<Index, 2> pair{ low, high };
        const double distance = (this->Mesh.point(low) - this->Mesh.point(high)).norm();
        if (low != high &&
          (distance > this->Most * (1.0 + tie) ||
            (distance >= this->Most * (1.0 - tie) && pair < this->Best)))
        {
          this->Most = std::max(this->Most, distance);
          this->Best = pair;
        }
      }
    }
  }

  const TriangleMesh& Mesh;
  Indices Vertices;
  std::vector<Box> Boxes;
  double Most = 0.0;
  std::array<Index, 2> Best{ none, none };
};
}
