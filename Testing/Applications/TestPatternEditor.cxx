// SPDX-License-Identifier: BSD-3-Clause
// Mouse and keys as Qt gets them from the X server, with the curves and flat pieces that must come
// of them.
#include "EditorSession.h"
#include "Sheet.h"

#include <vtkCallbackCommand.h>
#include <vtkFeatureEdges.h>
#include <vtkMath.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

#include <QInputDialog>
#include <QStyle>
#include <QToolBar>

#include <memory>

using namespace session;

TEST_F(PatternEditor, TheTutorialsCurvesDrawnByMouseSavedAndLoadedGiveItsReport)
{
  this->drawTutorial();
  this->waitForPieces();
  this->picture("drawn");
  editor::LiveFlattening expected;
  expected.setSurface(this->surface);
  ASSERT_TRUE(sheets::run(expected, tutorialLines(this->surface)));

  const std::string path = this->file("drawn_curves.vtp");
  ASSERT_TRUE(this->window->saveCurves(path));
  for (const bool loaded : { false, true })
  {
    if (loaded)
    {
      this->open();
      ASSERT_TRUE(this->window->openCurves(path)) << this->window->message().toStdString();
      this->waitForPieces();
    }
    ASSERT_EQ(this->window->curves()->GetNumberOfCurves(), 5);
    for (const char* name : { "AreaError", "AngleErrorMean", "GlobalHomogeneity", "StrainP95" })
    {
      const double value = expected.result().number(name);
      EXPECT_NEAR(this->measure(name), value, 1e-6 * value) << name;
    }
    vtkTable* const drawn = this->window->flattening().result().curves;
    vtkTable* const given = expected.result().curves;
    for (vtkIdType row = 0; row < 5; ++row)
    {
      const double length = given->GetValueByName(row, "FlatLength").ToDouble();
      EXPECT_NEAR(drawn->GetValueByName(row, "FlatLength").ToDouble(), length, 1e-9 * length);
      EXPECT_EQ(drawn->GetValueByName(row, "Name").ToString(),
        given->GetValueByName(row, "Name").ToString());
    }
  }
  // They are as editable as before.
  this->drag(this->node(1, 1), this->node(1, 1) + QPoint(0, 40));
  EXPECT_TRUE(this->window->curves()->CanUndo());
}

TEST_F(PatternEditor, NoKeyOfVTKsStylesEndsTheProgramOrDrawsOtherwise)
{
  vtkRenderWindowInteractor* const interactor = this->window->spaceWidget()->interactor();
  int ends = 0;
  const auto count = [](vtkObject*, unsigned long, void* client, void*) {
    ++*static_cast<int*>(client);
  };
  vtkNew<vtkCallbackCommand> exit;
  exit->SetCallback(count);
  exit->SetClientData(&ends);
  interactor->AddObserver(vtkCommand::ExitEvent, exit);
  for (const char* const key : { "q", "e", "w", "3" })
  {
    interactor->SetKeyEventInformation(0, 0, key[0], 0, key);
    interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    interactor->InvokeEvent(vtkCommand::CharEvent);
  }
  EXPECT_EQ(ends, 0);
  EXPECT_EQ(interactor->GetRenderWindow()->GetStereoRender(), 0);
  vtkActorCollection* const actors =
    interactor->GetRenderWindow()->GetRenderers()->GetFirstRenderer()->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* const actor = actors->GetNextActor(at))
  {
    EXPECT_EQ(actor->GetProperty()->GetRepresentation(), VTK_SURFACE);
  }
}

