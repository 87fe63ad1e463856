// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/patches.hpp"

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/box_pairs.hpp"
#include "certify/ridges_smooth/patch.hpp"

namespace crest::certify::smooth {
namespace {

using kernel::Rational;
using kernel::Sign;
using u32 = std::uint32_t;
using Ranges = std::array<kernel::Range, 3>;

/// |x - centre| < R - 2 rho, exactly.
bool is_near(const SmoothPatchRecord& p, std::size_t d, const Rational& x) {
  const Rational off = abs(Rational(x - Rational(p.centre[d])));
  return off < Rational(p.radius) - 2 * Rational(p.rho);
}

class PatchChecker {
 public:
  explicit PatchChecker(const Claim& claim) : claim_(claim) {}

  /// Returns an enclosure of the umbilic: kind 0 in x, y, z; kind 1 of the coordinates.
  Ranges check(u32 number) {
    const SmoothPatchRecord& p = claim_.certificate.patches[number];
    number_ = number;
    require(p.rho > 0 && 2 * p.rho < p.radius && p.radius < 0x1p500, "patch {}: rho and R", number);
    for (const auto n : p.branches) require(n == 1 || n == 3, "patch {}: {} branches", number, n);
    WitnessReader in(p.witness, "patch", number);
    double sign = 1;
    if (claim_.surface.implicit) {
      sign = check_graph(p, in);
    } else {
      check_square(p);
      for (const u32 f : p.faces) check_face(p, f);
    }
    if (claim_.arithmetic == Arithmetic::mpfr)
      return p.order == 3 ? check_umbilic<MpModel3>(p, sign, in)
                          : check_umbilic<MpModel5>(p, sign, in);
    return p.order == 3 ? check_umbilic<Model3>(p, sign, in) : check_umbilic<Model5>(p, sign, in);
  }

 private:
  /// Kind 1: Q is where X is defined.
  void check_square(const SmoothPatchRecord& p) {
    for (std::size_t d = 0; d < 2; ++d) {
      const Rational z(p.centre[d]), r(p.radius);
      if (claim_.surface.periodic[d])
        require(p.radius < 0.5 && std::fabs(p.centre[d]) < 4, "patch {}: too wide", number_);
      else
        require(z - r >= 0 && z + r <= 1, "patch {}: it leaves the domain", number_);
    }
  }

  /// Kind 0: S is a graph over Q between m0 and m1. The sign of F_m.
  double check_graph(const SmoothPatchRecord& p, WitnessReader& in) {
    require(p.height[0] < p.height[1], "patch {}: no height", number_);
    const auto signs = claim_.arithmetic == Arithmetic::mpfr
                           ? signs_of<kernel::MpInterval>(graph_box(p), in)
                           : signs_of<kernel::Interval>(graph_box(p), in);
    require(signs[0] != signs[1], "patch {}: S does not pass between m0 and m1", number_);
    return signs[2] == Sign::positive ? 1 : -1;
  }

  template <class T>
  std::array<Sign, 3> signs_of(const GraphBox& b, WitnessReader& in) {
    BoxProver<T> prover(claim_.surface);
    const Sign below = prover.on_pieces(b.below, nullptr, in);
    const Sign above = prover.on_pieces(b.above, nullptr, in);
    return {below, above, prover.on_pieces(b.all, &b.axis, in)};
  }

  /// Item 1 of kind 1.
  void check_face(const SmoothPatchRecord& p, u32 f) {
    const auto& c = claim_.certificate;
    for (std::size_t d = 0; d < 2; ++d) {
      const auto at = [&](std::size_t i) {
        return Rational(c.vertices[c.faces[f][i]][d]) + lift_of(c, f, i, d);
      };
      const double shift =
          claim_.surface.periodic[d]
              ? std::nearbyint(p.centre[d] - c.vertices[c.faces[f][0]][d] - lift_of(c, f, 0, d))
              : 0;
      for (std::size_t i = 0; i < 3; ++i)
        require(is_near(p, d, at(i) + Rational(shift)), "patch {}: face {} is not inside", number_,
                f);
    }
  }

