// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Coloring.h"
#include "SteadyPieces.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>

namespace editor
{
/// The flat pieces with their wires.
class PlaneView
{
public:
  explicit PlaneView(vtkRenderer* renderer);

  /// Shows no pieces until those of another surface come, which a camera sees in space.
  void start(vtkPolyData* surface, vtkCamera* camera);
  /// The camera stays as the user has it, but for the first pieces, after reset(), and where there
  /// are more pieces or fewer than before.
  void show(const figures::FlatPiece& piece, figures::Coloring coloring);
  void reset() { this->CameraSet = false; }
  /// Pale, as what they are made of has changed.
  void dim(bool on);
  bool isDim() const { return this->Dim; }
  /// The pieces where they are shown; null: none are.
  const figures::FlatPiece& shown() const { return this->Shown; }

private:
  void resetCamera(vtkPolyData* flat);
  void showScale(const figures::ColorMap& map);

  vtkSmartPointer<vtkRenderer> Renderer;
  SteadyPieces Steady;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPolyDataMapper> WireMapper;
  vtkNew<vtkActor> Wires;
  vtkSmartPointer<vtkScalarBarActor> Scale;
  vtkNew<vtkTextActor> Title; ///< of the scale
  figures::FlatPiece Shown;
  bool CameraSet = false;
  bool Dim = false;
  vtkIdType PieceCount = 0;
};
}