TEST_F(PatternEditor, ANewKeyDoesNotTurnThePieceOnTheScreen)
{
  // From the middle of the hem to that of the neck.
  const auto direction = [](vtkPolyData* flat) {
    vtkDataArray* const original = flat->GetPointData()->GetArray("vtkOriginalPointIds");
    double ends[2][3];
    for (vtkIdType k = 0; k < flat->GetNumberOfPoints(); ++k)
    {
      const double id = original->GetComponent(k, 0);
      if (id == 0.0 || id == 5.0)
      {
        flat->GetPoint(k, ends[id == 0.0 ? 0 : 1]);
      }
    }
    return std::atan2(ends[1][1] - ends[0][1], ends[1][0] - ends[0][0]);
  };
  const auto shown = [this, &direction] {
    vtkActorCollection* const actors =
      this->window->planeWidget()->renderWindow()->GetRenderers()->GetFirstRenderer()->GetActors();
    actors->InitTraversal();
    return direction(vtkPolyData::SafeDownCast(actors->GetNextActor()->GetMapper()->GetInput()));
  };
  const auto laid = [this, &direction] {
    return direction(this->window->flattening().result().flat);
  };
  this->waitForPieces();
  const double before = shown();
  const double laidBefore = laid();
  this->draw({ 401, 12 }); // across
  this->push(Hand::MAKE_KEY);
  this->waitForPieces();
  EXPECT_GT(std::abs(std::sin(laid() - laidBefore)), 0.9); // the pattern lies by its grain
  EXPECT_NEAR(shown(), before, 0.05);
  EXPECT_NEAR(std::sin(before), 1.0, 0.01); // as the shirt hangs
  this->picture("key");
}

TEST_F(PatternEditor, TheFlatPieceFollowsADrag)
{
  this->drawTutorial();
  this->waitForPieces();
  const double before = this->measure("AreaError");
  this->drag(this->node(3, 1), this->node(3, 1) + QPoint(15, 30));
  this->waitForPieces();
  EXPECT_NE(this->measure("AreaError"), before);
  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  this->waitForPieces();
  EXPECT_EQ(this->measure("AreaError"), before);
}

TEST_F(PatternEditor, WhatIsBrokenIsSaidAndGoesWithItsCause)
{
  ASSERT_TRUE(this->window->openCurves(FLATTENING_DATA "/shirt_front_curves.vtp"));
  this->waitForPieces();
  vtkFeatureCurveEditor* const curves = this->window->curves();
  for (int curve = 0; curve < curves->GetNumberOfCurves(); ++curve)
  {
    if (curves->GetCurveName(curve) == "bust_girth")
    {
      this->window->hand()->Choose(curve, -1);
    }
  }
  // Cut open along its girth the banks of the darts cross.
  this->push(Hand::MAKE_DART);
  this->waitForPieces();
  EXPECT_TRUE(this->window->message().contains("bust_dart_left"))
    << this->window->message().toStdString();
  this->push(Hand::UNDO);
  this->waitForPieces();
  EXPECT_EQ(this->window->message(), "");
}

TEST_F(PatternEditor, AllThatCanBeDoneIsInTheMenusWithAKeyOfItsOwn)
{
  std::map<QString, QString> keys;
  QList<QAction*> menus = this->window->menuBar()->actions();
  for (int k = 0; k < menus.size(); ++k)
  {
    for (QAction* action : menus[k]->menu()->actions())
    {
      if (action->menu())
      {
        menus.append(action);
      }
      else if (!action->isSeparator())
      {
        const QString key = action->shortcut().toString();
        EXPECT_FALSE(key.isEmpty()) << action->text().toStdString();
        EXPECT_TRUE(keys.emplace(key, action->text()).second)
          << key.toStdString() << ": " << action->text().toStdString();
      }
    }
  }
  EXPECT_GE(keys.size(), Hand::NUMBER_OF_ACTIONS + 10U);
}

TEST_F(PatternEditor, ViewsAreNotWhiteInADarkTheme)
{
  const auto light = [](vtkRenderer* renderer) { return renderer->GetBackground()[0]; };
  EXPECT_EQ(light(this->window->plane()), 1.0);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(30, 30, 30));
  this->window->setPalette(dark);
  QApplication::processEvents();
  for (vtkRenderer* const renderer : { this->window->space(), this->window->plane() })
  {
    EXPECT_LT(light(renderer), 0.7);
    EXPECT_GT(light(renderer), 0.5); // black lines are on it
  }
}

TEST_F(PatternEditor, TheBarHasIconsOfTheStylesSize)
{
  const auto* const bar = this->window->findChild<QToolBar*>();
  const int size = this->window->style()->pixelMetric(QStyle::PM_SmallIconSize);
  for (QAction* action : bar->actions())
  {
    if (!action->isSeparator())
    {
      const QImage drawn = action->icon().pixmap(size, size).toImage();
      bool visible = false;
      for (int k = 0; k < drawn.width() * drawn.height(); ++k)
      {
        visible = visible || qAlpha(drawn.pixel(k % drawn.width(), k / drawn.width())) > 0;
      }
      EXPECT_TRUE(visible) << action->text().toStdString();
    }
  }
}

