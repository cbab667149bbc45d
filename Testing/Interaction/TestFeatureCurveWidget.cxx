// SPDX-License-Identifier: BSD-3-Clause
// Mouse and keys as the window gets them, with the curves that must come of them.
#include "Drawing.h"
#include "Pieces.h"
#include <vtkFeatureCurveWidget.h>

#include <vtkActor2DCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCylinderSource.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkFeatureCurveRepresentation.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextActor.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Pixel = std::array<int, 2>;

class FeatureCurveWidget : public testing::TestWithParam<double>
{
protected:
  void SetUp() override { this->open(1.0); }

  void open(double scale)
  {
    vtkNew<vtkTransform> transform;
    transform->Scale(scale, scale, scale);
    vtkNew<vtkTransformPolyDataFilter> scaled;
    scaled->SetTransform(transform);
    scaled->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    scaled->SetInputData(figures::readPiece(FLATTENING_DATA, "shirt_front").surface);
    scaled->Update();
    this->surface = scaled->GetOutput();
    this->window = vtkSmartPointer<vtkRenderWindow>::New();
    this->window->SetOffScreenRendering(1);
    this->window->SetSize(900, 900);
    figures::Drawing drawing;
    this->renderer = drawing.renderer();
    this->window->AddRenderer(this->renderer);
    drawing.lookFrom(figures::facing(this->surface));
    drawing.addSurface(this->surface);
    const std::array<double, 2> size = drawing.size();
    drawing.finish({ 0, 0, 900, 900 }, std::max(size[0], size[1]) / 860.0, {});
    this->interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
    this->interactor->SetRenderWindow(this->window);
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    this->interactor->SetInteractorStyle(style);
    this->editor = vtkSmartPointer<vtkFeatureCurveEditor>::New();
    ASSERT_TRUE(this->editor->SetSurface(this->surface));
    this->widget = vtkSmartPointer<vtkFeatureCurveWidget>::New();
    this->widget->SetInteractor(this->interactor);
    this->widget->SetDefaultRenderer(this->renderer);
    this->widget->SetEditor(this->editor);
    this->widget->SetSurface(this->surface);
    this->widget->SetEnabled(1);
    this->interactor->Initialize();
    this->window->Render();
  }

  Pixel pixelOf(const double point[3]) const
  {
    this->renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
    this->renderer->WorldToDisplay();
    const double* const display = this->renderer->GetDisplayPoint();
    return { static_cast<int>(std::lround(display[0])), static_cast<int>(std::lround(display[1])) };
  }
  Pixel vertex(vtkIdType id) const { return this->pixelOf(this->surface->GetPoint(id)); }
  Pixel node(int curve, int id) const
  {
    double point[3];
    this->editor->GetNode(curve, id, point);
    return this->pixelOf(point);
  }

  void moveTo(const Pixel& pixel, bool alt = false, bool control = false)
  {
    this->interactor->SetEventInformation(pixel[0], pixel[1], control ? 1 : 0, 0);
    this->interactor->SetAltKey(alt ? 1 : 0);
    this->interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }
  void click(const Pixel& pixel, bool alt = false, bool control = false)
  {
    this->moveTo(pixel, alt, control);
    this->interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    this->interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
    this->interactor->SetAltKey(0);
  }
  void drag(const Pixel& from, const Pixel& to, bool control = false)
  {
    this->moveTo(from, false, control);
    this->interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    for (int k = 1; k <= 10; ++k)
    {
      this->moveTo({ from[0] + (to[0] - from[0]) * k / 10, from[1] + (to[1] - from[1]) * k / 10 });
    }
    this->interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  }
  void press(const char* key, bool control = false)
  {
    this->interactor->SetKeyEventInformation(control ? 1 : 0, 0, key[0], 0, key);
    this->interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->interactor->InvokeEvent(vtkCommand::CharEvent);
    this->interactor->SetControlKey(0);
  }
  void draw(const std::vector<Pixel>& pixels)
  {
    this->press("n");
    for (const Pixel& pixel : pixels)
    {
      this->click(pixel);
    }
    this->press("Return");
  }
  /// Keeps what the widget says last.
  void listen(std::string& said)
  {
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(&said);
    listener->SetCallback([](vtkObject*, unsigned long, void* client, void* words) {
      *static_cast<std::string*>(client) = static_cast<const char*>(words);
    });
    this->widget->AddObserver(vtkCommand::WarningEvent, listener);
  }

