// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"

namespace crest::certify::reeb {
namespace {

using u8 = std::uint8_t;

void check_indices(const Triangles& triangles, std::size_t nodes) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    require(a < nodes && b < nodes && c < nodes, "face {}: no such vertex", t);
    require(a != b && b != c && c != a, "face {}: a vertex twice", t);
  }
}

struct Side {
  u32 high, corner;
};

/// By the larger node. Buckets are short as a rule: a call of std::sort costs more than the
/// sorting.
void sort_bucket(Side* begin, Side* end) {
  if (end - begin > 24)
    return std::sort(begin, end, [](const Side& s, const Side& t) { return s.high < t.high; });
  for (Side* at = begin; at < end; ++at) {
    const Side side = *at;
    Side* to = at;
    for (; to > begin && (to - 1)->high > side.high; --to) *to = *(to - 1);
    *to = side;
  }
}

/// Sides in buckets by their smaller node, each bucket by the larger one.
Buffer<Side> sorted_sides(const Triangles& triangles, Buffer<u32>& start) {
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++start[std::min(t[i], t[i == 2 ? 0 : i + 1]) + 1];
  for (std::size_t v = 0; v + 1 < start.size(); ++v) start[v + 1] += start[v];
  Buffer<Side> sides(3 * triangles.size());
  Buffer<u32> fill(start.begin(), start.end() - 1);
  u32 corner = 0;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i, ++corner) {
      const u32 a = t[i], b = t[i == 2 ? 0 : i + 1];
      sides[fill[std::min(a, b)]++] = {std::max(a, b), corner};
    }
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    sort_bucket(sides.data() + start[v], sides.data() + start[v + 1]);
  return sides;
}

u32 find(Buffer<u32>& parent, u32 x) {
  while (parent[x] != x) x = parent[x] = parent[parent[x]];
  return x;
}

/// True if the two were not joined before.
bool join(Buffer<u32>& parent, u32 a, u32 b) {
  a = find(parent, a), b = find(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
  return a != b;
}

/// Faces that share a vertex are in one component: links are shown to be connected next.
u32 count_components(const Triangles& faces, std::size_t vertices) {
  Buffer<u32> parent(vertices);
  std::iota(parent.begin(), parent.end(), u32{0});
  auto components = static_cast<u32>(vertices);
  for (const auto& [a, b, c] : faces) components -= u32{join(parent, a, b)} + join(parent, b, c);
  return components;
}

/// Can every face be given a direction as its neighbours require?
bool is_orientable(const Triangles& faces, const Buffer<u32>& twin) {
  bool orientable = true;
  Buffer<u8> turned(faces.size(), 2);
  std::vector<u32> stack;
  for (u32 seed = 0; seed < faces.size(); ++seed) {
    if (turned[seed] != 2) continue;
    turned[seed] = 0;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const u32 f = stack.back();
      stack.pop_back();
      for (u32 i = 0; i < 3; ++i) {
        const u32 across = twin[3 * f + i];
        if (across == kNone) continue;
        const u32 g = across / 3;
        const bool same = faces[f][i] == faces[g][across - 3 * g];
        const auto wanted = static_cast<u8>(turned[f] ^ static_cast<u8>(same));
        if (turned[g] == 2) {
          turned[g] = wanted;
          stack.push_back(g);
        }
        orientable = orientable && turned[g] == wanted;
      }
    }
  }
  return orientable;
}

/// Walks the faces around v by their common sides; returns how many there are.
u32 fan_size(const Triangles& faces, const Buffer<u32>& twin, u32 v, u32 corner, bool by_previous) {
  u32 count = 0, c = corner;
  do {
    ++count;
    const u32 across = twin[by_previous ? previous_corner(c) : c];
    if (across == kNone) return count;
    // Entered by the side that starts at v: left by the one that ends there.
    by_previous = node_of(faces, across) == v;
    c = by_previous ? across : next_corner(across);
  } while (c != corner);
  return count;
}

/// The same if all faces have one direction: the next corner is across the side that ends at v.
/// `corner` must have the boundary, if there is one, at the side that starts there.
u32 fan_size(const Buffer<u32>& twin, u32 corner) {
  u32 count = 0, c = corner;
  do {
    ++count;
    c = twin[previous_corner(c)];
  } while (c != kNone && c != corner);
  return count;
}