TEST_F(PatternEditor, ACommandIsFoundBySomeOfItsLetters)
{
  onDialog<QInputDialog>(300, [](QInputDialog* dialog) {
    dialog->setTextValue("STROKE");
    dialog->accept();
  });
  QTest::keyClick(this->window.get(), Qt::Key_K, Qt::ControlModifier);
  EXPECT_TRUE(this->window->action(Hand::FREEHAND)->isChecked());
}

TEST_F(PatternEditor, KeysDoWhatTheBarDoes)
{
  EXPECT_FALSE(this->window->action(Hand::FINISH)->isEnabled());
  QTest::keyClick(this->window.get(), Qt::Key_N);
  EXPECT_TRUE(this->window->hand()->IsDrawing());
  this->click(this->vertex(401));
  this->click(this->vertex(12));
  QTest::keyClick(this->window.get(), Qt::Key_Return);
  EXPECT_FALSE(this->window->hand()->IsDrawing());
  ASSERT_EQ(this->window->curves()->GetNumberOfCurves(), 1);
  QTest::keyClick(this->window.get(), Qt::Key_K);
  EXPECT_EQ(this->window->curves()->GetCurveType(0), 1);
  EXPECT_TRUE(this->window->action(Hand::MAKE_KEY)->isChecked());
  QTest::keyClick(this->window.get(), Qt::Key_Delete);
  EXPECT_EQ(this->window->curves()->GetNumberOfCurves(), 0);
}

TEST_F(PatternEditor, WhatTheMouseCouldNotDoIsSaidUntilSomethingIsDone)
{
  QTest::keyClick(this->window.get(), Qt::Key_N);
  this->click(this->vertex(401));
  this->click({ 5, 5 }, Qt::RightButton);
  EXPECT_EQ(this->window->curves()->GetNumberOfCurves(), 0);
  this->waitForPieces();
  this->moveTo(this->vertex(6));
  EXPECT_TRUE(this->window->message().contains("one node"))
    << this->window->message().toStdString();
  QTest::keyClick(this->window.get(), Qt::Key_N);
  this->click(this->vertex(401));
  this->click(this->vertex(6));
  EXPECT_EQ(this->window->message(), "");
}

TEST_F(PatternEditor, CurvesOfAnotherSurfaceAreSaidToBe)
{
  const std::string curves = FLATTENING_DATA "/shirt_front_curves.vtp";
  ASSERT_TRUE(this->window->openCurves(curves)) << this->window->message().toStdString();
  EXPECT_EQ(this->window->message(), "");
  ASSERT_TRUE(this->window->openSurface(FLATTENING_DATA "/wetsuit_upper_front.vtp"));
  if (this->window->openCurves(curves))
  {
    EXPECT_TRUE(this->window->message().contains("from the surface"))
      << this->window->message().toStdString();
  }
  else
  {
    EXPECT_NE(this->window->message(), "");
  }
}

TEST_F(PatternEditor, AnOffsetRunsThroughTheClickedPlaceOrAtTheGivenDistance)
{
  vtkFeatureCurveEditor* const curves = this->window->curves();
  this->draw({ 401, 12 });
  this->push(Hand::OFFSET);
  const vtkIdType place = 6;
  this->click(this->vertex(place));
  ASSERT_EQ(curves->GetNumberOfCurves(), 2);
  EXPECT_FALSE(this->window->action(Hand::OFFSET)->isChecked());
  const double distance = curves->GetDistance(0, this->surface->GetPoint(place));
  ASSERT_GT(std::abs(distance), 0.1);
  EXPECT_NEAR(
    curves->GetDistance(1, this->surface->GetPoint(place)), 0.0, 0.02 * std::abs(distance));
  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(curves->GetNumberOfCurves(), 1);

  this->window->hand()->Choose(0, -1);
  onDialog<QInputDialog>(300, [](QInputDialog* dialog) {
    dialog->setDoubleValue(1.5);
    dialog->accept();
  });
  QTest::keyClick(this->window.get(), Qt::Key_L, Qt::ControlModifier);
  ASSERT_EQ(curves->GetNumberOfCurves(), 2);
  double node[3];
  curves->GetNode(1, curves->GetNumberOfNodes(1) / 2, node);
  EXPECT_NEAR(curves->GetDistance(0, node), 1.5, 0.01);
  this->waitForPieces();
  this->picture("offset");
  EXPECT_FALSE(this->window->addOffset(1e6));
  EXPECT_TRUE(this->window->message().contains("1e+06")) << this->window->message().toStdString();
}

