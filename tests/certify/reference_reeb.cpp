// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/reference_reeb.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace crest::tests {
namespace {

using u32 = std::uint32_t;
using Rational = kernel::Rational;
using Corners = ReferenceReeb::Corners;
using Weights = std::array<Rational, 3>;
constexpr u32 kNone = 0xffffffffU;

struct Groups {
  explicit Groups(std::size_t n) : parent(n), count(n) {
    std::iota(parent.begin(), parent.end(), std::size_t{0});
  }
  std::size_t find(std::size_t x) { return parent[x] == x ? x : parent[x] = find(parent[x]); }
  bool join(std::size_t a, std::size_t b) {
    a = find(a), b = find(b);
    if (a == b) return false;
    parent[a] = b;
    --count;
    return true;
  }
  std::vector<std::size_t> parent;
  std::size_t count;
};

/// A quadratic function in barycentric coordinates by Lagrange's basis: f at the corners, m at
/// the middles of 01, 12, 20. Derivatives in directions whose components sum to 0.
struct FaceFunction {
  std::array<Rational, 6> v;  ///< f0, f1, f2, m01, m12, m20
  static constexpr std::size_t kPair[3][2] = {{0, 1}, {1, 2}, {2, 0}};

  Rational value(const Weights& x) const {
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += v[i] * x[i] * (2 * x[i] - 1);
    for (std::size_t k = 0; k < 3; ++k) sum += 4 * v[3 + k] * x[kPair[k][0]] * x[kPair[k][1]];
    return sum;
  }
  Rational slope(const Weights& x, const Weights& d) const {
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += v[i] * (4 * x[i] - 1) * d[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [i, j] = kPair[k];
      sum += 4 * v[3 + k] * (x[i] * d[j] + x[j] * d[i]);
    }
    return sum;
  }
  Rational second(const Weights& d, const Weights& e) const {
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += 4 * v[i] * d[i] * e[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [i, j] = kPair[k];
      sum += 4 * v[3 + k] * (d[i] * e[j] + d[j] * e[i]);
    }
    return sum;
  }
  Rational hessian() const {
    const Weights p = {-1, 1, 0}, q = {-1, 0, 1};
    return second(p, p) * second(q, q) - second(p, q) * second(p, q);
  }
  /// The slopes in two directions are affine: x is orthogonal to both rows of corner values.
  std::optional<Weights> critical_point() const {
    if (hessian() == 0) return std::nullopt;
    const Weights p = {-1, 1, 0}, q = {-1, 0, 1};
    Weights a, b, x;
    for (std::size_t i = 0; i < 3; ++i) {
      Weights corner = {0, 0, 0};
      corner[i] = 1;
      a[i] = slope(corner, p), b[i] = slope(corner, q);
    }
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    const Rational sum = x[0] + x[1] + x[2];
    for (auto& w : x) w /= sum;
    return x;
  }
};

int sign(const Rational& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}
std::array<u32, 2> sorted_pair(u32 a, u32 b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

ReferenceReeb::ReferenceReeb(const certify::ReebCertificate& data)
    : faces_(data.faces), data_(data) {
  valid_ = check_requirements();
  if (!valid_) return;
  find_nodes();
  find_tiles();
  sort_nodes();
  find_types();
  sweep();
}

bool ReferenceReeb::check_requirements() {
  const std::size_t vertices = data_.values.size();
  if (vertices < 3 || faces_.empty()) return false;
  std::set<Corners> known;
  std::map<std::array<u32, 2>, int> sides;
  std::vector<std::vector<std::array<u32, 2>>> links(vertices);
  for (Corners f : faces_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const u32 a = f[i], b = f[(i + 1) % 3], c = f[(i + 2) % 3];
      if (a >= vertices || b >= vertices || c >= vertices || a == b) return false;
      ++sides[sorted_pair(a, b)];
      links[a].push_back({b, c});
    }
    std::sort(f.begin(), f.end());
    if (!known.insert(f).second) return false;
  }
  Groups all(vertices), loops(vertices);
  std::set<u32> boundary;
  for (const auto& [pair, count] : sides) {
    if (count > 2) return false;
    mesh_edges_.push_back(pair);
    all.join(pair[0], pair[1]);
    if (count == 1) {
      loops.join(pair[0], pair[1]);
      boundary.insert({pair[0], pair[1]});
    }
  }
  for (const auto& link : links) {
    std::map<u32, int> degree;
    Groups parts(vertices);
    for (const auto& [a, b] : link) ++degree[a], ++degree[b], parts.join(a, b);
    if (link.empty() || vertices - parts.count + 1 != degree.size()) return false;
    for (const auto& [w, d] : degree)
      if (d > 2) return false;
  }
  components_ = static_cast<u32>(all.count);
  std::set<std::size_t> roots;
  for (const u32 v : boundary) roots.insert(loops.find(v));
  boundary_loops_ = static_cast<u32>(roots.size());
  return data_.edge_values.empty() || data_.edge_values.size() == mesh_edges_.size();
}

u32 ReferenceReeb::edge(u32 a, u32 b) const {
  const auto at = std::lower_bound(mesh_edges_.begin(), mesh_edges_.end(), sorted_pair(a, b));
  return static_cast<u32>(at - mesh_edges_.begin());
}

Rational ReferenceReeb::on_edge(std::size_t e, const Rational& t) const {
  const Rational a = data_.values[mesh_edges_[e][0]], b = data_.values[mesh_edges_[e][1]],
                 m = data_.edge_values[e];
  return a * (1 - t) * (1 - 2 * t) + b * t * (2 * t - 1) + 4 * m * t * (1 - t);
}

std::array<Rational, 6> ReferenceReeb::nodal(std::size_t f) const {
  std::array<Rational, 6> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = data_.values[faces_[f][i]];
    v[3 + i] = data_.edge_values[edge(faces_[f][i], faces_[f][(i + 1) % 3])];
  }
  return v;
}

