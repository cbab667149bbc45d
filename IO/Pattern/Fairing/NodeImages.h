// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairNetwork.h"

#include <cstddef>
#include <vector>

namespace flattening
{
namespace pattern
{
/// Which node is the image of which, as far as that follows.
class NodeImages
{
public:
  explicit NodeImages(const FairNetwork& network)
    : Images(network.nodes.size(), unknown)
    , Hooked(network.nodes.size(), false)
  {
    for (const FairStretch& stretch : network.stretches)
    {
      for (const FairHook& hook : stretch.hooks)
      {
        this->Hooked[hook.node] = true;
      }
    }
  }

  /// Whether one may be the image of the other: what hangs on a curve only if it does so there.
  bool mayBe(std::size_t one, std::size_t other) const
  {
    return this->Images[one] == unknown && this->Images[other] == unknown
      ? !this->Hooked[one] && !this->Hooked[other]
      : this->Images[one] == other && this->Images[other] == one;
  }

  bool areUnknown(std::size_t one, std::size_t other) const
  {
    return this->Images[one] == unknown && this->Images[other] == unknown;
  }

  void join(std::size_t one, std::size_t other)
  {
    this->Images[one] = other;
    this->Images[other] = one;
  }

private:
  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  std::vector<std::size_t> Images;
  std::vector<bool> Hooked;
};
}
}
