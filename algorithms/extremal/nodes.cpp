// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/nodes.hpp"

#include <algorithm>

#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/direction_sign.hpp"

namespace crest::extremal {
namespace {

/// The least and the largest of the 16 coefficients that a cell sees in slice k.
struct Window {
  std::vector<float> low, high;
};

void window(const Grid& g, const std::vector<float>& c, int k, Window& w, Window& rows) {
  const auto nx = static_cast<std::size_t>(g.size[0]), ny = static_cast<std::size_t>(g.size[1]);
  for (Window* x : {&w, &rows}) {
    x->low.resize(nx * ny);
    x->high.resize(nx * ny);
  }
  const float* slice = c.data() + static_cast<std::size_t>(k) * g.stride[2];
  for (std::size_t j = 0; j < ny; ++j) {
    const float *a = slice + (j > 0 ? j - 1 : 0) * nx, *b = slice + j * nx;
    const float *d = slice + std::min(j + 1, ny - 1) * nx,
                *e = slice + std::min(j + 2, ny - 1) * nx;
    for (std::size_t i = 0; i < nx; ++i) {
      rows.low[j * nx + i] = std::min(std::min(a[i], b[i]), std::min(d[i], e[i]));
      rows.high[j * nx + i] = std::max(std::max(a[i], b[i]), std::max(d[i], e[i]));
    }
    const float *l = rows.low.data() + j * nx, *h = rows.high.data() + j * nx;
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t p = i > 0 ? i - 1 : 0, q = std::min(i + 1, nx - 1),
                        r = std::min(i + 2, nx - 1);
      w.low[j * nx + i] = std::min(std::min(l[p], l[i]), std::min(l[q], l[r]));
      w.high[j * nx + i] = std::max(std::max(h[p], h[i]), std::max(h[q], h[r]));
    }
  }
}

}  // namespace

void Nodes::scan_cells(const std::optional<double>& min_value) {
  const Grid& g = fields_.grid();
  cells_.assign(g.nodes(), 0);
  const int layers = std::max(1, g.size[2] - 1), part = 16;
  kernel::parallel_for(0, (layers + part - 1) / part, [&](int p) {
    std::array<Window, 4> ring;
    std::array<int, 4> held = {-1, -1, -1, -1};
    Window room;
    for (int k = p * part; k < std::min(layers, (p + 1) * part); ++k) {
      std::array<const Window*, 4> w;
      for (int i = 0; i < 4; ++i) {
        const int slice = std::clamp(k - 1 + i, 0, g.size[2] - 1);
        const auto place = static_cast<std::size_t>(slice % 4);
        if (held[place] != slice) window(g, fields_.scalars(), slice, ring[place], room);
        held[place] = slice;
        w[static_cast<std::size_t>(i)] = &ring[place];
      }
      for (int j = 0; j + 1 < g.size[1]; ++j)
        for (int i = 0; i + 1 < g.size[0]; ++i) {
          const std::size_t n = g.index({i, j, 0});
          const float low =
              std::min(std::min(w[0]->low[n], w[1]->low[n]), std::min(w[2]->low[n], w[3]->low[n]));
          const float high = std::max(std::max(w[0]->high[n], w[1]->high[n]),
                                      std::max(w[2]->high[n], w[3]->high[n]));
          bool possible = !min_value || static_cast<double>(low) >= *min_value;
          if (!possible && static_cast<double>(high) >= *min_value) {
            Coefficients net = fields_.coefficients(fields_.scalars(), {i, j, k});
            kernel::to_spline_net<double, 3>(net, {0, 0, 0});
            // Roundings of the net may not lose a cell: convex combinations err by few.
            const double slack = 0x1p-44 * std::max(std::fabs(low), std::fabs(high));
            possible = *std::max_element(net.begin(), net.end()) >= *min_value - slack;
          }
          cells_[g.index({i, j, k})] =
              static_cast<std::uint8_t>((possible ? kPossible : 0) | (low == high ? kPlateau : 0));
        }
    }
  });
}