  /// Items 2, 4, 5.
  template <class M>
  Ranges check_umbilic(const SmoothPatchRecord& p, double sign, WitnessReader& in) {
    PatchProver<M> prover(claim_.surface, p, sign,
                          std::ldexp(1.0, claim_.certificate.reach - int{p.reach}));
    if (!prover.has_umbilic()) in.fail("the umbilic");
    const auto index = prover.index();
    if (!nonzero(index)) in.fail("the index");
    require_equal(p.twice_index, static_cast<int>(*index), "patch: twice the index");
    kernel::Range height{0, 0};
    if (claim_.surface.implicit) {
      const auto found = prover.height();
      if (!found) in.fail("the umbilic's height");
      height = *found;
    }
    const auto branches = prover.branches(in);
    for (std::size_t j = 0; j < 2; ++j)
      require_equal(p.branches[j], branches[j],
                    j == 0 ? "patch: blue branches" : "patch: red branches");
    return enclosure(p, height);
  }

  Ranges enclosure(const SmoothPatchRecord& p, const kernel::Range& height) const {
    Ranges r{};
    for (std::size_t d = 0; d < 2; ++d) {
      const double off = p.rho + (std::fabs(p.centre[d]) + p.rho) * 0x1p-51;
      r[claim_.surface.implicit ? (p.axis + 1 + d) % 3 : d] = {p.centre[d] - off,
                                                               p.centre[d] + off};
    }
    if (claim_.surface.implicit) r[p.axis] = height;
    return r;
  }

  const Claim& claim_;
  u32 number_ = 0;
};

/// Item 3. Kind 1 modulo 1: with copies moved by 1, a little wider than rounding makes them.
void check_apart(const Surface& surface, const std::vector<Ranges>& umbilics) {
  std::vector<Ranges> copies = umbilics;
  for (std::size_t d = 0; d < 2 && !surface.implicit; ++d) {
    if (!surface.periodic[d]) continue;
    for (Ranges& r : copies) {
      const double shift = std::floor(r[d].low);  // below 4
      r[d] = {r[d].low - shift - 0x1p-48, r[d].high - shift + 0x1p-48};
    }
    const std::size_t count = copies.size();
    for (std::size_t i = 0; i < count; ++i) {
      copies.push_back(copies[i]);
      copies.back()[d] = {copies[i][d].low + 1, copies[i][d].high + 1};
    }
  }
  // Each box meets itself; copies of one umbilic do not meet, as they are less than 1 wide.
  for (const auto& [i, k] : meeting_boxes(copies, copies, 2 * copies.size())) {
    const std::size_t a = i % umbilics.size(), b = k % umbilics.size();
    require(i == k, "patches {} and {}: their umbilics may be one", std::min(a, b), std::max(a, b));
  }
}

}  // namespace

GraphBox graph_box(const SmoothPatchRecord& p) {
  GraphBox b{};
  const std::size_t m = p.axis, axes[2] = {(m + 1) % 3, (m + 2) % 3};
  for (std::size_t d = 0; d < 2; ++d) {
    // More than Q, by more than what rounding adds to the pieces of PatchProver.
    const double wide =
        p.radius + (std::fabs(p.centre[0]) + std::fabs(p.centre[1]) + p.radius) * 0x1p-48;
    b.all.low[axes[d]] = p.centre[d] - wide;
    b.all.high[axes[d]] = p.centre[d] + wide;
  }
  b.all.low[m] = p.height[0];
  b.all.high[m] = p.height[1];
  b.axis[m] = 1;
  b.below = b.above = b.all;
  b.below.high[m] = p.height[0];
  b.above.low[m] = p.height[1];
  return b;
}

void check_patches(const Claim& claim) {
  const auto& patches = claim.certificate.patches;
  std::vector<Ranges> umbilics(patches.size());
  parallel_for(
      patches.size(), [&] { return PatchChecker(claim); },
      [&](PatchChecker& checker, std::size_t i) {
        umbilics[i] = checker.check(static_cast<u32>(i));
      });
  check_apart(claim.surface, umbilics);
}

}  // namespace crest::certify::smooth
