// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/LevelDissector.h"
#include "Sparse/VertexSeparator.h"

#include <cmath>
#include <iterator>

namespace flattening
{
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

  /// In parts of so many vertices on the fewest that separate are looked for, among those that are
  /// nearest to the plane: on each side of it this share of the part, and no more than some rows,
  /// since the time that the search takes grows faster than what it gains.
  static constexpr Index worthFlow = 100;
  static constexpr double nearPlane = 0.1;
  static constexpr double rowsNearPlane = 4.0;
  /// A separator of more vertices than so many times the root of the part's is a bad one.
  static constexpr double manyInSeparator = 2.0;

  const Points3& Positions;
  bool Fewest;
  std::vector<std::pair<double, Index>> Along; ///< coordinate across the plane, vertex
  VertexSeparator Flow{ this->Begin, this->Neighbours };
  Indices Between;
};
}
