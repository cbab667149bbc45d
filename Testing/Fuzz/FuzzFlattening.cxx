// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's entry: any bytes are a surface with curves and options.
#include "HostileSurface.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  hostile::Bytes bytes(data, size);
  const hostile::Verdict verdict =
    hostile::tryCase(hostile::decodeCase(bytes, hostile::dataSpecimens(), hostile::fuzzedSizes));
  if (!verdict.fault.empty())
  {
    std::fprintf(stderr, "%s\n", verdict.fault.c_str());
    std::abort();
  }
  return 0;
}
