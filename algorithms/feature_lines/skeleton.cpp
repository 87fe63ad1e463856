// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/skeleton.hpp"

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>
#include <utility>

#include "kernel/geometry/stop.hpp"

namespace crest::feature_lines {
namespace {

/// Vertices by marked neighbours, most first; then by field, lowest first; then by number.
class DegreeQueue {
 public:
  explicit DegreeQueue(const std::vector<double>& field) : field_(field) {}
  void push(Index v, Index degree) { heap_.push({degree, field_.empty() ? 0.0 : -field_[v], ~v}); }
  /// False when empty; `pushed` is the degree the vertex was pushed with.
  bool pop(Index& v, Index& pushed) {
    if (heap_.empty()) return false;
    pushed = std::get<0>(heap_.top());
    v = ~std::get<2>(heap_.top());
    heap_.pop();
    return true;
  }

 private:
  const std::vector<double>& field_;
  std::priority_queue<std::tuple<Index, double, Index>> heap_;
};

}  // namespace

Thinner::Thinner(const kernel::TriangleMesh& mesh, Marks marks, std::vector<double> field)
    : mesh_(mesh),
      marks_(std::move(marks)),
      field_(std::move(field)),
      unmarked_(mesh.vertex_count(), 0),
      centre_until_(mesh.vertex_count(), 0) {
  for (const kernel::Edge& e : mesh.edges()) {
    unmarked_[e.v0] += marks_[e.v1] ^ 1u;
    unmarked_[e.v1] += marks_[e.v0] ^ 1u;
  }
}

Index Thinner::degree(Index v) const {
  return static_cast<Index>(mesh_.ring(v).size()) - unmarked_[v];
}

void Thinner::take(Index v) {
  marks_[v] = 0;
  for (const Index w : mesh_.ring(v))
    if (unmarked_[w]++ == 0) centre_until_[w] = pass_;
}

void Thinner::put_back(Index v) {
  marks_[v] = 1;
  for (const Index w : mesh_.ring(v)) --unmarked_[w];
}

/// As it was at the start of the pass: both sides of a band lose a layer, not only the side that
/// comes first.
bool Thinner::beside_centre(Index v) const {
  for (const Index w : mesh_.ring(v))
    if (marks_[w] && (unmarked_[w] == 0 || centre_until_[w] == pass_)) return true;
  return false;
}

/// One marked neighbour. At a boundary vertex the end of a line may hold the complement's two
/// sides apart: that is no tip.
bool Thinner::is_tip(Index v) const {
  return marks_[v] && degree(v) == 1 && is_simple(mesh_, marks_, v);
}

bool Thinner::goes_before(Index v, Index w) const {
  if (field_.empty() || field_[v] == field_[w]) return v < w;
  return field_[v] < field_[w];
}

void Thinner::skeletonize() {
  std::vector<Index> front, next, waiting, stack, next_of(mesh_.vertex_count(), 0);
  waiting.assign(mesh_.vertex_count(), 0);
  for (Index v = 0; v < mesh_.vertex_count(); ++v)
    if (marks_[v] && unmarked_[v] > 0) front.push_back(v);
  const auto visit = [&](Index v) {
    if (!marks_[v] || !beside_centre(v) || !is_simple(mesh_, marks_, v)) return;
    take(v);
    removed_.push_back(v);
    for (const Index w : mesh_.ring(v)) {
      if (!marks_[w] || next_of[w] == pass_) continue;
      next_of[w] = pass_;
      next.push_back(w);
    }
  };
  for (pass_ = 1; !front.empty(); ++pass_) {
    next.clear();
    for (const Index v : front) waiting[v] = pass_;
    // What happens to a vertex depends on the marks of its neighbours alone: those of them that go
    // before it first, and all is as if the whole front were sorted.
    for (const Index seed : front) {
      if (waiting[seed] != pass_) continue;
      kernel::stop_point();
      stack.assign(1, seed);
      while (!stack.empty()) {
        const Index v = stack.back();
        const auto ring = mesh_.ring(v);
        const auto first = std::find_if(ring.begin(), ring.end(), [&](Index w) {
          return waiting[w] == pass_ && goes_before(w, v);
        });
        if (first != ring.end()) {
          stack.push_back(*first);
          continue;
        }
        stack.pop_back();
        waiting[v] = 0;
        visit(v);
      }
    }
    front.swap(next);
  }
}

void Thinner::pre_prune() {
  // The ends of a strip have fewer marked neighbours than its sides: sides first, or an unlucky
  // numbering would eat the strip from its end.
  DegreeQueue queue(field_);
  for (Index v = 0; v < mesh_.vertex_count(); ++v)
    if (marks_[v] && degree(v) >= 2) queue.push(v, degree(v));
  Index v = 0, pushed = 0;
  while (queue.pop(v, pushed)) {
    kernel::stop_point();
    const Index now = marks_[v] ? degree(v) : 0;
    if (now < 2) continue;
    if (now != pushed) {
      if (now < pushed) queue.push(v, now);
      continue;
    }
    if (!is_simple(mesh_, marks_, v)) continue;
    take(v);
    removed_.push_back(v);
    for (const Index w : mesh_.ring(v))
      if (marks_[w] && degree(w) >= 2) queue.push(w, degree(w));
  }
}

std::vector<Thinner::Taken> Thinner::take_tips(Index rounds) {
  std::vector<Taken> history;
  std::vector<Index> tips, next;
  for (Index v = 0; v < mesh_.vertex_count(); ++v)
    if (is_tip(v)) tips.push_back(v);
  for (Index round = 0; round < rounds && !tips.empty(); ++round) {
    next.clear();
    for (const Index v : tips) {
      if (!is_tip(v)) continue;
      const auto ring = mesh_.ring(v);
      const Index parent =
          *std::find_if(ring.begin(), ring.end(), [&](Index w) { return marks_[w] != 0; });
      take(v);
      history.push_back({v, parent});
      next.push_back(parent);
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    tips.clear();
    std::copy_if(next.begin(), next.end(), std::back_inserter(tips),
                 [&](Index v) { return is_tip(v); });
  }
  return history;
}

void Thinner::restore_open_ends(const std::vector<Taken>& history, Index rounds) {
  // The two deepest chains taken from each vertex; history is in the order of taking, so a
  // vertex's own chains are known when it is taken itself.
  struct Chains {
    std::array<Index, 2> child{kNone, kNone}, depth{0, 0};
  };
  std::vector<Chains> chains(mesh_.vertex_count());
  std::vector<Index> holders;
  for (const auto& [v, parent] : history) {
    const Index depth = chains[v].depth[0] + 1;
    Chains& c = chains[parent];
    holders.push_back(parent);
    if (depth > c.depth[0]) {
      c = {{v, c.child[0]}, {depth, c.depth[0]}};
    } else if (depth > c.depth[1]) {
      c.child[1] = v;
      c.depth[1] = depth;
    }
  }
  const auto restore = [&](Index v) {
    for (; v != kNone; v = chains[v].child[0]) put_back(v);
  };
  std::sort(holders.begin(), holders.end());
  holders.erase(std::unique(holders.begin(), holders.end()), holders.end());
  // Decided for all before anything comes back: what is restored is no one else's neighbour.
  std::vector<Index> ends;
  for (const Index v : holders) {
    if (!marks_[v]) continue;
    const Chains& c = chains[v];
    if (is_tip(v)) ends.push_back(c.child[0]);
    if (degree(v) == 0 && 1 + c.depth[0] + c.depth[1] > rounds) {
      ends.push_back(c.child[0]);
      ends.push_back(c.child[1]);
    }
  }
  for (const Index v : ends) restore(v);
}

void Thinner::prune(Index rounds) {
  if (rounds == 0) return;
  const std::vector<Taken> history = take_tips(rounds);
  restore_open_ends(history, rounds);
  for (const auto& [v, parent] : history)
    if (!marks_[v]) removed_.push_back(v);
  pre_prune();
  for (Index v = 0; v < mesh_.vertex_count(); ++v)
    if (marks_[v] && degree(v) == 0) dropped_.push_back(v);
}

}  // namespace crest::feature_lines
