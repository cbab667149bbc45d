// SPDX-License-Identifier: BSD-3-Clause
#include "StatusOutput.h"

namespace flattening
{
namespace bridge
{
namespace
{
/// {Sewing.Test=PANEL} as Test = PANEL.
std::string remedyWords(const SuggestedRemedy& suggested)
{
  std::string words;
  std::size_t option = std::string::npos; // where the last one begins
  for (const char c : std::string(remedySentence(suggested.remedy)))
  {
    if (c == '{' || c == '}')
    {
      option = c == '{' ? words.size() : std::string::npos;
    }
    else if (c == '.' && option != std::string::npos)
    {
      words.resize(option);
    }
    else if (c == '=' && option != std::string::npos)
    {
      words += " = ";
    }
    else if (c == '%')
    {
      words += suggested.subject;
    }
    else if (c != '[' && c != ']')
    {
      words += c;
    }
  }
  return words;
}
}

std::string inWords(const Status& status)
{
  std::string text = status.message;
  const char* join = "; ";
  for (const SuggestedRemedy& suggested : status.remedies)
  {
    text += join + remedyWords(suggested);
    join = ", or ";
  }
  return text;
}
}
}
