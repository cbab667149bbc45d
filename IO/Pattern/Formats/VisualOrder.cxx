// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/VisualOrder.h"

#include <fribidi.h>

#include <algorithm>
#include <new>
#include <vector>

namespace flattening::pattern
{
std::string visualOrder(const std::string& text)
{
  constexpr std::size_t bytesOfACharacter = 4;
  std::vector<FriBidiChar> line(text.size() + 1);
  line.resize(static_cast<std::size_t>(fribidi_charset_to_unicode(
    FRIBIDI_CHAR_SET_UTF8, text.c_str(), static_cast<FriBidiStrIndex>(text.size()), line.data())));
  const auto length = static_cast<FriBidiStrIndex>(line.size());
  std::vector<FriBidiCharType> types(line.size());
  fribidi_get_bidi_types(line.data(), length, types.data());
  if (std::none_of(types.begin(), types.end(),
        [](FriBidiCharType type) { return FRIBIDI_IS_LETTER(type) && FRIBIDI_IS_RTL(type); }))
  {
    return text;
  }
  const bool fromLeft = std::find(types.begin(), types.end(), FRIBIDI_TYPE_LTR) != types.end();
  FriBidiParType direction = fromLeft ? FRIBIDI_PAR_LTR : FRIBIDI_PAR_RTL;
  std::vector<FriBidiChar> drawn(line.size() + 1); // as it ends with a zero
  if (fribidi_log2vis(line.data(), length, &direction, drawn.data(), nullptr, nullptr, nullptr) ==
    0)
  {
    throw std::bad_alloc(); // its only error
  }
  const FriBidiStrIndex left =
    fribidi_remove_bidi_marks(drawn.data(), length, nullptr, nullptr, nullptr);
  std::string result(bytesOfACharacter * static_cast<std::size_t>(length) + 1, '\0');
  result.resize(static_cast<std::size_t>(
    fribidi_unicode_to_charset(FRIBIDI_CHAR_SET_UTF8, drawn.data(), left, result.data())));
  return result;
}
}
