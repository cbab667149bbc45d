// SPDX-License-Identifier: BSD-3-Clause
#include "OptionHints.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>

namespace wirewarp
{
namespace
{
/// Insertions, removals and exchanges of letters between two words.
std::size_t lettersApart(const std::string& one, const std::string& other)
{
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t k = 0; k < other.size(); ++k)
    {
      const std::size_t above = row[k + 1];
      row[k + 1] = std::min({ above + 1, row[k] + 1, diagonal + (one[i] == other[k] ? 0 : 1) });
      diagonal = above;
    }
  }
  return row.back();
}

/// What follows the dashes of an argument, in small letters; empty where it is none of an option.
std::string optionWord(const std::string& argument)
{
  const std::size_t start = argument.find_first_not_of('-');
  if (start == 0 || start == std::string::npos)
  {
    return {};
  }
  std::string word = argument.substr(start, argument.find('=') - start);
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& names)
{
  std::string nearest;
  // A third of the letters may be wrong.
  std::size_t fewest = word.size() < 2 ? 0 : word.size() / 3 + 1;
  for (const std::string& name : names)
  {
    const std::size_t apart = lettersApart(word, name);
    if (apart < fewest)
    {
      fewest = apart;
      nearest = name;
    }
  }
  return nearest;
}

std::string nearestOption(const CLI::App& app, const std::vector<std::string>& unknown)
{
  for (const std::string& argument : unknown)
  {
    std::vector<std::string> names;
    for (const CLI::Option* const option : app.get_options())
    {
      const std::vector<std::string>& own = option->get_lnames();
      names.insert(names.end(), own.begin(), own.end());
    }
    const std::string nearest = nearestWord(optionWord(argument), names);
    if (!nearest.empty())
    {
      return "; is --" + nearest + " meant?";
    }
  }
  return {};
}
std::string successorOf(const std::string& option)
{
  static const std::map<std::string, std::string> successors{
    { "--suggest", "wirewarp cut SURFACE --kind darts|seams|all|lines" },
    { "--bound", "wirewarp cut SURFACE --max-strain STRAIN" },
    { "--max-cut-length", "wirewarp cut SURFACE --max-length LENGTH" },
    { "--release-keys", "--no-keys" },
    { "--imprint-tolerance", "--curve-distance" },
    { "--no-split", "--no-split-triangles" },
    { "--price-keys", "wirewarp prices SURFACE CURVES" },
    { "--flattenable", "wirewarp reshape SURFACE --max-strain STRAIN" },
    { "--outside-bias", "wirewarp reshape SURFACE --outward SHARE" },
    { "--resew", "wirewarp sew DIR --mode panel|product" },
    { "--resew-thickness", "wirewarp sew DIR --thickness T" },
    { "--resew-iterations", "wirewarp sew DIR --sewing-iterations N" },
    { "--resew-pressure", "wirewarp sew DIR --pressure P" },
    { "--resew-gravity", "wirewarp sew DIR --gravity X Y Z" },
    { "--resew-once", "wirewarp sew DIR --once" },
    { "--svg", "wirewarp pattern DIR -o FILE.svg" },
    { "--pdf", "wirewarp pattern DIR -o FILE.pdf" },
    { "--dxf", "wirewarp pattern DIR -o FILE.dxf" },
    { "--plt", "wirewarp pattern DIR -o FILE.plt" },
    { "--garmentcode", "wirewarp pattern DIR -o FILE.json" },
    { "--walk", "wirewarp pattern DIR -o FILE.csv" },
    { "--piece-name", "wirewarp pattern DIR --piece NAME" },
    { "--piece-quantity", "wirewarp pattern DIR --piece NAME:COPIES" },
    { "--curve-allowance", "wirewarp pattern DIR --allowance NAME=WIDTH" },
    { "--curve-notch", "wirewarp pattern DIR --notch NAME=DISTANCE" },
    { "--double-notches", "wirewarp pattern DIR --double-notch NAME" },
    { "--cut-on-fold", "wirewarp pattern DIR --fold symmetric" },
    { "--curve-dart-tip", "wirewarp pattern DIR --dart-tip NAME=LENGTH" },
    { "--cut-pairs", "wirewarp pattern DIR --pairs" },
    { "--fair", "wirewarp pattern DIR --smooth LENGTH" },
    { "--curve-fair", "wirewarp pattern DIR --smooth NAME=LENGTH" },
    { "--laser-colors", "wirewarp pattern DIR --style laser" },
    { "--fabric-width", "wirewarp nest DIR --roll-width WIDTH" },
    { "--fabric-gap", "wirewarp nest DIR --gap WIDTH" },
    { "--grade", "wirewarp grade SIZE=SURFACE SIZE=SURFACE CURVES" },
    { "--grade-at", "wirewarp grade SIZE=SURFACE SIZE=SURFACE CURVES --at NAME" },
    { "--picture", "wirewarp picture DIR -o FILE.png" },
    { "--color-by", "wirewarp picture DIR --color MEASURE" },
    { "--batch", "wirewarp batch LIST" },
    { "--list-curves", "--table" },
    { "--list-materials", "wirewarp materials" },
  };
  const auto found = successors.find(option);
  return found == successors.end() ? std::string() : found->second;
}
}