  /// What stands at the mouse.
  std::string label() const
  {
    vtkActor2DCollection* const props = this->renderer->GetActors2D();
    std::string words;
    for (int k = 0; k < props->GetNumberOfItems(); ++k)
    {
      auto* const text = vtkTextActor::SafeDownCast(props->GetItemAsObject(k));
      words += text && text->GetVisibility() && text->GetInput() ? text->GetInput() : "";
    }
    return words;
  }
  double distance(int curve, int id, const double point[3]) const
  {
    double place[3];
    this->editor->GetNode(curve, id, place);
    return std::sqrt(vtkMath::Distance2BetweenPoints(place, point));
  }

  vtkSmartPointer<vtkPolyData> surface;
  vtkSmartPointer<vtkRenderWindow> window;
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor;
  vtkSmartPointer<vtkFeatureCurveEditor> editor;
  vtkSmartPointer<vtkFeatureCurveWidget> widget;
};
}

//------------------------------------------------------------------------------
TEST_F(FeatureCurveWidget, AClickThroughAnOpeningDoesNotReachTheInsideOfABody)
{
  vtkNew<vtkCylinderSource> source; // about y, 2 high, of radius 1
  source->SetHeight(2.0);
  source->SetRadius(1.0);
  source->SetResolution(32);
  source->CappingOff();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->Update();
  this->surface = triangles->GetOutput();
  ASSERT_TRUE(this->editor->SetSurface(this->surface));
  this->widget->SetSurface(this->surface);
  vtkCamera* const camera = this->renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 3.0, 3.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  this->renderer->ResetCamera(this->surface->GetBounds());
  this->window->Render();
  const double inside[2][3] = { { -0.2, 0.5, -0.97 }, { 0.2, 0.5, -0.97 } };
  this->draw({ this->pixelOf(inside[0]), this->pixelOf(inside[1]) });
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
  const double outside[2][3] = { { -0.2, 0.0, 0.97 }, { 0.2, 0.0, 0.97 } };
  this->draw({ this->pixelOf(outside[0]), this->pixelOf(outside[1]) });
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 1);
}

TEST_F(FeatureCurveWidget, BesideACurveADragTurnsTheCameraAndOnANodeItMovesTheNode)
{
  this->draw({ this->vertex(401), this->vertex(6), this->vertex(12) });
  const double length = this->editor->GetCurveLength(0);
  const double x = this->renderer->GetActiveCamera()->GetPosition()[0];
  const Pixel place = this->node(0, 1);
  this->drag(place, { place[0] + 40, place[1] - 70 });
  EXPECT_EQ(this->renderer->GetActiveCamera()->GetPosition()[0], x);
  EXPECT_NE(this->editor->GetCurveLength(0), length);
  const Pixel moved = this->node(0, 1);
  EXPECT_NEAR(moved[0], place[0] + 40, 12); // up to the reach of what it snaps to
  EXPECT_NEAR(moved[1], place[1] - 70, 12);
  this->press("z", true);
  EXPECT_EQ(this->editor->GetCurveLength(0), length);
  EXPECT_EQ(this->node(0, 1), place);

  this->drag({ place[0] + 150, place[1] - 160 }, { place[0] + 190, place[1] - 160 });
  EXPECT_NE(this->renderer->GetActiveCamera()->GetPosition()[0], x);
  EXPECT_EQ(this->editor->GetCurveLength(0), length);
}

TEST_F(FeatureCurveWidget, AKeyInTheMiddleOfADragEndsItAndWhatFollowsIsUndoneByItself)
{
  this->draw({ this->vertex(401), this->vertex(6) });
  const double x = this->renderer->GetActiveCamera()->GetPosition()[0];
  const Pixel place = this->node(0, 1);
  this->moveTo(place);
  this->interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  this->moveTo({ place[0] + 20, place[1] + 30 });
  this->press("Delete");
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 0);
  this->moveTo({ place[0] + 40, place[1] + 60 }); // with the button still down
  this->interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
  EXPECT_EQ(this->renderer->GetActiveCamera()->GetPosition()[0], x);
  this->draw({ this->vertex(401), this->vertex(12) });
  this->draw({ this->vertex(6), this->vertex(12) });
  this->press("z", true);
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 1);
  this->press("z", true);
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
  this->press("z", true); // the removal
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 1);
  EXPECT_NE(this->node(0, 1), place);
  this->press("z", true); // the drag
  EXPECT_EQ(this->node(0, 1), place);
}

