// SPDX-License-Identifier: BSD-3-Clause
#include "SizeOptions.h"

#include "TextFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <set>

namespace wirewarp
{
//------------------------------------------------------------------------------
std::vector<SizeSurface> SizeRequest::all(const std::string& base) const
{
  std::vector<SizeSurface> sizes;
  for (const std::string& text : this->texts)
  {
    const std::size_t sign = std::min(text.find('='), text.size());
    sizes.push_back(
      { text.substr(0, sign), sign < text.size() ? text.substr(sign + 1) : std::string() });
  }
  const bool placed = std::any_of(
    sizes.begin(), sizes.end(), [](const SizeSurface& size) { return size.surface.empty(); });
  if (!placed)
  {
    sizes.insert(sizes.begin(), { base, "" });
  }
  return sizes;
}

//------------------------------------------------------------------------------
std::string SizeRequest::fault(const std::string& base) const
{
  if (base.empty())
  {
    return "a size has no name; write SIZE=SURFACE";
  }
  std::set<std::string> names;
  const std::vector<SizeSurface> sizes = this->all(base);
  for (const SizeSurface& size : sizes)
  {
    if (size.name.empty() || (size.surface.empty() && size.name != base))
    {
      return inQuotes(size.name) + " is not a size; write SIZE=SURFACE";
    }
    if (!names.insert(size.name).second)
    {
      return "the size " + inQuotes(size.name) + " is named twice; leave one of them out";
    }
  }
  return "";
}

//------------------------------------------------------------------------------
void addSizes(
  CLI::App& app, std::vector<std::string>& words, SizeRequest& request, std::string& base)
{
  app
    .add_option("SIZE=SURFACE", words,
      "Surfaces of one connectivity by the names of their sizes, in order, and files of curves, "
      "which are of the base")
    ->type_name("...");
  app.add_option("--base", base, "The size whose curves are given (default: the first)")
    ->type_name("SIZE");
  app
    .add_option("--at", request.alignment,
      "Lay sizes on each other at the first point of this curve and along it (default: the first "
      "key curve within each piece; where there is none, as they fit the base best)")
    ->type_name("NAME");
}
}
