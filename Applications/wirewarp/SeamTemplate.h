// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

#include <string>

namespace wirewarp
{
/// Seams as makers place them before any are proposed.
struct SeamTemplate
{
  std::string name; ///< "front-back", "gores" or "strips"; empty: none
  int pieces = 0;   ///< of gores; 0: six
  bool given() const { return this->name == "front-back" || this->name == "gores"; }
};

/// Where planes cut a surface, as curves with names: the one that parts front and back, across the
/// shorter of its sides that are level, or those through its upright axis. Throws InputError where
/// the surface is not a manifold, or no plane meets it.
flattening::DataSet seamsOf(const SeamTemplate& seams, const flattening::DataSet& surface);
}