TEST_F(FeatureCurveWidget, TheBareSurfaceSaysHowACurveIsDrawn)
{
  const auto told = [this] { return this->label().find("press N") != std::string::npos; };
  const Pixel bare{ this->vertex(6)[0] + 60, this->vertex(6)[1] - 200 };
  this->moveTo(bare);
  EXPECT_TRUE(told()) << this->label();
  this->moveTo({ 2, 2 }); // beside the surface
  EXPECT_FALSE(told());
  this->press("n");
  this->moveTo(bare);
  EXPECT_FALSE(told());
  this->click(this->vertex(401));
  this->click(this->vertex(6));
  this->press("Return");
  // Who has drawn one knows it, until a click on nothing asks again.
  this->moveTo(bare);
  EXPECT_FALSE(told());
  this->click(bare);
  this->moveTo({ bare[0] + 5, bare[1] });
  EXPECT_TRUE(told()) << this->label();
  this->click(this->node(0, 1));
  EXPECT_FALSE(told());
  this->moveTo(bare);
  EXPECT_FALSE(told());
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 1);
}

TEST_F(FeatureCurveWidget, AltTakesThePlaceAsItIs)
{
  Pixel place = this->vertex(6);
  place[0] += 5;
  this->press("n");
  this->click(place);
  EXPECT_EQ(this->distance(0, 0, this->surface->GetPoint(6)), 0.0);
  this->press("z", true);
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 0);
  this->click(place, true);
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 1);
  EXPECT_GT(this->distance(0, 0, this->surface->GetPoint(6)), 0.0);
  EXPECT_EQ(this->node(0, 0), place);
}

TEST_F(FeatureCurveWidget, AClickOnTheFirstNodeCloses)
{
  const Pixel middle = this->vertex(6);
  const std::vector<Pixel> corners{ { middle[0] - 80, middle[1] - 90 },
    { middle[0] + 70, middle[1] - 60 }, { middle[0] + 20, middle[1] + 80 } };
  this->press("n");
  for (const Pixel& corner : corners)
  {
    this->click(corner);
  }
  this->click(this->node(0, 0));
  EXPECT_FALSE(this->widget->IsDrawing());
  EXPECT_TRUE(this->editor->GetCurveClosed(0));
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 3);
  this->press("c");
  EXPECT_FALSE(this->editor->GetCurveClosed(0));
}

TEST_F(FeatureCurveWidget, ControlAndAClickInsertANode)
{
  this->draw({ this->vertex(401), this->vertex(12) });
  const Pixel a = this->node(0, 0);
  const Pixel b = this->node(0, 1);
  // Somewhere on the line, which is not straight on the screen.
  vtkNew<vtkPolyData> line;
  this->editor->GetCurve(0, line);
  const Pixel on = this->pixelOf(line->GetPoint(line->GetNumberOfPoints() / 2));
  const double length = this->editor->GetCurveLength(0);
  this->click(on, true, true);
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 3);
  EXPECT_NEAR(this->editor->GetCurveLength(0), length, 1e-3 * length);
  this->interactor->SetControlKey(0);
  this->drag(this->node(0, 1), { on[0], on[1] - 60 });
  EXPECT_GT(this->editor->GetCurveLength(0), 1.01 * length);
  EXPECT_EQ(this->node(0, 0), a);
  EXPECT_EQ(this->node(0, 2), b);
  this->click(this->node(0, 1));
  EXPECT_EQ(this->widget->GetChosenNode(), 1);
  this->press("BackSpace");
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 2);
}

