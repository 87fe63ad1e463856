// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/extraction.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/modes/surface_counts.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {

Extraction::Extraction(const ModeField& field, const Level& level, const ModeOptions& options,
                       const Workers* workers)
    : field_(field),
      scale_(scale_of(field.tensors)),
      level_(level),
      limits_{options.max_depth, options.budget},
      deviation_(options.deviation),
      vertices_(field.tensors, scale_, level),
      lines_(vertices_, level),
      faces_(vertices_, lines_, level, limits_),
      cells_(faces_, level, limits_),
      mesh_faces_(field.mesh.faces().size(), kNone) {
  vertices_.find_signs();
  decide_all(workers);
  close_cones();
  list_open();
}

Index Extraction::edge(Index a, Index b) {
  Index e = mesh_edges_.find(a, b);
  if (e == kNone) mesh_edges_.add(a, b, e = faces_.add_edge(std::min(a, b), std::max(a, b)));
  return e;
}

Index Extraction::face(Index mesh_face) {
  Index& f = mesh_faces_[mesh_face];
  if (f != kNone) return f;
  const auto& v = field_.mesh.faces()[mesh_face].corners;
  const std::array<Index, 3> edges = {edge(v[0], v[1]), edge(v[1], v[2]), edge(v[2], v[0])};
  f = faces_.add_face(v, edges, 0, faces_.add_account());
  if (field_.mesh.faces()[mesh_face].tets[1] == kernel::TetMesh::kNoTet) faces_.mark_boundary(f);
  return f;
}

void Extraction::decide_all(const Workers* workers) {
  const auto count = static_cast<Index>(field_.mesh.tets().size());
  counts_.total = count;
  TetRecords records = test_tets(field_, vertices_, scale_, level_, limits_, workers);
  faces_.reserve(static_cast<std::size_t>(
      std::count_if(records.signs.begin(), records.signs.end(),
                    [](const CellSign& s) { return s.finding == Finding::none; })));
  for (Index t = 0; t < count; ++t) {
    const CellSign& sign = records.signs[t];
    const auto corners = field_.mesh.sorted(t);
    if (std::any_of(corners.begin(), corners.end(),
                    [&](Index x) { return vertices_.is_zero(x); })) {
      Cone c{t, {}, {}, false};
      for (const Index x : corners) (vertices_.is_zero(x) ? c.zeros : c.others).push_back(x);
      if (c.others.size() >= 2) cones_.push_back(std::move(c));
      ++counts_.cones;
    } else if (sign.finding != Finding::none) {
      ++(sign.bound ? counts_.rejected_bound : counts_.rejected_bernstein);
      counts_.uniform += sign.finding == Finding::uniform ? 1 : 0;
    } else {
      ++counts_.active;
      std::array<Index, 4> faces;
      for (std::size_t i = 0; i < 4; ++i) faces[i] = face(field_.mesh.faces_of(t)[i]);
      trees_.push_back({t, cells_.add(t, corners, faces)});
    }
  }
  cells_.decide({std::move(records.tests), records.counts});
  for (const Tree& tree : trees_)
    counts_.graph_at_once += cells_.cell(tree.cell).state == State::graph ? 1 : 0;
}

/// The curves on faces that cones stand on; roots of edges that fans do.
void Extraction::close_cones() {
  std::vector<Index> faces;
  for (const Cone& c : cones_)
    if (c.zeros.size() == 1)
      faces.push_back(face(opposite_face(c)));
    else if (c.zeros.size() == 2)
      faces_.roots(edge(c.others[0], c.others[1]));
  faces_.close(faces);
  for (Cone& c : cones_) {
    if (c.zeros.size() != 1 || faces_.is_closed(face_of(c))) continue;
    c.open = true;
    open_.push_back(c.tet);
    faces_.for_each_leaf(face_of(c), [&](Index leaf) { open_faces_.insert(leaf); });
  }
}

