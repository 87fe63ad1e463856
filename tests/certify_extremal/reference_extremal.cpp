// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_extremal/reference_extremal.hpp"

#include <algorithm>
#include <cmath>

namespace crest::tests {
namespace {

using namespace certify;
namespace code = extremal_code;
using u32 = std::uint32_t;

ExtremalDirection quantised(const Vec& a) {
  const double most = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  ExtremalDirection out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = static_cast<std::int16_t>(std::lround(a[k] / most * 16384));
  return out;
}
Vec direction(const ExtremalDirection& w) {
  return unit({static_cast<double>(w[0]), static_cast<double>(w[1]), static_cast<double>(w[2])});
}
Vec minus(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec times(double s, const Vec& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
double length(const Vec& a) {
  return std::sqrt(dot(a, a));
}
double norm(const Sym& m) {
  return std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
}
Vec across(const Vec& a, const Vec& w) {
  return minus(a, times(dot(a, w), w));
}

/// The cone test over matrices: gap and angle.
struct Cone {
  double gap = HUGE_VAL, b = 0;
  double angle() const { return 0.5 * std::atan(2 * b / gap); }
};
void add(Cone& cone, const Sym& t, const Vec& w) {
  const std::size_t least = std::fabs(w[0]) < 0.6 ? 0 : 1;
  Vec axis{};
  axis[least] = 1;
  const Vec u = unit(across(axis, w));
  const Vec v{w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]};
  const double uu = dot(u, image(t, u)), vv = dot(v, image(t, v)), uv = dot(u, image(t, v));
  const double mu = (uu + vv) / 2 + std::hypot((uu - vv) / 2, uv);
  cone.gap = std::min(cone.gap, dot(w, image(t, w)) - mu);
  cone.b = std::max(cone.b, length(across(image(t, w), w)));
}
bool holds(const Cone& cone, double scale) {
  return cone.gap > 1e-6 * scale;
}

/// Proves codes of cells.
class CellMaker {
 public:
  CellMaker(const ReferenceFields& fields, bool world_units)
      : fields_(fields), world_units_(world_units) {}

  void make(u32 cell, ExtremalCertificate& c) {
    Vec centre = fields_.place(cell);
    for (unsigned k = 0; k < fields_.data.dimension; ++k) centre[k] += 0.5;
    make(cell, quantised(eigen(fields_.at(centre).tensor).vectors[0]), c);
  }
  /// Is the cell regular, and does the box test hold?
  bool is_boxed(u32 cell, const ExtremalDirection& w) {
    ExtremalCertificate c;
    make(cell, w, c);
    return c.codes[0] >= code::kRegular && boxed_;
  }
  /// Of the cell that was asked last.
  const GradientBox& box() const { return box_; }

 private:
  void make(u32 cell, const ExtremalDirection& w16, ExtremalCertificate& c) {
    w_ = direction(w16);
    controls_ = fields_.controls(cell);
    Cone cone;
    double scale = 0;
    for (const PointFields& p : controls_) {
      add(cone, p.tensor, w_);
      scale = std::max(scale, norm(p.tensor));
    }
    if (!holds(cone, fields_.data.dimension == 2 ? 1e-9 * scale : scale))
      return c.codes.push_back(code::kOpen);
    c.directions.push_back(w16);
    angle_ = cone.angle();
    gap_ = cone.gap;
    c.codes.push_back(kind(cell, c));
  }
  std::uint8_t kind(u32 cell, ExtremalCertificate& c) {
    double low = HUGE_VAL, high = -HUGE_VAL, p = 0, h = 0, least_curvature = HUGE_VAL;
    Vec sum{}, rows{};
    const Vec d = world_units_ ? Vec{1, 1, 1} : fields_.data.spacing;
    std::vector<Vec> gradients;
    for (const PointFields& x : controls_) {
      low = std::min(low, dot(w_, x.gradient));
      high = std::max(high, dot(w_, x.gradient));
      p = std::max(p, length(across(x.gradient, w_)));
      least_curvature = std::min(least_curvature, dot(w_, image(x.hessian, w_)));
      Sym scaled = x.hessian;
      for (std::size_t k = 0; k < 3; ++k) scaled[k] = times(d[k], scaled[k]);
      h = std::max(h, norm(scaled));
      for (std::size_t k = 0; k < 3; ++k) rows[k] = std::max(rows[k], length(scaled[k]));
      gradients.push_back(image(scaled, w_));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += gradients.back()[k];
    }
    const double c1 = std::cos(angle_), s1 = std::sin(angle_), room = 1e-6 * (p + std::fabs(low));
    if (low * c1 > p * s1 + room || -high * c1 > p * s1 + room) return code::kEmpty;
    if (fields_.data.hessian || sum == Vec{}) return code::kCone;
    const auto a16 = quantised(sum);
    const Vec a = direction(a16);
    const double chord = 2 * std::sin(angle_ / 2),
                 aside = p + s1 * std::max(std::fabs(low), std::fabs(high));
    const Vec turns = turning(cell);
    const double e = chord * h + length(turns) * aside;
    Vec each;
    for (std::size_t k = 0; k < 3; ++k) each[k] = chord * rows[k] + turns[k] * aside;
    boxed_ = has_box(gradients, each);
    for (const Vec& g : gradients)
      if (!(dot(a, g) - length(across(g, a)) > std::sqrt(2) * e * (1 + 1e-6))) return code::kCone;
    c.gradients.push_back(a16);
    double most_h = 0;
    for (const PointFields& x : controls_) most_h = std::max(most_h, norm(x.hessian));
    return least_curvature > 2 * angle_ * most_h * (1 + 1e-6) ? code::kRegularExtremal
                                                              : code::kRegular;
  }
  bool has_box(const std::vector<Vec>& gradients, const Vec& e) {
    double sum = 0;
    for (unsigned k = 0; k < fields_.data.dimension; ++k) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Vec& g : gradients) {
        low = std::min(low, g[k]);
        high = std::max(high, g[k]);
      }
      box_.inner_low[k] = low;
      box_.inner_high[k] = high;
      box_.low[k] = low -= e[k];
      box_.high[k] = high += e[k];
      sum += low > 0 ? low * low : high < 0 ? high * high : low * high;
    }
    return sum > 0;
  }
  Vec turning(u32 cell) const {
    Vec speed{};
    for (unsigned k = 0; k < fields_.data.dimension; ++k) {
      std::array<int, 3> order{};
      order[k] = 1;
      std::vector<Sym> m(64, Sym{});
      for (unsigned i = 0; i < fields_.data.dimension; ++i)
        for (unsigned j = 0; j < fields_.data.dimension; ++j) {
          const auto net = fields_.t_controls(cell, i, j, order);
          for (std::size_t n = 0; n < 64; ++n) m[n][i][j] = net[n];
        }
      double side = 0, most = 0;
      for (const Sym& x : m) {
        side = std::max(side, length(across(image(x, w_), w_)));
        most = std::max(most, norm(x));
      }
      const double unit = world_units_ ? fields_.data.spacing[k] : 1;
      speed[k] = (side + 2 * angle_ * most) / (gap_ * unit);
    }
    return speed;
  }

