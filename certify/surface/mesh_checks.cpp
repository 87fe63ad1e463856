// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/surface/mesh_checks.hpp"

#include <algorithm>
#include <array>

#include "certify/container/reject.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

void check_indices(const MeshData& data) {
  const std::size_t vertices = data.positions.size();
  for (std::size_t f = 0; f < data.faces.size(); ++f) {
    const auto& [a, b, c] = data.faces[f];
    require(a < vertices && b < vertices && c < vertices, "face {}: no such vertex", f);
    require(a != b && b != c && c != a, "face {}: a vertex twice", f);
  }
}

struct Side {
  u32 high, corner;
};

/// Sides in buckets by their smaller vertex, each bucket by the larger one.
std::vector<Side> sorted_sides(const MeshData& data, std::vector<u32>& start) {
  const u32 corners = static_cast<u32>(3 * data.faces.size());
  start.assign(data.positions.size() + 1, 0);
  for (const auto& f : data.faces)
    for (std::size_t i = 0; i < 3; ++i) ++start[std::min(f[i], f[(i + 1) % 3]) + 1];
  for (std::size_t v = 0; v + 1 < start.size(); ++v) start[v + 1] += start[v];
  std::vector<Side> sides(corners);
  std::vector<u32> fill(start.begin(), start.end() - 1);
  for (u32 c = 0; c < corners; ++c) {
    const u32 a = vertex_of(data, c), b = vertex_of(data, next_corner(c));
    sides[fill[std::min(a, b)]++] = {std::max(a, b), c};
  }
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    std::sort(sides.begin() + start[v], sides.begin() + start[v + 1],
              [](const Side& s, const Side& t) { return s.high < t.high; });
  return sides;
}

void build_edges(const MeshData& data, Topology& t) {
  std::vector<u32> start;
  const std::vector<Side> sides = sorted_sides(data, start);
  t.edge_of.resize(sides.size());
  t.twin.assign(sides.size(), kNone);
  t.edges.reserve(sides.size() / 2 + 16);
  for (u32 low = 0; low + 1 < start.size(); ++low)
    for (u32 i = start[low]; i < start[low + 1]; ++i) {
      const auto [high, corner] = sides[i];
      if (i == start[low] || sides[i - 1].high != high)
        t.edges.push_back({low, high, kNone, kNone});
      Edge& edge = t.edges.back();
      u32& slot = vertex_of(data, corner) == low ? edge.forward : edge.backward;
      require(slot == kNone, "edge {} {}: more than two faces, or two that disagree in orientation",
              low, high);
      slot = corner;
      t.edge_of[corner] = static_cast<u32>(t.edges.size() - 1);
    }
  for (const Edge& edge : t.edges) {
    if (edge.forward == kNone || edge.backward == kNone) continue;
    t.twin[edge.forward] = edge.backward;
    t.twin[edge.backward] = edge.forward;
    // Two faces with the same corners share each of their sides.
    require(vertex_of(data, previous_corner(edge.forward)) !=
                vertex_of(data, previous_corner(edge.backward)),
            "faces {} and {}: the same corners", edge.forward / 3, edge.backward / 3);
  }
}

/// The first corner of every vertex's ring, and the number of its corners (ring_start).
std::vector<u32> ring_beginnings(const MeshData& data, Topology& t) {
  std::vector<u32> first(data.positions.size(), kNone);
  t.ring_start.assign(data.positions.size() + 1, 0);
  t.on_boundary.assign(data.positions.size(), 0);
  for (u32 c = 0; c < t.twin.size(); ++c) {
    const u32 v = vertex_of(data, c);
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

void build_rings(const MeshData& data, Topology& t) {
  const std::vector<u32> first = ring_beginnings(data, t);
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

u32 count_boundary_loops(const MeshData& data, const Topology& t) {
  std::vector<std::uint8_t> seen(data.positions.size(), 0);
  u32 loops = 0;
  for (u32 v = 0; v < seen.size(); ++v) {
    if (!t.on_boundary[v] || seen[v]) continue;
    ++loops;
    // The first corner of a boundary ring starts the boundary side that leaves the vertex.
    for (u32 w = v; !seen[w]; w = vertex_of(data, next_corner(t.ring[t.ring_start[w]])))
      seen[w] = 1;
  }
  return loops;
}

bool has_zero_area(const MeshData& data, std::size_t f, SignLadder& sign) {
  const auto& a = data.positions[data.faces[f][0]];
  const auto& b = data.positions[data.faces[f][1]];
  const auto& c = data.positions[data.faces[f][2]];
  // Component k of the normal, from the coordinates k + 1 and k + 2.
  const auto component = [&](std::size_t k, auto lift) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return (lift(b[i]) - lift(a[i])) * (lift(c[j]) - lift(a[j])) -
           (lift(b[j]) - lift(a[j])) * (lift(c[i]) - lift(a[i]));
  };
  // The order only saves time: the largest component is the one a double can decide.
  std::size_t largest = 0;
  double size = -1;
  for (std::size_t k = 0; k < 3; ++k)
    if (const double x = std::fabs(component(k, filtered).value); x > size) {
      size = x;
      largest = k;
    }
  for (std::size_t k = largest; k < largest + 3; ++k)
    if (sign([&](auto lift) { return component(k % 3, lift); }) != kernel::Sign::zero) return false;
  return true;
}

}  // namespace

Topology build_topology(const MeshData& data) {
  check_indices(data);
  Topology t;
  build_edges(data, t);
  build_rings(data, t);
  t.boundary_loops = count_boundary_loops(data, t);
  t.euler_characteristic = static_cast<std::int64_t>(data.positions.size()) -
                           static_cast<std::int64_t>(t.edges.size()) +
                           static_cast<std::int64_t>(data.faces.size());
  return t;
}

void check_geometry(const MeshData& data, SignLadder& sign) {
  for (std::size_t f = 0; f < data.faces.size(); ++f)
    require(!has_zero_area(data, f, sign), "face {}: zero area", f);
  for (std::size_t v = 0; v < data.monge.size(); ++v) {
    const auto& m = data.monge[v];
    require(m[0] != 0 || m[1] != 0 || m[2] != 0, "vertex {}: d1 is zero", v);
    require(m[3] != 0 || m[4] != 0 || m[5] != 0, "vertex {}: n is zero", v);
    require(m[6] >= m[7], "vertex {}: k1 < k2", v);
  }
}

}  // namespace crest::certify
