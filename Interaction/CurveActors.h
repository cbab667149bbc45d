// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>

class vtkFeatureCurveEditor;

namespace interaction
{
/// Curve and node; -1: none.
struct CurveChoice
{
  int curve = -1;
  int node = -1;
  bool operator==(const CurveChoice& other) const
  {
    return this->curve == other.curve && this->node == other.node;
  }
};

/// "accessory", "key", "dart" or "seam".
const char* nameOfType(int type);

/// Red, green and blue of a type of curves, from 0 to 255: as in the figures.
std::array<unsigned char, 3> colorOfType(int type);

/// What is drawn of an editor's curves: lines in the colours of their types, nodes, what is chosen,
/// the segment that would come next, and the place that a click would take with a word beside it.
class CurveActors
{
public:
  CurveActors();

  void show(vtkRenderer* renderer);
  void hide(vtkRenderer* renderer);

  void drawCurves(const vtkFeatureCurveEditor& editor, const CurveChoice& chosen) const;
  vtkPolyData* preview() { return this->Preview.data; }
  /// In the place of the next segment.
  void drawStroke(vtkPoints* points) const;
  void drawMarker(const std::array<double, 3>& point, bool snapped) const;
  void drawLabel(const std::string& text, const std::array<int, 2>& pixel);
  void hideMarker();

private:
  struct Layer
  {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void makeLayer(Layer& layer, double size, double units);
  int labelWidth();

  Layer Lines;
  Layer ChosenLine;
  Layer Nodes;
  Layer ChosenNode;
  Layer Preview;
  Layer Marker;
  vtkNew<vtkTextActor> Label;
  vtkSmartPointer<vtkRenderer> Renderer; ///< that shows it all; null while hidden
};
}
