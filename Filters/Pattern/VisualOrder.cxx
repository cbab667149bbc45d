// SPDX-License-Identifier: BSD-3-Clause
#include "VisualOrder.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flattening
{
namespace pattern
{
namespace
{
enum class Direction
{
  Left,  ///< written from the left
  Right, ///< written from the right
  Number,
  Separator, ///< part of a number between two digits, otherwise neutral
  Neutral,
};

/// A character with the marks that stand on it.
struct Cluster
{
  std::string bytes;
  std::uint32_t code = 0;
  Direction direction = Direction::Neutral;
  int level = 0;
};

bool isMark(std::uint32_t code)
{
  return (code >= 0x300 && code <= 0x36F) || (code >= 0x591 && code <= 0x5BD) || code == 0x5BF ||
    code == 0x5C1 || code == 0x5C2 || code == 0x5C4 || code == 0x5C5 || code == 0x5C7 ||
    (code >= 0x610 && code <= 0x61A) || (code >= 0x64B && code <= 0x65F) || code == 0x670;
}

Direction directionOf(std::uint32_t code)
{
  const bool digit = (code >= '0' && code <= '9') || (code >= 0x660 && code <= 0x669);
  const bool latin = (code >= 'A' && code <= 'Z') || (code >= 'a' && code <= 'z');
  if (digit)
  {
    return Direction::Number;
  }
  if ((code >= 0x590 && code <= 0x8FF) || (code >= 0xFB1D && code <= 0xFDFF) ||
    (code >= 0xFE70 && code <= 0xFEFE) || (code >= 0x10800 && code <= 0x10FFF) ||
    (code >= 0x1E800 && code <= 0x1EFFF))
  {
    return Direction::Right;
  }
  if (code == '.' || code == ',' || code == ':' || code == '/' || code == '+' || code == '-')
  {
    return Direction::Separator;
  }
  const bool symbol =
    (code >= 0x80 && code < 0xC0 && code != 0xAA && code != 0xB5 && code != 0xBA) || code == 0xD7 ||
    code == 0xF7 || (code >= 0x2000 && code <= 0x2BFF);
  return latin || (code >= 0x80 && !symbol) ? Direction::Left : Direction::Neutral;
}

std::vector<Cluster> clustersOf(const std::string& text)
{
  std::vector<Cluster> clusters;
  for (std::size_t at = 0; at < text.size();)
  {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t wanted = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const std::size_t length = std::min(wanted, text.size() - at);
    std::uint32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length; ++k)
    {
      code = (code << 6U) | (static_cast<unsigned char>(text[at + k]) & 0x3FU);
    }
    if (!isMark(code) || clusters.empty())
    {
      clusters.push_back({ {}, code, directionOf(code) });
    }
    clusters.back().bytes += text.substr(at, length);
    at += length;
  }
  return clusters;
}

void joinNumbers(std::vector<Cluster>& line)
{
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    if (line[k].direction == Direction::Separator)
    {
      const bool within = k > 0 && k + 1 < line.size() &&
        line[k - 1].direction == Direction::Number && line[k + 1].direction == Direction::Number;
      line[k].direction = within ? Direction::Number : Direction::Neutral;
    }
  }
}

/// Numbers behind letters from the left belong to these, and what is neutral to what is on both
/// sides of it, or to the line.
void resolve(std::vector<Cluster>& line, Direction base)
{
  Direction strong = base;
  for (Cluster& cluster : line)
  {
    if (cluster.direction == Direction::Left || cluster.direction == Direction::Right)
    {
      strong = cluster.direction;
    }
    if (cluster.direction == Direction::Number && strong == Direction::Left)
    {
      cluster.direction = Direction::Left;
    }
  }
  const auto side = [](const Cluster& cluster) {
    return cluster.direction == Direction::Left ? Direction::Left : Direction::Right;
  };
  for (std::size_t k = 0; k < line.size();)
  {
    std::size_t end = k;
    while (end < line.size() && line[end].direction == Direction::Neutral)
    {
      ++end;
    }
    const Direction before = k > 0 ? side(line[k - 1]) : base;
    const Direction after = end < line.size() ? side(line[end]) : base;
    std::for_each(line.begin() + static_cast<std::ptrdiff_t>(k),
      line.begin() + static_cast<std::ptrdiff_t>(end),
      [&](Cluster& cluster) { cluster.direction = before == after ? before : base; });
    k = end + 1;
  }
}

std::string mirrored(const Cluster& cluster)
{
  static const std::string pairs = "()[]{}<>";
  const std::size_t at = cluster.bytes.size() == 1 ? pairs.find(cluster.bytes[0]) : pairs.npos;
  return at == pairs.npos ? cluster.bytes : std::string(1, pairs[at ^ 1U]);
}
}

std::string visualOrder(const std::string& text)
{
  std::vector<Cluster> line = clustersOf(text);
  const auto has = [&line](Direction direction) {
    return std::any_of(line.begin(), line.end(),
      [direction](const Cluster& cluster) { return cluster.direction == direction; });
  };
  if (!has(Direction::Right))
  {
    return text;
  }
  const Direction base = has(Direction::Left) ? Direction::Left : Direction::Right;
  joinNumbers(line);
  resolve(line, base);
  int highest = 0;
  for (Cluster& cluster : line)
  {
    const bool right = cluster.direction == Direction::Right;
    cluster.level = base == Direction::Right ? (right ? 1 : 2)
      : right                                ? 1
      : cluster.direction == Direction::Left ? 0
                                             : 2;
    highest = std::max(highest, cluster.level);
  }
  for (int level = highest; level > 0; --level)
  {
    for (auto from = line.begin(); from != line.end();)
    {
      const auto isLower = [level](const Cluster& cluster) { return cluster.level < level; };
      from = std::find_if_not(from, line.end(), isLower);
      const auto to = std::find_if(from, line.end(), isLower);
      std::reverse(from, to);
      from = to;
    }
  }
  std::string result;
  for (const Cluster& cluster : line)
  {
    result += cluster.level == 1 ? mirrored(cluster) : cluster.bytes;
  }
  return result;
}
}
}
