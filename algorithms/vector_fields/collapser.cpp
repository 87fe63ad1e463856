// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/collapser.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "algorithms/vector_fields/fillings.hpp"
#include "algorithms/vector_fields/thesis_test.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::dot;
using kernel::Sign;
using kernel::operator-;

namespace {

constexpr std::size_t kFillings = 132;  ///< of one hole: all of those with up to eight corners
constexpr std::size_t kCorners = 64;    ///< of a hole: their pairs have a table

/// Whether a closed triangle has a zero: outside of it all turns do not have one sign.
bool has_zero(const kernel::FieldOnTriangle& f, Sign& turn) {
  const std::array<Sign, 3> turns = {kernel::vector_turn(f.v[0], f.v[1]),
                                     kernel::vector_turn(f.v[1], f.v[2]),
                                     kernel::vector_turn(f.v[2], f.v[0])};
  const auto none = [&](Sign s) { return std::find(turns.begin(), turns.end(), s) == turns.end(); };
  turn = none(Sign::zero) && (none(Sign::negative) || none(Sign::positive)) ? turns[0] : Sign::zero;
  if (!none(Sign::positive) || !none(Sign::negative))
    return none(Sign::positive) || none(Sign::negative);
  // All parallel: unless they point the same way.
  for (std::size_t k = 0; k < 2; ++k) {
    const auto [least, most] = std::minmax({f.v[0][k], f.v[1][k], f.v[2][k]});
    if (least > 0 || most < 0) return false;
  }
  return true;
}

ZeroKind kind_of(const kernel::FieldOnTriangle& f, Sign turn) {
  if (turn == Sign::negative) return ZeroKind::saddle;
  const Sign trace = kernel::trace_sign(f);
  return trace == Sign::positive   ? ZeroKind::source
         : trace == Sign::negative ? ZeroKind::sink
                                   : ZeroKind::centre;
}

}  // namespace

bool Collapser::find_new_zeros(std::vector<NewZero>& found) const {
  for (const Index t : plan_.star) {
    if (t == plan_.gone[0] || t == plan_.gone[1]) continue;
    const auto f = state_.mesh.data_after(plan_, t);
    Sign turn = Sign::zero;
    if (!has_zero(f, turn)) continue;
    if (turn == Sign::zero) return false;
    found.push_back({kind_of(f, turn), t});
  }
  return true;
}

/// Zeros of the star stay as the equivalence demands.
Collapser::Answer Collapser::examine_zeros() {
  std::vector<Index> old;
  for (const Index t : plan_.star) {
    if (state_.frozen(t)) return Answer::critical;
    if (state_.zero_in[t] != kNone) old.push_back(state_.zero_in[t]);
  }
  if (minor_ && !old.empty()) return examine_minor(old);
  if (!old.empty() && options_.equivalence != Equivalence::relaxed) return Answer::critical;
  std::vector<NewZero> fresh;
  if (!find_new_zeros(fresh) || fresh.size() != old.size()) return Answer::critical;
  // One of a kind each: the new ones are the old ones, moved.
  for (const ZeroKind kind : {ZeroKind::saddle, ZeroKind::source, ZeroKind::sink}) {
    const auto of_kind = [&](const NewZero& z) { return z.kind == kind; };
    const auto before = std::count_if(old.begin(), old.end(),
                                      [&](Index z) { return state_.zeros[z].kind == kind; });
    if (before > 1 || before != std::count_if(fresh.begin(), fresh.end(), of_kind))
      return Answer::critical;
  }
  for (const Index z : old) {
    const ZeroKind kind = state_.zeros[z].kind;
    if (kind == ZeroKind::centre) return Answer::critical;
    const auto now =
        std::find_if(fresh.begin(), fresh.end(), [&](const NewZero& n) { return n.kind == kind; });
    moved_zeros_.push_back({z, state_.zeros[z], {kind, now->triangle, true}});
  }
  return Answer::yes;
}

/// Zeros of little weight may change into others, but into no more.
Collapser::Answer Collapser::examine_minor(const std::vector<Index>& old) {
  std::vector<NewZero> fresh;
  if (std::any_of(old.begin(), old.end(), [&](Index z) { return state_.zeros[z].kept; }) ||
      !find_new_zeros(fresh) || fresh.size() > old.size())
    return Answer::critical;
  for (std::size_t i = 0; i < old.size(); ++i) {
    const SearchZero& before = state_.zeros[old[i]];
    SearchZero now{before.kind, kNone, true, false};
    if (i < fresh.size()) now = {fresh[i].kind, fresh[i].triangle, true, false};
    moved_zeros_.push_back({old[i], before, now});
  }
  return Answer::yes;
}

