// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/reeb_samples.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace crest::tests {
namespace {

using u32 = std::uint32_t;

Faces shifted(Faces faces, u32 by) {
  for (auto& f : faces)
    for (u32& v : f) v += by;
  return faces;
}

std::size_t vertex_count(const Faces& faces) {
  u32 last = 0;
  for (const auto& f : faces) last = std::max({last, f[0], f[1], f[2]});
  return last + 1;
}

/// Numbers vertices 0, 1, ... without gaps.
void compact(Faces& faces) {
  std::map<u32, u32> number;
  for (auto& f : faces)
    for (u32& v : f) v = number.emplace(v, static_cast<u32>(number.size())).first->second;
}

/// Removes the last face of one and the first of the other and glues the holes, directions against
/// each other.
Faces connected_sum(Faces one, const Faces& two) {
  const auto by = static_cast<u32>(vertex_count(one));
  const Faces other = shifted(two, by);
  const auto [a, b, c] = one.back();
  one.pop_back();
  const std::map<u32, u32> glue = {{other[0][0], a}, {other[0][1], c}, {other[0][2], b}};
  for (auto f = other.begin() + 1; f != other.end(); ++f) {
    one.push_back(*f);
    for (u32& v : one.back())
      if (const auto at = glue.find(v); at != glue.end()) v = at->second;
  }
  compact(one);
  return one;
}

Faces both(Faces one, const Faces& two) {
  const Faces other = shifted(two, static_cast<u32>(vertex_count(one)));
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

/// A torus grid whose second seam is glued backwards.
Faces klein_bottle(u32 m, u32 n) {
  Faces faces;
  const auto at = [&](u32 i, u32 j) {
    if (i == m) i = 0, j = (n - j) % n;
    return i * n + j % n;
  };
  for (u32 i = 0; i < m; ++i)
    for (u32 j = 0; j < n; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return faces;
}

/// Takes out faces that share no vertex with each other or with the boundary.
Faces with_holes(Faces faces, std::size_t holes) {
  std::map<std::pair<u32, u32>, int> sides;
  for (const auto& f : faces)
    for (std::size_t i = 0; i < 3; ++i) ++sides[std::minmax(f[i], f[(i + 1) % 3])];
  std::set<u32> used;
  for (const auto& [side, count] : sides)
    if (count == 1) used.insert({side.first, side.second});
  Faces kept;
  for (const auto& f : faces) {
    const bool free = !used.contains(f[0]) && !used.contains(f[1]) && !used.contains(f[2]);
    if (holes > 0 && free) {
      used.insert(f.begin(), f.end());
      --holes;
    } else {
      kept.push_back(f);
    }
  }
  return kept;
}

void shuffle(Faces& faces, Random& random) {
  std::vector<u32> number(vertex_count(faces));
  std::iota(number.begin(), number.end(), u32{0});
  std::shuffle(number.begin(), number.end(), random);
  std::shuffle(faces.begin(), faces.end(), random);
  const bool turn = random() % 2;
  for (auto& f : faces) {
    for (u32& v : f) v = number[v];
    if (turn) std::shuffle(f.begin(), f.end(), random);
  }
}

double draw(Values kind, Random& random) {
  switch (kind) {
    case Values::small:
      return static_cast<double>(random() % 5) - 2;
    case Values::constant:
      return 1;
    case Values::mixed:
      return random() % 2 ? uniform(random) : static_cast<double>(random() % 3) - 1;
    default:
      return uniform(random);
  }
}

}  // namespace

std::vector<ReebSurface> reeb_surfaces(Random& random) {
  const Faces tetrahedron = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const Faces octahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                            {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
  const Faces moebius = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  const Faces projective = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                            {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  const Faces small_torus = torus(3, 3).faces, large_torus = torus(4, 5).faces;
  const Faces two_tori = connected_sum(torus(3, 4).faces, small_torus);
  const Faces disk = grid(4, 3).faces, annulus = grid(3, 3, true).faces;
  std::vector<ReebSurface> out;
  const auto add = [&](const char* name, Faces faces, u32 genus, bool closed) {
    compact(faces);
    shuffle(faces, random);
    const std::size_t vertices = vertex_count(faces);
    out.push_back({name, std::move(faces), vertices, genus, closed});
  };
  add("tetrahedron", tetrahedron, 0, true);
  add("octahedron", octahedron, 0, true);
  add("sphere", icosphere(1).faces, 0, true);
  add("torus of 9", small_torus, 1, true);
  add("torus of 20", large_torus, 1, true);
  add("genus 2", two_tori, 2, true);
  add("genus 3", connected_sum(two_tori, large_torus), 3, true);
  add("triangle", {{0, 1, 2}}, 0, false);
  add("disk", disk, 0, false);
  add("annulus", annulus, 0, false);
  add("disk with 4 holes", with_holes(grid(7, 6).faces, 4), 0, false);
  add("torus with 2 holes", with_holes(torus(4, 6).faces, 2), 0, false);
  add("Moebius strip", moebius, 0, false);
  add("projective plane", projective, 0, false);
  add("Klein bottle", klein_bottle(4, 4), 0, false);
  add("Klein bottle and torus", connected_sum(klein_bottle(3, 4), small_torus), 0, false);
  add("two tori apart", both(small_torus, large_torus), 2, true);
  add("sphere, disk and strip", both(both(octahedron, disk), moebius), 0, false);
  return out;
}

certify::ReebCertificate reeb_data(const ReebSurface& surface, int degree, Values kind,
                                   Random& random) {
  certify::ReebCertificate c;
  c.faces = surface.faces;
  for (std::size_t v = 0; v < surface.vertices; ++v) {
    c.positions.push_back({uniform(random), uniform(random), uniform(random)});
    c.values.push_back(kind == Values::ramp ? static_cast<double>(v) : draw(kind, random));
  }
  if (degree == 1) return c;
  std::set<std::pair<u32, u32>> edges;
  for (const auto& f : c.faces)
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(f[i], f[(i + 1) % 3]));
  for (const auto& [a, b] : edges)
    c.edge_values.push_back(kind == Values::ramp ? (c.values[a] + c.values[b]) / 2
                                                 : draw(kind, random));
  return c;
}

}  // namespace crest::tests
