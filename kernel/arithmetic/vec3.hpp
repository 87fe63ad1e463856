// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points and vectors of space.
#include <array>

namespace crest::kernel {

using Vec3 = std::array<double, 3>;

}  // namespace crest::kernel
