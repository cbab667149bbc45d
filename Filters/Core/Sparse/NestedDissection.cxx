// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NestedDissection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// In the place of a vertex: where ways begin and end.
constexpr Index atLeft = -2;
constexpr Index atRight = -3;
/// No state, but there may be others.
constexpr Index closed = -4;

constexpr Index entering(Index place)
{
  return 2 * place;
}
constexpr Index leaving(Index place)
{
  return 2 * place + 1;
}
}

VertexSeparator::VertexSeparator(const Indices& begin, const Indices& neighbours)
  : Begin(begin)
  , Neighbours(neighbours)
  , Sides(begin.size() - 1, Side::Outside)
  , Place(begin.size() - 1, none)
{
}

void VertexSeparator::build(const Indices& between)
{
  const auto count = static_cast<Index>(between.size());
  for (Index k = 0; k < count; ++k)
  {
    this->Place[between[k]] = k;
  }
  this->AtLeft.clear();
  this->AtRight.assign(count, 0);
  this->FirstBeside.assign(count + 1, 0);
  for (Index k = 0; k < count; ++k)
  {
    bool left = false;
    Index beside = 0;
    for (Index a = this->Begin[between[k]]; a < this->Begin[between[k] + 1]; ++a)
    {
      const Side side = this->Sides[this->Neighbours[a]];
      left = left || side == Side::Left;
      this->AtRight[k] = this->AtRight[k] || side == Side::Right ? 1 : 0;
      beside += side == Side::Between ? 1 : 0;
    }
    if (left)
    {
      this->AtLeft.push_back(k);
    }
    this->FirstBeside[k + 1] = this->FirstBeside[k] + beside;
  }
  this->Beside.resize(this->FirstBeside.back());
  this->Arc.assign(this->FirstBeside.begin(), this->FirstBeside.end());
  for (Index k = count; k-- > 0;)
  {
    for (Index a = this->Begin[between[k]]; a < this->Begin[between[k] + 1]; ++a)
    {
      if (this->Sides[this->Neighbours[a]] == Side::Between)
      {
        this->Beside[this->Arc[this->Place[this->Neighbours[a]]]++] = k;
      }
    }
  }
  this->Previous.assign(count, none);
  this->Next.assign(count, none);
}

/// The a-th state that may follow one; none after the last.
Index VertexSeparator::following(Index state, Index a) const
{
  const Index k = state / 2;
  if (state == entering(k))
  {
    // Through the vertex, or, where a way goes there, back along that.
    const Index back = this->Previous[k] == atLeft ? closed : leaving(this->Previous[k]);
    return a > 0 ? none : this->Next[k] == none ? leaving(k) : back;
  }
  if (a == 0)
  {
    return this->AtRight[k] ? atRight : closed;
  }
  if (a == 1)
  {
    return this->Next[k] == none ? closed : entering(k);
  }
  const Index at = this->FirstBeside[k] + a - 2;
  if (at >= this->FirstBeside[k + 1])
  {
    return none;
  }
  return this->Next[k] == this->Beside[at] ? closed : entering(this->Beside[at]);
}

/// Looks for a way among states that no earlier one has tried.
bool VertexSeparator::addWay(Index start)
{
  const auto enter = [this](Index state) {
    this->Tried[state] = 1;
    this->Way.push_back(state);
  };
  this->Way.clear();
  enter(entering(start));
  while (!this->Way.empty())
  {
    const Index state = this->Way.back();
    const Index next = this->following(state, this->Arc[state]);
    if (next == none)
    {
      this->Way.pop_back();
      continue;
    }
    ++this->Arc[state];
    if (next == atRight)
    {
      this->takeWay();
      return true;
    }
    if (next != closed && !this->Tried[next])
    {
      enter(next);
    }
  }
  return false;
}

