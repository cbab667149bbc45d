// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/RemedyWords.h"
#include "Base/Status.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flattening
{
/// The defect and its remedies, with the names of the filters' properties and of their inputs'
/// arrays; empty where the status is Ok.
std::string inWords(const Status& status);

std::vector<NamedRemedy> remediesOf(const Status& status);

/// What the ids of a kind are called where the input is meant; "" for those that mean nothing to a
/// caller.
const char* kindName(ElementKind kind);

/// The status in the input's ids, each once, in order of first mention. Where they differ from
/// those that the message tells, they are added to it.
/// \param inputId per id of the status its id in the input; negative: it has none
Status inInput(Status status, const std::vector<std::int64_t>& inputId);
}
