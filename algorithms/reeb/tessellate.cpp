// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "algorithms/reeb/node_order.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "kernel/predicates/boundary_saddle.hpp"
#include "kernel/predicates/line_critical.hpp"

namespace crest::reeb {
namespace {

using kernel::Decision;
using kernel::EdgeValues;
using kernel::FaceValues;
using kernel::QuadraticMesh;
using kernel::Sign;
using kernel::Stage;
using kernel::StageCounts;

struct Guarded {
  static Decision line(const EdgeValues& e) { return kernel::line_critical(e); }
  static Decision face(const FaceValues& f) { return kernel::face_critical(f); }
  static Decision saddle(const FaceValues& f) { return kernel::boundary_saddle(f); }
};

// The same formulas in plain double.
struct Plain {
  template <class Formula>
  static Sign of(const Formula& formula) {
    return kernel::sign_of(formula.template value<double>());
  }
  static Decision line(const EdgeValues& e) {
    const Sign a = of(kernel::EndSlope{e});
    return {a == of(kernel::EndSlope{{e.b, e.a, e.m}}) ? -a : Sign::zero, Stage::triage};
  }
  static Decision face(const FaceValues& f) {
    const Sign s = of(kernel::CentreSide{f});
    const bool inside =
        s == of(kernel::CentreSide{f.rotated(1)}) && s == of(kernel::CentreSide{f.rotated(2)});
    return {inside ? s : Sign::zero, Stage::triage};
  }
  static Decision saddle(const FaceValues& f) {
    const Sign s = of(kernel::CentreSide{f});
    return {s != Sign::zero ? s : -of(kernel::Hessian{f}), Stage::triage};
  }
};

template <class Rule>
class Tessellation {
 public:
  explicit Tessellation(const QuadraticMesh& mesh) : mesh_(mesh) {
    result.vertex_count = mesh.vertex_count();
  }

  void run() {
    find_line_critical();
    find_face_critical();
    number_face_critical();
    cut_faces();
  }

  TileComplex result;
  std::vector<Sign> signs;  ///< of the second derivatives at the nodes from V on
  StageCounts line, face, saddle;

 private:
  void find_line_critical() {
    edge_node_.assign(mesh_.edge_count(), kNone);
    for (Index i = 0; i < mesh_.edge_count(); ++i) {
      const kernel::Edge& e = mesh_.edges()[i];
      const Decision d =
          Rule::line({mesh_.values()[e.v0], mesh_.values()[e.v1], mesh_.edge_values()[i]});
      line.add(d.stage);
      if (d.sign == Sign::zero) continue;
      edge_node_[i] = result.vertex_count + static_cast<Index>(result.critical_edges.size());
      result.critical_edges.push_back(i);
      signs.push_back(d.sign);
    }
  }

  std::array<Index, 3> side_nodes(Index f) const {
    const auto& e = mesh_.face_edges()[f];
    return {edge_node_[e[0]], edge_node_[e[1]], edge_node_[e[2]]};
  }

  // A face-critical point implies a line-critical one, so faces without are not looked at.
  void find_face_critical() {
    result.tile_begin.reserve(mesh_.face_count() + std::size_t{1});
    Index tiles = 0;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      result.tile_begin.push_back(tiles);
      const auto nodes = side_nodes(f);
      const auto l = static_cast<Index>(3 - std::count(nodes.begin(), nodes.end(), kNone));
      tiles += l + 1;
      if (l == 0) continue;
      const Decision d = Rule::face(face_values(mesh_, f));
      face.add(d.stage);
      if (d.sign == Sign::zero) continue;
      tiles += 2;  // the fan has l + 3
      result.critical_faces.push_back(f);
      face_signs_.push_back(d.sign);
    }
    result.tile_begin.push_back(tiles);
  }

