// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as pieces of triangles, cut one by one, and everything counted on the pieces.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "tests/certify_extremal/reference_extremal.hpp"

namespace crest::tests {
namespace {

using namespace certify;
namespace code = extremal_code;
using u32 = std::uint32_t;
using Key = std::tuple<int, u32, u32>;  ///< names a node or a side of the cut mesh

/// Classes of keys.
struct Classes {
  std::map<Key, Key> parent;
  Key find(const Key& a) {
    const auto at = parent.try_emplace(a, a).first;
    if (at->second == a) return a;
    return at->second = find(Key(at->second));
  }
  void join(const Key& a, const Key& b) {
    const Key x = find(a), y = find(b);
    if (x != y) parent[std::max(x, y)] = std::min(x, y);
  }
};

struct Square {
  u32 id;
  std::array<u32, 4> edges, cells{};  // below, above; an image: the one
};
struct Group {
  u32 square;
  std::array<u32, 4> cells;
  std::vector<u32> all, polygons;  ///< edges
  unsigned reason = 0;
};
/// Of the cut mesh: sides in order, each from a node to the next one's.
struct Piece {
  std::vector<Key> nodes, sides;
};

/// What all steps know.
class MeshState {
 public:
  MeshState(ExtremalCertificate& c, const ReferenceFields& fields,
            const std::vector<std::uint8_t>& states, const ExtremalCertificate* stated)
      : c_(c),
        fields_(fields),
        states_(states),
        stated_(stated),
        d_(c.data.dimension),
        code_(fields.nodes, 0xff) {
    std::size_t at = 0;
    for (const CellRun& run : c.cells)
      for (u32 cell = run.first; cell < run.first + run.length; ++cell) {
        code_[cell] = c.codes[at++];
        if (code_[cell] != code::kOpen) direction_[cell] = c.directions[direction_.size()];
      }
    squares_ = squares();
  }

 protected:
  u32 stride(unsigned k) const {
    return k == 0 ? 1 : k == 1 ? c_.data.nodes[0] : c_.data.nodes[0] * c_.data.nodes[1];
  }
  u32 at(u32 node, unsigned k) const { return static_cast<u32>(fields_.place(node)[k]); }
  bool inside(u32 edge) const {
    for (unsigned k = 0; k < d_; ++k)
      if (k != edge % d_ && (at(edge / d_, k) == 0 || at(edge / d_, k) + 1 == c_.data.nodes[k]))
        return false;
    return true;
  }
  std::vector<u32> cells_round(u32 edge) const {
    const u32 node = edge / d_;
    if (d_ == 2) return {node - stride(1 - edge % 2), node};
    const u32 a = stride((edge + 1) % 3), b = stride((edge + 2) % 3);
    return {node - a - b, node - b, node, node - a};
  }
  std::vector<Square> squares() const {
    std::vector<Square> out;
    for (u32 node = 0; node < fields_.nodes; ++node)
      for (unsigned normal = 0; normal < (d_ == 3 ? 3U : 1U); ++normal) {
        const unsigned a = d_ == 3 ? (normal + 1) % 3 : 0, b = d_ == 3 ? (normal + 2) % 3 : 1;
        if (at(node, a) + 1 == c_.data.nodes[a] || at(node, b) + 1 == c_.data.nodes[b]) continue;
        Square square{d_ == 3 ? 3 * node + normal : node,
                      {d_ * node + a, d_ * (node + stride(a)) + b, d_ * (node + stride(b)) + a,
                       d_ * node + b}};
        square.cells = {d_ == 3 ? node - stride(normal) : node, node};
        out.push_back(square);
      }
    return out;
  }
  bool touches_listed(u32 edge) const {
    for (u32 cell = 0; cell < fields_.nodes; ++cell) {
      if (code_[cell] == 0xff) continue;
      bool has = true;
      for (unsigned k = 0; k < d_; ++k) {
        const u32 away = at(edge / d_, k) - at(cell, k);
        has = has && away <= (k == edge % d_ ? 0U : 1U);
      }
      if (has) return true;
    }
    return false;
  }

  bool is_polygon(u32 edge) const { return std::ranges::binary_search(polygons_, edge); }