/// Where it runs back along another way, the two change their ends.
void VertexSeparator::takeWay()
{
  this->Previous[this->Way.front() / 2] = atLeft;
  for (std::size_t at = 0; at + 1 < this->Way.size(); ++at)
  {
    const Index from = this->Way[at] / 2;
    const Index to = this->Way[at + 1] / 2;
    if (this->Way[at] == leaving(from))
    {
      this->Next[from] = from == to ? none : to;
      this->Previous[to] = from == to ? none : from;
    }
  }
  this->Next[this->Way.back() / 2] = atRight;
}

bool VertexSeparator::separate(const Indices& between, Index most)
{
  this->build(between);
  Index ways = 0;
  for (bool found = true; found && ways <= most;)
  {
    found = false;
    this->Tried.assign(2 * between.size(), 0);
    this->Arc.assign(2 * between.size(), 0);
    for (Index k : this->AtLeft)
    {
      if (this->Previous[k] == atLeft)
      {
        this->Tried[entering(k)] = 1;
      }
      else if (!this->Tried[entering(k)] && this->addWay(k))
      {
        found = true;
        ++ways;
      }
    }
  }
  for (std::size_t k = 0; k < between.size() && ways <= most; ++k)
  {
    const auto place = static_cast<Index>(k);
    this->Sides[between[k]] = this->Tried[leaving(place)] ? Side::Left
      : this->Tried[entering(place)]                      ? Side::Between
                                                          : Side::Right;
  }
  return ways <= most;
}

namespace
{
/// What both ways of halving have in common.
class Dissector
{
public:
  Dissector(const Triangles& cliques, Index count)
    : Begin(count + 1, 0)
    , Part(count, 0)
  {
    for (const Triangle& t : cliques)
    {
      for (Index v : t)
      {
        this->Begin[v + 1] += 2;
      }
    }
    this->AnyHub =
      *std::max_element(this->Begin.begin(), this->Begin.end()) / 2 > hubValence(smallPart);
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Neighbours.resize(this->Begin.back());
    Indices next(this->Begin.begin(), this->Begin.end() - 1);
    for (const Triangle& t : cliques)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Neighbours[next[t[k]]++] = t[(k + 1) % 3];
        this->Neighbours[next[t[k]]++] = t[(k + 2) % 3];
      }
    }
    this->Result.order.resize(count);
    std::iota(this->Result.order.begin(), this->Result.order.end(), 0);
  }
  virtual ~Dissector() = default;
  Dissector(const Dissector&) = delete;
  Dissector& operator=(const Dissector&) = delete;

protected:
  using Iterator = Indices::iterator;

  /// A part that stands at order[begin] .. order[end - 1] and is to be divided from a vertex at one
  /// of its ends, or the end of a range alone.
  struct Step
  {
    Index begin;
    Index end;
    Index start;
  };

  /// Divides a part into others that come next, by pushPart() from the last to the first.
  virtual void divide(const Step& part) = 0;

  void pushEnd(Index end) { this->Steps.push_back({ none, end, none }); }
  void pushPart(Index begin, Index end, Index start)
  {
    if (begin < end)
    {
      this->Steps.push_back({ begin, end, start });
    }
  }

  Dissection divideAll(Index start)
  {
    this->pushPart(0, static_cast<Index>(this->Part.size()), start);
    while (!this->Steps.empty())
    {
      const Step step = this->Steps.back();
      this->Steps.pop_back();
      if (step.begin == none || step.end - step.begin <= smallPart)
      {
        this->Result.endRange(step.end);
      }
      else if (!this->AnyHub || !this->takeHubs(step))
      {
        this->divide(step);
      }
    }
    return std::move(this->Result);
  }

  /// Moves those behind that have a neighbour for which this holds, the separator. \return its
  /// begin.
  template <typename Beyond>
  Iterator separate(Iterator first, Iterator last, const Beyond& beyond) const
  {
    return std::stable_partition(first, last, [&](Index v) {
      return std::none_of(this->Neighbours.begin() + this->Begin[v],
        this->Neighbours.begin() + this->Begin[v + 1], beyond);
    });
  }

  /// Gives vertices a mark that no other has had.
  Index assign(Iterator first, Iterator last)
  {
    const Index part = this->NextPart++;
    std::for_each(first, last, [&](Index v) { this->Part[v] = part; });
    return part;
  }

  /// Parts of so few vertices are not divided: a dense block of them costs less.
  static constexpr Index smallPart = 12;

  Indices Begin; ///< neighbours of each vertex, in flat arrays; inner edges twice
  Indices Neighbours;
  Indices Part; ///< mark of each vertex
  Dissection Result;

