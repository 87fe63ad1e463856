// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_isosurface/decode.hpp"

#include <algorithm>

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

void require_form(bool condition, const char* what) {
  if (!condition) throw Malformed(what);
}

}  // namespace

SplineIsosurfaceCertificate decode_spline_isosurface(std::span<const std::uint8_t> data,
                                                     std::span<const std::uint8_t> claims) {
  SplineIsosurfaceCertificate c;
  ByteReader section(data);
  c.volume = read_volume(section);
  require_form(section.left() == 0, "data section: bytes left over");
  ByteReader reader(claims);
  reader.words(c.bisected, reader.integer<std::uint32_t>());
  const auto trees = reader.take(reader.integer<std::uint32_t>());
  c.trees.assign(trees.begin(), trees.end());
  require_form(std::ranges::all_of(
                   c.trees, [](std::uint8_t node) { return node <= spline_code::kBisected; }),
               "claim section: no such code of a node");
  reader.rows(c.brackets, reader.integer<std::uint32_t>());
  require_plain_rows(c.brackets, "brackets");
  require_form(std::ranges::all_of(c.brackets,
                                   [](const std::array<double, 2>& bracket) {
                                     return bracket[0] >= 0 && bracket[0] <= bracket[1] &&
                                            bracket[1] <= 1;
                                   }),
               "claim section: a bracket is not in [0, 1] or not in order");
  reader.rows(c.triangles, reader.integer<std::uint32_t>());
  c.euler_characteristic = reader.integer<std::int32_t>();
  c.components = reader.integer<std::uint32_t>();
  c.boundary_loops = reader.integer<std::uint32_t>();
  require_form(reader.left() == 0, "claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
