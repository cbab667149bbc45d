// SPDX-License-Identifier: BSD-3-Clause
// The menus and the bar of EditorWindow.
#include "EditorWindow.h"
#include "FaceSeams.h"
#include "PatternDialog.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QRegularExpression>
#include <QToolBar>

#include <array>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace editor
{
namespace
{
/// What readSurface() takes.
const char* const surfaceFiles = "Surfaces (*.vtp *.vtk *.obj *.ply *.stl *.off *.gltf *.glb)";

/// Edges along which the faces of a file differ.
const std::array<std::pair<const char*, wirewarp::SeamSource>, 3> seamSources{
  { { "Where the texture breaks (UV)", wirewarp::SeamSource::Textures },
    { "Between materials", wirewarp::SeamSource::Materials },
    { "Between objects or groups", wirewarp::SeamSource::Groups } }
};

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
    case vtkFeatureCurveWidget::FREEHAND:
    case vtkFeatureCurveWidget::CLOSE:
    case vtkFeatureCurveWidget::JOIN:
    case vtkFeatureCurveWidget::OFFSET:
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

}

//------------------------------------------------------------------------------
QAction* EditorWindow::addAction(
  QMenu* menu, const QString& name, const QString& key, void (EditorWindow::*run)())
{
  QAction* const action = menu->addAction(name);
  action->setShortcut(QKeySequence(key));
  action->setIconText(name + "  [" + key + "]");
  QObject::connect(action, &QAction::triggered, [this, run] { (this->*run)(); });
  return action;
}

//------------------------------------------------------------------------------
void EditorWindow::makeFileMenu()
{
  QMenu* const menu = this->menuBar()->addMenu("&File");
  this->addAction(menu, "Open surface...", "Ctrl+O", &EditorWindow::askSurface);
  QAction* const open =
    this->addAction(menu, "Open curves...", "Ctrl+Shift+O", &EditorWindow::askCurves);
  QMenu* const seams = menu->addMenu("Seams from faces");
  for (const auto& [words, source] : seamSources)
  {
    QAction* const action = seams->addAction(words);
    action->setShortcut(QKeySequence("Ctrl+" + QString::number(seams->actions().size())));
    QObject::connect(action, &QAction::triggered, [this, source = source] {
      if (this->mayForgetCurves())
      {
        this->takeSeams(source);
      }
    });
  }
  QAction* const save = this->addAction(menu, "Save curves...", "Ctrl+S", &EditorWindow::askSave);
  QAction* const surface =
    this->addAction(menu, "Save surface...", "Ctrl+Shift+S", &EditorWindow::askSaveSurface);
  menu->addSeparator();
  QAction* const pattern =
    this->addAction(menu, "Export pattern...", "Ctrl+E", &EditorWindow::askPattern);
  this->addAction(menu, "Pattern options...", "Ctrl+Shift+E", &EditorWindow::askPatternOptions);
  this->SurfaceActions = { open, seams->menuAction(), save, surface, pattern };
  this->BarActions = { save, pattern };
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
    QList<QKeySequence> keys{ key };
    if (id == vtkFeatureCurveWidget::FINISH)
    {
      keys.append(QKeySequence("Escape"));
    }
    action->setShortcuts(keys);
    action->setCheckable(isSwitch(id));
    action->setIconText(action->text() + "  [" + key.toString() + "]");
    QObject::connect(action, &QAction::triggered, [this, id] {
      this->Hand->Do(id);
      this->followChoice();
    });
    this->HandActions[static_cast<std::size_t>(id)] = action;
  }
  this->OffsetAction =
    this->addAction(curve, "Offset by a distance...", "Ctrl+L", &EditorWindow::askOffset);
}

//------------------------------------------------------------------------------
void EditorWindow::makeProposalMenu(QVBoxLayout* side)
{
  QMenu* const menu = this->menuBar()->addMenu("&Proposals");
  this->SurfaceActions.push_back(
    this->addAction(menu, "Propose cuts", "F6", &EditorWindow::askProposals));
  this->Proposed = new ProposalBox(menu);
  side->insertWidget(1, this->Proposed);
  this->connectProposals();
}

