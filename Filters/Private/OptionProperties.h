// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionValues.h"

#include <vtkIndent.h>
#include <vtkObject.h>

#include <ostream>
#include <string>

namespace flattening::bridge
{
/// Sets a number, of a word its place, within the range of its option; below it -1 where the option
/// then follows from the input. NaN stays, which a run refuses. The owner is modified where it is
/// another than before.
void setNumber(vtkObject* owner, OptionValues& values, const char* property, double number);

/// Sets a text, in the same way.
void setText(vtkObject* owner, OptionValues& values, const char* property, const std::string& text);

/// What Get...AsString() returns.
const char* nameOfWord(const OptionValues& values, const char* property);

/// Prints all but lists, one per line.
void print(const OptionValues& values, std::ostream& os, vtkIndent indent);
}
