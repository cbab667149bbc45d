// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkObject.h>

#include <map>
#include <utility>

namespace flattening::bridge
{
/// Sets a value, the value of a key, or no values. The owner is modified by changes alone, so that
/// the same value does not run a filter again.
template <class Value>
void change(vtkObject* owner, Value& kept, Value value)
{
  if (!(kept == value))
  {
    kept = std::move(value);
    owner->Modified();
  }
}

template <class Key, class Value>
void changeEntry(vtkObject* owner, std::map<Key, Value>& kept, const Key& key, const Value& value)
{
  std::map<Key, Value> changed = kept;
  changed[key] = value;
  change(owner, kept, std::move(changed));
}

template <class List>
void changeToNone(vtkObject* owner, List& kept)
{
  change(owner, kept, List());
}
}
