// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace flattening
{
/// Sees the keys of each object as they are parsed, of which the last of several would count.
template <typename Json>
class DoubledKeys
{
public:
  bool operator()(typename Json::parse_event_t event, const Json& parsed)
  {
    switch (event)
    {
      case Json::parse_event_t::object_start:
        this->Open.emplace_back();
        break;
      case Json::parse_event_t::object_end:
        this->Open.pop_back();
        break;
      case Json::parse_event_t::key:
        if (!this->Open.back().insert(parsed.template get<std::string>()).second &&
          this->First.empty())
        {
          this->First = parsed.template get<std::string>();
        }
        break;
      default:
        break;
    }
    return true;
  }

  const std::string& first() const { return this->First; }

private:
  std::vector<std::set<std::string>> Open;
  std::string First;
};

/// What is wrong with a text, behind its name, and what to write instead; empty: nothing.
struct JsonFault
{
  std::string text;
  std::string remedy;
};

/// Reads a text as JSON, comments allowed, and hands it on. Exceptions of nlohmann from what it is
/// handed to are taken for numbers beyond all doubles; others pass.
template <typename Json, typename Read>
JsonFault readJson(const std::string& text, const Read& read)
{
  try
  {
    DoubledKeys<Json> doubled;
    const Json json = Json::parse(
      text,
      [&doubled](int, typename Json::parse_event_t event, const Json& parsed) {
        return doubled(event, parsed);
      },
      true, true);
    if (!doubled.first().empty())
    {
      return { "has \"" + doubled.first() + "\" twice", "it once" };
    }
    read(json);
  }
  catch (const typename Json::parse_error& error)
  {
    const auto until =
      text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    return { "is not JSON at line " + std::to_string(1 + std::count(text.begin(), until, '\n')),
      "" };
  }
  catch (const typename Json::exception&)
  {
    return { "has a number that is too large", "numbers up to 1e15" };
  }
  return {};
}
}
