// SPDX-License-Identifier: BSD-3-Clause
// write-options TEMPLATE FILE: copies a text and replaces each line
// @KIND:NAME@ by what the table of options says. write-options [--check] PAGE: the same between the lines
// <!-- options:CLASS --> and <!-- end --> of a page; with --check it only says whether they differ.
#include "Cloth/ClothMaterial.h"
#include "Formats/PatternOptionTable.h"
#include "Options/OptionTable.h"
#include "Options/OptionValues.h"
#include "Report/ReportKeys.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

using namespace flattening;

namespace
{
/// Those of patterns last.
const std::vector<const Option*>& allOptions()
{
  static const std::vector<const Option*> all = [] {
    std::vector<const Option*> options;
    for (const Option& option : optionTable())
    {
      options.push_back(&option);
    }
    const std::vector<const Option*> patterns = pattern::patternOptions();
    options.insert(options.end(), patterns.begin(), patterns.end());
    return options;
  }();
  return all;
}

OptionOwner ownerOf(const std::string& name)
{
  const std::optional<OptionOwner> owner = ownerNamed(name);
  return owner ? *owner : throw std::runtime_error("no class " + name + " has options");
}

std::vector<const Option*> ownOptions(OptionOwner owner)
{
  std::vector<const Option*> own;
  for (const Option* const option : allOptions())
  {
    if (option->owner == owner)
    {
      own.push_back(option);
    }
  }
  return own;
}

std::string number(double value, bool real)
{
  Option plain;
  std::string text = textOf(plain, value);
  return real && text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// "AsRigidAsPossible" as "As rigid as possible"; names of people keep their capital.
std::string phrase(const std::string& name)
{
  Option named;
  named.property = name;
  std::string text = labelOf(named);
  for (std::size_t k = 1; k < text.size(); ++k)
  {
    text[k] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[k])));
  }
  const std::size_t person = text.find("dirichlet");
  return person == std::string::npos ? text : text.replace(person, 1, "D");
}

// Python ----------------------------------------------------------------------

std::string argument(const Option& option)
{
  return spelled(option, OptionSpelling::Python);
}

std::string pythonType(const Option& option)
{
  switch (option.type)
  {
    case OptionType::Flag:
      return "bool";
    case OptionType::Integer:
      return "int";
    case OptionType::Number:
      return option.automatic.empty() ? "float" : "Optional[float]";
    case OptionType::Word:
      return option.property;
    case OptionType::Ids:
      return "Tuple[int, int]";
    case OptionType::Numbers:
      return "Sequence[float]";
    case OptionType::List:
      return option.property == "Grain" ? "Union[None, float, str, Sequence[str]]"
        : option.form == "NAME"         ? "Sequence[str]"
        : option.form == "N"            ? "Sequence[int]"
        : option.form == "NAME[:PIECE]=PERCENT%"
        ? "Optional[Mapping[Union[str, Tuple[str, int]], float]]"
        : option.property == "CurveNotches" ? "Optional[Mapping[str, Sequence[float]]]"
                                            : "Optional[Mapping[str, float]]";
    default:
      return option.form == "NAME|FILE" ? "Union[None, str, \"os.PathLike[str]\"]"
        : option.form == "ARRAY"        ? "Union[None, str, ArrayLike]"
                                        : "str";
  }
}

std::string pythonDefault(const Option& option)
{
  switch (option.type)
  {
    case OptionType::Flag:
      return std::get<double>(option.byDefault) != 0.0 ? "True" : "False";
    case OptionType::Integer:
    case OptionType::Number:
      return !option.automatic.empty()
        ? "None"
        : number(std::get<double>(option.byDefault), option.type == OptionType::Number);
    case OptionType::Ids:
    case OptionType::Numbers:
    {
      std::string text;
      for (const double one : std::get<std::vector<double>>(option.byDefault))
      {
        text += (text.empty() ? "(" : ", ") + number(one, option.type == OptionType::Numbers);
      }
      return text + ")";
    }
    case OptionType::List:
      return option.form == "NAME" || option.form == "N" ? "()" : "None";
    default:
      if (option.form == "ARRAY")
      {
        return "None";
      }
      return '"' + textOf(option, option.byDefault) + '"';
  }
}

