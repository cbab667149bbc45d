// SPDX-License-Identifier: BSD-3-Clause
// Mouse and keys as Qt gets them from the X server, with the curves, files and flat pieces that
// must come of them. With the variable PATTERN_EDITOR_PICTURES the session leaves pictures in that
// folder.
#include "EditorFiles.h"
#include "EditorWindow.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include <QApplication>
#include <QMenuBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

using editor::EditorWindow;
using Hand = vtkFeatureCurveWidget;

namespace
{
const std::string shirt = FLATTENING_DATA "/shirt_front.vtp";

struct TutorialCurve
{
  int type;
  std::string name;
  std::vector<vtkIdType> vertices;
};

std::vector<TutorialCurve> tutorialCurves()
{
  const std::map<std::string, int> types{ { "accessory", 0 }, { "key", 1 }, { "dart", 2 } };
  std::vector<TutorialCurve> curves;
  std::ifstream file(FLATTENING_TUTORIAL);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string type;
    TutorialCurve curve;
    if (line[0] != '#' && words >> type >> curve.name)
    {
      curve.type = types.at(type);
      for (vtkIdType vertex = 0; words >> vertex;)
      {
        curve.vertices.push_back(vertex);
      }
      curves.push_back(curve);
    }
  }
  return curves;
}

/// The same curves by their vertices, as the command takes them.
figures::PolyData tutorialLines(vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> types;
  types->SetName("CurveType");
  vtkNew<vtkStringArray> names;
  names->SetName("CurveName");
  for (const TutorialCurve& curve : tutorialCurves())
  {
    lines->InsertNextCell(static_cast<int>(curve.vertices.size()));
    for (const vtkIdType vertex : curve.vertices)
    {
      lines->InsertCellPoint(points->InsertNextPoint(surface->GetPoint(vertex)));
    }
    types->InsertNextValue(curve.type);
    names->InsertNextValue(curve.name);
  }
  figures::PolyData data = figures::PolyData::New();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetCellData()->AddArray(types);
  data->GetCellData()->AddArray(names);
  return data;
}

class PatternEditor : public testing::Test
{
protected:
  void SetUp() override { this->open(); }