  // By sorted corners, so that the faces' order does not matter.
  void number_face_critical() {
    struct Found {
      Triangle corners;
      Index face;
      Sign sign;
    };
    std::vector<Found> found;
    found.reserve(face_signs_.size());
    for (std::size_t i = 0; i < face_signs_.size(); ++i) {
      Triangle t = mesh_.faces()[result.critical_faces[i]];
      std::sort(t.begin(), t.end());
      found.push_back({t, result.critical_faces[i], face_signs_[i]});
    }
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.corners < b.corners; });
    signs.reserve(signs.size() + found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      result.critical_faces[i] = found[i].face;
      signs.push_back(found[i].sign);
    }
    face_signs_ = {};
  }

  void cut_faces() {
    const Index first = result.vertex_count + static_cast<Index>(result.critical_edges.size());
    std::vector<Index> centre(mesh_.face_count(), kNone);
    for (Index i = 0; i < result.critical_faces.size(); ++i)
      centre[result.critical_faces[i]] = first + i;
    result.tiles.reserve(result.tile_begin.back());
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      const auto nodes = side_nodes(f);
      if (centre[f] != kNone)
        cut_fan(f, nodes, centre[f]);
      else
        cut_without_centre(f, nodes);
    }
  }

  void cut_fan(Index f, const std::array<Index, 3>& nodes, Index centre) {
    std::array<Index, 6> around{};
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      around[n++] = mesh_.faces()[f][k];
      if (nodes[k] != kNone) around[n++] = nodes[k];
    }
    for (std::size_t i = 0; i < n; ++i)
      result.tiles.push_back({centre, around[i], around[(i + 1) % n]});
  }

  void cut_without_centre(Index f, const std::array<Index, 3>& e) {
    const Triangle& c = mesh_.faces()[f];
    const auto l = 3 - std::count(e.begin(), e.end(), kNone);
    if (l == 0) {
      result.tiles.push_back(c);
    } else if (l == 1) {
      const std::size_t k = e[0] != kNone ? 0 : e[1] != kNone ? 1 : 2, m = (k + 2) % 3;
      result.tiles.push_back({c[k], e[k], c[m]});
      result.tiles.push_back({e[k], c[(k + 1) % 3], c[m]});
    } else if (l == 2) {
      cut_two(f, e[0] == kNone ? 0 : e[1] == kNone ? 1 : 2, e);
    } else {
      result.tiles.push_back(Triangle{e[0], e[1], e[2]});
      for (std::size_t k = 0; k < 3; ++k) result.tiles.push_back({c[k], e[k], e[(k + 2) % 3]});
    }
  }

  // Side k is the one without a node: A = corner k, B = corner k + 1, C the third.
  void cut_two(Index f, std::size_t k, const std::array<Index, 3>& nodes) {
    const Triangle& c = mesh_.faces()[f];
    const std::size_t kb = (k + 1) % 3, kc = (k + 2) % 3;
    const Index a = c[k], b = c[kb], e = nodes[kc], e_prime = nodes[kb];
    result.tiles.push_back({e_prime, c[kc], e});
    bool from_b = b < a;
    const FaceValues values = face_values(mesh_, f);
    if (is_saddle(values.rotated(kc)))
      from_b = true;
    else if (is_saddle(values.rotated(kb)))
      from_b = false;
    if (from_b) {
      result.tiles.push_back({a, b, e});
      result.tiles.push_back({b, e_prime, e});
    } else {
      result.tiles.push_back({a, b, e_prime});
      result.tiles.push_back({a, e_prime, e});
    }
  }

  bool is_saddle(const FaceValues& values) {
    const Decision d = Rule::saddle(values);
    saddle.add(d.stage);
    return d.sign == Sign::positive;
  }

  const QuadraticMesh& mesh_;
  std::vector<Index> edge_node_;
  std::vector<Sign> face_signs_;
};

template <class Rule>
TileComplex tessellate_with(const QuadraticMesh& mesh, PredicateReport* report, bool guarded) {
  Tessellation<Rule> t(mesh);
  if (mesh.linear())
    t.result.tiles = mesh.faces();
  else
    t.run();
  StageCounts order;
  order_nodes(mesh, t.signs, guarded, t.result, order);
  if (report)
    *report = {{"line_critical", t.line},
               {"face_critical", t.face},
               {"boundary_saddle", t.saddle},
               {"critical_value_order", order}};
  return std::move(t.result);
}

}  // namespace

TileComplex tessellate(const QuadraticMesh& mesh, PredicateReport* report, bool guarded) {
  return guarded ? tessellate_with<Guarded>(mesh, report, true)
                 : tessellate_with<Plain>(mesh, report, false);
}

std::vector<NodePlace> node_places(const QuadraticMesh& mesh, const TileComplex& tiles) {
  std::vector<NodePlace> places(tiles.node_count());
  for (Index v = 0; v < tiles.vertex_count; ++v) places[v].point = mesh.points()[v];
  // The largest lower bound so far lies in every node's enclosure and never descends.
  double value = 0;
  for (Index r = 0; r < tiles.node_count(); ++r) {
    const Index node = tiles.order[r];
    const auto raise = [&](double low) { value = r == 0 ? low : std::max(value, low); };
    NodePlace& place = places[node];
    if (node < tiles.vertex_count) {  // nearly all are: nothing but its value is needed
      raise(mesh.values()[node]);
      place.value = value;
      continue;
    }
    const kernel::CriticalValue v = node_value(mesh, tiles, {}, node);
    raise(kernel::value_range(v).low);
    place.value = value;
    Triangle corners{};
    if (v.kind == kernel::ValueKind::edge) {
      const kernel::Edge& e = mesh.edges()[tiles.critical_edges[node - tiles.vertex_count]];
      corners = {e.v0, e.v1, e.v0};
    } else {
      corners = mesh.faces()[tiles.critical_faces[node - tiles.vertex_count -
                                                  tiles.critical_edges.size()]];
      std::sort(corners.begin(), corners.end());
    }
    const auto [x, y] = kernel::critical_place(v);
    const kernel::Vec3 &p = mesh.points()[corners[0]], &q = mesh.points()[corners[1]],
                       &s = mesh.points()[corners[2]];
    for (std::size_t i = 0; i < 3; ++i)
      place.point[i] = p[i] + x * (q[i] - p[i]) + y * (s[i] - p[i]);
  }
  return places;
}

}  // namespace crest::reeb
