// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/witnesses.hpp"

#include <algorithm>

#include "algorithms/vector_fields/starts.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::vector_fields {

using kernel::dot;
using kernel::Sign;
using kernel::operator-;

namespace {

constexpr std::size_t kMostVertices = 16;  ///< tried at one place

class WitnessFinder {
 public:
  WitnessFinder(const Surroundings& around, std::vector<Trace>& traces,
                std::vector<Annulus>& annuli)
      : around_(around), traces_(traces), annuli_(annuli) {}

  std::vector<Witness> run() {
    for (Index z = 0; z < around_.zeros.size(); ++z) stand_at_zero(z);
    for (std::size_t i = 0; i < around_.boundary.loops.size(); ++i) stand_at_loop(i);
    // Witnesses may find more of them.
    for (Index i = 0; i < annuli_.size(); ++i)
      for (const Index side : {0U, 1U}) stand_at_orbit(i, side);
    return std::move(witnesses_);
  }
  /// The line's trace; what it finds joins the annuli.
  Trace follow(const Witness& w) {
    const Domain& domain = around_.domain;
    Start start = start_at_vertex(domain, domain.fan(w.leaving), w.forward);
    start.from_vertex = true;
    start.origin = domain.from(w.leaving);
    AnnulusNotes notes;
    notes.known = annuli_;
    Trace result = std::move(trace(around_, start, notes).back());
    std::move(notes.found.begin(), notes.found.end(), std::back_inserter(annuli_));
    result.gates = {};
    return result;
  }

 private:
  template <class Ends>
  bool stands(const Ends& ends) const {
    return std::any_of(traces_.begin(), traces_.end(), ends);
  }
  /// Both directions from an inner vertex, one of which ends as it should.
  template <class Ends>
  bool stand(HalfEdge leaving, bool forward, const Ends& ends) {
    const Domain& domain = around_.domain;
    if (domain.is_zero(domain.from(leaving)) || !domain.fan(leaving).closed) return false;
    Trace there = follow({leaving, forward});
    if (!ends(there)) return false;
    Trace back = follow({leaving, !forward});
    if (back.end == EndKind::undecided) return false;
    add({leaving, forward}, std::move(there));
    add({leaving, !forward}, std::move(back));
    return true;
  }
  void add(const Witness& w, Trace&& trace) {
    witnesses_.push_back(w);
    traces_.push_back(std::move(trace));
  }

  void stand_at_zero(Index z) {
    const CriticalPoint& item = around_.zeros[z].item;
    if (item.where != ZeroPlace::triangle ||
        (item.kind != ZeroKind::sink && item.kind != ZeroKind::source))
      return;
    const auto ends = [&](const Trace& t) {
      return t.end == EndKind::critical_point && t.target == z;
    };
    if (stands(ends)) return;
    for (HalfEdge h = 3 * item.simplex; h < 3 * item.simplex + 3; ++h)
      if (stand(h, item.kind == ZeroKind::sink, ends)) return;
  }
  void stand_at_loop(std::size_t i) {
    const BoundaryLoop& loop = around_.boundary.loops[i];
    const auto& sides = around_.boundary.half_edges[i];
    const auto at = around_.boundary.regions.find(sides.front());
    if (loop.inflow + loop.outflow != 1 || loop.tangent + loop.zero > 0 ||
        at == around_.boundary.regions.end() || stands([&](const Trace& t) {
          return t.end == EndKind::boundary && t.target == at->second.at_from;
        }))
      return;
    for (std::size_t k = 0; k < std::min(sides.size(), kMostVertices); ++k) {
      const Witness w{sides[k], loop.inflow == 1};
      Trace trace = follow(w);
      if (trace.end != EndKind::undecided) return add(w, std::move(trace));
    }
  }
  void stand_at_orbit(Index i, Index side) {
    const auto ends = [&](const Trace& t) {
      return t.end == EndKind::closed_orbit && t.target == i &&
             side_of(around_.domain, annuli_[i], t) == side;
    };
    if (stands(ends)) return;
    const bool forward = annuli_[i].forward;
    for (const HalfEdge h : corners_along(annuli_[i]))
      if (stand(h, forward, ends)) return;
  }
  /// Of the triangles that an annulus crosses: half-edges that leave different vertices.
  std::vector<HalfEdge> corners_along(const Annulus& a) const {
    const Domain& domain = around_.domain;
    std::vector<HalfEdge> result;
    HalfEdge entry = a.side;
    for (std::size_t k = 0; k < a.turns.size() && result.size() < kMostVertices; ++k) {
      for (HalfEdge h = 3 * (entry / 3); h < 3 * (entry / 3) + 3; ++h)
        if (std::none_of(result.begin(), result.end(),
                         [&](HalfEdge g) { return domain.from(g) == domain.from(h); }))
          result.push_back(h);
      entry = domain.twin(3 * (entry / 3) + (entry % 3 + a.turns[k] + 1) % 3);
    }
    return result;
  }

  const Surroundings& around_;
  std::vector<Trace>& traces_;
  std::vector<Annulus>& annuli_;
  std::vector<Witness> witnesses_;
};

}  // namespace

std::optional<Index> side_of(const Domain& domain, const Annulus& annulus, const Trace& trace) {
  const Vec2 p = domain.point(domain.from(annulus.side));
  const Vec2 e = domain.point(domain.to(annulus.side)) - p;
  const double s = dot(trace.line.back() - p, e) / dot(e, e);
  const auto from_tail = [](double x) { return x > 0 ? x : 1 + x; };
  if (s <= from_tail(annulus.back_left)) return 0;
  if (s >= from_tail(annulus.back_right)) return 1;
  return std::nullopt;
}

std::vector<Witness> find_witnesses(const Surroundings& around, std::vector<Trace>& traces,
                                    std::vector<Annulus>& annuli) {
  return WitnessFinder(around, traces, annuli).run();
}

void follow_witnesses(const Surroundings& around, const std::vector<Witness>& witnesses,
                      std::vector<Trace>& traces, std::vector<Annulus>& annuli) {
  WitnessFinder finder(around, traces, annuli);
  for (const Witness& w : witnesses) {
    kernel::stop_point();
    traces.push_back(finder.follow(w));
  }
}

}  // namespace crest::vector_fields
