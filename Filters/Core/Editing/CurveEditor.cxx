// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveEditor.h"

#include "Base/Memory.h"
#include "Editing/CurveDrawing.h"

#include <algorithm>
#include <array>

namespace flattening
{
namespace
{
Status refusal(const std::string& defect)
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
  return {};
}

/// Three nodes make a loop, and two by a plane section round the surface.
bool canBeClosed(const EditedCurve& curve)
{
  return curve.nodes.size() > 2 ||
    (curve.nodes.size() == 2 && !curve.kinds.empty() &&
      std::all_of(curve.kinds.begin(), curve.kinds.end(),
        [](SegmentKind kind) { return kind == SegmentKind::Section; }));
}

bool samePlace(const SurfacePoint& a, const SurfacePoint& b)
{
  return a.position == b.position;
}

template <typename Value>
typename std::vector<Value>::iterator at(std::vector<Value>& values, std::size_t k)
{
  return values.begin() + static_cast<std::ptrdiff_t>(k);
}

/// The curve run through the other way round.
EditedCurve reversed(EditedCurve curve)
{
  std::reverse(curve.nodes.begin(), curve.nodes.end());
  std::reverse(curve.kinds.begin(), curve.kinds.end());
  curve.segments.clear();
  return curve;
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

bool CurveEditor::nameTaken(const std::string& name, std::size_t except) const
{
  for (std::size_t c = 0; c < this->curveCount(); ++c)
  {
    if (c != except && this->curve(c).traits.name == name)
    {
      return true;
    }
  }
  return false;
}

std::string CurveEditor::freeName(const std::string& wish) const
{
  if (!wish.empty() && !this->nameTaken(wish, this->curveCount()))
  {
    return wish;
  }
  const std::string stem = wish.empty() ? "curve" : wish;
  std::size_t number = wish.empty() ? 1 : 2;
  while (this->nameTaken(stem + " " + std::to_string(number), this->curveCount()))
  {
    ++number;
  }
  return stem + " " + std::to_string(number);
}

Status CurveEditor::replace(std::size_t c, EditedCurve changed)
{
  Status status = drawCurve(*this->Surface, this->state().mirror, &this->curve(c), changed);
  if (!status.refused())
  {
    CurveSet next = this->state();
    next.curves[c] = std::make_shared<const EditedCurve>(std::move(changed));
    this->History.push(std::move(next));
  }
  return status;
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
  return guarded([&] {
    Status status = checkTraits(curve.traits);
    if (curve.nodes.empty())
    {
      status = refusal("a curve has no node");
    }
    if (!status.ok())
    {
      return status;
    }
    curve.closed = curve.closed && canBeClosed(curve);
    curve.kinds.resize(segmentCount(curve.nodes.size(), curve.closed), SegmentKind::Geodesic);
    curve.traits.name = this->freeName(curve.traits.name);
    EditedCurve before = curve; // hints, where it holds segments
    const bool hints = before.segments.size() == before.kinds.size();
    before.nodes.assign(curve.nodes.size(), SurfacePoint());
    status = drawCurve(*this->Surface, this->state().mirror, hints ? &before : nullptr, curve);
    if (!status.refused())
    {
      CurveSet next = this->state();
      next.curves.push_back(std::make_shared<const EditedCurve>(std::move(curve)));
      this->History.push(std::move(next));
    }
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
    EditedCurve changed = this->curve(c);
    const std::size_t count = changed.nodes.size();
    if (node > count)
    {
      return refusal(
        "a node cannot be number " + std::to_string(node) + " behind " + std::to_string(count));
    }
    // Before the first node of a closed curve is behind its last.
    const std::size_t place = changed.closed && node == 0 ? count : node;
    changed.nodes.insert(at(changed.nodes, place), point);
    if (changed.closed || (node > 0 && node < count))
    {
      const std::size_t divided = place - 1;
      changed.kinds[divided] = kind;
      changed.kinds.insert(at(changed.kinds, divided), kind);
    }
    else
    {
      changed.kinds.insert(at(changed.kinds, place == 0 ? 0 : place - 1), kind);
    }
    return this->replace(c, std::move(changed));
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
    EditedCurve changed = this->curve(c);
    if (changed.nodes.size() == 1)
    {
      return this->remove(c);
    }
    changed.nodes.erase(at(changed.nodes, node));
    if (!changed.kinds.empty())
    {
      changed.kinds.erase(at(changed.kinds, std::min(node, changed.kinds.size() - 1)));
    }
    if (changed.closed && !canBeClosed(changed))
    {
      changed.closed = false;
      changed.kinds.resize(segmentCount(changed.nodes.size(), false));
    }
    return this->replace(c, std::move(changed));
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
    EditedCurve changed = this->curve(c);
    if (closed && !canBeClosed(changed))
    {
      return refusal("curve '" + changed.traits.name + "' has " +
        std::to_string(changed.nodes.size()) +
        " nodes; a closed one has at least 3, or 2 where it is a plane section");
    }
    if (closed && samePlace(changed.nodes.front(), changed.nodes.back()))
    {
      changed.nodes.pop_back();
    }
    changed.closed = closed;
    changed.kinds.resize(segmentCount(changed.nodes.size(), closed), changed.kinds.back());
    return this->replace(c, std::move(changed));
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
    EditedCurve first = this->curve(c);
    if (first.closed)
    {
      std::rotate(first.nodes.begin(), at(first.nodes, node), first.nodes.end());
      std::rotate(first.kinds.begin(), at(first.kinds, node), first.kinds.end());
      first.nodes.push_back(first.nodes.front());
      first.closed = false;
      return this->replace(c, std::move(first));
    }
    if (node == 0 || node + 1 == first.nodes.size())
    {
      return refusal("curve '" + first.traits.name + "' ends at node " + std::to_string(node) +
        "; only inner nodes split it");
    }
    EditedCurve second = first;
    first.nodes.resize(node + 1);
    first.kinds.resize(node);
    second.nodes.erase(second.nodes.begin(), at(second.nodes, node));
    second.kinds.erase(second.kinds.begin(), at(second.kinds, node));
    second.traits.name = this->freeName(second.traits.name);
    for (EditedCurve* part : { &first, &second })
    {
      status = drawCurve(*this->Surface, this->state().mirror, &this->curve(c), *part);
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
    EditedCurve joined = this->curve(first);
    EditedCurve other = this->curve(second);
    if (joined.closed || other.closed)
    {
      return refusal("curve '" + (joined.closed ? joined : other).traits.name +
        "' is closed; only open curves can be joined");
    }
    const auto gap = [](const SurfacePoint& a, const SurfacePoint& b) {
      return (a.position - b.position).norm();
    };
    const std::array<double, 4> gaps{ gap(joined.nodes.back(), other.nodes.front()),
      gap(joined.nodes.back(), other.nodes.back()), gap(joined.nodes.front(), other.nodes.front()),
      gap(joined.nodes.front(), other.nodes.back()) };
    const auto nearest = std::min_element(gaps.begin(), gaps.end()) - gaps.begin();
    joined = nearest < 2 ? joined : reversed(std::move(joined));
    other = nearest % 2 == 0 ? other : reversed(std::move(other));
    if (samePlace(joined.nodes.back(), other.nodes.front()))
    {
      other.nodes.erase(other.nodes.begin());
    }
    else
    {
      joined.kinds.push_back(SegmentKind::Geodesic);
    }
    joined.nodes.insert(joined.nodes.end(), other.nodes.begin(), other.nodes.end());
    joined.kinds.insert(joined.kinds.end(), other.kinds.begin(), other.kinds.end());
    status = drawCurve(*this->Surface, this->state().mirror, nullptr, joined);
    if (!status.refused())
    {
      CurveSet next = this->state();
      next.curves[first] = std::make_shared<const EditedCurve>(std::move(joined));
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
      node = this->Surface->pointNear(this->state().mirror->image(node.position));
    }
    image.traits.mirrored = false;
    image.segments.clear();
    return this->add(std::move(image));
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
    return this->replace(c, std::move(changed));
  });
}

Status CurveEditor::describe(std::size_t c, const CurveTraits& traits)
{
  return guarded([&] {
    Status status = this->checkCurve(c);
    status = status.ok() ? checkTraits(traits) : status;
    if (status.ok() && (traits.name.empty() || this->nameTaken(traits.name, c)))
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
      Status status = drawCurve(*this->Surface, mirror, curve.get(), changed);
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
