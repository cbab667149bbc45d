// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkLookupTable.h>

#include <array>
#include <optional>

namespace figures
{
/// What the colours of a surface and its flat pieces show.
enum class Coloring
{
  Developability,
  Homogeneity,
  AspectRatio,
  Area
};

constexpr std::array<Coloring, 4> colorings{ Coloring::Developability, Coloring::Homogeneity,
  Coloring::AspectRatio, Coloring::Area };

/// "developability", "homogeneity", "aspect-ratio", "area".
const char* nameOf(Coloring coloring);
std::optional<Coloring> coloringOf(const std::string& name);

/// An array of the outputs of vtkWireWarpingFilter and how it is coloured.
struct ColorMap
{
  const char* array;
  bool onPoints;
  const char* title;
  vtkSmartPointer<vtkLookupTable> colors;
  int labels; ///< numbers along the scale, so that they are round
};

/// Blue is good and red is poor; of areas, blue is smaller and red larger than on the surface.
/// @param flat what is coloured: the developability's range follows its largest value
ColorMap makeColorMap(Coloring coloring, const PolyData& flat);
}
