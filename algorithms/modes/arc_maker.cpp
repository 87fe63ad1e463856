// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/arc_maker.hpp"

#include <algorithm>
#include <cmath>

namespace crest::modes {

using kernel::Rational;
using kernel::Sign;

void ArcMaker::collect() {
  const Face& face = faces_.face(face_);
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge& edge = faces_.edge(face.edges[k]);
    const RootRange range = faces_.roots(face.edges[k]);
    const RootNumbers list = faces_.lines().roots(edge.line);
    const bool forward = edge.first == face.corners[k];
    for (std::size_t i = 0; i < range.count; ++i) {
      const std::size_t at = range.first + (forward ? i : range.count - 1 - i);
      ends_.push_back({list[at], static_cast<std::uint8_t>(k),
                       static_cast<std::uint8_t>(ends_.size()), faces_.lines().root(list[at]).side,
                       i});
    }
  }
}

bool ArcMaker::is_at(const End& end, std::size_t corner) {
  const Face& face = faces_.face(face_);
  const Edge& edge = faces_.edge(face.edges[end.edge]);
  const Index v = face.corners[corner];
  if (edge.first != v && edge.second != v) return false;
  return faces_.lines().compare_place(end.root, edge.first == v ? edge.begin : edge.end) ==
         Sign::zero;
}

/// The order along the axis c with c . w = 0: -1, 1, or 0 if it is not decided.
int ArcMaker::compare(const End& a, const End& b) {
  const Face& face = faces_.face(face_);
  const auto& w = face.witness.w;
  const long c[3] = {long{w[1]} - w[2], long{w[2]} - w[0], long{w[0]} - w[1]};
  const auto step = [&](const End& e) { return c[(e.edge + 1) % 3] - c[e.edge]; };
  if (a.edge == b.edge) {
    const long s = step(a);
    return s == 0 ? 0 : (a.order < b.order) == (s > 0) ? -1 : 1;
  }
  struct Range {
    double low, high;
  };
  const auto in_doubles = [&](const End& e) -> Range {
    const Edge& edge = faces_.edge(face.edges[e.edge]);
    const Root& r = faces_.lines().root(e.root);
    const double begin = edge.from, length = edge.to - begin;
    // begin and end are rounded once each, as are the differences and the quotient.
    const double slack = 4 * 0x1p-52 * (2 + 2 / length);
    double low = (r.low - begin) / length - slack, high = (r.high - begin) / length + slack;
    if (edge.first != face.corners[e.edge]) {
      const double t = 1 - low;
      low = 1 - high;
      high = t;
    }
    const double at = static_cast<double>(c[e.edge]), s = static_cast<double>(step(e));
    const double pad = 0x1p-48 * (std::fabs(at) + std::fabs(s));
    return {at + std::fmin(s * low, s * high) - pad, at + std::fmax(s * low, s * high) + pad};
  };
  const Range x = in_doubles(a), y = in_doubles(b);
  if (x.high < y.low) return -1;
  if (y.high < x.low) return 1;
  for (long bits = 64; bits <= 2048; bits *= 4) {
    const auto exactly = [&](const End& e) -> std::array<Rational, 2> {
      const Edge& edge = faces_.edge(face.edges[e.edge]);
      const Rational begin = edge.begin.value(), length = edge.end.value() - begin;
      auto r = faces_.lines().bounds(e.root, bits);
      for (Rational& t : r) {
        t = (t - begin) / length;
        if (edge.first != face.corners[e.edge]) t = 1 - t;
        t = c[e.edge] + step(e) * t;
      }
      if (r[1] < r[0]) std::swap(r[0], r[1]);
      return r;
    };
    const auto p = exactly(a), q = exactly(b);
    if (p[1] < q[0]) return -1;
    if (q[1] < p[0]) return 1;
  }
  return 0;
}

void ArcMaker::add(const End& a, const End& b) {
  const bool ordered = a.number < b.number;
  const End &first = ordered ? a : b, &second = ordered ? b : a;
  arcs_.push_back({face_, {first.root, second.root}, {first.number, second.number}, a.side});
}

bool ArcMaker::join(Side side) {
  boost::container::small_vector<End, 8> ends;
  for (const End& e : ends_)
    if (e.side == side) ends.push_back(e);
  if (ends.size() % 2 == 1) return false;
  // Two roots next to one corner: the curve, there nearly a line, cuts the corner off.
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (faces_.vertices().signs(faces_.face(face_).corners[corner]).f != Sign::zero) continue;
    boost::container::small_vector<std::size_t, 4> near;
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (is_at(ends[i], corner)) near.push_back(i);
    if (near.size() != 2) continue;
    add(ends[near[0]], ends[near[1]]);
    ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(near[1]));
    ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(near[0]));
  }
  // Insertion: few ends, and an order that may not be decided.
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (std::size_t k = i; k > 0; --k) {
      const int order = compare(ends[k - 1], ends[k]);
      if (order == 0) return false;
      if (order < 0) break;
      std::swap(ends[k - 1], ends[k]);
    }
  for (std::size_t i = 0; i < ends.size(); i += 2) add(ends[i], ends[i + 1]);
  return true;
}

bool ArcMaker::make() {
  collect();
  if (ends_.empty()) return true;
  for (const Side side : {Side::minus, Side::neutral, Side::plus})
    if (!join(side)) return false;
  std::sort(arcs_.begin(), arcs_.end(),
            [](const Arc& a, const Arc& b) { return a.numbers < b.numbers; });
  Face& face = faces_.faces_[face_];
  face.first_arc = static_cast<Index>(faces_.arcs_.size());
  face.arc_count = static_cast<Index>(arcs_.size());
  faces_.arcs_.insert(faces_.arcs_.end(), arcs_.begin(), arcs_.end());
  return true;
}

}  // namespace crest::modes