/// The words of all enumerations as types.
void writeLiterals(OptionOwner, std::ostream& out)
{
  for (const Option* const row : allOptions())
  {
    const Option& option = *row;
    if (option.type == OptionType::Word)
    {
      out << option.property << " = Literal[";
      for (const OptionWord& word : option.words)
      {
        out << (&word == &option.words.front() ? "" : ", ") << '"' << word.word << '"';
      }
      out << "]\n";
    }
  }
}

/// Members of a TypedDict.
void writeMembers(OptionOwner owner, std::ostream& out)
{
  for (const Option* const option : optionsOf(owner))
  {
    out << "    " << argument(*option) << ": " << pythonType(*option) << '\n';
  }
}

/// Keywords with their types.
void writeTyped(
  const std::vector<const Option*>& options, const std::string& margin, std::ostream& out)
{
  for (const Option* const option : options)
  {
    out << margin << argument(*option) << ": " << pythonType(*option) << " = "
        << pythonDefault(*option) << ",\n";
  }
}

/// Those of a function in a stub.
void writeKeywords(OptionOwner owner, std::ostream& out)
{
  writeTyped(optionsOf(owner), "    ", out);
  out << "    paper_method: bool = False,\n"
         "    progress: Optional[Callable[[float], Any]] = None,\n";
}

/// Those of a method.
void writeParameters(OptionOwner owner, std::ostream& out)
{
  writeTyped(ownOptions(owner), "        ", out);
}

/// A text with a narrower margin from its second line on. \param lead of its first line
void writeWrapped(const std::string& text, const std::string& lead, const std::string& rest,
  std::size_t width, std::ostream& out)
{
  for (std::size_t start = 0; start < text.size();)
  {
    std::size_t end = text.size() - start <= width ? text.size() : text.rfind(' ', start + width);
    out << (start == 0 ? lead : rest) << text.substr(start, end - start) << '\n';
    start = end + 1;
  }
}

/// What its help says of them.
void writeArguments(OptionOwner owner, std::ostream& out)
{
  for (const Option* const option : ownOptions(owner))
  {
    const std::string range = rangeOf(*option);
    std::string words;
    for (const OptionWord& word : option->words)
    {
      words += (words.empty() ? " One of " : ", ") + ('"' + word.word + '"');
    }
    const std::string text = argument(*option) + ": " + option->help +
      (range.empty() ? "" : " Range: " + range + '.') + (words.empty() ? "" : words + '.');
    writeWrapped(text, std::string(12, ' '), std::string(16, ' '), 96, out);
  }
}

/// Rows of a tuple of _Option.
void writeRows(OptionOwner, std::ostream& out)
{
  const std::map<OptionType, const char*> names{ { OptionType::Flag, "flag" },
    { OptionType::Integer, "integer" }, { OptionType::Number, "number" },
    { OptionType::Word, "word" }, { OptionType::Text, "text" }, { OptionType::List, "list" },
    { OptionType::Ids, "ids" }, { OptionType::Numbers, "numbers" } };
  for (const Option* const row : allOptions())
  {
    const Option& option = *row;
    out << "    Option(\"" << className(option.owner) << "\", \"" << option.property << "\", \""
        << argument(option) << "\", \"" << names.at(option.type) << "\", " << pythonDefault(option)
        << ",\n           (";
    for (const OptionWord& word : option.words)
    {
      out << "(\"" << word.word << "\", \"" << word.name << "\"), ";
    }
    const double most =
      option.maximum == std::numeric_limits<double>::max() ? 1e300 : option.maximum;
    out << "), " << number(option.minimum, true) << ", " << number(most, true) << ", "
        << (option.open ? "True" : "False") << ", \"" << rangeOf(option) << "\",\n           \""
        << option.help << "\"),\n";
  }
}

/// What help() says of the keys of a record.
void writeKeys(const std::string& record, std::ostream& out)
{
  std::string names;
  for (const ReportKey& key : reportKeys(record))
  {
    names += (names.empty() ? "" : ", ") + std::string(key.key);
    if (*key.help)
    {
      writeWrapped(names + ": " + key.help, std::string(8, ' '), std::string(12, ' '), 100, out);
      names.clear();
    }
  }
}