  void open()
  {
    this->window = std::make_unique<EditorWindow>();
    this->window->resize(1400, 900);
    this->window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(this->window.get()));
    QApplication::setActiveWindow(this->window.get());
    ASSERT_TRUE(this->window->openSurface(shirt)) << this->window->message().toStdString();
    this->surface = editor::readPolyData(shirt);
    QApplication::processEvents();
  }

  QPoint pixelOf(const double point[3]) const
  {
    vtkRenderer* const renderer = this->window->space();
    renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
    renderer->WorldToDisplay();
    const double* const display = renderer->GetDisplayPoint();
    return { static_cast<int>(std::lround(display[0])),
      this->window->spaceWidget()->height() - 1 - static_cast<int>(std::lround(display[1])) };
  }
  QPoint vertex(vtkIdType id) const { return this->pixelOf(this->surface->GetPoint(id)); }
  QPoint node(int curve, int id) const
  {
    double point[3];
    this->window->curves()->GetNode(curve, id, point);
    return this->pixelOf(point);
  }
  /// Without the X server's pointer, whose moves arrive when the server finds time, in the middle
  /// of a drag as well.
  void moveTo(const QPoint& place, Qt::MouseButtons buttons = Qt::NoButton)
  {
    QWidget* const view = this->window->spaceWidget();
    QMouseEvent event(
      QEvent::MouseMove, place, view->mapToGlobal(place), Qt::NoButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(view, &event);
  }
  void click(const QPoint& place, Qt::MouseButton button = Qt::LeftButton)
  {
    this->moveTo(place);
    QTest::mouseClick(this->window->spaceWidget(), button, Qt::NoModifier, place);
  }
  void drag(const QPoint& from, const QPoint& to, int steps = 8)
  {
    QWidget* const view = this->window->spaceWidget();
    this->moveTo(from);
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
    for (int k = 1; k <= steps; ++k)
    {
      this->moveTo(from + (to - from) * k / steps, Qt::LeftButton);
    }
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, to);
  }
  /// Clicks a vertex; one at the side is turned to the front first, as a user does.
  void clickSeen(vtkIdType id)
  {
    const QPoint middle = this->window->spaceWidget()->rect().center();
    const int aside = this->vertex(id).x() - middle.x();
    const int turn = std::abs(aside) > 40 ? (aside > 0 ? -140 : 140) : 0;
    const QPoint ground(middle.x(), 6);
    this->turn(ground, ground + QPoint(turn, 0));
    if (id == 12) // the end of the bust girth
    {
      this->moveTo(this->vertex(id));
      this->picture("drawing");
    }
    this->click(this->vertex(id));
    this->turn(ground, ground - QPoint(turn, 0));
  }
  void turn(const QPoint& from, const QPoint& to)
  {
    if (from != to)
    {
      this->drag(from, to, 4);
    }
  }
  /// Clicks the button of an action in the bar.
  void push(int action)
  {
    QWidget* button = nullptr;
    for (QToolBar* bar : this->window->findChildren<QToolBar*>())
    {
      button = button ? button : bar->widgetForAction(this->window->action(action));
    }
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void rename(const std::string& name)
  {
    QLineEdit* const field = this->window->panel()->name();
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClicks(field, QString::fromStdString(name));
    QTest::keyClick(field, Qt::Key_Return);
  }
  void drawTutorial()
  {
    for (const TutorialCurve& curve : tutorialCurves())
    {
      this->push(Hand::NEW_CURVE);
      this->push(Hand::SECTION);
      for (const vtkIdType id : curve.vertices)
      {
        this->clickSeen(id);
      }
      this->click({ 5, 5 }, Qt::RightButton);
      this->push(Hand::MAKE_ACCESSORY + curve.type);
      this->rename(curve.name);
    }
  }
  void waitForPieces()
  {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !this->window->isWaiting(); }, 20000));
  }
  void picture(const std::string& name)
  {
    if (const char* const folder = std::getenv("PATTERN_EDITOR_PICTURES"))
    {
      QApplication::processEvents();
      EXPECT_TRUE(this->window->savePicture(folder + ("/" + name) + ".png"));
    }
  }
  double measure(const char* name) const
  {
    return this->window->flattening().result().number(name);
  }

  std::unique_ptr<EditorWindow> window;
  figures::PolyData surface;
};
}

//------------------------------------------------------------------------------
TEST_F(PatternEditor, TheTutorialsCurvesDrawnByMouseSavedAndLoadedGiveItsReport)
{
  this->drawTutorial();
  this->waitForPieces();
  this->picture("drawn");
  editor::LiveFlattening expected;
  expected.setSurface(this->surface);
  ASSERT_TRUE(expected.run(tutorialLines(this->surface)));

  const std::string path = testing::TempDir() + "drawn_curves.vtp";
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
    vtkFieldData* const drawn = this->window->flattening().result().wires->GetFieldData();
    vtkFieldData* const given = expected.result().wires->GetFieldData();
    for (vtkIdType row = 0; row < 5; ++row)
    {
      const double length = given->GetArray("CurveFlatLengths")->GetComponent(row, 0);
      EXPECT_NEAR(drawn->GetArray("CurveFlatLengths")->GetComponent(row, 0), length, 1e-9 * length);
      EXPECT_EQ(vtkStringArray::SafeDownCast(drawn->GetAbstractArray("CurveNames"))->GetValue(row),
        vtkStringArray::SafeDownCast(given->GetAbstractArray("CurveNames"))->GetValue(row));
    }
  }
  // They are as editable as before.
  this->drag(this->node(1, 1), this->node(1, 1) + QPoint(0, 40));
  EXPECT_TRUE(this->window->curves()->CanUndo());
  std::remove(path.c_str());
}

