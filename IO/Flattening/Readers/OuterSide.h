// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

namespace wirewarp
{
/// Of each closed part that is a sheet with thickness, as modellers and scanners give cloth, keeps
/// the larger of the sides between the sharp edges of its rim; open parts stay as they are.
/// \return a line that says what was done
std::string takeOuterSide(TriangleList& list);
}
