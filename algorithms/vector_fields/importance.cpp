// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/importance.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "algorithms/vector_fields/domain.hpp"
#include "kernel/predicates/turn_in_time.hpp"

namespace crest::vector_fields {

using kernel::MovingPair;
using kernel::Sign;

namespace {

/// A zero crosses a side of a triangle.
struct Event {
  HalfEdge side;
  kernel::QuadraticRoot root;
  double time;
};

/// What happens in a triangle from t = 0 to 1; a zero is inside before every second event.
struct History {
  bool tied = false, inside_at_start = false;
  std::vector<Event> events = {};
  bool inside_before(std::size_t event) const { return inside_at_start == (event % 2 == 0); }
};

class Paths {
 public:
  Paths(const Domain& domain, const std::vector<Vec2>& smooth) : domain_(domain), smooth_(smooth) {}

  /// From a zero inside a triangle; partner: the triangle of the other one.
  ZeroWeight follow(Index t) {
    ZeroWeight path;
    std::size_t next = 0;
    path.first = 0;
    for (bool forward = true;;) {
      const History& h = history(t);
      if (h.tied) break;
      if (forward && next == h.events.size()) {
        path.end = PathEnd::stays;
        path.first = 1;
        return path;
      }
      if (!forward && next == 0) {
        path.end = PathEnd::partner;
        path.partner = t;
        return path;
      }
      const Event& e = h.events[forward ? next : next - 1];
      path.first = std::max(path.first, e.time);
      path.path.push_back({place(e), e.time});
      const HalfEdge side = domain_.twin(e.side);
      if (side == kNone) break;
      t = side / 3;
      const History& beyond = history(t);
      const auto same =
          std::find_if(beyond.events.begin(), beyond.events.end(),
                       [&](const Event& x) { return x.side == side && x.root == e.root; });
      if (beyond.tied || same == beyond.events.end()) break;
      next = static_cast<std::size_t>(same - beyond.events.begin());
      forward = !beyond.inside_before(next);
      if (forward) ++next;
    }
    path.first = 1;
    return path;
  }

 private:
  MovingPair pair(HalfEdge h) const {
    const Index a = domain_.from(h), b = domain_.to(h);
    return {domain_.vector(a), smooth_[a], domain_.vector(b), smooth_[b]};
  }

  Vec2 place(const Event& e) const {
    const Index a = domain_.from(e.side), b = domain_.to(e.side);
    const auto size = [&](Index v) {
      double at[2];
      for (std::size_t k = 0; k < 2; ++k)
        at[k] = (1 - e.time) * domain_.vector(v)[k] + e.time * smooth_[v][k];
      return std::hypot(at[0], at[1]);
    };
    const double s = size(a), share = s + size(b) > 0 ? s / (s + size(b)) : 0.5;
    Vec2 x = domain_.point(a);
    for (std::size_t k = 0; k < 2; ++k) x[k] += share * (domain_.point(b)[k] - x[k]);
    return x;
  }

  const History& history(Index t) {
    const auto [at, fresh] = known_.try_emplace(t);
    if (fresh) at->second = examine(t);
    return at->second;
  }

  History examine(Index t) const {
    History h;
    std::array<Sign, 3> turns{};
    for (HalfEdge side = 3 * t; side < 3 * t + 3; ++side) {
      const MovingPair p = pair(side);
      turns[side % 3] = kernel::vector_turn(p.a0, p.b0);
      const auto times = kernel::opposite_times(p);
      h.tied = h.tied || times.tied;
      for (std::size_t i = 0; i < static_cast<std::size_t>(times.count); ++i)
        h.events.push_back({side, times.roots[i], times.times[i]});
    }
    if (h.tied) return h;
    h.inside_at_start = turns[0] != Sign::zero && turns[0] == turns[1] && turns[1] == turns[2];
    std::sort(h.events.begin(), h.events.end(), [&](const Event& a, const Event& b) {
      const Sign s = kernel::event_order(pair(a.side), a.root, pair(b.side), b.root);
      if (s == Sign::zero && (a.side != b.side || a.root != b.root)) h.tied = true;
      return s == Sign::negative;
    });
    return h;
  }

