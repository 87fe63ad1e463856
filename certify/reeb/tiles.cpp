// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"
#include "certify/reeb/quadratic.hpp"

namespace crest::certify::reeb {
namespace {

using kernel::Sign;

bool has_line_node(const EdgeValues& e, SignLadder& sign) {
  const Sign start = sign([&](auto lift) { return start_slope(lift, e); });
  if (start == Sign::zero) return false;
  return sign([&](auto lift) { return end_slope(lift, e); }) == -start;
}

bool has_face_node(const FaceValues& f, SignLadder& sign) {
  const Sign h = sign([&](auto lift) { return quadratic(lift, f).hessian(); });
  if (h == Sign::zero) return false;
  for (unsigned corner = 0; corner < 3; ++corner)
    if (weight_sign(f, corner, sign) != h) return false;
  return true;
}

/// Is the node on side i a boundary saddle? With A B the side, C the opposite corner and s along
/// A B, t along A C, the node is at s = -g / P and the derivative in direction of C is
/// h + Q s = (h P - g Q) / P: its sign is opposite to that of P iff the weight of C,
/// g Q - h P, is positive. The weights do not depend on the choice of A.
bool is_boundary_saddle(const FaceValues& f, unsigned side, SignLadder& sign) {
  const Sign w = weight_sign(f, (side + 2) % 3, sign);
  if (w != Sign::zero) return w == Sign::positive;
  return sign([&](auto lift) { return quadratic(lift, f).hessian(); }) == Sign::negative;
}

/// The two sides with nodes are j + 1 = B C (node on_bc) and j + 2 = C A (node on_ca).
void two_line_nodes(Triangles& tiles, const Corners& face, const FaceValues& f, unsigned j,
                    u32 on_bc, u32 on_ca, SignLadder& sign) {
  const u32 a = face[j], b = face[(j + 1) % 3], c = face[(j + 2) % 3];
  tiles.push_back({c, on_ca, on_bc});
  const bool from_b = is_boundary_saddle(f, (j + 2) % 3, sign) ||
                      (!is_boundary_saddle(f, (j + 1) % 3, sign) && b < a);
  if (from_b) {
    tiles.push_back({a, b, on_ca});
    tiles.push_back({b, on_bc, on_ca});
  } else {
    tiles.push_back({a, b, on_bc});
    tiles.push_back({a, on_bc, on_ca});
  }
}

void fan(Triangles& tiles, const Corners& face, const Corners& line, u32 centre) {
  u32 before = line[2] == kNone ? face[2] : line[2];
  for (std::size_t i = 0; i < 3; ++i) {
    tiles.push_back({centre, before, face[i]});
    before = face[i];
    if (line[i] == kNone) continue;
    tiles.push_back({centre, before, line[i]});
    before = line[i];
  }
}

/// line: nodes on the sides or kNone; there is no face-critical node.
void cut_face(Triangles& tiles, const Corners& face, const Corners& line, const FaceValues& f,
              SignLadder& sign) {
  const auto count = 3 - std::count(line.begin(), line.end(), kNone);
  if (count == 0) {
    tiles.push_back(face);
  } else if (count == 3) {
    tiles.push_back(line);
    for (std::size_t i = 0; i < 3; ++i) tiles.push_back({face[i], line[i], line[(i + 2) % 3]});
  } else if (count == 1) {
    unsigned i = 0;
    while (line[i] == kNone) ++i;
    const u32 a = face[i], b = face[(i + 1) % 3], c = face[(i + 2) % 3];
    tiles.push_back({a, line[i], c});
    tiles.push_back({line[i], b, c});
  } else {
    unsigned j = 0;
    while (line[j] != kNone) ++j;
    two_line_nodes(tiles, face, f, j, line[(j + 1) % 3], line[(j + 2) % 3], sign);
  }
}

void number_line_nodes(const ReebContents& c, const Gluing& mesh, Tiling& out, SignLadder& sign) {
  const auto vertices = static_cast<u32>(c.values.size());
  out.line_node.assign(mesh.edges.size(), kNone);
  for (u32 e = 0; e < mesh.edges.size(); ++e) {
    if (!has_line_node(values_on_edge(c, mesh, e), sign)) continue;
    out.line_node[e] = vertices + static_cast<u32>(out.line_edges.size());
    out.line_edges.push_back(e);
  }
}

Corners line_nodes_of(const Gluing& mesh, const Buffer<u32>& line_node, u32 f) {
  return {line_node[mesh.edge_of[3 * f]], line_node[mesh.edge_of[3 * f + 1]],
          line_node[mesh.edge_of[3 * f + 2]]};
}

/// The node of each face; a face without line-critical nodes has none (section 4 of the paper,
/// case <1,0>: an ellipse grows inside until it touches a side; two asymptotes meet the three
/// closed sides in four points, so one side twice).
Buffer<u32> number_face_nodes(const ReebContents& c, const Gluing& mesh, Tiling& out,
                              SignLadder& sign) {
  struct Keyed {
    Corners corners;
    u32 face;
  };
  std::vector<Keyed> keyed;
  for (u32 f = 0; f < c.faces.size(); ++f) {
    if (line_nodes_of(mesh, out.line_node, f) == Corners{kNone, kNone, kNone}) continue;
    if (!has_face_node(values_in_face(c, mesh, f), sign)) continue;
    Corners sorted = c.faces[f];
    std::sort(sorted.begin(), sorted.end());
    keyed.push_back({sorted, f});
  }
  std::sort(keyed.begin(), keyed.end(),
            [](const Keyed& a, const Keyed& b) { return a.corners < b.corners; });
  Buffer<u32> face_node(c.faces.size(), kNone);
  auto number = static_cast<u32>(c.values.size() + out.line_edges.size());
  for (const Keyed& k : keyed) {
    face_node[k.face] = number++;
    out.critical_faces.push_back(k.face);
  }
  return face_node;
}

}  // namespace

Tiling tessellate(const ReebContents& c, const Gluing& mesh, SignLadder& sign) {
  require(c.edge_values.size() == mesh.edges.size(), "data: {} midpoint values for {} edges",
          c.edge_values.size(), mesh.edges.size());
  require(
      c.values.size() + mesh.edges.size() + c.faces.size() < kNone && 18 * c.faces.size() < kNone,
      "data: more tiles than the format numbers");
  Tiling out;
  number_line_nodes(c, mesh, out, sign);
  const auto face_node = number_face_nodes(c, mesh, out, sign);
  out.first.resize(c.faces.size() + 1);
  out.tiles.reserve(c.faces.size() + 2 * out.line_edges.size() + 3 * out.critical_faces.size());
  for (u32 f = 0; f < c.faces.size(); ++f) {
    const Corners line = line_nodes_of(mesh, out.line_node, f);
    out.first[f] = static_cast<u32>(out.tiles.size());
    if (face_node[f] != kNone)
      fan(out.tiles, c.faces[f], line, face_node[f]);
    else
      cut_face(out.tiles, c.faces[f], line, values_in_face(c, mesh, f), sign);
  }
  out.first.back() = static_cast<u32>(out.tiles.size());
  return out;
}

}  // namespace crest::certify::reeb
