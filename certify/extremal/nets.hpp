// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bezier nets of a cell: the splines and their derivatives by index, as 4^d control values each, 6
// for every axis times too large: so that all is sums of coefficients times integers.
//
// Errors. A row of a table has integer factors whose sizes add up to at most 6, 12, 24 for
// orders 0 to 2 and takes at most seven roundings; so with m the largest coefficient in reach,
// every intermediate and control value of total order at most 2 is at most A = 2^10 m in size (24 6
// 6, 12 12 6) and errs by at most 3 * 8 u A < 2^-48 A, u = 2^-53.
#include <algorithm>
#include <cmath>

#include "certify/extremal/fields.hpp"

namespace crest::certify::extremal {

/// Bezier values from four coefficients that lie `from` apart, to places `to` apart, for a block of
/// neighbours.
template <int order, size_t block>
inline void bezier(const double* c0, const double* c1, const double* c2, const double* c3,
                   double* out, size_t to) {
  for (size_t j = 0; j < block; ++j) {
    if constexpr (order == 0) {
      out[j] = c0[j] + 4 * c1[j] + c2[j];
      out[to + j] = 4 * c1[j] + 2 * c2[j];
      out[2 * to + j] = 2 * c1[j] + 4 * c2[j];
      out[3 * to + j] = c1[j] + 4 * c2[j] + c3[j];
    } else {
      const double e0 = c1[j] - c0[j], e1 = c2[j] - c1[j], e2 = c3[j] - c2[j];
      if constexpr (order == 1) {
        out[j] = 3 * (e0 + e1);
        out[to + j] = e0 + 5 * e1;
        out[2 * to + j] = 5 * e1 + e2;
        out[3 * to + j] = 3 * (e1 + e2);
      } else {
        const double d0 = e1 - e0, d1 = e2 - e1;
        out[j] = 6 * d0;
        out[to + j] = 4 * d0 + 2 * d1;
        out[2 * to + j] = 2 * d0 + 4 * d1;
        out[3 * to + j] = 6 * d1;
      }
    }
  }
}

/// The coefficients of one x round the cells of a row, already turned into Bezier values along y
/// and z: cells that follow one another share them.
template <unsigned dimension>
struct Column {
  static constexpr size_t kSize = dimension == 3 ? 16 : 4;
  using Values = std::array<double, kSize>;
  static constexpr u32 kEmpty = 0xffffffffU;

  u32 x = kEmpty;
  bool full = false;  ///< with what only regular cells and Hessians need
  // By order along y, z.
  std::array<Values, 3> t[6];  ///< (0, 0); full: (1, 0), (0, 1)
  std::array<Values, 6> l;     ///< (0, 0), (1, 0), (0, 1); full: (2, 0), (0, 2), (1, 1)
  double most_l, most_t;       ///< sizes of the coefficients
};

/// Nets of one cell after the other; in a row, columns are kept for the next cell.
template <unsigned dimension>
class RowNets {
 public:
  static constexpr size_t kControls = dimension == 3 ? 64 : 16;
  using Net = std::array<double, kControls>;

  explicit RowNets(const Fields& fields) : fields_(fields) {}

  /// Prepares the cell of that lowest node.
  void move_to(u32 cell, bool full) {
    const Place p = fields_.grid.place(cell);
    if (p[1] != y_ || p[2] != z_)
      for (auto& column : columns_) column.x = Column<dimension>::kEmpty;
    y_ = p[1];
    z_ = p[2];
    for (u32 i = 0; i < 4; ++i) {
      // Mirrored beyond the border, x is 0 or the last again.
      const u32 x = p[0] + i;  // one more than the coefficient's
      auto& column = columns_[x % 4];
      if (column.x != x || (full && !column.full)) fill(column, x, full);
    }
    x_ = p[0];
  }
  double most_l() const { return most(&Column<dimension>::most_l); }
  double most_t() const { return most(&Column<dimension>::most_t); }