TEST_F(PatternEditor, AStrokeIsACurveOfFewNodes)
{
  vtkFeatureCurveEditor* const curves = this->window->curves();
  QTest::keyClick(this->window.get(), Qt::Key_F);
  const QPoint from = this->vertex(401);
  const QPoint to = this->vertex(12);
  this->moveTo(from);
  this->press(from);
  QPoint middle;
  for (int k = 1; k <= 60; ++k)
  {
    const QPoint wave(0, static_cast<int>(std::lround(20.0 * std::sin(0.1 * k))));
    const QPoint place = from + (to - from) * k / 60 + (k < 60 ? wave : QPoint());
    middle = k == 31 ? place : middle;
    this->moveTo(place, Qt::LeftButton);
    if (k == 40)
    {
      this->picture("stroking");
    }
  }
  this->release(to);
  this->waitForPieces();
  this->picture("stroke");
  ASSERT_EQ(curves->GetNumberOfCurves(), 1) << this->window->message().toStdString();
  EXPECT_FALSE(this->window->hand()->IsOn(Hand::FREEHAND));
  EXPECT_GT(curves->GetNumberOfNodes(0), 2);
  EXPECT_LT(curves->GetNumberOfNodes(0), 15);
  EXPECT_EQ(curves->GetSegmentKind(0, 0), vtkFeatureCurveEditor::SPLINE);
  // A click on the stroke chooses the curve.
  this->window->hand()->Choose(-1, -1);
  this->click(middle);
  EXPECT_EQ(this->window->hand()->GetChosenCurve(), 0);
  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), 0);
}

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) // which needs no X server
  {
    return RUN_ALL_TESTS();
  }
  // The user's own journal of curves is left alone; a death test's second run shares the first's.
  std::unique_ptr<QTemporaryDir> home;
  if (!qEnvironmentVariableIsSet("PATTERN_EDITOR_HOME"))
  {
    home = std::make_unique<QTemporaryDir>();
    qputenv("PATTERN_EDITOR_HOME", home->path().toUtf8());
    qputenv("XDG_DATA_HOME", home->path().toUtf8());
  }
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLStereoWidget::defaultFormat());
  const editor::Application application(argc, argv);
  return RUN_ALL_TESTS();
}

TEST_F(PatternEditor, ACurveInTheMiddleIsNotJoinedToTheOutlineByALineThatLooksLikeACut)
{
  this->draw({ 6, 7 });
  this->waitForPieces();
  const auto lengthOf = [](vtkPolyData* lines, bool blackOnly) {
    double length = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
    {
      vtkDataArray* const colors = lines->GetCellData()->GetScalars();
      const double* const color = blackOnly ? colors->GetTuple3(line) : nullptr;
      lines->GetCellPoints(line, ids);
      for (vtkIdType k = 1; k < ids->GetNumberOfIds() && (!color || vtkMath::Norm(color) == 0.0);
           ++k)
      {
        double from[3];
        double to[3];
        lines->GetPoint(ids->GetId(k - 1), from);
        lines->GetPoint(ids->GetId(k), to);
        length += std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
      }
    }
    return length;
  };
  vtkNew<vtkFeatureEdges> outline;
  outline->SetInputData(this->window->planeView().shown().flat);
  outline->FeatureEdgesOff();
  outline->NonManifoldEdgesOff();
  outline->Update();
  const double expected = lengthOf(outline->GetOutput(), false);
  ASSERT_GT(expected, 100.0);
  vtkActorCollection* const actors = this->window->plane()->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  double black = 0.0;
  while (vtkActor* const actor = actors->GetNextActor(at))
  {
    auto* const drawn = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputAsDataSet());
    if (drawn && drawn->GetNumberOfLines() > 0)
    {
      black += lengthOf(drawn, true);
    }
  }
  EXPECT_NEAR(black, expected, 1e-6 * expected);
}
