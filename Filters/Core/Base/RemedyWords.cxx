// SPDX-License-Identifier: BSD-3-Clause
#include "Base/RemedyWords.h"

#include "Base/Status.h"

#include <cstddef>

namespace flattening
{
const char* remedySentence(const std::string& name)
{
  for (int k = 0; k < remedyCount; ++k)
  {
    const auto remedy = static_cast<Remedy>(k);
    if (name == remedyName(remedy))
    {
      return remedySentence(remedy);
    }
  }
  return nullptr;
}

std::string remedyWords(const std::string& name, const Spelling& spelling)
{
  const char* const sentence = remedySentence(name);
  const std::string rest = sentence ? sentence : "";
  std::string words;
  std::size_t part = std::string::npos; // where the one begins that may be left out
  bool complete = true;
  for (std::size_t k = 0; k < rest.size(); ++k)
  {
    if (rest[k] == '[')
    {
      part = words.size();
    }
    else if (rest[k] == ']')
    {
      words.resize(complete ? words.size() : part);
      part = std::string::npos;
      complete = true;
    }
    else if (rest[k] == '{')
    {
      const std::size_t end = rest.find('}', k);
      const std::string option = rest.substr(k + 1, end - k - 1);
      const std::size_t equal = option.find('=');
      const std::string spelled = spelling(
        option.substr(0, equal), equal == std::string::npos ? "" : option.substr(equal + 1));
      if (spelled.empty() && part == std::string::npos)
      {
        return {};
      }
      complete = complete && !spelled.empty();
      words += spelled;
      k = end;
    }
    else
    {
      words += rest[k];
    }
  }
  return words;
}

std::string describeDefect(
  const std::string& defect, const std::vector<NamedRemedy>& remedies, const Spelling& spelling)
{
  std::string text = defect;
  const char* join = "; ";
  for (const NamedRemedy& remedy : remedies)
  {
    std::string words = remedyWords(remedy.name, spelling);
    const std::size_t at = words.find('%');
    if (!words.empty())
    {
      text += join + (at == std::string::npos ? words : words.replace(at, 1, remedy.subject));
      join = ", or ";
    }
  }
  return text;
}
}
