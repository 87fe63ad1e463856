// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/complex.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace crest::recheck {
namespace {

std::string named(const char* what, Index i) {
  return what + (" " + std::to_string(i));
}

Index corner(Index face, Index k) {
  return 3 * face + k % 3;
}

}  // namespace

UnionFind::UnionFind(Index n) : parent_(n) {
  std::iota(parent_.begin(), parent_.end(), Index{0});
}
Index UnionFind::find(Index a) {
  while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
  return a;
}
bool UnionFind::join(Index a, Index b) {
  a = find(a);
  b = find(b);
  parent_[std::max(a, b)] = std::min(a, b);
  return a != b;
}

Complex::Complex(const Certificate& c) {
  glue(c);
  check_vertices(c);
  check_counts(c);
  check_patches(c);
}

void Complex::glue(const Certificate& c) {
  struct Side {
    std::uint32_t low, high;
    bool forward;
    Index face, side;
  };
  std::vector<Side> sides;
  std::vector<Corners> sets;
  for (Index f = 0; f < c.faces.size(); ++f) {
    Corners set = c.faces[f];
    for (Index k = 0; k < 3; ++k) {
      const std::uint32_t a = set[k], b = set[(k + 1) % 3];
      if (a == b) throw Rejected(named("face", f) + ": two corners are one vertex");
      sides.push_back({std::min(a, b), std::max(a, b), a < b, f, k});
    }
    std::sort(set.begin(), set.end());
    sets.push_back(set);
  }
  std::sort(sets.begin(), sets.end());
  if (std::adjacent_find(sets.begin(), sets.end()) != sets.end())
    throw Rejected("two faces have the same corners");
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  edge_of.resize(c.faces.size());
  for (Index i = 0; i < sides.size(); ++i) {
    const Side& s = sides[i];
    const bool second = i > 0 && sides[i - 1].low == s.low && sides[i - 1].high == s.high;
    if (!second) edges.emplace_back();
    Edge& e = edges.back();
    if (e.faces == 2) throw Rejected(named("face", s.face) + ": an edge is in three faces");
    if (second && sides[i - 1].forward == s.forward)
      throw Rejected(named("face", s.face) + ": is not oriented as its neighbour");
    e.face[static_cast<Index>(e.faces)] = s.face;
    e.side[static_cast<Index>(e.faces++)] = s.side;
    edge_of[s.face][s.side] = edges.size() - 1;
  }
}

void Complex::check_vertices(const Certificate& c) {
  UnionFind fans(3 * c.faces.size());
  Index left = 3 * c.faces.size();
  for (const Edge& e : edges) {
    if (e.faces == 1) {
      ++boundary_edges;
      continue;
    }
    left -= fans.join(corner(e.face[0], e.side[0]), corner(e.face[1], e.side[1] + 1)) ? 1 : 0;
    left -= fans.join(corner(e.face[0], e.side[0] + 1), corner(e.face[1], e.side[1])) ? 1 : 0;
  }
  std::vector<bool> used(c.vertices.size());
  for (const Corners& f : c.faces)
    for (const std::uint32_t v : f) used[v] = true;
  if (std::find(used.begin(), used.end(), false) != used.end())
    throw Rejected("a vertex is in no face");
  if (left != c.vertices.size()) throw Rejected("the faces at a vertex are not one fan");
}

void Complex::check_counts(const Certificate& c) {
  UnionFind pieces(c.faces.size()), loops(c.vertices.size());
  Index components = c.faces.size(), boundary_loops = boundary_edges;
  for (const Edge& e : edges) {
    if (e.faces == 2) {
      components -= pieces.join(e.face[0], e.face[1]) ? 1 : 0;
      continue;
    }
    // Two boundary edges at each boundary vertex: as many vertices as edges.
    const Corners& f = c.faces[e.face[0]];
    boundary_loops -= loops.join(f[e.side[0]], f[(e.side[0] + 1) % 3]) ? 1 : 0;
  }
  const auto euler = static_cast<std::int64_t>(c.vertices.size() + c.faces.size()) -
                     static_cast<std::int64_t>(edges.size());
  if (c.faces.empty()) throw Rejected("there is no face");
  if (euler != c.euler) throw Rejected("the Euler characteristic is " + std::to_string(euler));
  if (boundary_loops != c.boundary_loops)
    throw Rejected("there are " + std::to_string(boundary_loops) + " boundary loops");
  if (components != c.components)
    throw Rejected("there are " + std::to_string(components) + " components");
  for (Index f = 0; f < c.faces.size(); ++f) component_of.push_back(pieces.find(f));
}

void Complex::check_patches(const Certificate& c) {
  patch_of.assign(c.faces.size(), kNone);
  for (Index i = 0; i < c.patches.size(); ++i) {
    const auto& faces = c.patches[i].faces;
    if (faces.empty()) throw Rejected(named("patch", i) + ": has no face");
    if (i > 0 && faces[0] <= c.patches[i - 1].faces[0])
      throw Rejected(named("patch", i) + ": is out of order");
    for (Index k = 0; k < faces.size(); ++k) {
      if (faces[k] >= c.faces.size() || (k > 0 && faces[k] <= faces[k - 1]))
        throw Rejected(named("patch", i) + ": its faces are unknown or out of order");
      if (patch_of[faces[k]] != kNone || !c.records[faces[k]].in_patch)
        throw Rejected(named("face", faces[k]) + ": is in two patches, or not marked");
      patch_of[faces[k]] = i;
    }
  }
  for (Index f = 0; f < c.faces.size(); ++f)
    if (c.records[f].in_patch && patch_of[f] == kNone)
      throw Rejected(named("face", f) + ": is marked as in a patch, and in none");
  for (const PatchRecord& p : c.patches) check_disk(c, p);
}

void Complex::check_disk(const Certificate& c, const PatchRecord& p) {
  std::map<Index, Index> place;  // of a face in p.faces
  for (Index k = 0; k < p.faces.size(); ++k) place[p.faces[k]] = k;
  UnionFind pieces(p.faces.size()), fans(3 * p.faces.size());
  Index components = p.faces.size(), corners = 3 * p.faces.size(), edge_count = 0;
  std::set<std::uint32_t> vertices;
  for (const std::uint32_t f : p.faces)
    for (Index k = 0; k < 3; ++k) {
      vertices.insert(c.faces[f][k]);
      const Edge& e = edges[edge_of[f][k]];
      const bool inner = interior_to_patch(e);
      if (!inner) ++edge_count;
      if (!inner || e.face[0] != f) continue;
      ++edge_count;
      const Index a = place[e.face[0]], b = place[e.face[1]];
      components -= pieces.join(a, b) ? 1 : 0;
      corners -= fans.join(corner(a, e.side[0]), corner(b, e.side[1] + 1)) ? 1 : 0;
      corners -= fans.join(corner(a, e.side[0] + 1), corner(b, e.side[1])) ? 1 : 0;
    }
  if (components != 1 || corners != vertices.size() ||
      vertices.size() + p.faces.size() != edge_count + 1)
    throw Rejected(named("patch of face", p.faces[0]) + ": is not a disk");
}

}  // namespace crest::recheck
