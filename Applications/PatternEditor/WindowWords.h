// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

class vtkFlatteningAlgorithm;
class vtkPatternWriter;

namespace editor
{
/// The sentence of a remedy with what is on the screen; % stands for the subject. Empty where the
/// window has no option for it.
std::string remedyWords(const std::string& name);

/// The defect of the last run and the remedies that the window has.
std::string messageOf(const vtkFlatteningAlgorithm* filter);
std::string messageOf(const vtkPatternWriter* writer);
/// That a pattern is written, and what the writer has to say of it.
std::string savedWords(const std::string& path, vtkPatternWriter* writer);
}
