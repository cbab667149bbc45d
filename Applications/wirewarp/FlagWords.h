// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FieldRows.h"
#include "RemedyPhrases.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// How the command says the remedy of a name: with its options; % stands for the subject.
std::string remedyWords(const std::string& name);

/// A defect and its ways out.
std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies);

/// The ways out that the report has for one piece.
std::vector<Remedy> remediesOf(const FieldRows& field, vtkIdType piece);
}
