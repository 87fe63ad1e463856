// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/encode.hpp"

#include "certify/container/compose.hpp"

namespace crest::certify {

Bytes encode(const ModesCertificate& c) {
  std::size_t data_size = 8 + sizeof(double) * 3 * c.points.size();
  data_size += sizeof(std::uint32_t) * 4 * c.cells.size();
  const auto write_data = [&](ByteWriter& out) {
    out.count(c.points.size());
    out.count(c.cells.size());
    out.rows(c.points);
    for (const auto& cell : c.cells) out.numbers(std::span<const std::uint32_t>(cell));
  };
  const auto write_claims = [&](ByteWriter& out) {
    out.integer(c.distinct);
    out.integer(c.used);
  };
  return compose({kModes, kModesVersion}, data_size, write_data, write_claims);
}

}  // namespace crest::certify
