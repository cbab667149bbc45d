// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/GrainPlacement.h"

#include "Base/Types.h"
#include "Flattening/PieceArrangement.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// The vertices of a curve in the piece in the order of the curve, the first copy of each; none
/// where less than an edge of it lies there, or it ends where it starts.
Indices lineInPiece(const PieceContext& context, Index curve)
{
  const Piece& piece = context.piece;
  const FeatureCurve& feature = context.curves[curve];
  Indices placeOf(context.cut.originalVertexCount, none);
  for (std::size_t k = feature.vertices.size(); k > 0; --k)
  {
    placeOf[feature.vertices[k - 1]] = static_cast<Index>(k - 1);
  }
  Indices vertexAt(feature.vertices.size(), none);
  for (Index h = 0; h < piece.mesh.halfedgeCount(); ++h)
  {
    if (piece.curveOfHalfedge[h] != curve)
    {
      continue;
    }
    for (const Index v : { piece.mesh.from(h), piece.mesh.to(h) })
    {
      const Index place = placeOf[context.cut.originalVertex[piece.vertices[v]]];
      if (place != none && vertexAt[place] == none)
      {
        vertexAt[place] = v;
      }
    }
  }
  vertexAt.erase(std::remove(vertexAt.begin(), vertexAt.end(), none), vertexAt.end());
  return vertexAt.size() < 2 || feature.closed() ? Indices() : vertexAt;
}

double withinTurn(double angle)
{
  return angle - 2.0 * pi * std::ceil(angle / (2.0 * pi) - 0.5);
}

std::vector<double> sharesOfArea(const TriangleMesh& mesh)
{
  std::vector<double> share(mesh.vertexCount(), 0.0);
  double sum = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const double area = mesh.area(t);
    sum += area;
    for (const Index v : mesh.triangle(t))
    {
      share[v] += area / 3.0;
    }
  }
  for (double& s : share)
  {
    s /= sum;
  }
  return share;
}

Point2 middleOf(const Points2& positions, const std::vector<double>& share)
{
  // From the first point, which keeps the digits of pieces far from the origin.
  Point2 sum = Point2::Zero();
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    sum += share[v] * (positions[v] - positions.front());
  }
  return positions.front() + sum;
}

/// The rotation from one shape to another that fits it best.
double rotationBetween(const Points2& from, const Points2& to, const std::vector<double>& share)
{
  const Point2 middleFrom = middleOf(from, share);
  const Point2 middleTo = middleOf(to, share);
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t v = 0; v < from.size(); ++v)
  {
    const Point2 a = from[v] - middleFrom;
    const Point2 b = to[v] - middleTo;
    sine += share[v] * cross(a, b);
    cosine += share[v] * a.dot(b);
  }
  return std::atan2(sine, cosine);
}
}

void GrainReference::takeCurve(const PieceContext& context, Index curve)
{
  this->Line = lineInPiece(context, curve);
  this->Curve = this->Line.empty() ? none : curve;
}

GrainReference::GrainReference(const PieceContext& context, const Points2& positions)
{
  const ClothOptions& cloth = *context.options.cloth;
  const auto count = static_cast<Index>(context.curves.size());
  for (std::size_t k = 0; k < cloth.grainCurves.size() && this->Curve == none; ++k)
  {
    for (Index c = 0; c < count && this->Curve == none; ++c)
    {
      if (context.curves[c].name == cloth.grainCurves[k])
      {
        this->takeCurve(context, c);
        this->Asked = cloth.grainAngles[k];
      }
    }
  }
  this->Missing = this->Curve == none && cloth.grain == GrainKind::Curve;
  if (this->Curve == none)
  {
    this->Asked = cloth.grainAngle;
  }
  for (Index c = 0; c < count && this->Curve == none; ++c)
  {
    if (context.curves[c].type == CurveType::Key)
    {
      this->takeCurve(context, c);
    }
  }
  if (this->Curve == none)
  {
    this->Plain = positions;
    this->Share = sharesOfArea(context.piece.mesh);
    ArrangementPiece piece;
    piece.positions = positions;
    this->Upright =
      0.5 * pi - rotationBetween(positions, arrangePieces({ piece }, 0.0).front(), this->Share);
  }
}

double GrainReference::direction(const Points2& positions) const
{
  if (this->Curve == none)
  {
    return this->Upright + rotationBetween(this->Plain, positions, this->Share);
  }
  const Point2 line = positions[this->Line.back()] - positions[this->Line.front()];
  return std::atan2(line.y(), line.x());
}

double GrainReference::angle(const Points2& positions) const
{
  return withinTurn(0.5 * pi - this->direction(positions));
}

double GrainReference::bend(const Points2& positions) const
{
  if (this->Line.empty())
  {
    return 0.0;
  }
  Points2 line;
  double length = 0.0;
  for (const Index v : this->Line)
  {
    length += line.empty() ? 0.0 : (positions[v] - line.back()).norm();
    line.push_back(positions[v]);
  }
  return length > 0.0 ? farthestFromChord(line) / length : 0.0;
}

GrainReport GrainReference::report(const PieceContext& context, const Points2& positions) const
{
  GrainReport report{ this->angle(positions), this->Curve, this->bend(positions), this->Missing,
    {} };
  const auto count = static_cast<Index>(this->Missing ? context.curves.size() : 0);
  for (Index c = 0; c < count; ++c)
  {
    if (!lineInPiece(context, c).empty())
    {
      report.candidates.push_back(c);
    }
  }
  return report;
}

Points2 GrainReference::turned(double angle, const Points2& positions) const
{
  const double turn = this->angle(positions) - angle;
  const double cosine = std::cos(turn);
  const double sine = std::sin(turn);
  Points2 result;
  result.reserve(positions.size());
  for (const Point2& p : positions)
  {
    const Point2 d = p - positions.front();
    result.emplace_back(cosine * d.x() - sine * d.y(), sine * d.x() + cosine * d.y());
  }
  return result;
}

GrainHold GrainReference::hold(const Points2& positions) const
{
  GrainHold hold;
  if (this->Curve != none)
  {
    const Point2 line = (positions[this->Line.back()] - positions[this->Line.front()]).normalized();
    const Point2 across(-line.y(), line.x());
    hold.weights = { { this->Line.front(), -across }, { this->Line.back(), across } };
    return hold;
  }
  // No turn from here: sum share (p - middle) x (x - middle) = 0.
  const Point2 middle = middleOf(positions, this->Share);
  double spread = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    const Point2 d = positions[v] - middle;
    spread += this->Share[v] * d.squaredNorm();
    hold.weights.push_back({ static_cast<Index>(v), this->Share[v] * Point2(-d.y(), d.x()) });
  }
  for (GrainHold::Weight& part : hold.weights)
  {
    part.weight /= std::sqrt(spread);
  }
  return hold;
}
}
