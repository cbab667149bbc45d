// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSeams.h"

#include "InputError.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <variant>

namespace wirewarp
{
namespace
{
constexpr double sameTexture = 1e-6; ///< of texture coordinates, as files round them
constexpr int seamType = 3;

/// A side of a face between two points, the smaller id first.
struct FaceSide
{
  std::array<std::int64_t, 2> points{};
  std::size_t face = 0;
  std::array<std::size_t, 2> textures{}; ///< at these points, 0: none

  bool operator<(const FaceSide& other) const { return this->points < other.points; }
};

/// The sides of all faces, those of one edge one after the other.
std::vector<FaceSide> sidesOf(const DataSet& surface, const FaceLabels& labels)
{
  std::vector<FaceSide> sides;
  std::size_t corner = 0;
  for (std::size_t face = 0; face < surface.faces.size(); ++face)
  {
    const std::int64_t* const ids = surface.faces.begin(face);
    const std::int64_t count = surface.faces.end(face) - ids;
    for (std::int64_t k = 0; k < count; ++k)
    {
      const std::int64_t next = (k + 1) % count;
      const auto texture = [&](std::int64_t at) {
        return labels.corners.empty() ? 0 : labels.corners[corner + static_cast<std::size_t>(at)];
      };
      FaceSide side{ { ids[k], ids[next] }, face, { texture(k), texture(next) } };
      if (side.points[0] > side.points[1])
      {
        std::swap(side.points[0], side.points[1]);
        std::swap(side.textures[0], side.textures[1]);
      }
      sides.push_back(side);
    }
    corner += static_cast<std::size_t>(count);
  }
  std::stable_sort(sides.begin(), sides.end());
  return sides;
}

bool texturesMeet(const FaceLabels& labels, std::size_t a, std::size_t b)
{
  if (a == b || a == 0 || b == 0)
  {
    return a == b;
  }
  const std::array<double, 2>& one = labels.textures[a - 1];
  const std::array<double, 2>& other = labels.textures[b - 1];
  return std::abs(one[0] - other[0]) <= sameTexture && std::abs(one[1] - other[1]) <= sameTexture;
}

bool isSeam(const FaceLabels& labels, SeamSource source, const FaceSide& a, const FaceSide& b)
{
  switch (source)
  {
    case SeamSource::Textures:
      return !texturesMeet(labels, a.textures[0], b.textures[0]) ||
        !texturesMeet(labels, a.textures[1], b.textures[1]);
    case SeamSource::Materials:
      return labels.materials[a.face] != labels.materials[b.face];
    case SeamSource::Groups:
      return labels.objects[a.face] != labels.objects[b.face] ||
        labels.groups[a.face] != labels.groups[b.face];
    case SeamSource::None:
      break;
  }
  return false;
}

/// Edges as chains that end where another number of edges than two meets.
class Chains
{
public:
  void add(std::int64_t a, std::int64_t b)
  {
    this->Edges[a].push_back(b);
    this->Edges[b].push_back(a);
  }

  std::vector<std::vector<std::int64_t>> take()
  {
    std::vector<std::vector<std::int64_t>> chains;
    for (const bool rings : { false, true })
    {
      for (auto& [point, ends] : this->Edges)
      {
        while ((rings || ends.size() != 2) && this->isLeft(point))
        {
          chains.push_back(this->walk(point));
        }
      }
    }
    return chains;
  }

private:
  bool isLeft(std::int64_t point)
  {
    std::vector<std::int64_t>& ends = this->Edges[point];
    std::size_t& used = this->Used[point];
    while (used < ends.size() && this->Taken.count({ point, ends[used] }) > 0)
    {
      ++used;
    }
    return used < ends.size();
  }

  std::vector<std::int64_t> walk(std::int64_t start)
  {
    std::vector<std::int64_t> chain{ start };
    do
    {
      const std::int64_t from = chain.back();
      const std::int64_t to = this->Edges[from][this->Used[from]];
      this->Taken.insert({ from, to });
      this->Taken.insert({ to, from });
      chain.push_back(to);
    } while (this->Edges[chain.back()].size() == 2 && this->isLeft(chain.back()));
    return chain;
  }

  std::map<std::int64_t, std::vector<std::int64_t>>
    Edges; ///< points by the points that they are joined to
  std::unordered_map<std::int64_t, std::size_t> Used; ///< of these, from the first on
  std::set<std::array<std::int64_t, 2>> Taken;
};

/// Where a list tells two faces at least apart.
bool differs(const std::vector<std::size_t>& labels)
{
  return std::any_of(
    labels.begin(), labels.end(), [&labels](std::size_t label) { return label != labels.front(); });
}

void checkLabels(const FaceLabels& labels, SeamSource source)
{
  const bool has = source == SeamSource::Textures ? !labels.textures.empty()
    : source == SeamSource::Materials             ? differs(labels.materials)
                                      : differs(labels.objects) || differs(labels.groups);
  if (!has)
  {
    throw InputError(source == SeamSource::Textures
        ? "has no texture coordinates to take seams from; export it as .obj with them ('vt' lines)"
        : source == SeamSource::Materials
        ? "has not two materials to take seams from; export it as .obj with them ('usemtl')"
        : "has not two groups to take seams from; export it as .obj with them ('g' or 'o')");
  }
}

const char* wordOf(SeamSource source)
{
  return source == SeamSource::Textures ? "uv seam "
    : source == SeamSource::Materials   ? "material seam "
                                        : "group seam ";
}
}

std::vector<std::string> pieceNames(const FaceLabels& labels)
{
  const std::vector<std::size_t>& used = differs(labels.objects) ? labels.objects : labels.groups;
  std::vector<std::string> names;
  if (differs(used))
  {
    for (const std::size_t label : used)
    {
      names.push_back(labels.names[label]);
    }
  }
  return names;
}

DataSet seamsOf(const DataSet& surface, const FaceLabels& labels, SeamSource source)
{
  checkLabels(labels, source);
  const std::vector<FaceSide> sides = sidesOf(surface, labels);
  Chains chains;
  for (std::size_t k = 0; k < sides.size();)
  {
    std::size_t end = k + 1;
    while (end < sides.size() && sides[end].points == sides[k].points)
    {
      ++end;
    }
    if (end == k + 2 && isSeam(labels, source, sides[k], sides[k + 1]))
    {
      chains.add(sides[k].points[0], sides[k].points[1]);
    }
    k = end;
  }
  CurveList curves;
  int number = 0;
  for (const std::vector<std::int64_t>& chain : chains.take())
  {
    curves.add(chain, { { seamType, 0 }, wordOf(source) + std::to_string(++number) });
  }
  return curves.over(surface.points);
}

void addSeams(SeamSource source, SurfaceContents& contents)
{
  if (source == SeamSource::None)
  {
    return;
  }
  const DataSet seams = seamsOf(contents.surface, contents.labels, source);
  for (std::size_t k = 0; k < seams.lines.size(); ++k)
  {
    contents.curves.lines.add(std::vector<std::int64_t>(seams.lines.begin(k), seams.lines.end(k)));
  }
  for (flattening::Column& column : contents.curves.cellArrays)
  {
    const flattening::Column* const more = findColumn(seams.cellArrays, column.name);
    std::visit(
      [&](auto& values) {
        using Values = std::decay_t<decltype(values)>;
        const Values added = more ? std::get<Values>(more->values) : Values(seams.lines.size());
        values.insert(values.end(), added.begin(), added.end());
      },
      column.values);
  }
}
}
