// SPDX-License-Identifier: BSD-3-Clause
#include "ClickStyle.h"

#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>

namespace viewer
{
namespace
{
constexpr int stillHand = 3; // pixels that a click may move
}

vtkStandardNewMacro(ClickStyle);

//------------------------------------------------------------------------------
void ClickStyle::OnLeftButtonDown()
{
  const int* const pressed = this->Interactor->GetEventPosition();
  this->Pressed = { pressed[0], pressed[1] };
  this->FindPokedRenderer(this->Pressed[0], this->Pressed[1]);
  if (this->CurrentRenderer && this->CurrentRenderer == this->plane)
  {
    this->GrabFocus(this->EventCallbackCommand);
    this->StartPan();
    return;
  }
  this->Superclass::OnLeftButtonDown();
}

//------------------------------------------------------------------------------
void ClickStyle::OnLeftButtonUp()
{
  this->Superclass::OnLeftButtonUp();
  const int* const place = this->Interactor->GetEventPosition();
  if (std::abs(place[0] - this->Pressed[0]) <= stillHand &&
    std::abs(place[1] - this->Pressed[1]) <= stillHand)
  {
    this->onClick(place[0], place[1]);
  }
}

//------------------------------------------------------------------------------
void ClickStyle::OnChar()
{
  // Instead of VTK's own keys.
  this->onKey(std::string(1, this->Interactor->GetKeyCode()));
}
}
