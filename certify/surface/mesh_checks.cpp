// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/surface/mesh_checks.hpp"

#include "certify/container/reject.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

/// Also twins: two faces along an edge must run along it in opposite directions.
void build_edges(Faces faces, std::size_t vertices, Topology& t) {
  Gluing gluing = glue(faces, vertices, true);
  t.edges.reserve(gluing.edge_count);
  for (const auto& [low, high] : gluing.edges) t.edges.push_back({low, high, kNone, kNone});
  for (u32 side = 0; side < gluing.edge_of.size(); ++side) {
    Edge& edge = t.edges[gluing.edge_of[side]];
    u32& slot = vertex_of(faces, side) == edge.low ? edge.forward : edge.backward;
    require(slot == kNone, "edge {} {}: two faces that disagree in orientation", edge.low,
            edge.high);
    slot = side;
  }
  t.twin = std::move(gluing.twin);
  t.edge_of = std::move(gluing.edge_of);
}

/// The first corner of every vertex's ring, and the number of its corners (ring_start).
std::vector<u32> ring_beginnings(Faces faces, std::size_t vertices, Topology& t) {
  std::vector<u32> first(vertices, kNone);
  t.ring_start.assign(vertices + 1, 0);
  t.on_boundary.assign(vertices, 0);
  for (u32 c = 0; c < t.twin.size(); ++c) {
    const u32 v = vertex_of(faces, c);
    ++t.ring_start[v + 1];
    if (t.twin[c] == kNone) {
      require(!t.on_boundary[v], "vertex {}: its faces are not one fan", v);
      t.on_boundary[v] = 1;
      first[v] = c;
    } else if (first[v] == kNone) {
      first[v] = c;
    }
  }
  for (std::size_t v = 0; v < first.size(); ++v) {
    require(first[v] != kNone, "vertex {}: in no face", v);
    t.ring_start[v + 1] += t.ring_start[v];
  }
  return first;
}

void build_rings(Faces faces, std::size_t vertices, Topology& t) {
  const std::vector<u32> first = ring_beginnings(faces, vertices, t);
  t.ring.resize(t.twin.size());
  t.ring_position.resize(t.twin.size());
  for (u32 v = 0; v < first.size(); ++v) {
    u32 c = first[v], at = t.ring_start[v];
    // Twins are one-to-one, so the walk ends at a boundary or where it began.
    do {
      t.ring_position[c] = at - t.ring_start[v];
      t.ring[at++] = c;
      c = t.twin[previous_corner(c)];
    } while (c != kNone && c != first[v]);
    require(at == t.ring_start[v + 1], "vertex {}: its faces are not one fan", v);
  }
}

u32 count_boundary_loops(Faces faces, const Topology& t) {
  std::vector<std::uint8_t> seen(t.on_boundary.size(), 0);
  u32 loops = 0;
  for (u32 v = 0; v < seen.size(); ++v) {
    if (!t.on_boundary[v] || seen[v]) continue;
    ++loops;
    // The first corner of a boundary ring starts the boundary side that leaves the vertex.
    for (u32 w = v; !seen[w]; w = vertex_of(faces, next_corner(t.ring[t.ring_start[w]])))
      seen[w] = 1;
  }
  return loops;
}

}  // namespace

Topology build_topology(Faces faces, std::size_t vertices) {
  Topology t;
  build_edges(faces, vertices, t);
  build_rings(faces, vertices, t);
  t.boundary_loops = count_boundary_loops(faces, t);
  t.euler_characteristic = static_cast<std::int64_t>(vertices) -
                           static_cast<std::int64_t>(t.edges.size()) +
                           static_cast<std::int64_t>(faces.size());
  return t;
}

}  // namespace crest::certify
