// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"
#include "Grading/SizeGrading.h"
#include "Nesting/FabricLay.h"
#include "Outlines/PatternSource.h"

namespace flattening::pattern
{
class FairCache;
class PageCanvas;

/// What a flattening can be written as.
enum class FileFormat
{
  Automatic, ///< what the extension says; SVG where there is no path
  Svg,
  Pdf,
  Dxf,
  Walk,
  Hpgl,
  GarmentCode,
  Nest,      ///< SVG of all sizes
  GradeList, ///< comma-separated values
  RuleTable, ///< after ASTM D6673
};

/// How a file is written; the options of Formats/PatternOptionTable.h are its members.
struct FileOptions
{
  FileFormat format = FileFormat::Automatic;
  PatternOptions pattern;
  PageOptions pages;        ///< of PDF
  FabricOptions fabric;     ///< of SVG, PDF and HPGL: lay the pieces on cloth
  bool walkTable = false;   ///< of PDF: on pages after the pattern
  bool laserColors = false; ///< of SVG
  bool cutterStyle = false; ///< of DXF
  const Grading* grading =
    nullptr;                    ///< of a pattern of several sizes, of which the source is the base
  PageCanvas* canvas = nullptr; ///< of PDF: takes the pages, of which no bytes are made then
  FairCache* fair = nullptr; ///< smooth borders are kept there for other files; null: for this one
};
}
