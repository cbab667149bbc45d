// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairSolver.h"

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
  /// A stretch of a network.
  struct Part
  {
    std::size_t stretch = 0;
    std::vector<double> tolerances; ///< of its points, those of its ends among them
  };

  /// \param network of which they are stretches
  /// \param parts the stretch, and the one that is to be its mirror image, if that is another
  /// \param nodes of the network, where they are
  FairTrial(
    const FairNetwork& network, const std::vector<Part>& parts, const Points2& nodes, double wave);

  /// Looks for the fewest curves that keep the tolerances. \return whether there are any
  bool findFewest(std::size_t leastSpans);
  /// Takes away longer waves as long as this costs nothing that is seen.
  void smooth();

  /// Of all points.
  const std::vector<double>& weights(std::size_t part) const { return this->Weights[part]; }
  const std::vector<FairSpan>& spans(std::size_t part) const { return this->Found.spans[part]; }
  /// Of all points, millimetres.
  const std::vector<double>& deviation(std::size_t part) const
  {
    return this->Found.deviation[part];
  }

private:
  using Lists = std::vector<std::vector<double>>; ///< by part

  const std::vector<double>& breaks() const { return this->Network.stretches.front().breaks; }
  /// Whether the stretch is to be its own mirror image.
  bool isOwnImage() const;
  /// Breaks without those that follow, since they are images of others.
  std::vector<double> freeOf(std::vector<double> breaks) const;
  void setBreaks(const std::vector<double>& freeBreaks);
  /// Takes away each break without which the tolerances are kept as well, and puts one in the
  /// middle of two.
  void join(std::size_t leastSpans);
  /// Looks for so many curves, of which each is as far off as the others.
  bool divide(std::size_t spans);
  /// Shortens the curves that are farther off than others. \return whether that is known
  bool balance(std::vector<double>& breaks) const;
  /// The farthest of the points between two breaks and of those whose images are, as balance()
  /// needs it.
  double mostBetween(double start, double end) const;
  /// Whether there is a spline with the breaks as they are that keeps the tolerances.
  bool fits();
  bool take(const std::vector<double>& freeBreaks);
  /// Lets the points be where the curve is nearest to them, but those that others hang on.
  void follow(const Lists& nearest);
  /// Solves with the weights as they are. \return false: there is no solution
  bool solve(FairCurves& curves);

  FairNetwork Network;
  Lists Tolerances;
  double Wave;
  Lists Arcs; ///< of the points, along the last spline that keeps the tolerances
  Lists Weights;
  FairCurves Found; ///< the last that keeps the tolerances
  Lists Shares;     ///< of the points of the last solution: deviation over tolerance
  int Left;         ///< solutions that may still be tried
};
}
