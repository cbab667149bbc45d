// SPDX-License-Identifier: BSD-3-Clause
// The menus and the bar of EditorWindow.
#include "EditorWindow.h"
#include "FaceSeams.h"
#include "PatternDialog.h"

#include <QActionGroup>
#include <QCompleter>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QRegularExpression>
#include <QStyle>
#include <QToolBar>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
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
  using Widget = vtkFeatureCurveWidget;
  static const std::set<int> switches{ Widget::NEW_CURVE, Widget::FREEHAND, Widget::CLOSE,
    Widget::JOIN, Widget::OFFSET, Widget::MIRROR, Widget::MAKE_ACCESSORY, Widget::MAKE_KEY,
    Widget::MAKE_DART, Widget::MAKE_SEAM, Widget::STRAIGHT_KEY, Widget::GEODESIC, Widget::SECTION,
    Widget::EDGES, Widget::SPLINE, Widget::SNAP };
  return switches.count(action) > 0;
}

/// Signs of vtkFeatureCurveWidget::Actions in their order; the types of curves have squares in
/// their colors.
constexpr std::array<const char*, vtkFeatureCurveWidget::NUMBER_OF_ACTIONS> signs{ "\u270E",
  "\u223F", "\u2713", "\u2296", "\u2715", "\u25CB", "\u25CE", "\u2702", "\u22C8", "\u2225",
  "\u21CB", "\u25A0", "\u25A0", "\u25A0", "\u25A0", "\u2502", "\u2312", "\u25B1", "\u25B3",
  "\u223C", "\u2299", "\u2316", "\u21B6", "\u21B7" };

/// A sign as an icon of the style's size, in a color or that of texts.
QIcon signIcon(const QString& sign, const QWidget& window, const std::optional<QColor>& color = {})
{
  const int size = window.style()->pixelMetric(QStyle::PM_SmallIconSize);
  QPixmap drawn(QSize(size, size) * window.devicePixelRatioF());
  drawn.setDevicePixelRatio(window.devicePixelRatioF());
  drawn.fill(Qt::transparent);
  QPainter painter(&drawn);
  QFont font = window.font();
  font.setPixelSize(size);
  painter.setFont(font);
  painter.setPen(color.value_or(window.palette().color(QPalette::WindowText)));
  painter.drawText(QRect(0, 0, size, size), Qt::AlignCenter, sign);
  return QIcon(drawn);
}

/// The actions of a menu and of those in it that can be pressed now.
void addEnabled(const QList<QAction*>& actions, std::map<QString, QAction*>& found)
{
  for (QAction* const action : actions)
  {
    if (action->menu())
    {
      addEnabled(action->menu()->actions(), found);
    }
    else if (action->isEnabled() && !action->isSeparator())
    {
      found.emplace(action->text() + "  [" + action->shortcut().toString() + "]", action);
    }
  }
}
}

QAction* EditorWindow::addAction(
  QMenu* menu, const QString& name, const QString& key, const std::function<void()>& run)
{
  QAction* const action = menu->addAction(name);
  action->setShortcut(QKeySequence(key));
  action->setIconText(name + "  [" + key + "]");
  QObject::connect(action, &QAction::triggered, run);
  return action;
}

void EditorWindow::makeFileMenu()
{
  QMenu* const menu = this->menuBar()->addMenu("&File");
  this->addAction(menu, "Open surface...", "Ctrl+O",
    [this] { this->askOpen("Open surface", surfaceFiles, &EditorWindow::openSurface); });
  QAction* const open = this->addAction(menu, "Open curves...", "Ctrl+Shift+O", [this] {
    this->askOpen(
      "Open curves", "Curves (*.vtp *.vtk *.obj *.csv *.dxf *.txt)", &EditorWindow::openCurves);
  });
  QMenu* const seams = menu->addMenu("Seams from faces");
  for (const auto& [words, source] : seamSources)
  {
    this->addAction(seams, words, "Ctrl+" + QString::number(seams->actions().size() + 1),
      [this, source = source] {
        if (this->mayForgetCurves())
        {
          this->takeSeams(source);
        }
      });
  }
  QAction* const save =
    this->addAction(menu, "Save curves...", "Ctrl+S", [this] { this->askSave(); });
  QAction* const surface = this->addAction(menu, "Save surface...", "Ctrl+Shift+S", [this] {
    this->askWrite("Save surface", ".vtp", "Surfaces (*.vtp)", &EditorWindow::saveSurface);
  });
  menu->addSeparator();
  QAction* const pattern = this->addAction(menu, "Export pattern...", "Ctrl+E", [this] {
    this->askWrite("Export pattern", ".pdf", "Patterns (*.pdf *.svg *.dxf *.plt *.json)",
      &EditorWindow::savePattern);
  });
  this->addAction(
    menu, "Pattern options...", "Ctrl+Shift+E", [this] { this->askPatternOptions(); });
  this->SurfaceActions = { open, seams->menuAction(), save, surface, pattern };
  this->BarActions = { save, pattern };
  this->addAction(menu, "Save picture...", "Ctrl+P", [this] {
    this->askWrite("Save picture", ".png", "Pictures (*.png)", &EditorWindow::savePicture);
  });
  menu->addSeparator();
  this->addAction(menu, "Quit", "Ctrl+Q", [this] { this->close(); });
}

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
    const int type = id - vtkFeatureCurveWidget::MAKE_ACCESSORY;
    action->setIcon(signIcon(signs[static_cast<std::size_t>(id)], *this,
      type >= 0 && type < 4 ? std::optional(colorOfType(type)) : std::nullopt));
    QObject::connect(action, &QAction::triggered, [this, id] {
      this->Hand->Do(id);
      this->followChoice();
    });
    this->HandActions[static_cast<std::size_t>(id)] = action;
  }
  this->addAction(edit, "Find a command...", "Ctrl+K", [this] { this->askCommand(); });
  this->OffsetAction =
    this->addAction(curve, "Offset by a distance...", "Ctrl+L", [this] { this->askOffset(); });
  this->OffsetAction->setIcon(
    signIcon(signs[static_cast<std::size_t>(vtkFeatureCurveWidget::OFFSET)], *this));
}

