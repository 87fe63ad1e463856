// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bindings/python/arguments.hpp"

namespace crest::python {

/// `volume` with `spacing`, `origin`, `directions` as what read_volume() gives.
/// Throws: kernel::InputError for what no file may hold: fewer than 4 samples along an axis,
/// samples that are not finite or that doubles do not hold, spacings that are not positive.
kernel::SampledGrid grid_of(const Arguments& a);

}  // namespace crest::python
