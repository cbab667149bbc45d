// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/RemedyWords.h"

#include <string>
#include <vector>

namespace wirewarp
{
using Remedy = flattening::NamedRemedy;

/// The sentence of a remedy with the command's options; % stands for the subject.
std::string remedyWords(const std::string& name);

/// A defect and its remedies.
std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies);
}