void ReferenceReeb::find_nodes() {
  for (const double x : data_.values) value_.emplace_back(x);
  line_position_.resize(mesh_edges_.size());
  line_node_.assign(mesh_edges_.size(), kNone);
  face_node_.assign(faces_.size(), kNone);
  if (data_.edge_values.empty()) return;
  for (std::size_t e = 0; e < mesh_edges_.size(); ++e) {
    const Rational a = data_.values[mesh_edges_[e][0]], b = data_.values[mesh_edges_[e][1]],
                   m = data_.edge_values[e];
    if (a + b == 2 * m) continue;
    const Rational t = (3 * a + b - 4 * m) / (4 * (a + b - 2 * m));
    if (t <= 0 || t >= 1) continue;
    line_position_[e] = t;
    line_node_[e] = static_cast<u32>(value_.size());
    value_.push_back(on_edge(e, t));
    ++line_count_;
  }
  std::map<Corners, std::size_t> by_corners;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Corners c = faces_[f];
    std::sort(c.begin(), c.end());
    by_corners[c] = f;
  }
  for (const auto& [c, f] : by_corners) {
    const FaceFunction function{nodal(f)};
    const auto x = function.critical_point();
    if (!x || (*x)[0] <= 0 || (*x)[1] <= 0 || (*x)[2] <= 0) continue;
    face_node_[f] = static_cast<u32>(value_.size());
    value_.push_back(function.value(*x));
    ++face_count_;
  }
}

/// By the definition: the derivative towards the opposite corner against the second one along.
bool ReferenceReeb::is_saddle(std::size_t f, std::size_t side) const {
  const FaceFunction function{nodal(f)};
  const std::size_t i = side, j = (side + 1) % 3, k = (side + 2) % 3;
  const u32 e = edge(faces_[f][i], faces_[f][j]);
  const Rational& t = *line_position_[e];
  Weights x = {0, 0, 0}, inward, along = {0, 0, 0};
  const bool same = faces_[f][i] == mesh_edges_[e][0];
  x[i] = same ? Rational(1 - t) : t;
  x[j] = 1 - x[i];
  for (std::size_t n = 0; n < 3; ++n) inward[n] = (n == k ? 1 : 0) - x[n];
  along[i] = -1, along[j] = 1;
  const int across = sign(function.slope(x, inward));
  return across == 0 ? function.hessian() < 0 : across == -sign(function.second(along, along));
}

void ReferenceReeb::cut_face(const Corners& face, const std::array<u32, 3>& line, std::size_t f) {
  const auto count = 3 - std::count(line.begin(), line.end(), kNone);
  if (count == 0) {
    tiles_.push_back(face);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const u32 a = face[i], b = face[j], c = face[k];
    if (count == 3) tiles_.push_back({a, line[i], line[k]});
    if (count == 1 && line[i] != kNone) {
      tiles_.push_back({a, line[i], c});
      tiles_.push_back({line[i], b, c});
    }
    if (count != 2 || line[i] != kNone) continue;
    const u32 e = line[k], other = line[j];  // on c a and on b c
    tiles_.push_back({c, e, other});
    const bool diagonal_b = is_saddle(f, k) || (!is_saddle(f, j) && b < a);
    if (diagonal_b) {
      tiles_.push_back({a, b, e});
      tiles_.push_back({b, other, e});
    } else {
      tiles_.push_back({a, b, other});
      tiles_.push_back({a, other, e});
    }
  }
  if (count == 3) tiles_.push_back(line);
}