/// Members of a record. \param commented each with its help before it
void writeFields(const std::string& record, bool commented, std::ostream& out)
{
  const std::map<ReportKind, const char*> types{ { ReportKind::Text, "str" },
    { ReportKind::Integer, "int" }, { ReportKind::Number, "float" }, { ReportKind::Truth, "bool" },
    { ReportKind::Limit, "Optional[float]" } };
  const std::vector<ReportKey>& keys = reportKeys(record);
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    std::size_t last = k; // help stands behind the last of several keys
    while (!*keys[last].help && last + 1 < keys.size())
    {
      ++last;
    }
    if (commented && (k == 0 || *keys[k - 1].help))
    {
      writeWrapped(keys[last].help, "    #: ", "    #: ", 100, out);
    }
    const bool ofCurve = record == "CurveReport" && keys[k].column == std::string("Type");
    out << "    " << keys[k].key << ": " << (ofCurve ? "CurveType" : types.at(keys[k].kind))
        << '\n';
  }
}

// ParaView --------------------------------------------------------------------

std::string escaped(const std::string& text)
{
  std::string safe;
  for (const char letter : text)
  {
    safe += letter == '<' ? "&lt;" : letter == '&' ? "&amp;" : std::string(1, letter);
  }
  return safe;
}

std::string xmlNumbers(const Option& option, double value)
{
  const bool three = option.type == OptionType::Numbers;
  const std::string text = number(value, false);
  return three ? text + ' ' + text + ' ' + text : text;
}

void writeDecorators(const Option& option, std::ostream& out)
{
  std::ostringstream hints;
  for (const OptionCondition& condition : option.conditions)
  {
    const Option* const found = findOption(option.owner, condition.property);
    if (!found)
    {
      continue; // of the conformal map, which has no scheme
    }
    const Option& other = *found;
    std::string values = other.type == OptionType::Flag ? "1" : "";
    bool always = other.type == OptionType::Word;
    for (std::size_t k = 0; k < other.words.size(); ++k)
    {
      const auto& words = condition.words;
      const bool listed = std::find(words.begin(), words.end(), other.words[k].word) != words.end();
      always = always && (listed || other.words[k].name.empty());
      if (listed)
      {
        values += (values.empty() ? "" : " ") + std::to_string(k);
      }
    }
    if (!values.empty() && !always)
    {
      hints << "          <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\" "
               "property=\""
            << other.property << (values.size() == 1 ? "\" value=\"" : "\" values=\"") << values
            << "\" />\n";
    }
  }
  if (!hints.str().empty())
  {
    out << "        <Hints>\n" << hints.str() << "        </Hints>\n";
  }
}

/// What a panel shows of a text: the materials to choose from, with a file beside them; examples.
void writeTextHints(const Option& option, std::ostream& out)
{
  if (option.property == "Material" && option.owner == OptionOwner::Pieces)
  {
    out << "        <StringListDomain name=\"list\">\n          <String value=\"\" />\n";
    for (const flattening::ClothMaterial& material : flattening::materialPresets())
    {
      out << "          <String value=\"" << material.name << "\" />\n";
    }
    out << "        </StringListDomain>\n";
  }
}

void writeProperty(const Option& option, std::ostream& out)
{
  const bool whole = option.type == OptionType::Flag || option.type == OptionType::Integer ||
    option.type == OptionType::Word;
  const std::string tag = std::string(option.type == OptionType::Text ? "String"
                              : option.type == OptionType::Ids        ? "IdType"
                              : whole                                 ? "Int"
                                                                      : "Double") +
    "VectorProperty";
  const auto* const numbers = std::get_if<std::vector<double>>(&option.byDefault);
  Option plain;
  out << "      <" << tag << " name=\"" << option.property << '"';
  if (labelOf(option) != option.property)
  {
    out << " label=\"" << labelOf(option) << '"';
  }
  out << " command=\"Set" << option.property << "\" number_of_elements=\""
      << (numbers ? numbers->size() : 1) << "\"\n          default_values=\""
      << textOf(plain, option.byDefault) << '"'
      << (option.expert ? "\n          panel_visibility=\"advanced\"" : "") << ">\n";
  if (option.type == OptionType::Flag)
  {
    out << "        <BooleanDomain name=\"bool\" />\n";
  }
  for (std::size_t k = 0; k < option.words.size(); ++k)
  {
    out << (k == 0 ? "        <EnumerationDomain name=\"enum\">\n" : "");
    if (!option.words[k].name.empty())
    {
      out << "          <Entry value=\"" << k << "\" text=\"" << phrase(option.words[k].name)
          << "\" />\n";
    }
    out << (k + 1 == option.words.size() ? "        </EnumerationDomain>\n" : "");
  }
  if (option.minimum != option.maximum)
  {
    out << "        <" << (whole ? "Int" : "Double") << "RangeDomain name=\"range\" min=\""
        << xmlNumbers(option, option.sliderMinimum) << "\" max=\""
        << xmlNumbers(option, option.sliderMaximum) << "\" />\n";
  }
  writeTextHints(option, out);
  out << "        <Documentation>" << escaped(option.help) << "</Documentation>\n";
  writeDecorators(option, out);
  out << "      </" << tag << ">\n";
}

