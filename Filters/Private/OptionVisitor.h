// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"

#include <vtkIndent.h>

#include <functional>
#include <ostream>
#include <string>
#include <utility>

namespace flattening
{
namespace bridge
{
/// Visits the members of a filter that are options, each by the name of its property, and may
/// change them.
class OptionVisitor
{
public:
  using Action = std::function<void(const std::string& property, OptionValue& value)>;

  explicit OptionVisitor(Action action)
    : Act(std::move(action))
  {
  }

  template <class Member>
  void operator()(const char* property, Member& member)
  {
    OptionValue value = optionValueOf<OptionValue>(member);
    this->Act(property, value);
    assignOption(member, value);
  }

private:
  Action Act;
};

/// Sets the defaults of the options of this class and of those that it derives from.
OptionVisitor defaultsOf(OptionOwner owner);

/// Prints these options, one per line.
OptionVisitor printerOf(OptionOwner owner, std::ostream& os, vtkIndent indent);

/// Copies the options into the structures of Core.
OptionVisitor copierTo(OptionOwner owner, OptionStructures& structures);
}
}
