// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PatternChecks.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
Status invalidOption(const std::string& message)
{
  return { StatusCode::InvalidOption, message };
}

bool isLength(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

/// \param what names the curve
Status checkName(const PatternSource& source, const std::string& what, const std::string& wanted)
{
  const bool known = wanted == "boundary" ||
    std::any_of(source.wires.begin(), source.wires.end(),
      [&wanted](const SourceWire& wire) { return wire.name == wanted; });
  if (known)
  {
    return {};
  }
  std::string names = "boundary";
  for (const SourceWire& wire : source.wires)
  {
    if (wire.type != WireType::Boundary && names.find(wire.name) == std::string::npos &&
      names.size() < 200)
    {
      names += ", " + wire.name;
    }
  }
  return invalidOption(
    what + " names the curve " + wanted + ", which is not there; there are " + names);
}
}

Status checkPatternOptions(const PatternSource& source, const PatternOptions& options)
{
  if (!isLength(options.allowance))
  {
    return invalidOption("the seam allowance must be a number of millimetres from 0");
  }
  if (!std::isfinite(options.mitreLimit) || options.mitreLimit < 1.0)
  {
    return invalidOption("the mitre limit must be a number from 1");
  }
  if (!isLength(options.notchSpacing) || !isLength(options.notchLength))
  {
    return invalidOption("notch spacing and length must be numbers of millimetres from 0");
  }
  if (!isLength(options.fairTolerance))
  {
    return invalidOption("the tolerance of smooth borders must be a number of millimetres from 0");
  }
  if (options.symmetrize && !options.isFair(source))
  {
    return { StatusCode::InvalidOption,
      "outlines are made their own mirror images as smooth borders alone, and none is to be smooth",
      {}, { { Remedy::Give, "a tolerance of smooth borders above 0 mm" } } };
  }
  if (options.quantity < 1)
  {
    return invalidOption("the quantity must be a whole number from 1");
  }
  for (std::size_t p = 0; p < options.pieceQuantities.size(); ++p)
  {
    if (options.pieceQuantities[p] < 0)
    {
      return invalidOption(
        "the quantity of piece " + std::to_string(p + 1) + " must be a whole number from 1");
    }
  }
  for (const auto& [name, allowance] : options.allowanceOfCurve)
  {
    if (!isLength(allowance))
    {
      return invalidOption(
        "the seam allowance of " + name + " must be a number of millimetres from 0");
    }
    Status status = checkName(source, "a seam allowance", name);
    if (!status.ok())
    {
      return status;
    }
  }
  for (const auto& [name, tolerance] : options.fairToleranceOfCurve)
  {
    if (!isLength(tolerance))
    {
      return invalidOption(
        "the tolerance of the smooth " + name + " must be a number of millimetres from 0");
    }
    Status status = checkName(source, "a tolerance of smooth borders", name);
    if (!status.ok())
    {
      return status;
    }
  }
  if (!isLength(options.dartTip))
  {
    return invalidOption(
      "how far tips of darts are drawn back must be a number of millimetres from 0");
  }
  for (const auto& [name, back] : options.dartTipOfCurve)
  {
    if (!isLength(back))
    {
      return invalidOption(
        "how far the tip of " + name + " is drawn back must be a number of millimetres from 0");
    }
    Status status = checkName(source, "a tip to be drawn back", name);
    if (!status.ok())
    {
      return status;
    }
  }
  for (const std::string& name : options.foldsAlong)
  {
    Status status = checkName(source, "a fold", name);
    if (!status.ok())
    {
      return status;
    }
  }
  for (const std::string& name : options.doubleNotches)
  {
    Status status = checkName(source, "a double notch", name);
    if (!status.ok())
    {
      return status;
    }
  }
  for (const auto& [name, distances] : options.notchesOfCurve)
  {
    if (!std::all_of(distances.begin(), distances.end(), isLength))
    {
      return invalidOption("the notches of " + name + " must be numbers of millimetres from 0");
    }
    Status status = checkName(source, "a notch", name);
    if (!status.ok())
    {
      return status;
    }
  }
  return {};
}
}
}
