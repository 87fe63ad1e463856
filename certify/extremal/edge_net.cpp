// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/edge_net.hpp"

namespace crest::certify::extremal {
namespace {

/// Six times the Bezier values from four coefficients, by order.
constexpr int kTable[3][4][4] = {{{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}},
                                 {{-3, 0, 3, 0}, {-1, -4, 5, 0}, {0, -5, 4, 1}, {0, -3, 0, 3}},
                                 {{6, -12, 6, 0}, {4, -6, 0, 2}, {2, 0, -6, 4}, {0, 6, -12, 6}}};

/// The coefficients round an edge: 4 along it, 3 across it each way.
struct Block {
  double at[4][3][3];
  double most = 0;

  /// Of as many along it is the largest size.
  Block(const Fields& fields, const Buffer<float>& coefficients, u32 node, unsigned axis,
        u32 counted) {
    const Grid& grid = fields.grid;
    const Place p = grid.place(node);
    const unsigned b = (axis + 1) % 3, c = (axis + 2) % 3;
    const auto offset = [&](unsigned k, u32 i) {  // i - 1 beside the node, mirrored at the border
      const u32 place = p[k] + i == 0 ? 0 : std::min(p[k] + i - 1, grid.nodes[k] - 1);
      return size_t{place} * grid.stride[k];
    };
    for (u32 i = 0; i < 4; ++i)
      for (u32 j = 0; j < 3; ++j)
        for (u32 k = 0; k < 3; ++k) {
          const double x =
              static_cast<double>(coefficients[offset(axis, i) + offset(b, j) + offset(c, k)]);
          at[i][j][k] = x;
          if (i < counted) most = std::max(most, std::fabs(x));
        }
  }

  /// The controls of the derivative of these orders along the edge and across it.
  template <class Number>
  std::array<Number, 4> net(unsigned along, unsigned b, unsigned c) const {
    Number row[4];
    for (int i = 0; i < 4; ++i) {
      row[i] = Number(0);
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) {
          const int factor = kTable[b][0][j] * kTable[c][0][k];
          if (factor != 0) row[i] += Number(at[i][j][k]) * Number(factor);
        }
    }
    std::array<Number, 4> out;
    for (int i = 0; i < 4; ++i) {
      out[static_cast<size_t>(i)] = Number(0);
      for (int j = 0; j < 4; ++j)
        if (kTable[along][i][j] != 0)
          out[static_cast<size_t>(i)] += row[j] * Number(kTable[along][i][j]);
    }
    return out;
  }
};

template <class Number>
void scale(std::array<Number, 4>& controls, const Number& factor) {
  for (Number& x : controls) x *= factor;
}

template <class Number>
EdgeNet<Number> make_net(const Fields& fields, u32 node, unsigned axis, u32 counted) {
  EdgeNet<Number> net;
  const Block l(fields, fields.l, node, axis, counted);
  const Number sign(fields.valley ? 1 : -1);
  const auto inverse = [&](unsigned k) { return Number(1) / Number(fields.spacing[k]); };
  const double inverse_most = *std::ranges::max_element(fields.inverse_spacing);
  for (unsigned i = 0; i < 3; ++i) {
    std::array<unsigned, 3> order{};
    order[i] = 1;
    net.v[i] = l.net<Number>(order[axis], order[(axis + 1) % 3], order[(axis + 2) % 3]);
    scale(net.v[i], Number(sign * inverse(i)));
    for (unsigned j = i; j < 3; ++j) {
      std::array<unsigned, 3> orders{};
      ++orders[i];
      ++orders[j];
      auto& h = net.h[kComponent[i][j]];
      h = l.net<Number>(orders[axis], orders[(axis + 1) % 3], orders[(axis + 2) % 3]);
      scale(h, Number(sign * inverse(i) * inverse(j)));
    }
  }
  // Across an image nothing changes; the errors of sums would.
  for (unsigned i = 0; i < 3 && fields.grid.dimension == 2; ++i)
    net.h[kComponent[i][2]].fill(Number(0));
  if (fields.grid.dimension == 2) net.v[2].fill(Number(0));
  const double l_size = 0x1p10 * l.most;
  net.v_size = l_size * inverse_most;
  net.h_size = net.t_size = net.v_size * inverse_most;
  // T = Hess s is -Hess L for ridges.
  if (fields.hessian) net.t = net.h;
  double most = 0;
  for (unsigned i = 0; i < 6 && !fields.hessian; ++i) {
    net.t[i].fill(Number(0));
    if (fields.t[i].empty()) continue;
    const Block t(fields, fields.t[i], node, axis, counted);
    most = std::max(most, t.most);
    net.t[i] = t.net<Number>(0, 0, 0);
  }
  if (!fields.hessian) net.t_size = 0x1p10 * most;
  if (fields.grid.dimension == 2) {
    net.t[2].fill(Number(-8 * net.t_size));
    net.t_size *= 16;
  }
  return net;
}

}  // namespace

template <class Number>
EdgeNet<Number> edge_net(const Fields& fields, u32 node, unsigned axis) {
  return make_net<Number>(fields, node, axis, 4);
}
template <class Number>
EdgeNet<Number> node_net(const Fields& fields, u32 node) {
  return make_net<Number>(fields, node, 0, 3);
}

template EdgeNet<double> edge_net(const Fields&, u32, unsigned);
template EdgeNet<double> node_net(const Fields&, u32);
template EdgeNet<kernel::Rational> node_net(const Fields&, u32);

}  // namespace crest::certify::extremal
