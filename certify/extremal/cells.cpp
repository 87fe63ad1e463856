// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/cells.hpp"

#include <memory>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/extremal/bounds.hpp"
#include "certify/extremal/nets.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::extremal {
namespace {

namespace code = extremal_code;

constexpr size_t kBatch = 512;  ///< cells to a worker's turn: columns are shared in a row

/// The largest norms of diag(d) H, from the derivatives by index, and of each of its rows.
struct RowNorms {
  double all;
  Vec rows;
};
template <size_t n>
RowNorms most_row_norms(const Matrices<n>& h, const Vec& inverse) {
  RowNorms norms;
  std::array<double, n> sum{};
  for (unsigned i = 0; i < 3; ++i) {
    std::array<double, n> square{};
    for (unsigned j = 0; j < 3; ++j)
      for (size_t k = 0; k < n; ++k) {
        const double x = h.at[kComponent[i][j]][k] * inverse[j];
        square[k] += x * x;
      }
    norms.rows[i] = std::sqrt(most(square)) + slack(h.size);
    for (size_t k = 0; k < n; ++k) sum[k] += square[k];
  }
  norms.all = std::sqrt(most(sum)) + slack(h.size);
  return norms;
}

/// E_k of SPEC.md.
Vec box_errors(const Cone& cone, const RowNorms& norms, const Vec& turns, double aside,
               double size) {
  Vec errors;
  for (size_t k = 0; k < 3; ++k)
    errors[k] = (cone.chord * norms.rows[k] + turns[k] * aside) * kMore * kMore + slack(size);
  return errors;
}

/// The box test: do any two vectors with coordinates in these ranges, widened, have a positive
/// product?
template <size_t n>
bool has_box(const std::array<std::array<double, n>, 3>& h, unsigned dimension, const Vec& error) {
  double sum = 0, size = 0;
  for (unsigned k = 0; k < dimension; ++k) {
    const double low = least(h[k]) - error[k], high = most(h[k]) + error[k];
    sum += low > 0 ? low * low : high < 0 ? high * high : low * high;
    size += std::max(low * low, high * high);
  }
  return sum > slack(size);
}

/// Proves codes of cells; nets are its scratch.
template <unsigned dimension>
class CellProver {
 public:
  explicit CellProver(const Fields& fields)
      : fields_(fields),
        nets_(fields),
        inverse_(*std::ranges::max_element(fields.inverse_spacing)) {}

  /// Throws Reject, naming the cell so. `a` is read for regular cells. Returns whether the box test
  /// holds, too.
  bool prove(u32 lowest, u32 cell, std::uint8_t stated, const ExtremalDirection& w,
             const ExtremalDirection& a) {
    const bool regular = stated >= code::kRegular;
    nets_.move_to(lowest, regular || fields_.hessian);
    const Frame frame(w);
    make_tensors();
    const Cone cone = test_cone(t_, frame);
    require(cone.holds, "cell {}: the cone test fails", cell);
    if (stated == code::kCone) return false;
    make_gradients();
    if (stated == code::kEmpty) {
      require(sign_on(cone, frame, v_) != 0, "cell {}: it is not proven empty", cell);
      return false;
    }
    require(!fields_.hessian, "cell {}: `hessian` has no regular cells", cell);
    make_hessians();
    require(is_regular(cone, frame, Frame(a)), "cell {}: it is not proven regular", cell);
    if (stated != code::kRegularExtremal) return boxed_;
    scale_hessians();
    require(curvature_on(cone, frame, h_) == (fields_.valley ? 1 : -1),
            "cell {}: s_nn > 0 is not proven", cell);
    return boxed_;
  }

  /// Is L < level on the whole cell?
  bool is_below(u32 cell, double level) {
    nets_.move_to(cell, false);
    Net net;
    nets_.template l<0, 0, 0>(net);
    const double scale = dimension == 3 ? 216 : 36;
    const double size = std::max(0x1p10 * nets_.most_l(), scale * std::fabs(level));
    return most(net) + slack(size) < scale * level;
  }

 private:
  using Net = typename RowNets<dimension>::Net;
  static constexpr size_t kControls = RowNets<dimension>::kControls;

