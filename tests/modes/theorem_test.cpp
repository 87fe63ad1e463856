// SPDX-License-Identifier: GPL-3.0-or-later
// Theorem A: in a box so large that it ends at infinity both levels together have the Euler
// characteristic 0 above mu*, -2 below, the neutral surface -1.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <optional>

#include "algorithms/modes/degenerate_exact.hpp"
#include "algorithms/modes/theorem_a.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using modes::Level;

namespace {

/// Nothing: some cells are undecided.
std::optional<long> decided_characteristic(const modes::ModeField& field, const Level& level) {
  const auto r = modes::extract(field, level);
  if (!r.undecided.empty()) return std::nullopt;
  long sum = 0;
  for (const auto& s : r.surfaces) {
    sum += counts_of(s).euler_characteristic;
    CHECK(s.watertight);
    for (const auto& c : s.components) CHECK(c.orientable);
  }
  return sum;
}

long euler_characteristic(const modes::ModeField& field, const Level& level) {
  const auto sum = decided_characteristic(field, level);
  REQUIRE(sum);
  return *sum;
}

/// About [-2^16, 2^16]^3, the cubes small near the origin: beyond the coefficients by far, so that
/// what is outside looks like the linear part alone.
modes::ModeField large_box(const Rows& rows) {
  // No planes of symmetry: a neutral surface may touch a face there.
  constexpr double places[] = {-65536.25, -2049.6875, -63.140625, -2.171875,
                               1.859375,  61.78125,   2050.5625,  65533.75};
  const auto grid = box(rows, 3.5, 8, Cut::diagonal);
  std::vector<kernel::Vec3> points = grid.mesh.points();
  std::vector<std::array<double, 6>> tensors;
  for (auto& p : points) {
    for (double& x : p) x = places[static_cast<std::size_t>(std::lround(x + 3.5))];
    tensors.push_back(value_at(rows, p));
  }
  return {kernel::TetMesh(std::move(points), grid.mesh.tets()), std::move(tensors)};
}

Level level_of(std::int64_t thousandths) {
  const std::int64_t divisor = std::gcd(thousandths, std::int64_t{1000});
  return {thousandths / divisor, 1000 / divisor};
}

/// Entries of many digits: small ones make tangencies, and singular curves at infinity.
Rows random_rows(Random& random) {
  Rows rows(4);
  for (auto& row : rows)
    for (int& x : row) x = static_cast<int>(random() % 20001) - 10000;
  return rows;
}

/// mu*; nothing if the tensors are dependent.
std::optional<double> critical_mode(const Rows& rows) {
  std::array<std::array<double, 6>, 4> t;
  const kernel::Vec3 corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t k = 0; k < 4; ++k) t[k] = value_at(rows, corners[k]);
  const auto c = modes::critical_tensor({&t[0], &t[1], &t[2], &t[3]});
  if (!c) return std::nullopt;
  return std::sqrt(c->squared_mode.convert_to<double>());
}

/// tr(T_i T_j T_k) of the linear part: det there is sum t_ijk x_i x_j x_k / 3.
using Trilinear = std::array<std::array<std::array<std::int64_t, 3>, 3>, 3>;
Trilinear cubic_at_infinity(const Rows& rows) {
  std::array<std::array<std::array<std::int64_t, 3>, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& r = rows[i + 1];
    m[i] = {{{r[0], r[2], r[3]}, {r[2], r[1], r[4]}, {r[3], r[4], -r[0] - r[1]}}};
  }
  Trilinear t{};
  for (std::size_t n = 0; n < 729; ++n) {
    const std::size_t i = n % 3, j = n / 3 % 3, k = n / 9 % 3, a = n / 27 % 3, b = n / 81 % 3,
                      c = n / 243;
    t[i][j][k] += m[i][a][b] * m[j][b][c] * m[k][c][a];
  }
  return t;
}

