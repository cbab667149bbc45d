// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace flattening
{
namespace pattern
{
/// Why there is no pattern.
enum class PatternCode
{
  Ok,
  NothingToDraw, ///< no piece, or a piece without area
  InvalidInput,  ///< broken ids, infinite coordinates, an outline that is no loop
  InvalidOption,
  TooLarge,    ///< for the pages
  CannotWrite, ///< the file
};

/// Outcome of a step: the defect, where, and the way out in words.
struct PatternStatus
{
  PatternCode code = PatternCode::Ok;
  std::string message;

  bool ok() const { return this->code == PatternCode::Ok; }
};
}
}
