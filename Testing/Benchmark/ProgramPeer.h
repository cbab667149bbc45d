// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Measure.h"
#include "Surface/TriangleMesh.h"

#include <string>

namespace benchmarks
{
/// Lets a program of the reader's own map a disk: it is given an OBJ file and how often to map it,
/// and prints a line a run: the seconds that pass and those of the processor, both of the map
/// alone, its mesh in memory. The bytes are unknown. Throws std::runtime_error where it fails or
/// prints anything else.
Measured runProgram(
  const std::string& program, const flattening::TriangleMesh& mesh, const Repeats& repeats);
}
