// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/trees.hpp"

#include <algorithm>
#include <functional>

#include "certify/container/reject.hpp"

namespace crest::certify::modes {
namespace {

constexpr std::array<std::array<unsigned, 2>, 6> kTetEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// What is left over of {0, 1, 2, 3}.
std::array<unsigned, 2> others(unsigned i, unsigned j) {
  std::array<unsigned, 2> rest{};
  unsigned at = 0;
  for (unsigned k = 0; k < 4; ++k)
    if (k != i && k != j) rest[at++] = k;
  return rest;
}

/// Corners of simplices, and the lists from which everything is read.
class Base {
 public:
  Base(const ModeLevel& level, const Domain& domain, Field& field)
      : level_(level), domain_(domain), field_(field) {}

 protected:
  static std::array<u32, 3> facet(const std::array<u32, 4>& tet, unsigned opposite) {
    std::array<u32, 3> corners{};
    unsigned at = 0;
    for (unsigned i = 0; i < 4; ++i)
      if (i != opposite) corners[at++] = tet[i];
    return corners;
  }
  unsigned zeros(const auto& corners) const {
    unsigned count = 0;
    for (const u32 v : corners) count += field_.zero(v);
    return count;
  }

  /// Facets of listed tetrahedra, faces opposite to zeros, listed faces.
  void collect_faces() {
    auto& list = trees_.face_corners;
    list = level_.faces;
    require(std::ranges::is_sorted(list, std::less_equal<>()), "faces: not ascending");
    for (const auto& corners : list)
      require(domain_.find(corners) != kNone && zeros(corners) == 0,
              "faces: no tree can be of ({}, {}, {})", corners[0], corners[1], corners[2]);
    require(std::ranges::is_sorted(level_.tets, std::less_equal<>()), "tetrahedra: not ascending");
    for (const u32 t : level_.tets) {
      require(t < domain_.tets.size(), "tetrahedra: no tetrahedron {}", t);
      if (zeros(domain_.tets[t]) != 0) continue;
      for (unsigned i = 0; i < 4; ++i) list.push_back(facet(domain_.tets[t], i));
    }
    for (const auto& tet : domain_.tets) {
      if (zeros(tet) != 1) continue;
      for (unsigned i = 0; i < 4; ++i)
        if (field_.zero(tet[i])) list.push_back(facet(tet, i));
    }
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  /// Edges of those, edges opposite to two zeros.
  void collect_edges() {
    auto& list = trees_.edge_corners;
    for (const auto& [a, b, c] : trees_.face_corners) {
      list.push_back({a, b});
      list.push_back({b, c});
      list.push_back({a, c});
    }
    for (const auto& tet : domain_.tets) {
      if (zeros(tet) != 2) continue;
      const auto ends = nonzero_corners(field_, tet);
      list.push_back({ends[0], ends[1]});
    }
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  const ModeLevel& level_;
  const Domain& domain_;
  Field& field_;
  Trees trees_;
};

class EdgeReader : public Base {
 public:
  using Base::Base;

 protected:
  std::uint8_t next_code() {
    require(code_ < level_.codes.size(), "trees: codes end early");
    return level_.codes[code_++];
  }

  u32 read_edge(u32 first, u32 second) {
    const auto at = static_cast<u32>(trees_.edges.size());
    trees_.edges.push_back({first, second});
    const unsigned code = next_code();
    if (code >= 1 && code <= 63) {
      const u32 middle = field_.split(first, second, code);
      read_edge(first, middle);
      trees_.edges[at].other = read_edge(middle, second);
    } else if (code == modes_code::kOpenEdge) {
      trees_.edges[at].open = true;
    } else {
      require(code >= modes_code::kRoots && code <= modes_code::kRoots + 6U,
              "trees: code {} of an edge", code);
      const unsigned roots = code - modes_code::kRoots;
      require(level_.roots.size() - root_ >= roots, "trees: roots end early");
      trees_.edges[at].needed = true;
      trees_.edges[at].root = static_cast<u32>(root_);
      trees_.edges[at].roots = static_cast<std::uint8_t>(roots);
      root_ += roots;
    }
    return at;
  }

  void read_edges() {
    std::size_t listed = 0;
    for (const auto& ends : trees_.edge_corners) {
      if (listed < level_.edges.size() && level_.edges[listed] == ends) {
        ++listed;
        trees_.edge_roots.push_back(read_edge(ends[0], ends[1]));
      } else {
        trees_.edge_roots.push_back(static_cast<u32>(trees_.edges.size()));
        trees_.edges.push_back({ends[0], ends[1]});
      }
    }
    require(listed == level_.edges.size(), "edges: not ascending, or of no face with a tree");
  }

  /// Roots of an edge with all its parts; one that is open counts none.
  u32 count_roots(u32 node) {
    require(++visits_ <= 64 * (level_.codes.size() + trees_.face_corners.size()),
            "trees: edges are divided too often for their number of faces");
    const EdgeNode& edge = trees_.edges[node];
    return edge.leaf() ? edge.roots : count_roots(node + 1) + count_roots(edge.other);
  }

  std::size_t code_ = 0, root_ = 0, visits_ = 0;
};

class FaceReader : public EdgeReader {
 public:
  using EdgeReader::EdgeReader;

 protected:
  u32 add_face(const FaceNode& face) {
    trees_.faces.push_back(face);
    return static_cast<u32>(trees_.faces.size() - 1);
  }

  u32 count_roots(const FaceNode& face) {
    u32 roots = 0;
    for (const Side& side : face.edges) roots += EdgeReader::count_roots(side.node);
    return roots;
  }

  u32 read_face(FaceNode face) {
    face.code = next_code();
    face.needed = face.code > 2 && face.code != modes_code::kOpenFace;
    const u32 at = add_face(face);
    if (face.code <= 2) {
      split_face(at);
      return at;
    }
    require(face.code <= modes_code::kOpenFace, "trees: code {} of a face", face.code);
    // Of rejected faces, too: whoever looks at them walks along their edges.
    const u32 roots = count_roots(face);
    if (face.code != modes_code::kGraphFace && face.code != modes_code::kPlainFace) return at;
    require(face_witness_ < level_.face_witnesses.size(), "trees: witnesses of faces end early");
    require(roots <= 255, "trees: {} roots around one face", roots);
    require(level_.arcs.size() - arc_ >= roots / 2, "trees: arcs end early");
    FaceNode& node = trees_.faces[at];
    node.witness = static_cast<u32>(face_witness_++);
    node.arc = static_cast<u32>(arc_);
    node.arcs = roots / 2;
    arc_ += node.arcs;
    return at;
  }

  /// The parts of an edge: at a corner that the face goes on from, at the other.
  std::array<Side, 2> parts(const Side& side) const {
    const EdgeNode& edge = trees_.edges[side.node];
    const Side low = {side.node + 1, side.reversed}, high = {edge.other, side.reversed};
    if (side.reversed) return {high, low};
    return {low, high};
  }

  void split_face(u32 at) {
    const FaceNode face = trees_.faces[at];
    const unsigned k = face.code, next = (k + 1) % 3, last = (k + 2) % 3;
    require(!trees_.edges[face.edges[k].node].leaf(), "trees: a face is split where no edge is");
    const u32 middle = trees_.edges[trees_.edges[face.edges[k].node].other].first;
    const u32 inner = read_edge(face.corners[last], middle);
    const auto [here, there] = parts(face.edges[k]);
    FaceNode near = face, far = face;
    near.corners[next] = middle;
    near.edges[k] = here;
    near.edges[next] = {inner, true};
    far.corners[k] = middle;
    far.edges[k] = there;
    far.edges[last] = {inner, false};
    const u32 near_node = read_face(near), far_node = read_face(far);
    FaceNode& node = trees_.faces[at];
    node.near = near_node;
    node.far = far_node;
    node.inner = inner;
  }

  Side edge_of(u32 a, u32 b) const {
    const u32 node = trees_.edge(std::min(a, b), std::max(a, b));
    return {node, a > b};
  }

  void read_faces() {
    std::size_t listed = 0;
    for (const auto& corners : trees_.face_corners) {
      FaceNode face{};
      face.corners = corners;
      for (unsigned k = 0; k < 3; ++k) face.edges[k] = edge_of(corners[k], corners[(k + 1) % 3]);
      face.code = modes_code::kRejectedFace;
      face.sides = static_cast<std::uint8_t>(domain_.sides(domain_.find(corners)));
      face.near = face.far = face.inner = kNone;
      if (listed < level_.faces.size() && level_.faces[listed] == corners) {
        ++listed;
        trees_.face_roots.push_back(read_face(face));
      } else {
        count_roots(face);
        trees_.face_roots.push_back(add_face(face));
      }
    }
  }

  std::size_t face_witness_ = 0, arc_ = 0;
};

class Reader : public FaceReader {
 public:
  using FaceReader::FaceReader;

  Trees read() {
    collect_faces();
    collect_edges();
    read_edges();
    read_faces();
    read_tets();
    require(code_ == level_.codes.size(), "trees: codes left over");
    require(root_ == level_.roots.size(), "trees: {} roots on edges, {} listed", root_,
            level_.roots.size());
    require(face_witness_ == level_.face_witnesses.size(), "trees: witnesses of faces left over");
    require(arc_ == level_.arcs.size(), "trees: arcs left over");
    require(tet_witness_ == level_.tet_witnesses.size(),
            "trees: witnesses of tetrahedra left over");
    return std::move(trees_);
  }

 private:
  /// The edge of a face between two of its corners, 3 if there is none.
  unsigned edge_in(const FaceNode& face, u32 a, u32 b) const {
    for (unsigned k = 0; k < 3; ++k) {
      const u32 p = face.corners[k], q = face.corners[(k + 1) % 3];
      if ((p == a && q == b) || (p == b && q == a)) return k;
    }
    throw std::logic_error("a facet without its edge");
  }
  Side directed(const FaceNode& face, u32 from, u32 to) const {
    const unsigned k = edge_in(face, from, to);
    Side side = face.edges[k];
    side.reversed = side.reversed != (face.corners[k] != from);
    return side;
  }
  /// The part of a split face that keeps a corner.
  u32 part_with(const FaceNode& face, u32 corner) const {
    const auto& near = trees_.faces[face.near].corners;
    return std::ranges::find(near, corner) != near.end() ? face.near : face.far;
  }

  void read_cell(Cell cell) {
    cell.code = next_code();
    if (cell.code <= 5) return split_cell(cell);
    require(cell.code <= modes_code::kOpenTet, "trees: code {} of a tetrahedron", cell.code);
    if (cell.code == modes_code::kGraphTet || cell.code == modes_code::kPlainTet) {
      require(tet_witness_ < level_.tet_witnesses.size(),
              "trees: witnesses of tetrahedra end early");
      cell.witness = static_cast<u32>(tet_witness_++);
    }
    trees_.cells.push_back(cell);
  }

  void split_cell(const Cell& cell) {
    const auto [i, j] = kTetEdges[cell.code];
    const auto [k, l] = others(i, j);
    const u32 a = cell.corners[i], b = cell.corners[j];
    const auto &at_k = trees_.faces[cell.facets[k]], &at_l = trees_.faces[cell.facets[l]];
    require(at_k.code == edge_in(at_k, a, b) && at_l.code == edge_in(at_l, a, b),
            "trees: a tetrahedron is split where its faces are not");
    const u32 node = at_k.edges[at_k.code].node;
    if (node != at_l.edges[at_l.code].node) throw std::logic_error("faces without a common edge");
    const u32 middle = trees_.edges[trees_.edges[node].other].first;
    FaceNode inner{};
    inner.corners = {cell.corners[k], cell.corners[l], middle};
    inner.edges = {directed(trees_.faces[cell.facets[i]], cell.corners[k], cell.corners[l]),
                   Side{at_k.inner, false}, Side{at_l.inner, true}};
    inner.sides = 2;
    inner.near = inner.far = inner.inner = kNone;
    Cell first = cell, second = cell;
    first.corners[j] = second.corners[i] = middle;
    first.facets[k] = part_with(at_k, a), first.facets[l] = part_with(at_l, a);
    second.facets[k] = part_with(at_k, b), second.facets[l] = part_with(at_l, b);
    first.facets[i] = second.facets[j] = read_face(inner);
    read_cell(first);
    read_cell(second);
  }

  void read_tets() {
    for (const u32 t : level_.tets) {
      Cell cell{};
      cell.corners = domain_.tets[t];
      if (zeros(cell.corners) != 0) {
        require(next_code() == modes_code::kOpenTet,
                "trees: tetrahedron {} has a corner where the tensor is zero", t);
        trees_.open_tets.push_back(t);
        continue;
      }
      for (unsigned i = 0; i < 4; ++i) cell.facets[i] = trees_.face(facet(cell.corners, i));
      read_cell(cell);
    }
  }

  std::size_t tet_witness_ = 0;
};

}  // namespace

u32 Trees::edge(u32 a, u32 b) const {
  const auto at = std::ranges::lower_bound(edge_corners, std::array<u32, 2>{a, b});
  if (at == edge_corners.end() || *at != std::array<u32, 2>{a, b}) return kNone;
  return edge_roots[static_cast<std::size_t>(at - edge_corners.begin())];
}

u32 Trees::face(const std::array<u32, 3>& corners) const {
  const auto at = std::ranges::lower_bound(face_corners, corners);
  if (at == face_corners.end() || *at != corners) return kNone;
  return face_roots[static_cast<std::size_t>(at - face_corners.begin())];
}

void Trees::mark_needed(const Domain& domain, const Field& field) {
  for (const Cell& cell : cells)
    for (const u32 facet : cell.facets) {
      faces[facet].needed |=
          cell.code == modes_code::kGraphTet || cell.code == modes_code::kPlainTet;
      faces[facet].open_sides =
          static_cast<std::uint8_t>(faces[facet].open_sides + (cell.code == modes_code::kOpenTet));
    }
  std::size_t next_open = 0;
  for (u32 t = 0; t < domain.tets.size(); ++t) {
    const bool open = next_open < open_tets.size() && open_tets[next_open] == t;
    next_open += open;
    const auto corners = nonzero_corners(field, domain.tets[t]);
    if (corners.size() == 3) {
      FaceNode& node = faces[face({corners[0], corners[1], corners[2]})];
      node.needed |= !open;
      node.open_sides = static_cast<std::uint8_t>(node.open_sides + open);
    } else if (corners.size() == 2 && !open) {
      edges[edge(corners[0], corners[1])].needed = true;
    }
  }
  for (const FaceNode& node : faces) {
    if (!node.leaf())
      for (const u32 part : {node.near, node.far}) {
        faces[part].needed |= node.needed;
        faces[part].open_sides =
            static_cast<std::uint8_t>(faces[part].open_sides + node.open_sides);
      }
    if (node.code == modes_code::kGraphFace || node.code == modes_code::kPlainFace)
      for (const Side& side : node.edges) edges[side.node].needed = true;
  }
  for (u32 i = 0; i < edges.size(); ++i)
    if (!edges[i].leaf())
      for (const u32 part : {i + 1, edges[i].other}) edges[part].needed |= edges[i].needed;
}

Trees read_trees(const ModeLevel& level, const Domain& domain, Field& field) {
  return Reader(level, domain, field).read();
}

}  // namespace crest::certify::modes
