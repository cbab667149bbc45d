// SPDX-License-Identifier: BSD-3-Clause
#include "StatusOutput.h"

#include "FieldArrays.h"
#include "StatusInInput.h"

#include "vtkIdTypeArray.h"

namespace flattening
{
namespace bridge
{
namespace
{
/// {Sewing.Test=PANEL} as Test = PANEL.
std::string remedyWords(const SuggestedRemedy& suggested)
{
  std::string words;
  std::size_t option = std::string::npos; // where the last one begins
  for (const char c : std::string(remedySentence(suggested.remedy)))
  {
    if (c == '{' || c == '}')
    {
      option = c == '{' ? words.size() : std::string::npos;
    }
    else if (c == '.' && option != std::string::npos)
    {
      words.resize(option);
    }
    else if (c == '=' && option != std::string::npos)
    {
      words += " = ";
    }
    else if (c == '%')
    {
      words += suggested.subject;
    }
    else if (c != '[' && c != ']')
    {
      words += c;
    }
  }
  return words;
}
}

std::string inWords(const Status& status)
{
  std::string text = status.message;
  const char* join = "; ";
  for (const SuggestedRemedy& suggested : status.remedies)
  {
    text += join + remedyWords(suggested);
    join = ", or ";
  }
  return text;
}

void writeStatuses(const std::vector<Status>& statuses, vtkFieldData* field)
{
  std::vector<std::string> messages;
  std::vector<vtkIdType> ids;
  std::vector<vtkIdType> pieceOfId;
  std::vector<std::string> remedies;
  std::vector<std::string> subjects;
  std::vector<vtkIdType> pieceOfRemedy;
  for (std::size_t p = 0; p < statuses.size(); ++p)
  {
    messages.push_back(inWords(statuses[p]));
    ids.insert(ids.end(), statuses[p].ids.values.begin(), statuses[p].ids.values.end());
    pieceOfId.resize(ids.size(), static_cast<vtkIdType>(p));
    for (const SuggestedRemedy& suggested : statuses[p].remedies)
    {
      remedies.emplace_back(remedyName(suggested.remedy));
      subjects.push_back(suggested.subject);
      pieceOfRemedy.push_back(static_cast<vtkIdType>(p));
    }
  }
  const std::size_t rows = statuses.size();
  addRows<vtkStringArray>(
    field, "Status", rows, [&](std::size_t row) { return statusName(statuses[row].code); });
  addStrings(field, "StatusMessage", messages);
  addRows<vtkStringArray>(
    field, "StatusDefect", rows, [&](std::size_t row) { return statuses[row].message; });
  addRows<vtkStringArray>(
    field, "StatusIdKind", rows, [&](std::size_t row) { return kindName(statuses[row].ids.kind); });
  const auto addIds = [&](const char* name, const std::vector<vtkIdType>& values) {
    addRows<vtkIdTypeArray>(
      field, name, values.size(), [&](std::size_t row) { return values[row]; });
  };
  addIds("StatusIdPiece", pieceOfId);
  addIds("StatusId", ids);
  addIds("RemedyPiece", pieceOfRemedy);
  addStrings(field, "RemedyName", remedies);
  addStrings(field, "RemedySubject", subjects);
}
}
}