TEST_F(FeatureCurveWidget, ChosenCurvesGetTypesSplitJoinAndGo)
{
  this->draw({ this->vertex(401), this->vertex(6), this->vertex(12) });
  this->draw({ this->vertex(402), this->vertex(7), this->vertex(13) });
  EXPECT_EQ(this->widget->GetChosenCurve(), 1);
  this->click({ 3, 3 });
  EXPECT_EQ(this->widget->GetChosenCurve(), -1);
  EXPECT_FALSE(this->widget->CanDo(vtkFeatureCurveWidget::MAKE_KEY));
  this->click(this->node(0, 1));
  ASSERT_EQ(this->widget->GetChosenCurve(), 0);
  this->press("k");
  EXPECT_EQ(this->editor->GetCurveType(0), 1);
  this->press("t");
  EXPECT_EQ(this->editor->GetCurveKeyShape(0), 1);
  const double length = this->editor->GetCurveLength(0);
  this->press("x");
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 3);
  EXPECT_LT(this->editor->GetCurveLength(0), length);
  this->press("j");
  this->click(this->node(2, 1));
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 2);
  EXPECT_NEAR(this->editor->GetCurveLength(0), length, 1e-9 * length);
  this->press("Delete");
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 1);
  while (this->widget->CanDo(vtkFeatureCurveWidget::UNDO))
  {
    this->press("z", true);
  }
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
}

TEST_F(FeatureCurveWidget, ACurveOfOneNodeIsNotKeptAndThatIsSaid)
{
  std::string said;
  this->listen(said);
  this->draw({ this->vertex(401), this->vertex(6) });
  EXPECT_EQ(said, "");
  this->draw({ this->vertex(12) });
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 1);
  EXPECT_NE(said.find("one node"), std::string::npos) << said;
  EXPECT_EQ(said, this->widget->GetHint());
}

TEST_F(FeatureCurveWidget, UndoTakesNodesBackWhileACurveIsDrawnAndTheWholeCurveOnceItIsThere)
{
  this->draw({ this->vertex(401), this->vertex(6) });
  this->press("n");
  for (const vtkIdType id : { 401, 68, 12 })
  {
    this->click(this->vertex(id));
  }
  this->press("z", true);
  ASSERT_EQ(this->editor->GetNumberOfNodes(1), 2);
  EXPECT_TRUE(this->widget->IsDrawing());
  this->click(this->vertex(12));
  this->press("k"); // while it is drawn
  this->press("Return");
  ASSERT_EQ(this->editor->GetNumberOfNodes(1), 3);
  const double length = this->editor->GetCurveLength(1);
  this->press("z", true);
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 1);
  EXPECT_FALSE(this->widget->IsDrawing());
  this->press("y", true);
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 2);
  EXPECT_EQ(this->editor->GetCurveLength(1), length);
  EXPECT_EQ(this->editor->GetCurveType(1), 1);
  EXPECT_FALSE(this->widget->CanDo(vtkFeatureCurveWidget::REDO));
  this->press("z", true);
  this->press("z", true);
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
  EXPECT_FALSE(this->widget->CanDo(vtkFeatureCurveWidget::UNDO));
}

TEST_F(FeatureCurveWidget, HoweverDrawingEndsTheCurveIsUndoneAsAWhole)
{
  const auto begin = [this] {
    this->press("n");
    this->click(this->vertex(401));
    this->click(this->vertex(68));
    this->click(this->vertex(12));
  };
  const auto expectOne = [this](const char* how) {
    EXPECT_FALSE(
      this->widget->IsOn(vtkFeatureCurveWidget::NEW_CURVE) && this->widget->GetChosenCurve() >= 0)
      << how;
    this->press("Return");
    this->press("z", true);
    EXPECT_EQ(this->editor->GetNumberOfCurves(), 0) << how;
    EXPECT_FALSE(this->widget->CanDo(vtkFeatureCurveWidget::UNDO)) << how;
  };
  begin();
  this->press("n"); // the next curve
  expectOne("n");
  begin();
  this->press("f");
  expectOne("f");
  begin();
  this->press("c");
  EXPECT_TRUE(this->editor->GetCurveClosed(0));
  expectOne("c");
  begin();
  this->widget->Choose(-1, -1); // from a list beside
  expectOne("choose");
  // What was removed in the middle comes back whole.
  begin();
  this->press("Delete");
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
  this->press("z", true);
  ASSERT_EQ(this->editor->GetNumberOfCurves(), 1);
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 3);
  expectOne("Delete");
  // A girth is two steps: what was drawn, and how it runs.
  begin();
  this->press("o");
  ASSERT_TRUE(this->editor->GetCurveClosed(0)) << this->widget->GetHint();
  this->press("z", true);
  EXPECT_FALSE(this->editor->GetCurveClosed(0));
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 3);
  expectOne("o");
}

