// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/trim.hpp"

#include "certify/container/reject.hpp"
#include "certify/extremal/signs.hpp"

namespace crest::certify::extremal {
namespace {

using kernel::Rational;

/// In a cell, in 65536ths of its edges.
struct Spot {
  u32 cell;
  std::array<u32, 3> at;
};

/// Six times the B-splines' values of that order at t, of the four coefficients.
template <class Number>
std::array<Number, 4> basis(unsigned order, const Number& t) {
  const Number s = Number(1) - t;
  if (order == 0)
    return {s * s * s, (Number(3) * t - Number(6)) * t * t + Number(4),
            ((Number(3) - Number(3) * t) * t + Number(3)) * t + Number(1), t * t * t};
  if (order == 1)
    return {Number(-3) * s * s, (Number(9) * t - Number(12)) * t,
            (Number(6) - Number(9) * t) * t + Number(3), Number(3) * t * t};
  return {Number(6) * s, Number(18) * t - Number(12), Number(6) - Number(18) * t, Number(6) * t};
}

/// Splines at a spot, 216 times too large. Doubles: sums of 64 terms, whose sizes add up to at most
/// A = 2^10 times the largest coefficient; 70 roundings, so less than 2^-46 A.
template <class Number>
class SpotFields {
 public:
  SpotFields(const Fields& fields, const Spot& spot) : fields_(fields) {
    const Grid& grid = fields.grid;
    const Place p = grid.place(spot.cell);
    for (unsigned k = 0; k < 3; ++k) {
      for (unsigned order = 0; order < 3; ++order)
        basis_[k][order] = basis<Number>(order, Number(spot.at[k] * 0x1p-16));
      for (u32 i = 0; i < 4; ++i) {
        const u32 place = p[k] + i == 0 ? 0 : std::min(p[k] + i - 1, grid.nodes[k] - 1);
        offsets_[k][i] = size_t{place} * grid.stride[k];
      }
    }
  }
  Number value(const Buffer<float>& coefficients, const std::array<unsigned, 3>& order,
               double& most) const {
    Number sum(0);
    for (u32 n = 0; n < 64; ++n) {
      const u32 i = n % 4, j = n / 4 % 4, k = n / 16;
      const double c =
          static_cast<double>(coefficients[offsets_[0][i] + offsets_[1][j] + offsets_[2][k]]);
      most = std::max(most, std::fabs(c));
      sum += basis_[0][order[0]][i] * basis_[1][order[1]][j] * basis_[2][order[2]][k] * Number(c);
    }
    return sum;
  }
  /// Hess s, in world units.
  std::array<Number, 6> hessian(double& size) const {
    std::array<Number, 6> h;
    double most = 0;
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j < 3; ++j) {
        if (j >= fields_.grid.dimension) {  // of an image; the errors of a sum would decide
          h[kComponent[i][j]] = Number(0);
          continue;
        }
        std::array<unsigned, 3> order{};
        ++order[i];
        ++order[j];
        h[kComponent[i][j]] = Number(fields_.valley ? 1 : -1) * value(fields_.l, order, most) /
                              (Number(fields_.spacing[i]) * Number(fields_.spacing[j]));
      }
    const double inverse = *std::ranges::max_element(fields_.inverse_spacing);
    size = 0x1p10 * most * inverse * inverse;
    return h;
  }
  std::array<Number, 6> tensor(double& size) const {
    std::array<Number, 6> t;
    if (fields_.hessian) {
      t = hessian(size);
    } else {
      double most = 0;
      for (unsigned i = 0; i < 6; ++i)
        t[i] = fields_.t[i].empty() ? Number(0) : value(fields_.t[i], {0, 0, 0}, most);
      size = 0x1p10 * most;
    }
    if (fields_.grid.dimension == 2) {
      t[2] = Number(-8 * size);
      size *= 16;
    }
    return t;
  }

