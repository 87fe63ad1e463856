// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/bijection.hpp"

#include <algorithm>
#include <set>

#include "certify/container/reject.hpp"

namespace crest::certify::compression {
namespace {

class ZeroCheck {
 public:
  ZeroCheck(const Match& match, const Map& zeros, SkeletonNotion notion, SignLadder& sign)
      : in_(match.in),
        out_(match.out),
        match_(match),
        zeros_(zeros),
        notion_(notion),
        sign_(sign) {}

  void run() {
    for (u32 k = 0; k < zeros_.to.size(); ++k) check_stated(k);
    std::vector<std::size_t> left;  // triangles that meet each zero
    for (const u32 of : in_.zeros.of_triangle) count(of, left);
    for (u32 t = 0; t < out_.field.triangles(); ++t) {
      const u32 of = out_.zeros.of_triangle[t];
      if (of == kNone || !keeps_triangles(of)) continue;
      const u32 corner = match_.corner[3 * t];
      require(corner != kNone && in_.zeros.of_triangle[corner / 3] == zeros_.from[of],
              "zero {} of the output: triangle {} around it is not the input's", of, t);
      --left[zeros_.from[of]];
    }
    for (u32 k = 0; k < zeros_.to.size(); ++k)
      require(!keeps_triangles(zeros_.to[k]) || left[k] == 0,
              "zero {}: a triangle around it is gone", k);
    check_zero_vertices();
    check_edge_zeros();
  }

 private:
  static void count(u32 number, std::vector<std::size_t>& counts) {
    if (number == kNone) return;
    if (counts.size() <= number) counts.resize(number + 1, 0);
    ++counts[number];
  }
  bool keeps_triangles(u32 output_zero) const {
    const ZeroPlace place = out_.stated.zeros[output_zero].place;
    if (place == ZeroPlace::triangle) return notion_ != SkeletonNotion::relaxed;
    return place == ZeroPlace::edge || place == ZeroPlace::vertex;
  }

  void check_stated(u32 k) const {
    const SkeletonZero &a = in_.stated.zeros[k], &b = out_.stated.zeros[zeros_.to[k]];
    const bool moves = notion_ == SkeletonNotion::relaxed && a.place == ZeroPlace::triangle;
    require(a.place == b.place && a.kind == b.kind && (a.focus == b.focus || moves) &&
                a.index == b.index && a.hyperbolic == b.hyperbolic && a.elliptic == b.elliptic,
            "zero {} is another one in the output", k);
  }

  u32 zero_of(const Proof& proof, u32 corner) const { return proof.zeros.of_triangle[corner / 3]; }

  /// Vertices with a zero vector: the same, in the same components.
  void check_zero_vertices() const {
    const auto count = [](const Proof& proof) {
      std::size_t n = 0;
      for (u32 f = 0; f < proof.domain.open.size(); ++f)
        n += is_zero(proof.field.vector(proof.domain.corners_of(f)[0]));
      return n;
    };
    require(count(in_) == count(out_), "{} vertices without flow, {} in the output", count(in_),
            count(out_));
    for (u32 f = 0; f < out_.domain.open.size(); ++f) {
      const u32 corner = out_.domain.corners_of(f)[0];
      if (!is_zero(out_.field.vector(corner))) continue;
      const u32 there = in_.domain.corners_of(match_.fan[f])[0];
      require(zero_of(in_, there) == zeros_.from[zero_of(out_, corner)],
              "vertex {} of the output: in another zero", out_.field.vertex(corner));
    }
  }

  /// Zeros inside sides, by the vertices of the sides, with their components.
  std::vector<std::array<u32, 3>> edge_zeros(const Proof& proof, bool output) const {
    std::vector<std::array<u32, 3>> all;
    for (u32 c = 0; c < proof.field.corners(); ++c) {
      if (proof.domain.live[c / 3] == 0 ||
          (proof.domain.twin[c] != kNone && proof.domain.twin[c] < c) ||
          !has_edge_zero(proof.field, c, sign_))
        continue;
      u32 tail = proof.domain.fan[c], head = proof.domain.fan[next_corner(c)],
          zero = zero_of(proof, c);
      if (output) {
        tail = match_.fan[tail];
        head = match_.fan[head];
        zero = zeros_.from[zero];
      }
      all.push_back({std::min(tail, head), std::max(tail, head), zero});
    }
    std::sort(all.begin(), all.end());
    return all;
  }
  void check_edge_zeros() const {
    require(edge_zeros(in_, false) == edge_zeros(out_, true), "zeros inside edges are others");
  }

