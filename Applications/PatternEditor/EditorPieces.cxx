// SPDX-License-Identifier: BSD-3-Clause
// How the flat pieces of EditorWindow follow the curves and the cloth.
#include "EditorWindow.h"

#include "PatternPicture.h"
#include "StraightCorners.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QApplication>

#include <algorithm>

namespace editor
{
namespace
{
// Seconds. Pieces that come later would be behind the mouse, drafts that come later no help.
constexpr double quick = 0.040;
constexpr double quickDraft = 0.5;
/// What comes sooner is not announced: it would flicker.
constexpr double soon = 0.1;
constexpr std::size_t tableRows = 6;
}

void EditorWindow::followCurves()
{
  this->followChoice();
  if (!this->Surface)
  {
    return;
  }
  this->tell("", false);
  this->followSaving();
  const bool atOnce = this->Live->seconds(Care::Full) < quick;
  if (atOnce || this->Live->seconds(Care::Draft) < quickDraft)
  {
    this->askForPieces(atOnce ? Care::Full : Care::Draft);
  }
  if (!atOnce)
  {
    this->Rest->start();
  }
  this->expectPieces();
}

void EditorWindow::askForPieces(Care care)
{
  this->Rest->stop();
  vtkNew<vtkPolyData> curves;
  this->Curves->GetCurves(curves);
  this->Live->ask(curves, care);
}

void EditorWindow::customEvent(QEvent*)
{
  this->takePieces();
}

void EditorWindow::takePieces()
{
  if (this->Live->take())
  {
    // What something else has said stays where there is nothing new to say.
    std::string words = this->Live->message();
    const std::string corners = words.empty() ? "" : cornersOfStraightKeys(this->Curves);
    words = corners.empty() ? words : corners;
    if (!words.empty() || this->Message->text().toStdString() == this->Broken)
    {
      this->tell(words, true);
    }
    this->Broken = words;
    this->Late->stop();
    this->Behind = this->Live->isRefused();
    this->showResult();
    if (this->Live->isBusy()) // with what was changed since
    {
      this->expectPieces();
    }
  }
}

void EditorWindow::waitForPieces()
{
  if (this->Rest->isActive())
  {
    this->askForPieces(Care::Full);
  }
  QApplication::setOverrideCursor(Qt::WaitCursor);
  while (this->Live->isBusy())
  {
    QApplication::processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
    this->takePieces();
  }
  QApplication::restoreOverrideCursor();
}

void EditorWindow::expectPieces()
{
  const double full = this->Live->seconds(Care::Full);
  const double draft = this->Live->seconds(Care::Draft);
  const double expected = full < quick || draft >= quickDraft ? full : draft;
  if (expected > soon)
  {
    this->showBehind();
  }
  else if (!this->Behind && !this->Late->isActive())
  {
    this->Late->start();
  }
}

void EditorWindow::showBehind()
{
  this->Late->stop();
  this->Behind = true;
  this->showMeasures();
  if (this->Live->hasResult() && !this->PlaneScene.isDim())
  {
    this->PlaneScene.dim(true);
    this->PlaneWidget->renderWindow()->Render();
  }
}

void EditorWindow::showMeasures()
{
  QString table;
  if (this->Live->hasResult())
  {
    for (const std::string& row : figures::errorTable(this->Live->result(), tableRows))
    {
      table += QString::fromStdString(row) + "\n";
    }
    table = table.trimmed();
    table += this->Behind && this->isWaiting() ? "   (of before; recomputing...)"
      : this->Behind                           ? "   (of before: what is there now is rejected)"
      : this->Live->care() == Care::Draft      ? "   (draft)"
                                               : "";
  }
  else if (this->Behind && this->isWaiting())
  {
    table = "flattening...";
  }
  this->Measures->setEnabled(!this->Behind); // grey
  this->Measures->setText(table);
  this->Readout->setEnabled(!this->Behind);
}

void EditorWindow::showResult()
{
  this->showMeasures();
  if (!this->Live->hasResult())
  {
    return;
  }
  const figures::Coloring coloring = this->shownColoring();
  const figures::FlatPiece piece = coloring == figures::Coloring::Strain
    ? figures::withStrain(this->Live->result())
    : this->Live->result();
  this->SpaceScene.color(piece, coloring);
  this->PlaneScene.show(piece, coloring);
  this->PlaneScene.dim(this->Behind);
  this->Reader.setPiece(this->PlaneScene.shown());
  this->SpaceWidget->renderWindow()->Render();
  this->PlaneWidget->renderWindow()->Render();
}

void EditorWindow::makeCloth(QVBoxLayout* side)
{
  side->insertWidget(1, this->Cloth);
  this->Readout->setWordWrap(true);
  this->Readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  this->Cloth->onChange = [this] { this->followCloth(); };
  this->PlaneWidget->interactor()->AddObserver(
    vtkCommand::MouseMoveEvent, this, &EditorWindow::readPlane);
}

void EditorWindow::followCloth()
{
  const bool changed = this->Live->setCloth(this->Cloth->material(), this->Cloth->grain());
  if (this->Surface && changed)
  {
    this->askForPieces(Care::Full);
    this->expectPieces();
  }
}

figures::Coloring EditorWindow::shownColoring() const
{
  const auto& threads = figures::threadColorings;
  const bool ofThreads = std::find(threads.begin(), threads.end(), this->Coloring) != threads.end();
  vtkPolyData* const flat = this->Live->result().flat;
  return ofThreads && !(flat && flat->GetCellData()->HasArray("StrainWarp"))
    ? figures::Coloring::Homogeneity
    : this->Coloring;
}

void EditorWindow::readPlane()
{
  const int* const at = this->PlaneWidget->interactor()->GetEventPosition();
  this->Readout->setText(QString::fromStdString(this->Reader.at(this->Plane, at[0], at[1])));
}
}
