// SPDX-License-Identifier: BSD-3-Clause
#include "HelpFormatter.h"

#include <cstddef>
#include <utility>

namespace wirewarp
{
namespace
{
/// The length of a text up to a full stop or semicolon that is in no parentheses.
std::size_t firstSentence(const std::string& text)
{
  int open = 0;
  for (std::size_t k = 0; k + 1 < text.size(); ++k)
  {
    open += text[k] == '(' ? 1 : text[k] == ')' ? -1 : 0;
    if (open == 0 && text[k + 1] == ' ' && (text[k] == '.' || text[k] == ';'))
    {
      return k;
    }
  }
  return text.size() - (!text.empty() && text.back() == '.' ? 1 : 0);
}
}

HelpFormatter::HelpFormatter(bool whole)
  : Whole(whole)
{
  this->column_width(34);
}

std::string HelpFormatter::make_help(
  const CLI::App* app, std::string name, CLI::AppFormatMode mode) const
{
  std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n"))
  {
    text.erase(at, 1);
  }
  return text;
}

std::string HelpFormatter::make_group(
  std::string group, bool positional, std::vector<const CLI::Option*> options) const
{
  const bool hidden = !this->Whole && !positional && group != commonGroup && group != globalGroup;
  return hidden ? "" : CLI::Formatter::make_group(group, positional, options);
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const
{
  std::string text = CLI::Formatter::make_option_desc(option);
  text.resize(this->Whole ? text.size() : firstSentence(text));
  constexpr std::size_t width = 66;
  std::string lines;
  std::size_t start = 0;
  while (text.size() - start > width)
  {
    const std::size_t blank = text.rfind(' ', start + width);
    if (blank == std::string::npos || blank <= start)
    {
      break;
    }
    lines += text.substr(start, blank - start) + '\n';
    start = blank + 1;
  }
  return lines + text.substr(start);
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const
{
  const std::string type = option->get_type_name();
  const std::string value = option->get_default_str();
  return (type.empty() ? ""
                       : ' ' +
               type.substr(0,
                 type.find_first_of(
                   ':', type.find("[:") == std::string::npos ? 0 : type.find(']')))) +
    (option->get_positional() && option->get_expected_max() > 1 ? " ..." : "") +
    (value.empty() ? "" : " (" + value + ')');
}
}
