// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_skeleton/reference_compression.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "certify/compression/encode.hpp"
#include "certify/verify.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using u32 = std::uint32_t;
using Triangle = std::array<u32, 3>;

double area(const PlaneField& f, const Triangle& t) {
  const auto &p = f.positions[t[0]], &q = f.positions[t[1]], &r = f.positions[t[2]];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

bool holds(const Triangle& t, u32 v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

/// Neighbours of a vertex, by how many of its triangles have them.
std::map<u32, int> neighbours(const Triangles& triangles, u32 v) {
  std::map<u32, int> all;
  for (const Triangle& t : triangles)
    if (holds(t, v))
      for (const u32 w : t)
        if (w != v) ++all[w];
  return all;
}

Triangle from_least(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Names of what a skeleton lists, in the input's vertex numbers.
class Names {
 public:
  Names(const SkeletonCertificate& c, std::vector<u32> vertices)
      : c_(c), vertices_(std::move(vertices)) {}

  u32 vertex(u32 corner) const {
    const u32 v = c_.triangles[corner / 3][corner % 3];
    return vertices_.empty() ? v : vertices_[v];
  }
  Triangle triangle(u32 t) const {
    return from_least({vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)});
  }
  /// Of a zero: its place and vertices.
  std::vector<u32> zero(u32 k) const {
    const SkeletonZero& z = c_.zeros[k];
    std::vector<u32> name = {static_cast<u32>(z.place)};
    if (z.place == ZeroPlace::triangle) {
      for (const u32 v : triangle(z.triangle)) name.push_back(v);
      return name;
    }
    for (const u32 i : {0U, 1U, 2U})
      if (c_.vectors[c_.triangles[z.triangle][i]] == std::array{0.0, 0.0}) {
        name.push_back(vertex(3 * z.triangle + i));
        return name;
      }
    return name;
  }
  std::vector<u32> switch_point(u32 k) const {
    const u32 side = c_.switches[k].side, head = side % 3 == 2 ? side - 2 : side + 1;
    return {c_.switches[k].place, vertex(head)};
  }
  /// Of a line: where it starts.
  std::vector<u32> line(u32 i) const {
    const SkeletonSeparatrix& s = c_.separatrices[i];
    std::vector<u32> name = s.origin == SkeletonOrigin::zero ? zero(s.from) : switch_point(s.from);
    name.insert(name.end(), {static_cast<u32>(s.origin), s.backward});
    if (s.origin == SkeletonOrigin::zero && !s.legs.empty()) {
      const u32 side = s.legs[0].corner;
      name.insert(name.end(), {vertex(side), vertex(side % 3 == 2 ? side - 2 : side + 1)});
    }
    return name;
  }

 private:
  const SkeletonCertificate& c_;
  std::vector<u32> vertices_;
};

/// Equal names in their order.
template <class Name>
std::vector<u32> map_by(std::size_t before, std::size_t after, const Name& name_before,
                        const Name& name_after) {
  std::map<std::vector<u32>, std::vector<u32>> places;
  for (u32 j = static_cast<u32>(after); j-- > 0;) places[name_after(j)].push_back(j);
  std::vector<u32> map(before, kNotStated);
  for (u32 i = 0; i < before; ++i) {
    auto& list = places[name_before(i)];
    if (list.empty()) continue;
    map[i] = list.back();
    list.pop_back();
  }
  return map;
}

/// Zeros that have moved correspond in the order of their classes, their rays by their ends.
void map_moved(CompressionCertificate& c) {
  std::vector<bool> used(c.output.zeros.size(), false);
  for (const u32 k : c.zeros)
    if (k < used.size()) used[k] = true;
  for (u32 i = 0; i < c.zeros.size(); ++i)
    for (u32 k = 0; k < used.size() && c.zeros[i] == kNotStated; ++k)
      if (!used[k] && c.output.zeros[k].kind == c.input.zeros[i].kind) {
        c.zeros[i] = k;
        used[k] = true;
      }
  std::vector<bool> taken(c.output.separatrices.size(), false);
  for (const u32 j : c.separatrices)
    if (j < taken.size()) taken[j] = true;
  const auto find = [&](const SkeletonSeparatrix& a, bool ends) {
    for (u32 j = 0; j < taken.size(); ++j) {
      const auto& b = c.output.separatrices[j];
      if (taken[j] || b.origin != a.origin || b.backward != a.backward ||
          b.from != (a.origin == SkeletonOrigin::zero ? c.zeros[a.from] : a.from) ||
          (ends && (b.end != a.end || b.to != (a.end == SkeletonEnd::zero ? c.zeros[a.to] : a.to))))
        continue;
      taken[j] = true;
      return j;
    }
    return kNotStated;
  };
  for (const bool ends : {true, false})
    for (u32 i = 0; i < c.separatrices.size(); ++i)
      if (c.separatrices[i] == kNotStated) c.separatrices[i] = find(c.input.separatrices[i], ends);
}

}  // namespace

Triangles collapsed(const PlaneField& field, const Triangles& triangles, u32 from, u32 to) {
  const auto around = neighbours(triangles, from);
  std::vector<u32> ends;
  int common = 0;
  const auto others = neighbours(triangles, to);
  for (const auto& [v, count] : around) {
    if (count == 1) ends.push_back(v);
    common += others.count(v) != 0;
  }
  const bool boundary = !ends.empty();
  if (around.count(to) == 0 || common != (boundary ? 1 : 2)) return {};
  if (boundary && (ends.size() != 2 || (ends[0] != to && ends[1] != to) ||
                   area(field, {from, ends[0], ends[1]}) != 0))
    return {};
  Triangles result;
  for (Triangle t : triangles) {
    if (holds(t, from) && holds(t, to)) continue;
    std::replace(t.begin(), t.end(), from, to);
    if (!(area(field, t) > 0)) return {};
    result.push_back(t);
  }
  return result;
}

Triangles flipped(const Triangles& triangles, u32 a, u32 b) {
  Triangles result = triangles;
  std::vector<std::pair<Triangle*, u32>> sides;  // the triangle, its corner across
  for (Triangle& t : result)
    if (holds(t, a) && holds(t, b))
      sides.push_back({&t, t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2]});
  if (sides.size() != 2) return {};
  // Each gives one end of the edge for the corner across from it in the other.
  std::replace(sides[0].first->begin(), sides[0].first->end(), b, sides[1].second);
  std::replace(sides[1].first->begin(), sides[1].first->end(), a, sides[0].second);
  return result;
}

