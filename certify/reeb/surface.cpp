// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::reeb {
namespace {

using u8 = std::uint8_t;

/// Faces that share a vertex are in one component: links are shown to be connected next.
u32 count_components(const Triangles& faces, std::size_t vertices) {
  UnionFind classes(vertices);
  auto components = static_cast<u32>(vertices);
  for (const auto& [a, b, c] : faces) components -= u32{classes.join(a, b)} + classes.join(b, c);
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
    by_previous = vertex_of(faces, across) == v;
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
    const u32 v = vertex_of(faces, c), w = vertex_of(faces, next_corner(c));
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
  UnionFind classes(vertices);
  u32 loops = 0;
  for (u32 c = 0; c < twin.size(); ++c)
    // As many sides as vertices: in each loop exactly one side joins nothing new.
    loops +=
        twin[c] == kNone && !classes.join(vertex_of(faces, c), vertex_of(faces, next_corner(c)));
  return loops;
}

}  // namespace

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
