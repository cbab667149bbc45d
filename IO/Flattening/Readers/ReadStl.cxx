// SPDX-License-Identifier: BSD-3-Clause
#include "ReadStl.h"

#include "InputError.h"
#include "TextFile.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace wirewarp
{
namespace
{
constexpr std::size_t headerSize = 80;
constexpr std::size_t facetSize = 50;

/// Takes triangles corner by corner.
class Soup
{
public:
  void add(const std::array<float, 3>& corner)
  {
    const auto [known, isNew] =
      this->Places.emplace(corner, static_cast<std::int64_t>(this->Points.size()));
    if (isNew)
    {
      this->Points.emplace_back(corner[0], corner[1], corner[2]);
    }
    this->Corners[this->Count++] = known->second;
    if (this->Count == 3)
    {
      const auto& [a, b, c] = this->Corners;
      if (a != b && b != c && c != a)
      {
        this->Surface.faces.add(this->Corners);
      }
      this->Count = 0;
    }
  }
  bool isWhole() const { return this->Count == 0; }

  DataSet take()
  {
    this->Surface.points = std::make_shared<const Points3>(std::move(this->Points));
    return std::move(this->Surface);
  }

private:
  Points3 Points;
  std::map<std::array<float, 3>, std::int64_t> Places;
  std::array<std::int64_t, 3> Corners{};
  std::size_t Count = 0;
  DataSet Surface;
};

[[noreturn]] void refuse(const std::string& path, const std::string& what)
{
  throw InputError(path, what + "; write the file again");
}

std::uint32_t wordAt(std::string_view bytes, std::size_t at)
{
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  }
  return word;
}

void readBinary(const std::string& path, std::string_view bytes, Soup& soup)
{
  const std::size_t first = headerSize + 4;
  const std::size_t facets = bytes.size() < first ? 1 : wordAt(bytes, headerSize);
  if (bytes.size() < first || (bytes.size() - first) / facetSize < facets)
  {
    refuse(path, "is shorter than its header says; the file is truncated");
  }
  for (std::size_t facet = 0; facet < facets; ++facet)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      std::array<float, 3> x{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        // Behind the normal.
        const std::uint32_t word =
          wordAt(bytes, first + facet * facetSize + 12 + 12 * corner + 4 * k);
        std::memcpy(&x[k], &word, sizeof(float));
        if (!std::isfinite(x[k]))
        {
          throw InputError(path,
            "facet " + std::to_string(facet) +
              " has a coordinate that is not a finite number; mend or remove it");
        }
      }
      soup.add(x);
    }
  }
}

void readText(const std::string& path, std::string_view bytes, Soup& soup)
{
  if (bytes.find("endsolid") == std::string_view::npos)
  {
    refuse(path, "has no 'endsolid' line; the file is truncated");
  }
  LineReader lines(path, bytes, false);
  std::string line;
  while (lines.next(line))
  {
    std::string_view rest(line);
    if (takeWord(rest) != "vertex")
    {
      continue;
    }
    const Eigen::Vector3f x = takePoint(rest, lines).cast<float>();
    if (!x.allFinite())
    {
      lines.refuse("a coordinate is not a finite number; mend or remove the facet");
    }
    soup.add({ x[0], x[1], x[2] });
  }
  if (!soup.isWhole())
  {
    refuse(path, "has a facet without three corners");
  }
}
}

DataSet readStl(const std::string& path)
{
  const std::string bytes = readWholeFile(path);
  Soup soup;
  const bool text = bytes.compare(0, 5, "solid") == 0 && bytes.find("facet") != std::string::npos;
  (text ? readText : readBinary)(path, bytes, soup);
  return soup.take();
}
}
