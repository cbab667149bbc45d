// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Edges to add as wires so that all wires hang together: shortest paths of mesh edges from the
/// wires that are joined to the given root vertex to the others, nearest first.
/// \param isWire per half-edge, both sides of an edge alike. \return half-edges.
Indices findConnectors(const TriangleMesh& mesh, const std::vector<char>& isWire, Index root);
}
