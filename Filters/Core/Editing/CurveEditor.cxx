// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveEditor.h"

#include "Base/Memory.h"
#include "Base/Status.h"
#include "Editing/CurveDrawing.h"
#include "Editing/CurveNodes.h"

#include <cmath>
#include <cstddef>
#include <string>

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

namespace
{
/// Of a command that asks for what there is not.
inline Status refusal(const std::string& defect)
{
  return { StatusCode::InvalidOption, defect };
}

/// A command's status, with memory that runs out among them.
template <typename Command>
Status guarded(const Command& command)
{
  struct Outcome
  {
    Status status;
  };
  return withinMemory([&command] { return Outcome{ command() }; }).status;
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
  this->History.push(std::move(next));
}

//------------------------------------------------------------------------------
Status CurveEditor::restart(
  const std::vector<EditedCurve>& curves, const std::optional<MirrorPlane>& mirror)
{
  return guarded([&] {
    CurveEditor fresh(this->Surface);
    CurveSet set;
    set.mirror = mirror;
    fresh.History = CurveHistory(set);
    for (EditedCurve curve : curves)
    {
      Status status = fresh.add(std::move(curve));
      if (status.refused())
      {
        return status;
      }
    }
    this->History = CurveHistory(fresh.state());
    return Status();
  });
}

Status CurveEditor::add(EditedCurve curve)
{
  return this->addAll({ std::move(curve) });
}

Status CurveEditor::addAll(std::vector<EditedCurve> curves)
{
  return guarded([&] {
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
    this->History.push(std::move(next));
    return status;
  });
}

Status CurveEditor::remove(std::size_t c)
{
  return guarded([&] {
    Status status = this->checkCurve(c);
    if (status.ok())
    {
      CurveSet next = this->state();
      next.curves.erase(at(next.curves, c));
      this->History.push(std::move(next));
    }
    return status;
  });
}

//------------------------------------------------------------------------------
Status CurveEditor::insertNode(
  std::size_t c, std::size_t node, const SurfacePoint& point, SegmentKind kind)
{
  return guarded([&] {
    Status status = this->checkCurve(c);
    if (!status.ok())
    {
      return status;
    }
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
  return guarded([&] {
    Status status = this->checkNode(c, node);
    if (!status.ok())
    {
      return status;
    }
    EditedCurve changed = this->curve(c);
    changed.nodes[node] = point;
    return this->replace(c, std::move(changed));
  });
}

Status CurveEditor::removeNode(std::size_t c, std::size_t node)
{
  return guarded([&] {
    Status status = this->checkNode(c, node);
    if (!status.ok())
    {
      return status;
    }
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
  return guarded([&] {
    Status status = this->checkCurve(c);
    if (!status.ok() || this->curve(c).closed == closed)
    {
      return status;
    }
    const EditedCurve& curve = this->curve(c);
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
  return guarded([&] {
    Status status = this->checkCurve(c);
    if (status.ok() && segment >= this->curve(c).kinds.size())
    {
      status = refusal("there is no segment " + std::to_string(segment) + " of curve '" +
        this->curve(c).traits.name + "'");
    }
    if (!status.ok())
    {
      return status;
    }
    EditedCurve changed = this->curve(c);
    changed.kinds[segment] = kind;
    changed.segments[segment] = {}; // is no hint to one of another kind
    return this->replace(c, std::move(changed));
  });
}

Status CurveEditor::describe(std::size_t c, const CurveTraits& traits)
{
  return guarded([&] {
    Status status = this->checkCurve(c);
    status = status.ok() ? checkTraits(traits) : status;
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
  return guarded([&] {
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
    this->History.push(std::move(next));
    return Status();
  });
}

Status CurveEditor::split(std::size_t c, std::size_t node)
{
  return guarded([&] {
    Status status = this->checkNode(c, node);
    if (!status.ok())
    {
      return status;
    }
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
    this->History.push(std::move(next));
    return status;
  });
}

Status CurveEditor::join(std::size_t first, std::size_t second)
{
  return guarded([&] {
    Status status = this->checkCurve(first);
    status = status.ok() ? this->checkCurve(second) : status;
    if (!status.ok())
    {
      return status;
    }
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
    status = drawCurve(*this->Surface, { {}, this->state().mirror }, nullptr, whole);
    if (!status.refused())
    {
      CurveSet next = this->state();
      next.curves[first] = std::make_shared<const EditedCurve>(std::move(whole));
      next.curves.erase(at(next.curves, second));
      this->History.push(std::move(next));
    }
    return status;
  });
}

//------------------------------------------------------------------------------
Status CurveEditor::addImage(std::size_t c)
{
  return guarded([&] {
    Status status = this->checkCurve(c);
    if (!status.ok())
    {
      return status;
    }
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
  return guarded([&] {
    const Status status = this->checkCurve(c);
    return status.ok() ? this->addDerived(offsetCurves(*this->Surface, this->curve(c), distance))
                       : status;
  });
}

Status CurveEditor::tighten(std::size_t c)
{
  return guarded([&] {
    Status status = this->checkCurve(c);
    if (!status.ok())
    {
      return status;
    }
    DerivedCurves tight = tightCurve(*this->Surface, this->curve(c));
    if (tight.status.refused())
    {
      return tight.status;
    }
    EditedCurve changed = std::move(tight.curves.front());
    status = drawCurve(*this->Surface, { {}, this->state().mirror }, nullptr, changed);
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
    [&] { return this->addDerived(strokeCurve(*this->Surface, stroke, tolerance, kind)); });
}

Status CurveEditor::addDerived(DerivedCurves derived)
{
  return derived.status.refused() ? derived.status : this->addAll(std::move(derived.curves));
}
}
