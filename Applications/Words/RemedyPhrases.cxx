// SPDX-License-Identifier: BSD-3-Clause
#include "RemedyPhrases.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

namespace wirewarp
{
namespace
{
std::vector<Remedy> inPairs(vtkStringArray* names, vtkStringArray* subjects)
{
  std::vector<Remedy> remedies;
  for (vtkIdType k = 0; k < names->GetNumberOfValues(); ++k)
  {
    remedies.push_back({ names->GetValue(k), subjects->GetValue(k) });
  }
  return remedies;
}
}

//------------------------------------------------------------------------------
std::string phraseOf(const RemedyPhrases& own, const std::string& name)
{
  for (const RemedyPhrase& phrase : own)
  {
    if (name == phrase.remedy)
    {
      return phrase.words;
    }
  }
  const char* const filters = vtkFlatteningAlgorithm::GetRemedyWords(name.c_str());
  return filters ? filters : "";
}

//------------------------------------------------------------------------------
std::string describe(
  const std::string& defect, const std::vector<Remedy>& remedies, const RemedyPhrases& own)
{
  std::string text = defect;
  const char* join = "; ";
  for (const Remedy& remedy : remedies)
  {
    std::string way = phraseOf(own, remedy.name);
    const std::size_t at = way.find('%');
    if (!way.empty())
    {
      text += join + (at == std::string::npos ? way : way.replace(at, 1, remedy.subject));
      join = ", or ";
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<Remedy> remediesOf(const vtkFlatteningAlgorithm* filter)
{
  return inPairs(filter->GetStatusRemedies(), filter->GetStatusRemedySubjects());
}

//------------------------------------------------------------------------------
std::vector<Remedy> remediesOf(const vtkPatternWriter* writer)
{
  return inPairs(writer->GetStatusRemedies(), writer->GetStatusRemedySubjects());
}
}