//------------------------------------------------------------------------------
void EditorWindow::makeViewMenu()
{
  QMenu* const menu = this->menuBar()->addMenu("&View");
  auto* const group = new QActionGroup(this);
  // Those of threads show what they can where there is a material.
  std::vector<figures::Coloring> colorings(figures::colorings.begin(), figures::colorings.end());
  colorings.insert(
    colorings.end(), figures::threadColorings.begin(), figures::threadColorings.end());
  colorings.push_back(figures::Coloring::Strain);
  for (std::size_t k = 0; k < colorings.size(); ++k)
  {
    const figures::Coloring coloring = colorings[k];
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
  for (const auto& [name, key, axis] : { std::tuple("From the front", "F2", 0),
         std::tuple("From the side", "F4", 1), std::tuple("From above", "F5", 2) })
  {
    QAction* const action = menu->addAction(name);
    action->setShortcut(QKeySequence(key));
    QObject::connect(action, &QAction::triggered, [this, axis = axis] { this->lookAlong(axis); });
  }
}

//------------------------------------------------------------------------------
void EditorWindow::makeBar()
{
  auto* const bar = new QToolBar("Curves");
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  for (const QAction* entry : this->menuBar()->actions())
  {
    if (entry->text() == "&File")
    {
      bar->addAction(
        entry->menu()->actions().front()); // without a surface nothing else can be done
      bar->addSeparator();
    }
    else if (entry->text() == "&Edit" || entry->text() == "&Curve")
    {
      bar->addActions(entry->menu()->actions());
      bar->addSeparator();
    }
    else if (entry->text() == "&Proposals")
    {
      bar->addAction(entry->menu()->actions().front()); // the others are on the box's buttons
    }
  }
  bar->addSeparator();
  for (QAction* const action : this->BarActions)
  {
    bar->addAction(action);
  }
  this->addToolBar(Qt::LeftToolBarArea, bar);
}

//------------------------------------------------------------------------------
std::string EditorWindow::askOpen(const QString& title, const QString& kinds)
{
  const QString file = this->mayForgetCurves()
    ? QFileDialog::getOpenFileName(this, title, this->Folder, kinds)
    : QString();
  if (!file.isEmpty())
  {
    this->Folder = QFileInfo(file).absolutePath();
  }
  return file.toStdString();
}

//------------------------------------------------------------------------------
void EditorWindow::askSurface()
{
  const std::string file = this->askOpen("Open surface", surfaceFiles);
  if (!file.empty())
  {
    this->openSurface(file);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askCurves()
{
  const std::string file =
    this->askOpen("Open curves", "Curves (*.vtp *.vtk *.obj *.csv *.dxf *.txt)");
  if (!file.empty())
  {
    this->openCurves(file);
  }
}

//------------------------------------------------------------------------------
std::string EditorWindow::askFile(const QString& title, const QString& name, const QString& kinds)
{
  QString file =
    QFileDialog::getSaveFileName(this, title, QDir(this->Folder).filePath(name), kinds);
  if (!file.isEmpty())
  {
    this->Folder = QFileInfo(file).absolutePath();
  }
  const QString extension = QFileInfo(file).suffix().toLower();
  if (file.isEmpty() ||
    (!extension.isEmpty() &&
      kinds.contains(QRegularExpression("\\*\\." + QRegularExpression::escape(extension) + "\\b"))))
  {
    return file.toStdString();
  }
  // The dialog has asked about the name that was typed, not about this one.
  file += "." + QFileInfo(name).suffix();
  const bool taken = QFileInfo::exists(file);
  return taken &&
      QMessageBox::question(this, title, file + " exists. Replace it?",
        QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes
    ? std::string()
    : file.toStdString();
}

//------------------------------------------------------------------------------
void EditorWindow::askSave()
{
  const std::string file = this->askFile(
    "Save curves", QString::fromStdString(this->Name + "_curves.vtp"), "Curves (*.vtp)");
  if (!file.empty())
  {
    this->saveCurves(file);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askSaveSurface()
{
  const std::string file =
    this->askFile("Save surface", QString::fromStdString(this->Name + ".vtp"), "Surfaces (*.vtp)");
  if (!file.empty())
  {
    this->saveSurface(file);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askPattern()
{
  const std::string file = this->askFile("Export pattern",
    QString::fromStdString(this->Name + ".pdf"), "Patterns (*.pdf *.svg *.dxf *.plt *.json)");
  if (!file.empty())
  {
    this->savePattern(file);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askPatternOptions()
{
  std::set<std::string> curves{ "boundary" };
  PieceEases eases;
  for (int k = 0; k < this->Curves->GetNumberOfCurves(); ++k)
  {
    const std::string name = this->Curves->GetCurveName(k);
    curves.insert(name);
    eases[name] = { this->Curves->GetCurveEase(k), this->Curves->GetCurveEasedPiece(k) };
  }
  PatternDialog dialog(this->Pattern, eases, curves, this);
  if (dialog.exec() == QDialog::Accepted)
  {
    const int before = this->Curves->GetNumberOfCommands();
    eases = dialog.eases();
    for (int k = 0; k < this->Curves->GetNumberOfCurves(); ++k)
    {
      const PieceEase ease = eases[this->Curves->GetCurveName(k)];
      if (ease.fraction != this->Curves->GetCurveEase(k) ||
        ease.piece != this->Curves->GetCurveEasedPiece(k))
      {
        this->Curves->SetCurveEase(k, ease.fraction, ease.piece);
      }
    }
    this->Curves->JoinCommandsSince(before);
  }
}

//------------------------------------------------------------------------------
void EditorWindow::askPicture()
{
  const std::string file =
    this->askFile("Save picture", QString::fromStdString(this->Name + ".png"), "Pictures (*.png)");
  if (!file.empty())
  {
    this->savePicture(file);
  }
}
}