/// Open cells, and what was counted.
void Extraction::list_open() {
  for (Index c = 0; c < cells_.size(); ++c) {
    counts_.graph_cells += cells_.cell(c).state == State::graph ? 1 : 0;
    if (cells_.cell(c).state != State::open) continue;
    open_.push_back(cells_.cell(c).tet);
    for (const Index f : cells_.cell(c).faces)
      faces_.for_each_leaf(f, [&](Index leaf) { open_faces_.insert(leaf); });
  }
  std::sort(open_.begin(), open_.end());
  open_.erase(std::unique(open_.begin(), open_.end()), open_.end());
  counts_.tests = cells_.counters().tests + faces_.counters().tests + counts_.total;
  counts_.exact_tests = cells_.counters().exact_tests + faces_.counters().exact_tests;
  counts_.max_depth = std::max(cells_.counters().depth, faces_.counters().depth);
}

/// Of a tree's root: its corners ascending; parts keep it, a corner being replaced by one beside
/// it.
int Extraction::orientation(const Cell& cell) const {
  const auto given = field_.mesh.tets()[cell.tet];
  int sign = field_.mesh.orientation(cell.tet) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (given[i] > given[k]) sign = -sign;
  return sign;
}

void Extraction::add_leaves(SurfaceBuilder& builder, Side side, Index c, int orientation) {
  const Cell& cell = cells_.cell(c);
  if (cell.part[0] != kNone) {
    for (const Index part : cell.part) add_leaves(builder, side, part, orientation);
    return;
  }
  if (cell.state != State::graph) return;
  const std::size_t count = cell.pieces[static_cast<std::size_t>(static_cast<int>(side) + 1)];
  if (count == 0) return;
  builder.add_cell(c, cell, orientation,
                   CellTopology(faces_, cell.faces, cell.witness.w).pieces(side, count));
}

void Extraction::add_pieces(SurfaceBuilder& builder, Side side) {
  for (const Tree& tree : trees_)
    add_leaves(builder, side, tree.cell, orientation(cells_.cell(tree.cell)));
  for (const Cone& c : cones_)
    for (std::size_t k = 0; k < 3 && c.open; ++k)
      builder.leave_open(c.zeros[0], edge_between(c.others[k], c.others[(k + 1) % 3]));
  for (const Cone& c : cones_) {
    if (c.open) continue;
    if (c.zeros.size() == 2) {
      builder.add_fan(c.tet, c.zeros[0], c.zeros[1], edge_between(c.others[0], c.others[1]));
      continue;
    }
    builder.add_cone(c.tet, c.zeros[0], face_of(c));
  }
}

std::span<const std::array<double, 3>> Extraction::polyline(Index arc) const {
  const auto side = static_cast<std::size_t>(static_cast<int>(faces_.arcs()[arc].side) + 1);
  const auto found = polylines_[side].find(arc);
  if (found == polylines_[side].end()) return {};
  return found->second;
}

std::span<const std::array<double, 4>> Extraction::inner(Index cell, Side side) const {
  const auto& of_side = inner_[static_cast<std::size_t>(static_cast<int>(side) + 1)];
  const auto found = of_side.find(cell);
  if (found == of_side.end()) return {};
  return found->second;
}

/// Only reads the trees, and keeps its polylines and vertices inside cells.
ModeSurface Extraction::surface(Side side, std::size_t cone_rims) {
  SurfaceBuilder builder(faces_, level_, side, field_.mesh.points(), open_faces_);
  add_pieces(builder, side);
  ModeSurface s = builder.build(deviation_);
  polylines_[static_cast<std::size_t>(static_cast<int>(side) + 1)] = builder.polylines();
  inner_[static_cast<std::size_t>(static_cast<int>(side) + 1)] = builder.inner();
  const auto boundary = count(s);
  for (const auto& [a, b] : boundary)
    if (s.tensors[a] == Symmetric{} && s.tensors[b] == Symmetric{}) ++s.zero_rims;
  // Each of these is an edge of one triangle: no others, if there are as many.
  s.watertight = boundary.size() == builder.boundary_segments() + cone_rims + s.zero_rims;
  s.face_loops = face_loops(side);
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (builder.touches_open(t)) s.components[s.component_of[t]].complete = false;
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (product(s.tensors[v], s.tensors[v]) > 0)
      s.max_mode_error =
          std::fmax(s.max_mode_error, std::fabs(ModeFunction::mode(s.tensors[v]) - s.mode));
  return s;
}