/// Returns one corner of every vertex.
Buffer<u32> check_links(const Triangles& faces, const Gluing& gluing, std::size_t vertices) {
  const auto& twin = gluing.twin;
  // Where the walk around a vertex starts, and by which side of that corner it leaves the face.
  Buffer<u32> corner(vertices, kNone), degree(vertices, 0);
  Buffer<u8> by_previous(vertices, 0);
  u32 c = 0;
  for (const auto& f : faces)
    for (const u32 v : f) {
      ++degree[v];
      corner[v] = c++;
    }
  for (c = 0; c < twin.size(); ++c) {
    if (twin[c] != kNone) continue;
    // A boundary side: the walk around either end begins there.
    const u32 v = node_of(faces, c), w = node_of(faces, next_corner(c));
    corner[v] = c, by_previous[v] = 1;
    if (!gluing.aligned) corner[w] = next_corner(c), by_previous[w] = 0;
  }
  for (u32 v = 0; v < vertices; ++v) {
    require(corner[v] != kNone, "vertex {}: in no face", v);
    const u32 size = gluing.aligned ? fan_size(twin, corner[v])
                                    : fan_size(faces, twin, v, corner[v], by_previous[v] != 0);
    require(size == degree[v], "vertex {}: its link is neither one cycle nor one path", v);
  }
  return corner;
}

/// Every boundary vertex is on one boundary loop: loops are the components of the boundary sides.
u32 count_boundary_loops(const Triangles& faces, const Buffer<u32>& twin, std::size_t vertices) {
  if (std::find(twin.begin(), twin.end(), kNone) == twin.end()) return 0;
  Buffer<u32> parent(vertices);
  std::iota(parent.begin(), parent.end(), u32{0});
  u32 loops = 0;
  for (u32 c = 0; c < twin.size(); ++c)
    // As many sides as vertices: in each loop exactly one side joins nothing new.
    loops += twin[c] == kNone && !join(parent, node_of(faces, c), node_of(faces, next_corner(c)));
  return loops;
}

}  // namespace

Gluing glue(const Triangles& triangles, std::size_t nodes, bool with_edges) {
  check_indices(triangles, nodes);
  Buffer<u32> start(nodes + 1, 0);
  const Buffer<Side> sides = sorted_sides(triangles, start);
  Gluing g;
  g.twin.assign(sides.size(), kNone);
  if (with_edges) {
    g.edge_of.resize(sides.size());
    g.edges.reserve(sides.size() / 2 + 16);
  }
  for (u32 low = 0; low < nodes; ++low)
    for (u32 i = start[low]; i < start[low + 1]; ++g.edge_count) {
      const u32 high = sides[i].high, a = sides[i].corner;
      u32 end = i + 1;
      while (end < start[low + 1] && sides[end].high == high) ++end;
      require(end - i <= 2, "edge {} {}: in more than two faces", low, high);
      if (end - i == 2) {
        const u32 b = sides[i + 1].corner;
        g.twin[a] = b;
        g.twin[b] = a;
        g.aligned = g.aligned && node_of(triangles, a) != node_of(triangles, b);
        // Two faces with the same corners share each of their sides.
        require(node_of(triangles, previous_corner(a)) != node_of(triangles, previous_corner(b)),
                "faces {} and {}: the same corners", a / 3, b / 3);
      }
      if (with_edges) {
        g.edges.push_back({low, high});
        for (; i < end; ++i) g.edge_of[sides[i].corner] = static_cast<u32>(g.edge_count);
      }
      i = end;
    }
  return g;
}

SurfaceFacts check_surface(const Triangles& faces, const Gluing& gluing, std::size_t vertices) {
  SurfaceFacts facts;
  facts.corner = check_links(faces, gluing, vertices);
  facts.components = count_components(faces, vertices);
  facts.orientable = gluing.aligned || is_orientable(faces, gluing.twin);
  facts.euler_characteristic = static_cast<std::int64_t>(vertices) -
                               static_cast<std::int64_t>(gluing.edge_count) +
                               static_cast<std::int64_t>(faces.size());
  facts.boundary_loops = count_boundary_loops(faces, gluing.twin, vertices);
  return facts;
}

}  // namespace crest::certify::reeb
