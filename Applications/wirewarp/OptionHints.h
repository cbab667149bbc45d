// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace wirewarp
{
/// The name that a word nearly is, by Levenshtein's distance; empty where none is.
std::string nearestWord(const std::string& word, const std::vector<std::string>& names);

/// "; is --scheme meant?" for the first of the arguments that no option took and that is nearly the
/// name of one; empty where none is.
std::string nearestOption(const CLI::App& app, const std::vector<std::string>& unknown);

/// What does now what an option of version 0.1 did; empty: it is none of these.
std::string successorOf(const std::string& option);
}
