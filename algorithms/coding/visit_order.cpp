// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/visit_order.hpp"

namespace crest::coding {
namespace {

/// The apex of the face at a half-edge.
Index apex(const Surface& surface, Index h) {
  return surface.from(previous_half(h));
}

}  // namespace

Index VisitOrder::take() {
  for (;; --highest_) {
    Queue& queue = queues_[highest_];
    while (queue.head < queue.entries.size()) {
      const Index v = queue.entries[queue.head++];
      if (!known_[v] && count_[v] == highest_) return v;
    }
    queue = {};
    if (highest_ == 0) break;
  }
  while (lowest_ < known_.size() && known_[lowest_]) ++lowest_;
  return lowest_ < known_.size() ? lowest_ : kNone;
}

void VisitOrder::visit(Index w) {
  known_[w] = 1;
  surface_.around(w, [&](Index h) {
    const Index a = surface_.to(h), b = apex(surface_, h);
    for (const Index v : {a, b}) {
      if (known_[v] || queued_[v]) continue;
      queued_[v] = 1;
      queues_[0].entries.push_back(v);
    }
    if (!known_[a]) return;
    if (const Index across = surface_.twin(next_half(h)); across != kNone && known_[b]) {
      if (const Index d = apex(surface_, across); !known_[d]) credit(d);
    }
    if (const Index across = surface_.twin(h); across != kNone) {
      const Index c = apex(surface_, across);
      if (known_[b] != known_[c]) credit(known_[b] ? c : b);
    }
  });
}

}  // namespace crest::coding
