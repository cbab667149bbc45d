// SPDX-License-Identifier: BSD-3-Clause
// What EditorWindow has to do with cloth: which it is, and what it does at the mouse.
#include "EditorWindow.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>

namespace editor
{
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
