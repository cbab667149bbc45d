// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Coloring.h"
#include "Drawing.h"

#include <vtkRenderWindow.h>

#include <string>
#include <vector>

namespace figures
{
/// What a picture of a pattern shows.
struct PatternScene
{
  FlatPiece piece;
  PolyData sewn; ///< Coloring::Distance: output 0 of vtkSewnShape
  Coloring coloring = Coloring::Homogeneity;
  ColorRange range{ 0.0, 0.0 }; ///< of the colors; equal ends: by what is shown
  /// Curves that are no wires, as lines in space and in the plane, or null.
  PolyData releasedInSpace;
  PolyData releasedInPlane;
  std::string title;
  std::string message; ///< what is amiss, or what to know; may have several lines
  bool warning = false;
};

/// A window with the surface in space on the left, its flat pieces on the right, each with a camera
/// of its own, and below them the errors, the colours of the wires and the scale of the colours.
class PatternPicture
{
public:
  /// @param width, height of the window in pixels
  /// @param samples samples a pixel
  PatternPicture(int width, int height, int samples);

  /// Draws the scene. The cameras are set by the first scene and by resetCameras().
  void show(const PatternScene& scene);
  void resetCameras() { this->CamerasSet = false; }

  vtkRenderWindow* window() { return this->Window; }
  vtkRenderer* space() { return this->Space; }
  vtkRenderer* plane() { return this->Plane; }
  /// Writes what is shown as PNG. Throws std::runtime_error.
  void write(const std::string& path);

private:
  enum class TextStyle
  {
    Plain,
    Bold,
    FixedPitch
  };

  void drawPanels(const PatternScene& scene, const ColorMap& map);
  void drawTexts(const PatternScene& scene);
  void drawLegend(const PatternScene& scene);
  void drawScale(const ColorMap& map);
  /// @return its width in pixels
  int addText(const std::string& text, int x, int y, int size, const Vector& color,
    TextStyle style = TextStyle::Plain, bool fromTop = false);

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Space;
  vtkSmartPointer<vtkRenderer> Plane;
  vtkSmartPointer<vtkRenderer> Ground; ///< behind the words below
  vtkSmartPointer<vtkRenderer> Overlay;
  bool CamerasSet = false;
};

/// One row of measures a piece, in columns of equal width, with a head.
std::vector<std::string> errorTable(const FlatPiece& piece, std::size_t maximumRows);
}
