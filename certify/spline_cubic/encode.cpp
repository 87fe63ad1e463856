// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_cubic/encode.hpp"

#include <cmath>

#include "certify/container/compose.hpp"

namespace crest::certify {
namespace {

void require_fit(bool fits, const char* what) {
  if (!fits) throw std::invalid_argument(std::string("certificate: ") + what);
}

/// x in units of 2^unit.
std::int64_t in_units(double x, int unit) {
  const double scaled = std::ldexp(x, -unit);
  require_fit(
      std::fabs(scaled) < 0x1p53 && scaled == std::floor(scaled) && std::ldexp(scaled, unit) == x,
      "a number of a spline in integers is no integer of its unit below 2^53");
  return static_cast<std::int64_t>(scaled);
}

/// `first` is the unit's exponent of a row's first number, `others` that of the rest.
template <std::size_t n>
void write_rows(ByteWriter& out, const SplineCubicData& data,
                const std::vector<std::array<double, n>>& rows, int first, int others) {
  if (!data.integers) return out.rows(rows);
  for (const auto& row : rows)
    for (std::size_t k = 0; k < n; ++k)
      out.integer(in_units(row[k], data.exponent + (k == 0 ? first : others)));
}

void write_data(ByteWriter& out, const SplineCubicData& data) {
  out.integer(std::uint8_t{data.integers});
  out.integer(data.exponent);
  out.numbers(data.box);
  out.numbers(data.cubes);
  out.count(data.domain.size());
  for (const SplineCubeRun& run : data.domain) {
    out.integer(run.first);
    out.integer(run.length);
  }
  write_rows(out, data, data.vertices, 0, 1);
  write_rows(out, data, data.slopes, 0, 0);
  write_rows(out, data, data.centres, -3, -2);
  out.integer(data.outside);
  out.count(data.samples.size());
  out.rows(data.samples);
}

}  // namespace

Bytes encode(const SplineCubicCertificate& c) {
  const SplineCubicData& data = c.data;
  std::size_t cubes = 1, vertices = 1;
  for (const std::size_t n : data.cubes) {
    cubes *= n;
    vertices *= n + 1;
  }
  require_fit(data.vertices.size() == vertices && data.slopes.size() == vertices &&
                  data.centres.size() == cubes,
              "numbers of a spline that do not fit its cubes");
  const std::size_t size = 1 + 4 + 6 * 8 + 3 * 4 + 4 + 8 * data.domain.size() + 80 * vertices +
                           32 * cubes + 8 + 4 + 32 * data.samples.size();
  return compose(
      {kSplineCubic, kSplineCubicVersion}, size, [&](ByteWriter& out) { write_data(out, data); },
      [&](ByteWriter& out) {
        out.number(c.jump);
        out.number(c.error);
      });
}

}  // namespace crest::certify
