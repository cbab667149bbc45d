// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Editing/EditedCurve.h"

namespace flattening
{
/// The states of a set of curves, with no bound to how far back they go. A state shares the curves
/// that an edit leaves as they are with the one before.
class CurveHistory
{
public:
  explicit CurveHistory(CurveSet first = {})
    : Present(std::move(first))
  {
  }

  const CurveSet& present() const { return this->Present; }
  bool canUndo() const { return !this->Past.empty(); }
  bool canRedo() const { return !this->Future.empty(); }

  /// The next state; what was undone is forgotten. Within a group it takes the place of the
  /// group's last.
  void push(CurveSet next);
  void undo();
  void redo();
  /// Until the end of the group all edits are undone as one, such as the moves of a drag.
  void beginGroup();
  void endGroup() { this->Grouped = Group::None; }
  /// How many edits undo() can take back.
  std::size_t depth() const { return this->Past.size(); }
  /// What was pushed since there were so many is undone as one from now on, and not at all where it
  /// came to nothing.
  void joinSince(std::size_t depth);

private:
  enum class Group
  {
    None,
    Begun,  ///< nothing was pushed yet
    Pushed, ///< the next state takes the present one's place
  };

  std::vector<CurveSet> Past;
  CurveSet Present;
  std::vector<CurveSet> Future; ///< the next one last
  Group Grouped = Group::None;
};
}
