// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveEditor.h"

#include "Base/Memory.h"
#include "Base/Status.h"
#include "Editing/CurveDrawing.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
template <typename Value>
typename std::vector<Value>::iterator at(std::vector<Value>& values, std::size_t k)
{
  return values.begin() + static_cast<std::ptrdiff_t>(k);
}

// What edits make of a curve's nodes and of the kinds of its segments. The segments are those that
// there were, cut and joined: hints to drawCurve(), and empty where there was none.

/// The curve run through the other way round.
EditedCurve reversed(EditedCurve curve)
{
  std::reverse(curve.nodes.begin(), curve.nodes.end());
  std::reverse(curve.kinds.begin(), curve.kinds.end());
  std::reverse(curve.segments.begin(), curve.segments.end());
  for (SurfacePath& segment : curve.segments)
  {
    segment = reversed(std::move(segment));
  }
  return curve;
}

/// One segment that runs as both; none where one of them is none.
SurfacePath together(SurfacePath first, const SurfacePath& second)
{
  if (first.points.empty() || second.points.empty())
  {
    return {};
  }
  append(first, second);
  return first;
}

/// Both parts of a segment, up to the point of it that is nearest to a place, and from there.
std::pair<SurfacePath, SurfacePath> dividedNear(const SurfacePath& segment, const Point3& place)
{
  if (segment.points.empty())
  {
    return {};
  }
  const auto nearest = std::min_element(segment.points.begin(), segment.points.end(),
    [&place](const SurfacePoint& a, const SurfacePoint& b) {
      return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
    });
  const auto middle = static_cast<std::size_t>(nearest - segment.points.begin());
  return { partOf(segment, 0, middle), partOf(segment, middle, segment.points.size() - 1) };
}

/// Three nodes make a loop, and two by a plane section round the surface.
bool canBeClosed(const EditedCurve& curve)
{
  return curve.nodes.size() > 2 ||
    (curve.nodes.size() == 2 && !curve.kinds.empty() &&
      std::all_of(curve.kinds.begin(), curve.kinds.end(),
        [](SegmentKind kind) { return kind == SegmentKind::Section; }));
}

/// Closed or opened between the last node and the first. \pre canBeClosed(curve)
EditedCurve withClosed(EditedCurve curve, bool closed)
{
  if (closed && curve.nodes.front().position == curve.nodes.back().position)
  {
    curve.nodes.pop_back();
  }
  curve.closed = closed;
  curve.kinds.resize(segmentCount(curve.nodes.size(), closed), curve.kinds.back());
  curve.segments.resize(curve.kinds.size());
  return curve;
}

/// \param node the number that the node gets, at most as many as there are
/// \param kind of the segments to its neighbours
EditedCurve withNode(
  EditedCurve curve, std::size_t node, const SurfacePoint& point, SegmentKind kind)
{
  const std::size_t count = curve.nodes.size();
  curve.segments.resize(curve.kinds.size());
  // Before the first node of a closed curve is behind its last.
  const std::size_t place = curve.closed && node == 0 ? count : node;
  curve.nodes.insert(at(curve.nodes, place), point);
  if (curve.closed || (node > 0 && node < count))
  {
    const std::size_t divided = place - 1;
    curve.kinds[divided] = kind;
    curve.kinds.insert(at(curve.kinds, divided), kind);
    auto [before, after] = dividedNear(curve.segments[divided], point.position);
    curve.segments[divided] = std::move(after);
    curve.segments.insert(at(curve.segments, divided), std::move(before));
  }
  else
  {
    const std::size_t end = place == 0 ? 0 : place - 1;
    curve.kinds.insert(at(curve.kinds, end), kind);
    curve.segments.insert(at(curve.segments, end), SurfacePath());
  }
  return curve;
}

/// Opened where too few nodes are left for a loop. \pre There are two nodes or more.
EditedCurve withoutNode(EditedCurve curve, std::size_t node)
{
  const bool inner = curve.closed || (node > 0 && node + 1 < curve.nodes.size());
  curve.nodes.erase(at(curve.nodes, node));
  curve.segments.resize(curve.kinds.size());
  if (!curve.kinds.empty())
  {
    const std::size_t gone = std::min(node, curve.kinds.size() - 1);
    if (inner)
    {
      SurfacePath& before = curve.segments[gone == 0 ? curve.segments.size() - 1 : gone - 1];
      before = together(std::move(before), curve.segments[gone]);
    }
    curve.kinds.erase(at(curve.kinds, gone));
    curve.segments.erase(at(curve.segments, gone));
  }
  if (curve.closed && !canBeClosed(curve))
  {
    curve.closed = false;
    curve.kinds.resize(segmentCount(curve.nodes.size(), false));
    curve.segments.resize(curve.kinds.size());
  }
  return curve;
}

