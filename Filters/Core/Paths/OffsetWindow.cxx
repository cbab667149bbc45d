// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetWindow.h"

#include <algorithm>

namespace flattening
{
OffsetWindow OffsetWindow::moved(const FlatTriangle::Motion& motion) const
{
  OffsetWindow window = *this;
  window.apex = motion.place(this->apex);
  window.right = motion.place(this->right);
  window.rightWay = motion.direction(this->rightWay);
  window.left = motion.place(this->left);
  window.leftWay = motion.direction(this->leftWay);
  window.normal = motion.direction(this->normal);
  return window;
}

OffsetWindow OffsetWindow::between(const Point2& rightEnd, const Point2& leftEnd) const
{
  const auto way = [this](const Point2& end) {
    return this->strip ? this->normal : Point2((end - this->apex).normalized());
  };
  OffsetWindow window = *this;
  if (this->besideRight(rightEnd) > 0.0)
  {
    window.right = rightEnd;
    window.rightWay = way(rightEnd);
  }
  if (this->besideLeft(leftEnd) > 0.0)
  {
    window.left = leftEnd;
    window.leftWay = way(leftEnd);
  }
  return window;
}

SegmentPart clipped(SegmentPart part, double atStart, double atEnd)
{
  if (atStart < 0.0 && atEnd < 0.0)
  {
    return { 1.0, 0.0 };
  }
  if (atStart < 0.0)
  {
    part.from = std::max(part.from, atStart / (atStart - atEnd));
  }
  else if (atEnd < 0.0)
  {
    part.to = std::min(part.to, atStart / (atStart - atEnd));
  }
  return part;
}
}
