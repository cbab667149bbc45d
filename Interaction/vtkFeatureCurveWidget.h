// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveWidget
 * @brief draw feature curves on a surface by mouse and keys
 *
 * Changes the curves of a vtkFeatureCurveEditor, in any program with a vtkRenderWindowInteractor.
 * While the widget is enabled,
 *
 * - after NEW_CURVE clicks add nodes, and the next segment follows the mouse. A click on the first
 *   node closes the curve; FINISH, or a click with the right button, ends it. UNDO takes nodes
 *   back while it is drawn, and the whole curve once it is there;
 * - after FREEHAND a stroke with the button held becomes a smooth curve of few nodes within
 *   StrokeTolerance of it, closed where it ends where it started;
 * - after OFFSET a click adds the curve through that place which keeps its distance from the chosen
 *   one;
 * - a click on a curve or a node chooses it, and nodes can be dragged;
 * - a click with Control on a curve inserts a node, which can be dragged on;
 * - nodes snap to what vtkFeatureCurveEditor::SnapPoint() says, unless Alt is held.
 *
 * Whatever is not done on a curve goes on to the interactor's style, so that the camera is turned
 * by dragging beside curves, and by the other buttons.
 *
 * Everything else is an action with a name and a key. Programs show them in menus by the functions
 * below and call Do(); with HandleKeys the keys work by themselves.
 *
 * Events: SelectionChangedEvent; StartInteractionEvent, InteractionEvent and EndInteractionEvent
 * around each drag; CursorChangedEvent when GetHint() changed; WarningEvent, with the words as its
 * data, when what the mouse or a key asked for was refused: GetHint() says so too, until the mouse
 * moves. Changes of curves are those of the editor.
 *
 * @code
 * vtkNew<vtkFeatureCurveEditor> editor;
 * editor->SetSurface(surface);
 * vtkNew<vtkRenderWindowInteractor> interactor; // of the window that shows the surface
 * vtkNew<vtkFeatureCurveWidget> widget;
 * widget->SetInteractor(interactor);
 * widget->SetEditor(editor);
 * widget->SetSurface(surface);
 * widget->SetEnabled(1);
 * @endcode
 *
 * @warning Give the editor and the widget the same surface; a changed one has to be set again.
 *
 * @sa vtkFeatureCurveEditor vtkFeatureCurveRepresentation
 */
#ifndef vtkFeatureCurveWidget_h
#define vtkFeatureCurveWidget_h

#include "vtkAbstractWidget.h"
#include "vtkFeatureCurveEditor.h"          // for the editor
#include "vtkInteractionFlatteningModule.h" // for the export macro
#include "vtkNew.h"                         // for the stroke
#include "vtkRenderer.h"                    // for the renderer
#include "vtkSmartPointer.h"                // for the editor

#include <array>  // for pixels
#include <memory> // for the picker
#include <string> // for words

class vtkFeatureCurveRepresentation;
class vtkPoints;
class vtkPolyData;

namespace flattening
{
namespace interaction
{
class SurfacePicker;
}
}

