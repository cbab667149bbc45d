// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/CurveImprint.h"
#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

#include <string>
#include <vector>

namespace benchmarks
{
/// A piece of Data as its files have it.
struct DataPiece
{
  flattening::Points3 points;
  flattening::Triangles triangles;
  std::vector<flattening::Polyline> curves; ///< pointIds: of the file of curves
};

/// Reads .vtp files. Throws std::runtime_error.
DataPiece readPiece(const std::string& surfaceFile, const std::string& curvesFile);

/// A surface in memory with feature curves along its edges.
struct RefinedPiece
{
  flattening::TriangleMesh mesh;
  std::vector<flattening::FeatureCurve> curves;
};

/// Reads `folder/name.vtp` and `folder/name_curves.vtp` and divides each edge by `division`, so
/// that there are division^2 times as many triangles. New vertices lie on the cubic PN triangles
/// (Vlachos, Peters, Boyd, Mitchell, "Curved PN triangles", 2001), so that the surface stays
/// smooth; curves follow. Throws std::runtime_error.
RefinedPiece readRefined(const std::string& folder, const std::string& name, int division);
}
