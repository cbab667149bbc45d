// SPDX-License-Identifier: BSD-3-Clause
#include "Grading/SizeChecks.h"

#include "Base/Types.h"

#include <algorithm>
#include <set>

namespace flattening
{
namespace pattern
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

std::string listed(const std::set<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
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
  return { StatusCode::InvalidPattern, "size " + inQuotes(size.name) + ": " + what, {},
    { Remedy::GiveFlatPieces } };
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
}

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
    if (status.ok())
    {
      status = checkSound(size, sizes[base]);
    }
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
}
}