NodeState Nodes::before_direction(const Node& v) const {
  const Grid& g = fields_.grid();
  bool possible = false, plateau = false;
  for (int c = 0; c < 8; ++c) {
    const Node cell = {v[0] - (c & 1), v[1] - (c >> 1 & 1), v[2] - (c >> 2)};
    if (g.dimension() == 2 ? cell[2] < 0 || !g.is_square(cell) : !g.is_cell(cell)) continue;
    const std::uint8_t bits = cells_[g.index(cell)];
    possible = possible || (bits & kPossible) != 0;
    plateau = plateau || (bits & kPlateau) != 0;
  }
  if (!possible) return NodeState::inactive;
  return plateau ? NodeState::flat : NodeState::active;
}

NodeState Nodes::decide(const Node& v, std::array<float, 3>& direction, std::int8_t& sign) const {
  if (const NodeState s = before_direction(v); s != NodeState::active) return s;
  const Fields::AtNode at = fields_.at_node(v);
  const Vec3 n = dominant_direction(at.tensor);
  // Where less of a gap is left nothing could be decided round the node.
  if (!(kernel::cone_margin(at.tensor, at.tensor_size, at.tensor_error, n) >
        1e-8 * at.tensor_size + 0x1p-200))
    return NodeState::flat;
  if (!fields_.structure() &&
      !(kernel::dot(n, product(at.tensor, n)) > 8 * at.tensor_error + 0x1p-44 * at.tensor_size))
    return NodeState::inactive;
  direction = {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
  auto s =
      kernel::triage_direction_sign(at.tensor, at.tensor_error, at.gradient, at.gradient_error, n);
  if (!s) {
    const auto [t, gradient] = fields_.exact_at_node(v);
    const auto w = kernel::lift<kernel::Rational>(n);
    s = kernel::exact_direction_sign(t, gradient, w);
    if (*s == kernel::Sign::zero) s = kernel::symbolic_direction_sign(t, w);
  }
  sign = static_cast<std::int8_t>(*s);
  return NodeState::active;
}

Nodes::Nodes(const Fields& fields, const std::optional<double>& min_value,
             const kernel::GridBox& asked)
    : fields_(fields) {
  scan_cells(min_value);
  const Grid& g = fields.grid();
  states_.assign(g.nodes(), NodeState::inactive);
  struct Slice {
    std::vector<std::array<float, 3>> directions;
    std::vector<std::int8_t> signs;
  };
  std::vector<Slice> slices(static_cast<std::size_t>(g.size[2]));
  const auto low = [&](std::size_t k) { return static_cast<int>(asked.low[k]); };
  const auto high = [&](std::size_t k) { return static_cast<int>(asked.high[k]); };
  kernel::parallel_for(low(2), high(2), [&](int k) {
    Slice& slice = slices[static_cast<std::size_t>(k)];
    for (int j = low(1); j < high(1); ++j)
      for (int i = low(0); i < high(0); ++i) {
        std::array<float, 3> direction;
        std::int8_t sign;
        const NodeState s = decide({i, j, k}, direction, sign);
        states_[g.index({i, j, k})] = s;
        if (s != NodeState::active) continue;
        slice.directions.push_back(direction);
        slice.signs.push_back(sign);
      }
  });
  ids_ = RankedBits(g.nodes(), [&](std::size_t v) { return active(v); });
  const std::size_t next = count(NodeState::active);
  directions_.reserve(next);
  signs_.reserve(next);
  for (Slice& s : slices) {
    directions_.insert(directions_.end(), s.directions.begin(), s.directions.end());
    signs_.insert(signs_.end(), s.signs.begin(), s.signs.end());
    s = {};
  }
}

std::size_t Nodes::count(NodeState s) const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), s));
}

}  // namespace crest::extremal
