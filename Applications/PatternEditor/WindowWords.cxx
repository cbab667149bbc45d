// SPDX-License-Identifier: BSD-3-Clause
#include "WindowWords.h"

#include "VtkRemedies.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPatternWriter.h>

namespace editor
{
namespace
{
/// Options that the window has. A remedy that needs another one is left out.
constexpr wirewarp::SpellingTable table{
  { "CurveType", "by their type" },
  { "Grain", "the grain" },
  { "LengthTolerance", "by a tolerance" },
  { "NotchSpacing", "the space of notches in the pattern options" },
  { "Paper", "paper in the pattern options" },
};

std::string spellingOf(const std::string& property, const std::string& value)
{
  return wirewarp::findSpelling(table, property, value);
}
}

//------------------------------------------------------------------------------
std::string remedyWords(const std::string& name)
{
  return wirewarp::remedyWords(name, spellingOf);
}

//------------------------------------------------------------------------------
std::string messageOf(const vtkFlatteningAlgorithm* filter)
{
  return wirewarp::describe(filter->GetStatusDefect(), wirewarp::remediesOf(filter), spellingOf);
}

//------------------------------------------------------------------------------
std::string messageOf(const vtkPatternWriter* writer)
{
  const std::string defect = writer->GetStatusDefect();
  // What the pipeline refuses has no parts.
  return defect.empty() ? writer->GetErrorMessage()
                        : wirewarp::describe(defect, wirewarp::remediesOf(writer), spellingOf);
}

//------------------------------------------------------------------------------
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
