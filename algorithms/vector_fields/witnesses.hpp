// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The witness line, through a vertex, stands where no separatrix does: into a sink, out of a
// source, from each side into a closed orbit, from a loop of the boundary that is one region. So no
// orbit appears around these unseen, and some orbits are found that no separatrix reaches.
#include <array>

#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

/// The line through the vertex that a half-edge leaves.
struct Witness {
  HalfEdge leaving = kNone;
  bool forward = true;
};

/// Whether a line that ends in an annulus comes to its orbit from where the side's tail is (0) or
/// its head (1); nothing if it enters between its lines' returns.
std::optional<Index> side_of(const Domain& domain, const Annulus& annulus, const Trace& trace);

/// Chooses witnesses and appends their lines, which all have ends; annuli that are found join the
/// others. None stands where no vertex nearby will do.
std::vector<Witness> find_witnesses(const Surroundings& around, std::vector<Trace>& traces,
                                    std::vector<Annulus>& annuli);

/// Appends the lines of given ones, whether they have ends or not.
void follow_witnesses(const Surroundings& around, const std::vector<Witness>& witnesses,
                      std::vector<Trace>& traces, std::vector<Annulus>& annuli);

}  // namespace crest::vector_fields
