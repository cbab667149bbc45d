// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <array>

namespace flattening::interaction
{
/// A plane.
struct Symmetry
{
  std::array<double, 3> origin{};
  std::array<double, 3> normal{ 1.0, 0.0, 0.0 };
  /// How far the surface's image lies from it (RMS), as a fraction of how far it is from its
  /// points.
  double error = 0.0;
};

struct SurfacePick
{
  std::array<double, 3> point{};
  double pixel = 0.0; ///< length of a pixel there, in the unit of the scene
};

/// The point of a surface that is seen at a place in the window.
class SurfacePicker
{
public:
  void setSurface(vtkPolyData* surface);

  /// Looks at the pixels around as well, up to a distance, for who aims at the boundary and misses.
  /// \return whether the surface is seen there
  bool pick(
    vtkRenderer* renderer, const std::array<int, 2>& pixel, int around, SurfacePick& picked) const;
  /// The plane through the middle of the surface, upright to an axis, in which the surface is most
  /// like its image.
  Symmetry symmetry() const;

private:
  bool pickPixel(vtkRenderer* renderer, double x, double y, SurfacePick& picked) const;
  /// Whether a triangle is seen from within a surface that surrounds a space.
  bool isInside(vtkIdType triangle, const std::array<double, 3>& way) const;

  vtkNew<vtkStaticCellLocator> Locator;
  vtkSmartPointer<vtkPolyData> Surface;
  double Outwards = 0.0; ///< 1 or -1: where the normals of one that surrounds a space point; or 0
};
}
