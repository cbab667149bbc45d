// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternFile.h"

#include "Drawing/PatternBuilder.h"
#include "Drawing/SeamWalk.h"
#include "Formats/PageDrawing.h"
#include "Formats/PatternOptionTable.h"
#include "Formats/PatternWriters.h"
#include "Grading/GradeFiles.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

namespace flattening::pattern
{
namespace
{
struct NamedFormat
{
  const char* name;
  const char* extension; ///< that says it; empty: none
};
/// In the order of FileFormat.
constexpr NamedFormat formats[] = { { "Automatic", "" }, { "SVG", ".svg" }, { "PDF", ".pdf" },
  { "DXF", ".dxf" }, { "Walk", ".csv" }, { "HPGL", ".plt" }, { "GarmentCode", ".json" },
  { "Nest", "" }, { "GradeList", "" }, { "RuleTable", ".rul" } };

/// InvalidOption where an option is out of its range in the table.
Status checkRanges(FileOptions options)
{
  Status status;
  const OptionValues table(patternOptions());
  const auto check = [&](const std::string& property, const std::string& whose,
                       const OptionValue& value) {
    const Option& option = *table.find(property);
    if (status.ok() && value != option.byDefault && !isValid(option, value))
    {
      status = { StatusCode::InvalidOption,
        property + whose + " = " + textOf(option, value) + " is out of range: " + rangeOf(option) };
    }
  };
  for (const PatternOption& option : patternOptionTable())
  {
    if (option.valueIn)
    {
      check(option.property, "", option.valueIn(options));
    }
  }
  const auto checkCurves = [&check](const char* property, const auto& ofCurve) {
    for (const auto& [curve, value] : ofCurve)
    {
      check(property, " of " + curve, value);
    }
  };
  const PatternOptions& drawn = options.pattern;
  checkCurves("CurveAllowances", drawn.allowanceOfCurve);
  checkCurves("CurveDartTips", drawn.dartTipOfCurve);
  checkCurves("CurveFairTolerances", drawn.fairToleranceOfCurve);
  checkCurves("CurveNotches", drawn.notchesOfCurve);
  for (std::size_t p = 0; p < drawn.pieceQuantities.size(); ++p)
  {
    const double quantity = drawn.pieceQuantities[p];
    if (quantity != 0.0) // that of all pieces
    {
      check("PieceQuantities", " of piece " + std::to_string(p + 1), quantity);
    }
  }
  return status;
}

Status makeGradeFile(const FileOptions& options, const Pattern& drawing, std::string& content)
{
  if (!options.grading)
  {
    return { StatusCode::InvalidOption,
      std::string("there are no sizes to write as ") + formatName(options.format), {},
      { { Remedy::Give, "the sizes" } } };
  }
  const Grading& grading = *options.grading;
  content = options.format == FileFormat::Nest ? makeNest(grading, options.pattern.name)
    : options.format == FileFormat::GradeList  ? makeRuleList(grading)
                                               : makeRuleTable(grading, options.pattern.name,
                                                   options.pattern.unit, drawing.date, drawing.time);
  return {};
}

/// The points with rules among those of the base size.
Status addGradePoints(const Grading& grading, PatternSource& source)
{
  if (grading.positions[grading.base].size() != source.positions.size())
  {
    return invalidPieces("the sizes have " +
      std::to_string(grading.positions[grading.base].size()) + " points and the flat surface " +
      std::to_string(source.positions.size()));
  }
  for (const GradeRule& rule : grading.rules)
  {
    source.gradePoints.push_back(rule.point);
  }
  return {};
}

/// Not with paper for plotters, of which a page is one roll.
bool hasJoinTable(const FileOptions& options)
{
  const PaperSize paper = options.pages.paper;
  return options.pattern.joinMarks && paper != PaperSize::A0 && paper != PaperSize::Sheet;
}
}

const char* formatName(FileFormat format)
{
  return formats[static_cast<int>(format)].name;
}

FileFormat formatOf(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto* const found = std::find_if(std::begin(formats), std::end(formats),
    [&ending](const NamedFormat& format) { return ending == format.extension; });
  return found == std::end(formats) ? FileFormat::Automatic
                                    : static_cast<FileFormat>(found - std::begin(formats));
}

std::string knownExtensions()
{
  std::string list;
  for (const NamedFormat& format : formats)
  {
    const bool isKnown = *format.extension != '\0';
    list += isKnown ? (list.empty() ? "" : ", ") + std::string(format.extension) : "";
  }
  return list;
}

Status makePatternFile(
  const PatternSource& source, const FileOptions& options, Pattern& drawing, std::string& content)
{
  Status status = checkRanges(options);
  if (!status.ok() || options.format >= FileFormat::Nest)
  {
    return status.ok() ? makeGradeFile(options, drawing, content) : status;
  }
  std::optional<PatternSource> graded;
  if (options.grading)
  {
    graded = source;
    status = addGradePoints(*options.grading, *graded);
    if (!status.ok())
    {
      return status;
    }
  }
  const bool onFabric = options.fabric.width != 0.0 &&
    (options.format == FileFormat::Automatic || options.format == FileFormat::Svg ||
      options.format == FileFormat::Pdf || options.format == FileFormat::Hpgl);
  PatternOptions drawn = options.pattern;
  drawn.oneLayer = onFabric;
  std::optional<DrawingSource> all;
  status = prepareDrawing(graded ? *graded : source, drawn, options.fair, all);
  if (status.ok())
  {
    status = buildPattern(*all, drawing);
  }
  if (status.ok() && onFabric)
  {
    status = layOnFabric(options.fabric, drawing);
  }
  if (!status.ok())
  {
    return status;
  }
  switch (options.format)
  {
    case FileFormat::Pdf:
      drawing.tables.clear();
      if (hasJoinTable(options))
      {
        drawing.tables.push_back(joinRows(walkSeams(*all), drawing));
      }
      if (options.walkTable)
      {
        drawing.tables.push_back(walkRows(walkSeams(*all), drawing));
      }
      return options.canvas ? drawPages(drawing, options.pages, *options.canvas)
                            : makePdf(drawing, options.pages, content);
    case FileFormat::Dxf:
      content = options.cutterStyle ? makeCutterDxf(drawing) : makeDxf(drawing);
      return {};
    case FileFormat::Walk:
      content = makeWalkTable(walkSeams(*all), drawing);
      return {};
    case FileFormat::Hpgl:
      content = makeHpgl(drawing);
      return {};
    case FileFormat::GarmentCode:
      return makeGarmentCode(source, *all, drawing, content);
    default:
      content = makeSvg(drawing, options.laserColors);
      return {};
  }
}
}
