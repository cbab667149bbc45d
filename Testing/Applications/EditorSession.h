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
#include <vtkActor2DCollection.h>
#include <vtkActorCollection.h>
#include <vtkCellData.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkStringArray.h>
#include <vtkTextActor.h>
#include <vtkXMLPolyDataWriter.h>

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenuBar>
#include <QProgressDialog>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
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

inline std::string textOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/// Does something with the dialog that is open after some milliseconds.
template <class Dialog>
void onDialog(int milliseconds, const std::function<void(Dialog*)>& act)
{
  QTimer::singleShot(milliseconds, [act] {
    auto* const dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    act(dialog);
  });
}

inline vtkSmartPointer<vtkPoints> pointsAt(const std::vector<std::array<double, 3>>& places)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  return points;
}

inline vtkSmartPointer<vtkPoints> pointsAt(
  vtkPolyData* surface, std::initializer_list<vtkIdType> vertices)
{
  std::vector<std::array<double, 3>> places;
  for (const vtkIdType id : vertices)
  {
    surface->GetPoint(id, places.emplace_back().data());
  }
  return pointsAt(places);
}

/// What is written in a view.
inline std::string textsOf(vtkRenderer* renderer)
{
  vtkActor2DCollection* const props = renderer->GetActors2D();
  std::string words;
  for (int k = 0; k < props->GetNumberOfItems(); ++k)
  {
    auto* const text = vtkTextActor::SafeDownCast(props->GetItemAsObject(k));
    words += text && text->GetInput() ? text->GetInput() + std::string("\n") : "";
  }
  return words;
}

inline QPoint pixelOf(vtkRenderer* renderer, const QWidget* view, const double point[3])
{
  renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
  renderer->WorldToDisplay();
  const double* const display = renderer->GetDisplayPoint();
  return { static_cast<int>(std::lround(display[0])),
    view->height() - 1 - static_cast<int>(std::lround(display[1])) };
}

class PatternEditor : public testing::Test
{
protected:
  void SetUp() override { this->open(); }

  /// A window without anything.
  void show()
  {
    this->window = std::make_unique<EditorWindow>();
    this->window->resize(1400, 900);
    this->window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(this->window.get()));
    QApplication::setActiveWindow(this->window.get());
  }
  void open()
  {
    this->show();
    ASSERT_TRUE(this->window->openSurface(shirt)) << this->window->message().toStdString();
    this->surface = wirewarp::polyDataOf(wirewarp::readSurface(shirt).surface);
    QApplication::processEvents();
  }

  QPoint pixelOf(const double point[3]) const
  {
    return session::pixelOf(this->window->space(), this->window->spaceWidget(), point);
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
  void send(QEvent::Type type, const QPoint& place, Qt::MouseButton button,
    Qt::MouseButtons buttons, QVTKOpenGLStereoWidget* in = nullptr)
  {
    QVTKOpenGLStereoWidget* const view = in ? in : this->window->spaceWidget();
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
  /// Draws a curve by clicks; a section by a user who turns its ends to the front first.
  void draw(const std::vector<vtkIdType>& vertices, bool section = false)
  {
    this->push(Hand::NEW_CURVE);
    if (section)
    {
      this->push(Hand::SECTION);
    }
    for (const vtkIdType id : vertices)
    {
      section ? this->clickSeen(id) : this->click(this->vertex(id));
    }
    this->click({ 5, 5 }, Qt::RightButton);
  }

  void drawTutorial()
  {
    for (const TutorialCurve& curve : tutorialCurves())
    {
      this->draw(curve.vertices, true);
      this->push(Hand::MAKE_ACCESSORY + curve.type);
      this->rename(curve.name);
    }
  }

  /// Answers the dialog for a file that comes next.
  void choose(const std::string& path)
  {
    onDialog<QFileDialog>(500, [path](QFileDialog* dialog) {
      dialog->findChild<QLineEdit*>()->setText(QString::fromStdString(path));
      QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
    });
  }
  /// Fills a curve's row in the pattern options, which are accepted then.
  void fillCurveOptions(
    const QString& curve, const std::function<void(QDialog*, QTableWidget*, int)>& fill)
  {
    onDialog<QDialog>(300, [curve, fill](QDialog* dialog) {
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
  /// In a folder that goes with the test.
  std::string file(const std::string& name)
  {
    if (!this->files)
    {
      this->files = std::make_unique<QTemporaryDir>(QDir::tempPath() + "/pattern editor, XXXXXX");
    }
    return this->files->filePath(QString::fromStdString(name)).toStdString();
  }
  std::string write(vtkPolyData* data, const std::string& name)
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    std::string path = this->file(name);
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    writer->Write();
    return path;
  }

  double measure(const char* name) const
  {
    return this->window->flattening().result().number(name);
  }

  std::unique_ptr<EditorWindow> window;
  figures::PolyData surface;

private:
  std::unique_ptr<QTemporaryDir> files;
};
}
