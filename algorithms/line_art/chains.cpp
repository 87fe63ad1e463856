// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/chains.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "algorithms/line_art/inked_parts.hpp"

namespace crest::line_art {
namespace {

using kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr double kBridge = 1.3, kShortest = 2.5, kShortestCrease = 8, kTaper = 4;  // line widths
constexpr double kTouch = 1.5;                        // line widths: nearer ink is a junction
constexpr double kAgree = 0.5;                        // cosine of 60 degrees
constexpr double kWideBridge = 2.6, kStraight = 0.9;  // line widths, where chains go on straight

/// A visible piece: its ends are numbered 2 i and 2 i + 1.
struct Segment {
  Vec2 from, to;
  bool crease;
};

/// Joined segments.
struct Chain {
  std::vector<Vec2> points;
  bool crease, closed;
  bool held_start, held_end;  ///< other ink is there
  double length = 0;
};

double length_of(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += norm(line[i] - line[i - 1]);
  return sum;
}

class Chainer {
 public:
  double visible_length = 0;  ///< mm, of all pieces

  Chainer(const Scene& scene, const View& view, const Contours& contours, double width)
      : scene_(scene), view_(view), contours_(contours), width_(width) {}

  std::vector<Chain> run() {
    collect();
    link_.assign(2 * segments_.size(), kNone);
    for (const auto& [node, ends] : nodes_) join(ends);
    bridge();
    trace();
    return std::move(chains_);
  }

 private:
  using Node =
      std::tuple<int, Index, Index>;  // 0: vertex; 1: break k of an edge; 2: an end of its own

  Vec2 at(const ContourEdge& e, double t) const {
    const Vec3 &a = scene_.points[e.a], &b = scene_.points[e.b];
    return view_.project(t == 0 ? a : t == 1 ? b : (1 - t) * a + t * b);
  }

  void collect() {
    for (const InkedPart& part : inked_parts(scene_, view_, contours_)) {
      const ContourEdge& e = contours_.edges[part.edge];
      const Index k = part.piece, end = static_cast<Index>(2 * segments_.size());
      segments_.push_back({at(e, part.from), at(e, part.to), e.crease});
      visible_length += norm(segments_.back().to - segments_.back().from);
      // Where another edge goes on over it no chain is joined.
      const bool first = part.whole_from && k == 0, last = part.whole_to && k + 1 == e.pieces;
      const Node from = part.whole_from ? Node{1, part.edge, k} : Node{2, end, 0};
      const Node to = part.whole_to ? Node{1, part.edge, k + 1} : Node{2, end + 1, 0};
      nodes_[first ? Node{0, e.a, 0} : from].push_back(end);
      nodes_[last ? Node{0, e.b, 0} : to].push_back(end + 1);
      // At a break an edge in front ends it; at a vertex alone it ends freely.
      held_.push_back(!first);
      held_.push_back(!last);
    }
    for (const auto& [node, ends] : nodes_)
      if (ends.size() > 2)
        for (const Index end : ends) held_[end] = true;
  }

  const Vec2& place(Index end) const {
    return end % 2 == 0 ? segments_[end / 2].from : segments_[end / 2].to;
  }
  /// Out of the segment at this end.
  Vec2 outward(Index end) const { return unit(place(end) - place(end ^ 1U)); }

  void connect(Index x, Index y) {
    link_[x] = y;
    link_[y] = x;
  }

  /// The two that are alone; of more the straightest pairs, like with like first.
  void join(const std::vector<Index>& ends) {
    if (ends.size() == 2) return connect(ends[0], ends[1]);
    std::vector<std::tuple<bool, double, Index, Index>> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const double straight = -dot(outward(ends[i]), outward(ends[j]));
        const bool unlike = segments_[ends[i] / 2].crease != segments_[ends[j] / 2].crease;
        if (straight > kAgree) pairs.emplace_back(unlike, -straight, ends[i], ends[j]);
      }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [unlike, turn, x, y] : pairs)
      if (link_[x] == kNone && link_[y] == kNone) connect(x, y);
  }

