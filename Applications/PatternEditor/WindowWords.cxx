// SPDX-License-Identifier: BSD-3-Clause
#include "WindowWords.h"

#include "Base/RemedyWords.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

#include <map>
#include <vector>

namespace editor
{
namespace
{
/// Options that the window has. A remedy that needs another one is left out.
std::string spellingOf(const std::string& property, const std::string&)
{
  static const std::map<std::string, std::string> words{ { "CurveType", "by their type" },
    { "Grain", "the grain" }, { "LengthTolerance", "by a tolerance" },
    { "NotchSpacing", "the space of notches in the pattern options" },
    { "Paper", "paper in the pattern options" } };
  const auto found = words.find(property);
  return found == words.end() ? std::string() : found->second;
}

/// \tparam Source a filter or a writer
template <class Source>
std::string describeRun(const Source* source)
{
  std::vector<flattening::NamedRemedy> remedies;
  for (vtkIdType k = 0; k < source->GetStatusRemedies()->GetNumberOfValues(); ++k)
  {
    remedies.push_back(
      { source->GetStatusRemedies()->GetValue(k), source->GetStatusRemedySubjects()->GetValue(k) });
  }
  return flattening::describeDefect(source->GetStatusDefect(), remedies, spellingOf);
}
}

std::string remedyWords(const std::string& name)
{
  return flattening::remedyWords(name, spellingOf);
}

std::string messageOf(const vtkFlatteningAlgorithm* filter)
{
  return describeRun(filter);
}

std::string messageOf(const vtkPatternWriter* writer)
{
  // What the pipeline refuses has no parts.
  return *writer->GetStatusDefect() ? describeRun(writer) : writer->GetErrorMessage();
}

std::string savedWords(const std::string& path, vtkPatternWriter* writer)
{
  std::string words = "saved " + path;
  for (int k = 0; k < writer->GetNumberOfWarnings(); ++k)
  {
    words += "; " + std::string(writer->GetWarning(k));
  }
  // All patterns are smooth unless another tolerance is chosen.
  const bool usual = writer->GetFairTolerance() == vtkNew<vtkPatternWriter>()->GetFairTolerance();
  for (int k = 0; k < writer->GetNumberOfNotes(); ++k)
  {
    const int kind = writer->GetNoteKind(k);
    if (usual && (kind == vtkPatternWriter::SMOOTHED || kind == vtkPatternWriter::LEFT_ROUGH))
    {
      continue;
    }
    words += "; " + std::string(writer->GetNote(k));
  }
  return words;
}
}