/// A closed curve as an open one that starts and ends at a node.
EditedCurve openedAt(EditedCurve curve, std::size_t node)
{
  std::rotate(curve.nodes.begin(), at(curve.nodes, node), curve.nodes.end());
  std::rotate(curve.kinds.begin(), at(curve.kinds, node), curve.kinds.end());
  curve.segments.resize(curve.kinds.size());
  std::rotate(curve.segments.begin(), at(curve.segments, node), curve.segments.end());
  curve.nodes.push_back(curve.nodes.front());
  curve.closed = false;
  return curve;
}

/// An open curve up to an inner node, and from there.
std::pair<EditedCurve, EditedCurve> dividedAt(const EditedCurve& curve, std::size_t node)
{
  EditedCurve first = curve;
  EditedCurve second = curve;
  first.nodes.resize(node + 1);
  first.kinds.resize(node);
  first.segments.resize(node);
  second.nodes.erase(second.nodes.begin(), at(second.nodes, node));
  second.kinds.erase(second.kinds.begin(), at(second.kinds, node));
  second.segments.resize(curve.kinds.size());
  second.segments.erase(second.segments.begin(), at(second.segments, node));
  return { std::move(first), std::move(second) };
}

/// Two open curves as one, joined where their ends are nearest to each other.
EditedCurve joined(EditedCurve first, EditedCurve second)
{
  const auto gap = [](const SurfacePoint& a, const SurfacePoint& b) {
    return (a.position - b.position).norm();
  };
  const std::array<double, 4> gaps{ gap(first.nodes.back(), second.nodes.front()),
    gap(first.nodes.back(), second.nodes.back()), gap(first.nodes.front(), second.nodes.front()),
    gap(first.nodes.front(), second.nodes.back()) };
  const auto nearest = std::min_element(gaps.begin(), gaps.end()) - gaps.begin();
  first.segments.resize(first.kinds.size());
  second.segments.resize(second.kinds.size());
  first = nearest < 2 ? first : reversed(std::move(first));
  second = nearest % 2 == 0 ? second : reversed(std::move(second));
  if (first.nodes.back().position == second.nodes.front().position)
  {
    second.nodes.erase(second.nodes.begin());
  }
  else
  {
    first.kinds.push_back(SegmentKind::Geodesic);
    first.segments.emplace_back();
  }
  first.nodes.insert(first.nodes.end(), second.nodes.begin(), second.nodes.end());
  first.kinds.insert(first.kinds.end(), second.kinds.begin(), second.kinds.end());
  first.segments.insert(first.segments.end(), second.segments.begin(), second.segments.end());
  return first;
}

/// Of a command that asks for what there is not.
inline Status refusal(const std::string& defect)
{
  return { StatusCode::InvalidOption, defect };
}

/// A command's status, with memory that runs out among them. \param check what it would fail by
template <typename Command>
Status guarded(const Status& check, const Command& command)
{
  return check.ok() ? withinMemory([&command] { return Status(command()); }) : check;
}

Status checkTraits(const CurveTraits& traits)
{
  if (!(traits.tolerance >= 0.0 && traits.tolerance < 1.0))
  {
    return refusal(
      "a curve's tolerance is " + shortNumber(traits.tolerance) + ", which is not in [0, 1)");
  }
  const LengthEase& ease = traits.ease;
  if (!(std::abs(ease.fraction) < 1.0) || ease.piece < none)
  {
    return refusal("a curve's ease is " + shortNumber(ease.fraction) + " in piece " +
      std::to_string(ease.piece) +
      ", which is not a fraction between -1 and 1 in a piece from 0, " + "or in -1");
  }
  return {};
}
}

CurveEditor::CurveEditor(std::shared_ptr<const DrawingSurface> surface)
  : Surface(std::move(surface))
{
}

//------------------------------------------------------------------------------
void CurveEditor::push(CurveSet next)
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

void CurveEditor::takeLast(std::vector<CurveSet>& from, std::vector<CurveSet>& to)
{
  if (!from.empty())
  {
    this->endGroup();
    to.push_back(std::exchange(this->Present, std::move(from.back())));
    from.pop_back();
  }
}

void CurveEditor::joinSince(std::size_t count)
{
  this->endGroup();
  if (count < this->Past.size())
  {
    this->Past.resize(count + 1);
    if (identical(this->Past.back(), this->Present))
    {
      this->Past.pop_back();
    }
  }
}

//------------------------------------------------------------------------------
Status CurveEditor::checkCurve(std::size_t c) const
{
  return c < this->curveCount() ? Status()
                                : refusal("there is no curve " + std::to_string(c) + ", only " +
                                    std::to_string(this->curveCount()));
}

