// SPDX-License-Identifier: BSD-3-Clause
#include "TextFile.h"

#include "InputError.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace wirewarp
{
namespace
{
/// A surface of so many bytes has tens of millions of triangles, more than memory is flattened in.
constexpr std::uintmax_t largestFile = 4000000000;

}

std::size_t checkedFileSize(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status =
    std::filesystem::status(std::filesystem::u8path(path), error);
  if (!std::filesystem::exists(status))
  {
    throw InputError(path, "no such file; check the name and the folder it is in");
  }
  if (std::filesystem::is_directory(status))
  {
    throw InputError(path, "this is a folder; name a file in it");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw InputError(path,
      std::string("this is ") +
        (std::filesystem::is_fifo(status) ? "a pipe" : "a device or socket") +
        ", not a file; write its content into a file first");
  }
  const std::uintmax_t size = std::filesystem::file_size(std::filesystem::u8path(path), error);
  if (!error && size == 0)
  {
    throw InputError(path, "the file is empty; write it again");
  }
  if (!error && size > largestFile)
  {
    throw InputError(path,
      "has " + std::to_string(size / 1000000000) + " GB, and files of more than " +
        std::to_string(largestFile / 1000000000) +
        " GB are not read; check what it holds, or reduce the mesh");
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
  {
    throw InputError(path, "cannot be opened " + systemReason(errno, "check its permissions"));
  }
  return static_cast<std::size_t>(size);
}

std::string systemReason(int error, const std::string& remedy)
{
  const bool files = error == EMFILE || error == ENFILE;
  return "(" + std::generic_category().message(error) + "); " +
    (files                ? "raise the limit of open files (ulimit -n)"
        : error == EAGAIN ? "raise the limit of processes (ulimit -u), or close other programs"
        : error == ENOMEM ? wayOutOfMemory
                          : remedy);
}

std::string readWholeFile(const std::string& path)
{
  std::string bytes(checkedFileSize(path), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
  {
    throw InputError(path, "cannot be read to its end; check the disk and try again");
  }
  return bytes;
}

std::string lowerCaseExtension(const std::string& path)
{
  return lowered(std::filesystem::u8path(path).extension().string());
}

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string lowered(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

LineReader::LineReader(std::string path, std::string_view text, bool joins)
  : Path(std::move(path))
  , Rest(text)
  , Joins(joins)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.substr(0, mark.size()) == mark)
  {
    this->Rest.remove_prefix(mark.size());
  }
}

void LineReader::refuse(const std::string& text) const
{
  throw InputError(this->Path, this->Number, text);
}

bool LineReader::nextPhysical(std::string_view& line)
{
  if (this->Rest.empty())
  {
    return false;
  }
  const std::size_t end = std::min(this->Rest.find('\n'), this->Rest.size());
  line = this->Rest.substr(0, end);
  this->Rest.remove_prefix(std::min(end + 1, this->Rest.size()));
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  ++this->Lines;
  return true;
}

bool LineReader::next(std::string& line)
{
  std::string_view part;
  if (!this->nextPhysical(part))
  {
    return false;
  }
  this->Number = this->Lines;
  line.assign(part);
  while (this->Joins && !line.empty() && line.back() == '\\')
  {
    line.back() = ' ';
    if (!this->nextPhysical(part))
    {
      break;
    }
    line.append(part);
  }
  return true;
}

void FilePoints::add(const flattening::Point3& point, std::size_t line)
{
  if (line > 0 && !point.allFinite())
  {
    this->Invalid.emplace(this->size(), line);
  }
  this->Points.push_back(point);
}

flattening::Point3 takePoint(std::string_view& rest, const LineReader& lines)
{
  flattening::Point3 point;
  for (double& coordinate : point)
  {
    const std::string_view word = takeWord(rest);
    if (word.empty())
    {
      lines.refuse("a vertex needs three coordinates; the file may be truncated");
    }
    if (!parseNumber(word, coordinate))
    {
      lines.refuse(inQuotes(word) + " is not a coordinate; write a decimal number");
    }
  }
  return point;
}

void FilePoints::check(const std::string& path, std::int64_t id) const
{
  const auto found = this->Invalid.find(id);
  if (found != this->Invalid.end())
  {
    throw InputError(path, found->second,
      "a coordinate is not a finite number; mend the vertex, or remove it with its faces");
  }
}

std::shared_ptr<const flattening::Points3> FilePoints::share()
{
  return std::make_shared<const flattening::Points3>(std::move(this->Points));
}

std::string_view takeWord(std::string_view& text, std::string_view blanks)
{
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::optional<std::string> takeQuoted(std::string_view& text)
{
  std::string field;
  for (std::size_t begin = 1;;)
  {
    const std::size_t end = text.find('"', begin);
    if (end == std::string_view::npos)
    {
      return std::nullopt;
    }
    field.append(text.substr(begin, end - begin));
    begin = end + 1;
    if (begin == text.size() || text[begin] != '"')
    {
      text.remove_prefix(begin);
      return field;
    }
    field += '"';
    ++begin;
  }
}

std::optional<std::string> takeName(std::string_view& text)
{
  std::string_view rest = text;
  const std::string_view word = takeWord(rest);
  if (word.empty() || word.front() != '"')
  {
    text = rest;
    return std::string(word);
  }
  text.remove_prefix(static_cast<std::size_t>(word.data() - text.data()));
  return takeQuoted(text);
}

bool parseNumber(std::string_view word, double& value)
{
  if (word.size() > 1 && word.front() == '+')
  {
    word.remove_prefix(1);
  }
#ifdef __cpp_lib_to_chars
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
#else // libc++ before LLVM 20 has from_chars() of whole numbers alone
  const std::string text(word);
  if (text.empty() || wordBlanks.find(text.front()) != std::string_view::npos ||
    text.front() == '+' || text.find_first_of("xX(\r\n") != std::string::npos)
  {
    return false;
  }
  char* end = nullptr;
  errno = 0;
  value = std::strtod(text.c_str(), &end);
  const bool inRange = errno != ERANGE || (value != 0.0 && std::abs(value) < 1.0);
  return inRange && end == text.c_str() + text.size();
#endif
}

bool parseInteger(std::string_view word, long long& value)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

std::string inQuotes(std::string_view word)
{
  const std::size_t most = 40;
  std::string text(word.substr(0, most));
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
  return "'" + text + (word.size() > most ? "..." : "") + "'";
}
}
