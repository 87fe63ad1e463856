// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fields and meshes with known answers (reference numbers of the paper's system).
#include <array>
#include <cmath>
#include <vector>

#include "algorithms/modes/modes.hpp"
#include "tests/modes/reference_fields.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// Rows xx yy xy xz yz (zz = -xx - yy) of T0, Tx, Ty, Tz.
using Rows = std::vector<std::array<int, 5>>;

inline Rows rows_of(const LinearField& field) {
  return {field.begin(), field.end()};
}

inline std::array<double, 6> tensor_of(const std::array<double, 5>& r) {
  return {r[0], r[1], -r[0] - r[1], r[2], r[4], r[3]};
}

/// Of a linear field, or of one with rows for xy and z^2, at a point.
inline std::array<double, 6> value_at(const Rows& rows, const kernel::Vec3& p) {
  const double factor[6] = {1, p[0], p[1], p[2], p[0] * p[1], p[2] * p[2]};
  std::array<double, 5> r{};
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < 5; ++k) r[k] += factor[i] * rows[i][k];
  return tensor_of(r);
}

enum class Cut { diagonal, mirrored };

/// [-half, half]^3 with n^3 vertices, each cube in six tetrahedra along a diagonal: always from
/// (0, 0, 0) to (1, 1, 1), or mirrored from cube to cube.
inline modes::ModeField box(const Rows& rows, double half, kernel::Index n, Cut cut) {
  std::vector<kernel::Vec3> points;
  std::vector<std::array<double, 6>> tensors;
  for (kernel::Index z = 0; z < n; ++z)
    for (kernel::Index y = 0; y < n; ++y)
      for (kernel::Index x = 0; x < n; ++x) {
        const auto at = [&](kernel::Index i) { return -half + 2 * half * i / (n - 1); };
        points.push_back({at(x), at(y), at(z)});
        tensors.push_back(value_at(rows, points.back()));
      }
  constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  std::vector<kernel::TetMesh::Tet> tets;
  for (kernel::Index z = 0; z + 1 < n; ++z)
    for (kernel::Index y = 0; y + 1 < n; ++y)
      for (kernel::Index x = 0; x + 1 < n; ++x)
        for (const auto& order : orders) {
          const kernel::Index cube[3] = {x, y, z};
          std::array<kernel::Index, 3> corner{};
          kernel::TetMesh::Tet t{};
          for (std::size_t k = 0; k < 4; ++k) {
            if (k > 0) corner[static_cast<std::size_t>(order[k - 1])] = 1;
            std::array<kernel::Index, 3> c{};
            for (std::size_t i = 0; i < 3; ++i) {
              const bool flip = cut == Cut::mirrored && cube[i] % 2 == 1;
              c[i] = cube[i] + (flip ? 1 - corner[i] : corner[i]);
            }
            t[k] = (c[2] * n + c[1]) * n + c[0];
          }
          tets.push_back(t);
        }
  return {kernel::TetMesh(std::move(points), std::move(tets)), std::move(tensors)};
}

/// The box with entries from the generator at its vertices.
template <class Entry>
modes::ModeField random_box(kernel::Index n, const Entry& entry) {
  auto field = box(Rows(4), 1, n, Cut::diagonal);
  for (auto& t : field.tensors) {
    std::array<double, 5> r;
    for (double& x : r) x = entry();
    t = tensor_of(r);
  }
  return field;
}

/// Small integers: exact zeros, edges of exactly the same angle, special faces.
inline modes::ModeField random_integers(kernel::Index n, std::uint64_t seed) {
  Random random(seed);
  return random_box(n, [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); });
}

/// Euler characteristic, components, boundary loops of a surface.
struct ModeCounts {
  long euler_characteristic, components, loops;
  friend bool operator==(const ModeCounts&, const ModeCounts&) = default;
};
inline ModeCounts counts_of(const modes::ModeSurface& s) {
  ModeCounts c{static_cast<long>(s.euler_characteristic), static_cast<long>(s.components.size()),
               0};
  for (const auto& part : s.components) c.loops += static_cast<long>(part.boundary_loops);
  return c;
}

/// A field with its counts: of mode 0, and of +mu, -mu for 0.3, 0.6, 0.9.
struct Row {
  const char* name;
  Rows rows;
  ModeCounts neutral;
  ModeCounts pairs[3][2];
};

inline const std::vector<Row>& small_boxes() {
  static const std::vector<Row> rows = {
      {"1",
       rows_of(reference_fields()[0]),
       {2, 2, 2},
       {{{1, 2, 3}, {2, 2, 2}}, {{1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}}}},
      {"2",
       rows_of(reference_fields()[1]),
       {1, 1, 1},
       {{{2, 2, 2}, {1, 2, 3}}, {{2, 2, 2}, {1, 2, 3}}, {{0, 2, 4}, {0, 1, 2}}}},
      {"3",
       rows_of(reference_fields()[2]),
       {-1, 1, 1},
       {{{-1, 1, 1}, {0, 1, 2}}, {{0, 1, 2}, {0, 1, 2}}, {{0, 1, 2}, {0, 1, 2}}}},
      {"4",
       rows_of(reference_fields()[3]),
       {-1, 1, 3},
       {{{-1, 1, 3}, {-1, 1, 3}}, {{0, 1, 2}, {-1, 1, 3}}, {{1, 2, 3}, {-1, 1, 3}}}},
      {"5",
       rows_of(reference_fields()[4]),
       {0, 1, 2},
       {{{0, 1, 2}, {-1, 1, 3}}, {{0, 1, 2}, {-1, 1, 3}}, {{0, 1, 2}, {0, 1, 2}}}},
      {"6",
       rows_of(reference_fields()[5]),
       {1, 1, 1},
       {{{2, 2, 2}, {1, 1, 1}}, {{2, 2, 2}, {1, 1, 1}}, {{1, 2, 3}, {-1, 1, 3}}}}};
  return rows;
}

/// The first three in a box of half width 60.
inline const std::vector<Row>& large_boxes() {
  static const std::vector<Row> rows = {
      {"1",
       small_boxes()[0].rows,
       {-1, 1, 3},
       {{{0, 1, 2}, {0, 1, 2}}, {{1, 2, 3}, {-1, 1, 3}}, {{0, 2, 4}, {0, 2, 4}}}},
      {"2",
       small_boxes()[1].rows,
       {-1, 1, 1},
       {{{-1, 1, 3}, {1, 2, 3}}, {{-1, 1, 3}, {1, 2, 3}}, {{-1, 1, 3}, {1, 2, 3}}}},
      {"3",
       small_boxes()[2].rows,
       {-1, 1, 1},
       {{{-1, 1, 1}, {-1, 1, 1}}, {{-1, 1, 1}, {-1, 1, 1}}, {{-1, 1, 3}, {-1, 1, 3}}}}};
  return rows;
}

/// Also with xy and z^2.
inline const std::vector<Rows>& piecewise_linear() {
  static const std::vector<Rows> fields = {{{-1, -4, 0, 4, -6},
                                            {-5, 2, -5, -1, 3},
                                            {-6, 2, -3, -6, -5},
                                            {0, 0, -5, -3, -5},
                                            {2, 0, -6, 3, -5},
                                            {-3, 4, 4, 3, -6}},
                                           {{-3, -1, 0, -4, -3},
                                            {5, -6, -5, -4, -3},
                                            {6, 2, -3, 0, 4},
                                            {-6, 1, 1, 1, 0},
                                            {1, 3, -3, 0, -5},
                                            {1, -3, 6, -6, 5}}};
  return fields;
}

}  // namespace crest::tests