/// What passes the star.
void Collapser::collect() {
  ++attempts_;
  lines_.clear();
  chains_.clear();
  for (const Index t : plan_.star)
    for (const Index item : state_.passing[t]) {
      if (seen_[item] == attempts_) continue;
      seen_[item] = attempts_;
      if (item < state_.line_count())
        lines_.push_back(item);
      else
        chains_.push_back(item - state_.line_count());
    }
  lost_sides_.clear();
  for (const Index t : plan_.star)
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (plan_.flipped != kNone || !plan_.filling.empty() || t == plan_.gone[0] ||
          t == plan_.gone[1] || state_.mesh.from(h) == plan_.from ||
          state_.mesh.to(h) == plan_.from)
        lost_sides_.push_back(h);
  std::sort(lines_.begin(), lines_.end());
  std::sort(chains_.begin(), chains_.end());
}

/// From the first of its sides that stays on.
Collapser::Answer Collapser::prove_orbit(Index number) {
  const SearchOrbit old = state_.orbits[number];
  const auto stays = [&](HalfEdge h) {
    return std::find(lost_sides_.begin(), lost_sides_.end(), h) == lost_sides_.end();
  };
  const auto side = std::find_if(old.exits.begin(), old.exits.end(), stays);
  if (side == old.exits.end()) return Answer::orbit;
  const auto k = static_cast<std::size_t>(side - old.exits.begin());
  for (const double wider : {4.0, 1.0, 16.0, 0.25}) {
    SearchOrbit now;
    if (!state_.close(old, k, wider, now)) continue;
    const AnnulusDoor door{now.forward, state_.mesh.twin(now.exits.front()), 1 - now.high.front(),
                           1 - now.low.front()};
    if (!closes(state_.mesh, door, now.exits)) continue;
    now.around = state_.enclosed(now);
    if (now.around != old.around) return Answer::orbit;
    moved_orbits_.push_back({number, old});
    state_.orbits[number] = std::move(now);
    return Answer::yes;
  }
  return Answer::orbit;
}

Collapser::Answer Collapser::examine_orbits() {
  for (const Index orbit : chains_)
    if (const Answer a = prove_orbit(orbit); a != Answer::yes) return a;
  // Their lines end at other segments now.
  for (const auto& [orbit, old] : moved_orbits_) {
    const auto first = state_.arrivals.size() - 2 * (state_.orbits.size() - orbit);
    for (const std::size_t side : {first, first + 1})
      for (const Index line : state_.arrivals[side])
        if (seen_[line] != attempts_) {
          seen_[line] = attempts_;
          lines_.push_back(line);
        }
  }
  return Answer::yes;
}

Collapser::Answer Collapser::retrace(Index number, std::size_t from) {
  SearchLine& line = state_.lines[number];
  const auto begin = line.steps.begin() + static_cast<std::ptrdiff_t>(from);
  retraced_.push_back({number, from, {begin, line.steps.end()}, line.start, line.first});
  line.steps.erase(begin, line.steps.end());
  if (from == 0) line.first.reset();
  EndKind end = EndKind::undecided;
  Index target = kNone;
  const std::size_t most = 4 * (from + retraced_.back().tail.size()) + 1000;
  if (state_.follow(line, most, end, target) == QuickEnd::lost) return Answer::open;
  if (!line.steps.empty()) line.first = line.steps.front();
  return end == line.end && target == line.target ? Answer::yes : Answer::ends;
}

/// Whether all four rays of a saddle are known.
bool Collapser::note_rays(MovedZero& saddle) const {
  for (const Index number : lines_) {
    const SearchLine& line = state_.lines[number];
    if (line.start.kind != StartKind::ray || line.start.origin != saddle.zero) continue;
    if (line.steps.empty()) return false;
    saddle.lines.push_back(number);
    saddle.rays.push_back(state_.place(line.steps.front()) - state_.place_of(saddle.zero));
  }
  return saddle.lines.size() == 4;
}