  const ReferenceFields& fields_;
  bool world_units_;
  std::vector<PointFields> controls_;
  Vec w_{};
  double angle_ = 0, gap_ = 0;
  bool boxed_ = false;
  GradientBox box_{};
};

/// n in the direction nearer to another; zero if lambda1 is not simple.
Vec direction_of(const PointFields& here, const Vec& like) {
  const auto e = eigen(here.tensor);
  if (!(e.values[0] - e.values[1] > 1e-5 * std::fabs(e.values[0]))) return {};
  return dot(e.vectors[0], like) < 0 ? times(-1, e.vectors[0]) : e.vectors[0];
}

/// Along an edge: signs, types, trees.
class EdgeMaker {
 public:
  explicit EdgeMaker(const ReferenceFields& fields) : fields_(fields) {}

  /// Untested: 0; 1: no change of sign; 2 + type.
  std::uint8_t state(u32 node, unsigned axis) {
    constexpr int kSteps = 64;
    const auto net = fields_.edge(node, axis);
    Vec n = direction_of(net[0], {1, 1e-3, 1e-6});
    if (n == Vec{}) return 0;
    const int first = sign(net[0], n, true);
    int before = first, positive = 0, negative = 0;
    const auto note_curvature = [&](const PointFields& point) {
      const double curvature = dot(n, image(point.hessian, n));
      const double small = 1e-6 * norm(point.hessian) + 1e-12;
      positive += curvature > -small;
      negative += curvature < small;
    };
    if (sign(net[0], n, false) == 0) note_curvature(net[0]);
    for (int i = 1; i <= kSteps; ++i) {
      const PointFields point = on_edge(net, static_cast<double>(i) / kSteps);
      const Vec next = direction_of(point, n);
      if (next == Vec{} || std::fabs(dot(next, n)) < 0.9) return 0;
      n = next;
      const int here = sign(point, n, i == kSteps);
      if (here != before || sign(point, n, false) == 0) note_curvature(point);
      if (here != 0) before = here;
    }
    if (before == first) return 1;
    return positive > 0 && negative > 0 ? 4 : positive > 0 ? 3 : 2;
  }

  /// Appends the edge's tree; false: none was found.
  bool make_tree(u32 node, unsigned axis, ExtremalCertificate& c) {
    const auto edge = fields_.edge(node, axis);
    const std::array<Sym, 4> net = {edge[0].tensor, edge[1].tensor, edge[2].tensor, edge[3].tensor};
    const std::size_t trees = c.trees.size(), leaves = c.leaves.size();
    if (divide(net, 0, c)) return true;
    c.trees.resize(trees);
    c.leaves.resize(leaves);
    return false;
  }