void EditorWindow::makeProposalMenu(QVBoxLayout* side)
{
  QMenu* const menu = this->menuBar()->addMenu("&Proposals");
  this->SurfaceActions.push_back(
    this->addAction(menu, "Propose cuts", "F6", [this] { this->askProposals(); }));
  this->Proposed = new ProposalBox(menu);
  side->insertWidget(1, this->Proposed);
  this->connectProposals();
}

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
    QAction* const action =
      this->addAction(menu, QString("Colors: %1").arg(figures::nameOf(coloring)),
        QString::number(k + 1), [this, coloring] {
          this->Coloring = coloring;
          this->showResult();
        });
    action->setCheckable(true);
    action->setChecked(coloring == this->Coloring);
    group->addAction(action);
  }
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): the group's parent deletes it
  QAction* const edges = menu->addAction("Edges of the mesh");
  edges->setShortcut(QKeySequence("W"));
  edges->setCheckable(true);
  QObject::connect(edges, &QAction::triggered, [this](bool shown) {
    this->SpaceScene.setEdges(shown);
    this->showResult();
  });
  this->addAction(menu, "Whole view", "R", [this] { this->resetViews(); });
  for (const auto& [name, key, axis] : { std::tuple("From the front", "F2", 0),
         std::tuple("From the side", "F4", 1), std::tuple("From above", "F5", 2) })
  {
    this->addAction(menu, name, key, [this, axis = axis] { this->lookAlong(axis); });
  }
}

void EditorWindow::makeBar()
{
  auto* const bar = new QToolBar("Curves");
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
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
  bar->addActions({ this->BarActions.begin(), this->BarActions.end() });
  for (QAction* const action : bar->actions())
  {
    const QString words = action->text();
    if (action->icon().isNull() && !action->isSeparator())
    {
      action->setIcon(words.startsWith("Open") ? this->style()->standardIcon(QStyle::SP_DirOpenIcon)
          : words.startsWith("Save")    ? this->style()->standardIcon(QStyle::SP_DialogSaveButton)
          : words.startsWith("Propose") ? signIcon("\u2605", *this)
          : words.startsWith("Export")  ? this->style()->standardIcon(QStyle::SP_FileIcon)
                                        : signIcon("\u2315", *this));
    }
  }
  this->addToolBar(Qt::LeftToolBarArea, bar);
}

void EditorWindow::askCommand()
{
  std::map<QString, QAction*> all;
  addEnabled(this->menuBar()->actions(), all);
  QStringList words;
  for (const auto& [word, action] : all)
  {
    words.append(word);
  }
  QInputDialog dialog(this);
  dialog.setWindowTitle("Find a command");
  dialog.setLabelText("Some letters of a command:");
  dialog.setComboBoxItems(words);
  dialog.setComboBoxEditable(true);
  dialog.setTextValue("");
  if (auto* const box = dialog.findChild<QComboBox*>())
  {
    box->completer()->setCompletionMode(QCompleter::PopupCompletion);
    box->completer()->setFilterMode(Qt::MatchContains);
  }
  const bool accepted = dialog.exec() == QDialog::Accepted;
  const QString typed = dialog.textValue().trimmed();
  const auto found = std::find_if(all.begin(), all.end(),
    [&typed](const auto& entry) { return entry.first.contains(typed, Qt::CaseInsensitive); });
  if (accepted && !typed.isEmpty() && found != all.end())
  {
    found->second->trigger();
  }
}

void EditorWindow::askOpen(
  const QString& title, const QString& kinds, bool (EditorWindow::*open)(const std::string&))
{
  const QString file = this->mayForgetCurves()
    ? QFileDialog::getOpenFileName(this, title, this->Folder, kinds)
    : QString();
  if (!file.isEmpty())
  {
    this->Folder = QFileInfo(file).absolutePath();
    (this->*open)(file.toStdString());
  }
}

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

void EditorWindow::askWrite(const QString& title, const QString& ending, const QString& kinds,
  bool (EditorWindow::*write)(const std::string&))
{
  const std::string file = this->askFile(title, QString::fromStdString(this->Name) + ending, kinds);
  if (!file.empty())
  {
    (this->*write)(file);
  }
}

void EditorWindow::askSave()
{
  this->askWrite("Save curves", "_curves.vtp", "Curves (*.vtp)", &EditorWindow::saveCurves);
}

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
}
