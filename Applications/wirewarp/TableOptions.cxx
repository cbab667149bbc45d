// SPDX-License-Identifier: BSD-3-Clause
#include "TableOptions.h"

#include "Options.h"
#include "Options/OptionTable.h"
#include "PlainText.h"
#include "TextFile.h"
#include "Units.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace wirewarp
{
namespace
{
using flattening::OptionType;

std::string exactly(double value)
{
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

/// Checks what is given, and may rewrite it. \param isValid of the text \param fault of one that is
/// not, behind it
CLI::Validator checked(std::function<bool(std::string&)> isValid, const std::string& fault,
  const std::string& description)
{
  return CLI::Validator(
    [isValid = std::move(isValid), fault](std::string& text) {
      const std::string given = text;
      return isValid(text) ? std::string() : inQuotes(given) + fault;
    },
    description);
}

/// Reads a length that may have a unit, and is in mm without.
bool inMillimetres(std::string_view text, double& millimetres)
{
  Length length;
  const bool read = parseLength(text, length);
  millimetres = length.value * (length.unit.empty() ? 1.0 : millimetresOf(length.unit));
  return read;
}

/// Splits at the last sign, since names may hold one. \param read the value, into a number
/// \return whether there are a name and a value
template <class Read>
bool splitAtSign(const std::string& text, std::string& name, double& value, Read&& read)
{
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
  {
    return false;
  }
  name = text.substr(0, sign);
  return read(std::string_view(text).substr(sign + 1), value);
}

/// What sets an option to a value that was given.
auto keeperOf(flattening::OptionValues& values, const flattening::Option& option)
{
  return [&values, property = option.property](flattening::OptionValue value) {
    values.set(property, std::move(value));
    values.markGiven(property);
  };
}

/// NAME:PIECE=+3%, where a name may hold both signs. Throws CLI::ValidationError.
flattening::CurveEase easeOf(const std::string& entry)
{
  flattening::CurveEase ease;
  const std::size_t sign = entry.rfind('=');
  std::string value = sign == std::string::npos ? std::string() : entry.substr(sign + 1);
  const bool percent = !value.empty() && value.back() == '%';
  value.resize(value.size() - (percent ? 1 : 0));
  value.erase(0, value.size() > 1 && value[0] == '+' && value[1] != '-' ? 1 : 0);
  if (!percent || sign == 0 || !parseNumber(value, ease.fraction) ||
    !(std::abs(ease.fraction) < 100.0))
  {
    throw CLI::ValidationError("--ease",
      inQuotes(entry) + " is not NAME=PERCENT% or NAME:PIECE=PERCENT% with less than 100 %");
  }
  ease.fraction /= 100.0;
  ease.curve = entry.substr(0, sign);
  const std::size_t colon = ease.curve.rfind(':');
  long long piece = 0;
  if (colon != std::string::npos && colon > 0 && parseInteger(ease.curve.substr(colon + 1), piece))
  {
    if (piece < 1 || piece > std::numeric_limits<int>::max())
    {
      throw CLI::ValidationError("--ease", inQuotes(entry) + ": pieces are numbered from 1");
    }
    ease.piece = static_cast<int>(piece) - 1;
    ease.curve.resize(colon);
  }
  return ease;
}

/// Checks a number within bounds that may be given in percent: 0.05 or 5%. \param range the bounds
/// in words
CLI::Validator percentage(double least, double most, const std::string& range)
{
  return checked(
    [least, most](std::string& text) {
      const bool percent = !text.empty() && text.back() == '%';
      text.resize(text.size() - (percent ? 1 : 0));
      double value = 0.0;
      const bool read = parseNumber(text, value);
      value /= percent ? 100.0 : 1.0;
      text = exactly(value);
      return read && value >= least && value <= most;
    },
    " is not a number in " + range + " or as much in %", "");
}

/// Adds the options of a subset one by one.
class TableOptions
{
public:
  TableOptions(CLI::App& app, flattening::OptionValues& values)
    : App(app)
    , Values(values)
  {
  }

  CLI::Option* add(const flattening::Option& option)
  {
    const std::string name = spelled(option, flattening::OptionSpelling::Command);
    if (const flattening::Option* const list = this->listOf(option))
    {
      return this->addOfCurves(name, option, *list);
    }
    switch (option.type)
    {
      case OptionType::Flag:
      {
        const double turned = std::get<double>(option.byDefault) != 0.0 ? 0.0 : 1.0;
        return this->App.add_flag_callback(
          name, [turned, keep = keeperOf(this->Values, option)]() { keep(turned); },
          turned == 0.0 ? option.helpOff : option.help);
      }
      case OptionType::Integer:
      case OptionType::Number:
        return this->addNumber(name, option);
      case OptionType::Word:
        return this->addWord(name, option);
      case OptionType::Ids:
      case OptionType::Numbers:
        return this->addNumbers(name, option);
      default:
        return this->addTexts(name, option);
    }
  }

private:
  /// What a number is for single curves, by the same flag.
  const flattening::Option* listOf(const flattening::Option& option) const
  {
    for (const flattening::Option* const other : this->Values.options())
    {
      if (option.type == OptionType::Number && other->type == OptionType::List &&
        other->spelling == option.spelling)
      {
        return other;
      }
    }
    return nullptr;
  }

  CLI::Option* addOfCurves(
    const std::string& name, const flattening::Option& option, const flattening::Option& list)
  {
    return this->App
      .add_option_function<std::vector<std::string>>(
        name,
        [name, &option, keep = keeperOf(this->Values, option), &list,
          keepList = keeperOf(this->Values, list)](const std::vector<std::string>& entries) {
          std::vector<std::string> ofCurves;
          for (const std::string& entry : entries)
          {
            std::string curve;
            double value = 0.0;
            const bool named = splitAtSign(entry, curve, value, inMillimetres);
            if ((!named && !inMillimetres(entry, value)) || !isValid(option, value))
            {
              throw CLI::ValidationError(name,
                inQuotes(entry) + " is neither a length in mm in " + rangeOf(option) +
                  " nor NAME=MM of a curve");
            }
            named ? ofCurves.push_back(entry) : keep(value);
          }
          if (!ofCurves.empty())
          {
            keepList(ofCurves);
          }
        },
        option.help + ' ' + list.form + ": " + list.help + " May be given several times.")
      ->type_name(option.form + '|' + list.form)
      ->default_str(this->byDefault(option))
      ->allow_extra_args(false);
  }

  std::string byDefault(const flattening::Option& option) const
  {
    return option.automatic.empty() ? this->Values.text(option.property) : option.automatic;
  }

  static CLI::Validator within(const flattening::Option& option)
  {
    const bool whole = option.type == OptionType::Integer;
    return checked(
      [&option, whole](const std::string& text) {
        double value = 0.0;
        long long count = 0;
        const bool read = whole ? parseInteger(text, count) : parseNumber(text, value);
        return read && isValid(option, whole ? static_cast<double>(count) : value);
      },
      (whole ? " is not a whole number " : " is not a number in ") + rangeOf(option),
      (whole ? "" : "in ") + rangeOf(option));
  }

  CLI::Option* addNumber(const std::string& name, const flattening::Option& option)
  {
    CLI::Option* const added = this->App.add_option_function<double>(
      name, [keep = keeperOf(this->Values, option)](double value) { keep(value); }, option.help);
    if (option.form == "STRAIN")
    {
      added->transform(percentage(option.minimum, option.maximum, rangeOf(option)));
    }
    else if (option.form == "MM")
    {
      added->transform(
        length([&option](double value) { return isValid(option, value); }, rangeOf(option)));
    }
    else
    {
      added->check(within(option));
    }
    const char* const kind = option.type == OptionType::Integer ? "INT" : "FLOAT";
    return added->type_name(option.form.empty() ? kind : option.form)
      ->default_str(this->byDefault(option));
  }

  CLI::Option* addWord(const std::string& name, const flattening::Option& option)
  {
    std::vector<std::string> words;
    std::string kind;
    for (const flattening::OptionWord& word : option.words)
    {
      words.push_back(word.word);
      kind += (kind.empty() ? "" : "|") + word.word;
    }
    return this->App
      .add_option_function<std::string>(
        name,
        [words, keep = keeperOf(this->Values, option)](const std::string& word) {
          keep(static_cast<double>(std::find(words.begin(), words.end(), word) - words.begin()));
        },
        option.help)
      ->transform(CLI::IsMember(words, CLI::ignore_case).description(""))
      ->type_name(option.form.empty() ? kind : option.form)
      ->default_str(this->Values.text(option.property));
  }

  CLI::Option* addNumbers(const std::string& name, const flattening::Option& option)
  {
    const bool ids = option.type == OptionType::Ids;
    return this->App
      .add_option_function<std::vector<double>>(
        name,
        [keep = keeperOf(this->Values, option)](const std::vector<double>& all) { keep(all); },
        option.help)
      ->expected(static_cast<int>(std::get<std::vector<double>>(option.byDefault).size()))
      ->check(ids ? wholeNumber(0, std::numeric_limits<int>::max(), "from 0") : within(option))
      ->type_name(option.form);
  }

  CLI::Option* addTexts(const std::string& name, const flattening::Option& option)
  {
    const bool list = option.type == OptionType::List;
    CLI::Option* const added = this->App.add_option_function<std::vector<std::string>>(
      name,
      [list, &option, keep = keeperOf(this->Values, option)](
        const std::vector<std::string>& entries) {
        if (list)
        {
          std::for_each(entries.begin(), entries.end(),
            [&option](const std::string& entry) { checkEntry(entry, option); });
          keep(entries);
          return;
        }
        keep(entries.front());
      },
      option.help + (list ? " May be given several times." : ""));
    added
      ->check(CLI::Validator(
        [](std::string& text) { return text.empty() ? std::string("it has no name") : ""; }, ""))
      ->type_name(option.form)
      ->default_str(this->Values.text(option.property))
      ->allow_extra_args(false);
    return list ? added : added->expected(1);
  }

  static void checkEntry(const std::string& entry, const flattening::Option& option)
  {
    if (option.form == "NAME[:PIECE]=PERCENT%")
    {
      easeOf(entry);
    }
    else if (option.form.find('=') != std::string::npos)
    {
      namedNumber(entry, option);
    }
  }

  CLI::App& App;
  flattening::OptionValues& Values;
};
}

std::vector<CLI::Option*> addOptions(
  CLI::App& app, const TableSubset& subset, flattening::OptionValues& values)
{
  std::vector<CLI::Option*> added;
  for (const flattening::Option* const option : values.options())
  {
    const bool taken =
      option->type == OptionType::List && app.get_option_no_throw("--" + option->spelling);
    if (option->group == subset.group && subset.leftOut.count(option->property) == 0 && !taken)
    {
      added.push_back(TableOptions(app, values).add(*option));
    }
  }
  return added;
}

std::pair<std::string, double> namedNumber(
  const std::string& entry, const flattening::Option& option)
{
  std::pair<std::string, double> named;
  const bool fraction = option.form == "NAME=FRACTION";
  const std::string range = rangeOf(option);
  const bool split = splitAtSign(
    entry, named.first, named.second, option.form == "NAME=MM" ? inMillimetres : parseNumber);
  if (!split || !std::isfinite(named.second) || named.second < 0.0 ||
    (fraction && named.second >= 1.0) || !isValid(option, named.second))
  {
    throw CLI::ValidationError(spelled(option, flattening::OptionSpelling::Command),
      inQuotes(entry) + " is not " + option.form +
        (fraction           ? " with a fraction in [0, 1)"
            : range.empty() ? " with a number from 0"
                            : " with a number in " + range));
  }
  return named;
}

CLI::Validator length(std::function<bool(double)> isValid, const std::string& range)
{
  return checked(
    [isValid = std::move(isValid)](std::string& text) {
      double value = 0.0;
      const bool valid = inMillimetres(text, value) && isValid(value);
      text = exactly(value);
      return valid;
    },
    " is not a length in " + range + " mm, such as 12, 12mm or 0.5in", "");
}

CLI::Validator number(double least, double most, const std::string& range)
{
  return checked(
    [least, most](const std::string& text) {
      double value = 0.0;
      return parseNumber(text, value) && value >= least && value <= most;
    },
    " is not a number in " + range, "in " + range);
}

CLI::Validator wholeNumber(long long least, long long most, const std::string& range)
{
  return checked(
    [least, most](const std::string& text) {
      long long value = 0;
      return parseInteger(text, value) && value >= least && value <= most;
    },
    " is not a whole number " + range, range);
}

void addMethods(CLI::App& app, Options& options)
{
  for (const char* const group :
    { "Method", "Material", "Ease", "Pieces", "Solver", "Surface and Curves" })
  {
    for (CLI::Option* const option : addOptions(app, { group }, options.values))
    {
      option->group(group);
    }
  }
  app
    .add_flag_callback(
      "--paper-method",
      [&options]() {
        const auto choose = [&options](const char* property, double word) {
          options.values.set(property, word);
          options.values.markGiven(property);
        };
        choose("Scheme", static_cast<double>(flattening::Scheme::Global));
        choose("Interior", static_cast<double>(flattening::InteriorMethod::Laplacian));
      },
      "The paper's method: --scheme global --interior laplacian. newton finds the minimum that the "
      "paper defines; --solver sequential approaches it by the paper's steps, where they converge")
    ->excludes("--scheme", "--interior")
    ->group("Method");
}

void takeOptions(const flattening::OptionValues& values, flattening::OptionOwner owner,
  flattening::OptionStructures& structures)
{
  for (const flattening::Option* const option : optionsOf(owner))
  {
    const flattening::Option* const given = values.find(option->property);
    if (given && given->owner == option->owner && option->set)
    {
      option->set(structures, values[option->property]);
    }
  }
}

flattening::OptionStructures structuresOf(const Options& options)
{
  using flattening::OptionOwner;
  flattening::OptionStructures structures;
  const bool reshapes = options.command == "reshape";
  const bool cuts = options.command == "cut" || options.command == "make";
  structures.proposes = cuts;
  if (reshapes)
  {
    takeOptions(options.reshaping, OptionOwner::Reshaping, structures);
  }
  takeOptions(options.values,
    reshapes ? OptionOwner::Reshaping
      : cuts ? OptionOwner::Suggestion
             : OptionOwner::Warping,
    structures);
  const flattening::Option& prefer =
    *findOption(flattening::OptionOwner::Suggestion, "Preferences");
  for (const std::string& entry : options.values.list(prefer.property))
  {
    const auto [curve, weight] = namedNumber(entry, prefer);
    structures.search.preferences.push_back({ curve, weight });
  }
  if (options.values.text("Scheme") == "lscm")
  {
    structures.flattening.scheme = flattening::Scheme::LeastSquaresConformal;
  }
  for (const std::string& entry : options.values.list("CurveEases"))
  {
    structures.flattening.eases.push_back(easeOf(entry));
  }
  return structures;
}

Options withLengthsIn(const std::string& unit, Options options)
{
  for (const auto& [property, own] : options.unitsOfLengths)
  {
    const double factor = own.empty() ? 1.0 : millimetresOf(own) / millimetresOf(unit);
    options.values.set(property, factor * options.values.number(property));
  }
  options.unitsOfLengths.clear();
  return options;
}

std::map<std::string, double> tolerancesOf(const Options& options)
{
  const flattening::Option& option =
    *findOption(flattening::OptionOwner::Warping, "CurveTolerances");
  std::map<std::string, double> tolerances;
  for (const std::string& entry : options.values.list(option.property))
  {
    const auto [curve, tolerance] = namedNumber(entry, option);
    tolerances[curve] = tolerance;
  }
  return tolerances;
}

std::array<std::int64_t, 2> pinsOf(const Options& options)
{
  const auto& pins = std::get<std::vector<double>>(options.values["Pins"]);
  return { static_cast<std::int64_t>(pins[0]), static_cast<std::int64_t>(pins[1]) };
}

namespace
{
/// Adds a length of the table that is in the unit of the surface, where it has none of its own.
void addSurfaceLength(CLI::App& app, const char* property, Options& options)
{
  const flattening::Option& option = *options.values.find(property);
  app
    .add_option_function<std::string>(
      spelled(option, flattening::OptionSpelling::Command),
      [&options, property](const std::string& text) {
        Length length;
        parseLength(text, length); // the check has read it
        options.values.set(property, length.value);
        options.values.markGiven(property);
        options.unitsOfLengths[property] = length.unit;
      },
      option.help)
    ->check(checked(
      [&option](const std::string& text) {
        Length length;
        return parseLength(text, length) && isValid(option, length.value);
      },
      " is not a length from 0, such as 1.5, 1.5m or 150cm", ""))
    ->type_name("LENGTH")
    ->default_str(options.values.text(property));
}

/// Of the default of MaximumWork, which takes some 45 s of one processor.
const std::map<std::string, double> shareOfEffort{ { "quick", 0.25 }, { "normal", 1.0 },
  { "long", 4.0 } };
}

void addCutting(CLI::App& app, Options& options)
{
  const double work = options.values.number("MaximumWork");
  addOptions(app, { "Suggestions", { "MaximumWidth", "MaximumCutLength" } }, options.values);
  addSurfaceLength(app, "MaximumWidth", options);
  addSurfaceLength(app, "MaximumCutLength", options);
  app
    .add_option_function<std::string>(
      "--effort",
      [&options, work](const std::string& effort) {
        options.values.set("MaximumWork", work * shareOfEffort.at(effort));
      },
      "Length of the search: quick (10 s), normal (30 s), long (2 min). Each is about that long on "
      "one processor that does nothing else; the best cuts that are found by then are proposed, as "
      "after Ctrl+C")
    ->transform(CLI::IsMember({ "quick", "normal", "long" }, CLI::ignore_case).description(""))
    ->type_name("EFFORT")
    ->default_str("normal")
    ->excludes("--max-work");
}
}