/// The four rays of a saddle that moved: its separatrices are matched with them in the way that
/// keeps their ends and how they alternate.
Collapser::Answer Collapser::retrace_saddle(const MovedZero& saddle) {
  std::array<SearchLine, 4> fresh;
  std::array<Vec2, 4> rays;
  for (std::size_t k = 0; k < 4; ++k) {
    SearchLine& line = fresh[k];
    line.start = state_.lines[saddle.lines[k]].start;
    line.start.place = 3 * saddle.now.triangle;
    line.start.sense = k % 2 == 0 ? 1 : -1;
    const std::size_t most = 4 * state_.lines[saddle.lines[k]].steps.size() + 1000;
    if (state_.follow(line, most, line.end, line.target) == QuickEnd::lost || line.steps.empty())
      return Answer::open;
    rays[k] = state_.place(line.steps.front()) - state_.place_of(saddle.zero);
  }
  const auto turn = [](const auto& r) { return cross(r[0], r[2]) > 0; };
  const std::size_t other = turn(rays) == turn(saddle.rays) ? 0 : 1;
  const std::size_t first = dot(rays[0], saddle.rays[0]) > 0 ? 0 : 1;
  for (const std::size_t flip : {first, 1 - first}) {
    // Forward rays are 0 and 1, backward ones 2 and 3.
    const auto ray = [&](std::size_t k) { return (k < 2 ? k ^ flip : k ^ flip ^ other); };
    bool same = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const SearchLine& line = state_.lines[saddle.lines[k]];
      same = same && fresh[ray(k)].end == line.end && fresh[ray(k)].target == line.target;
    }
    if (!same) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      SearchLine& line = state_.lines[saddle.lines[k]];
      retraced_.push_back({saddle.lines[k], 0, std::move(line.steps), line.start, line.first});
      line.start = fresh[ray(k)].start;
      line.steps = std::move(fresh[ray(k)].steps);
      line.first = line.steps.front();
    }
    return Answer::yes;
  }
  return Answer::ends;
}

bool Collapser::enters_moved_orbit(const SearchLine& line, std::size_t step) const {
  if (line.end != EndKind::closed_orbit) return false;
  return std::any_of(moved_orbits_.begin(), moved_orbits_.end(), [&](const auto& moved) {
    const SearchOrbit& o = state_.orbits[moved.first];
    const Step& s = line.steps[step];
    return moved.first == line.target && s.exit == o.exits.front() && o.low.front() < s.share &&
           s.share < o.high.front();
  });
}

Collapser::Answer Collapser::examine_lines() {
  for (const MovedZero& z : moved_zeros_) {
    if (z.lines.empty()) continue;
    if (const Answer a = retrace_saddle(z); a != Answer::yes) return a;
  }
  const auto done = [&](Index number) {
    return std::any_of(moved_zeros_.begin(), moved_zeros_.end(), [&](const MovedZero& z) {
      return std::find(z.lines.begin(), z.lines.end(), number) != z.lines.end();
    });
  };
  // Those first for which attempts nearby were refused lately.
  std::vector<Index> order = lines_;
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return failed_[a] > failed_[b]; });
  for (const Index number : order) {
    const SearchLine& line = state_.lines[number];
    if (line.end == EndKind::undecided || done(number)) continue;
    std::size_t from = 0;
    while (from < line.steps.size() && in_star_[line.steps[from].exit / 3] == 0 &&
           !enters_moved_orbit(line, from))
      ++from;
    // It ends at a segment that it passed before.
    if (from < line.steps.size() && in_star_[line.steps[from].exit / 3] == 0) ++from;
    if (const Answer a = retrace(number, from); a != Answer::yes) {
      failed_[number] = attempts_;
      return a;
    }
  }
  return Answer::yes;
}

Collapser::Answer Collapser::examine_orders() {
  std::vector<Index> ends;
  for (const Retraced& r : retraced_) ends.push_back(state_.end_of(r.line));
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const Retraced& r : retraced_)
    if (state_.lines[r.line].ordered && state_.end_of(r.line) == kNone) return Answer::open;
  for (const Index end : ends) {
    if (end == kNone) continue;
    for (const Index line : state_.arrivals[end])
      if (state_.end_of(line) != end) return Answer::order;
    const auto order = state_.order_at(end);
    if (order == SearchState::Order::open) return Answer::open;
    if (order == SearchState::Order::other) return Answer::order;
  }
  return Answer::yes;
}

