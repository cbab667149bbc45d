// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveRepresentation
 * @brief what vtkFeatureCurveWidget draws: feature curves, nodes, what is chosen and what comes next
 *
 * Lines have the colors of their types, as in the figures. Nodes, the chosen curve and node, the
 * segment that would come next, and the place that a click would take with a word beside it lie
 * over them. BuildRepresentation() draws the curves of the editor as they are.
 *
 * @code
 * vtkNew<vtkFeatureCurveEditor> editor;
 * editor->SetSurface(surface);
 * vtkNew<vtkFeatureCurveRepresentation> drawn;
 * drawn->SetEditor(editor);
 * drawn->BuildRepresentation();
 * vtkNew<vtkRenderer> renderer; // that shows the surface
 * renderer->AddViewProp(drawn);
 * @endcode
 *
 * @warning Without a widget it is not told of changes: call BuildRepresentation() after them.
 *
 * @sa vtkFeatureCurveWidget vtkFeatureCurveEditor
 */
#ifndef vtkFeatureCurveRepresentation_h
#define vtkFeatureCurveRepresentation_h

#include "vtkInteractionFlatteningModule.h" // for the export macro
#include "vtkWidgetRepresentation.h"

#include <memory> // for the actors
#include <string> // for the label

class vtkFeatureCurveEditor;
class vtkPoints;
class vtkPolyData;

class VTKINTERACTIONFLATTENING_EXPORT vtkFeatureCurveRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkFeatureCurveRepresentation* New();
  vtkTypeMacro(vtkFeatureCurveRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curves. The editor has to live as long as it is drawn.
   */
  void SetEditor(vtkFeatureCurveEditor* editor);

  ///@{
  /**
   * The chosen curve and node; -1: none. Default: none.
   */
  void SetChosen(int curve, int node);
  vtkGetMacro(ChosenCurve, int);
  vtkGetMacro(ChosenNode, int);
  ///@}

  /**
   * "accessory", "key", "dart" or "seam", of a vtkFeatureCurveAlgorithm::CurveTypes.
   */
  static const char* GetTypeName(int type);
  /**
   * Sets red, green and blue of a type, from 0 to 255.
   */
  static void GetTypeColor(int type, unsigned char color[3]);

  ///@{
  /**
   * The segment that would come next, as lines to be filled; a stroke in its place; the place that
   * a click would take, larger where it snapped; a label beside a pixel of the window. HideMarker()
   * takes all of them away.
   */
  vtkPolyData* GetPreview();
  void DrawStroke(vtkPoints* points);
  void DrawMarker(const double point[3], bool snapped);
  void DrawLabel(const std::string& text, int x, int y);
  void HideMarker();
  ///@}

  ///@{
  /**
   * What VTK asks of a representation and a prop.
   */
  void BuildRepresentation() override;
  vtkMTimeType GetRedrawMTime() override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetActors(vtkPropCollection* actors) override;
  void GetActors2D(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  ///@}

protected:
  vtkFeatureCurveRepresentation();
  ~vtkFeatureCurveRepresentation() override;

private:
  vtkFeatureCurveRepresentation(const vtkFeatureCurveRepresentation&) = delete;
  void operator=(const vtkFeatureCurveRepresentation&) = delete;

  struct Parts;
  const std::unique_ptr<Parts> Drawn;
  vtkFeatureCurveEditor* Editor = nullptr;
  int ChosenCurve = -1;
  int ChosenNode = -1;
  double Bounds[6];
};

#endif
