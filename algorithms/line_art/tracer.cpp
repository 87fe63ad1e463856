// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/tracer.hpp"

#include <algorithm>
#include <cmath>

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr double kShun = 0.6;  // spacings short of a singularity lines end

Vec2 wide(const std::array<float, 2>& d) {
  return {d[0], d[1]};
}

}  // namespace

LinePoints::LinePoints(const Vec2& page, double reach, const Barriers& barriers)
    : barriers_(barriers),
      reach_(reach),
      columns_(static_cast<int>(page[0] / reach) + 1),
      rows_(static_cast<int>(page[1] / reach) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void LinePoints::add(const Vec2& p, Index line, Index number) {
  const auto [c, r] = cell(p);
  cells_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(c)]
      .push_back({p, line, number});
}

Tracer::Tracer(const Buffers& buffers, const Barriers& barriers, std::vector<Vec2> singular,
               double spacing, bool crosses)
    : buffers_(buffers),
      barriers_(barriers),
      singular_(std::move(singular)),
      spacing_(spacing),
      crosses_(crosses) {
  std::sort(singular_.begin(), singular_.end());
}

Vec2 Tracer::pick(std::size_t pixel, Family family, const Vec2& ahead) const {
  const Vec2 rib = wide(buffers_.rib[pixel]), backbone = wide(buffers_.backbone[pixel]);
  const bool turned = crosses_ && ahead != Vec2{0, 0}
                          ? std::abs(dot(backbone, ahead)) > std::abs(dot(rib, ahead))
                          : family == Family::backbone;
  const Vec2 d = turned ? backbone : rib;
  return dot(d, ahead) < 0 ? -1.0 * d : d;
}

std::optional<Vec2> Tracer::direction(const Vec2& p, Family family, const Vec2& ahead) const {
  const auto own = buffers_.at(p);
  if (!own || buffers_.face[*own] == kNone) return std::nullopt;
  const Vec2 first = pick(*own, family, ahead);
  if (first == Vec2{0, 0}) return std::nullopt;
  // Bilinear over the centres around, as far as they are of the same sheet.
  const double u = p[0] / buffers_.pixel - 0.5, v = p[1] / buffers_.pixel - 0.5;
  const double fu = u - std::floor(u), fv = v - std::floor(v);
  Vec2 sum{0, 0};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const Vec2 centre = {(std::floor(u) + i + 0.5) * buffers_.pixel,
                           (std::floor(v) + j + 0.5) * buffers_.pixel};
      const auto at = buffers_.at(centre);
      if (!at || buffers_.face[*at] == kNone) continue;
      const Vec2 d = pick(*at, family, first);
      if (dot(d, first) < 0.8) continue;
      sum = sum + ((i == 0 ? 1 - fu : fu) * (j == 0 ? 1 - fv : fv)) * d;
    }
  const double n = norm(sum);
  return n > 0 ? (1 / n) * sum : first;
}

bool Tracer::near_singularity(const Vec2& p) const {
  const double reach = kShun * spacing_;
  auto s = std::lower_bound(singular_.begin(), singular_.end(), Vec2{p[0] - reach, p[1]});
  for (; s != singular_.end() && (*s)[0] < p[0] + reach; ++s)
    if (norm(*s - p) < reach) return true;
  return false;
}

Trace Tracer::trace(const Vec2& start, const Vec2& ahead, Family family, double most_turn,
                    const Stop& stop) const {
  Trace trace;
  trace.points.push_back(start);
  Vec2 p = start;
  const auto first = direction(p, family, ahead);
  if (!first) return trace;
  Vec2 d = *first;
  double turned = 0;
  while (trace.points.size() < 4000) {
    const auto middle = direction(p + (0.5 * kStep) * d, family, d);
    const Vec2 m = middle.value_or(d);
    const Vec2 q = p + kStep * m;
    const double share = barriers_.free_share(p, q, kClearance);
    if (share < 1) {
      trace.end = Trace::End::contour;
      if (share > 0.1) trace.points.push_back(p + share * kStep * m);
      return trace;
    }
    const auto next = direction(q, family, m);
    if (!next) {
      if (barriers_.nearest(q, 2 * buffers_.pixel)) trace.end = Trace::End::contour;
      return trace;
    }
    const double turn = std::atan2(cross(d, *next), dot(d, *next));
    turned += turn;
    if (std::abs(turn) > 0.6 || std::abs(turned) > most_turn) {
      trace.end = Trace::End::turned;
      return trace;
    }
    if (near_singularity(q)) {
      trace.end = Trace::End::singularity;
      return trace;
    }
    if (stop(q, static_cast<Index>(trace.points.size()))) {
      trace.end = Trace::End::line;
      return trace;
    }
    trace.points.push_back(q);
    p = q;
    d = *next;
  }
  return trace;
}

}  // namespace crest::line_art