  const Proof &in_, &out_;
  const Match& match_;
  const Map& zeros_;
  SkeletonNotion notion_;
  SignLadder& sign_;
};

class LineCheck {
 public:
  LineCheck(const Match& match, const ArrivalTable& in, const ArrivalTable& out, const Maps& maps)
      : match_(match), in_(in), out_(out), maps_(maps) {}

  std::size_t run() {
    std::size_t open = 0;
    for (u32 i = 0; i < maps_.separatrices.to.size(); ++i) {
      const u32 j = maps_.separatrices.to[i];
      check_start(i, j);
      check_end(i, j);
      open += match_.in.stated.separatrices[i].end == SkeletonEnd::undecided;
    }
    check_moved_saddles();
    return open;
  }

 private:
  const SkeletonSeparatrix& before(u32 i) const { return match_.in.stated.separatrices[i]; }
  const SkeletonSeparatrix& after(u32 j) const { return match_.out.stated.separatrices[j]; }

  bool same_origin(const SkeletonSeparatrix& a, const SkeletonSeparatrix& b) const {
    if (a.origin != b.origin) return false;
    if (a.origin == SkeletonOrigin::vertex)
      return match_.in.domain.fan[a.from] == match_.fan[match_.out.domain.fan[b.from]];
    return a.from == (a.origin == SkeletonOrigin::zero ? maps_.zeros.from[b.from]
                                                       : match_.switch_point[b.from]);
  }

  /// Inside a triangle that is not the input's.
  bool moved(u32 output_zero) const {
    const SkeletonZero &there = match_.in.stated.zeros[maps_.zeros.from[output_zero]],
                       &here = match_.out.stated.zeros[output_zero];
    const u32 corner = match_.corner[3 * here.triangle];
    return here.place == ZeroPlace::triangle && (corner == kNone || corner / 3 != there.triangle);
  }

  void check_start(u32 i, u32 j) const {
    const SkeletonSeparatrix &a = before(i), &b = after(j);
    require(same_origin(a, b) && a.backward == b.backward && a.legs.empty() == b.legs.empty(),
            "separatrix {}: starts elsewhere in the output", i);
    if (a.legs.empty() || a.origin != SkeletonOrigin::zero || moved(b.from)) return;
    const Ray &ray = match_.in.claimed[i].ray, &other = match_.out.claimed[j].ray;
    bool same = ray.root == other.root && (ray.exit == kNone) == (other.exit == kNone);
    if (ray.exit != kNone && other.exit != kNone)
      same = same &&
             ray.exit == (other.root == 3 ? match_.fan[other.exit] : match_.corner[other.exit]);
    if (ray.exit == kNone && other.exit == kNone)
      same = same && in_.paths[i].direction == out_.paths[j].direction &&
             fan_of(match_.in, in_.paths[i]) == match_.fan[fan_of(match_.out, out_.paths[j])];
    require(same, "separatrix {}: another ray of its zero in the output", i);
  }
  /// Of the corner that a straight line from a vertex starts at.
  static u32 fan_of(const Proof& proof, const Path& path) {
    require(path.cells[0].entry == Entry::vertex, "a straight line from no vertex");
    return proof.domain.fan[path.cells[0].name];
  }