  void make_tensors() {
    if (fields_.hessian) {
      make_hessians();
      scale_hessians();
      t_ = h_;
      if (!fields_.valley)
        for (auto& component : t_.at)
          for (double& x : component) x = -x;
    } else {
      for (unsigned i = 0; i < 6; ++i)
        if (fields_.t[i].empty())
          t_.at[i].fill(0);
        else
          nets_.template t<0, 0, 0>(i, t_.at[i]);
      t_.size = 0x1p10 * nets_.most_t();
    }
    if constexpr (dimension == 2) {
      t_.at[2].fill(-8 * t_.size);
      t_.size *= 16;
    }
  }
  void make_gradients() {
    nets_.template l<1, 0, 0>(v_.at[0]);
    nets_.template l<0, 1, 0>(v_.at[1]);
    if constexpr (dimension == 3)
      nets_.template l<0, 0, 1>(v_.at[2]);
    else
      v_.at[2].fill(0);
    for (size_t k = 0; k < dimension; ++k)
      for (double& x : v_.at[k]) x *= fields_.inverse_spacing[k];
    v_.size = 0x1p10 * nets_.most_l() * inverse_;
  }
  /// By index, not by length.
  void make_hessians() {
    nets_.template l<2, 0, 0>(h_.at[0]);
    nets_.template l<0, 2, 0>(h_.at[1]);
    nets_.template l<1, 1, 0>(h_.at[3]);
    if constexpr (dimension == 3) {
      nets_.template l<0, 0, 2>(h_.at[2]);
      nets_.template l<0, 1, 1>(h_.at[4]);
      nets_.template l<1, 0, 1>(h_.at[5]);
    } else {
      for (size_t i : {2, 4, 5}) h_.at[i].fill(0);
    }
    h_.size = 0x1p10 * nets_.most_l() * inverse_;
  }
  void scale_hessians() {
    const Vec& d = fields_.inverse_spacing;
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j < 3; ++j)
        for (double& x : h_.at[kComponent[i][j]]) x *= d[i] * d[j];
    h_.size = 0x1p10 * nets_.most_l() * inverse_ * inverse_;
  }

  /// Bounds d_k |n_k| for every axis: D_k of SPEC.md.
  Vec turning(const Cone& cone, const Frame& frame) {
    Vec speed{};
    for (unsigned axis = 0; axis < dimension; ++axis) {
      for (unsigned i = 0; i < 6; ++i)
        if (fields_.t[i].empty())
          d_.at[i].fill(0);
        else if (axis == 0)
          nets_.template t<1, 0, 0>(i, d_.at[i]);
        else if (axis == 1)
          nets_.template t<0, 1, 0>(i, d_.at[i]);
        else
          nets_.template t<0, 0, 1>(i, d_.at[i]);
      d_.size = 0x1p10 * nets_.most_t();
      const double across =
          most_length(form(d_, frame.w, frame.u), form(d_, frame.w, frame.v), d_.size);
      speed[axis] = (across + 2 * cone.angle * most_norm(d_)) / cone.gap * kMore;
    }
    return speed;
  }
  bool is_regular(const Cone& cone, const Frame& frame, const Frame& a) {
    const auto along = form(v_, frame.w);
    const double most_along = std::max(most(along), -least(along)) + slack(v_.size);
    const double p = most_length(form(v_, frame.u), form(v_, frame.v), v_.size);
    const RowNorms norms = most_row_norms(h_, fields_.inverse_spacing);
    const Vec turns = turning(cone, frame);
    const double aside = (p + cone.sine * most_along) * kMore;
    const double error =
        (cone.chord * norms.all + std::sqrt(dot(turns, turns)) * kMore * aside) * kMore;
    // a . h_i, h_i = diag(d) H_i w of s, and the same for two across a.
    const Vec& d = fields_.inverse_spacing;
    const double sign = fields_.valley ? 1 : -1;
    const Vec w{sign * frame.w[0] * d[0], sign * frame.w[1] * d[1], sign * frame.w[2] * d[2]};
    const auto ahead = form(h_, a.w, w), u = form(h_, a.u, w), v = form(h_, a.v, w);
    std::array<double, kControls> room;
    for (size_t n = 0; n < kControls; ++n)
      room[n] = ahead[n] - std::sqrt(u[n] * u[n] + v[n] * v[n]);
    boxed_ =
        has_box(std::array{form(h_, {1, 0, 0}, w), form(h_, {0, 1, 0}, w), form(h_, {0, 0, 1}, w)},
                dimension, box_errors(cone, norms, turns, aside, h_.size));
    return least(room) - 3 * slack(h_.size) > 1.4142135623730952 * error * kMore;
  }

