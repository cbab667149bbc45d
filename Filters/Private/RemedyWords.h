// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

namespace flattening
{
namespace bridge
{
/// How the filters say a remedy: with the names of their properties and of their inputs' arrays. %
/// stands for the subject.
const char* remedyWords(Remedy remedy);

/// The defect and the ways out of it; empty where the status is Ok.
std::string inWords(const Status& status);
}
}