  void check_end(u32 i, u32 j) const {
    const SkeletonSeparatrix &a = before(i), &b = after(j);
    require(a.end == b.end, "separatrix {}: ends otherwise in the output", i);
    const u32 to = b.end == SkeletonEnd::zero           ? maps_.zeros.from[b.to]
                   : b.end == SkeletonEnd::switch_point ? match_.switch_point[b.to]
                   : b.end == SkeletonEnd::boundary     ? match_.region[b.to]
                   : b.end == SkeletonEnd::orbit        ? maps_.orbits.from[b.to]
                                                        : 0;
    require(a.to == to, "separatrix {}: ends elsewhere in the output", i);
    if (a.end == SkeletonEnd::zero && !is_ordered(match_.in.zeros.components[a.to], i))
      check_last(i, j);
  }
  /// Whether the order of arrivals tells where it arrives.
  bool is_ordered(const Component& zero, u32 i) const {
    switch (zero.stated.place) {
      case ZeroPlace::triangle:
        return zero.stated.kind != ZeroClass::saddle;
      case ZeroPlace::vertex:
      case ZeroPlace::edge:
        return zero.stated.index != kNoIndex && zero.stated.hyperbolic == 0;
      default: {
        const u32 exit = in_.paths[i].cells.back().exit;
        return exit != kNone && match_.in.domain.twin[exit] == kNone;
      }
    }
  }
  /// A straight line comes to its zero through the same triangle, in the same direction.
  void check_last(u32 i, u32 j) const {
    const Path &a = in_.paths[i], &b = out_.paths[j];
    const Cell &p = a.cells.back(), &q = b.cells.back();
    require(!a.trace->straight.empty() && a.direction == b.direction && p.entry == q.entry &&
                match_.corner[q.name] == p.name,
            "separatrix {}: comes to its zero in another way in the output", i);
  }

  /// Its four rays keep their order.
  void check_moved_saddles() {
    std::vector<std::vector<u32>> rays(match_.out.stated.zeros.size());
    for (u32 j = 0; j < maps_.separatrices.from.size(); ++j)
      if (const auto& b = after(j); b.origin == SkeletonOrigin::zero && moved(b.from))
        rays[b.from].push_back(j);
    for (u32 k = 0; k < rays.size(); ++k) {
      if (rays[k].empty()) continue;
      std::vector<u32> turned = rays[k];
      for (u32& line : turned) line = maps_.separatrices.from[line];
      sort_around(match_.out, rays[k]);
      sort_around(match_.in, turned);
      for (u32& line : turned) line = maps_.separatrices.to[line];
      std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), rays[k][0]),
                  turned.end());
      require(turned == rays[k], "zero {} of the output: its rays are in another order", k);
    }
  }
  /// Counter-clockwise from corner 0 of the saddle's triangle on.
  void sort_around(const Proof& proof, std::vector<u32>& lines) {
    const auto place = [&](u32 line) {
      const Claimed& claimed = proof.claimed[line];
      require(claimed.known, "separatrix {}: of a zero that has moved, and not known", line);
      const u32 triangle = proof.stated.zeros[claimed.from].triangle;
      const Ray& ray = claimed.ray;
      if (ray.root != 3) return 4 * (ray.exit % 3) + 1 + 2 * second_in_side(proof, ray);
      for (const u32 k : {0U, 1U, 2U})
        if (proof.domain.fan[3 * triangle + k] == ray.exit) return 4 * k;
      throw Reject("a ray through another triangle's vertex");
    };
    std::sort(lines.begin(), lines.end(), [&](u32 a, u32 b) { return place(a) < place(b); });
  }
  /// Whether, of a ray out and one in that leave through one side, it is the nearer to the head.
  u32 second_in_side(const Proof& proof, const Ray& ray) {
    const u32 side = ray.exit, t = side / 3;
    const Component& zero = proof.zeros.components[proof.zeros.of_triangle[t]];
    const Plane<Rational> z = zero_point(proof.field, proof.domain, zero);
    const Rational swirl =
        det(exact(proof.field.position(side)) - z, exact(proof.field.vector(side)));
    // Before a ray that goes out flow turns counter-clockwise.
    return (swirl > 0) != ray.out ? 1 : 0;
  }

  const Match& match_;
  const ArrivalTable &in_, &out_;
  const Maps& maps_;
};

/// Every group ascends; a cyclic list begins with the least number.
void normalise(Arrivals& arrivals) {
  for (auto& group : arrivals.lines) std::sort(group.begin(), group.end());
  if (arrivals.cyclic)
    std::rotate(arrivals.lines.begin(),
                std::min_element(arrivals.lines.begin(), arrivals.lines.end()),
                arrivals.lines.end());
}

}  // namespace

