// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Editing/DerivedCurves.h"
#include "Editing/DrawingSurface.h"
#include "Editing/EditedCurve.h"

namespace flattening
{
/// Draws and changes curves on a surface, command by command, each of which can be undone.
///
/// A command that is refused changes nothing. Curves and nodes are counted from 0; a curve whose
/// last node goes, goes. Curves keep their order, and a new one is the last. There is no bound to
/// how far back undo() goes; a state shares the curves that an edit leaves as they are with the one
/// before.
///
/// Errors of all commands: InvalidOption (no such curve, node or segment, or a value out of range);
/// those of drawSegment(); OutOfMemory.
class CurveEditor
{
public:
  explicit CurveEditor(std::shared_ptr<const DrawingSurface> surface);

  const DrawingSurface& surface() const { return *this->Surface; }
  const CurveSet& state() const { return this->Present; }
  std::size_t curveCount() const { return this->state().curves.size(); }
  const EditedCurve& curve(std::size_t c) const { return *this->state().curves[c]; }

  /// Forgets everything, the past as well, and starts with these curves; their kinds, where they
  /// are too few, are Geodesic. What they hold of segments are hints.
  Status restart(const std::vector<EditedCurve>& curves, const std::optional<MirrorPlane>& mirror);

  /// Adds a curve; its segments are drawn. Without a name, or with one that is taken, it gets
  /// another.
  Status add(EditedCurve curve);
  /// Several at once, or none.
  Status addAll(std::vector<EditedCurve> curves);
  Status remove(std::size_t c);
  /// \param node the number that the node gets; behind the last one: the curve goes on
  /// \param kind of the segments to its neighbours
  Status insertNode(std::size_t c, std::size_t node, const SurfacePoint& point, SegmentKind kind);
  Status moveNode(std::size_t c, std::size_t node, const SurfacePoint& point);
  Status removeNode(std::size_t c, std::size_t node);
  /// Closed, it runs from the last node to the first; from three nodes on.
  Status setClosed(std::size_t c, bool closed);
  /// At an inner node in two; a closed curve opens there.
  Status split(std::size_t c, std::size_t node);
  /// Appends the second curve to the first, both open, where they are nearest to each other; the
  /// second goes. A curve joined with itself is closed.
  Status join(std::size_t first, std::size_t second);
  /// Adds the curve's image in the mirror plane as a curve of its own.
  Status addImage(std::size_t c);
  /// Adds the curve at a distance from one, as offsetPath() has it, with its type and traits;
  /// several where the boundary interrupts it. \param distance positive: on the left
  Status addOffset(std::size_t c, double distance);
  /// Pulls a closed curve tight, as tightCurve() has it; its nodes are others then.
  Status tighten(std::size_t c);
  /// Adds a curve along a stroke by hand, as strokeCurve() has it.
  Status addStroke(const std::vector<SurfacePoint>& stroke, double tolerance,
    SegmentKind kind = SegmentKind::Spline);
  Status setKind(std::size_t c, std::size_t segment, SegmentKind kind);
  /// Another name, type, shape, tolerance, or with an image in the mirror.
  Status describe(std::size_t c, const CurveTraits& traits);
  /// The plane of mirrored curves; without one they have no image.
  Status setMirror(const std::optional<MirrorPlane>& mirror);

  bool canUndo() const { return !this->Past.empty(); }
  bool canRedo() const { return !this->Future.empty(); }
  void undo() { this->takeLast(this->Past, this->Future); }
  void redo() { this->takeLast(this->Future, this->Past); }
  /// Until the end of the group all commands are undone as one, such as the moves of a drag.
  void beginGroup() { this->Grouped = Group::Begun; }
  void endGroup() { this->Grouped = Group::None; }
  /// How many commands undo() can take back.
  std::size_t commandCount() const { return this->Past.size(); }
  /// Joins all commands after the first `count` into one step of undo, or none where nothing
  /// changed: for a group that is known as one only when it ends, such as the nodes of a curve,
  /// which are undone one by one while it is drawn.
  void joinSince(std::size_t count);

private:
  enum class Group
  {
    None,
    Begun,  ///< nothing was pushed yet
    Pushed, ///< the next state takes the present one's place
  };

  /// The next state; what was undone is forgotten. Within a group it takes the place of the
  /// group's last.
  void push(CurveSet next);
  /// Makes the last of some states the present one, which becomes the last of others.
  void takeLast(std::vector<CurveSet>& from, std::vector<CurveSet>& to);
  Status replace(std::size_t c, EditedCurve changed);
  void put(std::size_t c, EditedCurve drawn);
  Status checkCurve(std::size_t c) const;
  Status checkNode(std::size_t c, std::size_t node) const;
  Status addDerived(DerivedCurves derived);

  std::shared_ptr<const DrawingSurface> Surface;
  std::vector<CurveSet> Past;
  CurveSet Present;
  std::vector<CurveSet> Future; ///< the next one last
  Group Grouped = Group::None;
};
}