TEST_F(FeatureCurveWidget, ACurveOfOneNodeIsNoStepOfUndoAndRedoneItIsDrawnOn)
{
  this->draw({ this->vertex(12) });
  EXPECT_FALSE(this->widget->CanDo(vtkFeatureCurveWidget::UNDO));
  this->press("n");
  this->click(this->vertex(401));
  this->press("z", true);
  this->press("Return");
  EXPECT_FALSE(this->widget->IsDrawing());
  this->press("y", true);
  ASSERT_EQ(this->editor->GetNumberOfNodes(0), 1);
  EXPECT_TRUE(this->widget->IsDrawing());
  EXPECT_EQ(std::string(this->widget->GetHint()).find("length 0"), std::string::npos)
    << this->widget->GetHint();
  this->click(this->vertex(6));
  this->press("Return");
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 2);
  this->press("z", true);
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
}

TEST_F(FeatureCurveWidget, WhatIsChosenElsewhereIsNotDrawnOn)
{
  this->draw({ this->vertex(401), this->vertex(6) });
  this->press("n");
  this->click(this->vertex(12));
  this->click(this->vertex(68));
  this->widget->Choose(0, -1);
  EXPECT_FALSE(this->widget->IsDrawing());
  this->click(this->vertex(7));
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 2);
  EXPECT_EQ(this->editor->GetNumberOfNodes(1), 2);
}

TEST_F(FeatureCurveWidget, AClickThatMeetsNothingIsSaid)
{
  std::string said;
  this->listen(said);
  const Pixel beside{ 4, 4 };
  const auto expectSaid = [&](const char* words) {
    said.clear();
    this->click(beside);
    EXPECT_NE(said.find(words), std::string::npos) << words << ": " << said;
    EXPECT_EQ(said, this->widget->GetHint());
  };
  this->click(beside);
  EXPECT_EQ(said, ""); // nothing was asked for
  this->press("n");
  expectSaid("no surface");
  this->click(this->vertex(401));
  expectSaid("no surface");
  EXPECT_EQ(this->editor->GetNumberOfNodes(0), 1);
  this->click(this->vertex(6));
  this->press("Return");
  this->press("l");
  expectSaid("no surface");
  this->press("Return");
  this->press("f");
  expectSaid("no surface");
  this->press("Return");
  this->draw({ this->vertex(12), this->vertex(68) });
  this->press("j");
  expectSaid("nothing is joined");
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 2);
}

TEST_F(FeatureCurveWidget, AMirroredCurveLiesOnBothHalvesAndWhatIsNotSymmetricIsSaid)
{
  std::string said;
  this->listen(said);
  // The left side of the bust, off the middle plane x = 0.
  this->draw({ this->vertex(401), this->vertex(6) });
  this->press("m");
  ASSERT_TRUE(this->editor->GetCurveMirrored(0)) << this->widget->GetHint();
  EXPECT_EQ(said, ""); // a shirt front is symmetric
  vtkNew<vtkPolyData> both;
  this->editor->GetCurves(both);
  ASSERT_EQ(both->GetNumberOfCells(), 2);
  double bounds[6];
  both->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], -bounds[1], 1e-6 * bounds[1]);
  // A third of its length to one side: x += y / 3.
  for (vtkIdType k = 0; k < this->surface->GetNumberOfPoints(); ++k)
  {
    double point[3];
    this->surface->GetPoint(k, point);
    this->surface->GetPoints()->SetPoint(k, point[0] + point[1] / 3.0, point[1], point[2]);
  }
  this->surface->GetPoints()->Modified();
  this->surface->Modified();
  ASSERT_TRUE(this->editor->SetSurface(this->surface));
  this->widget->SetSurface(this->surface);
  vtkNew<vtkPoints> nodes;
  nodes->SetDataTypeToDouble();
  nodes->InsertNextPoint(this->surface->GetPoint(401));
  nodes->InsertNextPoint(this->surface->GetPoint(6));
  ASSERT_TRUE(this->editor->AddCurve(nodes));
  this->widget->Choose(0, -1);
  this->press("m");
  ASSERT_TRUE(this->editor->GetCurveMirrored(0)) << this->widget->GetHint();
  EXPECT_NE(said.find("not symmetric"), std::string::npos) << said;
}