Status CurveEditor::checkNode(std::size_t c, std::size_t node) const
{
  Status status = this->checkCurve(c);
  if (status.ok() && node >= this->curve(c).nodes.size())
  {
    status = refusal("there is no node " + std::to_string(node) + " of curve '" +
      this->curve(c).traits.name + "', only " + std::to_string(this->curve(c).nodes.size()));
  }
  return status;
}

Status CurveEditor::replace(std::size_t c, EditedCurve changed)
{
  Status status = drawCurve(*this->Surface, this->state(), &this->curve(c), changed);
  if (!status.refused())
  {
    this->put(c, std::move(changed));
  }
  return status;
}

void CurveEditor::put(std::size_t c, EditedCurve drawn)
{
  CurveSet next = this->state();
  next.curves[c] = std::make_shared<const EditedCurve>(std::move(drawn));
  this->push(std::move(next));
}

//------------------------------------------------------------------------------
Status CurveEditor::restart(
  const std::vector<EditedCurve>& curves, const std::optional<MirrorPlane>& mirror)
{
  return guarded({}, [&] {
    CurveEditor fresh(this->Surface);
    fresh.Present.mirror = mirror;
    for (EditedCurve curve : curves)
    {
      Status status = fresh.add(std::move(curve));
      if (status.refused())
      {
        return status;
      }
    }
    fresh.Past.clear();
    *this = std::move(fresh);
    return Status();
  });
}

Status CurveEditor::add(EditedCurve curve)
{
  return this->addAll({ std::move(curve) });
}

Status CurveEditor::addAll(std::vector<EditedCurve> curves)
{
  return guarded({}, [&] {
    CurveSet next = this->state();
    Status status;
    for (EditedCurve& curve : curves)
    {
      Status own = checkTraits(curve.traits);
      if (curve.nodes.empty())
      {
        own = refusal("a curve has no node");
      }
      if (!own.ok())
      {
        return own;
      }
      curve.closed = curve.closed && canBeClosed(curve);
      curve.kinds.resize(segmentCount(curve.nodes.size(), curve.closed), SegmentKind::Geodesic);
      curve.traits.name = freeName(next, curve.traits.name);
      own = drawCurve(*this->Surface, next, nullptr, curve);
      if (own.refused())
      {
        return own;
      }
      status = own.ok() ? status : own;
      next.curves.push_back(std::make_shared<const EditedCurve>(std::move(curve)));
    }
    this->push(std::move(next));
    return status;
  });
}

Status CurveEditor::remove(std::size_t c)
{
  return guarded(this->checkCurve(c), [&] {
    CurveSet next = this->state();
    next.curves.erase(at(next.curves, c));
    this->push(std::move(next));
    return Status();
  });
}

//------------------------------------------------------------------------------
Status CurveEditor::insertNode(
  std::size_t c, std::size_t node, const SurfacePoint& point, SegmentKind kind)
{
  return guarded(this->checkCurve(c), [&] {
    const std::size_t count = this->curve(c).nodes.size();
    if (node > count)
    {
      return refusal(
        "a node cannot be number " + std::to_string(node) + " behind " + std::to_string(count));
    }
    return this->replace(c, withNode(this->curve(c), node, point, kind));
  });
}

Status CurveEditor::moveNode(std::size_t c, std::size_t node, const SurfacePoint& point)
{
  return guarded(this->checkNode(c, node), [&] {
    EditedCurve changed = this->curve(c);
    changed.nodes[node] = point;
    return this->replace(c, std::move(changed));
  });
}

Status CurveEditor::removeNode(std::size_t c, std::size_t node)
{
  return guarded(this->checkNode(c, node), [&] {
    if (this->curve(c).nodes.size() == 1)
    {
      return this->remove(c);
    }
    return this->replace(c, withoutNode(this->curve(c), node));
  });
}

//------------------------------------------------------------------------------
Status CurveEditor::setClosed(std::size_t c, bool closed)
{
  return guarded(this->checkCurve(c), [&] {
    const EditedCurve& curve = this->curve(c);
    if (curve.closed == closed)
    {
      return Status();
    }
    if (closed && !canBeClosed(curve))
    {
      return refusal("curve '" + curve.traits.name + "' has " + std::to_string(curve.nodes.size()) +
        " nodes; a closed one has at least 3, or 2 where it is a plane section");
    }
    return this->replace(c, withClosed(curve, closed));
  });
}

Status CurveEditor::setKind(std::size_t c, std::size_t segment, SegmentKind kind)
{
  return guarded(this->checkCurve(c), [&] {
    if (segment >= this->curve(c).kinds.size())
    {
      return refusal("there is no segment " + std::to_string(segment) + " of curve '" +
        this->curve(c).traits.name + "'");
    }
    EditedCurve changed = this->curve(c);
    changed.kinds[segment] = kind;
    changed.segments[segment] = {}; // is no hint to one of another kind
    return this->replace(c, std::move(changed));
  });
}

