// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/SmoothRamp.h"

namespace flattening
{
/// Stiffness of a material's stiffer thread in its energies, as |J - R|^2 has it for a stretch in
/// one direction; the other stiffnesses are in proportion.
inline constexpr double stiffestThread = 2.0;

/// Half the square of a thread's strain, times compression where it is shorter than at rest; the
/// second derivative passes from one to the other over two parts in a thousand.
Curve2 threadEnergy(double strain, double compression);
}
