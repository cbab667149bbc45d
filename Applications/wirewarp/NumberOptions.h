// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace wirewarp
{
/// Checks that an option is a number within bounds. \param range the bounds in words: "[0, 1]".
CLI::Validator number(double least, double most, const std::string& range);

/// The same for a number that may be given in percent: 0.05 or 5%.
CLI::Validator percentage(double least, double most, const std::string& range);

/// The same for a whole number. \param range as "from 1".
CLI::Validator wholeNumber(long long least, long long most, const std::string& range);

/// Splits NAME=NUMBER at the last sign, since names may hold one. \return whether it is so
bool splitNameAndNumber(const std::string& text, std::string& name, double& value);

/// Checks that an option is the name of a curve, '=', and a number of millimetres in [0, 1e6].
CLI::Validator nameAndMillimetres();
}