  /// L's net of these orders, together at most 2.
  template <int x, int y, int z>
  void l(Net& out) const {
    constexpr size_t place = y + z == 0   ? 0
                             : y + z == 1 ? (z == 0 ? 1 : 2)
                             : y == 2     ? 3
                             : z == 2     ? 4
                                          : 5;
    along_x<x>([&](u32 i) { return columns_[(x_ + i) % 4].l[place].data(); }, out);
  }
  /// A component's net of T, of order 0 or one first derivative. Not with `hessian`.
  template <int x, int y, int z>
  void t(unsigned component, Net& out) const {
    constexpr size_t place = y + z == 0 ? 0 : z == 0 ? 1 : 2;
    along_x<x>([&](u32 i) { return columns_[(x_ + i) % 4].t[component][place].data(); }, out);
  }

 private:
  static constexpr size_t kSize = Column<dimension>::kSize;

  double most(double Column<dimension>::*member) const {
    double m = 0;
    for (const auto& column : columns_) m = std::max(m, column.*member);
    return m;
  }
  template <int order, class Values>
  void along_x(const Values& values, Net& out) const {
    bezier<order, kSize>(values(0), values(1), values(2), values(3), out.data(), kSize);
  }

  /// The coefficients of that x, 4 along y for each of 4 (or 1) along z; returns the largest size.
  double gather(const Buffer<float>& coefficients, u32 x, std::array<double, kSize>& out) const {
    const auto at = [](u32 place, u32 n) { return place == 0 ? 0 : std::min(place - 1, n - 1); };
    const Grid& grid = fields_.grid;
    double size = 0;
    for (u32 k = 0; k < kSize / 4; ++k)
      for (u32 j = 0; j < 4; ++j) {
        const u32 z = dimension == 3 ? at(z_ + k, grid.nodes[2]) : 0;
        const double c = static_cast<double>(
            coefficients[at(x, grid.nodes[0]) + at(y_ + j, grid.nodes[1]) * grid.stride[1] +
                         z * grid.stride[2]]);
        out[4 * k + j] = c;
        size = std::max(size, std::fabs(c));
      }
    return size;
  }
  template <int order>
  static void along_z(const std::array<double, kSize>& c, std::array<double, kSize>& out) {
    if constexpr (dimension == 3)
      bezier<order, 4>(c.data(), c.data() + 4, c.data() + 8, c.data() + 12, out.data(), 4);
    else
      out = c;
  }
  template <int order>
  static void along_y(const std::array<double, kSize>& c, std::array<double, kSize>& out) {
    for (size_t k = 0; k < kSize; k += 4) {
      const double* const row = c.data() + k;
      bezier<order, 1>(row, row + 1, row + 2, row + 3, out.data() + k, 1);
    }
  }

  void fill(Column<dimension>& column, u32 x, bool full) const {
    std::array<double, kSize> c, z0, z1, z2;
    column.x = x;
    column.full = full;
    column.most_t = 0;
    for (unsigned i = 0; i < 6; ++i) {
      if (fields_.t[i].empty()) continue;
      column.most_t = std::max(column.most_t, gather(fields_.t[i], x, c));
      along_z<0>(c, z0);
      along_y<0>(z0, column.t[i][0]);
      if (!full) continue;
      along_y<1>(z0, column.t[i][1]);
      along_z<1>(c, z1);
      along_y<0>(z1, column.t[i][2]);
    }
    column.most_l = gather(fields_.l, x, c);
    along_z<0>(c, z0);
    along_z<1>(c, z1);
    along_y<0>(z0, column.l[0]);
    along_y<1>(z0, column.l[1]);
    along_y<0>(z1, column.l[2]);
    if (!full) return;
    along_z<2>(c, z2);
    along_y<2>(z0, column.l[3]);
    along_y<0>(z2, column.l[4]);
    along_y<1>(z1, column.l[5]);
  }

  const Fields& fields_;
  u32 y_ = 0xffffffffU, z_ = 0xffffffffU, x_ = 0;
  std::array<Column<dimension>, 4> columns_;
};

}  // namespace crest::certify::extremal
