// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OrdinarySurface.h"

namespace hostile
{
/// A surface to draw on: an ordinary one, one triangle, balls with poles and without, tori, tubes,
/// solids of few triangles, double pyramids with hubs, a needle; or two of these beside each other.
/// In units from 1e-6 to 1e6.
Specimen makeVariedSurface(std::mt19937& random);
}
