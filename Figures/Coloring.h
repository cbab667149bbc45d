// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing.h"
#include "Pieces.h"

#include <vtkLookupTable.h>

#include <array>
#include <optional>
#include <string>

namespace figures
{
/// What the colors of a surface and its flat pieces show.
enum class Coloring
{
  Developability,
  Homogeneity,
  AspectRatio,
  Area,
  Strain, ///< of withStrain()
  Stretch,
  Warp,
  Weft,
  Shear,
  Distance, ///< of the sewn surface from the design
  Piece     ///< a color for each piece
};

constexpr std::array<Coloring, 4> colorings{ Coloring::Developability, Coloring::Homogeneity,
  Coloring::AspectRatio, Coloring::Area };

/// Those of pieces on a material.
constexpr std::array<Coloring, 4> threadColorings{ Coloring::Stretch, Coloring::Warp,
  Coloring::Weft, Coloring::Shear };

/// "developability", "homogeneity", "aspect-ratio", "area", "strain", "stretch", "warp", "weft",
/// "shear", "distance", "piece".
const char* nameOf(Coloring coloring);
std::optional<Coloring> coloringOf(const std::string& name);

/// An array of the outputs of vtkWireWarpingFilter, or of vtkSewnShape, and how it is colored.
struct ColorMap
{
  const char* array;
  bool onPoints;
  std::string title;
  vtkSmartPointer<vtkLookupTable> colors;
  int labels; ///< numbers along the scale, so that they are round; 0: there is no scale
};

/// Magnitudes are in viridis, light where good and dark where poor; what goes either way from 0 or
/// 1 is diverging. Of areas, blue is smaller and red larger than on the surface. The largest
/// stretch has steps of 2.5 % from 100 to 120 %; of warp and weft, blue is compressed and red
/// drawn; these three reach as far from the middle as the triangles from 5 to 95 %; of the shear,
/// blue and red are its two senses, up to the material's limit, where threads lock, or 15 degrees
/// where it has none.
/// @param piece what is colored: the ranges of developability and distance follow its largest value,
///              that of the strain what 99 % of the triangles have
/// @param range of the colors in place of these; its ends are equal where it is none
ColorMap makeColorMap(Coloring coloring, const FlatPiece& piece, ColorRange range = { 0.0, 0.0 });

/// The piece with the cell array `Strain` on the flat piece and the cut surface: the larger of
/// abs(ln S) and abs(ln s) of each triangle in percent, S and s the singular values of its map into
/// the plane.
FlatPiece withStrain(const FlatPiece& piece);
}
