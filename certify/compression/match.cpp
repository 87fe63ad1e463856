// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/match.hpp"

#include <algorithm>

namespace crest::certify::compression {
namespace {

/// A triangle's vertices from the least on, and the corner there.
struct Named {
  std::array<u32, 3> vertices;
  u32 corner;
  friend bool operator<(const Named& a, const Named& b) { return a.vertices < b.vertices; }
};

template <class VertexOf>
Named named(u32 triangle, const VertexOf& vertex_of) {
  const u32 c = 3 * triangle;
  std::array<u32, 3> v = {vertex_of(c), vertex_of(c + 1), vertex_of(c + 2)};
  const auto least = std::min_element(v.begin(), v.end());
  const auto k = static_cast<u32>(least - v.begin());
  std::rotate(v.begin(), least, v.end());
  return {v, c + k};
}

class SurfaceMatch {
 public:
  SurfaceMatch(const std::vector<u32>& vertices, const Proof& in, const Proof& out,
               SignLadder& sign)
      : vertices_(vertices), in_(in), out_(out), sign_(sign), match_{in, out, {}, {},
                                                                     {}, {},  {}, {}} {}

  Match run() {
    find_triangles();
    find_chains();
    find_fans();
    find_loops();
    return std::move(match_);
  }

 private:
  u32 vertex(u32 output_corner) const { return vertices_[out_.field.vertex(output_corner)]; }

  void find_triangles() {
    std::vector<Named> all;
    for (u32 t = 0; t < in_.field.triangles(); ++t)
      all.push_back(named(t, [&](u32 c) { return in_.field.vertex(c); }));
    std::sort(all.begin(), all.end());
    match_.corner.assign(out_.field.corners(), kNone);
    for (u32 t = 0; t < out_.field.triangles(); ++t) {
      const Named wanted = named(t, [&](u32 c) { return vertex(c); });
      const auto found = std::lower_bound(all.begin(), all.end(), wanted);
      if (found == all.end() || found->vertices != wanted.vertices) continue;
      u32 to = found->corner, from = wanted.corner;
      for (int k = 0; k < 3; ++k, to = next_corner(to), from = next_corner(from))
        match_.corner[from] = to;
    }
  }

  /// The next vertex lies ahead on the line of an output side.
  bool goes_along(u32 output_side, u32 side) {
    const Pair &p = out_.field.position(output_side),
               &q = out_.field.position(next_corner(output_side)), &x = in_.field.position(side),
               &y = in_.field.position(next_corner(side));
    return orientation(sign_, p, q, y) == Sign::zero &&
           sign_([&](const auto& lift) {
             return dot(lifted(lift, q) - lifted(lift, p), lifted(lift, y) - lifted(lift, x));
           }) == Sign::positive;
  }

  void find_chains() {
    std::vector<std::array<u32, 2>> by_tail;
    for (const auto& loop : in_.domain.loops)
      for (const u32 side : loop) by_tail.push_back({in_.field.vertex(side), side});
    std::sort(by_tail.begin(), by_tail.end());
    std::vector<u8> covered(in_.field.corners(), 0);
    std::size_t count = 0;
    match_.chain.assign(out_.field.corners(), {kNone, kNone});
    for (const auto& loop : out_.domain.loops)
      for (const u32 side : loop) {
        const u32 tail = vertex(side), head = vertex(next_corner(side));
        auto at = std::lower_bound(by_tail.begin(), by_tail.end(), std::array{tail, u32{0}});
        while (at != by_tail.end() && (*at)[0] == tail && !goes_along(side, (*at)[1])) ++at;
        require(at != by_tail.end() && (*at)[0] == tail,
                "side {} of the output: no part of the input's boundary", side);
        u32 now = (*at)[1];
        match_.chain[side][0] = now;
        for (;;) {
          require(covered[now] == 0, "side {} of the input: twice on the output's boundary", now);
          covered[now] = 1;
          ++count;
          if (in_.field.vertex(next_corner(now)) == head) break;
          now = in_.domain.next_side(now);
          require(goes_along(side, now), "side {} of the output: leaves the input's boundary",
                  side);
        }
        match_.chain[side][1] = now;
      }
    require(count == by_tail.size(), "the output's boundary has {} of the input's {} sides", count,
            by_tail.size());
    for (const auto& loop : out_.domain.loops)
      for (const u32 side : loop)
        require(match_.chain[out_.domain.next_side(side)][0] ==
                    in_.domain.next_side(match_.chain[side][1]),
                "side {} of the output: goes on elsewhere than in the input", side);
  }

