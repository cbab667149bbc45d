// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/BorderMarks.h"

#include "Fairing/BorderChains.h"

#include <map>
#include <set>

namespace flattening
{
namespace pattern
{
namespace
{
struct CurveEnd
{
  std::string name;
  double arcLength = 0.0;
};

class MarkFinder
{
public:
  explicit MarkFinder(const DrawingSource& all)
    : All(all)
    , Chains(all)
  {
    for (std::size_t p = 0; p < all.loops.size(); ++p)
    {
      this->Borders += all.loops[p].size();
      if (all.options.darts == DartStyle::CutOut)
      {
        continue;
      }
      for (const Dart& dart : findDarts(all.source, all.loops[p], all.wires, all.partners))
      {
        this->OfDarts.insert({ dart.tip, dart.otherTip, dart.mouth[0], dart.mouth[1] });
      }
    }
    this->findEnds();
  }

  std::vector<BorderMark> find() const
  {
    std::vector<BorderMark> marks;
    for (std::size_t c = 0; c < this->Borders; ++c)
    {
      const BorderChain& chain = this->Chains.chains()[c];
      const std::size_t count = chain.points.size();
      for (std::size_t k = 0; k < count; ++k)
      {
        const Index point = chain.points[k];
        BorderMark mark;
        mark.piece = chain.piece;
        mark.before = chain.points[(k + count - 1) % count];
        mark.point = point;
        mark.after = chain.points[(k + 1) % count];
        mark.corner = chain.turns[k];
        const auto end = this->Ends.find(point);
        const bool isWanted =
          mark.corner ? this->All.options.notchCorners : this->All.options.notchCurveEnds;
        if (!isWanted || this->OfDarts.count(point) > 0 ||
          (!mark.corner && end == this->Ends.end()))
        {
          continue;
        }
        if (end != this->Ends.end())
        {
          mark.name = end->second.name;
          mark.arcLength = end->second.arcLength;
        }
        marks.push_back(std::move(mark));
      }
    }
    return marks;
  }

private:
  /// The ends of all curves but the boundary's, and the places that are sewn to them.
  void findEnds()
  {
    const PatternSource& source = this->All.source;
    for (const SourceWire& wire : source.wires)
    {
      if (wire.type == WireType::Boundary || wire.points.size() < 2 ||
        wire.points.front() == wire.points.back())
      {
        continue;
      }
      double length = 0.0;
      for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
      {
        length += lengthOnSurface(source, wire.points[k], wire.points[k + 1]);
      }
      this->Ends.insert({ wire.points.front(), { wire.name, 0.0 } });
      this->Ends.insert({ wire.points.back(), { wire.name, length } });
    }
    const std::map<Index, CurveEnd> own = this->Ends;
    for (const SewnEdges& pair : source.sewn)
    {
      for (std::size_t end = 0; end < 2; ++end)
      {
        for (const auto& [one, other] :
          { std::array{ pair.a[end], pair.b[end] }, std::array{ pair.b[end], pair.a[end] } })
        {
          const auto found = own.find(one);
          if (found != own.end())
          {
            this->Ends.insert({ other, found->second });
          }
        }
      }
    }
  }

  const DrawingSource& All;
  const BorderChains Chains;
  std::size_t Borders = 0; ///< the first of the chains
  std::set<Index> OfDarts;
  std::map<Index, CurveEnd> Ends;
};
}

std::vector<BorderMark> findBorderMarks(const DrawingSource& all)
{
  const bool any = all.options.notchCorners || all.options.notchCurveEnds;
  return any ? MarkFinder(all).find() : std::vector<BorderMark>();
}
}
}
