// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairNetwork.h"

#include <cstddef>
#include <vector>

namespace flattening::pattern
{
/// Weights of points for the next curve of least squares, which become those of the curve whose
/// farthest point is nearest. C. L. Lawson, Contributions to the theory of linear least maximum
/// approximation, thesis, University of California, 1961.
/// \param shares of each point, its deviation over its tolerance; some are not 0
void emphasize(const std::vector<double>& shares, std::vector<double>& weights);

/// A spline for one stretch of as few cubic curves as are found, between nodes that stay where
/// they are; with it that of its mirror image, if it is to have one.
class FairTrial
{
public:
  /// \param parts numbers of the stretch, and of that which is to be its mirror image, if that is
  /// another
  /// \param nodes of the network, where they are
  FairTrial(const FairNetwork& network, const std::vector<std::size_t>& parts, const Points2& nodes,
    double wave);
  const FairStretch& stretch(std::size_t part) const { return this->Network.stretches[part]; }
  const FairCurves& curves() const { return this->Found; }
  /// Looks for the fewest curves that keep the tolerances, and takes longer waves away if this
  /// costs nothing that is seen. \return whether the tolerances are kept at all
  bool simplify(std::size_t leastSpans);

private:
  /// Whether the stretch is to be its own mirror image.
  bool isOwnImage() const;
  std::size_t spans() const { return this->Network.stretches.front().breaks.size() - 1; }
  /// Sets breaks, and their images where curves are such.
  void setBreaks(std::vector<double> breaks);
  /// Looks for a number of curves of which each is as far off as the others.
  bool divide(std::size_t spans);
  /// Shortens the curves that are farther off than others.
  void balance(std::vector<double>& breaks) const;
  /// The farthest of the points between two breaks and of those whose images are.
  double mostBetween(double start, double end) const;
  /// Takes away each break without which the tolerances are kept as well, or puts one in the middle
  /// of two.
  void join(std::size_t leastSpans);
  void solve();
  static std::vector<double> sharesOf(const FairStretch& stretch, const std::vector<double>& off);
  /// The largest deviation over its tolerance. \param ends those that stay count as well
  double largestShare(bool ends) const;
  /// Whether there is a spline with the breaks as they are that keeps the tolerances; the points
  /// move along it to where it is nearest to them.
  bool fits();
  /// Lets the points be where the curve is nearest to them, but those that others hang on.
  static void follow(const std::vector<double>& nearest, FairStretch& one);

  FairNetwork Network;
  double Wave;
  FairCurves Last;  ///< that was solved
  FairCurves Found; ///< the last that keeps the tolerances
  int Left = 1000;  ///< that may still be tried
};
}
