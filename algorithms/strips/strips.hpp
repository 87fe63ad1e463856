// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Generalised triangle strips (thesis 4.4): the faces of a surface as few, long sequences of
// vertices.
#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/strips/path_cover.hpp"
#include "kernel/geometry/corner_table.hpp"

namespace crest::strips {

using kernel::Triangle;

/// Strip i holds vertices[begin[i]] .. vertices[begin[i + 1] - 1]. Three in a row are a face, in
/// odd places turned; a repeated vertex (a swap) makes a triangle of no area, which is none.
struct Strips {
  std::vector<std::size_t> begin = {0};
  std::vector<Index> vertices;
  std::size_t swaps = 0;

  std::size_t count() const { return begin.size() - 1; }
  std::span<const Index> strip(std::size_t i) const {
    return {vertices.data() + begin[i], vertices.data() + begin[i + 1]};
  }
};

struct StripOptions {
  int effort = 20;    ///< sweeps of annealing; 0: the links as they are
  bool swaps = true;  ///< false: where a swap were needed a new strip starts
};

/// Shapes: the links' mesh and its faces. Guarantees: every face once, turned as it is; the same
/// strips for any machine; not more vertices than the links given make without annealing.
Strips strips_of(const CornerTable& mesh, std::span<const Triangle> faces, Links start,
                 const StripOptions& options);

/// The share of the three vertices a face that is not sent, in per cent.
double saved_per_cent(const Strips& strips, std::size_t faces);

/// The same triangle with its least corner first.
Triangle least_first(Triangle t);

/// The triangles of strip s with three different corners, least corners first.
std::vector<Triangle> triangles_of(const Strips& strips, std::size_t s);

/// Whether the strips' triangles are the faces: each once, turned as it is.
bool covers(const Strips& strips, std::span<const Triangle> faces);

}  // namespace crest::strips
