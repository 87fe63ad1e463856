// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of claim 4's sections: any bytes give a certificate that encodes to the same
// sections, or Malformed. The first two bytes divide the rest.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "certify/container/container.hpp"
#include "certify/ridges_smooth/decode.hpp"
#include "certify/ridges_smooth/encode.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crest::certify;
  if (size < 2) return 0;
  const std::span<const std::uint8_t> rest(data + 2, size - 2);
  const std::size_t split = std::min(rest.size(), data[0] + std::size_t{256} * data[1]);
  try {
    const auto c = decode_ridges_smooth(rest.first(split), rest.subspan(split));
    const Bytes bytes = encode(c);
    const Container container = open_container(bytes);
    if (!std::ranges::equal(container.data, rest.first(split)) ||
        !std::ranges::equal(container.claims, rest.subspan(split)))
      abort();
  } catch (const Malformed&) {
  }
  return 0;
}
