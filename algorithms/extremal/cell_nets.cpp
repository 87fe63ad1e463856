// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/cell_nets.hpp"

#include <algorithm>

#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::extremal {
namespace {

/// Order 0, 1 or 2 along an axis of stride S over 16 numbers.
template <int Order, std::size_t S>
void along(const double* c, double* out) {
  for (std::size_t high = 0; high < 16; high += 4 * S)
    for (std::size_t low = high; low < high + S; ++low) {
      const double c0 = c[low], c1 = c[low + S], c2 = c[low + 2 * S], c3 = c[low + 3 * S];
      if constexpr (Order == 0) {
        out[low] = (c0 + 4 * c1 + c2) * (1.0 / 6);
        out[low + S] = (2 * c1 + c2) * (1.0 / 3);
        out[low + 2 * S] = (c1 + 2 * c2) * (1.0 / 3);
        out[low + 3 * S] = (c1 + 4 * c2 + c3) * (1.0 / 6);
      } else if constexpr (Order == 1) {
        const double b0 = (c2 - c0) * 0.5, b1 = c2 - c1, b2 = (c3 - c1) * 0.5;
        out[low] = b0;
        out[low + S] = (b0 + 2 * b1) * (1.0 / 3);
        out[low + 2 * S] = (2 * b1 + b2) * (1.0 / 3);
        out[low + 3 * S] = b2;
      } else {
        const double d0 = c0 - 2 * c1 + c2, d1 = c1 - 2 * c2 + c3;
        out[low] = d0;
        out[low + S] = (2 * d0 + d1) * (1.0 / 3);
        out[low + 2 * S] = (d0 + 2 * d1) * (1.0 / 3);
        out[low + 3 * S] = d1;
      }
    }
}

using Plane = std::array<double, 16>;

template <int OrderY, int OrderZ>
void plane_net(const Plane& c, Plane& out) {
  Plane room;
  along<OrderY, 4>(c.data(), room.data());
  along<OrderZ, 1>(room.data(), out.data());
}

template <int Order>
void across(const std::array<const double*, 4>& c, double scale, double* out) {
  for (std::size_t m = 0; m < 16; ++m) {
    const double c0 = c[0][m], c1 = c[1][m], c2 = c[2][m], c3 = c[3][m];
    if constexpr (Order == 0) {
      const double third = scale / 3, sixth = scale / 6;
      out[m] = (c0 + 4 * c1 + c2) * sixth;
      out[16 + m] = (2 * c1 + c2) * third;
      out[32 + m] = (c1 + 2 * c2) * third;
      out[48 + m] = (c1 + 4 * c2 + c3) * sixth;
    } else if constexpr (Order == 2) {
      const double d0 = c0 - 2 * c1 + c2, d1 = c1 - 2 * c2 + c3, third = scale / 3;
      out[m] = d0 * scale;
      out[16 + m] = (2 * d0 + d1) * third;
      out[32 + m] = (d0 + 2 * d1) * third;
      out[48 + m] = d1 * scale;
    } else {
      const double b0 = (c2 - c0) * 0.5, b1 = c2 - c1, b2 = (c3 - c1) * 0.5, third = scale / 3;
      out[m] = b0 * scale;
      out[16 + m] = (b0 + 2 * b1) * third;
      out[32 + m] = (2 * b1 + b2) * third;
      out[48 + m] = b2 * scale;
    }
  }
}

double largest(const Plane& c) {
  double r = 0;
  for (const double x : c) r = std::max(r, std::fabs(x));
  return r;
}

using Rows = std::array<std::size_t, 16>;
using Columns = std::array<const NetColumn*, 4>;

CREST_WIDE_CLONES void fill_column(const Fields& fields, const Rows& rows, std::size_t x,
                                   NetColumn& r) {
  const auto gather = [&](const std::vector<float>& c) {
    Plane p;
    for (std::size_t n = 0; n < 16; ++n) p[n] = static_cast<double>(c[rows[n] + x]);
    return p;
  };
  const Plane l = gather(fields.scalars());
  r.scalar_size = largest(l);
  plane_net<0, 0>(l, r.scalar[0]);
  plane_net<1, 0>(l, r.scalar[1]);
  plane_net<0, 1>(l, r.scalar[2]);
  if (!fields.structure()) {
    plane_net<2, 0>(l, r.scalar[3]);
    plane_net<1, 1>(l, r.scalar[4]);
    plane_net<0, 2>(l, r.scalar[5]);
  }
  r.tensor_size = 0;
  for (std::size_t t = 0; t < fields.tensors().size(); ++t) {
    const Plane c = gather(fields.tensors()[t]);
    r.tensor_size = std::max(r.tensor_size, largest(c));
    plane_net<0, 0>(c, r.tensor[t]);
  }
}

/// T = Hess s of the spline itself.
void make_hessian(const Fields& fields, const Columns& c, CellNets& nets) {
  const auto of = [&](std::size_t n) {
    return std::array<const double*, 4>{c[0]->scalar[n].data(), c[1]->scalar[n].data(),
                                        c[2]->scalar[n].data(), c[3]->scalar[n].data()};
  };
  const Vec3& d = fields.grid().spacing;
  const double s = fields.sign(), least = std::min({d[0], d[1], d[2]});
  nets.tensor_size = 2 * nets.gradient_size / least;
  across<2>(of(0), s / (d[0] * d[0]), nets.tensor[0].data());
  across<0>(of(3), s / (d[1] * d[1]), nets.tensor[1].data());
  across<0>(of(5), s / (d[2] * d[2]), nets.tensor[2].data());
  across<1>(of(1), s / (d[0] * d[1]), nets.tensor[3].data());
  across<0>(of(4), s / (d[1] * d[2]), nets.tensor[4].data());
  across<1>(of(2), s / (d[0] * d[2]), nets.tensor[5].data());
  if (fields.grid().dimension() == 2) nets.tensor[2].fill(-8 * nets.tensor_size);
}

CREST_WIDE_CLONES void make_nets(const Fields& fields, const Columns& c, CellNets& nets) {
  const Vec3& d = fields.grid().spacing;
  const double s = fields.sign();
  const auto of = [&](std::size_t n) {
    return std::array<const double*, 4>{c[0]->scalar[n].data(), c[1]->scalar[n].data(),
                                        c[2]->scalar[n].data(), c[3]->scalar[n].data()};
  };
  across<1>(of(0), s / d[0], nets.gradient[0].data());
  across<0>(of(1), s / d[1], nets.gradient[1].data());
  across<0>(of(2), s / d[2], nets.gradient[2].data());
  nets.gradient_size =
      std::max({c[0]->scalar_size, c[1]->scalar_size, c[2]->scalar_size, c[3]->scalar_size}) * 2 /
      std::min({d[0], d[1], d[2]});
  if (!fields.structure()) {
    make_hessian(fields, c, nets);
    return;
  }
  nets.tensor_size =
      std::max({c[0]->tensor_size, c[1]->tensor_size, c[2]->tensor_size, c[3]->tensor_size});
  for (std::size_t t = 0; t < fields.tensors().size(); ++t)
    across<0>({c[0]->tensor[t].data(), c[1]->tensor[t].data(), c[2]->tensor[t].data(),
               c[3]->tensor[t].data()},
              1, nets.tensor[fields.entry(t)].data());
  if (fields.tensors().size() == 3) {
    nets.tensor[4].fill(0);
    nets.tensor[5].fill(0);
    nets.tensor[2].fill(-8 * nets.tensor_size);
  }
}

}  // namespace

RowNets::RowNets(const Fields& fields, int j, int k) : fields_(fields) {
  const Grid& g = fields.grid();
  for (int y = 0; y < 4; ++y)
    for (int z = 0; z < 4; ++z)
      rows_[static_cast<std::size_t>(4 * y + z)] = g.index(
          {0, std::clamp(j - 1 + y, 0, g.size[1] - 1), std::clamp(k - 1 + z, 0, g.size[2] - 1)});
}

const NetColumn& RowNets::column(int i) {
  const auto place = static_cast<std::size_t>(i + 4) % 4;
  NetColumn& r = ring_[place];
  if (held_[place] == i) return r;
  held_[place] = i;
  fill_column(fields_, rows_,
              static_cast<std::size_t>(std::clamp(i, 0, fields_.grid().size[0] - 1)), r);
  return r;
}

void RowNets::make(int i, CellNets& nets) {
  Columns c;
  for (int m = 0; m < 4; ++m) c[static_cast<std::size_t>(m)] = &column(i - 1 + m);
  make_nets(fields_, c, nets);
}

}  // namespace crest::extremal
