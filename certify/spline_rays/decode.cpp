// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/decode.hpp"

#include <algorithm>

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

void require_form(bool condition, const char* what) {
  if (!condition) throw Malformed(what);
}

double read_parameter(ByteReader& reader) {
  const auto bits = reader.integer<std::uint64_t>();
  require_plain(is_plain(bits), "parameters of hits");
  return std::bit_cast<double>(bits);
}

}  // namespace

SplineRaysCertificate decode_spline_rays(std::span<const std::uint8_t> data,
                                         std::span<const std::uint8_t> claims) {
  SplineRaysCertificate c;
  ByteReader section(data);
  c.volume = read_volume(section);
  section.rows(c.rays, section.integer<std::uint32_t>());
  require_plain_rows(c.rays, "rays");
  require_form(section.left() == 0, "data section: bytes left over");
  ByteReader reader(claims);
  const auto meets = reader.take(c.rays.size());
  c.meets.assign(meets.begin(), meets.end());
  require_form(std::ranges::all_of(c.meets, [](std::uint8_t flag) { return flag <= 1; }),
               "claim section: a flag is neither 0 nor 1");
  c.hits.resize(static_cast<std::size_t>(std::ranges::count(c.meets, 1)));
  require_form(c.hits.size() <= reader.left() / 21, "section ends early");
  for (SplineHit& hit : c.hits) {
    hit.cube = reader.integer<std::uint32_t>();
    hit.tetrahedron = reader.integer<std::uint8_t>();
    hit.low = read_parameter(reader);
    hit.high = read_parameter(reader);
    require_form(hit.low >= 0 && hit.low <= hit.high,
                 "claim section: the parameters of a hit are negative or not in order");
  }
  require_form(reader.left() == 0, "claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