TEST_F(PatternEditor, EditsAtRandomUndoneLeaveTheFirstState)
{
  this->drawTutorial();
  const std::string path = testing::TempDir() + "first_curves.vtp";
  ASSERT_TRUE(this->window->saveCurves(path));
  ASSERT_TRUE(this->window->openCurves(path));
  const auto state = [this] {
    vtkNew<vtkPolyData> curves;
    this->window->curves()->GetCurves(curves);
    std::vector<double> values;
    for (vtkIdType k = 0; k < curves->GetNumberOfPoints(); ++k)
    {
      values.insert(values.end(), curves->GetPoint(k), curves->GetPoint(k) + 3);
    }
    return values;
  };
  const std::vector<double> first = state();
  std::mt19937 random(3);
  const auto pick = [&random](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  vtkFeatureCurveEditor* const curves = this->window->curves();
  for (int k = 0; k < 40; ++k)
  {
    const int curve = curves->GetNumberOfCurves() > 0 ? pick(curves->GetNumberOfCurves()) : -1;
    const QPoint place = this->vertex(pick(static_cast<int>(this->surface->GetNumberOfPoints())));
    if (curve < 0 || pick(4) == 0)
    {
      this->push(Hand::NEW_CURVE);
      this->click(place);
      this->click(this->vertex(pick(400)));
      this->click({ 5, 5 }, Qt::RightButton);
    }
    else if (pick(2) == 0)
    {
      this->drag(this->node(curve, pick(curves->GetNumberOfNodes(curve))), place, 2);
    }
    else
    {
      this->click(this->node(curve, pick(curves->GetNumberOfNodes(curve))));
      const int actions[] = { Hand::REMOVE_NODE, Hand::CLOSE, Hand::SPLIT, Hand::MIRROR,
        Hand::MAKE_DART, Hand::MAKE_KEY, Hand::GEODESIC, Hand::REMOVE_CURVE };
      this->push(actions[pick(8)]);
    }
  }
  EXPECT_NE(state(), first);
  int undone = 0;
  for (; this->window->action(Hand::UNDO)->isEnabled(); ++undone)
  {
    this->push(Hand::UNDO);
  }
  EXPECT_GT(undone, 20);
  EXPECT_EQ(state(), first);
  std::remove(path.c_str());
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
  for (const QAction* menu : this->window->menuBar()->actions())
  {
    for (const QAction* action : menu->menu()->actions())
    {
      if (!action->isSeparator())
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

TEST_F(PatternEditor, PatternsAndPicturesAreWritten)
{
  this->drawTutorial();
  for (const char* extension : { ".pdf", ".svg", ".dxf", ".png" })
  {
    const std::string path = testing::TempDir() + "editor_pattern" + extension;
    const bool picture = std::string(extension) == ".png";
    EXPECT_TRUE(picture ? this->window->savePicture(path) : this->window->savePattern(path))
      << this->window->message().toStdString();
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    EXPECT_GT(file.tellg(), 2000) << extension;
    std::remove(path.c_str());
  }
}

TEST_F(PatternEditor, FilesThatCannotBeReadOrWrittenAreNamed)
{
  const std::string nowhere = "/no such folder/curves.vtp";
  EXPECT_FALSE(this->window->openSurface(nowhere));
  EXPECT_TRUE(this->window->message().contains("/no such folder"));
  EXPECT_FALSE(this->window->saveCurves(nowhere));
  EXPECT_FALSE(this->window->savePattern("/no such folder/pattern.pdf"));
  EXPECT_FALSE(this->window->openSurface(FLATTENING_TUTORIAL));
  EXPECT_TRUE(this->window->message().contains(".vtp"));
  EXPECT_FALSE(this->window->openCurves(shirt)); // no curves
  EXPECT_EQ(this->window->curves()->GetNumberOfCurves(), 0);
}

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) // which needs no X server
  {
    return RUN_ALL_TESTS();
  }
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
