// SPDX-License-Identifier: BSD-3-Clause
#include "NumberOptions.h"

#include "PlainText.h"
#include "TextFile.h"

#include <iomanip>
#include <sstream>

namespace wirewarp
{
//------------------------------------------------------------------------------
CLI::Validator number(double least, double most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      double value = 0.0;
      const bool valid = parseNumber(text, value) && value >= least && value <= most;
      return valid ? std::string() : inQuotes(text) + " is not a number in " + range;
    },
    "in " + range);
}

//------------------------------------------------------------------------------
CLI::Validator percentage(double least, double most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      const bool percent = !text.empty() && text.back() == '%';
      double value = 0.0;
      if (!parseNumber(percent ? text.substr(0, text.size() - 1) : text, value))
      {
        return inQuotes(text) + " is not a number in " + range + " or as much in %";
      }
      value = percent ? value / 100.0 : value;
      if (!(value >= least && value <= most))
      {
        return inQuotes(text) + " is not a number in " + range + " or as much in %";
      }
      std::ostringstream fraction;
      fraction << std::setprecision(17) << value;
      text = fraction.str();
      return std::string();
    },
    "");
}

//------------------------------------------------------------------------------
CLI::Validator wholeNumber(long long least, long long most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      long long value = 0;
      const bool valid = parseInteger(text, value) && value >= least && value <= most;
      return valid ? std::string() : inQuotes(text) + " is not a whole number " + range;
    },
    range);
}

//------------------------------------------------------------------------------
bool splitNameAndNumber(const std::string& text, std::string& name, double& value)
{
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
  {
    return false;
  }
  name = text.substr(0, sign);
  return parseNumber(text.substr(sign + 1), value);
}

//------------------------------------------------------------------------------
CLI::Validator nameAndMillimetres()
{
  return CLI::Validator(
    [](std::string& text) {
      std::string name;
      double length = 0.0;
      const bool valid = splitNameAndNumber(text, name, length) && length >= 0.0 && length <= 1e6;
      return valid ? std::string()
                   : inQuotes(text) + " is not the name of a curve, '=', and a number in [0, 1e6]";
    },
    "NAME=MM");
}
}
