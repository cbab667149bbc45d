// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// A body that cloth lies on.
struct LoadedBody
{
  TriangleMesh mesh;
  bool given = false;
  Status outcome;

  const TriangleMesh* get() const { return this->given ? &this->mesh : nullptr; }
};

/// Reads a body; null: there is none. One that is closed is turned so that its normals point
/// outwards.
LoadedBody loadBody(vtkPolyData* body);
}
}
