// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/geometry/input_error.hpp"

namespace crest::python {
namespace {

template <class T>
bool is_exact(T x) {
  if constexpr (std::is_floating_point_v<T>)
    return std::isfinite(x);
  else if constexpr (sizeof(T) < 8)
    return true;
  else
    return static_cast<double>(x) < 0x1p63 && static_cast<T>(static_cast<double>(x)) == x;
}

void check(const kernel::SampledGrid& grid) {
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    if (grid.size[k] < 4)
      throw kernel::InputError(
          fmt::format("volume: has {} samples along an axis; give 4 at least", grid.size[k]));
    if (!(grid.spacing[k] > 0) || !std::isfinite(grid.spacing[k]))
      throw kernel::InputError("spacing: is no positive number; give a length");
  }
  std::visit(
      [](const auto& x) {
        const auto bad = std::find_if_not(x.begin(), x.end(), [](auto v) { return is_exact(v); });
        if (bad != x.end())
          throw kernel::InputError(fmt::format(
              "volume: sample {} is not a finite number that a double holds; replace it",
              bad - x.begin()));
      },
      grid.samples);
}

}  // namespace

kernel::SampledGrid grid_of(const Arguments& a) {
  const Array& volume = a.array("volume");
  kernel::SampledGrid grid;
  for (std::size_t k = 0; k < volume.shape.size(); ++k)
    grid.size[k] = volume.shape[volume.shape.size() - 1 - k];
  std::copy_n(a.numbers("spacing").begin(), 3, grid.spacing.begin());
  std::copy_n(a.numbers("origin").begin(), 3, grid.origin.begin());
  const auto directions = a.rows<3>("directions");
  std::copy_n(directions.begin(), 3, grid.directions.begin());
  grid.samples = volume.data;
  check(grid);
  return grid;
}

}  // namespace crest::python
