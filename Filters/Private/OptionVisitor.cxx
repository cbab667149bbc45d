// SPDX-License-Identifier: BSD-3-Clause
#include "OptionVisitor.h"

#include <cstddef>
#include <variant>

namespace flattening
{
namespace bridge
{
//------------------------------------------------------------------------------
OptionVisitor defaultsOf(OptionOwner owner)
{
  return OptionVisitor([owner](const std::string& property, OptionValue& value) {
    value = findOption(owner, property)->byDefault;
  });
}

//------------------------------------------------------------------------------
OptionVisitor printerOf(OptionOwner owner, std::ostream& os, vtkIndent indent)
{
  return OptionVisitor([owner, &os, indent](const std::string& property, OptionValue& value) {
    const Option& option = *findOption(owner, property);
    os << indent << property << ": ";
    if (option.type == OptionType::Flag)
    {
      os << (std::get<double>(value) != 0.0 ? "On" : "Off");
    }
    else if (option.type == OptionType::Word)
    {
      os << option.words[static_cast<std::size_t>(std::get<double>(value))].name;
    }
    else
    {
      os << textOf(option, value);
    }
    os << "\n";
  });
}

//------------------------------------------------------------------------------
OptionVisitor copierTo(OptionOwner owner, OptionStructures& structures)
{
  return OptionVisitor([owner, &structures](const std::string& property, OptionValue& value) {
    if (const auto& set = findOption(owner, property)->set)
    {
      set(structures, value);
    }
  });
}
}
}
