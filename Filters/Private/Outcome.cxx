// SPDX-License-Identifier: BSD-3-Clause
#include "Outcome.h"

#include <algorithm>
#include <unordered_set>

namespace flattening
{
namespace bridge
{
Outcome outcomeOf(const Status& status)
{
  return { status.code, status.message, { status.ids.begin(), status.ids.end() } };
}

Outcome outcomeOf(const Status& status, const char* noun, const std::vector<vtkIdType>& inputId)
{
  Outcome outcome{ status.code, status.message, {} };
  bool renumbered = false;
  std::unordered_set<vtkIdType> told;
  for (const Index id : status.ids)
  {
    const bool known = id >= 0 && static_cast<std::size_t>(id) < inputId.size();
    const vtkIdType input = known ? inputId[id] : -1;
    renumbered = renumbered || input != id;
    if (input >= 0 && told.insert(input).second)
    {
      outcome.ids.push_back(input);
    }
  }
  if (renumbered && !outcome.ids.empty())
  {
    constexpr std::size_t most = 5;
    outcome.message += std::string(" (in the input: ") + noun;
    for (std::size_t i = 0; i < std::min(outcome.ids.size(), most); ++i)
    {
      outcome.message += (i ? ", " : " ") + std::to_string(outcome.ids[i]);
    }
    if (outcome.ids.size() > most)
    {
      outcome.message += " and " + std::to_string(outcome.ids.size() - most) + " more";
    }
    outcome.message += ")";
  }
  return outcome;
}
}
}