 private:
  /// Of g; at nodes of the perturbed one.
  static int sign(const PointFields& point, const Vec& n, bool node) {
    const Vec& v = point.gradient;
    const double g = dot(n, v);
    if (std::fabs(g) > 1e-9 * (length(v) + 1e-3)) return g > 0 ? 1 : -1;
    if (!node) return 0;
    for (const double x : n)
      if (std::fabs(x) > 1e-9) return x > 0 ? 1 : -1;
    return 0;
  }
  bool divide(const std::array<Sym, 4>& net, unsigned depth, ExtremalCertificate& c) {
    const auto first = eigen(net[0]), last = eigen(net[3]);
    Vec w = first.vectors[0];
    const double turn = dot(w, last.vectors[0]) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) w[k] += turn * last.vectors[0][k];
    const auto w16 = quantised(w);
    Cone cone;
    double scale = 0;
    for (const Sym& t : net) {
      add(cone, t, direction(w16));
      scale = std::max(scale, norm(t));
    }
    if (holds(cone, fields_.data.dimension == 2 ? 1e-9 * scale : scale)) {
      c.trees.push_back(code::kLeaf);
      c.leaves.push_back(w16);
      return true;
    }
    if (depth == 14) return false;
    c.trees.push_back(code::kSplit);
    std::array<Sym, 4> low, high;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        std::array<double, 4> row;
        for (std::size_t k = 0; k < 4; ++k) row[k] = net[k][i][j];
        for (std::size_t k = 0; k < 4; ++k) {
          low[k][i][j] = row[0];
          high[3 - k][i][j] = row[3 - k];
          for (std::size_t m = 0; m + 1 + k < 4; ++m) row[m] = (row[m] + row[m + 1]) / 2;
        }
      }
    return divide(low, depth + 1, c) && divide(high, depth + 1, c);
  }

  const ReferenceFields& fields_;
};

/// 1: of a proven cell, 2: of open ones only.
std::vector<std::uint8_t> edges_of_cells(const ExtremalCertificate& c) {
  const unsigned d = c.data.dimension;
  const std::array<u32, 3> stride = {1, c.data.nodes[0], c.data.nodes[0] * c.data.nodes[1]};
  std::vector<std::uint8_t> out(std::size_t{d} * stride[2] * c.data.nodes[2], 0);
  std::size_t at = 0;
  for (const CellRun& run : c.cells)
    for (u32 cell = run.first; cell < run.first + run.length; ++cell, ++at)
      for (u32 i = 0; i < (1U << d); ++i)
        for (unsigned axis = 0; axis < d; ++axis) {
          if ((i >> axis & 1U) != 0) continue;
          u32 node = cell;
          for (unsigned k = 0; k < d; ++k) node += (i >> k & 1U) * stride[k];
          auto& mark = out[d * node + axis];
          if (c.codes[at] != code::kOpen)
            mark = 1;
          else if (mark == 0)
            mark = 2;
        }
  return out;
}

class Maker {
 public:
  Maker(const ExtremalData& data, const ReferenceOptions& options)
      : fields_(data), options_(options), d_(data.dimension) {
    c_.data = data;
  }

  ExtremalCertificate make() {
    list_cells();
    make_edges();
    count_mesh(c_, fields_, states_);
    return std::move(c_);
  }

 private:
  bool is_cell(u32 node) const {
    const Vec p = fields_.place(node);
    for (unsigned k = 0; k < d_; ++k)
      if (p[k] + 1 >= c_.data.nodes[k]) return false;
    return true;
  }
  u32 stride(unsigned k) const {
    return k == 0 ? 1 : k == 1 ? c_.data.nodes[0] : c_.data.nodes[0] * c_.data.nodes[1];
  }

  /// Cells where L may reach the least value, and all round them.
  void list_cells() {
    std::vector<std::uint8_t> wanted(fields_.nodes, 0), listed(fields_.nodes, 0);
    for (u32 cell = 0; cell < fields_.nodes; ++cell) {
      if (!is_cell(cell)) continue;
      for (const double l : fields_.l_controls(cell, {0, 0, 0}))
        if (!c_.data.has_min_value || l >= c_.data.min_value - 1e-6) wanted[cell] = 1;
    }
    for (u32 cell = 0; cell < fields_.nodes; ++cell) {
      if (!is_cell(cell)) continue;
      const Vec p = fields_.place(cell);
      for (u32 i = 0; i < 125; ++i) {
        const std::array<long, 3> step = {i % 5 - 2L, i / 5 % 5 - 2L, i / 25 - 2L};
        u32 other = 0;
        bool inside = true;
        for (unsigned k = 0; k < 3; ++k) {
          const long at = static_cast<long>(p[k]) + step[k];
          inside = inside && at >= 0 && at < static_cast<long>(c_.data.nodes[k]);
          other += static_cast<u32>(at) * stride(k);
        }
        if (inside && wanted[other] != 0) listed[cell] = 1;
      }
    }
    CellMaker maker(fields_, options_.world_units);
    for (u32 cell = 0; cell < fields_.nodes; ++cell) {
      if (listed[cell] == 0) continue;
      if (!c_.cells.empty() && c_.cells.back().first + c_.cells.back().length == cell)
        ++c_.cells.back().length;
      else
        c_.cells.push_back({cell, 1});
      if (options_.no_cells)
        c_.codes.push_back(code::kOpen);
      else
        maker.make(cell, c_);
    }
  }

