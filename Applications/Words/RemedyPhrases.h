// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

class vtkFlatteningAlgorithm;
class vtkPatternWriter;

namespace wirewarp
{
/// A way out of a defect as the filters name it.
struct Remedy
{
  std::string name;
  std::string subject; ///< what it is to be applied to; may be empty
};

/// How a program says a remedy; % stands for the subject. Empty where it has nothing for it.
struct RemedyPhrase
{
  const char* remedy;
  const char* words;
};
using RemedyPhrases = std::initializer_list<RemedyPhrase>;

/// The program's own words for a remedy, or those of the filters.
std::string phraseOf(const RemedyPhrases& own, const std::string& name);

/// A defect and those ways out that the program has words for.
std::string describe(
  const std::string& defect, const std::vector<Remedy>& remedies, const RemedyPhrases& own);

/// The ways out that a filter or a writer found for its last run.
std::vector<Remedy> remediesOf(const vtkFlatteningAlgorithm* filter);
std::vector<Remedy> remediesOf(const vtkPatternWriter* writer);
}