  const Domain& domain_;
  const std::vector<Vec2>& smooth_;
  std::unordered_map<Index, History> known_;
};

/// Weights rise until the rules hold.
void make_consistent(const Skeleton& skeleton, Importance& w) {
  std::vector<std::vector<Index>> from(w.zeros.size());
  std::vector<Index> work;
  const auto raise = [&](Index zero, double weight) {
    if (w.zeros[zero].weight >= weight) return;
    w.zeros[zero].weight = weight;
    work.push_back(zero);
  };
  const auto arrive = [&](Index line) {
    const Separatrix& s = skeleton.separatrices[line];
    if (s.end == EndKind::critical_point) raise(s.target, w.separatrices[line]);
  };
  for (Index i = 0; i < skeleton.separatrices.size(); ++i) {
    const Separatrix& s = skeleton.separatrices[i];
    if (!s.from_switch_point) from[s.origin].push_back(i);
    w.separatrices.push_back(s.from_switch_point ? 1 : 0);
  }
  for (Index z = 0; z < w.zeros.size(); ++z) {
    w.zeros[z].weight = w.zeros[z].first;
    work.push_back(z);
  }
  for (Index i = 0; i < skeleton.separatrices.size(); ++i) arrive(i);
  while (!work.empty()) {
    const Index z = work.back();
    work.pop_back();
    const double weight = w.zeros[z].weight;
    if (w.zeros[z].partner != kNone) raise(w.zeros[z].partner, weight);
    for (const Index line : from[z]) {
      w.separatrices[line] = std::max(w.separatrices[line], weight);
      arrive(line);
    }
  }
}

}  // namespace

Importance weigh(const PlanarField& field, const std::vector<Vec2>& smooth,
                 const Skeleton& skeleton) {
  const Domain domain(field);
  Paths paths(domain, smooth);
  Importance result;
  std::unordered_map<Index, Index> zero_in;
  for (Index z = 0; z < skeleton.critical_points.size(); ++z)
    if (skeleton.critical_points[z].where == ZeroPlace::triangle)
      zero_in[skeleton.critical_points[z].simplex] = z;
  for (const CriticalPoint& c : skeleton.critical_points) {
    ZeroWeight& w = result.zeros.emplace_back();
    if (c.where == ZeroPlace::triangle) w = paths.follow(c.simplex);
    if (w.end == PathEnd::partner) w.partner = zero_in.at(w.partner);
    result.pairs += w.end == PathEnd::partner ? 1 : 0;
    result.staying += w.end == PathEnd::stays ? 1 : 0;
    result.open += w.end == PathEnd::open ? 1 : 0;
  }
  result.pairs /= 2;
  make_consistent(skeleton, result);
  return result;
}

Skeleton important_part(const Skeleton& skeleton, const Importance& importance, double least) {
  Skeleton part = skeleton;
  part.critical_points.clear();
  part.separatrices.clear();
  std::vector<Index> number(skeleton.critical_points.size(), kNone);
  for (Index z = 0; z < number.size(); ++z) {
    if (importance.zeros[z].weight < least) continue;
    number[z] = static_cast<Index>(part.critical_points.size());
    part.critical_points.push_back(skeleton.critical_points[z]);
  }
  for (std::size_t i = 0; i < skeleton.separatrices.size(); ++i) {
    if (importance.separatrices[i] < least) continue;
    Separatrix& s = part.separatrices.emplace_back(skeleton.separatrices[i]);
    if (!s.from_switch_point) s.origin = number[s.origin];
    if (s.end == EndKind::critical_point || s.end == EndKind::zero_flow)
      s.target = number[s.target];
  }
  return part;
}

}  // namespace crest::vector_fields