  /// The direction a chain ends in, over the last two widths.
  Vec2 direction_at(Index end) const {
    Index far = end ^ 1U;
    while (norm(place(end) - place(far)) < 2 * width_ && link_[far] != kNone && link_[far] != end)
      far = link_[far] ^ 1U;
    return unit(place(end) - place(far));
  }

  void bridge() {
    const double reach = kWideBridge * width_;
    std::map<std::pair<long, long>, std::vector<Index>> cells;
    std::vector<std::tuple<double, Index, Index>> pairs;
    for (Index end = 0; end < link_.size(); ++end) {
      if (link_[end] != kNone) continue;
      const long i = std::lround(place(end)[0] / reach), j = std::lround(place(end)[1] / reach);
      for (long di = -1; di <= 1; ++di)
        for (long dj = -1; dj <= 1; ++dj)
          if (const auto cell = cells.find({i + di, j + dj}); cell != cells.end())
            for (const Index other : cell->second) {
              const double gap = norm(place(end) - place(other));
              const Vec2 out = direction_at(end), there = direction_at(other);
              const Vec2 across = unit(place(other) - place(end));
              const bool straight = -dot(out, there) > kStraight && dot(out, across) > kStraight;
              if (gap < (straight ? kWideBridge : kBridge) * width_ && -dot(out, there) > kAgree)
                pairs.emplace_back(gap, other, end);
            }
      cells[{i, j}].push_back(end);
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [gap, x, y] : pairs)
      if (link_[x] == kNone && link_[y] == kNone) connect(x, y);
  }

  void trace() {
    std::vector<bool> done(segments_.size());
    const auto follow = [&](Index start) {
      Stroke stroke;
      bool crease = true, closed = false;
      Index end = start;
      while (true) {
        done[end / 2] = true;
        crease = crease && segments_[end / 2].crease;
        if (stroke.points.empty() || stroke.points.back() != place(end))
          stroke.points.push_back(place(end));
        stroke.points.push_back(place(end ^ 1U));
        const Index next = link_[end ^ 1U];
        if (next == kNone) break;
        closed = next == start;
        if (closed) break;
        end = next;
      }
      if (closed && stroke.points.back() != stroke.points.front())
        stroke.points.push_back(stroke.points.front());
      chains_.push_back({std::move(stroke.points), crease, closed, held_[start], held_[end ^ 1U]});
    };
    for (Index end = 0; end < link_.size(); ++end)
      if (!done[end / 2] && link_[end] == kNone) follow(end);
    for (Index end = 0; end < link_.size(); end += 2)
      if (!done[end / 2]) follow(end);
  }

  const Scene& scene_;
  const View& view_;
  const Contours& contours_;
  double width_;
  std::vector<Segment> segments_;
  std::map<Node, std::vector<Index>> nodes_;
  std::vector<bool> held_;
  std::vector<Index> link_;
  std::vector<Chain> chains_;
};

/// Strokes of chains.
class Inker {
 public:
  explicit Inker(double width) : width_(width) {}

  DrawnContours run(std::vector<Chain> chains) {
    chains_ = std::move(chains);
    finish();
    return std::move(result_);
  }

 private:
  /// Leaves out what is too short, and finds which ends touch other ink: these are not free.
  void finish() {
    std::vector<Chain> kept;
    for (Chain& c : chains_) {
      c.length = length_of(c.points);
      if (c.length < (c.crease ? kShortestCrease : kShortest) * width_) {
        ++result_.suppressed;
        result_.suppressed_length += c.length;
        continue;
      }
      c.points = resample(c.points, 0.5 * width_);
      kept.push_back(std::move(c));
    }
    hold_ends(kept);
    for (const Chain& c : kept) add_stroke(c);
  }