void ReferenceReeb::find_tiles() {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::array<u32, 3> line;
    std::vector<u32> around;
    for (std::size_t i = 0; i < 3; ++i) {
      line[i] = line_node_[edge(faces_[f][i], faces_[f][(i + 1) % 3])];
      around.push_back(faces_[f][i]);
      if (line[i] != kNone) around.push_back(line[i]);
    }
    if (face_node_[f] == kNone) {
      cut_face(faces_[f], line, f);
      continue;
    }
    for (std::size_t i = 0; i < around.size(); ++i)
      tiles_.push_back({face_node_[f], around[i], around[(i + 1) % around.size()]});
  }
}

void ReferenceReeb::sort_nodes() {
  order_.resize(value_.size());
  std::iota(order_.begin(), order_.end(), u32{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](u32 a, u32 b) { return value_[a] < value_[b]; });
  rank_.resize(order_.size());
  for (u32 i = 0; i < order_.size(); ++i) rank_[order_[i]] = i;
}

/// Runs are the components of the lower and of the upper part of the link.
void ReferenceReeb::find_types() {
  for (const u32 v : order_) {
    std::set<u32> lower, upper;
    Groups groups(order_.size());
    std::int64_t lower_edges = 0;
    for (const Corners& t : tiles_)
      for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] != v) continue;
        const u32 a = t[(i + 1) % 3], b = t[(i + 2) % 3];
        const bool a_low = rank_[a] < rank_[v], b_low = rank_[b] < rank_[v];
        (a_low ? lower : upper).insert(a);
        (b_low ? lower : upper).insert(b);
        if (a_low == b_low) groups.join(a, b);
        lower_edges += a_low && b_low;
      }
    const auto runs = [&](const std::set<u32>& part) {
      std::set<std::size_t> roots;
      for (const u32 w : part) roots.insert(groups.find(w));
      return static_cast<u32>(roots.size());
    };
    const u32 l = runs(lower), u = runs(upper);
    if (l == 1 && u == 1) continue;
    critical_.push_back(v);
    index_.push_back(1 - static_cast<std::int64_t>(lower.size()) + lower_edges);
    multiplicity_.push_back(l == 0 || u == 0 ? 0 : std::max(l, u) - 1);
    minima_ += l == 0;
    maxima_ += u == 0;
    saddles_ += multiplicity_.back();
  }
}

std::int64_t ReferenceReeb::loops() const {
  return std::int64_t{components_} + static_cast<std::int64_t>(arcs_.size()) -
         static_cast<std::int64_t>(critical_.size());
}

/// The contours between all successive nodes; each has the arc it belongs to.
void ReferenceReeb::sweep() {
  std::map<std::array<u32, 2>, u32> numbers;
  std::vector<std::array<u32, 2>> edges;  // by rank
  std::vector<int> uses;
  std::vector<std::array<u32, 3>> sides;
  for (const Corners& t : tiles_) {
    sides.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto pair = sorted_pair(rank_[t[i]], rank_[t[(i + 1) % 3]]);
      const auto [entry, fresh] = numbers.emplace(pair, static_cast<u32>(edges.size()));
      if (fresh) edges.push_back(pair), uses.push_back(0);
      ++uses[entry->second];
      sides.back()[i] = entry->second;
    }
  }
  struct Open {
    u32 lower, node;
    bool cycle;
    u32 upper;
  };
  std::vector<Open> open;
  std::vector<u32> arc(edges.size(), kNone);
  for (u32 level = 0; level < order_.size(); ++level) {
    const auto crossed = [&](u32 e) { return edges[e][0] <= level && level < edges[e][1]; };
    const auto at = std::find(critical_.begin(), critical_.end(), order_[level]);
    const bool critical = at != critical_.end();
    const u32 position = static_cast<u32>(at - critical_.begin());
    u32 below = kNone;
    for (u32 e = 0; e < edges.size(); ++e)
      if (edges[e][1] == level) {
        below = arc[e];
        if (critical) open[arc[e]].upper = position;
      }
    Groups contours(edges.size());
    for (const auto& side : sides)
      for (std::size_t i = 0; i < 3; ++i)
        if (crossed(side[i]) && crossed(side[(i + 1) % 3]))
          contours.join(side[i], side[(i + 1) % 3]);
    std::map<std::size_t, std::vector<u32>> members;
    for (u32 e = 0; e < edges.size(); ++e)
      if (crossed(e)) members[contours.find(e)].push_back(e);
    for (const auto& [root, list] : members) {
      u32 number = kNone, node = kNone;
      bool cycle = true;
      for (const u32 e : list) {
        cycle = cycle && uses[e] == 2;
        if (edges[e][0] == level) node = std::min(node, order_[edges[e][1]]);
      }
      if (node == kNone)
        number = arc[list.front()];
      else if (!critical)
        number = below;
      else {
        number = static_cast<u32>(open.size());
        open.push_back({position, node, cycle, kNone});
      }
      for (const u32 e : list) arc[e] = number;
    }
  }
  for (const Open& o : open) arcs_.push_back({o.lower, o.upper, o.node, o.cycle});
  std::sort(arcs_.begin(), arcs_.end());
}

