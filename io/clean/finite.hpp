// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points that faces use are finite.
#include <fmt/format.h>

#include <cmath>

#include "io/formats/files.hpp"
#include "io/formats/soup.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::io {

/// Throws: kernel::InputError naming the point, where the soup knows it its line, and the number.
inline void require_finite(const Soup& soup, kernel::Index point) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = soup.points[point][k];
    if (std::isfinite(x)) continue;
    fail(soup.point_name(point),
         fmt::format("its coordinate {} is {}", "xyz"[k],
                     std::isnan(x) ? "not a number" : "not finite"),
         "repair it, or remove it with its faces");
  }
}

}  // namespace crest::io