  void hold_ends(std::vector<Chain>& chains) const {
    const double reach = kTouch * width_;
    std::map<std::pair<long, long>, std::vector<std::pair<std::size_t, std::size_t>>> cells;
    const auto cell = [&](const Vec2& p) {
      return std::pair{std::lround(p[0] / reach), std::lround(p[1] / reach)};
    };
    for (std::size_t c = 0; c < chains.size(); ++c)
      for (std::size_t i = 0; i < chains[c].points.size(); ++i)
        cells[cell(chains[c].points[i])].emplace_back(c, i);
    const auto touches = [&](std::size_t c, std::size_t i) {
      const Vec2& p = chains[c].points[i];
      const auto [x, y] = cell(p);
      for (long dx = -1; dx <= 1; ++dx)
        for (long dy = -1; dy <= 1; ++dy)
          if (const auto found = cells.find({x + dx, y + dy}); found != cells.end())
            for (const auto& [d, j] : found->second) {
              const bool own = d == c && (i > j ? i - j : j - i) < 12;
              if (!own && norm(chains[d].points[j] - p) < reach) return true;
            }
      return false;
    };
    for (std::size_t c = 0; c < chains.size(); ++c) {
      chains[c].held_start = chains[c].held_start || touches(c, 0);
      chains[c].held_end = chains[c].held_end || touches(c, chains[c].points.size() - 1);
    }
  }

  void add_stroke(const Chain& c) {
    Stroke stroke;
    stroke.points = smooth(c.points, c.closed);
    const auto last = static_cast<double>(stroke.points.size() - 1);
    const double step = c.length / last, taper = std::min(kTaper * width_, 0.4 * c.length);
    const double full = (c.crease ? 0.7 : 1) * width_;
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      double reach = HUGE_VAL;
      if (!c.closed && !c.held_start) reach = step * static_cast<double>(i);
      if (!c.closed && !c.held_end) reach = std::min(reach, step * (last - static_cast<double>(i)));
      stroke.widths.push_back(full * (0.15 + 0.85 * std::min(1.0, reach / taper)));
    }
    stroke.rank = static_cast<Index>(result_.strokes.size());
    result_.strokes.push_back(std::move(stroke));
  }

  /// Averages that stay within half a width; ends and corners stay where they are.
  std::vector<Vec2> smooth(const std::vector<Vec2>& line, bool closed) const {
    const auto n = static_cast<long>(line.size());
    const auto wrapped = [&](long i) {
      if (closed) return static_cast<std::size_t>((i % (n - 1) + n - 1) % (n - 1));
      return static_cast<std::size_t>(std::clamp(i, 0L, n - 1));
    };
    std::vector<bool> fixed(line.size());
    constexpr long kReach = 6;  // steps of half a width
    for (long i = 0; i < n; ++i) {
      const Vec2 in = line[wrapped(i)] - line[wrapped(i - kReach)];
      const Vec2 out = line[wrapped(i + kReach)] - line[wrapped(i)];
      fixed[static_cast<std::size_t>(i)] = !(dot(unit(in), unit(out)) > 0.35);
    }
    if (!closed) fixed.front() = fixed.back() = true;
    std::vector<Vec2> now = line, next = line;
    for (int round = 0; round < 24; ++round) {
      for (long i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (fixed[k]) continue;
        const Vec2 mean = 0.5 * (now[wrapped(i - 1)] + now[wrapped(i + 1)]);
        const Vec2 off = 0.5 * (now[k] + mean) - line[k];
        const double most = 0.5 * width_, size = norm(off);
        next[k] = line[k] + (size > most ? most / size : 1.0) * off;
      }
      if (closed) next.back() = next.front();
      std::swap(now, next);
    }
    return now;
  }

  double width_;
  std::vector<Chain> chains_;
  DrawnContours result_;
};

}  // namespace

DrawnContours draw_contours(const Scene& scene, const View& view, const Contours& contours,
                            const ChainOptions& options) {
  Chainer chainer(scene, view, contours, options.line_width);
  DrawnContours drawn = Inker(options.line_width).run(chainer.run());
  drawn.visible_length = chainer.visible_length;
  return drawn;
}

}  // namespace crest::line_art
