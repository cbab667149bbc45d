// SPDX-License-Identifier: BSD-3-Clause
#include "RemedySpelling.h"

#include "Base/Status.h"

namespace wirewarp
{
namespace
{
/// The sentence of a remedy of Core; empty where there is none of the name.
std::string sentenceOf(const std::string& name)
{
  for (int k = 0; k < flattening::remedyCount; ++k)
  {
    const auto remedy = static_cast<flattening::Remedy>(k);
    if (name == flattening::remedyName(remedy))
    {
      return flattening::remedySentence(remedy);
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
std::string findSpelling(
  const SpellingTable& table, const std::string& property, const std::string& value)
{
  const std::string setting = property + "=" + value;
  for (const SpelledOption& row : table)
  {
    if (row.option == property || row.option == setting)
    {
      return row.words;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string remedyWords(const std::string& name, const Spelling& spelling)
{
  const std::string sentence = sentenceOf(name);
  std::string words;
  std::size_t part = std::string::npos; // where the one begins that may be left out
  bool complete = true;
  for (std::size_t k = 0; k < sentence.size(); ++k)
  {
    if (sentence[k] == '[')
    {
      part = words.size();
    }
    else if (sentence[k] == ']')
    {
      words.resize(complete ? words.size() : part);
      part = std::string::npos;
      complete = true;
    }
    else if (sentence[k] == '{')
    {
      const std::size_t end = sentence.find('}', k);
      const std::string option = sentence.substr(k + 1, end - k - 1);
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
      words += sentence[k];
    }
  }
  return words;
}

//------------------------------------------------------------------------------
std::string describe(
  const std::string& defect, const std::vector<Remedy>& remedies, const Spelling& spelling)
{
  std::string text = defect;
  const char* join = "; ";
  for (const Remedy& remedy : remedies)
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

//------------------------------------------------------------------------------
std::vector<Remedy> remediesOf(const flattening::Status& status)
{
  std::vector<Remedy> remedies;
  for (const flattening::SuggestedRemedy& suggested : status.remedies)
  {
    remedies.push_back({ flattening::remedyName(suggested.remedy), suggested.subject });
  }
  return remedies;
}
}