private:
  /// Makes the hubs of a part its separator. False where it has none.
  bool takeHubs(const Step& step)
  {
    const Index enough = hubValence(step.end - step.begin);
    const Iterator first = this->Result.order.begin() + step.begin;
    const Iterator last = this->Result.order.begin() + step.end;
    const auto high = [&](Index v) { return (this->Begin[v + 1] - this->Begin[v]) / 2 > enough; };
    if (std::none_of(first, last, high))
    {
      return false;
    }
    const Index part = this->assign(first, last);
    const Iterator hubs = std::stable_partition(first, last, [&](Index v) {
      return !high(v) ||
        std::count_if(this->Neighbours.begin() + this->Begin[v],
          this->Neighbours.begin() + this->Begin[v + 1],
          [&](Index n) { return this->Part[n] == part; }) /
          2 <=
        enough;
    });
    if (hubs == last)
    {
      return false;
    }
    this->assign(first, hubs);
    this->pushEnd(step.end);
    if (hubs != first)
    {
      this->pushPart(step.begin, step.end - static_cast<Index>(last - hubs), *(hubs - 1));
    }
    return true;
  }

  std::vector<Step> Steps;
  Index NextPart = 1;
  bool AnyHub = false;
};

/// Halves parts by their level structure.
class LevelDissector : protected Dissector
{
public:
  LevelDissector(const Triangles& cliques, Index count)
    : Dissector(cliques, count)
    , Level(count, none)
    , Queue(count)
  {
  }

  Dissection run()
  {
    return this->divideAll(this->Queue.empty() ? none : this->Queue[this->visit(0) - 1]);
  }

protected:
  /// Divides a part by levels where their separator is smaller than another one of it.
  bool divideByLevels(const Step& part, Index cost)
  {
    const auto first = this->Result.order.begin() + part.begin;
    this->assign(first, this->Result.order.begin() + part.end);
    const Index visited = this->visit(*first);
    if (visited < part.end - part.begin)
    {
      this->divideComponents(part);
      return true;
    }
    this->visit(this->Queue[visited - 1]);
    return this->divideQueue(part, cost - 1);
  }

private:
  /// Queues the part of a vertex breadth first from it, each with its distance as level. Levels of
  /// later visits are higher, so that none has to be taken back. \return how many are queued.
  Index visit(Index start)
  {
    const Index part = this->Part[start];
    const Index first = this->NextLevel;
    Index end = 0;
    this->Queue[end++] = start;
    this->Level[start] = first;
    for (Index at = 0; at < end; ++at)
    {
      const Index v = this->Queue[at];
      for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
      {
        const Index other = this->Neighbours[k];
        if (this->Part[other] == part && this->Level[other] < first)
        {
          this->Level[other] = this->Level[v] + 1;
          this->Queue[end++] = other;
        }
      }
    }
    this->NextLevel = this->Level[this->Queue[end - 1]] + 1;
    return end;
  }

  void divide(const Step& part) override
  {
    const Index visited = this->visit(part.start);
    if (visited < part.end - part.begin)
    {
      this->divideComponents(part);
      return;
    }
    this->divideQueue(part, visited);
  }

