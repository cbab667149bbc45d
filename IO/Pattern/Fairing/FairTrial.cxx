// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairTrial.h"

#include "Fairing/OutlineMirror.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace flattening::pattern
{
namespace
{
constexpr double leastFactor = 0.2;
constexpr double leastWeight = 0.01;
constexpr int emphasesOfTrial = 12; ///< of one set of breaks
/// A trial takes time in proportion to the curves, and a tolerance far below what the points need
/// makes more curves than there are edges: fewer trials are left to these.
constexpr std::size_t spansOfTrial = 100;
constexpr double hopeless = 1.5;   ///< tolerances, after some emphases
constexpr double atMiddle = 1e-6;  ///< of a stretch, from its middle
constexpr int roundsOfBalance = 8; ///< of a number of curves
constexpr double leastOff = 0.1;   ///< of a curve in what its length is chosen by
constexpr double balancing = 0.4;  ///< power of how far off it is
constexpr int smoothings = 6;
constexpr double widerWave = 1.6;
constexpr double sparing = 0.5; ///< of the tolerance, what may be spent on smoothness alone
/// Parts of 1 in what one trial gives to the next: far above rounding errors, and 0.02 % of a
/// weight or span, which decides nothing else.
constexpr double grid = 1 << 12;

/// Rounds what one trial gives to the next, so that rounding errors do not grow from trial to
/// trial: the curves would be others on another processor.
double rounded(double share)
{
  return std::round(share * grid) / grid;
}

/// Splines for a stretch, with that of its mirror image if it is to have one.
class FairTrial
{
public:
  FairTrial(const FairNetwork& network, const std::vector<std::size_t>& parts, const Points2& nodes,
    double wave)
    : Wave(wave)
  {
    const auto take = [&](std::size_t node) {
      this->Network.nodes.push_back(nodes[node]);
      return this->Network.nodes.size() - 1;
    };
    for (const std::size_t part : parts)
    {
      FairStretch one = network.stretches[part];
      const bool ring = one.from == one.to;
      one.from = take(one.from);
      one.to = ring ? one.from : take(one.to);
      for (FairHook& hook : one.hooks)
      {
        hook.node = take(hook.node);
      }
      this->Network.stretches.push_back(std::move(one));
    }
    this->Network.held = true;
    this->Network.axis = network.axis;
    for (const MirroredStretches& pair : network.images)
    {
      if (pair.one == parts.front())
      {
        this->Network.images.push_back({ 0, parts.size() - 1 });
      }
    }
  }

  std::optional<SimplerStretches> simplify(std::size_t leastSpans)
  {
    if (!this->fits())
    {
      return std::nullopt;
    }
    // As if what a number of curves does more of them did as well.
    std::size_t low = leastSpans;
    while (low < this->spans() && this->Left > 0)
    {
      const std::size_t middle = (low + this->spans() - 1) / 2;
      low = this->divide(middle) ? low : middle + 1;
    }
    this->join(leastSpans);
    for (int k = 0; k < smoothings; ++k)
    {
      this->Wave *= widerWave;
      this->solve();
      if (!this->Last.converged || this->largestShare(true) > sparing)
      {
        break;
      }
      this->Found = this->Last;
    }
    return SimplerStretches{ this->Network.stretches, this->Found };
  }

private:
  /// Whether the stretch is to be its own mirror image.
  bool isOwnImage() const
  {
    return !this->Network.images.empty() && this->Network.stretches.size() == 1;
  }

  /// Sets breaks, and their images where curves are such.
  void setBreaks(std::vector<double> breaks)
  {
    if (this->isOwnImage())
    {
      const double end = breaks.back();
      const auto isImage = [end](double at) { return 2.0 * at > (1.0 + atMiddle) * end; };
      breaks.erase(std::find_if(breaks.begin(), breaks.end(), isImage), breaks.end());
      for (std::size_t k = breaks.size(); k-- > 0;)
      {
        if (2.0 * breaks[k] < (1.0 - atMiddle) * end)
        {
          breaks.push_back(end - breaks[k]);
        }
      }
    }
    for (FairStretch& one : this->Network.stretches)
    {
      one.breaks = &one == &this->Network.stretches.front()
        ? breaks
        : mirroredBreaks(breaks, one.breaks.front(), one.breaks.back());
    }
  }

  /// Looks for a number of curves of which each is as far off as the others.
  bool divide(std::size_t spans)
  {
    const std::vector<FairStretch> before = this->Network.stretches;
    // From the breaks that there are: where more were needed more will be.
    const std::vector<double>& old = before.front().breaks;
    std::vector<double> breaks;
    for (std::size_t k = 0; k < spans; ++k)
    {
      const double at =
        static_cast<double>(k) * static_cast<double>(old.size() - 1) / static_cast<double>(spans);
      const auto whole = static_cast<std::size_t>(at);
      const double part = at - static_cast<double>(whole);
      breaks.push_back(old[whole] + part * (old[whole + 1] - old[whole]));
    }
    breaks.push_back(old.back());
    for (int round = 0; this->Left > 0 && round < roundsOfBalance; ++round)
    {
      this->Network.stretches = before;
      this->setBreaks(breaks);
      for (FairStretch& one : this->Network.stretches)
      {
        std::fill(one.weights.begin(), one.weights.end(), 1.0);
      }
      if (this->fits())
      {
        return true;
      }
      if (spans == 1 || !this->Last.converged)
      {
        break;
      }
      this->balance(breaks);
    }
    this->Network.stretches = before;
    return false;
  }

  /// Shortens the curves that are farther off than others.
  void balance(std::vector<double>& breaks) const
  {
    std::vector<double> ends{ 0.0 };
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      const double most = this->mostBetween(breaks[k], breaks[k + 1]);
      ends.push_back(ends.back() + (breaks[k + 1] - breaks[k]) * std::pow(most, -balancing));
    }
    const auto spans = static_cast<double>(breaks.size() - 1);
    for (std::size_t k = 1; k + 1 < breaks.size(); ++k)
    {
      breaks[k] = rounded(spans * ends[k] / ends.back()) / spans * breaks.back();
    }
  }

  /// The farthest of the points between two breaks and of those whose images are.
  double mostBetween(double start, double end) const
  {
    const double whole = this->Network.stretches.front().length();
    double most = leastOff;
    for (std::size_t s = 0; s < this->Network.stretches.size(); ++s)
    {
      const FairStretch& stretch = this->Network.stretches[s];
      const std::vector<double> shares = sharesOf(stretch, this->Last.deviation[s]);
      for (std::size_t p = 1; p + 1 < stretch.arc.size(); ++p)
      {
        const double image = (1.0 - stretch.arc[p] / stretch.length()) * whole;
        const bool within = s == 0 && stretch.arc[p] >= start && stretch.arc[p] <= end;
        const bool imageWithin = (s > 0 || this->isOwnImage()) && image >= start && image <= end;
        most = within || imageWithin ? std::max(most, shares[p]) : most;
      }
    }
    return most;
  }

  /// Takes away each break without which the tolerances are kept as well, or puts one in the middle
  /// of two.
  void join(std::size_t leastSpans)
  {
    std::size_t start = 0;
    for (bool joined = true; joined && this->Left > 0;)
    {
      joined = false;
      const std::vector<FairStretch> before = this->Network.stretches;
      const std::vector<double>& all = before.front().breaks;
      const std::size_t within = this->isOwnImage() ? (all.size() - 1) / 2 : all.size() - 2;
      for (std::size_t n = 0; !joined && n<2 * within&& this->spans()> leastSpans; ++n)
      {
        // On from where the last one was: what was needed there is needed still.
        const std::size_t k = 1 + (start + n / 2) % within;
        std::vector<double> fewer = all;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
        if (n % 2 == 1 && k == within)
        {
          continue;
        }
        fewer[k] = n % 2 == 1 ? (all[k] + all[k + 1]) / 2.0 : fewer[k];
        this->setBreaks(fewer);
        joined = this->fits();
        start = joined ? k - 1 : start;
        if (!joined)
        {
          this->Network.stretches = before;
        }
      }
    }
  }

  void solve()
  {
    this->Left -= 1 + static_cast<int>(this->spans() / spansOfTrial);
    this->Last = solveFairNetwork(this->Network, this->Wave);
    // Its length is neither seen nor measured right.
    for (const std::vector<FairSpan>& curve : this->Last.spans)
    {
      this->Last.converged = this->Last.converged &&
        std::none_of(
          curve.begin(), curve.end(), [](const FairSpan& one) { return one.turnsBack(); });
    }
  }

  static std::vector<double> sharesOf(const FairStretch& stretch, const std::vector<double>& off)
  {
    std::vector<double> shares;
    for (std::size_t p = 0; p < off.size(); ++p)
    {
      shares.push_back(off[p] / stretch.tolerances[p]);
    }
    return shares;
  }

  /// The largest deviation over its tolerance. \param ends those that stay count as well
  double largestShare(bool ends) const
  {
    double most = 0.0;
    for (std::size_t s = 0; s < this->Network.stretches.size(); ++s)
    {
      const std::vector<double> own = sharesOf(this->Network.stretches[s], this->Last.deviation[s]);
      const std::ptrdiff_t skipped = ends ? 0 : 1;
      for (auto share = own.begin() + skipped; share != own.end() - skipped; ++share)
      {
        most = std::max(most, *share);
      }
    }
    return most;
  }

  /// Whether there is a spline with the breaks as they are that keeps the tolerances; the points
  /// move along it to where it is nearest to them.
  bool fits()
  {
    for (int k = 0; this->Left > 0 && k < emphasesOfTrial; ++k)
    {
      this->solve();
      if (!this->Last.converged)
      {
        return false;
      }
      const double most = this->largestShare(false);
      if (most <= 1.0)
      {
        this->Found = this->Last;
        return true;
      }
      if (k > 1 && most > hopeless)
      {
        return false;
      }
      for (std::size_t s = 0; s < this->Network.stretches.size(); ++s)
      {
        FairStretch& one = this->Network.stretches[s];
        std::vector<double> shares = sharesOf(one, this->Last.deviation[s]);
        shares.front() = shares.back() = 0.0;
        if (*std::max_element(shares.begin(), shares.end()) > 0.0)
        {
          emphasize(shares, one.weights);
        }
        follow(this->Last.nearest[s], one);
      }
    }
    return false;
  }

  /// Lets the points be where the curve is nearest to them, but those that others hang on.
  static void follow(const std::vector<double>& nearest, FairStretch& one)
  {
    for (std::size_t p = 1; p + 1 < one.arc.size(); ++p)
    {
      const double low = one.arc[p - 1];
      const double width = one.arc[p + 1] - low;
      const double at = rounded((nearest[p] - low) / width);
      if (!one.isHook(p) && 0.0 < at && at < 1.0)
      {
        one.arc[p] = low + at * width;
      }
    }
  }

  std::size_t spans() const { return this->Network.stretches.front().breaks.size() - 1; }

  FairNetwork Network;
  double Wave;
  FairCurves Last;  ///< that was solved
  FairCurves Found; ///< the last that keeps the tolerances
  int Left = 1000;  ///< trials that are left, of spansOfTrial curves each
};
}

void emphasize(const std::vector<double>& shares, std::vector<double>& weights)
{
  const double most = *std::max_element(shares.begin(), shares.end());
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    weights[k] *= leastFactor + shares[k] / most;
  }
  const double mean =
    std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  for (double& weight : weights)
  {
    weight = std::max(rounded(weight / mean), leastWeight);
  }
}

std::optional<SimplerStretches> simplerStretches(const FairNetwork& network,
  const std::vector<std::size_t>& parts, const Points2& nodes, double wave, std::size_t leastSpans)
{
  return FairTrial(network, parts, nodes, wave).simplify(leastSpans);
}
}
