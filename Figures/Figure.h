// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing.h"

#include <vtkRenderWindow.h>

#include <list>
#include <string>

namespace figures
{
/// Rows of drawings on white ground, all in one scale, so that sizes compare.
class Figure
{
public:
  /// @param width, maximumHeight size in pixels; the height is what the rows need
  /// @param samples samples a pixel; without, pictures compare best
  Figure(int width, int maximumHeight, int samples = 0);

  /// A drawing at the end of the row.
  Drawing& add();
  void nextRow();
  /// A scale of colors below all rows, as many as there is room for beside each other.
  void addScale(const std::string& title, ColorRange range);

  /// Draws everything.
  vtkRenderWindow* render();
  /// Draws everything into a PNG file, without showing it. Throws std::runtime_error.
  void write(const std::string& path);

  FigureStyle style;

private:
  using Row = std::list<Drawing>; // add() hands out references

  double neededPixel() const;
  int rowHeight(const Row& row, double pixel) const;
  void finishRow(Row& row, int bottom, int height, double pixel) const;

  struct Scale
  {
    std::string title;
    ColorRange range;
  };

  void drawScales(int windowHeight) const;

  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<Scale> Scales;
  std::list<Row> Rows;
  int Width;
  int MaximumHeight;
};
}