Status CurveEditor::describe(std::size_t c, const CurveTraits& traits)
{
  return guarded(this->checkCurve(c), [&] {
    Status status = checkTraits(traits);
    if (status.ok() && (traits.name.empty() || nameTaken(this->state(), traits.name, c)))
    {
      status = refusal(traits.name.empty() ? "a curve's name is empty"
                                           : "another curve is called '" + traits.name + "'");
    }
    if (!status.ok())
    {
      return status;
    }
    EditedCurve changed = this->curve(c);
    changed.traits = traits;
    return this->replace(c, std::move(changed));
  });
}

Status CurveEditor::setMirror(const std::optional<MirrorPlane>& mirror)
{
  return guarded({}, [&] {
    CurveSet next;
    next.mirror = mirror;
    for (const auto& curve : this->state().curves)
    {
      EditedCurve changed = *curve;
      Status status = drawCurve(*this->Surface, next, curve.get(), changed);
      if (status.refused())
      {
        return status;
      }
      next.curves.push_back(std::make_shared<const EditedCurve>(std::move(changed)));
    }
    this->push(std::move(next));
    return Status();
  });
}

Status CurveEditor::split(std::size_t c, std::size_t node)
{
  return guarded(this->checkNode(c, node), [&] {
    const EditedCurve& curve = this->curve(c);
    if (curve.closed)
    {
      return this->replace(c, openedAt(curve, node));
    }
    if (node == 0 || node + 1 == curve.nodes.size())
    {
      return refusal("curve '" + curve.traits.name + "' ends at node " + std::to_string(node) +
        "; only inner nodes split it");
    }
    Status status;
    auto [first, second] = dividedAt(curve, node);
    second.traits.name = freeName(this->state(), second.traits.name);
    for (EditedCurve* part : { &first, &second })
    {
      status = drawCurve(*this->Surface, this->state(), &this->curve(c), *part);
      if (status.refused())
      {
        return status;
      }
    }
    CurveSet next = this->state();
    next.curves[c] = std::make_shared<const EditedCurve>(std::move(first));
    next.curves.push_back(std::make_shared<const EditedCurve>(std::move(second)));
    this->push(std::move(next));
    return status;
  });
}

Status CurveEditor::join(std::size_t first, std::size_t second)
{
  const Status check = this->checkCurve(first);
  return guarded(check.ok() ? this->checkCurve(second) : check, [&] {
    if (first == second)
    {
      return this->setClosed(first, true);
    }
    for (const std::size_t c : { first, second })
    {
      if (this->curve(c).closed)
      {
        return refusal(
          "curve '" + this->curve(c).traits.name + "' is closed; only open curves can be joined");
      }
    }
    EditedCurve whole = joined(this->curve(first), this->curve(second));
    Status status = drawCurve(*this->Surface, { {}, this->state().mirror }, nullptr, whole);
    if (!status.refused())
    {
      CurveSet next = this->state();
      next.curves[first] = std::make_shared<const EditedCurve>(std::move(whole));
      next.curves.erase(at(next.curves, second));
      this->push(std::move(next));
    }
    return status;
  });
}

//------------------------------------------------------------------------------
Status CurveEditor::addImage(std::size_t c)
{
  return guarded(this->checkCurve(c), [&] {
    if (!this->state().mirror)
    {
      return refusal("there is no mirror plane");
    }
    EditedCurve image = this->curve(c);
    for (SurfacePoint& node : image.nodes)
    {
      node = imageOf(*this->Surface, this->state(), &this->curve(c), node);
    }
    image.traits.mirrored = false;
    image.traits.ease = easeOfImage(image.traits.ease);
    image.segments.clear();
    return this->add(std::move(image));
  });
}

Status CurveEditor::addOffset(std::size_t c, double distance)
{
  return guarded(this->checkCurve(c),
    [&] { return this->addDerived(offsetCurves(*this->Surface, this->curve(c), distance)); });
}

Status CurveEditor::tighten(std::size_t c)
{
  return guarded(this->checkCurve(c), [&] {
    DerivedCurves tight = tightCurve(*this->Surface, this->curve(c));
    if (tight.status.refused())
    {
      return tight.status;
    }
    EditedCurve changed = std::move(tight.curves.front());
    Status status = drawCurve(*this->Surface, { {}, this->state().mirror }, nullptr, changed);
    if (!status.refused())
    {
      this->put(c, std::move(changed));
    }
    return status.ok() ? tight.status : status;
  });
}

Status CurveEditor::addStroke(
  const std::vector<SurfacePoint>& stroke, double tolerance, SegmentKind kind)
{
  return guarded(
    {}, [&] { return this->addDerived(strokeCurve(*this->Surface, stroke, tolerance, kind)); });
}

Status CurveEditor::addDerived(DerivedCurves derived)
{
  return derived.status.refused() ? derived.status : this->addAll(std::move(derived.curves));
}
}
