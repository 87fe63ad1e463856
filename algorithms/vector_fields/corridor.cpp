// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/corridor.hpp"

#include <span>

#include "algorithms/vector_fields/reals.hpp"

namespace crest::vector_fields {

namespace {

/// Angles relative to the precision's own and pieces 2^-shrink times as long, as they are tried.
struct Variant {
  int angle, shrink;
};
constexpr Variant kVariants[] = {{0, 0}, {-6, 0}, {-6, 1}, {-6, 2}, {-6, 3}, {-10, 0}, {-10, 2}};
constexpr std::size_t kQuickVariants = 3;
/// Where the line creeps: next to a saddle whose matrix is far from normal.
constexpr Variant kLongPieces[] = {{0, 0}, {-6, -4}, {-6, -3}, {-6, -2}, {-6, -1}};

/// Both arcs at one setting; nothing if one fails.
template <class Real>
std::optional<std::array<ArcEnd<Real>, 2>> two_arcs(BarrierMaker<Real>& maker, bool forward,
                                                    Index t, const ArcStart<Real>& left,
                                                    const ArcStart<Real>& right,
                                                    const TrapShape* trap) {
  const TriangleFrame<Real> frame(maker.domain(), t, left.origin, forward, maker.unit());
  const auto l = maker.arc(frame, left.x, left.y, true, left.entry, trap);
  if (!l) return std::nullopt;
  const auto go = [&](const TriangleFrame<Real>& f) {
    return maker.arc(f, right.x, right.y, false, right.entry, trap);
  };
  const auto r =
      right.origin == left.origin
          ? go(frame)
          : go(TriangleFrame<Real>(maker.domain(), t, right.origin, forward, maker.unit()));
  if (!r) return std::nullopt;
  return std::array<ArcEnd<Real>, 2>{*l, *r};
}

}  // namespace

template <class Real>
CellResult<Real> cross_cell(BarrierMaker<Real>& maker, bool forward, Index t, int c,
                            const ArcStart<Real>& left, const ArcStart<Real>& right,
                            const TrapShape* trap) {
  CellResult<Real> result;
  const BarrierSetting own = maker.setting();
  std::span<const Variant> variants = kVariants;
  if (maker.quick()) variants = variants.first(kQuickVariants);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    maker.set(own.angle + variants[i].angle, variants[i].shrink);
    const auto ends = two_arcs(maker, forward, t, left, right, trap);
    if (!ends) {
      if (maker.exhausted() && maker.quick()) break;
      if (variants.data() == kVariants && maker.exhausted()) {
        variants = kLongPieces;
        i = 0;
      }
      continue;
    }
    const auto& [l, r] = *ends;
    result.setting = maker.setting();
    result.special = i > 0;
    if (l.side != r.side) {
      result.divided = true;
      break;
    }
    if (l.side < 0) {
      result.end = CellEnd::trapped;
      break;
    }
    const HalfEdge side = 3 * t + static_cast<Index>(l.side), twin = maker.domain().twin(side);
    // Leaving, left is nearer to the head of the triangle's own side.
    if (!nearer_to_tail(r.t, l.t)) break;
    result.turn = static_cast<std::uint8_t>((l.side - c + 5) % 3);
    if (twin == kNone) {
      result.end = CellEnd::left_domain;
      result.gate = {side, l.t, r.t};
    } else {
      result.end = CellEnd::crossed;
      result.gate = {twin, from_other_side(l.t), from_other_side(r.t)};
    }
    break;
  }
  maker.set(own.angle, own.shrink);
  return result;
}

template CellResult<double> cross_cell(BarrierMaker<double>&, bool, Index, int,
                                       const ArcStart<double>&, const ArcStart<double>&,
                                       const TrapShape*);
template CellResult<DoubleDouble> cross_cell(BarrierMaker<DoubleDouble>&, bool, Index, int,
                                             const ArcStart<DoubleDouble>&,
                                             const ArcStart<DoubleDouble>&, const TrapShape*);
template CellResult<Real133> cross_cell(BarrierMaker<Real133>&, bool, Index, int,
                                        const ArcStart<Real133>&, const ArcStart<Real133>&,
                                        const TrapShape*);
template CellResult<Real332> cross_cell(BarrierMaker<Real332>&, bool, Index, int,
                                        const ArcStart<Real332>&, const ArcStart<Real332>&,
                                        const TrapShape*);
template CellResult<Real1000> cross_cell(BarrierMaker<Real1000>&, bool, Index, int,
                                         const ArcStart<Real1000>&, const ArcStart<Real1000>&,
                                         const TrapShape*);

}  // namespace crest::vector_fields
