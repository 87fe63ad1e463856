// SPDX-License-Identifier: GPL-3.0-or-later
// Roots, multiplicities, order and signs against CGAL's algebraic kernel, an independent code.
#include <CGAL/CORE_BigInt.h>
// The number type comes first.
#include <CGAL/Algebraic_kernel_d_1.h>

#include <catch2/catch.hpp>

#include "kernel/polynomial/real_roots.hpp"
#include "tests/kernel/polynomials.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

using Peer = CGAL::Algebraic_kernel_d_1<CORE::BigInt>;
using PeerRoots = std::vector<std::pair<Peer::Algebraic_real_1, int>>;

Peer::Polynomial_1 peer_polynomial(const IntegerPolynomial& p) {
  std::vector<CORE::BigInt> c;
  for (const Integer& x : p.coefficients()) c.emplace_back(x.str().c_str());
  return {c.begin(), c.end()};
}
PeerRoots peer_roots(const IntegerPolynomial& p) {
  PeerRoots r;
  Peer().solve_1_object()(peer_polynomial(p), std::back_inserter(r));
  return r;
}

// Every number by its own polynomial and interval, in ours and in the peer's words.
struct Twin {
  AlgebraicNumber ours;
  Peer::Algebraic_real_1 peer;
};

std::string difference(const IntegerPolynomial& p, std::vector<Twin>& twins) {
  const RealRoots ours = real_roots(p);
  const PeerRoots peer = peer_roots(p);
  if (ours.roots.size() != peer.size()) return "number of roots";
  for (std::size_t i = 0; i < peer.size(); ++i) {
    if (ours.roots[i].multiplicity != peer[i].second) return "multiplicity";
    const auto b = ours.roots[i].value.bracket();
    const double x = CGAL::to_double(peer[i].first);
    if (x < b.low - 1e-9 * std::fabs(b.low) || x > b.high + 1e-9 * std::fabs(b.high))
      return "place";
    twins.push_back({ours.roots[i].value, peer[i].first});
  }
  return "";
}

void require_same_order_and_signs(const std::vector<Twin>& twins,
                                  const std::vector<IntegerPolynomial>& polynomials) {
  const Peer peer;
  std::size_t wrong = 0;
  for (const Twin& x : twins) {
    for (const Twin& y : twins)
      wrong += static_cast<int>(compare(x.ours, y.ours)) !=
               static_cast<int>(peer.compare_1_object()(x.peer, y.peer));
    for (const IntegerPolynomial& q : polynomials)
      wrong += static_cast<int>(sign_at(q, x.ours).sign) !=
               static_cast<int>(peer.sign_at_1_object()(peer_polynomial(q), x.peer));
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("polynomials against CGAL: random integers and products") {
  Draw d(800);
  for (std::uint64_t round = 0; round < scaled(12); ++round) {
    std::vector<Twin> twins;
    std::vector<IntegerPolynomial> polynomials;
    for (int i = 0; i < 6; ++i) {
      const IntegerPolynomial p =
          i % 2 == 0 ? draw_product(d) : draw_small(d, d.integer(1, 9), 1000);
      if (p.degree() < 1) continue;
      polynomials.push_back(p);
      CAPTURE(round, i);
      REQUIRE(difference(p, twins) == "");
    }
    require_same_order_and_signs(twins, polynomials);
  }
}

TEST_CASE("polynomials against CGAL: Wilkinson, Mignotte, Chebyshev, clusters") {
  std::vector<Twin> twins;
  const Rational close(1, Integer(1) << 200);
  const std::vector<IntegerPolynomial> polynomials = {
      wilkinson(14),
      mignotte(9, 1000),
      mignotte(8, 1000),
      chebyshev(12),
      with_roots({{Rational(1, 3), 1}, {Rational(1, 3) + close, 1}}) * polynomial({-2, 0, 1}),
      with_roots({{Rational(1, 3), 2}, {1, 1}}) * polynomial({-2 - close, 0, 1})};
  for (const IntegerPolynomial& p : polynomials) REQUIRE(difference(p, twins) == "");
  CHECK(twins.size() == 14 + 3 + 4 + 12 + 4 + 4);
  require_same_order_and_signs(twins, polynomials);
}