  void find_fans() {
    const Domain &in = in_.domain, &out = out_.domain;
    std::vector<u32> inner(in_.field.vertices(), kNone);
    for (u32 f = 0; f < in.open.size(); ++f)
      if (in.open[f] == 0) inner[in_.field.vertex(in.corners_of(f)[0])] = f;
    match_.fan.assign(out.open.size(), kNone);
    for (u32 f = 0; f < out.open.size(); ++f) {
      const auto corners = out.corners_of(f);
      match_.fan[f] = out.open[f] == 0
                          ? inner[vertex(corners[0])]
                          : in.fan[next_corner(match_.chain[previous_corner(corners.back())][1])];
      require(match_.fan[f] != kNone, "vertex {} of the output: on the input's boundary",
              out_.field.vertex(corners[0]));
    }
  }

  void find_loops() {
    std::vector<u32> of_side(in_.field.corners(), kNone);
    for (u32 i = 0; i < in_.domain.loops.size(); ++i)
      for (const u32 side : in_.domain.loops[i]) of_side[side] = i;
    for (const auto& loop : out_.domain.loops)
      match_.loop.push_back(of_side[match_.chain[loop[0]][0]]);
  }

  const std::vector<u32>& vertices_;
  const Proof &in_, &out_;
  SignLadder& sign_;
  Match match_;
};

void match_regions(Match& match) {
  const Boundary &in = match.in.boundary, &out = match.out.boundary;
  require(in.region_count == out.region_count, "{} regions of the boundary, {} in the output",
          in.region_count, out.region_count);
  match.region.assign(out.region_count, kNone);
  std::vector<u32> back(in.region_count, kNone);
  for (const auto& loop : match.out.domain.loops)
    for (const u32 side : loop)
      for (const std::size_t end : {0U, 1U}) {
        const u32 there = out.regions[side][end], here = in.regions[match.chain[side][end]][end];
        require((there == kNone) == (here == kNone), "side {} of the output: in another region",
                side);
        if (there == kNone) continue;
        if (match.region[there] == kNone && back[here] == kNone) {
          match.region[there] = here;
          back[here] = there;
        }
        require(match.region[there] == here && back[here] == there,
                "region {} of the output: not one of the input's", there);
      }
  // What lies inside a part that has become one side: tangent with it, or of its region.
  for (const auto& loop : match.out.domain.loops)
    for (const u32 side : loop)
      for (u32 now = match.chain[side][0]; now != match.chain[side][1];
           now = match.in.domain.next_side(now)) {
        const auto& parts = out.regions[side];
        const bool tangent = parts[0] == kNone && parts[1] == kNone;
        for (const u32 here : {in.regions[now][1], in.regions[match.in.domain.next_side(now)][0]})
          require(tangent ? here == kNone
                          : here != kNone && back[here] != kNone &&
                                (back[here] == parts[0] || back[here] == parts[1]),
                  "side {} of the output: another region inside it", side);
      }
}

void match_switches(Match& match) {
  const auto &in = match.in.boundary.switches, &out = match.out.boundary.switches;
  require(in.size() == out.size(), "{} switch points, {} in the output", in.size(), out.size());
  std::vector<std::array<u32, 3>> places;
  for (u32 i = 0; i < in.size(); ++i) places.push_back({in[i].side, in[i].place, i});
  std::sort(places.begin(), places.end());
  for (u32 i = 0; i < out.size(); ++i) {
    const auto& chain = match.chain[out[i].side];
    const std::array<u32, 3> wanted = {chain[1], out[i].place, 0};
    const auto found = std::lower_bound(places.begin(), places.end(), wanted);
    require(found != places.end() && (*found)[0] == wanted[0] && (*found)[1] == wanted[1] &&
                (out[i].place != 0 || chain[0] == chain[1]) &&
                in[(*found)[2]].inside == out[i].inside,
            "switch point {} of the output: none of the input", i);
    match.switch_point.push_back((*found)[2]);
  }
}

}  // namespace

Match match_surfaces(const std::vector<u32>& vertices, const Proof& in, const Proof& out,
                     SignLadder& sign) {
  return SurfaceMatch(vertices, in, out, sign).run();
}

void match_boundary(Match& match) {
  match_regions(match);
  match_switches(match);
}

}  // namespace crest::certify::compression