  const Fields& fields_;
  RowNets<dimension> nets_;
  double inverse_;
  bool boxed_ = false;
  Matrices<kControls> t_, h_, d_;
  Vectors<kControls> v_;
};

template <unsigned dimension>
void check_codes(const ExtremalCertificate& c, const Splines& splines, Cells& cells) {
  splines.for_items(
      cells.ids.size(), kBatch, [&](size_t i) { return cells.ids[i]; },
      [](const Fields& fields) { return std::make_unique<CellProver<dimension>>(fields); },
      [&](auto& prover, const Window& window, size_t i) {
        if (c.codes[i] == code::kOpen) return;
        const ExtremalDirection& w = c.directions[cells.directions[i]];
        const u32 cell = cells.ids[i];
        cells.set_boxed(
            cell, prover->prove(window.node(splines.grid(), cell), cell, c.codes[i], w,
                                c.codes[i] < code::kRegular ? w : c.gradients[cells.gradients[i]]));
      });
}

/// Bezier values are means of coefficients, so first by these.
bool is_low(const Fields& fields, u32 cell, float level) {
  const Grid& grid = fields.grid;
  const Place p = grid.place(cell);
  const auto low = [](u32 x) { return x == 0 ? 0 : x - 1; };
  for (u32 z = low(p[2]); z <= std::min(p[2] + 2, grid.nodes[2] - 1); ++z)
    for (u32 y = low(p[1]); y <= std::min(p[1] + 2, grid.nodes[1] - 1); ++y)
      for (u32 x = low(p[0]); x <= std::min(p[0] + 2, grid.nodes[0] - 1); ++x)
        if (!(fields.l[x + size_t{y} * grid.stride[1] + size_t{z} * grid.stride[2]] < level))
          return false;
  return true;
}

/// Exactly, where doubles do not decide: a plateau may lie just below the level.
bool is_below_exactly(const Fields& fields, u32 cell, double level);

/// The cells between two nodes.
template <class Visit>
void for_cells(const Grid& grid, const std::array<Place, 2>& corners, const Visit& visit) {
  const auto& [low, high] = corners;
  const u32 top = std::max(high[2], low[2] + 1);  // an image has one layer
  for (u32 z = low[2]; z < top; ++z)
    for (u32 y = low[1]; y < high[1]; ++y)
      for (u32 x = low[0]; x < high[0]; ++x) visit(x + y * grid.stride[1] + z * grid.stride[2]);
}

template <unsigned dimension>
void check_unlisted(const ExtremalCertificate& c, const Splines& splines, const Cells& cells) {
  const Grid& grid = splines.grid();
  const double level = c.data.min_value;
  float above = static_cast<float>(level);  // floats below it are below the level
  if (static_cast<double>(above) < level) above = std::nextafter(above, HUGE_VALF);
  parallel_for(
      splines.blocks(), [] { return 0; },
      [&](int, size_t block) {
        const auto b = static_cast<u32>(block);
        if (c.data.has_min_value && splines.is_low(b, above)) return;
        splines.with_window(b, false, [&](const Window& window) {
          const Fields& fields = *window.fields;
          const auto prover = std::make_unique<CellProver<dimension>>(fields);
          for_cells(grid, splines.corners(b), [&](u32 cell) {
            if (cells.code(cell) != Cells::kUnlisted) return;
            require(c.data.has_min_value, "cell {}: it is not listed", cell);
            const u32 own = window.node(grid, cell);
            require(is_low(fields, own, above) || prover->is_below(own, level) ||
                        is_below_exactly(fields, own, level),
                    "cell {}: it is not listed, but L may reach the least value", cell);
          });
        });
      });
}

/// x 2^-low, which is whole.
template <class Number>
Number whole(double x, int low) {
  int exponent;
  const Number bits = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
  const int up = exponent - 53 - low;
  return bits == 0 ? bits : up >= 0 ? Number(bits << up) : Number(bits >> -up);
}

