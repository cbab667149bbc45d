// SPDX-License-Identifier: BSD-3-Clause
#include "Grading/SizeGrading.h"

#include "Outlines/Outline.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_set>

namespace flattening::pattern
{
namespace
{
Status invalidSizes(const std::string& message)
{
  return { StatusCode::InvalidOption, message };
}

std::string inQuotes(const std::string& name)
{
  return "'" + name + "'";
}

Status checkNames(const std::vector<PatternSize>& sizes)
{
  if (sizes.size() < 2)
  {
    return invalidSizes("there are " + std::to_string(sizes.size()) + " sizes; grading needs two");
  }
  std::set<std::string> names;
  for (const PatternSize& size : sizes)
  {
    if (size.name.empty())
    {
      return invalidSizes("a size has no name");
    }
    if (!names.insert(size.name).second)
    {
      return invalidSizes("two sizes are named " + inQuotes(size.name));
    }
  }
  return {};
}

Status broken(const PatternSize& size, const std::string& what)
{
  return invalidPieces("size " + inQuotes(size.name) + ": " + what);
}

/// \param base whose pieces and wires the others are to have, too
Status checkSound(const PatternSize& size, const PatternSize& base)
{
  const PatternSource& source = size.source;
  const auto finite = [](const Point2& p) { return isFinite(p); };
  if (!std::all_of(source.positions.begin(), source.positions.end(), finite))
  {
    return broken(size, "a point of the flat surface is not finite");
  }
  if (&size != &base)
  {
    return {};
  }
  const auto count = static_cast<Index>(source.triangles.size());
  Index pieces = 0;
  for (const Index piece : source.pieceOfTriangle)
  {
    if (piece < 0 || piece >= count)
    {
      return broken(size, "a PieceId is " + std::to_string(piece));
    }
    pieces = std::max(pieces, piece + 1);
  }
  for (const SourceWire& wire : source.wires)
  {
    if (wire.points.size() < 2 || wire.piece < 0 || wire.piece >= pieces)
    {
      return broken(size, "the wire " + inQuotes(wire.name) + " is of no piece or has no length");
    }
  }
  return {};
}

/// Whether a size differs from the base in where its points are alone.
Status checkAlike(const PatternSize& size, const PatternSize& base)
{
  const PatternSource& mine = size.source;
  const PatternSource& model = base.source;
  if (mine.triangles != model.triangles || mine.positions.size() != model.positions.size() ||
    mine.pieceOfTriangle != model.pieceOfTriangle)
  {
    return invalidSizes("size " + inQuotes(size.name) + " has another mesh than " +
      inQuotes(base.name) +
      ": sizes must be surfaces of one connectivity, with the same curves along their edges");
  }
  for (std::size_t w = 0; w < std::min(mine.wires.size(), model.wires.size()); ++w)
  {
    const SourceWire& wire = mine.wires[w];
    const SourceWire& other = model.wires[w];
    if (wire.name != other.name || wire.type != other.type || wire.piece != other.piece ||
      wire.points != other.points)
    {
      return invalidSizes("the curve " + inQuotes(wire.name) + " of size " + inQuotes(size.name) +
        " runs elsewhere than in " + inQuotes(base.name) + ", on piece " +
        std::to_string(wire.piece + 1));
    }
  }
  if (mine.wires.size() != model.wires.size())
  {
    return invalidSizes(
      "size " + inQuotes(size.name) + " has other curves than " + inQuotes(base.name));
  }
  return {};
}

/// Whether sizes can be graded. \param base the place of the base size among them, which is found
/// \return the errors of gradeSizes()
Status checkSizes(
  const std::vector<PatternSize>& sizes, const GradingOptions& options, std::size_t& base)
{
  Status status = checkNames(sizes);
  if (!status.ok())
  {
    return status;
  }
  base = (sizes.size() - 1) / 2;
  std::string names;
  for (std::size_t s = 0; s < sizes.size(); ++s)
  {
    names += (s > 0 ? ", " : "") + sizes[s].name;
    base = sizes[s].name == options.base ? s : base;
  }
  if (!options.base.empty() && sizes[base].name != options.base)
  {
    return invalidSizes("there is no size " + inQuotes(options.base) + "; there are " + names);
  }
  for (const PatternSize& size : sizes)
  {
    status = checkAlike(size, sizes[base]);
    status = status.ok() ? checkSound(size, sizes[base]) : status;
    if (!status.ok())
    {
      return status;
    }
  }
  std::set<std::string> curves;
  for (const SourceWire& wire : sizes[base].source.wires)
  {
    curves.insert(wire.name);
  }
  if (!options.alignment.empty() && curves.count(options.alignment) == 0)
  {
    return invalidSizes(
      "no curve is named " + inQuotes(options.alignment) + "; the curves are " + listed(curves));
  }
  return {};
}

constexpr double cornerAngle = pi / 6.0; ///< a sharper turn of the boundary has a rule

/// Where pieces of one size are laid on those of the others.
struct Frame
{
  Point2 origin = Point2::Zero();
  Point2 along = Point2::UnitY(); ///< the grain, of length 1
};

/// The wire along which a piece is laid; null where there is none.
const SourceWire* aligningWire(
  const PatternSource& model, const BorderEdges& border, const GradingOptions& options, Index piece)
{
  for (const SourceWire& wire : model.wires)
  {
    const bool chosen = options.alignment.empty()
      ? wire.type == WireType::Key && !areOnBorder(border, wire.points)
      : wire.name == options.alignment;
    if (wire.piece == piece && chosen)
    {
      return &wire;
    }
  }
  return nullptr;
}

/// The middle of the wires of a piece, turned as they fit those of the base best.
Frame fittedFrame(const PatternSource& model, const PatternSource& size, Index piece)
{
  std::set<Index> points;
  for (const SourceWire& wire : model.wires)
  {
    if (wire.piece == piece)
    {
      points.insert(wire.points.begin(), wire.points.end());
    }
  }
  Frame frame;
  Point2 middle = Point2::Zero(); // of the base
  for (const Index point : points)
  {
    frame.origin += size.positions[point] / static_cast<double>(points.size());
    middle += model.positions[point] / static_cast<double>(points.size());
  }
  double sine = 0.0;
  double cosine = 0.0;
  for (const Index point : points)
  {
    const Point2 here = size.positions[point] - frame.origin;
    const Point2 there = model.positions[point] - middle;
    sine += cross(here, there);
    cosine += here.dot(there);
  }
  const double length = std::hypot(sine, cosine);
  if (length > 0.0 && &size != &model)
  {
    frame.along = Point2(sine, cosine) / length;
  }
  return frame;
}

std::vector<Frame> framesOf(const PatternSource& model, const BorderEdges& border,
  const GradingOptions& options, const PatternSource& size)
{
  std::vector<Frame> frames;
  for (Index piece = 0; piece < static_cast<Index>(pieceCount(model)); ++piece)
  {
    const SourceWire* const wire = aligningWire(model, border, options, piece);
    const Point2 from = wire ? size.positions[wire->points.front()] : Point2(Point2::Zero());
    const Point2 way = wire ? Point2(size.positions[wire->points.back()] - from) : from;
    frames.push_back(way.norm() > 0.0
        ? Frame{ from, (way.y() >= 0.0 ? 1.0 : -1.0) * way.normalized() }
        : fittedFrame(model, size, piece));
  }
  return frames;
}

/// The points of a size in the frames of its pieces. \param scale millimetres per unit
Points2 laidPoints(const PatternSource& size, const std::vector<Frame>& frames, double scale)
{
  Points2 laid(size.positions.size(), Point2::Zero());
  for (std::size_t t = 0; t < size.triangles.size(); ++t)
  {
    const Frame& frame = frames[static_cast<std::size_t>(size.pieceOfTriangle[t])];
    for (const Index point : size.triangles[t])
    {
      const Point2 way = scale * (size.positions[point] - frame.origin);
      laid[point] = { -cross(frame.along, way), frame.along.dot(way) };
    }
  }
  return laid;
}

Indices cornersOf(const PatternSource& model, const SourceWire& wire, bool closed)
{
  Indices found;
  const std::size_t count = wire.points.size();
  for (std::size_t k = 1; k + (closed ? 0 : 1) < count; ++k)
  {
    const Point2& at = model.positions[wire.points[k]];
    const Point2& next = model.positions[wire.points[k + 1 < count ? k + 1 : 1]];
    const Point2 in = at - model.positions[wire.points[k - 1]];
    const Point2 out = next - at;
    if (std::abs(std::atan2(cross(in, out), in.dot(out))) > cornerAngle)
    {
      found.push_back(wire.points[k]);
    }
  }
  return found;
}

/// Points with rules, without their deltas.
std::vector<GradeRule> rulePoints(const PatternSource& model, const BorderEdges& border)
{
  std::unordered_set<Index> onBorder;
  for (const auto& [edge, piece] : border)
  {
    onBorder.insert(startOf(edge));
  }
  std::map<std::pair<Index, Index>, std::vector<std::string>> places;
  for (const SourceWire& wire : model.wires)
  {
    const bool closed = wire.points.front() == wire.points.back();
    for (const Index end : { wire.points.front(), wire.points.back() })
    {
      if (!closed && onBorder.count(end) > 0)
      {
        std::vector<std::string>& names = places[{ wire.piece, end }];
        if (std::find(names.begin(), names.end(), wire.name) == names.end())
        {
          names.push_back(wire.name);
        }
      }
    }
    if (wire.type == WireType::Boundary)
    {
      for (const Index corner : cornersOf(model, wire, closed))
      {
        places.insert({ { wire.piece, corner }, { wire.name } });
      }
    }
  }
  std::vector<GradeRule> rules;
  for (const auto& [place, names] : places)
  {
    rules.push_back({ place.first, place.second, listed(names), {} });
  }
  return rules;
}
}

Status gradeSizes(
  const std::vector<PatternSize>& sizes, const GradingOptions& options, Grading& grading)
{
  grading = Grading();
  Status status = checkSizes(sizes, options, grading.base);
  if (!status.ok())
  {
    return status;
  }
  const PatternSource& model = sizes[grading.base].source;
  const BorderEdges border = bordersOf(model);
  grading.wires = model.wires;
  grading.rules = rulePoints(model, border);
  for (const PatternSize& size : sizes)
  {
    const std::vector<Frame> frames = framesOf(model, border, options, size.source);
    grading.sizes.push_back(size.name);
    grading.positions.push_back(laidPoints(size.source, frames, millimetresPer(options.unit)));
    for (std::size_t p = 0; &size.source == &model && p < frames.size(); ++p)
    {
      grading.grains.push_back(frames[p].along);
    }
  }
  for (GradeRule& rule : grading.rules)
  {
    const Point2 from = grading.positions[grading.base][rule.point];
    for (const Points2& laid : grading.positions)
    {
      rule.deltas.emplace_back(laid[rule.point] - from);
    }
  }
  return status;
}
}
