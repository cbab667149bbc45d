// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FieldRows.h"

#include <string>
#include <vector>

class vtkFlatteningAlgorithm;

namespace wirewarp
{
/// A way out of a defect as the filters name it.
struct Remedy
{
  std::string name;
  std::string subject; ///< what it is to be applied to; may be empty
};

/// How the command says the remedy of a name: with its options; % stands for the subject.
std::string remedyWords(const std::string& name);

/// A defect and its ways out.
std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies);

/// The ways out that a filter found for its last run, and the report's for one piece.
std::vector<Remedy> remediesOf(const vtkFlatteningAlgorithm* filter);
std::vector<Remedy> remediesOf(const FieldRows& field, vtkIdType piece);
}