  Key corner(u32 edge, u32 cell) const { return {1, vertex_.at({edge, cell}), 0}; }
  bool kept(const Key& node) const { return kept_.at(node); }

  ExtremalCertificate& c_;
  const ReferenceFields& fields_;
  const std::vector<std::uint8_t>& states_;
  const ExtremalCertificate* stated_;
  unsigned d_;
  std::vector<std::uint8_t> code_;
  std::map<u32, ExtremalDirection> direction_;
  std::vector<Square> squares_;
  std::vector<u32> polygons_, vertex_cells_;
  std::vector<Group> groups_;
  std::map<std::pair<u32, u32>, u32> vertex_;  ///< of (edge, cell)
  std::map<Key, bool> kept_;
  std::vector<std::pair<Piece, u32>> pieces_;
  u32 cuts_ = 0;
};

class GroupMaker : public MeshState {
 public:
  using MeshState::MeshState;

 protected:
  void make_groups() {
    for (const Square& square : squares_) {
      std::vector<u32> critical, untested;
      for (const u32 edge : square.edges) {
        if (states_[edge] >= 2) critical.push_back(edge);
        if (states_[edge] == 0) untested.push_back(edge);
      }
      if (critical.empty()) continue;
      std::vector<std::vector<u32>> groups;
      if (!untested.empty()) {
        const bool five = std::ranges::any_of(untested, [&](u32 e) { return touches_listed(e); });
        for (const u32 edge : critical) add_group(square, {edge}, five ? 5 : 4);
        continue;
      }
      c_.odd_faces += static_cast<u32>(critical.size() % 2);
      if (critical.size() != 4) {
        add_group(square, critical, 0);
        continue;
      }
      c_.pairings.push_back(stated_ != nullptr ? stated_->pairings.at(c_.pairings.size())
                                               : static_cast<std::uint8_t>(square.id % 2));
      const auto& e = square.edges;
      const bool other = c_.pairings.back() == 1;
      add_group(square, other ? std::vector{e[1], e[2]} : std::vector{e[0], e[1]}, 0);
      add_group(square, other ? std::vector{e[3], e[0]} : std::vector{e[2], e[3]}, 0);
    }
  }
  void add_group(const Square& square, std::vector<u32> edges, unsigned reason) {
    Group group{square.id, square.cells, std::move(edges), {}, reason};
    for (const u32 edge : group.all)
      if (is_polygon(edge)) group.polygons.push_back(edge);
    if (group.polygons.empty()) return;
    if (reason == 0 && group.polygons.size() != 2) {
      group.reason = 1;
      if (group.all.size() == 2) {
        const u32 mate = group.all[0] == group.polygons[0] ? group.all[1] : group.all[0];
        group.reason = states_[mate] == 3 ? 4 : states_[mate] == 2 ? 2 : 5;
      }
    }
    groups_.push_back(group);
  }
};

/// Vertices, and the pieces that are kept.
class PieceMaker : public GroupMaker {
 public:
  using GroupMaker::GroupMaker;

 protected:
  void make_vertices() {
    Classes classes;
    for (const Group& group : groups_)
      for (const u32 cell : std::set<u32>(group.cells.begin(), group.cells.begin() + 2))
        for (const u32 edge : group.polygons)
          classes.join({0, group.polygons[0], cell}, {0, edge, cell});
    std::map<std::pair<u32, u32>, std::vector<u32>> order;  // (cell, lowest edge) -> edges
    for (const u32 edge : polygons_)
      for (const u32 cell : cells_round(edge))
        order[{cell, std::get<1>(classes.find({0, edge, cell}))}].push_back(edge);
    for (const auto& [first, edges] : order) {
      Vec sum{};
      for (const u32 edge : edges) {
        const Vec from = fields_.place(edge / d_), low = fields_.place(first.first);
        for (unsigned k = 0; k < d_; ++k)
          sum[k] += from[k] - low[k] + (k == edge % d_ ? zero(edge) : 0);
        vertex_[{edge, first.first}] = static_cast<u32>(c_.vertices.size());
      }
      std::array<std::uint16_t, 3> place{};
      for (unsigned k = 0; k < d_; ++k)
        place[k] = static_cast<std::uint16_t>(
            std::clamp(sum[k] / static_cast<double>(edges.size()) * 65536, 1024.0, 64512.0));
      c_.vertices.push_back(stated_ != nullptr ? stated_->vertices.at(c_.vertices.size()) : place);
      vertex_cells_.push_back(first.first);
    }
  }

