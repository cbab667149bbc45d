// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Status.h"

#include <cstdio>

#include <algorithm>

namespace flattening
{
int severity(StatusCode code)
{
  switch (code)
  {
    case StatusCode::Ok:
      return 0;
    case StatusCode::BeyondLimits:
      return 1;
    case StatusCode::MissingGrain:
      return 2;
    case StatusCode::Overlap:
      return 3;
    case StatusCode::FlippedTriangles:
      return 4;
    case StatusCode::NotConverged:
      return 5;
    case StatusCode::IncompatibleKeys:
      return 6;
    case StatusCode::LengthError:
      return 7;
    default:
      return 8;
  }
}

const char* statusName(StatusCode code)
{
  switch (code)
  {
    case StatusCode::Ok:
      return "Ok";
    case StatusCode::Cancelled:
      return "Cancelled";
    case StatusCode::EmptySurface:
      return "EmptySurface";
    case StatusCode::NonFinitePoint:
      return "NonFinitePoint";
    case StatusCode::InvalidPointId:
      return "InvalidPointId";
    case StatusCode::DegenerateTriangle:
      return "DegenerateTriangle";
    case StatusCode::NonManifoldEdge:
      return "NonManifoldEdge";
    case StatusCode::NonManifoldVertex:
      return "NonManifoldVertex";
    case StatusCode::NotOrientable:
      return "NotOrientable";
    case StatusCode::ClosedSurface:
      return "ClosedSurface";
    case StatusCode::Handle:
      return "Handle";
    case StatusCode::CurveTooShort:
      return "CurveTooShort";
    case StatusCode::CurvePointOffSurface:
      return "CurvePointOffSurface";
    case StatusCode::CurveLeavesSurface:
      return "CurveLeavesSurface";
    case StatusCode::CurveNotOnEdges:
      return "CurveNotOnEdges";
    case StatusCode::InvalidCurve:
      return "InvalidCurve";
    case StatusCode::InvalidOption:
      return "InvalidOption";
    case StatusCode::OutOfMemory:
      return "OutOfMemory";
    case StatusCode::NumericalFailure:
      return "NumericalFailure";
    case StatusCode::MissingGrain:
      return "MissingGrain";
    case StatusCode::BeyondLimits:
      return "BeyondLimits";
    case StatusCode::NothingToDraw:
      return "NothingToDraw";
    case StatusCode::InvalidPattern:
      return "InvalidPattern";
    case StatusCode::PatternTooLarge:
      return "PatternTooLarge";
    case StatusCode::FileNotWritten:
      return "FileNotWritten";
    case StatusCode::NotConverged:
      return "NotConverged";
    case StatusCode::IncompatibleKeys:
      return "IncompatibleKeys";
    case StatusCode::LengthError:
      return "LengthError";
    case StatusCode::FlippedTriangles:
      return "FlippedTriangles";
    case StatusCode::Overlap:
      return "Overlap";
  }
  return "Unknown";
}

namespace
{
template <class Ids>
std::string listed(const Ids& ids, std::size_t most)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), most); ++i)
  {
    text += (i ? ", " : "") + std::to_string(ids[i]);
  }
  if (ids.size() > most)
  {
    text += " and " + std::to_string(ids.size() - most) + " more";
  }
  return text;
}
}

std::string listIds(const Indices& ids, std::size_t most)
{
  return listed(ids, most);
}

std::string listIds(const std::vector<std::int64_t>& ids, std::size_t most)
{
  return listed(ids, most);
}

std::string shortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string percent(double fraction)
{
  return shortNumber(100.0 * fraction) + " %";
}
}
