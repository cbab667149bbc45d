// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <gtest/gtest.h>

#include <algorithm>

/// What holds for every status.
namespace statustesting
{
using namespace flattening;

/// The code of a status, which names the defect and a remedy wherever it is not Ok.
inline StatusCode codeOf(const Status& status)
{
  EXPECT_EQ(status.ok(), status.message.empty()) << status.message;
  EXPECT_EQ(status.ok() || status.code == StatusCode::Cancelled, status.remedies.empty())
    << status.message;
  return status.code;
}

inline bool has(const Status& status, Remedy remedy)
{
  return std::any_of(status.remedies.begin(), status.remedies.end(),
    [remedy](const SuggestedRemedy& suggested) { return suggested.remedy == remedy; });
}
}
