// SPDX-License-Identifier: BSD-3-Clause
// The options of all filters, each declared once. Front ends may include this header: it needs the
// standard library alone.
#pragma once

#include "Options/Option.h"

#include <optional>
#include <string>
#include <vector>

namespace flattening
{
/// All options, ordered by owner and group.
const std::vector<Option>& optionTable();

/// Name of the VTK class.
const char* className(OptionOwner owner);

/// The way back; none where no class of the name has options.
std::optional<OptionOwner> ownerNamed(const std::string& name);

/// The options of a filter: those of the classes that it derives from, and its own; with those of
/// Warping also those of Conformal, which programs have as a scheme.
std::vector<const Option*> optionsOf(OptionOwner owner);

/// \return the option of this filter, or null.
const Option* findOption(OptionOwner owner, const std::string& property);
}
