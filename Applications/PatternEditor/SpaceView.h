// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Coloring.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

namespace editor
{
/// The surface to draw on, in the colors of the measures.
class SpaceView
{
public:
  explicit SpaceView(vtkRenderer* renderer);

  /// Looks at it from where most of it is seen.
  void setSurface(const figures::PolyData& surface);
  void color(const figures::FlatPiece& piece, figures::Coloring coloring);
  void setEdges(bool shown);
  /// Lines that are no curves yet, one of them stronger; none from their number on.
  void showGhosts(const figures::PolyData& lines, std::size_t chosen);
  void resetCamera();
  /// Shows the whole surface from a direction.
  void lookFrom(const figures::Vector& back);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  figures::PolyData Surface;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPolyDataMapper> EdgeMapper;
  vtkNew<vtkActor> Boundary;
  vtkNew<vtkPolyDataMapper> GhostMapper;
  vtkNew<vtkActor> Ghosts;
};
}