bool are_positive(const PlaneField& field, const Triangles& triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    using kernel::Rational;
    const auto &p = field.positions[t[0]], &q = field.positions[t[1]], &r = field.positions[t[2]];
    const auto from_p = [&](const auto& x, std::size_t k) {
      return Rational(Rational(x[k]) - Rational(p[k]));
    };
    return from_p(q, 0) * from_p(r, 1) > from_p(q, 1) * from_p(r, 0);
  });
}

CompressionCertificate claim_of(const PlaneField& field, const SkeletonCertificate& skeleton,
                                const Triangles& triangles, SkeletonNotion notion) {
  CompressionCertificate c;
  c.notion = notion;
  c.input = skeleton;
  std::set<u32> kept;
  for (const Triangle& t : triangles) kept.insert(t.begin(), t.end());
  c.vertices.assign(kept.begin(), kept.end());
  std::map<u32, u32> number;
  PlaneField small;
  for (const u32 v : c.vertices) {
    number[v] = static_cast<u32>(small.positions.size());
    small.positions.push_back(field.positions[v]);
    small.vectors.push_back(field.vectors[v]);
  }
  for (const Triangle& t : triangles)
    small.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  c.output = reference_skeleton(small);
  const Names in(c.input, {}), out(c.output, c.vertices);
  using Name = std::function<std::vector<u32>(u32)>;
  c.zeros = map_by<Name>(
      c.input.zeros.size(), c.output.zeros.size(), [&](u32 k) { return in.zero(k); },
      [&](u32 k) { return out.zero(k); });
  c.separatrices = map_by<Name>(
      c.input.separatrices.size(), c.output.separatrices.size(), [&](u32 i) { return in.line(i); },
      [&](u32 i) { return out.line(i); });
  for (u32 i = 0; i < c.input.orbits.size(); ++i) c.orbits.push_back(i);
  if (notion == SkeletonNotion::relaxed) map_moved(c);
  return c;
}

CompressionCertificate reference_compression(const PlaneField& field, SkeletonNotion notion,
                                             std::size_t tries, Random& random) {
  const SkeletonCertificate skeleton = reference_skeleton(field);
  Triangles triangles = field.triangles;
  CompressionCertificate best = claim_of(field, skeleton, triangles, notion);
  std::size_t batch = 16;
  for (std::size_t tried = 0; tried < tries;) {
    Triangles next = triangles;
    for (std::size_t k = 0; k < batch; ++k, ++tried) {
      const Triangle& t = next[static_cast<std::size_t>(random() % next.size())];
      const auto corner = static_cast<std::size_t>(random() % 3);
      const Triangles moved = collapsed(field, next, t[corner], t[(corner + 1) % 3]);
      if (!moved.empty()) next = moved;
    }
    const CompressionCertificate c = claim_of(field, skeleton, next, notion);
    if (verify(encode(c)).accepted) {
      best = c;
      triangles = next;
    } else {
      batch = std::max<std::size_t>(1, batch / 2);
    }
  }
  return best;
}

}  // namespace crest::tests