void Collapser::commit() {
  const auto leave = [&](Index item, Index t) {
    auto& all = state_.passing[t];
    *std::find(all.begin(), all.end(), item) = all.back();
    all.pop_back();
  };
  // Zeros that moved had their lines registered where they were.
  const auto old_place = [&](Index zero) {
    for (const MovedZero& z : moved_zeros_)
      if (z.zero == zero) return z.old.triangle;
    return state_.zeros[zero].triangle;
  };
  for (const Retraced& r : retraced_) {
    const SearchLine& line = state_.lines[r.line];
    for (const Step& s : r.tail) leave(r.line, s.exit / 3);
    for (std::size_t k = r.from; k < line.steps.size(); ++k)
      state_.passing[line.steps[k].exit / 3].push_back(r.line);
    if (line.end != EndKind::critical_point) continue;
    const Index before = old_place(line.target), now = state_.zeros[line.target].triangle;
    if (before == now || now == kNone) continue;
    leave(r.line, before);
    state_.passing[now].push_back(r.line);
  }
  for (const auto& [orbit, old] : moved_orbits_) {
    const Index item = state_.line_count() + orbit;
    for (const HalfEdge h : old.exits) leave(item, h / 3);
    for (const HalfEdge h : state_.orbits[orbit].exits) state_.passing[h / 3].push_back(item);
  }
}

void Collapser::take_back() {
  for (auto r = retraced_.rbegin(); r != retraced_.rend(); ++r) {
    state_.lines[r->line].start = r->start;
    state_.lines[r->line].first = r->first;
    auto& steps = state_.lines[r->line].steps;
    steps.resize(r->from);
    steps.insert(steps.end(), r->tail.begin(), r->tail.end());
  }
  for (auto& [orbit, old] : moved_orbits_) state_.orbits[orbit] = std::move(old);
  state_.mesh.undo();
  for (const MovedZero& z : moved_zeros_) state_.place_zero(z.zero, z.old);
}

Collapser::Answer Collapser::attempt(Index from, Index to) {
  const auto refusal = state_.mesh.plan(from, to, plan_);
  if (refusal == CollapseRefusal::geometry) return Answer::geometry;
  if (refusal == CollapseRefusal::boundary) return Answer::boundary;
  if (plan_.gone[0] == plan_.gone[1] && !options_.boundary) return Answer::boundary;
  moved_zeros_.clear();
  if (const Answer a = examine_zeros(); a != Answer::yes) return a;
  return change();
}

/// Away from zeros.
Collapser::Answer Collapser::attempt_flip(HalfEdge side) {
  if (!state_.mesh.plan_flip(side, plan_)) return Answer::geometry;
  moved_zeros_.clear();
  std::vector<NewZero> fresh;
  for (const Index t : plan_.star)
    if (state_.frozen(t) || state_.zero_in[t] != kNone) return Answer::critical;
  if (!find_new_zeros(fresh) || !fresh.empty()) return Answer::critical;
  return change();
}

/// What was planned, kept if the lines allow it.
Collapser::Answer Collapser::change() {
  moved_orbits_.clear();
  retraced_.clear();
  collect();
  if (options_.equivalence == Equivalence::strong && !lines_.empty()) return Answer::ends;
  if (options_.equivalence == Equivalence::strong && !chains_.empty()) return Answer::orbit;
  for (MovedZero& z : moved_zeros_)
    if (z.old.kept && z.old.kind == ZeroKind::saddle && !note_rays(z)) return Answer::open;
  std::optional<ThesisTest> thesis;
  if (options_.test == CollapseTest::thesis) thesis.emplace(state_, plan_, lines_);
  state_.mesh.apply(plan_);
  for (const Index t : plan_.star) in_star_[t] = 1;
  for (const MovedZero& z : moved_zeros_) state_.place_zero(z.zero, z.now);
  Answer answer = examine_orbits();
  if (answer == Answer::yes) answer = examine_lines();
  if (answer == Answer::yes) answer = examine_orders();
  if (answer == Answer::yes && thesis && !thesis->allows(state_, lines_)) answer = Answer::order;
  for (const Index t : plan_.star) in_star_[t] = 0;
  if (answer == Answer::yes) {
    commit();
    note_change();
  } else {
    take_back();
  }
  return answer;
}

