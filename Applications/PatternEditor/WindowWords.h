// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

class vtkFlatteningAlgorithm;
class vtkPatternWriter;

namespace editor
{
/// How the window says the way out of a name: with what is on the screen; % stands for the subject.
/// Empty where the window has nothing for it.
std::string remedyWords(const std::string& name);

/// What the last run says, in these words: the defect, and the ways out that the window has.
std::string messageOf(const vtkFlatteningAlgorithm* filter);
std::string messageOf(const vtkPatternWriter* writer);
/// That a pattern is written, and what the writer has to say of it.
std::string savedWords(const std::string& path, vtkPatternWriter* writer);
}
