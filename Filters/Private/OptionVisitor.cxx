// SPDX-License-Identifier: BSD-3-Clause
#include "OptionVisitor.h"

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
    os << indent << property << ": " << printed(*findOption(owner, property), value) << "\n";
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