  /// By the levels of all its vertices in the queue. False where the separator has more vertices
  /// than allowed.
  bool divideQueue(const Step& part, Index most)
  {
    const auto order = this->Result.order.begin();
    const Index visited = part.end - part.begin;
    const auto queue = this->Queue.begin();
    // Beyond the last level is none, so that the one before it is the last that can separate.
    const Index middle =
      std::min(this->Level[queue[visited / 2]], this->Level[queue[visited - 1]] - 1);
    const auto levelBegin = std::partition_point(
      queue, queue + visited, [&](Index v) { return this->Level[v] < middle; });
    const auto levelEnd = std::partition_point(
      levelBegin, queue + visited, [&](Index v) { return this->Level[v] == middle; });
    // A vertex of the middle level that touches none beyond it need not separate.
    const auto separator =
      this->separate(levelBegin, levelEnd, [&](Index n) { return this->Level[n] == middle + 1; });
    if (levelEnd - separator > most)
    {
      return false;
    }
    const Index leftEnd = part.begin + static_cast<Index>(separator - queue);
    const Index rightEnd = part.end - static_cast<Index>(levelEnd - separator);
    this->assign(queue, separator);
    this->assign(levelEnd, queue + visited);
    std::copy(queue, separator, order + part.begin);
    std::copy(levelEnd, queue + visited, order + leftEnd);
    std::copy(separator, levelEnd, order + rightEnd);
    // The last of each half in the queue is the farthest from its first.
    this->pushEnd(part.end);
    this->pushPart(leftEnd, rightEnd, order[rightEnd - 1]);
    this->pushPart(part.begin, leftEnd, leftEnd > part.begin ? order[leftEnd - 1] : none);
    return true;
  }

  /// A part that does not hang together.
  void divideComponents(const Step& whole)
  {
    const auto order = this->Result.order.begin();
    const Indices vertices(order + whole.begin, order + whole.end);
    const Index part = this->Part[vertices.front()];
    Indices ends{ whole.begin };
    for (Index v : vertices)
    {
      if (this->Part[v] == part)
      {
        const Index visited = this->visit(v);
        std::copy(this->Queue.begin(), this->Queue.begin() + visited, order + ends.back());
        this->assign(this->Queue.begin(), this->Queue.begin() + visited);
        ends.push_back(ends.back() + visited);
      }
    }
    for (std::size_t k = ends.size() - 1; k > 0; --k)
    {
      this->pushPart(ends[k - 1], ends[k], order[ends[k] - 1]);
    }
  }

  Indices Level;
  Indices Queue;
  Index NextLevel = 0;
};

/// Halves parts by planes across their longest extent.
class PlaneDissector : LevelDissector
{
public:
  PlaneDissector(const Triangles& cliques, const Points3& positions, Separators separators)
    : LevelDissector(cliques, static_cast<Index>(positions.size()))
    , Positions(positions)
    , Fewest(separators == Separators::Fewest)
  {
  }

  Dissection run() { return this->divideAll(none); }

private:
  /// Where the vertices right of the separator begin, and where it does.
  struct Halves
  {
    Iterator right;
    Iterator separator;
  };

