// SPDX-License-Identifier: BSD-3-Clause
// The commands of CurveEditor that make curves of other curves.
#include "Editing/CommandStatus.h"
#include "Editing/CurveDrawing.h"
#include "Editing/CurveEditor.h"
#include "Editing/CurveNodes.h"

#include <cstddef>

namespace flattening
{
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
