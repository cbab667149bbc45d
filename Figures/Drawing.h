// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <vector>

namespace figures
{
using Vector = std::array<double, 3>;

/// A range of values from blue to red; `low` above `high` turns the colors round.
struct ColorRange
{
  double low;
  double high;
};

/// Sizes in pixels.
struct FigureStyle
{
  double wireWidth = 4.0;
  int gap = 14;
  int titleHeight = 28;
  int scaleHeight = 90; ///< of colors, with title and numbers
};

/// How the two sides of an opened dart are drawn.
enum class DartSides
{
  Black, ///< as what they are in the plane, a boundary
  Blue
};

/// One part of a figure, in parallel projection: the plane from above, or space.
class Drawing
{
public:
  Drawing();

  /// Words above the drawing.
  void setTitle(const std::string& title);
  /// Looks at space from a direction; without it the drawing shows the plane.
  void lookFrom(const Vector& direction, const Vector& up = { 0.0, 1.0, 0.0 });

  void addSurface(const PolyData& surface);
  /// A surface through which others are seen.
  void addGhost(const PolyData& surface);
  void addPointMap(const PolyData& surface, const char* array, ColorRange range);
  void addCellMap(const PolyData& surface, const char* array, ColorRange range);
  void addMap(const PolyData& surface, const char* array, bool onPoints, vtkLookupTable* colors);
  /// Neighbouring numbers get colors that differ.
  void addCategories(const PolyData& surface, const char* array);

  /// The wires of a flat piece, or feature curves in space: key red, accessory green, dart blue,
  /// the boundary black.
  void addWires(const PolyData& wires, DartSides sides = DartSides::Black);
  /// The boundary of a surface, black.
  void addBoundary(const PolyData& surface);

  vtkRenderer* renderer() { return this->Renderer; }
  bool hasTitle() const { return this->Title != nullptr; }
  /// Width and height of what is drawn, in the unit of length.
  std::array<double, 2> size() const;
  /// Sets the camera and draws the wires.
  /// @param area left, bottom, width and height in the window, in pixels
  /// @param pixel size of a pixel in the unit of length
  void finish(const std::array<int, 4>& area, double pixel, const FigureStyle& style);

private:
  struct WireSet
  {
    PolyData edges;
    Vector color;
    double lift; ///< toward the eye, in widths of a wire
  };

  vtkActor* addActor(const PolyData& data, bool interpolated);
  void addEdges(
    const PolyData& lines, const std::vector<vtkIdType>& cells, const Vector& color, double lift);
  void drawWires(const WireSet& set, double radius);
  /// Range of all points along the camera's right, up and backward directions.
  std::array<double, 6> extent() const;

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkTextActor> Title;
  std::vector<PolyData> Shown;
  std::vector<WireSet> Wires;
  bool InSpace = false;
  Vector Right{ 1.0, 0.0, 0.0 };
  Vector Up{ 0.0, 1.0, 0.0 };
  Vector Back{ 0.0, 0.0, 1.0 };
};

constexpr Vector boundaryColor{ 0.0, 0.0, 0.0 };
constexpr Vector accessoryColor{ 0.0, 0.6, 0.1 };
constexpr Vector keyColor{ 0.85, 0.0, 0.0 };
constexpr Vector dartColor{ 0.0, 0.2, 0.9 };
constexpr Vector seamColor{ 0.6, 0.0, 0.75 };

/// Wires of one color.
struct WireGroup
{
  Vector color;
  std::vector<vtkIdType> cells;
};

/// Accessory and key curves, darts, seams and the boundary, those drawn over others last.
std::array<WireGroup, 5> groupWires(vtkPolyData* wires, DartSides sides);

/// The axis y or z along which a surface is larger.
Vector upOf(const PolyData& surface);

/// The direction from which most of a surface is seen: its mean normal, or obliquely from above
/// where that is nearly upright or the surface, as a box or a bottle, faces all sides.
Vector facing(const PolyData& surface, const Vector& up = { 0.0, 1.0, 0.0 });

/// The edges with one triangle, as lines.
PolyData boundaryOf(const PolyData& surface);

/// Blue to red, as in the figures of the paper.
vtkSmartPointer<vtkLookupTable> makeColors(ColorRange range);

/// One color after the other for a count of numbers from 0 on, again from the first on.
vtkSmartPointer<vtkLookupTable> makeCategories(const std::vector<Vector>& colors, int count);

/// Shows an array of a surface, of its points or of its cells.
void colorBy(vtkMapper* mapper, const char* array, bool onPoints, vtkLookupTable* colors);

/// A horizontal bar of colors with numbers below it.
/// @param labels how many numbers; textSize in pixels
vtkSmartPointer<vtkScalarBarActor> makeScaleBar(vtkLookupTable* colors, int labels, int textSize);
}
