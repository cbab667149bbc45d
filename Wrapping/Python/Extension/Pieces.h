// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace flattening::python
{
/// Adds what is done with flat pieces, and what reads files.
void definePieces(pybind11::module_& module);
/// Adds what draws curves and measures.
void defineSurfaces(pybind11::module_& module);
}
