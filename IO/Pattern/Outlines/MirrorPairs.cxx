// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/MirrorPairs.h"

#include "Outlines/Outline.h"
#include "Outlines/PlaneGeometry.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
namespace
{
Segments linesOf(const PieceShape& shape)
{
  Segments lines;
  addSegments(shape.outline, true, lines);
  for (const Points2& line : shape.lines)
  {
    addSegments(line, false, lines);
  }
  return lines;
}

/// A shape about the centroid of its area, with the moments that say how it is turned.
class LaidShape
{
  struct Side
  {
    const Point2& a;
    const Point2& b;
    double cross;
  };

public:
  explicit LaidShape(PieceShape shape)
    : Shape(std::move(shape))
  {
    Point2 moment = Point2::Zero();
    for (std::size_t k = 0; k < this->Shape.outline.size(); ++k)
    {
      const Side side = this->side(k);
      this->Area += side.cross / 2.0;
      moment += side.cross / 6.0 * (side.a + side.b);
    }
    this->Center = this->Area != 0.0 ? Point2(moment / this->Area) : Point2::Zero();
    const auto center = [this](Points2& points) {
      std::for_each(points.begin(), points.end(), [this](Point2& p) { p -= this->Center; });
    };
    center(this->Shape.outline);
    std::for_each(this->Shape.lines.begin(), this->Shape.lines.end(), center);
    for (std::size_t k = 0; k < this->Shape.outline.size(); ++k)
    {
      const Side side = this->side(k);
      const auto mixed = [&side](int i, int j) {
        const Point2& a = side.a;
        const Point2& b = side.b;
        return side.cross / 24.0 * (2.0 * (a[i] * a[j] + b[i] * b[j]) + a[i] * b[j] + a[j] * b[i]);
      };
      this->Round += mixed(0, 0) + mixed(1, 1);
      this->Long += Point2(mixed(0, 0) - mixed(1, 1), 2.0 * mixed(0, 1));
    }
    this->Lines = linesOf(this->Shape);
  }

  double area() const { return this->Area; }
  const Point2& center() const { return this->Center; }
  const Points2& outline() const { return this->Shape.outline; }

  /// Turns by which the mirror image of another shape might come to lie on this one.
  std::vector<double> turns(const LaidShape& other, double tolerance) const
  {
    // Where the area is longer one way than the other its axes say it, but for half a turn.
    if (this->Long.norm() > 1e-3 * this->Round)
    {
      const double turn =
        (std::atan2(this->Long.y(), this->Long.x()) + std::atan2(other.Long.y(), other.Long.x())) /
        2.0;
      return { turn, turn + pi };
    }
    const auto farthest = std::max_element(other.outline().begin(), other.outline().end(),
      [](const Point2& a, const Point2& b) { return a.squaredNorm() < b.squaredNorm(); });
    std::vector<double> turns;
    for (const Point2& p : this->outline())
    {
      if (std::abs(p.norm() - farthest->norm()) <= 2.0 * tolerance)
      {
        turns.push_back(std::atan2(p.y(), p.x()) + std::atan2(farthest->y(), farthest->x()));
      }
    }
    return turns;
  }

  /// Whether all vertices of the other, turned over and by an angle, lie on this one's lines.
  bool covers(const LaidShape& other, double turn, double tolerance) const
  {
    const auto lies = [&](const Point2& p) {
      return distance(turnedOver(p, turn), this->Lines) <= tolerance;
    };
    const auto all = [&](const Points2& points) {
      return std::all_of(points.begin(), points.end(), lies);
    };
    return all(other.outline()) &&
      std::all_of(other.Shape.lines.begin(), other.Shape.lines.end(), all);
  }

private:
  static Point2 turnedOver(const Point2& p, double turn)
  {
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    return { c * p.x() + s * p.y(), s * p.x() - c * p.y() };
  }

  Side side(std::size_t k) const
  {
    const Points2& outline = this->Shape.outline;
    const Point2& a = outline[k];
    const Point2& b = outline[(k + 1) % outline.size()];
    return { a, b, flattening::cross(a, b) };
  }