double Collapser::priority(Index from, Index to) const {
  const Vec2 e = state_.mesh.point(to) - state_.mesh.point(from),
             d = state_.mesh.vector(to) - state_.mesh.vector(from);
  const double length = std::sqrt(dot(e, e)), error = std::sqrt(dot(d, d));
  return options_.priority == CollapsePriority::length  ? length
         : options_.priority == CollapsePriority::error ? error
                                                        : length * error;
}

/// Whether zeros of little weight would vanish.
bool Collapser::cancels(Index from, Index to) {
  std::vector<HalfEdge> fan;
  state_.mesh.fan(from, fan);
  const auto zeros = static_cast<std::size_t>(std::count_if(
      fan.begin(), fan.end(), [&](HalfEdge h) { return state_.zero_in[h / 3] != kNone; }));
  std::vector<NewZero> fresh;
  return zeros > 1 && state_.mesh.plan(from, to, plan_) == CollapseRefusal::none &&
         find_new_zeros(fresh) && fresh.size() < zeros;
}

/// Stars at the corners of the star are others now.
void Collapser::note_change() {
  const auto corners_of = [&](Index t) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      changed_[state_.mesh.from(h)] = pass_;
      changed_at_[state_.mesh.from(h)] = attempts_;
    }
  };
  for (const Index t : plan_.star)
    if (state_.mesh.alive(t)) corners_of(t);
  // A corner of the triangles that vanished alone.
  for (const Index t : plan_.gone)
    if (t != kNone) corners_of(t);
}

bool Collapser::try_collapse(Index from, Index to, CompressionCounts& counts) {
  kernel::stop_point();
  return note(attempt(from, to), counts);
}

/// Counts a test's answer; whether it was yes.
bool Collapser::note(Answer answer, CompressionCounts& counts) {
  ++counts.tests;
  RefusedCollapses& r = counts.refused;
  switch (answer) {
    case Answer::yes:
      ++counts.collapses;
      return true;
    case Answer::geometry:
      ++r.geometry;
      return false;
    case Answer::boundary:
      ++r.boundary;
      return false;
    case Answer::critical:
      ++r.critical_points;
      return false;
    case Answer::ends:
      ++r.ends;
      return false;
    case Answer::order:
      ++r.order;
      return false;
    case Answer::orbit:
      ++r.orbit;
      return false;
    case Answer::open:
      ++r.undecided;
      return false;
  }
  return false;
}

/// What changed since the last pass began.
bool Collapser::pass(CompressionCounts& counts) {
  // What cancels zeros comes first.
  using Entry = std::tuple<bool, double, Index, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto add = [&](Index from, Index to) {
    queue.push({!(minor_ && cancels(from, to)), priority(from, to), from, to});
  };
  const CollapseMesh& mesh = state_.mesh;
  const int since = pass_++;
  for (HalfEdge h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (!mesh.alive(h / 3)) continue;
    const Index p = mesh.from(h), q = mesh.to(h);
    if (changed_[p] >= since) add(p, q);
    if (mesh.twin(h) == kNone && changed_[q] >= since) add(q, p);
  }
  bool any = false;
  std::vector<HalfEdge> fan;
  while (!queue.empty()) {
    const auto [later, cost, from, to] = queue.top();
    queue.pop();
    if (!mesh.adjacent(from, to) || !try_collapse(from, to, counts)) continue;
    any = true;
    mesh.fan(to, fan);
    for (const HalfEdge h : fan) {
      add(to, mesh.to(h));
      add(mesh.to(h), to);
    }
  }
  return any;
}

/// Whether a vertex might be taken out.
bool Collapser::may_go(Index vertex) const {
  if (state_.mesh.stays(vertex)) return false;
  std::vector<HalfEdge> fan;
  state_.mesh.fan(vertex, fan);
  return std::none_of(fan.begin(), fan.end(), [&](HalfEdge h) {
    return state_.frozen(h / 3) ||
           (options_.equivalence != Equivalence::relaxed && state_.zero_in[h / 3] != kNone);
  });
}