/// Segments from a zero corner to the roots of the opposite edge, in faces on the boundary.
std::size_t Extraction::cone_rims(Side side) {
  std::size_t count = 0;
  for (const Cone& c : cones_)
    for (const Index f : field_.mesh.faces_of(c.tet)) {
      if (c.open || field_.mesh.faces()[f].tets[1] != kernel::TetMesh::kNoTet) continue;
      std::vector<Index> others;
      for (const Index v : field_.mesh.faces()[f].corners)
        if (!vertices_.is_zero(v)) others.push_back(v);
      if (others.size() != 2) continue;
      const Index e = edge_between(others[0], others[1]);
      if (e == kNone) continue;
      const RootNumbers roots = lines_.roots(faces_.edge(e).line);
      for (std::size_t i = 0; i < roots.size(); ++i)
        count += lines_.root(roots[i]).side == side ? 1 : 0;
    }
  return count;
}

/// Cycles of arcs in the tree of one face of the mesh.
std::size_t Extraction::face_loops(Side side) const {
  std::size_t count = 0;
  for (const Index f : mesh_faces_) {
    if (f == kNone || faces_.face(f).split < 0) continue;
    std::unordered_map<Index, std::vector<Index>> next;
    faces_.for_each_arc(f, side, [&](Index a) {
      const Arc& arc = faces_.arcs()[a];
      next[arc.roots[0]].push_back(arc.roots[1]);
      next[arc.roots[1]].push_back(arc.roots[0]);
    });
    std::unordered_set<Index> seen;
    for (const auto& [start, ends] : next) {
      if (seen.contains(start)) continue;
      bool closed = true;
      std::vector<Index> stack{start};
      while (!stack.empty()) {
        const Index r = stack.back();
        stack.pop_back();
        if (!seen.insert(r).second) continue;
        closed = closed && next.at(r).size() == 2;
        for (const Index n : next.at(r)) stack.push_back(n);
      }
      count += closed ? 1 : 0;
    }
  }
  return count;
}

Perturbed Extraction::perturbed(Side side) {
  Perturbed p;
  p.uniform_tets = counts_.uniform;
  for (Index v = 0; v < vertices_.mesh_size(); ++v) {
    if (vertices_.is_zero(v)) continue;
    const PointSigns s = vertices_.signs(v);
    const int det = static_cast<int>(s.det);
    p.vertices += s.f == kernel::Sign::zero && det == static_cast<int>(side) ? 1 : 0;
  }
  for (const Index e : mesh_edges_.numbers()) {
    const Lines::Line& line = lines_.line(faces_.edge(e).line);
    // A place touched from below has two roots, one before and one behind it.
    for (std::size_t i = 1; i < line.roots.size(); ++i) {
      const Root &a = lines_.root(line.roots[i - 1]), &b = lines_.root(line.roots[i]);
      p.edge_touches += a.side == side && b.side == side && a.shift < 0 && b.shift > 0 &&
                                a.number && b.number &&
                                kernel::compare(*a.number, *b.number) == kernel::Sign::zero
                            ? 1
                            : 0;
    }
  }
  return p;
}

Index Extraction::opposite_face(const Cone& c) const {
  const auto v = field_.mesh.sorted(c.tet);
  const auto i = static_cast<std::size_t>(std::find(v.begin(), v.end(), c.zeros[0]) - v.begin());
  return field_.mesh.faces_of(c.tet)[i];
}

ModeResult Extraction::result() {
  ModeResult r;
  r.level = level_;
  std::vector<Side> sides = {Side::plus, Side::minus};
  if (level_.neutral()) sides = {Side::neutral};
  std::vector<std::size_t> rims;  // before: a root may be isolated for them
  for (const Side side : sides) rims.push_back(cone_rims(side));
  r.surfaces.resize(sides.size());
  kernel::parallel_for(std::size_t{0}, sides.size(), [&](std::size_t i) {
    r.surfaces[i] = surface(sides[i], rims[i]);
    r.surfaces[i].perturbed = perturbed(sides[i]);
  });
  r.counts = counts_;
  r.undecided = open_;
  r.exhausted = cells_.exhausted();
  return r;
}

}  // namespace crest::modes