  void make_edges() {
    const auto of_cell = edges_of_cells(c_);
    EdgeMaker maker(fields_);
    states_.assign(of_cell.size(), 0);
    for (u32 edge = 0; edge < of_cell.size(); ++edge) {
      if (of_cell[edge] == 0) continue;
      const std::uint8_t state = maker.state(edge / d_, edge % d_);
      if (of_cell[edge] == 2) {
        if (state == 0 || !maker.make_tree(edge / d_, edge % d_, c_)) continue;
        c_.edges.push_back(edge);
      }
      states_[edge] = std::max<std::uint8_t>(state, 1);
      if (state >= 2) c_.types.push_back(static_cast<std::uint8_t>(state - 2));
    }
  }

  ReferenceFields fields_;
  ReferenceOptions options_;
  unsigned d_;
  ExtremalCertificate c_;
  std::vector<std::uint8_t> states_;
};

}  // namespace

bool is_boxed(const ReferenceFields& fields, u32 cell, const ExtremalDirection& w) {
  return CellMaker(fields, false).is_boxed(cell, w);
}

GradientBox gradient_box(const ReferenceFields& fields, u32 cell, const ExtremalDirection& w) {
  CellMaker maker(fields, false);
  maker.is_boxed(cell, w);
  return maker.box();
}

ExtremalCertificate reference_of(const ExtremalCertificate& c) {
  const ReferenceFields fields(c.data);
  ExtremalCertificate out;
  out.data = c.data;
  out.cells = c.cells;
  out.codes = c.codes;
  out.directions = c.directions;
  const auto of_cell = edges_of_cells(c);
  std::vector<std::uint8_t> states(of_cell.size(), 0);
  EdgeMaker maker(fields);
  for (u32 edge = 0; edge < of_cell.size(); ++edge) {
    if (of_cell[edge] != 1 && !std::ranges::binary_search(c.edges, edge)) continue;
    const unsigned d = c.data.dimension;
    states[edge] = std::max<std::uint8_t>(maker.state(edge / d, edge % d), 1);
    if (states[edge] == 1) continue;
    const std::size_t i = out.types.size();
    const auto found = static_cast<std::uint8_t>(states[edge] - 2);
    out.types.push_back(found);
    if (i >= c.types.size()) continue;
    if (c.types[i] == code::kUndecidedType || found == code::kUndecidedType)
      states[edge] = static_cast<std::uint8_t>(c.types[i] + 2);
    else if (c.types[i] != found)
      out.odd_faces = ~0U;
  }
  if (out.types.size() != c.types.size()) out.odd_faces = ~0U;
  if (out.odd_faces == 0) count_mesh(out, fields, states, &c);
  return out;
}

bool code_holds(const ReferenceFields& fields, u32 cell, std::uint8_t stated,
                const ExtremalDirection& w) {
  if (stated == code::kOpen) return true;
  int sign = 0;
  for (u32 i = 0; i < 125; ++i) {
    const std::array<u32, 3> step = {i % 5, i / 5 % 5, i / 25};
    Vec place = fields.place(cell);
    for (unsigned k = 0; k < fields.data.dimension; ++k) place[k] += step[k] / 4.0;
    const PointFields here = fields.at(place);
    Vec n = eigen(here.tensor).vectors[0];
    const double along = dot(n, direction(w)), turn = along < 0 ? -1 : 1;
    for (double& x : n) x *= turn;
    const double g = dot(n, here.gradient);
    if (std::fabs(along) < 0.707) return false;
    if (stated == code::kEmpty && (g == 0 || (sign != 0 && (g > 0) != (sign > 0)))) return false;
    if (stated == code::kRegularExtremal && dot(n, image(here.hessian, n)) <= 0) return false;
    sign = g > 0 ? 1 : -1;
  }
  return true;
}

ExtremalCertificate reference_extremal(const ExtremalData& data, const ReferenceOptions& options) {
  return Maker(data, options).make();
}

}  // namespace crest::tests