  PieceShape Shape;
  Segments Lines;
  double Area = 0.0;
  Point2 Center = Point2::Zero(); ///< where it was
  double Round = 0.0;             ///< sum of the second moments
  Point2 Long = Point2::Zero();   ///< their difference, at twice the angle of the long axis
};

bool areMirrored(const LaidShape& one, const LaidShape& other, double tolerance)
{
  const double perimeter =
    polylineLength(one.outline()) + (one.outline().front() - one.outline().back()).norm();
  if (std::abs(one.area() - other.area()) > tolerance * perimeter)
  {
    return false;
  }
  // The same reflection lays the other on the one and the one on the other.
  const std::vector<double> turns = one.turns(other, tolerance);
  return std::any_of(turns.begin(), turns.end(), [&](double turn) {
    return one.covers(other, turn, tolerance) && other.covers(one, turn, tolerance);
  });
}

constexpr int improvements = 30;
constexpr double settled = 1e-9; ///< radians, millimetres

/// An axis that was turned and moved so that the image of the outline lies on the outline with
/// least squares: by its moments alone it is vague where the shape is about as wide as it is long.
/// P. J. Besl, N. D. McKay, A method for registration of 3-D shapes, IEEE Transactions on Pattern
/// Analysis and Machine Intelligence 14(2), 1992.
MirrorAxis improved(const PieceShape& shape, MirrorAxis axis)
{
  Segments outline;
  addSegments(shape.outline, true, outline);
  axis.miss = mirrorMiss(shape, axis);
  MirrorAxis best = axis;
  for (int k = 0; k < improvements; ++k)
  {
    const Point2 across(axis.along.y(), -axis.along.x());
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    Point2 right = Point2::Zero();
    for (const Segment& segment : outline)
    {
      const Point2 image = imageOf((segment.from + segment.to) / 2.0, axis);
      const Point2 off = nearestPoint(image, outline) - image;
      // Turned by an angle the axis turns images by twice as much, and moved it moves them so.
      const Point2 arm = image - axis.at;
      const Point2 byTurn(-2.0 * arm.y(), 2.0 * arm.x());
      const Point2 byShift = 2.0 * across;
      const double weight = (segment.to - segment.from).norm();
      squares(0, 0) += weight * byTurn.squaredNorm();
      squares(1, 1) += weight * byShift.squaredNorm();
      squares(0, 1) += weight * byTurn.dot(byShift);
      right += weight * Point2(byTurn.dot(off), byShift.dot(off));
    }
    squares(1, 0) = squares(0, 1);
    const Point2 change = squares.ldlt().solve(right);
    if (!change.allFinite() || change.norm() < settled)
    {
      break;
    }
    axis.at += change.y() * across;
    axis.along = (axis.along - change.x() * across).normalized();
    axis.miss = mirrorMiss(shape, axis);
    best = axis.miss < best.miss ? axis : best;
  }
  return best;
}
}

Point2 imageOf(const Point2& p, const MirrorAxis& axis)
{
  return 2.0 * (axis.at + axis.along.dot(p - axis.at) * axis.along) - p;
}

double mirrorMiss(const PieceShape& shape, const MirrorAxis& axis)
{
  const Segments lines = linesOf(shape);
  double most = 0.0;
  const auto add = [&](const Points2& points) {
    for (const Point2& p : points)
    {
      most = std::max(most, distance(imageOf(p, axis), lines));
    }
  };
  add(shape.outline);
  std::for_each(shape.lines.begin(), shape.lines.end(), add);
  return most;
}

MirrorAxis nearestMirrorAxis(const PieceShape& shape, double tolerance)
{
  const LaidShape laid(shape);
  std::optional<MirrorAxis> best;
  for (const double turn : laid.turns(laid, tolerance))
  {
    MirrorAxis axis{ laid.center(), { std::cos(turn / 2.0), std::sin(turn / 2.0) }, 0.0 };
    axis = improved(shape, axis);
    axis.along *= axis.along.y() < 0.0 ? -1.0 : 1.0;
    const bool both = best && std::max(axis.miss, best->miss) <= tolerance;
    if (!best || (both ? axis.along.y() > best->along.y() : axis.miss < best->miss))
    {
      best = axis;
    }
  }
  return best.value_or(MirrorAxis());
}

std::optional<MirrorAxis> findMirrorAxis(const PieceShape& shape, double tolerance)
{
  const MirrorAxis axis = nearestMirrorAxis(shape, tolerance);
  return axis.miss <= tolerance ? std::make_optional(axis) : std::nullopt;
}

std::vector<std::size_t> findMirrorPairs(const std::vector<PieceShape>& shapes, double tolerance)
{
  std::vector<LaidShape> laid;
  laid.reserve(shapes.size());
  for (const PieceShape& shape : shapes)
  {
    laid.emplace_back(shape);
  }
  std::vector<std::size_t> first(shapes.size(), noPair);
  std::vector<bool> taken(shapes.size(), false);
  for (std::size_t p = 0; p < shapes.size(); ++p)
  {
    for (std::size_t q = p + 1; q < shapes.size() && !taken[p]; ++q)
    {
      if (!taken[q] && areMirrored(laid[p], laid[q], tolerance))
      {
        first[q] = p;
        taken[p] = taken[q] = true;
      }
    }
  }
  return first;
}
}