  /// Where g changes its sign first.
  double zero(u32 edge) const {
    const auto net = fields_.edge(edge / d_, edge % d_);
    Vec n = eigen(net[0].tensor).vectors[0];
    const double first = dot(n, net[0].gradient);
    for (int i = 1; i <= 64; ++i) {
      const PointFields here = on_edge(net, i / 64.0);
      const Vec next = eigen(here.tensor).vectors[0];
      const double turn = dot(next, n) < 0 ? -1 : 1;
      for (std::size_t k = 0; k < 3; ++k) n[k] = turn * next[k];
      if ((dot(n, here.gradient) > 0) != (first > 0)) return (i - 0.5) / 64;
    }
    return 0.5;
  }
  bool is_kept(const Vec& place) const {
    const PointFields here = fields_.at(place);
    const Vec n = eigen(here.tensor).vectors[0];
    return (!c_.data.has_min_value || here.l >= c_.data.min_value) &&
           (c_.data.min_strength == 0 || dot(n, image(here.hessian, n)) >= c_.data.min_strength);
  }
  /// Makes the pieces.
  void cut() {
    const bool cuts = c_.data.has_min_value || c_.data.min_strength > 0;
    for (u32 i = 0; i < c_.vertices.size(); ++i) {
      Vec place = fields_.place(vertex_cells_[i]);
      for (unsigned k = 0; k < d_; ++k) place[k] += c_.vertices[i][k] / 65536.0;
      kept_[{1, i, 0}] = !cuts || is_kept(place);
    }
    std::map<std::tuple<u32, u32, u32>, u32> seams;  // edge, cells -> group
    for (u32 i = 0; i < groups_.size(); ++i)
      for (const u32 edge : groups_[i].polygons)
        seams[{edge, groups_[i].cells[0], groups_[i].cells[1]}] = i;
    for (const u32 edge : polygons_) {
      const Key fan{2, edge, 0};
      Vec place = fields_.place(edge / d_);
      auto point = static_cast<std::uint16_t>(zero(edge) * 65536);
      if (cuts && stated_ != nullptr) point = stated_->fan_points.at(c_.fan_points.size());
      place[edge % d_] += point / 65536.0;
      if (cuts) c_.fan_points.push_back(point);
      kept_[fan] = !cuts || is_kept(place);
      const auto cells = cells_round(edge);
      for (u32 i = 0; i < cells.size(); ++i) {
        const u32 next = cells[(i + 1) % cells.size()];
        const Key a = corner(edge, cells[i]), spoke{3, edge, i};
        if (d_ == 2) {
          clip({{fan, a}, {spoke}}, edge, i);
          continue;
        }
        const u32 seam = seams.at({edge, std::min(cells[i], next), std::max(cells[i], next)});
        clip({{fan, a, corner(edge, next)}, {spoke, {4, seam, 0}, {3, edge, (i + 1) % 4}}}, edge,
             i);
      }
    }
  }
  void clip(const Piece& whole, u32 edge, u32 number) {
    Piece piece;
    const std::size_t n = whole.nodes.size();
    for (std::size_t i = 0; i < whole.sides.size(); ++i) {
      const Key &a = whole.nodes[i], &b = whole.nodes[(i + 1) % n], &side = whole.sides[i];
      const Key middle{
          5, std::get<0>(side) == 3 ? 4 * std::get<1>(side) + std::get<2>(side) : std::get<1>(side),
          static_cast<u32>(std::get<0>(side))};
      if (kept(a)) {
        piece.nodes.push_back(a);
        piece.sides.push_back(side);
        if (!kept(b)) {
          piece.nodes.push_back(middle);
          piece.sides.push_back({6, edge, number});
          ++cuts_;
        }
      } else if (kept(b)) {
        piece.nodes.push_back(middle);
        piece.sides.push_back(side);
        if (d_ == 2) ++cuts_;
      }
    }
    if (d_ == 2) {
      if (piece.nodes.empty()) return;
      piece.sides.resize(1);
      if (piece.nodes.size() == 1) piece.nodes.push_back(whole.nodes[1]);
    }
    if (!piece.nodes.empty()) pieces_.push_back({piece, edge});
  }
};

/// Theorem 15, read once more.
class ClusterFinder : public PieceMaker {
 public:
  using PieceMaker::PieceMaker;

