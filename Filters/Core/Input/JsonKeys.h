// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

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
}
