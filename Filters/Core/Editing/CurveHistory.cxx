// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveHistory.h"

namespace flattening
{
void CurveHistory::push(CurveSet next)
{
  if (this->Grouped != Group::Pushed)
  {
    this->Past.push_back(this->Present);
  }
  if (this->Grouped == Group::Begun)
  {
    this->Grouped = Group::Pushed;
  }
  this->Future.clear();
  this->Present = std::move(next);
}

void CurveHistory::undo()
{
  if (this->canUndo())
  {
    this->endGroup();
    this->Future.push_back(this->Present);
    this->Present = std::move(this->Past.back());
    this->Past.pop_back();
  }
}

void CurveHistory::redo()
{
  if (this->canRedo())
  {
    this->endGroup();
    this->Past.push_back(this->Present);
    this->Present = std::move(this->Future.back());
    this->Future.pop_back();
  }
}

void CurveHistory::beginGroup()
{
  this->Grouped = Group::Begun;
}

void CurveHistory::joinSince(std::size_t depth)
{
  this->endGroup();
  if (depth < this->Past.size())
  {
    this->Past.resize(depth + 1);
    if (identical(this->Past.back(), this->Present))
    {
      this->Past.pop_back();
    }
  }
}
}
