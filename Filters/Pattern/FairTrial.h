// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FairNetwork.h"

namespace flattening
{
namespace pattern
{
/// Joins the cubic curves of the spline of one stretch, between nodes that stay where they are;
/// with them those of its mirror image, if it is to have one.
class FairTrial
{
public:
  /// A stretch of a network.
  struct Part
  {
    std::size_t stretch = 0;
    std::vector<double> tolerances; ///< of its points, those of its ends among them
  };

  /// \param network of which they are stretches \param nodes where they are
  /// \param parts the stretch, and the one that is to be its mirror image, if that is another
  FairTrial(
    const FairNetwork& network, const std::vector<Part>& parts, const Points2& nodes, double wave);

  /// Takes away each break without which the tolerances are kept as well, and puts one in the
  /// middle of two. \return whether any was
  bool join(std::size_t leastSpans);

  const std::vector<double>& breaks(std::size_t part) const
  {
    return this->Network.stretches[part].breaks;
  }
  /// Of all points.
  const std::vector<double>& weights(std::size_t part) const { return this->Weights[part]; }

private:
  /// Whether the stretch is to be its own mirror image.
  bool isOwnImage() const;
  /// Ends of the stretch, and the breaks between them that follow from no others.
  std::vector<double> freeBreaks() const;
  void setBreaks(const std::vector<double>& freeBreaks);
  /// Whether there is a spline with the breaks as they are that keeps the tolerances.
  bool fits();
  bool take(const std::vector<double>& freeBreaks);

  FairNetwork Network;
  std::vector<std::vector<double>> Tolerances; ///< by part
  std::vector<std::vector<double>> Weights;
  double Wave;
  int Left; ///< solutions that may still be tried
};
}
}
