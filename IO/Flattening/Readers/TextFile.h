// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace wirewarp
{
/// How many bytes a file has. Throws InputError where it is missing, no regular file (a pipe would
/// not end), empty, larger than what can be flattened, or cannot be opened.
std::size_t checkedFileSize(const std::string& path);

/// Reason of a failed system call, by its errno, and a remedy: "(Too many open files); raise
/// the limit of open files (ulimit -n)". \param remedy where errno names no limit
std::string systemReason(int error, const std::string& remedy);

/// The bytes of a file. Throws InputError as checkedFileSize(), and where it cannot be read.
std::string readWholeFile(const std::string& path);

/// Lower-case extension with its dot, ".vtp"; empty where there is none.
std::string lowerCaseExtension(const std::string& path);

/// Walks the lines of a file's text and counts them.
class LineReader
{
public:
  /// \param path for messages
  /// \param text may begin with the byte order mark that some editors put before UTF-8.
  /// \param joins whether a backslash at the end of a line joins it to the next
  LineReader(std::string path, std::string_view text, bool joins = true);
  /// False at the end. The line has no line break and no carriage return.
  bool next(std::string& line);
  /// Where the last line started, counted from 1.
  std::size_t number() const { return this->Number; }
  /// What follows.
  std::string_view rest() const { return this->Rest; }
  /// Throws InputError with the file and the last line.
  [[noreturn]] void refuse(const std::string& text) const;

private:
  bool nextPhysical(std::string_view& line);

  std::string Path;
  std::string_view Rest;
  bool Joins;
  std::size_t Number = 0;
  std::size_t Lines = 0;
};

/// Takes the next three words of a line as coordinates. Throws InputError.
flattening::Point3 takePoint(std::string_view& rest, const LineReader& lines);

/// The points of a file. Those that are not finite are kept with their lines: no face may use them.
class FilePoints
{
public:
  /// \param line of the point; 0: not known
  void add(const flattening::Point3& point, std::size_t line);
  std::int64_t size() const { return static_cast<std::int64_t>(this->Points.size()); }
  /// Throws InputError where a point is not finite.
  void check(const std::string& path, std::int64_t id) const;
  /// All of them, which it has no longer.
  std::shared_ptr<const flattening::Points3> share();

private:
  flattening::Points3 Points;
  std::map<std::int64_t, std::size_t> Invalid; ///< lines by ids
};

/// A text without the blanks around it.
std::string_view trimmed(std::string_view text);

/// A text in small letters.
std::string lowered(std::string_view text);

/// Of a line.
inline constexpr std::string_view wordBlanks = " \t\v\f";

/// Takes the next word, divided by blanks, off the front of a text; empty at its end.
std::string_view takeWord(std::string_view& text, std::string_view blanks = wordBlanks);

/// Takes a field in double quotes, which begin the text, off its front; two quotes in it stand for
/// one. None where the quotes are not closed.
std::optional<std::string> takeQuoted(std::string_view& text);

/// Takes a word, or a name in double quotes, off the front of a text; empty at its end. None where
/// the quotes are not closed.
std::optional<std::string> takeName(std::string_view& text);

/// Reads a whole word as a number, whatever the locale; false where it is none.
bool parseNumber(std::string_view word, double& value);
bool parseInteger(std::string_view word, long long& value);

/// A word as it may stand in a message: quoted, shortened, without control characters.
std::string inQuotes(std::string_view word);
}
