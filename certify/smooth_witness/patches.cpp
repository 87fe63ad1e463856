// SPDX-License-Identifier: GPL-3.0-or-later
// Patches: the order, Y, the heights' signs, sectors and intervals.
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/patch.hpp"
#include "certify/smooth_witness/loop.hpp"
#include "certify/smooth_witness/parts.hpp"

namespace crest::certify::witness {
namespace {

using namespace smooth;

/// With one model type.
template <class M>
class PatchRecorder {
 public:
  PatchRecorder(const Surface& surface, SmoothPatchRecord& patch, double sign, double reach)
      : patch_(patch), prover_(surface, patch, sign, reach) {}

  /// Appends the intervals. False: undecided.
  bool record(Bytes& out) {
    const auto d = prover_.derivative();
    if (!d) return false;
    const double a = middle((*d)[0]), b = middle((*d)[1]), c = middle((*d)[2]), e = middle((*d)[3]),
                 det = a * e - b * c;
    patch_.krawczyk = {e / det, -b / det, -c / det, a / det};
    for (double& x : patch_.krawczyk) {
      x += 0.0;
      if (!std::isfinite(x)) return false;
    }
    if (!prover_.has_umbilic()) return false;
    for (int side = 0; side < 4; ++side)
      for (int k = 0; k < 4; ++k)
        if (!divide({side, -1 + k * 0.5, -0.5 + k * 0.5}, 0, 3, out)) return false;
    return true;
  }

 private:
  /// New enclosures at every kSectorStep-th depth up to kSectorDepth.
  static constexpr int kSectorStep = 3, kSectorDepth = 6, kDepth = 12;

  bool divide(const RayInterval& t, int depth, unsigned open, Bytes& out) {
    const std::size_t above = prover_.sector();
    unsigned node = 0, w = 0;
    if (depth <= kSectorDepth && depth % kSectorStep == 0) {
      const auto p = prover_.shape_along(t);
      w = direction_near(middle(p[0]), middle(p[1]), middle(p[2]));
      node = prover_.add_sector(t, w) ? 1 : 0;
    }
    const auto f = prover_.interval(t);
    std::array<double, 2> combination{};
    bool running = false;
    unsigned left = open;
    for (std::size_t j = 0; j < 2; ++j) {
      unsigned code = (open >> j & 1U) != 0 ? kOpen : kSaidAbove;
      if (code == kOpen && f && prover_.free_sign(*f, j) != 0) code = kFree;
      if (code == kOpen && f) {
        if (!running) combination = combination_of(*f);
        if (prover_.running_sign(*f, j, combination) != 0) {
          code = kRunning;
          running = true;
        }
      }
      if (code != kOpen) left &= ~(1U << j);
      node |= code << (1 + 2 * j);
    }
    out.push_back(static_cast<std::uint8_t>(node));
    if ((node & 1U) != 0) out.push_back(static_cast<std::uint8_t>(w));
    for (std::size_t k = 0; running && k < 2; ++k) put_f32(out, combination[k]);
    if (left != 0) {
      if (depth == kDepth) return false;
      for (const bool second : {false, true})
        if (!divide(t.half(second), depth + 1, left, out)) return false;
    }
    prover_.use_sector(above);
    return true;
  }

  std::array<double, 2> combination_of(const typename PatchProver<M>::Forms2& f) const {
    std::array<kernel::Range, 2> e{};
    for (std::size_t j = 0; j < 2; ++j) {
      const auto a = f[0].e[j].value().range(), b = f[1].e[j].value().range();
      e[j] = {std::fmin(a.low, b.low), std::fmax(a.high, b.high)};
    }
    return combinations(e)[0];
  }

  SmoothPatchRecord& patch_;
  PatchProver<M> prover_;
};

void record(const Claim& claim, RidgesSmoothCertificate& c, std::size_t number) {
  SmoothPatchRecord& patch = c.patches[number];
  double sign = 1;
  Bytes sides;
  if (claim.surface.implicit) {
    const GraphBox b = graph_box(patch);
    BoxProver<kernel::Interval> prover(claim.surface);
    constexpr int kDepth = 9;
    if (!record_box(prover, b.below, nullptr, 3, kDepth, sides) ||
        !record_box(prover, b.above, nullptr, 3, kDepth, sides) ||
        !record_box(prover, b.all, &b.axis, 3, kDepth, sides))
      throw Undecided(fmt::format("patch {}: S as a graph", number));
    Box corner = b.all;
    corner.high = corner.low;
    if (prover.on_box(corner, &b.axis) == kernel::Sign::negative) sign = -1;
  }
  const std::uint8_t reach = patch.reach;
  for (const std::uint8_t order : {std::uint8_t{3}, std::uint8_t{5}})
    for (int longer = 0; longer < (claim.surface.implicit ? 3 : 1) && longer <= reach; ++longer) {
      patch.order = order;
      patch.reach = static_cast<std::uint8_t>(reach - longer);
      patch.witness = sides;
      const double h = std::ldexp(1.0, c.reach - int{patch.reach});
      if (order == 3 ? PatchRecorder<Model3>(claim.surface, patch, sign, h).record(patch.witness)
                     : PatchRecorder<Model5>(claim.surface, patch, sign, h).record(patch.witness))
        return;
    }
  throw Undecided(fmt::format("patch {}: the umbilic", number));
}

}  // namespace

void record_patches(const Claim& claim, RidgesSmoothCertificate& c) {
  for_all(
      c.patches.size(), [] { return 0; }, [&](int, std::size_t p) { record(claim, c, p); });
}

}  // namespace crest::certify::witness
