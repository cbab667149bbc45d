// SPDX-License-Identifier: BSD-3-Clause
#include "VtkRemedies.h"

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