/// What an input of a filter may be. \param kind "composite" where its blocks are taken one by one,
/// or "polydata"
void writeInput(const std::string& kind, std::ostream& out)
{
  if (kind != "composite" && kind != "polydata")
  {
    throw std::runtime_error("an input is composite or polydata, not " + kind);
  }
  out << R"(        <ProxyGroupDomain name="groups">
          <Group name="sources" />
          <Group name="filters" />
        </ProxyGroupDomain>
        <DataTypeDomain name="input_type" composite_data_supported=")"
      << (kind == "composite" ? 1 : 0) << R"(">
          <DataType value="vtkPolyData" />
        </DataTypeDomain>
)";
}

constexpr const char* materialFile =
  R"(      <StringVectorProperty name="MaterialFile" label="Material File" command="SetMaterialFile" number_of_elements="1"
          default_values="">
        <FileListDomain name="files" />
        <Documentation>A JSON file with the numbers of a material, used instead of Material. Empty: none.</Documentation>
        <Hints>
          <FileChooser extensions="json" file_description="Material" />
        </Hints>
      </StringVectorProperty>
)";

std::vector<const Option*> withoutLists(std::vector<const Option*> options)
{
  eraseIf(options, [](const Option* option) { return option->type == OptionType::List; });
  return options;
}

/// Those of patterns under one heading, since not all are of every format.
std::function<void(OptionOwner, std::ostream&)> propertiesUnder(const std::string& group)
{
  return [group](OptionOwner owner, std::ostream& out) {
    for (const Option* const option : withoutLists(ownOptions(owner)))
    {
      if (option->group == group)
      {
        writeProperty(*option, out);
      }
    }
  };
}

bool hasMaterialFile(OptionOwner owner, const Option& option)
{
  return owner == OptionOwner::Pieces && option.property == "Material";
}

/// Properties and their groups. Lists are written by hand, since their methods are.
void writeProperties(OptionOwner owner, std::ostream& out)
{
  const std::vector<const Option*> options = withoutLists(ownOptions(owner));
  for (const Option* const option : options)
  {
    writeProperty(*option, out);
    if (hasMaterialFile(owner, *option))
    {
      out << materialFile;
    }
  }
  for (std::size_t k = 0; k < options.size(); ++k)
  {
    const std::string& group = options[k]->group;
    if (k == 0 || options[k - 1]->group != group)
    {
      out << "      <PropertyGroup label=\"" << group << "\">\n";
    }
    out << "        <Property name=\"" << options[k]->property << "\" />\n"
        << (hasMaterialFile(owner, *options[k]) ? "        <Property name=\"MaterialFile\" />\n"
                                                : "");
    if (k + 1 == options.size() || options[k + 1]->group != group)
    {
      out << "      </PropertyGroup>\n";
    }
  }
}

// Documentation ---------------------------------------------------------------