class VTKINTERACTIONFLATTENING_EXPORT vtkFeatureCurveWidget : public vtkAbstractWidget
{
public:
  static vtkFeatureCurveWidget* New();
  vtkTypeMacro(vtkFeatureCurveWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What is drawn of the curves. Default: a vtkFeatureCurveRepresentation with its own defaults.
   */
  void SetRepresentation(vtkFeatureCurveRepresentation* representation);
  void CreateDefaultRepresentation() override;

  /**
   * The curves, and the surface that they are drawn on, which the editor has as well. The renderer
   * is that of the surface: the one under the mouse where it is not set (SetDefaultRenderer()).
   */
  void SetEditor(vtkFeatureCurveEditor* editor);
  vtkFeatureCurveEditor* GetEditor() { return this->Editor; }
  void SetSurface(vtkPolyData* surface);

  ///@{
  /**
   * The renderer that curves are drawn by, where it is not that of the surface: over the same
   * camera in a layer above, so that the surface need not be drawn again (vtkStillRenderer).
   * Default: none. Set before the widget is enabled.
   */
  void SetCurveRenderer(vtkRenderer* renderer) { this->CurveRenderer = renderer; }
  vtkRenderer* GetCurveRenderer() { return this->CurveRenderer; }
  ///@}

  void SetEnabled(int enabled) override;

  /**
   * What can be done apart from clicks.
   */
  enum Actions
  {
    NEW_CURVE = 0,
    FREEHAND,
    FINISH,
    REMOVE_NODE,
    REMOVE_CURVE,
    CLOSE,
    TIGHTEN,
    SPLIT,
    JOIN,
    OFFSET,
    MIRROR,
    MAKE_ACCESSORY,
    MAKE_KEY,
    MAKE_DART,
    MAKE_SEAM,
    STRAIGHT_KEY,
    GEODESIC,
    SECTION,
    EDGES,
    SPLINE,
    GIRTH,
    SNAP,
    UNDO,
    REDO,
    NUMBER_OF_ACTIONS
  };

  ///@{
  /**
   * The words of an action, and its key as VTK names it, with "Control-" before it where that is
   * held.
   */
  static const char* GetActionName(int action);
  static const char* GetActionKey(int action);
  ///@}

  ///@{
  /**
   * Whether an action makes sense now, whether it is a switch that is on, and do it: false where
   * it does not or is refused, with GetHint() saying why.
   */
  bool CanDo(int action) const;
  bool IsOn(int action) const;
  bool Do(int action);
  ///@}

  ///@{
  /**
   * Let the keys of actions work. Default: on.
   */
  vtkSetMacro(HandleKeys, bool);
  vtkGetMacro(HandleKeys, bool);
  vtkBooleanMacro(HandleKeys, bool);
  ///@}

  ///@{
  /**
   * How near a click has to be to what it means, in pixels. Default: 8.
   */
  vtkSetClampMacro(Reach, int, 1, 100);
  vtkGetMacro(Reach, int);
  ///@}

  ///@{
  /**
   * How far a curve may be from the stroke that it is made of, in pixels. Default: 3.
   */
  vtkSetClampMacro(StrokeTolerance, double, 0.1, 100.0);
  vtkGetMacro(StrokeTolerance, double);
  ///@}

  ///@{
  /**
   * The unit of the surface's lengths, which stands behind each length that is shown. Default: "",
   * none is shown.
   */
  void SetLengthUnit(const std::string& unit);
  const char* GetLengthUnit() const { return this->LengthUnit.c_str(); }
  ///@}

  ///@{
  /**
   * The chosen curve and node, -1 where there is none, and whether a curve is being drawn. To
   * choose another one ends the one that is drawn.
   */
  int GetChosenCurve() const { return this->Chosen.curve; }
  int GetChosenNode() const { return this->Chosen.node; }
  void Choose(int curve, int node);
  bool IsDrawing() const { return this->State == Mode::Drawing; }
  ///@}

  /**
   * What a click would do now, or why the last action was refused: a line for the user.
   */
  const char* GetHint() const { return this->Hint.c_str(); }

  /**
   * Draws the curves as they are.
   */
  void Redraw();

protected:
  vtkFeatureCurveWidget();
  ~vtkFeatureCurveWidget() override;

private:
  vtkFeatureCurveWidget(const vtkFeatureCurveWidget&) = delete;
  void operator=(const vtkFeatureCurveWidget&) = delete;

  enum class Mode
  {
    Choosing,
    Drawing,
    Dragging,
    Joining,    ///< the next curve that is clicked is joined to the chosen one
    Offsetting, ///< the next place that is clicked gets a curve as far from the chosen one
    Sketching,  ///< the next press begins a stroke
    Stroking,
  };
  /// Curve and node; -1: none.
  struct Choice
  {
    int curve = -1;
    int node = -1;
    bool operator==(const Choice& other) const
    {
      return this->curve == other.curve && this->node == other.node;
    }
  };
  struct Aim; ///< what is under the mouse

  /// Lets a method answer an event of the interactor.
  template <void (vtkFeatureCurveWidget::*Method)()>
  static void Answer(vtkAbstractWidget* widget);
  void OnPress();
  void OnRelease();
  void OnMove();
  void OnRightPress();
  void OnDoubleClick();
  void OnKeyPress();
  void OnChar();
  /// The action of the key that is pressed, or none.
  int ActionOfKey() const;
  /// A click, a press that did not move the mouse.
  void OnClick();
  bool StartDrag();
  void EndDrag();
  void StartStroke();
  void FinishStroke();
  /// It begins a drag of the style, which turns the camera.
  void HandPressOn();

  Aim AimAt(int exceptCurve) const;
  bool HasMoved() const;
  /// Whether the next click or press is for a place on the surface.
  bool IsPlacing() const
  {
    return this->State == Mode::Drawing || this->State == Mode::Sketching ||
      this->State == Mode::Offsetting;
  }
  bool AddNode(const Aim& aim);
  bool StepBack();
  bool SetKind(int kind);
  /// Of the chosen curve.
  bool SetKindOfSegments(int kind);
  bool ToggleMirror();
  bool MakeGirth();
  bool EndDrawing();
  void UndoOrRedo(int action);
  void Select(int curve, int node);
  bool Finished(bool done);
  /// False.
  bool Refuse(const std::string& words);
  void FollowEditor();
  void SetHint(const std::string& hint);
  void UpdateHint(const Aim& aim);
  void RenderIfEnabled();

  vtkSmartPointer<vtkFeatureCurveEditor> Editor;
  unsigned long EditorTag = 0;
  vtkFeatureCurveRepresentation* Drawn();

  vtkSmartPointer<vtkRenderer> CurveRenderer;
  const std::unique_ptr<flattening::interaction::SurfacePicker> Picker;
  Choice Chosen;
  Mode State = Mode::Choosing;
  bool PressedHere = false;
  bool Missed = false; ///< the last click was on the bare surface
  int DrawnSince = 0;  ///< commands of the editor before the curve that is drawn
  std::array<int, 2> Pressed{};
  bool HandleKeys = true;
  bool Snapping = true;
  int Kind = 0; ///< of new segments
  int Reach = 8;
  double StrokeTolerance = 3.0;
  vtkNew<vtkPoints> Stroke;
  double StrokePixel = 0.0; ///< length of a pixel where the stroke began
  std::string LengthUnit;
  std::string Hint;
};

#endif
