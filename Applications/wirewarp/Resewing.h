// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionTable.h"

#include <string>

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;

/// Whether and how flat pieces are sewn together again.
struct ResewingRequest
{
  std::string test; ///< "panel" or "product"; empty: none
  flattening::OptionValues values{ flattening::OptionOwner::Sewing };

  bool any() const { return !this->test.empty(); }
};

void addResewing(CLI::App& app, ResewingRequest& request);

/// Sews the flat pieces together again where that is asked for. What the cloth cannot do ends in
/// the result's status: a refusal leaves nothing of the flattening.
/// \param body file of it; empty: none. \param material of which the cloth is; empty: none
void sewAgain(const ResewingRequest& request, const std::string& body, const std::string& material,
  bool quiet, Flattening& result);

/// A line a piece, or a line of all that is sewn together: how far it is from the surface; empty
/// where nothing was sewn.
std::string resewingTable(const ResewingRequest& request, const Flattening& result);
}
