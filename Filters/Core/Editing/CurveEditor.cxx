// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveEditor.h"

#include "Editing/CommandStatus.h"
#include "Editing/CurveDrawing.h"
#include "Editing/CurveNodes.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace flattening
{
namespace
{
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
}
