// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <array>

namespace interaction
{
/// A plane.
struct Symmetry
{
  std::array<double, 3> origin{};
  std::array<double, 3> normal{ 1.0, 0.0, 0.0 };
};

/// The point of a surface that is seen at a place in the window.
class SurfacePicker
{
public:
  void setSurface(vtkPolyData* surface);

  /// Looks at the pixels around as well, up to a distance, for who aims at the boundary and misses.
  /// \return whether the surface is seen there
  bool pick(vtkRenderer* renderer, const std::array<int, 2>& pixel, int around,
    std::array<double, 3>& point) const;
  /// The plane through the middle of the surface, upright to an axis, in which the surface is most
  /// like its image.
  Symmetry symmetry() const;

private:
  bool pickPixel(vtkRenderer* renderer, double x, double y, std::array<double, 3>& point) const;

  vtkNew<vtkStaticCellLocator> Locator;
  vtkSmartPointer<vtkPolyData> Surface;
};

/// Length of a pixel at a point, in the unit of the scene.
double pixelSize(vtkRenderer* renderer, const std::array<double, 3>& point);
}