/// Every control value of a cell of these coefficients below the level? All times 2^-low, and
/// six for each axis.
template <class Number>
bool are_controls_below(const std::array<double, 64>& coefficients, double level, int low,
                        unsigned dimension) {
  std::array<Number, 64> c;
  Number most = whole<Number>(level, low);
  const u32 count = 1U << 2 * dimension;
  for (u32 n = 0; n < count; ++n) c[n] = whole<Number>(coefficients[n], low);
  for (u32 step = 1; step < count; step *= 4) {
    most *= 6;
    for (u32 n = 0; n < count; ++n) {
      if (n / step % 4 != 0) continue;
      const Number c1 = c[n + step], c2 = c[n + 2 * step];
      c[n] += 4 * c1 + c2;
      c[n + step] = 4 * c1 + 2 * c2;
      c[n + 2 * step] = 2 * c1 + 4 * c2;
      c[n + 3 * step] += c1 + 4 * c2;
    }
  }
  return std::all_of(c.begin(), c.begin() + count, [&](const Number& x) { return x < most; });
}

__extension__ using Wide = __int128;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Exponents between which all bits of numbers lie, of which zeros have none.
struct BitRange {
  int low = 2000, high = -2000;
  void add(double x, int bits) {
    if (x == 0) return;
    int exponent;
    std::frexp(x, &exponent);
    low = std::min(low, exponent - bits);
    high = std::max(high, exponent);
  }
};

bool is_below_exactly(const Fields& fields, u32 cell, double level) {
  const Grid& grid = fields.grid;
  const Place p = grid.place(cell);
  const auto at = [&](unsigned k, u32 i) {
    return size_t{p[k] + i == 0 ? 0 : std::min(p[k] + i - 1, grid.nodes[k] - 1)} * grid.stride[k];
  };
  std::array<double, 64> c;
  BitRange range;
  range.add(level, 53);
  for (u32 n = 0; n < 64; ++n) {
    c[n] = static_cast<double>(fields.l[at(0, n % 4) + at(1, n / 4 % 4) + at(2, n / 16)]);
    range.add(c[n], 24);  // a float
  }
  // Of 110 bits, their sums of 118: some ten times faster.
  if (range.high - range.low <= 110)
    return are_controls_below<Wide>(c, level, range.low, grid.dimension);
  return are_controls_below<Integer>(c, level, range.low, grid.dimension);
}

}  // namespace

Cells list_cells(const ExtremalCertificate& c, const Grid& grid) {
  Cells cells(grid);
  std::uint64_t total = 0;
  for (const CellRun& run : c.cells) total += run.length;
  require(total == c.codes.size(), "cells: {} in runs, {} codes", total, c.codes.size());
  cells.ids.reserve(c.codes.size());
  std::uint64_t end = 0;  // of the run before
  for (const CellRun& run : c.cells) {
    const std::uint64_t last = std::uint64_t{run.first} + run.length;
    require(run.length > 0 && last <= grid.count, "cells: a run is empty or leaves the grid");
    require(run.first > end || (end == 0 && run.first == 0),
            "cells: runs are not ascending and apart");
    const u32 final = static_cast<u32>(last - 1);
    require(grid.is_cell(run.first) && grid.is_cell(final) &&
                run.first / grid.nodes[0] == final / grid.nodes[0],
            "cells: a run leaves its row");
    for (u32 cell = run.first; cell < last; ++cell) cells.list(cell, c.codes[cells.ids.size()]);
    end = last;
  }
  u32 directions = 0, gradients = 0;
  for (const std::uint8_t stated : c.codes) {
    cells.directions.push_back(directions);
    cells.gradients.push_back(gradients);
    directions += stated != code::kOpen;
    gradients += stated >= code::kRegular;
  }
  return cells;
}

void check_cells(const ExtremalCertificate& c, const Splines& splines, Cells& cells) {
  if (splines.grid().dimension == 3) {
    check_codes<3>(c, splines, cells);
    check_unlisted<3>(c, splines, cells);
  } else {
    check_codes<2>(c, splines, cells);
    check_unlisted<2>(c, splines, cells);
  }
}

}  // namespace crest::certify::extremal
