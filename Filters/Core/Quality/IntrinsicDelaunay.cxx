// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/IntrinsicDelaunay.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Corners slimmer than this count as that slim: a cotangent beyond would cost the others their
/// digits.
constexpr double largestCotangent = 1e6;
/// Cotangents of an edge may add up to this much less than zero, by rounding.
constexpr double roundingCotangent = 1e-9;
/// Flips per half-edge until slivers that rounding keeps from ending are left as they are.
constexpr std::size_t maxFlips = 50;

class Flipping
{
public:
  explicit Flipping(const TriangleMesh& mesh)
    : Triangulation{ mesh.triangles(), {} }
    , Twin(mesh.twins())
  {
    this->Length.reserve(mesh.halfedgeCount());
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      this->Length.push_back(mesh.length(h));
    }
  }

  IntrinsicTriangulation run()
  {
    Indices waiting;
    std::vector<char> waits(this->Twin.size(), 1);
    for (Index h = static_cast<Index>(this->Twin.size()) - 1; h >= 0; --h)
    {
      waiting.push_back(h);
    }
    std::size_t left = maxFlips * this->Twin.size();
    while (!waiting.empty() && left > 0)
    {
      const Index h = waiting.back();
      waiting.pop_back();
      waits[h] = 0;
      if (this->Twin[h] == none || this->isDelaunay(h) || !this->flip(h))
      {
        continue;
      }
      --left;
      for (Index side : { h, this->Twin[h] })
      {
        for (Index edge : { TriangleMesh::next(side), TriangleMesh::previous(side) })
        {
          if (!waits[edge])
          {
            waits[edge] = 1;
            waiting.push_back(edge);
          }
        }
      }
    }
    for (Index h = 0; h < static_cast<Index>(this->Twin.size()); h += 3)
    {
      // The corner of half-edge h + k is opposite to the next one.
      this->Triangulation.cotangents.push_back(
        { this->cotangent(h + 1), this->cotangent(h + 2), this->cotangent(h) });
    }
    return std::move(this->Triangulation);
  }

private:
  /// Of the angle opposite to a half-edge.
  double cotangent(Index h) const
  {
    const double a = this->Length[h];
    const double b = this->Length[TriangleMesh::next(h)];
    const double c = this->Length[TriangleMesh::previous(h)];
    const double square = (a + b + c) * (b + c - a) * (a + c - b) * (a + b - c);
    const double area4 = std::sqrt(std::max(square, 0.0));
    const double dot = b * b + c * c - a * a;
    return area4 * largestCotangent > std::abs(dot) ? dot / area4
                                                    : std::copysign(largestCotangent, dot);
  }

  bool isDelaunay(Index h) const
  {
    return this->cotangent(h) + this->cotangent(this->Twin[h]) >= -roundingCotangent;
  }

  /// The third corner of a half-edge's triangle, where the half-edge runs along x from 0.
  Point2 apex(Index h) const
  {
    const double base = this->Length[h];
    const double left = this->Length[TriangleMesh::previous(h)];
    const double right = this->Length[TriangleMesh::next(h)];
    const double x = 0.5 * (base + (left - right) * (left + right) / base);
    return { x, std::sqrt(std::max((left - x) * (left + x), 0.0)) };
  }

  /// Turns the edge of a half-edge to the other diagonal of its two triangles.
  bool flip(Index h)
  {
    const Index g = this->Twin[h];
    if (g / 3 == h / 3)
    {
      return false;
    }
    const Index hNext = TriangleMesh::next(h);
    const Index hPrevious = TriangleMesh::previous(h);
    const Index gNext = TriangleMesh::next(g);
    const Index gPrevious = TriangleMesh::previous(g);
    const Point2 above = this->apex(h);
    const Point2 turned = this->apex(g);
    const Point2 below(this->Length[h] - turned.x(), -turned.y());
    const double diagonal = (above - below).norm();
    if (!(diagonal > 0.0) || !std::isfinite(diagonal))
    {
      return false;
    }
    // h: a -> b with apex c and g: b -> a with apex d become h: d -> c and g: c -> d; the sides
    // around them, b c, c a, a d and d b, move on to the next place.
    const std::array<Index, 4> before{ hNext, hPrevious, gNext, gPrevious };
    const std::array<Index, 4> after{ gPrevious, hNext, hPrevious, gNext };
    const Index c = this->from(hPrevious);
    const Index d = this->from(gPrevious);
    this->moveSides(before, after);
    this->from(h) = d;
    this->from(g) = c;
    this->Length[h] = diagonal;
    this->Length[g] = diagonal;
    return true;
  }

  void moveSides(const std::array<Index, 4>& before, const std::array<Index, 4>& after)
  {
    struct Moved
    {
      Index from;
      Index twin;
      double length;
    };
    std::array<Moved, 4> sides{};
    for (int k = 0; k < 4; ++k)
    {
      sides[k] = { this->from(before[k]), this->Twin[before[k]], this->Length[before[k]] };
      for (int j = 0; j < 4; ++j)
      {
        sides[k].twin = this->Twin[before[k]] == before[j] ? after[j] : sides[k].twin;
      }
    }
    for (int k = 0; k < 4; ++k)
    {
      this->from(after[k]) = sides[k].from;
      this->Length[after[k]] = sides[k].length;
      this->Twin[after[k]] = sides[k].twin;
      if (sides[k].twin != none)
      {
        this->Twin[sides[k].twin] = after[k];
      }
    }
  }

  Index& from(Index h) { return this->Triangulation.triangles[h / 3][h % 3]; }

  IntrinsicTriangulation Triangulation;
  Indices Twin;
  std::vector<double> Length;
};
}

IntrinsicTriangulation intrinsicDelaunay(const TriangleMesh& mesh)
{
  return Flipping(mesh).run();
}
}
