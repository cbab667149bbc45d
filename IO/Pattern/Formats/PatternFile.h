// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Formats/FileOptions.h"
#include "Outlines/Pattern.h"
#include "Outlines/PatternSource.h"

namespace flattening::pattern
{
/// "SVG", "Walk", ...
const char* formatName(FileFormat format);

/// What the extension of a path says, in either case; Automatic where it says nothing.
FileFormat formatOf(const std::string& path);

/// The extensions that say a format, for a message: ".svg, .pdf, ...".
std::string knownExtensions();

/// Draws a flattening and makes the file's bytes.
/// \param drawing what was drawn; its date and time are kept, its warnings are for the user
/// \return InvalidOption where an option is out of its range in the table
Status makePatternFile(
  const PatternSource& source, const FileOptions& options, Pattern& drawing, std::string& content);
}
