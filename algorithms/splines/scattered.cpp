// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/scattered.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "kernel/geometry/parallel.hpp"

namespace crest::splines {

Scattered::Scattered(const Domain& domain, std::span<const Vec3> points,
                     std::span<const double> values)
    : domain_(domain), first_(domain.cube_count() + 1), below_(domain.vertex_count()) {
  std::vector<std::uint32_t> cube_of(points.size());
  constexpr auto nowhere = static_cast<std::uint32_t>(-1);
  const auto cube_at = [&](const Vec3& x) {
    std::array<std::size_t, 3> i;
    for (std::size_t d = 0; d < 3; ++d)
      i[d] = std::min<std::size_t>(static_cast<std::size_t>(x[d]), domain.cubes[d] - 1);
    return static_cast<std::uint32_t>(domain.cube(i[0], i[1], i[2]));
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    cube_of[p] = nowhere;
    if (!domain.contains(points[p])) continue;
    cube_of[p] = cube_at(domain.cube_coordinates(points[p]));
    ++first_[cube_of[p] + 1];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  samples_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t p = 0; p < points.size(); ++p)
    if (cube_of[p] != nowhere)
      samples_[next[cube_of[p]]++] = {domain.cube_coordinates(points[p]), values[p]};
  kernel::parallel_for(
      tbb::blocked_range<std::size_t>(0, domain.cube_count(), 64), [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c)
          std::sort(samples_.begin() + first_[c], samples_.begin() + first_[c + 1]);
      });
  const auto [nx, ny, nz] = domain.cubes;
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j) {
      std::uint32_t row = 0;
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t c = domain.cube(i, j, k);
        row += first_[c + 1] - first_[c];
        below_[domain.vertex(i + 1, j + 1, k + 1)] = row + below_[domain.vertex(i + 1, j, k + 1)] +
                                                     below_[domain.vertex(i + 1, j + 1, k)] -
                                                     below_[domain.vertex(i + 1, j, k)];
      }
    }
}

std::size_t Scattered::empty_cubes() const {
  std::size_t empty = 0;
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) empty += first_[c] == first_[c + 1] ? 1 : 0;
  return empty;
}

Scattered::Range Scattered::cubes_within(const Vec3& centre, double radius) const {
  Range range;
  for (std::size_t d = 0; d < 3; ++d) {
    const double n = domain_.cubes[d];
    range.from[d] = static_cast<std::size_t>(std::clamp(std::floor(centre[d] - radius), 0.0, n));
    range.to[d] = static_cast<std::size_t>(std::clamp(std::floor(centre[d] + radius) + 1, 0.0, n));
  }
  return range;
}

std::size_t Scattered::count(const Range& r) const {
  std::uint32_t sum = 0;  // modulo 2^32, as the terms are
  for (std::size_t c = 0; c < 8; ++c) {
    const auto end = [&](std::size_t d) { return (c >> d & 1) != 0 ? r.to[d] : r.from[d]; };
    const std::uint32_t term = below_[domain_.vertex(end(0), end(1), end(2))];
    const bool odd = ((c ^ c >> 1 ^ c >> 2) & 1) != 0;
    sum += odd ? term : 0 - term;
  }
  return sum;
}

void Scattered::gather(const Vec3& centre, const Request& request, std::vector<Near>& found) const {
  const std::size_t least = std::min(request.least, size());
  for (double radius = request.radius;; radius *= request.growth) {
    const Range range = cubes_within(centre, radius);
    if (count(range) < least) continue;
    found.clear();
    const double square = radius * radius;
    for (std::size_t k = range.from[2]; k < range.to[2]; ++k)
      for (std::size_t j = range.from[1]; j < range.to[1]; ++j) {
        const std::uint32_t last = first_[domain_.cube(range.to[0] - 1, j, k) + 1];
        for (std::uint32_t i = first_[domain_.cube(range.from[0], j, k)]; i < last; ++i) {
          using kernel::operator-;
          const Vec3 d = samples_[i].x - centre;
          const double distance = kernel::dot(d, d);
          if (distance <= square) found.push_back({distance, i});
        }
      }
    if (found.size() >= least) break;
  }
  if (found.size() <= request.most) return;
  const auto last = found.begin() + static_cast<std::ptrdiff_t>(request.most);
  std::nth_element(found.begin(), last - 1, found.end());
  found.erase(last, found.end());
  std::sort(found.begin(), found.end(),
            [](const Near& a, const Near& b) { return a.sample < b.sample; });
}

}  // namespace crest::splines