std::vector<bool> ReferenceReeb::choose_cuts(Random& random, double extra) const {
  std::vector<bool> cut(arcs_.size(), false);
  std::vector<std::size_t> shuffled(arcs_.size());
  std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  Groups tree(critical_.size());
  for (const std::size_t a : shuffled)
    cut[a] = !tree.join(arcs_[a].lower, arcs_[a].upper) || uniform(random) < 2 * extra - 1;
  while (true) {
    Groups parts(critical_.size());
    std::vector<std::int64_t> euler(critical_.size(), 0), saddles(critical_.size(), 0);
    for (std::size_t a = 0; a < arcs_.size(); ++a)
      if (!cut[a]) parts.join(arcs_[a].lower, arcs_[a].upper);
    for (std::size_t i = 0; i < critical_.size(); ++i) {
      euler[parts.find(i)] += index_[i];
      saddles[parts.find(i)] += multiplicity_[i] > 0;
    }
    for (std::size_t a = 0; a < arcs_.size(); ++a)
      if (cut[a]) {
        euler[parts.find(arcs_[a].lower)] += arcs_[a].cycle;
        euler[parts.find(arcs_[a].upper)] += 1;
      }
    const auto bad = [&](std::size_t a) {
      const std::size_t part = parts.find(arcs_[a].lower);
      return !cut[a] && euler[part] < 1 && saddles[part] > 1;
    };
    const auto next = std::find_if(shuffled.begin(), shuffled.end(), bad);
    if (next == shuffled.end()) return cut;
    cut[*next] = true;
  }
}

certify::ReebCertificate ReferenceReeb::certificate(Random& random, double extra) const {
  certify::ReebCertificate c = data_;
  c.euler_characteristic =
      static_cast<std::int32_t>(static_cast<std::int64_t>(data_.values.size() + faces_.size()) -
                                static_cast<std::int64_t>(mesh_edges_.size()));
  c.boundary_loops = boundary_loops_;
  c.components = components_;
  c.line_critical = line_count_;
  c.face_critical = face_count_;
  c.tiles = static_cast<u32>(tiles_.size());
  c.minima = minima_, c.saddles = saddles_, c.maxima = maxima_;
  c.order = order_;
  c.critical_nodes = critical_;
  c.arcs.clear();
  c.cuts.clear();
  const auto cut = choose_cuts(random, extra);
  for (u32 a = 0; a < arcs_.size(); ++a) {
    c.arcs.push_back({arcs_[a].lower, arcs_[a].upper});
    if (cut[a]) c.cuts.push_back({a, arcs_[a].node});
  }
  Groups classes(critical_.size());
  c.tied_arcs = 0;
  for (const Arc& arc : arcs_) {
    if (value_[critical_[arc.lower]] != value_[critical_[arc.upper]]) continue;
    classes.join(arc.lower, arc.upper);
    ++c.tied_arcs;
  }
  c.contracted_nodes = static_cast<u32>(classes.count);
  return c;
}

bool ReferenceReeb::is_true(const certify::ReebCertificate& claim) {
  const ReferenceReeb truth(claim);
  if (!truth.valid()) return false;
  Random random(1);
  certify::ReebCertificate stated = truth.certificate(random);
  for (const auto& cut : claim.cuts) {
    const auto& arc = claim.arcs.at(cut.arc);
    const auto is_it = [&](const Arc& a) {
      return a.lower == arc.lower && a.upper == arc.upper && a.node == cut.node;
    };
    if (std::none_of(truth.arcs_.begin(), truth.arcs_.end(), is_it)) return false;
  }
  stated.cuts = claim.cuts;
  return certify::encode(stated) == certify::encode(claim);
}

}  // namespace crest::tests
