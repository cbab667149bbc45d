// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace flattening
{
namespace bridge
{
/// By how much of its length a curve is eased, or may be.
struct CurveFraction
{
  std::string curve;
  int piece = -1; ///< from 0; -1: none is named
  double fraction = 0.0;

  bool operator==(const CurveFraction& other) const
  {
    return this->curve == other.curve && this->piece == other.piece &&
      this->fraction == other.fraction;
  }
};

/// Reads "NAME:PIECE=+3%; NAME=2%", where pieces are numbered from 1 and a name may hold both
/// signs.
/// \param ease with pieces and either sign; otherwise from 0 alone, and a colon belongs to the name
/// \return false where the text is none of it
bool readFractions(const std::string& text, bool ease, std::vector<CurveFraction>& fractions);
/// Them as such text, to 15 digits, of eases with their signs.
std::string fractionsText(const std::vector<CurveFraction>& fractions, bool ease);
}
}
