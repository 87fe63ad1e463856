// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/strips/vertex_cache.hpp"

#include <algorithm>
#include <numeric>

namespace crest::strips {
namespace {

/// First in, first out; a vertex that is there does not move up.
class Cache {
 public:
  Cache(std::size_t vertices, std::size_t entries) : entries_(entries), missed_at_(vertices, 0) {}

  bool holds(Index v) const { return missed_at_[v] != 0 && misses_ - missed_at_[v] < entries_; }
  void send(Index v) {
    if (!holds(v)) missed_at_[v] = ++misses_;
  }
  std::size_t misses() const { return misses_; }

 private:
  std::size_t entries_, misses_ = 0;
  std::vector<std::size_t> missed_at_;  // from 1
};

/// The strips that begin with a vertex, within their first few.
struct Beginnings {
  std::vector<std::size_t> begin;
  std::vector<std::size_t> strips;
};

std::span<const Index> head(const Strips& strips, std::size_t s, std::size_t entries) {
  const std::span<const Index> all = strips.strip(s);
  return all.first(std::min(all.size(), entries));
}

Beginnings beginnings(const Strips& strips, std::size_t vertices, std::size_t entries) {
  Beginnings b;
  b.begin.assign(vertices + 1, 0);
  for (std::size_t s = 0; s < strips.count(); ++s)
    for (const Index v : head(strips, s, entries)) ++b.begin[v + 1];
  std::partial_sum(b.begin.begin(), b.begin.end(), b.begin.begin());
  b.strips.resize(b.begin.back());
  std::vector<std::size_t> next(b.begin.begin(), b.begin.end() - 1);
  for (std::size_t s = 0; s < strips.count(); ++s)
    for (const Index v : head(strips, s, entries)) b.strips[next[v]++] = s;
  return b;
}

}  // namespace

double average_cache_miss_ratio(const Strips& strips, std::size_t vertices, std::size_t faces,
                                std::size_t entries) {
  Cache cache(vertices, entries);
  for (const Index v : strips.vertices) cache.send(v);
  return static_cast<double>(cache.misses()) / static_cast<double>(faces);
}

Strips in_cache_order(const Strips& strips, std::size_t vertices, std::size_t entries) {
  const Beginnings b = beginnings(strips, vertices, entries);
  Cache cache(vertices, entries);
  std::vector<std::uint8_t> done(strips.count(), 0);
  std::vector<std::size_t> hits(strips.count(), 0), met;
  Strips ordered;
  ordered.swaps = strips.swaps;
  const auto best = [&](std::span<const Index> last, std::size_t first_left) {
    met.clear();
    for (std::size_t i = 0; i < last.size(); ++i) {
      const Index v = last[i];
      if (!cache.holds(v) || std::find(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(i),
                                       v) != last.begin() + static_cast<std::ptrdiff_t>(i))
        continue;
      for (std::size_t k = b.begin[v]; k < b.begin[v + 1]; ++k) {
        const std::size_t s = b.strips[k];
        if (!done[s] && hits[s]++ == 0) met.push_back(s);
      }
    }
    std::size_t found = first_left;
    for (const std::size_t s : met)
      if (hits[s] > hits[found] || (hits[s] == hits[found] && s < found)) found = s;
    for (const std::size_t s : met) hits[s] = 0;
    return found;
  };
  std::size_t first_left = 0;
  for (std::size_t i = 0; i < strips.count(); ++i) {
    while (done[first_left]) ++first_left;
    const std::size_t recent = std::min(ordered.vertices.size(), 2 * entries);
    const std::size_t s =
        best({ordered.vertices.data() + (ordered.vertices.size() - recent), recent}, first_left);
    done[s] = 1;
    for (const Index v : strips.strip(s)) {
      cache.send(v);
      ordered.vertices.push_back(v);
    }
    ordered.begin.push_back(ordered.vertices.size());
  }
  return ordered;
}

}  // namespace crest::strips
