// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/faces.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/modes/arc_maker.hpp"
#include "algorithms/modes/test_all.hpp"

namespace crest::modes {

using kernel::Dyadic;
using kernel::Integer;

namespace {

/// c |c| / (|a|^2 |b|^2), c = <a, b>: decreases as the angle grows. A function of the two ends
/// alone; 1 where it is not a number.
double angle_measure(const Deviator& a, const Deviator& b) {
  const double c = product(a.t, b.t);
  const double r = c * std::fabs(c) / (product(a.t, a.t) * product(b.t, b.t));
  return r <= 1 ? r : 1;
}

/// In 64ths from the first end, where the angle is halved.
std::uint8_t halving(const Deviator& a, const Deviator& b) {
  const double la = std::sqrt(product(a.t, a.t)), lb = std::sqrt(product(b.t, b.t));
  const double n = std::floor(64 * (la / (la + lb)) + 0.5);
  return n >= 1 ? static_cast<std::uint8_t>(std::min(n, 63.0)) : std::uint8_t{1};
}

/// begin + (end - begin) n / 64.
Dyadic between(const Dyadic& begin, const Dyadic& end, long n) {
  const Dyadic length = end - begin;
  return begin + Dyadic{length.mantissa * n, length.exponent - 6};
}

}  // namespace

Index Faces::add_edge(Index first, Index second) {
  const double measure = angle_measure(vertices_.tensor(first), vertices_.tensor(second));
  edges_.push_back(
      {first, second, lines_.add(first, second), {Integer(0), 0}, {Integer(1), 0}, 0, 1, measure});
  return static_cast<Index>(edges_.size() - 1);
}

Index Faces::add_face(const std::array<Index, 3>& corners, const std::array<Index, 3>& edges,
                      int depth, Index account, Index whole) {
  Face f{corners, edges};
  f.account = account;
  f.depth = static_cast<std::uint8_t>(depth);
  f.whole = whole == kNone ? static_cast<Index>(faces_.size()) : whole;
  faces_.push_back(f);
  return static_cast<Index>(faces_.size() - 1);
}

Index Faces::edge_of(Index face, Index a, Index b) const {
  const Face& f = faces_[face];
  for (std::size_t k = 0; k < 3; ++k) {
    const Index x = f.corners[k], y = f.corners[(k + 1) % 3];
    if ((x == a && y == b) || (x == b && y == a)) return f.edges[k];
  }
  return kNone;
}

bool Faces::cut_before(Index a, Index b) const {
  const Edge &x = edges_[a], &y = edges_[b];
  if (x.measure != y.measure) return x.measure < y.measure;
  return std::minmax(x.first, x.second) < std::minmax(y.first, y.second);
}

void Faces::cut(Index e) {
  if (edges_[e].middle != kNone) return;
  const Edge edge = edges_[e];
  const auto n = halving(vertices_.tensor(edge.first), vertices_.tensor(edge.second));
  const Index m = vertices_.add(edge.first, edge.second, n);
  const Dyadic t = between(edge.begin, edge.end, n);
  const auto add = [&](Index from, Index to, const Dyadic& begin, const Dyadic& end) {
    edges_.push_back({from, to, edge.line, begin, end, begin.lower(), end.lower(),
                      angle_measure(vertices_.tensor(from), vertices_.tensor(to))});
    return static_cast<Index>(edges_.size() - 1);
  };
  const Index near = add(edge.first, m, edge.begin, t), far = add(m, edge.second, t, edge.end);
  edges_[e].middle = m;
  edges_[e].part[0] = near;
  edges_[e].part[1] = far;
}

void Faces::split(Index f) {
  if (faces_[f].split >= 0) return;
  std::size_t k = 0;
  for (std::size_t j = 1; j < 3; ++j)
    if (cut_before(faces_[f].edges[j], faces_[f].edges[k])) k = j;
  cut(faces_[f].edges[k]);
  const Face face = faces_[f];
  const Edge edge = edges_[face.edges[k]];
  const Index a = face.corners[k], m = edge.middle, opposite = face.corners[(k + 2) % 3];
  const Index at_a = edge.part[edge.first == a ? 0 : 1], at_b = edge.part[edge.first == a ? 1 : 0];
  const Index inner = add_edge(opposite, m);
  std::array<Index, 3> near = face.corners, far = face.corners, near_edges, far_edges;
  near[(k + 1) % 3] = m;
  far[k] = m;
  near_edges[k] = at_a;
  near_edges[(k + 1) % 3] = inner;
  near_edges[(k + 2) % 3] = face.edges[(k + 2) % 3];
  far_edges[k] = at_b;
  far_edges[(k + 1) % 3] = face.edges[(k + 1) % 3];
  far_edges[(k + 2) % 3] = inner;
  const Index parts[2] = {add_face(near, near_edges, face.depth + 1, face.account, face.whole),
                          add_face(far, far_edges, face.depth + 1, face.account, face.whole)};
  for (const Index p : parts)
    if (face.state == State::rejected) faces_[p].state = State::rejected;
  Face& whole = faces_[f];
  whole.split = static_cast<std::int8_t>(k);
  whole.inner = inner;
  whole.part[0] = parts[0];
  whole.part[1] = parts[1];
  whole.closed = face.state == State::rejected;
  for (const Index p : parts) {
    faces_[p].parent = f;
    faces_[p].closed = whole.closed;
  }
  // The new leaves are undecided: so is all that they are part of.
  if (!whole.closed)
    for (Index p = face.parent; p != kNone; p = faces_[p].parent) faces_[p].closed = false;
}

Index Faces::part_with(Index f, Index corner) const {
  const Face& face = faces_[f];
  const auto k = static_cast<std::size_t>(face.split);
  return face.part[face.corners[k] == corner ? 0 : 1];
}

/// The leaves that are not decided.
void Faces::add_leaves_to_test(Index f, std::vector<Index>& to) {
  if (faces_[f].closed) return;
  if (faces_[f].split < 0) {
    if (faces_[f].state == State::unknown) {
      faces_[f].state = State::asked;
      to.push_back(f);
    }
    return;
  }
  for (const Index part : faces_[f].part) add_leaves_to_test(part, to);
}

void Faces::refine(Index f, std::vector<Index>& next) {
  if (faces_[f].depth >= limits_.depth || is_spent(faces_[f].account)) {
    faces_[f].state = State::open;
    return;
  }
  faces_[f].state = State::unknown;
  split(f);
  for (const Index part : faces_[f].part) {
    faces_[part].state = State::asked;
    next.push_back(part);
  }
}

void Faces::take(Index f, const CellResult<2>& result, std::vector<Index>& graphs,
                 std::vector<Index>& next) {
  ++counters_.tests;
  spend(faces_[f].account);
  counters_.depth = std::max<int>(counters_.depth, faces_[f].depth);
  counters_.exact_tests += result.exact ? 1 : 0;
  if (result.finding == Finding::graph) {
    faces_[f].witness = result.witness;
    graphs.push_back(f);
  } else if (result.finding == Finding::none) {
    refine(f, next);
  } else {
    faces_[f].state = State::rejected;
  }
}

/// The roots on the faces' edges.
void Faces::isolate_around(const std::vector<Index>& faces) {
  std::vector<Index> lines;
  for (const Index f : faces)
    for (const Index e : faces_[f].edges)
      if (!lines_.line(edges_[e].line).known) lines.push_back(edges_[e].line);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  lines_.isolate(lines);
}

void Faces::close(std::span<const Index> faces) {
  std::vector<Index> asked, graphs, next;
  for (const Index f : faces) add_leaves_to_test(f, asked);
  std::vector<std::array<Index, 3>> corners;
  while (!asked.empty()) {
    corners.clear();
    for (const Index f : asked) corners.push_back(faces_[f].corners);
    const auto results = test_all<2>(vertices_, corners, level_);
    graphs.clear();
    next.clear();
    for (std::size_t i = 0; i < asked.size(); ++i) take(asked[i], results[i], graphs, next);
    isolate_around(graphs);
    for (const Index f : graphs)
      if (ArcMaker(*this, f).make())
        faces_[f].state = State::graph;
      else
        refine(f, next);
    asked.swap(next);
  }
}

bool Faces::is_closed(Index f) {
  if (faces_[f].closed) return true;
  bool closed = true;
  if (faces_[f].split < 0)
    closed = faces_[f].state == State::rejected || faces_[f].state == State::graph;
  else
    for (const Index part : faces_[f].part) closed = is_closed(part) && closed;
  faces_[f].closed = closed;
  return closed;
}

RootRange Faces::roots(Index e) {
  const RootNumbers list = lines_.roots(edges_[e].line);
  Edge& edge = edges_[e];
  if (edge.first_root == kNone) {
    const auto below = [&](const Dyadic& t) {
      std::size_t k = 0;
      while (k < list.size() && lines_.is_below(list[k], t)) ++k;
      return static_cast<Index>(k);
    };
    const Index first = edge.from == 0 ? 0 : below(edge.begin);
    const Index end = edge.to == 1 ? static_cast<Index>(list.size()) : below(edge.end);
    edge.first_root = first;
    edge.root_count = end - first;
  }
  return {edge.first_root, edge.root_count};
}

}  // namespace crest::modes