 private:
  const Fields& fields_;
  std::array<std::array<std::array<Number, 4>, 3>, 3> basis_;
  std::array<std::array<size_t, 4>, 3> offsets_;
};

Matrices<1> matrices(const std::array<double, 6>& m, double size) {
  Matrices<1> out;
  for (size_t i = 0; i < 6; ++i) out.at[i][0] = m[i];
  out.size = size;
  return out;
}

/// L >= level?
bool is_high(const Fields& fields, const Spot& spot, double level) {
  double most = 0;
  const double value = SpotFields<double>(fields, spot).value(fields.l, {0, 0, 0}, most);
  const double error = slack(0x1p10 * std::max(most, std::fabs(level)));
  const double difference = value - 216 * level;
  if (std::fabs(difference) > error) return difference > 0;
  return SpotFields<Rational>(fields, spot).value(fields.l, {0, 0, 0}, most) >=
         216 * Rational(level);
}

/// s_nn >= strength?
bool is_strong(const Fields& fields, const Spot& spot, double strength) {
  double t_size = 0, h_size = 0;
  const SpotFields<double> near(fields, spot);
  const auto t = near.tensor(t_size);
  const Direction direction = direction_at(matrices(t, t_size));
  const auto hessian = near.hessian(h_size);
  Matrices<1> h = matrices(hessian, h_size);
  for (size_t i = 0; i < 3; ++i) h.at[i][0] -= 216 * strength;
  h.size = std::max(h.size, 0x1p10 * strength);
  if (const int sign = curvature_on(direction.cone, direction.frame, h)) return sign > 0;
  const SpotFields<Rational> exact(fields, spot);
  ExactMatrix m = exact.hessian(h_size);
  for (size_t i = 0; i < 3; ++i) m[i] -= 216 * Rational(strength);
  ExactVector w;
  for (size_t k = 0; k < 3; ++k) w[k] = Rational(direction.frame.w[k]);
  const ExactMatrix tensor = exact.tensor(t_size);
  return vanishes(tensor, w, m) || sign_at(tensor, w, m) > 0;
}

}  // namespace

Kept trim(const ExtremalCertificate& c, const Splines& splines, const Mesh& mesh) {
  const Grid& grid = splines.grid();
  const size_t vertices = mesh.vertex_cells.size(), polygons = mesh.polygons.size();
  const bool cuts = c.data.has_min_value || c.data.min_strength > 0;
  require_equal(static_cast<std::int64_t>(c.vertices.size()), vertices, "vertices");
  require_equal(static_cast<std::int64_t>(c.fan_points.size()), cuts ? polygons : 0,
                "points on edges");
  Kept kept{std::vector<std::uint8_t>(vertices, 1), std::vector<std::uint8_t>(polygons, 1)};
  if (!cuts) return kept;
  const auto is_kept = [&](const Fields& fields, const Spot& spot) {
    return (!c.data.has_min_value || is_high(fields, spot, c.data.min_value)) &&
           (c.data.min_strength == 0 || is_strong(fields, spot, c.data.min_strength));
  };
  splines.for_items(
      vertices + polygons, 256,
      [&](size_t i) {
        return i < vertices ? mesh.vertex_cells[i]
                            : edge_place(grid, mesh.polygons[i - vertices]).node;
      },
      [](const Fields&) { return 0; },
      [&](int, const Window& window, size_t i) {
        if (i < vertices) {
          const auto& at = c.vertices[i];
          kept.vertices[i] = is_kept(
              *window.fields, {window.node(grid, mesh.vertex_cells[i]), {at[0], at[1], at[2]}});
          return;
        }
        const auto [node, axis] = edge_place(grid, mesh.polygons[i - vertices]);
        Spot spot{window.node(grid, node), {0, 0, 0}};
        spot.at[axis] = c.fan_points[i - vertices];
        kept.fans[i - vertices] = is_kept(*window.fields, spot);
      });
  return kept;
}

}  // namespace crest::certify::extremal
