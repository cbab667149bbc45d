// SPDX-License-Identifier: BSD-3-Clause
// The menus and the bar of EditorWindow.
#include "EditorWindow.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace editor
{
namespace
{
/// A key of VTK in the words of Qt.
QKeySequence keyOf(const QString& key)
{
  QString words = key;
  words.replace("Control-", "Ctrl+").replace("BackSpace", "Backspace");
  return QKeySequence(words);
}

bool isSwitch(int action)
{
  switch (action)
  {
    case vtkFeatureCurveWidget::NEW_CURVE:
    case vtkFeatureCurveWidget::CLOSE:
    case vtkFeatureCurveWidget::JOIN:
    case vtkFeatureCurveWidget::MIRROR:
    case vtkFeatureCurveWidget::MAKE_ACCESSORY:
    case vtkFeatureCurveWidget::MAKE_KEY:
    case vtkFeatureCurveWidget::MAKE_DART:
    case vtkFeatureCurveWidget::MAKE_SEAM:
    case vtkFeatureCurveWidget::STRAIGHT_KEY:
    case vtkFeatureCurveWidget::GEODESIC:
    case vtkFeatureCurveWidget::SECTION:
    case vtkFeatureCurveWidget::EDGES:
    case vtkFeatureCurveWidget::SPLINE:
    case vtkFeatureCurveWidget::SNAP:
      return true;
    default:
      return false;
  }
}

std::string chosenFile(const QString& file, const QString& extension)
{
  const bool bare = !file.isEmpty() && QFileInfo(file).suffix().isEmpty();
  return (bare ? file + extension : file).toStdString();
}
}

//------------------------------------------------------------------------------
QAction* EditorWindow::addAction(
  QMenu* menu, const QString& name, const QString& key, void (EditorWindow::*run)())
{
  QAction* const action = menu->addAction(name);
  action->setShortcut(QKeySequence(key));
  QObject::connect(action, &QAction::triggered, [this, run] { (this->*run)(); });
  return action;
}

//------------------------------------------------------------------------------
void EditorWindow::makeFileMenu()
{
  QMenu* const menu = this->menuBar()->addMenu("&File");
  this->addAction(menu, "Open surface...", "Ctrl+O", &EditorWindow::askSurface);
  this->addAction(menu, "Open curves...", "Ctrl+Shift+O", &EditorWindow::askCurves);
  this->addAction(menu, "Save curves...", "Ctrl+S", &EditorWindow::askSave);
  menu->addSeparator();
  this->addAction(menu, "Export pattern...", "Ctrl+E", &EditorWindow::askPattern);
  this->addAction(menu, "Save picture...", "Ctrl+P", &EditorWindow::askPicture);
  menu->addSeparator();
  QAction* const quit = menu->addAction("Quit");
  quit->setShortcut(QKeySequence("Ctrl+Q"));
  QObject::connect(quit, &QAction::triggered, [this] { this->close(); });
}

//------------------------------------------------------------------------------
void EditorWindow::makeHandActions()
{
  QMenu* const edit = this->menuBar()->addMenu("&Edit");
  QMenu* const curve = this->menuBar()->addMenu("&Curve");
  for (int id = 0; id < vtkFeatureCurveWidget::NUMBER_OF_ACTIONS; ++id)
  {
    const bool editing = id == vtkFeatureCurveWidget::UNDO || id == vtkFeatureCurveWidget::REDO ||
      id == vtkFeatureCurveWidget::REMOVE_NODE || id == vtkFeatureCurveWidget::REMOVE_CURVE;
    QAction* const action =
      (editing ? edit : curve)->addAction(vtkFeatureCurveWidget::GetActionName(id));
    const QKeySequence key = keyOf(vtkFeatureCurveWidget::GetActionKey(id));
    action->setShortcut(key);
    action->setCheckable(isSwitch(id));
    action->setIconText(action->text() + "  [" + key.toString() + "]");
    QObject::connect(action, &QAction::triggered, [this, id] {
      if (!this->Hand->Do(id))
      {
        this->tell(this->Hand->GetHint(), true);
      }
      this->followChoice();
    });
    this->HandActions[static_cast<std::size_t>(id)] = action;
  }
}

//------------------------------------------------------------------------------
void EditorWindow::makeViewMenu()
{
  QMenu* const menu = this->menuBar()->addMenu("&View");
  auto* const group = new QActionGroup(this);
  for (std::size_t k = 0; k < figures::colorings.size(); ++k)
  {
    const figures::Coloring coloring = figures::colorings[k];
    QAction* const action = menu->addAction(QString("Colours: %1").arg(figures::nameOf(coloring)));
    action->setShortcut(QKeySequence(QString::number(k + 1)));
    action->setCheckable(true);
    action->setChecked(coloring == this->Coloring);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, [this, coloring] {
      this->Coloring = coloring;
      this->showResult();
    });
  }
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): the group's parent deletes it
  QAction* const edges = menu->addAction("Edges of the mesh");
  edges->setShortcut(QKeySequence("W"));
  edges->setCheckable(true);
  QObject::connect(edges, &QAction::triggered, [this](bool shown) {
    this->SpaceScene.setEdges(shown);
    this->showResult();
  });
  this->addAction(menu, "Whole view", "R", &EditorWindow::resetViews);
}

//------------------------------------------------------------------------------
void EditorWindow::makeBar()
{
  auto* const bar = new QToolBar("Curves");
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  for (const QAction* entry : this->menuBar()->actions())
  {
    if (entry->text() == "&Edit" || entry->text() == "&Curve")
    {
      bar->addActions(entry->menu()->actions());
      bar->addSeparator();
    }
  }
  this->addToolBar(Qt::LeftToolBarArea, bar);
}

//------------------------------------------------------------------------------
void EditorWindow::askSurface()
{
  const QString file = this->mayForgetCurves() ? QFileDialog::getOpenFileName(this, "Open surface",
                                                   {}, "Surfaces (*.vtp *.vtk *.obj *.ply *.stl)")
                                               : QString();
  if (!file.isEmpty())
  {
    this->openSurface(file.toStdString());
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askCurves()
{
  const QString file = this->mayForgetCurves()
    ? QFileDialog::getOpenFileName(this, "Open curves", {}, "Curves (*.vtp *.vtk)")
    : QString();
  if (!file.isEmpty())
  {
    this->openCurves(file.toStdString());
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askSave()
{
  const std::string file =
    chosenFile(QFileDialog::getSaveFileName(this, "Save curves",
                 QString::fromStdString(this->Name + "_curves.vtp"), "Curves (*.vtp)"),
      ".vtp");
  if (!file.empty())
  {
    this->saveCurves(file);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askPattern()
{
  const std::string file =
    chosenFile(QFileDialog::getSaveFileName(this, "Export pattern",
                 QString::fromStdString(this->Name + ".pdf"), "Patterns (*.pdf *.svg *.dxf)"),
      ".pdf");
  if (!file.empty())
  {
    this->savePattern(file);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askPicture()
{
  const std::string file =
    chosenFile(QFileDialog::getSaveFileName(this, "Save picture",
                 QString::fromStdString(this->Name + ".png"), "Pictures (*.png)"),
      ".png");
  if (!file.empty())
  {
    this->savePicture(file);
  }
}
}
