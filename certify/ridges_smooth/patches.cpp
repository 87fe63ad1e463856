// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/patches.hpp"

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/box.hpp"
#include "certify/ridges_smooth/patch.hpp"

namespace crest::certify::smooth {
namespace {

using kernel::Rational;
using kernel::Sign;
using u32 = std::uint32_t;
using Ranges = std::array<kernel::Range, 3>;

constexpr int kDepth = 5;

/// |x - centre| < R - 2 rho, exactly.
bool is_near(const SmoothPatchRecord& p, std::size_t d, const Rational& x) {
  const Rational off = abs(Rational(x - Rational(p.centre[d])));
  return off < Rational(p.radius) - 2 * Rational(p.rho);
}

class PatchChecker {
 public:
  explicit PatchChecker(const Claim& claim) : claim_(claim), provers_(claim) {}

  /// Returns an enclosure of the umbilic: kind 0 in x, y, z; kind 1 of the coordinates.
  Ranges check(u32 number, const std::vector<FaceResult>& faces) {
    const SmoothPatchRecord& p = claim_.certificate.patches[number];
    number_ = number;
    require(p.rho > 0 && 2 * p.rho < p.radius && p.radius < 0x1p500, "patch {}: rho and R", number);
    for (const auto n : p.branches) require(n == 1 || n == 3, "patch {}: {} branches", number, n);
    double sign = 1;
    if (claim_.surface.implicit)
      sign = check_graph(p);
    else
      check_square(p);
    for (const u32 f : p.faces) check_face(p, f, faces[f]);
    kernel::Range height{0, 0};
    const bool proven =
        claim_.arithmetic == Arithmetic::mpfr
            ? check_umbilic<MpModel>(p, sign, height)
            : check_umbilic<Model3>(p, sign, height) || check_umbilic<Model5>(p, sign, height);
    if (!proven) throw Undecided(fmt::format("patch {}: the umbilic", number));
    return enclosure(p, height);
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
  double check_graph(const SmoothPatchRecord& p) {
    require(p.height[0] < p.height[1], "patch {}: no height", number_);
    const std::size_t m = p.axis, axes[2] = {(m + 1) % 3, (m + 2) % 3};
    Box box;
    for (std::size_t d = 0; d < 2; ++d) {
      // More than Q, by more than what rounding adds to the pieces of PatchProver.
      const double wide =
          p.radius + (std::fabs(p.centre[0]) + std::fabs(p.centre[1]) + p.radius) * 0x1p-48;
      box.low[axes[d]] = p.centre[d] - wide;
      box.high[axes[d]] = p.centre[d] + wide;
    }
    box.low[m] = p.height[0];
    box.high[m] = p.height[1];
    std::array<double, 3> axis{};
    axis[m] = 1;
    Box below = box, above = box;
    below.high[m] = box.low[m];
    above.low[m] = box.high[m];
    const auto signs = claim_.arithmetic == Arithmetic::mpfr
                           ? signs_of<kernel::MpInterval>(below, above, box, axis)
                           : signs_of<kernel::Interval>(below, above, box, axis);
    for (const auto& sign : signs)
      if (!nonzero(sign)) throw Undecided(fmt::format("patch {}: S as a graph", number_));
    require(*signs[0] != *signs[1], "patch {}: S does not pass between m0 and m1", number_);
    return *signs[2] == Sign::positive ? 1 : -1;
  }

  template <class T>
  std::array<kernel::MaybeSign, 3> signs_of(const Box& below, const Box& above, const Box& all,
                                            const std::array<double, 3>& axis) {
    BoxProver<T> prover(claim_.surface);
    return {prover.value(below), prover.value(above), prover.slope(all, axis)};
  }

  /// Item 1.
  void check_face(const SmoothPatchRecord& p, u32 f, const FaceResult& result) {
    if (claim_.surface.implicit) {
      if ((result.box && is_inside(p, *result.box)) || is_inside(p, f, Piece::face(), 0)) return;
      throw Undecided(fmt::format("patch {}: face {} is not inside", number_, f));
    }
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

  bool is_inside(const SmoothPatchRecord& p, const Ranges& box) const {
    const std::size_t m = p.axis;
    for (std::size_t d = 0; d < 2; ++d) {
      const kernel::Range& x = box[(m + 1 + d) % 3];
      if (!std::isfinite(x.low) || !std::isfinite(x.high)) return false;
      if (!is_near(p, d, Rational(x.low)) || !is_near(p, d, Rational(x.high))) return false;
    }
    return box[m].low > p.height[0] && box[m].high < p.height[1];
  }
  bool is_inside(const SmoothPatchRecord& p, u32 f, const Piece& piece, int depth) {
    const bool proven = provers_.at_depth(depth, [&](auto& prover) {
      const auto image = prover.image(f, piece, false);
      return image && is_inside(p, {image->x[0].range(), image->x[1].range(), image->x[2].range()});
    });
    if (proven || depth == kDepth) return proven;
    for (std::size_t k = 0; k < 4; ++k)
      if (!is_inside(p, f, piece.child(k), depth + 1)) return false;
    return true;
  }

  /// Items 2, 4, 5. False: not decided with this model type.
  template <class M>
  bool check_umbilic(const SmoothPatchRecord& p, double sign, kernel::Range& height) {
    PatchProver<M> prover(claim_.surface, p, sign);
    if (!prover.has_umbilic()) return false;
    const auto index = prover.index();
    if (!nonzero(index)) return false;
    require_equal(p.twice_index, static_cast<int>(*index), "patch: twice the index");
    if (claim_.surface.implicit) {
      const auto found = prover.height();
      if (!found) return false;
      height = *found;
    }
    const auto branches = prover.branches();
    if (!branches) return false;
    for (std::size_t j = 0; j < 2; ++j)
      require_equal(p.branches[j], (*branches)[j],
                    j == 0 ? "patch: blue branches" : "patch: red branches");
    return true;
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
  FaceProvers provers_;
  u32 number_ = 0;
};

/// Item 3. Kind 1: modulo 1 in periodic directions.
bool are_apart(const Surface& surface, const Ranges& a, const Ranges& b) {
  for (std::size_t d = 0; d < (surface.implicit ? 3 : 2); ++d) {
    if (surface.implicit || !surface.periodic[d]) {
      if (a[d].low > b[d].high || b[d].low > a[d].high) return true;
      continue;
    }
    // The least distance of the two ranges' points, modulo 1; coordinates are below 4.
    const double middle = (a[d].low + a[d].high - b[d].low - b[d].high) / 2;
    const double widths = (a[d].high - a[d].low + b[d].high - b[d].low) / 2;
    if (std::fabs(middle - std::nearbyint(middle)) > widths + 0x1p-48) return true;
  }
  return false;
}

}  // namespace

void check_patches(const Claim& claim, const std::vector<FaceResult>& faces) {
  const auto& patches = claim.certificate.patches;
  std::vector<Ranges> umbilics(patches.size());
  parallel_for(
      patches.size(), [&] { return PatchChecker(claim); },
      [&](PatchChecker& checker, std::size_t i) {
        umbilics[i] = checker.check(static_cast<u32>(i), faces);
      });
  for (std::size_t i = 0; i < umbilics.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      require(are_apart(claim.surface, umbilics[i], umbilics[k]),
              "patches {} and {}: their umbilics may be one", k, i);
}

}  // namespace crest::certify::smooth