TEST_F(FeatureCurveWidget, KeysChooseHowACurveRuns)
{
  this->draw({ this->vertex(401), this->vertex(68), this->vertex(12) });
  const double straight = this->editor->GetCurveLength(0);
  for (const char* key : { "p", "e", "b" })
  {
    this->press(key);
    EXPECT_GT(this->editor->GetCurveLength(0), straight) << key; // than which nothing is shorter
  }
  EXPECT_TRUE(this->widget->IsOn(vtkFeatureCurveWidget::SPLINE));
  this->press("g");
  EXPECT_EQ(this->editor->GetCurveLength(0), straight);
  while (this->widget->CanDo(vtkFeatureCurveWidget::UNDO))
  {
    this->press("z", true);
  }
  EXPECT_EQ(this->editor->GetNumberOfCurves(), 0);
}

TEST_F(FeatureCurveWidget, WhatItDrawsIsAPropOfItsRendererWhileItIsEnabled)
{
  std::array<int, 2> counts{}; // enabled, disabled
  for (std::size_t k = 0; k < 2; ++k)
  {
    vtkNew<vtkCallbackCommand> count;
    count->SetCallback(
      [](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
    count->SetClientData(&counts[k]);
    this->widget->AddObserver(k == 0 ? vtkCommand::EnableEvent : vtkCommand::DisableEvent, count);
  }
  vtkNew<vtkFeatureCurveRepresentation> own;
  vtkNew<vtkRenderer> above;
  this->window->AddRenderer(above);
  for (vtkRenderer* layer : { static_cast<vtkRenderer*>(nullptr), above.Get() })
  {
    this->widget->SetEnabled(0);
    this->widget->SetCurveRenderer(layer);
    this->widget->SetRepresentation(own);
    EXPECT_FALSE(this->renderer->HasViewProp(own));
    this->widget->SetEnabled(1);
    EXPECT_EQ(this->renderer->HasViewProp(own) != 0, layer == nullptr);
    EXPECT_EQ(above->HasViewProp(own) != 0, layer != nullptr);
  }
  this->widget->SetEnabled(0);
  EXPECT_FALSE(above->HasViewProp(own));
  EXPECT_EQ(counts, (std::array<int, 2>{ 2, 3 }));

  EXPECT_EQ(own->GetBounds(), nullptr);
  vtkNew<vtkPoints> ends;
  ends->InsertNextPoint(this->surface->GetPoint(0));
  ends->InsertNextPoint(this->surface->GetPoint(this->surface->GetNumberOfPoints() / 2));
  ASSERT_TRUE(this->editor->AddCurve(ends));
  const double* const bounds = own->GetBounds();
  ASSERT_NE(bounds, nullptr);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GE(bounds[2 * axis], this->surface->GetBounds()[2 * axis] - 1e-9);
    EXPECT_LE(bounds[2 * axis + 1], this->surface->GetBounds()[2 * axis + 1] + 1e-9);
  }
}

TEST_P(FeatureCurveWidget, EveryUnitOfLengthBehavesAlike)
{
  const double scale = this->GetParam();
  const auto session = [this] {
    Pixel off = this->vertex(6);
    off[1] += 30;
    this->draw({ this->vertex(401), off, this->vertex(12) });
    this->drag(this->node(0, 1), this->vertex(68));
    this->press("g");
    return this->editor->GetCurveLength(0);
  };
  const double length = session();
  this->open(scale);
  EXPECT_NEAR(session() / scale, length, 1e-6 * length);
}
INSTANTIATE_TEST_SUITE_P(Scales, FeatureCurveWidget, testing::Values(1e-3, 1e3));