void writeTable(OptionOwner owner, std::ostream& out)
{
  out << "| command, property; Python where it differs | default | range or words | with | "
         "|\n|---|---|---|---|---|\n";
  for (const Option* const option : ownOptions(owner))
  {
    std::string words;
    for (const OptionWord& word : option->words)
    {
      words += (words.empty() ? "" : ", ") + word.word;
    }
    std::string with;
    for (const OptionCondition& condition : option->conditions)
    {
      with += (with.empty() ? "" : "; ") + condition.property;
      for (const std::string& word : condition.words)
      {
        with += (&word == &condition.words.front() ? " " : ", ") + (word.empty() ? "none" : word);
      }
    }
    const std::string value = textOf(*option, option->byDefault);
    const std::string command = spelled(*option, OptionSpelling::Command);
    std::string keyword = option->argument;
    std::replace(keyword.begin(), keyword.end(), '_', '-');
    const bool alike = command == "--" + keyword || command == "--no-" + keyword;
    out << "| `" << command << "` `" << option->property << "`"
        << (alike || option->argument.empty() ? "" : "; `" + option->argument + "`") << " | "
        << (!option->automatic.empty()            ? option->automatic
               : option->type != OptionType::Flag ? value
               : value == "0"                     ? "off"
                                                  : "on")
        << " | " << (words.empty() ? rangeOf(*option) : words) << " | " << with << " | "
        << option->help << " |\n";
  }
}

// -----------------------------------------------------------------------------

std::string readFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
  {
    throw std::runtime_error("cannot read " + path);
  }
  return text.str();
}

void writeFile(const std::string& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}

/// The template with what each line @KIND:NAME@ stands for.
std::string filled(const std::string& text)
{
  using Writer = std::function<void(const std::string&, std::ostream&)>;
  const auto of = [](const std::function<void(OptionOwner, std::ostream&)>& write) -> Writer {
    return [write](const std::string& name, std::ostream& to) { write(ownerOf(name), to); };
  };
  const std::map<std::string, Writer> writers{
    { "literals", of(writeLiterals) }, { "members", of(writeMembers) }, { "rows", of(writeRows) },
    { "properties", of(writeProperties) }, { "parameters", of(writeParameters) },
    { "arguments", of(writeArguments) }, { "drawing", of(propertiesUnder("Drawing")) },
    { "details", of(propertiesUnder("Details")) }, { "cloth", of(propertiesUnder("Cloth")) },
    { "pdf", of(propertiesUnder("PDF")) }, { "svg", of(propertiesUnder("SVG")) },
    { "dxf", of(propertiesUnder("DXF")) }, { "keywords", of(writeKeywords) },
    { "input", writeInput }, { "keys", writeKeys },
    { "fields", [](const std::string& name, std::ostream& to) { writeFields(name, false, to); } },
    { "attributes", [](const std::string& name, std::ostream& to) { writeFields(name, true, to); } }
  };
  std::istringstream in(text);
  std::ostringstream out;
  for (std::string line; std::getline(in, line);)
  {
    const std::size_t colon = line.find(':');
    const auto writer = line.size() > 2 && line.front() == '@' && line.back() == '@'
      ? writers.find(line.substr(1, colon - 1))
      : writers.end();
    if (writer == writers.end())
    {
      out << line << '\n';
      continue;
    }
    const std::string name = line.substr(colon + 1, line.size() - colon - 2);
    writer->second(name, out);
  }
  return out.str();
}

/// The page with its tables anew.
std::string withTables(const std::string& page)
{
  const std::string lead = "<!-- options:";
  std::istringstream in(page);
  std::ostringstream out;
  bool copies = true;
  for (std::string line; std::getline(in, line);)
  {
    copies = copies || line == "<!-- end -->";
    if (copies)
    {
      out << line << '\n';
    }
    if (line.compare(0, lead.size(), lead) == 0)
    {
      writeTable(ownerOf(line.substr(lead.size(), line.find(' ', lead.size()) - lead.size())), out);
      copies = false;
    }
  }
  return out.str();
}
}

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  try
  {
    if (words.size() == 2 && words[0] == "--check")
    {
      const std::string page = readFile(words[1]);
      if (withTables(page) != page)
      {
        std::cerr << words[1] << " differs from the table of options; run write-options on it\n";
        return 1;
      }
    }
    else if (words.size() == 1)
    {
      writeFile(words[0], withTables(readFile(words[0])));
    }
    else if (words.size() == 2)
    {
      writeFile(words[1], filled(readFile(words[0])));
    }
    else
    {
      std::cerr << "usage: write-options TEMPLATE FILE | write-options [--check] PAGE\n";
      return 2;
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "write-options: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
