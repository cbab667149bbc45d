// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "FabricLay.h"
#include "Pattern.h"
#include "PatternSource.h"
#include "PdfPages.h"

namespace flattening
{
namespace pattern
{
/// What a flattening can be written as.
enum class FileFormat
{
  Automatic, ///< what the extension says
  Svg,
  Pdf,
  Dxf,
  Walk,
  Hpgl,
  GarmentCode,
};

/// "SVG", "Walk", ...
const char* formatName(FileFormat format);

/// What the extension of a path says, in either case; Automatic where it says nothing.
FileFormat formatOf(const std::string& path);

/// The extensions that say a format, for a message: ".svg, .pdf, ...".
std::string knownExtensions();

struct FileOptions
{
  FileFormat format = FileFormat::Svg;
  PatternOptions pattern;
  PageOptions pages;         ///< of PDF
  FabricOptions fabric;      ///< of SVG, PDF and HPGL: lay the pieces on cloth
  bool walkTable = false;    ///< of PDF: on pages after the pattern
  bool laserColours = false; ///< of SVG
};

/// Draws a flattening and makes the file's bytes.
/// \param drawing what was drawn; its date and time are kept, its warnings are for the user
Status makePatternFile(
  const PatternSource& source, const FileOptions& options, Pattern& drawing, std::string& content);
}
}
