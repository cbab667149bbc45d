// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PageDrawing.h"

#include <emscripten/val.h>

#include <array>
#include <string>
#include <utility>

namespace flattening::web
{
/// Calls an object of JavaScript with the methods of pattern::PageCanvas; see PageCanvas of the
/// package.
class PageWriter final : public pattern::PageCanvas
{
public:
  explicit PageWriter(emscripten::val object)
    : Object(std::move(object))
  {
  }

  void beginPage(const Point2& paper) override { this->call("beginPage", paper.x(), paper.y()); }
  void endPage() override { this->call("endPage"); }
  void save() override { this->call("save"); }
  void restore() override { this->call("restore"); }
  void translate(const Point2& by) override { this->call("translate", by.x(), by.y()); }
  void scale(double factor) override { this->call("scale", factor); }
  void clip(const Point2& corner, const Point2& extent) override
  {
    this->call("clip", corner.x(), corner.y(), extent.x(), extent.y());
  }
  void pen(const pattern::Color& color, double width, const std::array<double, 4>& dashes) override
  {
    emscripten::val list = emscripten::val::array();
    for (const double dash : dashes)
    {
      if (dash > 0.0)
      {
        list.call<void>("push", dash);
      }
    }
    this->call("pen", color[0], color[1], color[2], width, list);
  }
  void moveTo(const Point2& to) override { this->call("moveTo", to.x(), to.y()); }
  void lineTo(const Point2& to) override { this->call("lineTo", to.x(), to.y()); }
  void curveTo(const Point2& one, const Point2& two, const Point2& to) override
  {
    this->call("curveTo", one.x(), one.y(), two.x(), two.y(), to.x(), to.y());
  }
  void rectangle(const Point2& corner, const Point2& extent) override
  {
    this->call("rectangle", corner.x(), corner.y(), extent.x(), extent.y());
  }
  void closePath() override { this->call("closePath"); }
  void stroke(bool filled) override { this->call("stroke", filled); }
  void text(const std::string& words, const Point2& at, double height, pattern::Anchor anchor,
    double angle) override
  {
    this->call("text", words, at.x(), at.y(), height, static_cast<int>(anchor) / 2.0, angle);
  }

private:
  template <class... Arguments>
  void call(const char* method, const Arguments&... arguments)
  {
    this->Object.call<void>(method, arguments...);
  }

  emscripten::val Object;
};
}
