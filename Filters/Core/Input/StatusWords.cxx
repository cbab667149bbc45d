// SPDX-License-Identifier: BSD-3-Clause
#include "Input/StatusWords.h"

#include "Options/OptionValues.h"

#include <algorithm>
#include <unordered_set>

namespace flattening
{
namespace
{
const char* nounOf(ElementKind kind)
{
  return kind == ElementKind::Curves ? "cells of the curves"
    : kind == ElementKind::Edges     ? "points"
                                     : kindName(kind);
}
}

std::vector<NamedRemedy> remediesOf(const Status& status)
{
  std::vector<NamedRemedy> remedies;
  for (const SuggestedRemedy& suggested : status.remedies)
  {
    remedies.push_back({ remedyName(suggested.remedy), suggested.subject });
  }
  return remedies;
}

std::string inWords(const Status& status)
{
  return describeDefect(
    status.message, remediesOf(status), [](const std::string& property, const std::string& value) {
      return spelledSetting(property, value, OptionSpelling::Property);
    });
}

const char* kindName(ElementKind kind)
{
  switch (kind)
  {
    case ElementKind::Points:
      return "points";
    case ElementKind::Cells:
      return "cells";
    case ElementKind::Curves:
      return "curves";
    case ElementKind::CurvePoints:
      return "curve points";
    case ElementKind::Edges:
      return "edges";
    default:
      return "";
  }
}

Status inInput(Status status, const std::vector<std::int64_t>& inputId)
{
  ElementIds ids;
  ids.kind = status.ids.kind;
  bool renumbered = false;
  std::unordered_set<std::int64_t> told;
  // An edge is named by both of its ends, or not at all.
  const std::size_t stride = ids.kind == ElementKind::Edges ? 2 : 1;
  for (std::size_t k = 0; k + stride <= status.ids.values.size(); k += stride)
  {
    std::vector<std::int64_t> element;
    for (std::size_t i = k; i < k + stride; ++i)
    {
      const std::int64_t id = status.ids.values[i];
      const bool known = id >= 0 && static_cast<std::size_t>(id) < inputId.size();
      element.push_back(known ? inputId[static_cast<std::size_t>(id)] : -1);
      renumbered = renumbered || element.back() != id;
    }
    const bool whole = *std::min_element(element.begin(), element.end()) >= 0;
    if (whole && (stride > 1 || told.insert(element.front()).second))
    {
      ids.values.insert(ids.values.end(), element.begin(), element.end());
    }
  }
  if (ids.empty())
  {
    ids.kind = ElementKind::None;
  }
  else if (renumbered)
  {
    status.message +=
      std::string(" (in the input: ") + nounOf(ids.kind) + " " + listIds(ids.values) + ")";
  }
  status.ids = std::move(ids);
  return status;
}
}
