// SPDX-License-Identifier: BSD-3-Clause
// A window of PatternEditor and a user of it. With the variable PATTERN_EDITOR_PICTURES the session
// leaves pictures in that folder.
#pragma once

#include "EditorWindow.h"
#include "PolyDataOutput.h"
#include "ReadCurves.h"
#include "ReadSurface.h"

#include <QVTKOpenGLWindow.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellData.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkStringArray.h>

#include <QApplication>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenuBar>
#include <QProgressDialog>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <sstream>

namespace session
{
using editor::EditorWindow;
using Hand = vtkFeatureCurveWidget;

inline const std::string shirt = FLATTENING_DATA "/shirt_front.vtp";

struct TutorialCurve
{
  int type;
  std::string name;
  std::vector<vtkIdType> vertices;
};

inline std::vector<TutorialCurve> tutorialCurves()
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

/// The same curves, as the command reads them.
inline figures::PolyData tutorialLines(vtkPolyData* surface)
{
  return wirewarp::polyDataOf(
    wirewarp::readCurves(FLATTENING_TUTORIAL, wirewarp::dataSetOf(surface)).curves);
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
    this->surface = wirewarp::polyDataOf(wirewarp::readSurface(shirt).surface);
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
  void send(
    QEvent::Type type, const QPoint& place, Qt::MouseButton button, Qt::MouseButtons buttons)
  {
    QVTKOpenGLStereoWidget* const view = this->window->spaceWidget();
    QMouseEvent event(type, place, view->mapToGlobal(place), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(view->embeddedOpenGLWindow(), &event);
  }
  void moveTo(const QPoint& place, Qt::MouseButtons buttons = Qt::NoButton)
  {
    this->send(QEvent::MouseMove, place, Qt::NoButton, buttons);
  }
  void press(const QPoint& place, Qt::MouseButton button = Qt::LeftButton)
  {
    this->send(QEvent::MouseButtonPress, place, button, button);
  }
  void release(const QPoint& place, Qt::MouseButton button = Qt::LeftButton)
  {
    this->send(QEvent::MouseButtonRelease, place, button, Qt::NoButton);
    QApplication::processEvents();
  }
  void click(const QPoint& place, Qt::MouseButton button = Qt::LeftButton)
  {
    this->moveTo(place);
    this->press(place, button);
    this->release(place, button);
  }
  void drag(const QPoint& from, const QPoint& to, int steps = 8)
  {
    this->moveTo(from);
    this->press(from);
    for (int k = 1; k <= steps; ++k)
    {
      this->moveTo(from + (to - from) * k / steps, Qt::LeftButton);
    }
    this->release(to);
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
  /// Answers the dialog for a file that comes next.
  void choose(const std::string& path)
  {
    QTimer::singleShot(500, [path] {
      auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      dialog->findChild<QLineEdit*>()->setText(QString::fromStdString(path));
      QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
    });
  }
  /// Fills a curve's row in the pattern options, which are accepted then.
  void fillCurveOptions(
    const QString& curve, const std::function<void(QDialog*, QTableWidget*, int)>& fill)
  {
    QTimer::singleShot(300, [curve, fill] {
      auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      auto* const table = dialog->findChild<QTableWidget*>("CurveOptions");
      ASSERT_NE(table, nullptr);
      int row = 0;
      while (row + 1 < table->rowCount() && table->verticalHeaderItem(row)->text() != curve)
      {
        ++row;
      }
      fill(dialog, table, row);
      dialog->accept();
    });
    QTest::keyClick(this->window.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QApplication::setActiveWindow(this->window.get()); // the dialog was it
    this->waitForPieces();
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