 protected:
  void find_isotopic(const std::set<u32>& polygons, ExtremalComponent& out) const {
    if (c_.data.hessian || out.cut) return;
    for (const Group& group : groups_)
      if (polygons.contains(group.polygons[0]) && group.polygons.size() != 2) return;
    std::set<u32> cluster;
    for (const u32 edge : polygons)
      for (const u32 cell : cells_round(edge)) {
        cluster.insert(cell);
        for (unsigned k = 0; k < d_; ++k) {
          const auto place = c_.vertices[vertex_.at({edge, cell})][k];
          if (place < 1024 || place > 64512) return;
        }
      }
    std::vector<u32> waiting(cluster.begin(), cluster.end());
    bool extremal = true;
    while (!waiting.empty()) {
      const u32 cell = waiting.back();
      waiting.pop_back();
      if (code_[cell] != code::kRegular && code_[cell] != code::kRegularExtremal) return;
      extremal = extremal && code_[cell] == code::kRegularExtremal;
      if (!has_one_sheet(cell) || !is_boxed(fields_, cell, direction_.at(cell))) return;
      for (u32 i = 0; i < (d_ == 3 ? 27U : 9U); ++i) {
        const std::array<u32, 3> step = {i % 3, i / 3 % 3, i / 9};
        u32 other = cell;
        for (unsigned k = 0; k < d_; ++k) {
          const u32 here = at(cell, k) + step[k];
          if (here == 0 || here >= c_.data.nodes[k]) return;  // beyond the grid
          other += (step[k] - 1) * stride(k);
        }
        if (code_[other] != code::kEmpty && cluster.insert(other).second) waiting.push_back(other);
      }
    }
    out.isotopic = true;
    out.extremal = extremal;
  }
  bool has_one_sheet(u32 cell) const {
    Classes classes;
    for (const Square& square : squares_) {
      bool own = d_ == 2 && square.id == cell;
      for (unsigned k = 0; k < d_ && d_ == 3; ++k)
        own = own || square.id == 3 * cell + k || square.id == 3 * (cell + stride(k)) + k;
      if (!own) continue;
      std::vector<u32> critical;
      for (const u32 edge : square.edges)
        if (states_[edge] >= 2) critical.push_back(edge);
      if (critical.size() == 4) return false;
      for (const u32 edge : critical) classes.join({0, critical[0], 0}, {0, edge, 0});
    }
    int sheets = 0;
    for (const auto& [edge, to] : classes.parent) sheets += edge == to;
    return sheets <= 1;
  }
};

class MeshCounter : public ClusterFinder {
 public:
  using ClusterFinder::ClusterFinder;

  void count() {
    for (u32 edge = 0; edge < states_.size(); ++edge)
      if (states_[edge] == 3 && inside(edge)) polygons_.push_back(edge);
    make_groups();
    make_vertices();
    cut();
    count_valences();
    count_components();
  }

 private:
  void count_valences() {
    for (const Group& group : groups_) {
      bool some = false;
      for (const u32 cell : std::set<u32>(group.cells.begin(), group.cells.begin() + 2))
        some = some || kept(corner(group.polygons[0], cell));
      if (!some) continue;
      if (group.polygons.size() == 1) ++c_.valences.one[group.reason - 1];
      if (group.polygons.size() == 2) ++c_.valences.two;
      if (group.polygons.size() == 3) ++c_.valences.three;
    }
    c_.valences.one[2] += cuts_;
  }

  /// Lowest polygon, lowest kept corner of it.
  using Order = std::pair<u32, Key>;

