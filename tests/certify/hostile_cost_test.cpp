// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates made to cost the checker more than n log n.
#include <catch2/catch.hpp>
#include <ctime>

#include "certify/reeb/encode.hpp"
#include "certify/verify.hpp"

using namespace crest::certify;

namespace {

using u32 = std::uint32_t;

double seconds_to_verify(const ReebCertificate& c, const std::string& words) {
  const Bytes bytes = encode(c);
  const std::clock_t start = std::clock();
  const Verdict verdict = verify(bytes);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  INFO(verdict.reason);
  CHECK(verdict.accepted == words.empty());
  CHECK(verdict.reason.find(words) == 0);
  return seconds;
}

/// A double pyramid over a ring of 2 k vertices, low and high in turns: both tips are saddles, the
/// upper one with an arc to each of the k maxima.
ReebCertificate star(u32 k, bool cut_all) {
  ReebCertificate c;
  c.values = {0, 0.5};
  for (u32 i = 0; i < 2 * k; ++i) {
    const u32 a = 2 + i, b = 2 + (i + 1) % (2 * k);
    c.faces.push_back({0, a, b});
    c.faces.push_back({1, b, a});
    c.values.push_back(i % 2 ? 1 : -1);
  }
  c.positions.resize(c.values.size());
  for (u32 i = 0; i < k; ++i) c.order.push_back(2 + 2 * i);
  c.order.insert(c.order.end(), {0, 1});
  for (u32 i = 0; i < k; ++i) c.order.push_back(3 + 2 * i);
  c.critical_nodes = c.order;
  for (u32 i = 0; i < k; ++i) c.arcs.push_back({i, k});
  for (u32 i = 0; i <= k; ++i) c.arcs.push_back({i == 0 ? k : k + 1, k + 1 + i});
  for (u32 i = 0; cut_all && i < k; ++i) c.cuts.push_back({k + 1 + i, 3 + 2 * i});
  c.euler_characteristic = 2;
  c.components = 1;
  c.tiles = 4 * k;
  c.minima = c.maxima = k;
  c.saddles = 2 * (k - 1);
  c.contracted_nodes = 2 * k + 2;
  return c;
}

/// Over a ring that rises by steps, with a bump at each: every saddle's arc to the next has a
/// contour all around. The first `cuts` of these arcs are cut.
ReebCertificate stairs(u32 steps, u32 cuts) {
  ReebCertificate c;
  const auto ring = [](u32 i) { return 2 + i; };
  const auto bump = [&](u32 i) { return 2 + steps + i; };
  c.values.resize(1 + 2 * steps);
  c.values[0] = -1;
  c.values[1] = steps + 1;
  c.order = {0, ring(0)};
  c.critical_nodes = {0};
  c.arcs = {{0, 1}};
  for (u32 i = 0; i < steps; ++i) {
    const u32 a = ring(i), b = ring((i + 1) % steps), m = bump(i), at = 2 * i - 1;
    c.values[a] = i;
    c.faces.push_back({1, b, a});
    if (i + 1 < steps) {
      c.values[m] = i + 1.5;
      c.faces.insert(c.faces.end(), {{0, a, m}, {a, b, m}, {b, 0, m}});
    } else {
      c.faces.push_back({0, a, b});
    }
    if (i == 0) continue;
    for (auto* list : {&c.order, &c.critical_nodes}) list->insert(list->end(), {a, bump(i - 1)});
    c.arcs.insert(c.arcs.end(), {{at, at + 1}, {at, at + 2}});
    if (i <= cuts) c.cuts.push_back({2 * i, 1});
  }
  for (auto* list : {&c.order, &c.critical_nodes}) list->push_back(1);
  c.positions.resize(c.values.size());
  c.euler_characteristic = 2;
  c.components = c.minima = 1;
  c.tiles = static_cast<u32>(c.faces.size());
  c.saddles = steps - 1;
  c.maxima = steps;
  c.contracted_nodes = 2 * steps;
  return c;
}

}  // namespace

TEST_CASE("cuts along long contours do not cost the square of the mesh") {
  seconds_to_verify(stairs(5, 0), "");
  seconds_to_verify(stairs(5, 4), "");
  seconds_to_verify(stairs(20000, 20), "");
  CHECK(seconds_to_verify(stairs(20000, 19999), "cuts: they cross more than 4194304 edges") <
        10 * seconds_to_verify(stairs(20000, 20), "") + 0.5);  // the square: 100 times
}

TEST_CASE("a cut for every arc at one vertex costs no more than its edges") {
  CHECK(seconds_to_verify(star(40000, true), "") <
        10 * seconds_to_verify(star(40000, false), "") + 0.5);  // the square: over 100 times
}
