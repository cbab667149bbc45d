// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <string>

namespace flattening
{
namespace bridge
{
/// The defect and its remedies, with the names of the filters' properties and of their inputs'
/// arrays; empty where the status is Ok.
std::string inWords(const Status& status);
}
}
