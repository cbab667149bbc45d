// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>

namespace flattening
{
namespace bridge
{
/// Sets a value, the value of a key, or no values; whether that changes anything. Setters are
/// modified by changes alone, so that the same value does not run a filter again.
template <class Value>
bool change(Value& kept, Value value)
{
  const bool other = !(kept == value);
  kept = std::move(value);
  return other;
}

template <class Key, class Value>
bool changeEntry(std::map<Key, Value>& kept, const Key& key, const Value& value)
{
  const auto [entry, added] = kept.emplace(key, value);
  return change(entry->second, value) || added;
}

template <class List>
bool changeToNone(List& kept)
{
  return change(kept, List());
}
}
}
