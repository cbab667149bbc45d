// SPDX-License-Identifier: BSD-3-Clause
// What EditorWindow does of its own accord to curves: proposals and offsets.
#include "EditorWindow.h"

#include <vtkRenderWindow.h>

#include <QApplication>
#include <QInputDialog>
#include <QProgressDialog>

#include <functional>

namespace editor
{
namespace
{
const char* const searching = "Looking for cuts and flattening with them";
constexpr int dialogWidth = 420;
const char* const everywhere = "everywhere alike";
}

void EditorWindow::askProposals()
{
  const std::vector<std::string> arrays =
    this->Surface ? weightArrays(this->Surface) : std::vector<std::string>();
  if (arrays.empty())
  {
    this->propose();
    return;
  }
  QStringList choices{ everywhere };
  for (const std::string& name : arrays)
  {
    choices.append(QString::fromStdString(name));
  }
  bool given = false;
  const QString choice = QInputDialog::getItem(this, "Propose cuts",
    "Where distortion matters: everywhere alike, or as an array of the surface says,\n"
    "which has a weight for each triangle, 0 where it does not matter",
    choices, 0, false, &given);
  if (given)
  {
    const int row = choices.indexOf(choice);
    this->propose(row > 0 ? arrays[static_cast<std::size_t>(row - 1)] : std::string());
  }
}

void EditorWindow::propose(const std::string& weights)
{
  if (!this->Surface)
  {
    this->tell("open a surface before asking for proposals", true);
    return;
  }
  // The search does not know how many flattenings it needs.
  QProgressDialog dialog(searching, "Stop", 0, 0, this); // what is found by then stays
  dialog.setWindowModality(Qt::WindowModal);
  dialog.setMinimumDuration(0);
  dialog.setAutoReset(false);
  dialog.setMinimumWidth(dialogWidth);
  dialog.show();
  vtkNew<vtkPolyData> curves;
  this->Curves->GetCurves(curves);
  const auto goOn = [&dialog](const std::string& phase) {
    dialog.setLabelText(QString("%1\n%2").arg(searching).arg(QString::fromStdString(phase)));
    QApplication::processEvents();
    return !dialog.wasCanceled();
  };
  const auto preview = [this](vtkPolyData* lines) {
    this->SpaceScene.showGhosts(lines, lines->GetNumberOfCells());
    this->SpaceWidget->renderWindow()->Render();
  };
  Proposals proposals = editor::propose(this->Surface, curves, weights, goOn, preview);
  dialog.hide();
  std::string words = proposals.stopped ? "the search was stopped"
    : proposals.cuts.empty() && proposals.message.empty()
    ? "the surface lies flat as it is: there is nothing to propose"
    : proposals.message;
  const bool bad = proposals.cuts.empty() && !proposals.stopped && !proposals.message.empty();
  if (!proposals.cuts.empty() && !proposals.mirror.empty())
  {
    words += (words.empty() ? "" : "; ") + std::string("the surface is mirrored across ") +
      proposals.mirror;
  }
  this->Proposed->set(std::move(proposals));
  this->tell(words, bad);
}

void EditorWindow::connectProposals()
{
  this->Proposed->onAccept = [this](const Proposal& proposal) {
    this->Hand->Choose(-1, -1); // ends a curve that is being drawn, which is undone by itself
    const int curve = this->Curves->GetNumberOfCurves();
    if (!accept(proposal, this->Curves))
    {
      this->tell(this->Curves->GetMessage(), true);
      return false;
    }
    this->Hand->Choose(curve, -1);
    return true;
  };
  this->Proposed->onAcceptAll = [this](const std::function<void()>& accept) {
    this->Hand->Choose(-1, -1); // as above
    const int before = this->Curves->GetNumberOfCommands();
    accept();
    this->Curves->JoinCommandsSince(before);
    this->followChoice();
  };
  this->Proposed->onChange = [this] {
    this->SpaceScene.showGhosts(linesOf(this->Proposed->cuts()), this->Proposed->chosen());
    this->SpaceWidget->renderWindow()->Render();
  };
}

bool EditorWindow::addOffset(double distance)
{
  if (this->Hand->IsDrawing())
  {
    this->Hand->Do(vtkFeatureCurveWidget::FINISH);
  }
  const int curve = this->Curves->GetNumberOfCurves();
  const bool done = this->Curves->AddOffset(this->Hand->GetChosenCurve(), distance);
  if (done)
  {
    this->Hand->Choose(curve, -1);
  }
  else
  {
    this->tell(this->Curves->GetMessage(), true);
  }
  return done;
}

void EditorWindow::askOffset()
{
  if (this->Hand->GetChosenCurve() < 0)
  {
    this->tell("choose the curve that the offset is to follow", true);
    return;
  }
  bool given = false;
  const double length = this->Curves->GetCurveLength(this->Hand->GetChosenCurve());
  const double distance = QInputDialog::getDouble(this, "Offset",
    QString("Distance over the surface, in %1; negative: on the other side")
      .arg(this->Unit->currentText()),
    0.05 * length, -1e9, 1e9, 4, &given);
  if (given)
  {
    this->addOffset(distance);
  }
}
}
