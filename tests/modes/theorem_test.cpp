// SPDX-License-Identifier: GPL-3.0-or-later
// Theorem A: in a box so large that it ends at infinity both levels together have the Euler
// characteristic 0 above mu*, -2 below, the neutral surface -1.
#include "algorithms/modes/theorem_a.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <optional>

#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using modes::Level;

namespace {

long euler_characteristic(const modes::ModeField& field, const Level& level) {
  const auto r = modes::extract(field, level);
  CHECK(r.undecided.empty());
  long sum = 0;
  for (const auto& s : r.surfaces) {
    sum += counts_of(s).euler_characteristic;
    CHECK(s.watertight);
    for (const auto& c : s.components) CHECK(c.orientable);
  }
  return sum;
}

Rows random_rows(Random& random) {
  Rows rows(4);
  for (auto& row : rows)
    for (int& x : row) x = static_cast<int>(random() % 13) - 6;
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

}  // namespace

TEST_CASE("theorem A holds for random fields in large boxes") {
  Random random(kSeed + 70);
  for (std::uint64_t i = 0; i < scaled(50); ++i) {
    const Rows rows = random_rows(random);
    const auto critical = critical_mode(rows);
    if (!critical || *critical < 0.02 || *critical > 0.98) continue;
    // Beyond the coefficients by far: what is outside looks like the linear part alone.
    const auto field = box(rows, 1 << 16, 2, Cut::diagonal);
    const auto below = static_cast<std::int64_t>(800 * *critical),
               above = static_cast<std::int64_t>(1000 - 600 * (1 - *critical));
    INFO("field " << i << ", mu* " << *critical);
    CHECK(euler_characteristic(field, {0, 1}) == -1);
    CHECK(euler_characteristic(field, {below / std::gcd(below, std::int64_t{1000}),
                                       1000 / std::gcd(below, std::int64_t{1000})}) == -2);
    CHECK(euler_characteristic(field, {above / std::gcd(above, std::int64_t{1000}),
                                       1000 / std::gcd(above, std::int64_t{1000})}) == 0);
  }
}