/// Whether its star and those of its neighbours are those around which nothing would do.
bool Collapser::as_it_was(Index vertex) const {
  const std::size_t then = stuck_at_[vertex];
  if (changed_at_[vertex] > then) return false;
  std::vector<HalfEdge> fan;
  state_.mesh.fan(vertex, fan);
  return std::none_of(fan.begin(), fan.end(), [&](HalfEdge h) {
    return changed_at_[state_.mesh.to(h)] > then ||
           changed_at_[state_.mesh.from(Domain::previous(h))] > then;
  });
}

Collapser::Answer Collapser::attempt_filling() {
  moved_zeros_.clear();
  if (const Answer a = examine_zeros(); a != Answer::yes) return a;
  return change();
}

/// Takes the vertex out if one of the triangulations of its star will do. A collapse has those
/// that have all their edges at one corner.
bool Collapser::take_out(Index vertex, CompressionCounts& counts) {
  const CollapseMesh& mesh = state_.mesh;
  if (!mesh.plan_hole(vertex, corners_, plan_) || corners_.size() > kCorners) return false;
  const bool open = plan_.gone[0] == plan_.gone[1];
  if (open && !options_.boundary) return false;
  const bool zeros = std::any_of(plan_.star.begin(), plan_.star.end(),
                                 [&](Index t) { return state_.zero_in[t] != kNone; });
  const auto may_be = [&](std::size_t first, std::size_t apex, std::size_t last) {
    const bool outer = !open && first == 0 && last + 1 == corners_.size();
    if (!outer && mesh.adjacent(corners_[first], corners_[last])) return false;
    const std::array<Index, 3> t = {corners_[first], corners_[apex], corners_[last]};
    const auto f = mesh.data(t);
    Sign turn = Sign::zero;
    return kernel::orientation(f.p[0], f.p[1], f.p[2]) == Sign::positive &&
           (zeros || !has_zero(f, turn));
  };
  return Fillings(corners_, may_be).any(kFillings, [&](const Fillings::Triangles& filling) {
    kernel::stop_point();
    plan_.filling = filling;
    if (!note(attempt_filling(), counts)) return false;
    ++counts.filled;
    return true;
  });
}

/// Flips edges at the vertex until it collapses.
void Collapser::loosen(Index vertex, CompressionCounts& counts) {
  const CollapseMesh& mesh = state_.mesh;
  std::vector<HalfEdge> fan, after;
  for (bool flipped = true; flipped;) {
    flipped = false;
    mesh.fan(vertex, fan);
    if (mesh.twin(fan.front()) == kNone) return;
    for (const HalfEdge h : fan) {
      kernel::stop_point();
      if (attempt_flip(h) != Answer::yes) continue;
      ++counts.flips;
      flipped = true;
      mesh.fan(vertex, after);
      std::vector<Index> neighbours;
      for (const HalfEdge g : after) neighbours.push_back(mesh.to(g));
      for (const Index to : neighbours)
        if (try_collapse(vertex, to, counts)) return;
      break;
    }
  }
  // Else edges opposite to it, for one more neighbour.
  mesh.fan(vertex, fan);
  for (const HalfEdge h : fan) {
    const HalfEdge beyond = mesh.twin(Domain::next(h));
    if (beyond == kNone || attempt_flip(Domain::next(h)) != Answer::yes) continue;
    ++counts.flips;
    if (try_collapse(vertex, mesh.from(Domain::previous(h)), counts)) return;
  }
}

/// Where nothing collapses any more.
void Collapser::loosen(CompressionCounts& counts) {
  const CollapseMesh& mesh = state_.mesh;
  std::vector<std::uint8_t> seen(mesh.vertex_count(), 0);
  for (HalfEdge h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (!mesh.alive(h / 3) || seen[mesh.from(h)] != 0) continue;
    seen[mesh.from(h)] = 1;
    const Index v = mesh.from(h);
    if (!may_go(v) || as_it_was(v)) continue;
    stuck_at_[v] = attempts_;
    if (!take_out(v, counts)) loosen(v, counts);
  }
}

void Collapser::run(CompressionCounts& counts) {
  const bool flips = options_.flips && options_.test == CollapseTest::retrace;
  for (bool again = true; again;) {
    const std::uint64_t before = counts.collapses;
    do ++counts.passes;
    while (pass(counts));
    if (flips) loosen(counts);
    again = counts.collapses > before && flips;
  }
  counts.retraced_crossings = state_.crossings;
  counts.inherited = state_.inherited;
}

}  // namespace crest::vector_fields
