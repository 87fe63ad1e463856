// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_cubic/domain.hpp"

#include <algorithm>
#include <span>

#include "certify/container/reject.hpp"

namespace crest::certify::spline_cubic {
namespace {

/// Whether one of the cubes that have a site is in the domain. `at` is the site's lowest vertex;
/// along axes in `along` it reaches to the next vertex, along others it has a cube on either side.
bool has_cube(const SplineCubicData& data, const Domain& domain,
              const std::array<std::size_t, 3>& at, unsigned along) {
  for (unsigned sides = 0; sides < 8; ++sides) {
    if ((sides & along) != 0) continue;
    std::size_t cube = 0;
    bool inside = true;
    for (std::size_t d = 3; d-- > 0;) {
      const std::size_t i = at[d] - ((sides >> d) & 1U);  // below 0: beyond every n
      inside = inside && i < data.cubes[d];
      cube = cube * data.cubes[d] + i;
    }
    if (inside && domain.holds(cube)) return true;
  }
  return false;
}

bool all_zero(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double x) { return x == 0; });
}

}  // namespace

void Domain::mark(const SplineCubicData& data) {
  std::uint64_t end = 0;
  bool first = true;
  for (const SplineCubeRun& run : data.domain) {
    require(run.length > 0 && (first || run.first > end) &&
                std::uint64_t{run.first} + run.length <= cubes_.size(),
            "domain: runs of cubes are not ascending and apart");
    first = false;
    end = std::uint64_t{run.first} + run.length;
    std::fill_n(cubes_.begin() + run.first, run.length, std::uint8_t{1});
    size_ += run.length;
  }
  require(size_ > 0, "domain: no cube");
}

Domain::Domain(const SplineCubicData& data) : cubes_(data.centres.size()) {
  mark(data);
  for (std::size_t cube = 0; cube < cubes_.size(); ++cube)
    require(holds(cube) || all_zero(data.centres[cube]), "cube {} is not in the domain, not 0",
            cube);
  std::size_t vertex = 0;
  std::array<std::size_t, 3> at{};
  for (at[2] = 0; at[2] <= data.cubes[2]; ++at[2])
    for (at[1] = 0; at[1] <= data.cubes[1]; ++at[1])
      for (at[0] = 0; at[0] <= data.cubes[0]; ++at[0], ++vertex) {
        require(all_zero(data.vertices[vertex]) || has_cube(data, *this, at, 0),
                "vertex {} is not in the domain, not 0", vertex);
        for (std::size_t axis = 0; axis < 3; ++axis)
          require(all_zero(std::span(data.slopes[vertex]).subspan(2 * axis, 2)) ||
                      has_cube(data, *this, at, 1U << axis),
                  "an edge of vertex {} is not in the domain, not 0", vertex);
      }
}

}  // namespace crest::certify::spline_cubic