  void divide(const Step& part) override
  {
    const Iterator begin = this->Result.order.begin() + part.begin;
    const Iterator end = this->Result.order.begin() + part.end;
    Eigen::AlignedBox3d box;
    std::for_each(begin, end, [&](Index v) { box.extend(this->Positions[v]); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    this->Along.clear();
    std::for_each(
      begin, end, [&](Index v) { this->Along.emplace_back(this->Positions[v][axis], v); });
    const bool flow = this->Fewest && end - begin >= worthFlow;
    const Halves halves = flow ? this->halveByFlow(begin, end) : this->halveByPlane(begin, end);
    // A plane across many long triangles has more next to it than levels, which count edges.
    const auto cost = static_cast<Index>(end - halves.separator);
    if (cost > manyInSeparator * std::sqrt(static_cast<double>(end - begin)) &&
      this->divideByLevels(part, cost))
    {
      return;
    }
    const auto leftEnd = part.begin + static_cast<Index>(halves.right - begin);
    const auto rightEnd = part.begin + static_cast<Index>(halves.separator - begin);
    this->pushEnd(part.end);
    this->pushPart(leftEnd, rightEnd, none);
    this->pushPart(part.begin, leftEnd, none);
  }

  /// The separator are the vertices of the left half that are next to the plane.
  Halves halveByPlane(Iterator begin, Iterator end)
  {
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(
      this->Along.begin(), this->Along.begin() + (middle - begin), this->Along.end());
    std::transform(this->Along.begin(), this->Along.end(), begin,
      [](const std::pair<double, Index>& item) { return item.second; });
    this->assign(begin, middle);
    const Index right = this->assign(middle, end);
    const Iterator separator =
      this->separate(begin, middle, [&](Index n) { return this->Part[n] == right; });
    return { separator, std::rotate(separator, middle, end) };
  }

  /// The separator are as few vertices as any near the plane ("inertial flow": A. Schild, C.
  /// Sommer, "On balanced separators in road networks", 2015).
  Halves halveByFlow(Iterator begin, Iterator end)
  {
    using Side = VertexSeparator::Side;
    const auto count = static_cast<double>(end - begin);
    const double reach = std::min(nearPlane * count, rowsNearPlane * std::sqrt(count));
    const auto first = this->Along.begin() + static_cast<std::ptrdiff_t>(0.5 * count - reach);
    const auto last = this->Along.begin() + static_cast<std::ptrdiff_t>(0.5 * count + reach);
    std::nth_element(this->Along.begin(), first, this->Along.end());
    std::nth_element(first, last, this->Along.end());
    const auto setSides = [this](auto from, auto to, Side side) {
      std::for_each(from, to, [&](const auto& item) { this->Flow.setSide(item.second, side); });
    };
    setSides(this->Along.begin(), first, Side::Left);
    setSides(first, last, Side::Between);
    setSides(last, this->Along.end(), Side::Right);
    // A long edge may lead from one side to the other.
    const auto outer = std::partition(this->Along.begin(), first, [&](const auto& item) {
      return std::none_of(this->Neighbours.begin() + this->Begin[item.second],
        this->Neighbours.begin() + this->Begin[item.second + 1],
        [&](Index n) { return this->Flow.side(n) == Side::Right; });
    });
    setSides(outer, first, Side::Between);
    std::sort(outer, last);
    this->Between.clear();
    std::transform(
      outer, last, std::back_inserter(this->Between), [](const auto& item) { return item.second; });
    const bool few =
      this->Flow.separate(this->Between, static_cast<Index>(manyInSeparator * std::sqrt(count)));
    const auto is = [this](Side side) {
      return [this, side](Index v) { return this->Flow.side(v) == side; };
    };
    const Iterator right = std::stable_partition(begin, end, is(Side::Left));
    const Iterator separator = std::stable_partition(right, end, is(Side::Right));
    setSides(this->Along.begin(), this->Along.end(), Side::Outside);
    const bool halved = few && right != begin && separator != right;
    return halved ? Halves{ right, separator } : this->halveByPlane(begin, end);
  }

  /// In parts of at least this many vertices the fewest that separate are looked for, among those
  /// that are nearest to the plane: on each side of it this share of the part, and no more than
  /// some rows, since the time that the search takes grows faster than what it gains.
  static constexpr Index worthFlow = 100;
  static constexpr double nearPlane = 0.1;
  static constexpr double rowsNearPlane = 4.0;
  /// A separator of more vertices than this multiple of the root of the part's is a bad one.
  static constexpr double manyInSeparator = 2.0;

  const Points3& Positions;
  bool Fewest;
  std::vector<std::pair<double, Index>> Along; ///< coordinate across the plane, vertex
  VertexSeparator Flow{ this->Begin, this->Neighbours };
  Indices Between;
};
}

Dissection dissect(const Triangles& cliques, const Points3& positions, Separators separators)
{
  return PlaneDissector(cliques, positions, separators).run();
}

Dissection dissect(const Triangles& cliques, Index count)
{
  return LevelDissector(cliques, count).run();
}
}
