// SPDX-License-Identifier: BSD-3-Clause
#include "PatternFile.h"

#include "DxfWriter.h"
#include "GarmentCode.h"
#include "HpglWriter.h"
#include "PatternBuilder.h"
#include "PdfWriter.h"
#include "SeamWalk.h"
#include "SvgWriter.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
namespace
{
struct Extension
{
  const char* text;
  FileFormat format;
};
constexpr Extension extensions[] = { { ".svg", FileFormat::Svg }, { ".pdf", FileFormat::Pdf },
  { ".dxf", FileFormat::Dxf }, { ".csv", FileFormat::Walk }, { ".plt", FileFormat::Hpgl },
  { ".json", FileFormat::GarmentCode } };
}

const char* formatName(FileFormat format)
{
  switch (format)
  {
    case FileFormat::Svg:
      return "SVG";
    case FileFormat::Pdf:
      return "PDF";
    case FileFormat::Dxf:
      return "DXF";
    case FileFormat::Walk:
      return "Walk";
    case FileFormat::Hpgl:
      return "HPGL";
    case FileFormat::GarmentCode:
      return "GarmentCode";
    default:
      return "Automatic";
  }
}

FileFormat formatOf(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const Extension& extension : extensions)
  {
    if (ending == extension.text)
    {
      return extension.format;
    }
  }
  return FileFormat::Automatic;
}

std::string knownExtensions()
{
  std::string list;
  for (const Extension& extension : extensions)
  {
    list += (list.empty() ? "" : ", ") + std::string(extension.text);
  }
  return list;
}

Status makePatternFile(
  const PatternSource& source, const FileOptions& options, Pattern& drawing, std::string& content)
{
  const bool onFabric = options.fabric.width != 0.0 &&
    (options.format == FileFormat::Svg || options.format == FileFormat::Pdf ||
      options.format == FileFormat::Hpgl);
  PatternOptions drawn = options.pattern;
  drawn.oneLayer = onFabric;
  Status status = buildPattern(source, drawn, drawing);
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
      if (options.walkTable)
      {
        std::vector<WalkInterval> walk;
        status = walkSeams(source, options.pattern, walk);
        drawing.walk = walkRows(walk, drawing);
      }
      return status.ok() ? makePdf(drawing, options.pages, content) : status;
    case FileFormat::Dxf:
      content = makeDxf(drawing);
      return {};
    case FileFormat::Walk:
    {
      std::vector<WalkInterval> walk;
      status = walkSeams(source, options.pattern, walk);
      content = makeWalkTable(walk, drawing);
      return status;
    }
    case FileFormat::Hpgl:
      content = makeHpgl(drawing);
      return {};
    case FileFormat::GarmentCode:
      return makeGarmentCode(source, options.pattern, drawing, content);
    default:
      content = makeSvg(drawing, options.laserColours);
      return {};
  }
}
}
}
