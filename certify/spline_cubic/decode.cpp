// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_cubic/decode.hpp"

#include <cmath>

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

void require_form(bool condition, const char* what) {
  if (!condition) throw Malformed(what);
}

double read_number(ByteReader& reader, const char* what) {
  const auto bits = reader.integer<std::uint64_t>();
  require_plain(is_plain(bits), what);
  return std::bit_cast<double>(bits);
}

/// `first` is the exponent of the unit of a row's first number, `others` that of the rest, both
/// counted from that of u.
template <std::size_t n>
void read_rows(ByteReader& reader, const SplineCubicData& data,
               std::vector<std::array<double, n>>& rows, std::size_t count, int first, int others,
               const char* what) {
  if (!data.integers) {
    reader.rows(rows, count);
    return require_plain_rows(rows, what);
  }
  require_form(count <= reader.left() / (8 * n), "section ends early");
  // Powers of two, so products are exact.
  const double unit[2] = {std::ldexp(1.0, data.exponent + first),
                          std::ldexp(1.0, data.exponent + others)};
  constexpr std::int64_t kMost = std::int64_t{1} << 53;
  bool good = true;
  rows.resize(count);
  for (auto& row : rows)
    for (std::size_t k = 0; k < n; ++k) {
      const auto x = reader.integer<std::int64_t>();
      good = x > -kMost && x < kMost && good;
      row[k] = static_cast<double>(x) * unit[k == 0 ? 0 : 1];
    }
  require_form(good, "data section: an integer is not below 2^53");
}

void read_grid(ByteReader& reader, SplineCubicData& data) {
  for (double& x : data.box) x = read_number(reader, "box");
  for (std::size_t d = 0; d < 3; ++d)
    require_form(data.box[2 * d] < data.box[2 * d + 1], "data section: the box is empty");
  std::uint64_t cubes = 1;
  for (auto& n : data.cubes) {
    n = reader.integer<std::uint32_t>();
    require_form(n >= 1, "data section: no cube along an axis");
    cubes *= n;
    require_form(cubes <= 0x8000000U, "data section: more than 2^27 cubes");
  }
  const std::size_t runs = reader.integer<std::uint32_t>();
  require_form(runs <= reader.left() / 8, "section ends early");
  data.domain.resize(runs);
  for (SplineCubeRun& run : data.domain) {
    run.first = reader.integer<std::uint32_t>();
    run.length = reader.integer<std::uint32_t>();
  }
}

SplineCubicData read_data(std::span<const std::uint8_t> section) {
  ByteReader reader(section);
  SplineCubicData data;
  const auto kind = reader.integer<std::uint8_t>();
  require_form(kind <= 1, "data section: a flag is neither 0 nor 1");
  data.integers = kind == 1;
  data.exponent = reader.integer<std::int32_t>();
  require_form(data.integers ? data.exponent >= -1060 && data.exponent <= 954 : data.exponent == 0,
               "data section: no such unit");
  read_grid(reader, data);
  const auto [nx, ny, nz] = data.cubes;
  const std::size_t vertices = (std::size_t{nx} + 1) * (ny + 1) * (nz + 1);
  read_rows(reader, data, data.vertices, vertices, 0, 1, "vertices");
  read_rows(reader, data, data.slopes, vertices, 0, 0, "slopes");
  read_rows(reader, data, data.centres, std::size_t{nx} * ny * nz, -3, -2, "centres");
  data.outside = reader.integer<std::uint64_t>();
  reader.rows(data.samples, reader.integer<std::uint32_t>());
  require_plain_rows(data.samples, "samples");
  require_form(reader.left() == 0, "data section: bytes left over");
  return data;
}

}  // namespace

SplineCubicCertificate decode_spline_cubic(std::span<const std::uint8_t> data,
                                           std::span<const std::uint8_t> claims) {
  SplineCubicCertificate c;
  c.data = read_data(data);
  ByteReader reader(claims);
  c.jump = read_number(reader, "jump");
  c.error = read_number(reader, "error");
  require_form(c.jump >= 0 && c.error >= 0, "claim section: a bound is negative");
  require_form(reader.left() == 0, "claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