Map::Map(const std::vector<u32>& stated, std::size_t count, const char* what)
    : to(stated), from(count, kNone) {
  require(to.size() == count, "{}: {} are mapped, {} found", what, to.size(), count);
  for (u32 i = 0; i < count; ++i) {
    require(to[i] < count && from[to[i]] == kNone, "{}: no map one to one", what);
    from[to[i]] = i;
  }
}

void check_zeros(const Match& match, const Map& zeros, SkeletonNotion notion, SignLadder& sign) {
  ZeroCheck(match, zeros, notion, sign).run();
}

void check_orbits(const std::vector<Orbit>& in, const std::vector<Orbit>& out, const Match& match,
                  const Maps& maps) {
  const auto mapped = [](const std::vector<u32>& list, const std::vector<u32>& map) {
    std::vector<u32> result;
    for (const u32 i : list) result.push_back(map[i]);
    std::sort(result.begin(), result.end());
    return result;
  };
  for (u32 i = 0; i < in.size(); ++i) {
    const Orbit &a = in[i], &b = out[maps.orbits.to[i]];
    require(a.chain.backward == b.chain.backward && a.counter_clockwise == b.counter_clockwise &&
                a.rank == b.rank && a.zeros == mapped(b.zeros, maps.zeros.from) &&
                a.loops == mapped(b.loops, match.loop),
            "orbit {} is another one in the output", i);
  }
}

std::size_t check_separatrices(const Match& match, const ArrivalTable& in, const ArrivalTable& out,
                               const Maps& maps) {
  return LineCheck(match, in, out, maps).run();
}

void check_arrivals(const Match& match, const ArrivalTable& in, const ArrivalTable& out,
                    const Maps& maps) {
  require(in.orders.size() == out.orders.size(), "lines arrive at {} places, {} in the output",
          in.orders.size(), out.orders.size());
  const auto here = [&](Place place) {
    const auto& map = place.kind == Place::region                              ? match.region
                      : place.kind == Place::wall || place.kind == Place::zero ? maps.zeros.from
                                                                               : maps.orbits.from;
    place.number = map[place.number];
    if (place.kind == Place::wall) place.loop = match.loop[place.loop];
    return place;
  };
  for (const auto& [place, listed] : out.orders) {
    Arrivals arrivals = listed;
    for (auto& group : arrivals.lines)
      for (u32& line : group) line = maps.separatrices.from[line];
    const auto found = in.orders.find(here(place));
    require(found != in.orders.end(), "lines arrive where none does in the input");
    Arrivals expected = found->second;
    normalise(expected);
    normalise(arrivals);
    require(expected.lines == arrivals.lines && expected.cyclic == arrivals.cyclic,
            "separatrix {} and those that arrive beside it: in another order in the output",
            expected.lines[0][0]);
  }
}

std::size_t check_strong(const Match& match, const ArrivalTable& in, const ArrivalTable& out,
                         const Maps& maps) {
  std::set<u32> triangles;
  const auto compare = [&](const Path& a, const Path& b, const char* what, u32 number) {
    bool same = a.cells.size() == b.cells.size();
    for (std::size_t k = 0; same && k < a.cells.size(); ++k) {
      const Cell &p = a.cells[k], &q = b.cells[k];
      // What is inside has the name of corner 0.
      same = match.corner[q.name] != kNone && p.entry == q.entry &&
             (p.entry == Entry::inside ? match.corner[q.name] / 3 == p.name / 3
                                       : match.corner[q.name] == p.name) &&
             p.exit == (q.exit == kNone ? kNone : match.corner[q.exit]);
      triangles.insert(p.name / 3);
    }
    require(same, "{} {}: meets other triangles in the output", what, number);
  };
  for (u32 i = 0; i < in.paths.size(); ++i)
    compare(in.paths[i], out.paths[maps.separatrices.to[i]], "separatrix", i);
  for (u32 i = 0; i < maps.orbits.to.size(); ++i)
    compare(chain_of(match.in, i), chain_of(match.out, maps.orbits.to[i]), "orbit", i);
  return triangles.size();
}

}  // namespace crest::certify::compression
