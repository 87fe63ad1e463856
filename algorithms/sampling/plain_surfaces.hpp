// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangulated surfaces of every topology, as plain points and triangles, and functions on them.
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::sampling {

struct PlainSurface {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> triangles;
};

enum class Sides { open, joined, flipped };

/// A strip of m x n squares; its ends x = 0 and x = m are open, joined, or joined with a half
/// twist, its sides y = 0 and y = n open, joined, or joined against one another. joined + joined: a
/// torus; flipped + open: a Moebius strip; joined + flipped: a Klein bottle.
PlainSurface strip(unsigned m, unsigned n, Sides ends, Sides sides);

PlainSurface torus_surface(unsigned m, unsigned n);

/// An n x n plate with `holes` square holes; with `thick` the boundary of such a plate of some
/// thickness: the closed surface whose genus is the number of holes.
PlainSurface plate(unsigned n, unsigned holes, bool thick);

/// Every triangle into four, `times` times.
PlainSurface subdivided(PlainSurface s, unsigned times);

PlainSurface icosphere(unsigned times);

/// Half an icosahedron with opposite boundary points joined, subdivided.
PlainSurface projective_plane(unsigned times);

/// Both, the second's vertices and triangles after the first's.
PlainSurface disjoint(PlainSurface a, const PlainSurface& b);

std::vector<double> noise_values(const PlainSurface& s, std::uint64_t seed);

/// A sum of 64 plane waves of random direction, frequency and phase.
std::vector<double> smooth_values(const PlainSurface& s, std::uint64_t seed, double frequency = 8);

/// Rounded down to multiples of `step`: many ties.
std::vector<double> quantised(std::vector<double> values, double step);

/// The vertices by ascending value, equal values by number, and the places of the vertices.
struct VertexOrder {
  std::vector<kernel::Index> rank, order;
};
VertexOrder order_of(const std::vector<double>& values);

}  // namespace crest::sampling