  void count_components() {
    Classes classes;
    for (const auto& [piece, edge] : pieces_)
      for (const Key& node : piece.nodes) classes.join(piece.nodes[0], node);
    std::map<Key, Order> first;
    for (const auto& [piece, edge] : pieces_)
      for (const Key& node : piece.nodes) {
        if (std::get<0>(node) == 5) continue;  // a cut
        const Key of = classes.find(node);
        const Order order{edge, node};
        const auto at = first.try_emplace(of, order).first;
        at->second = std::min(at->second, order);
      }
    std::vector<std::pair<Order, Key>> order;
    for (const auto& [of, where] : first) order.push_back({where, of});
    std::ranges::sort(order);
    for (const auto& [where, of] : order) {
      std::vector<std::pair<Piece, u32>> own;
      for (const auto& each : pieces_)
        if (classes.find(each.first.nodes[0]) == of) own.push_back(each);
      c_.components.push_back(count_component(own));
    }
  }

  ExtremalComponent count_component(const std::vector<std::pair<Piece, u32>>& pieces) const {
    ExtremalComponent out;
    std::set<u32> polygons;
    std::set<Key> nodes;
    std::map<Key, std::vector<std::pair<Key, std::size_t>>> sides;  // from which node, which piece
    std::map<Key, std::pair<Key, Key>> ends;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = pieces[i].first;
      polygons.insert(pieces[i].second);
      nodes.insert(piece.nodes.begin(), piece.nodes.end());
      for (std::size_t k = 0; k < piece.sides.size(); ++k) {
        sides[piece.sides[k]].push_back({piece.nodes[k], i});
        ends[piece.sides[k]] = {piece.nodes[k], piece.nodes[(k + 1) % piece.nodes.size()]};
      }
    }
    out.polygons = static_cast<u32>(polygons.size());
    out.euler_characteristic = static_cast<std::int32_t>(nodes.size()) -
                               static_cast<std::int32_t>(sides.size()) +
                               (d_ == 3 ? static_cast<std::int32_t>(pieces.size()) : 0);
    Classes boundary;
    std::map<Key, int> degree;
    for (const auto& [side, uses] : sides) {
      ++degree[ends[side].first];
      ++degree[ends[side].second];
      if (uses.size() == 1) boundary.join(ends[side].first, ends[side].second);
    }
    for (const auto& [node, to] : boundary.parent) out.loops += node == to;
    if (d_ == 2)
      out.loops = static_cast<u32>(
          std::ranges::count_if(degree, [](const auto& each) { return each.second == 1; }));
    out.orientable = d_ == 2 || is_orientable(pieces, sides);
    for (const u32 edge : polygons) {
      out.cut |= !kept({2, edge, 0});
      for (const u32 cell : cells_round(edge)) out.cut |= !kept(corner(edge, cell));
    }
    find_isotopic(polygons, out);
    return out;
  }
  static bool is_orientable(const std::vector<std::pair<Piece, u32>>& pieces,
                            const std::map<Key, std::vector<std::pair<Key, std::size_t>>>& sides) {
    std::vector<int> turn(pieces.size(), 0);
    for (std::size_t seed = 0; seed < pieces.size(); ++seed) {
      if (turn[seed] != 0) continue;
      std::vector<std::size_t> waiting{seed};
      turn[seed] = 1;
      while (!waiting.empty()) {
        const std::size_t i = waiting.back();
        waiting.pop_back();
        for (const Key& side : pieces[i].first.sides) {
          const auto& uses = sides.at(side);
          if (uses.size() != 2) continue;
          const auto& own = uses[0].second == i ? uses[0] : uses[1];
          const auto& other = uses[0].second == i ? uses[1] : uses[0];
          const int wanted = own.first == other.first ? -turn[i] : turn[i];
          if (turn[other.second] == 0) {
            turn[other.second] = wanted;
            waiting.push_back(other.second);
          } else if (turn[other.second] != wanted) {
            return false;
          }
        }
      }
    }
    return true;
  }
};

}  // namespace

void count_mesh(ExtremalCertificate& c, const ReferenceFields& fields,
                const std::vector<std::uint8_t>& edge_states, const ExtremalCertificate* stated) {
  MeshCounter(c, fields, edge_states, stated).count();
}

}  // namespace crest::tests
