// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The plain surfaces of algorithms/sampling under the names the tests use.
#include "algorithms/sampling/plain_surfaces.hpp"

namespace crest::tests {

using Surface = sampling::PlainSurface;
using sampling::disjoint;
using sampling::icosphere;
using sampling::noise_values;
using sampling::order_of;
using sampling::plate;
using sampling::projective_plane;
using sampling::quantised;
using sampling::Sides;
using sampling::smooth_values;
using sampling::strip;
using sampling::subdivided;
using sampling::torus_surface;
using sampling::VertexOrder;

}  // namespace crest::tests
