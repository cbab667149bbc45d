// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfWriter.h"

#include "Formats/PdfDrawing.h"
#include "Formats/PdfLayers.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
namespace
{
std::set<StrokeRole> rolesOf(const Pattern& pattern)
{
  std::set<StrokeRole> roles;
  for (const PatternPiece& piece : pattern.pieces)
  {
    for (const Stroke& stroke : strokesOf(piece))
    {
      roles.insert(stroke.role);
    }
  }
  return roles;
}

/// The name of a role's layer, which is that of SVG.
std::string nameOf(StrokeRole role)
{
  std::string name = styleOf(role).name;
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}
}

Status makePdf(const Pattern& pattern, const PageOptions& options, std::string& pdf)
{
  pdf.clear();
  PagePlan plan;
  Status status = planPages(pattern, options, plan);
  if (!status.ok())
  {
    return status;
  }
  const std::set<StrokeRole> roles = rolesOf(pattern);
  if (!hasPdfLayers())
  {
    return drawPdf(pattern, options.paper, plan, { true, true, roles }, pdf);
  }
  std::vector<PdfLayer> layers;
  const auto add = [&](const std::string& name, const PdfSelection& selection) {
    if (status.ok())
    {
      layers.push_back({ name, {} });
      status = drawPdf(pattern, options.paper, plan, selection, layers.back().pdf);
    }
  };
  add("page marks", { true, false, {} });
  for (const StrokeRole role : roles)
  {
    add(nameOf(role), { false, false, { role } });
  }
  add("text", { false, true, {} });
  return status.ok() ? joinPdfLayers(layers, plan.pages.size(), pdf) : status;
}
}
}