/// Whether that curve has no singular point, not even a complex one: its three derivatives have no
/// common zero. Their resultant is, but for a factor, the determinant of their coefficients and
/// those of the derivatives of their Jacobian (Sylvester).
bool is_smooth_at_infinity(const Rows& rows) {
  const Trilinear t = cubic_at_infinity(rows);
  // Coefficients of x_i x_j, i <= j.
  const auto place = [](std::size_t i, std::size_t j) { return i == j ? i : i + j + 2; };
  std::array<std::array<kernel::Integer, 6>, 6> matrix{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) matrix[k][place(i, j)] += t[k][i][j];
  constexpr int orders[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
  for (const auto& [p, q, r, sign] : orders)
    for (std::size_t n = 0; n < 27; ++n) {
      const std::size_t i = n % 3, j = n / 3 % 3, k = n / 9;
      const auto at = [](int x) { return static_cast<std::size_t>(x); };
      const kernel::Integer term = sign * t[0][at(p)][i] * t[1][at(q)][j] * t[2][at(r)][k];
      matrix[3 + i][place(j, k)] += term;
      matrix[3 + j][place(i, k)] += term;
      matrix[3 + k][place(i, j)] += term;
    }
  return !modes::determinant<6>(matrix).is_zero();
}

}  // namespace

TEST_CASE("theorem A holds for random fields in large boxes") {
  Random random(kSeed + 70);
  for (std::uint64_t i = 0; i < scaled(50); ++i) {
    const Rows rows = random_rows(random);
    const auto critical = critical_mode(rows);
    if (!critical || *critical < 0.02 || *critical > 0.98) continue;
    const auto field = large_box(rows);
    INFO("field " << i << ", mu* " << *critical);
    CHECK(euler_characteristic(field, {0, 1}) == -1);
    CHECK(euler_characteristic(field, level_of(std::lround(800 * *critical))) == -2);
    CHECK(euler_characteristic(field, level_of(std::lround(400 + 600 * *critical))) == 0);
  }
}

TEST_CASE("theorem A: a node of the curve at infinity changes the count by one") {
  // Euler characteristics: -1 of the closed surface, -1 of a curve with one node; what is left
  // beside the curve has their difference.
  const Rows rows = {{3, -3, -5, -3, 6}, {5, -6, 1, 3, 1}, {6, -2, -6, 1, 5}, {-2, 4, 2, -2, 0}};
  // det of the linear part, and its derivative at (-5, 2, 11): a singular point, exactly.
  const auto det = [&](const kernel::Vec3& x) {
    Rows linear = rows;
    linear[0] = {};
    const auto t = value_at(linear, x);
    return t[0] * (t[1] * t[2] - t[4] * t[4]) - t[3] * (t[3] * t[2] - t[4] * t[5]) +
           t[5] * (t[3] * t[4] - t[1] * t[5]);
  };
  const kernel::Vec3 node = {-5, 2, 11};
  CHECK(det(node) == 0);
  for (std::size_t k = 0; k < 3; ++k) {
    // Of a cubic along a line: four values give the derivative.
    const auto at = [&](double step) {
      kernel::Vec3 x = node;
      x[k] += step;
      return det(x);
    };
    CHECK(8 * (at(1) - at(-1)) - (at(2) - at(-2)) == 0);
  }
  CHECK(!is_smooth_at_infinity(rows));
  CHECK(euler_characteristic(large_box(rows), {0, 1}) == 0);
}

TEST_CASE("theorem A for small integers: only a singular curve at infinity changes the count") {
  Random random(kSeed + 71);
  int decided = 0;
  for (std::uint64_t i = 0; i < scaled(60); ++i) {
    Rows rows(4);
    for (auto& row : rows)
      for (int& x : row) x = static_cast<int>(random() % 7) - 3;
    if (!critical_mode(rows) || !is_smooth_at_infinity(rows)) continue;
    INFO("field " << i);
    const auto sum = decided_characteristic(large_box(rows), {0, 1});
    if (!sum) continue;
    ++decided;
    CHECK(*sum == -1);
  }
  CHECK(decided > 30);
}
