// SPDX-License-Identifier: BSD-3-Clause
#include "IdleOptions.h"

#include <vtkPatternWriter.h>

#include <algorithm>

namespace wirewarp
{
namespace
{
bool drawsPdf(const PatternRequest& request)
{
  return std::any_of(request.files.begin(), request.files.end(),
    [](const PatternFile& file) { return file.format == vtkPatternWriter::PDF; });
}
}

//------------------------------------------------------------------------------
std::string idleOption(const Options& options, const IsGiven& isGiven)
{
  std::string idle = describeIdleOption(options.values, flattening::OptionSpelling::Command);
  if (!idle.empty())
  {
    return idle;
  }
  for (const char* const option : { "--paper", "--page-overlap", "--max-pages", "--seam-table" })
  {
    if (isGiven(option) && !drawsPdf(options.pattern))
    {
      return std::string(option) +
        " is for a pattern in PDF (-o FILE.pdf); give that as well, or leave it out";
    }
  }
  return "";
}
}
