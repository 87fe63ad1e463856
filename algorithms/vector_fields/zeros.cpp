// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/zeros.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::dot;
using kernel::Sign;
using kernel::operator-;

namespace {

/// A place of the zero set in a triangle that is not inside it.
struct TiedPlace {
  Index triangle;
  HalfEdge name;  ///< fan: the least half-edge that leaves it; edge: the lesser half-edge
  bool vertex;
  friend auto operator<=>(const TiedPlace&, const TiedPlace&) = default;
};

CriticalPoint classify(const Domain& domain, Index t, Sign turn) {
  CriticalPoint item;
  item.simplex = t;
  item.point = zero_in_triangle(domain.corners(t));
  item.jacobian = jacobian(domain, t);
  item.index = static_cast<int>(turn);
  if (turn == Sign::negative) {
    item.kind = ZeroKind::saddle;
    return item;
  }
  const auto data = domain.corners(t);
  const Sign trace = kernel::trace_sign(data);
  item.kind = trace == Sign::positive   ? ZeroKind::source
              : trace == Sign::negative ? ZeroKind::sink
                                        : ZeroKind::centre;
  item.focus = trace != Sign::zero && kernel::field_discriminant_sign(data) == Sign::negative;
  return item;
}

/// Finds zeros inside triangles at once and collects the triangles with ties.
class Scan {
 public:
  explicit Scan(const Domain& domain) : domain_(domain) {
    for (Index t = 0; t < domain.triangle_count(); ++t) {
      const auto& [i, j, k] = domain.field().triangles[t];
      const Vec2 &a = domain.vector(i), &b = domain.vector(j), &c = domain.vector(k);
      const double p = a[0] * b[1], q = a[1] * b[0], r = b[0] * c[1], s = b[1] * c[0],
                   u = c[0] * a[1], v = c[1] * a[0];
      const bool left = p > q && r > s && u > v, right = p < q && r < s && u < v;
      if (left || right)
        inside.push_back({t, left ? Sign::positive : Sign::negative});
      else if (p == q || r == s || u == v)
        look_closer(t, a, b, c);
    }
  }
  std::vector<std::pair<Index, Sign>> inside;
  std::vector<Index> tied;

 private:
  void look_closer(Index t, const Vec2& a, const Vec2& b, const Vec2& c) {
    const std::array<Sign, 3> turns = {kernel::vector_turn(a, b), kernel::vector_turn(b, c),
                                       kernel::vector_turn(c, a)};
    if (turns[0] != Sign::zero && turns[1] != Sign::zero && turns[2] != Sign::zero) {
      if (turns[0] == turns[1] && turns[1] == turns[2]) inside.push_back({t, turns[0]});
    } else if (domain_.live(t)) {
      tied.push_back(t);
    }
  }
  const Domain& domain_;
};

/// Whether the field vanishes strictly inside the edge. Requires: its ends' turn is zero.
bool opposite(const Vec2& a, const Vec2& b) {
  // Parallel vectors point to opposite sides iff a coordinate has opposite signs.
  return (a[0] > 0 && b[0] < 0) || (a[0] < 0 && b[0] > 0) || (a[1] > 0 && b[1] < 0) ||
         (a[1] < 0 && b[1] > 0);
}

class Components {
 public:
  Components(const Domain& domain, const std::vector<Index>& tied) : domain_(domain) {
    for (const Index t : tied) collect(t);
    std::sort(places_.begin(), places_.end());
  }

  std::vector<ZeroComponent> take() {
    std::vector<HalfEdge> names;  // even: fans, odd: edges
    for (const TiedPlace& p : places_) names.push_back(key(p));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const auto number = [&](const TiedPlace& p) {
      return static_cast<Index>(std::lower_bound(names.begin(), names.end(), key(p)) -
                                names.begin());
    };
    kernel::DisjointSets sets(static_cast<Index>(names.size()));
    for (std::size_t i = 1; i < places_.size(); ++i)
      if (places_[i].triangle == places_[i - 1].triangle)
        sets.unite(number(places_[i]), number(places_[i - 1]));
    std::vector<ZeroComponent> found;
    std::unordered_map<Index, std::size_t> where;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto [at, fresh] = where.try_emplace(sets.find(number(places_[i])), found.size());
      if (fresh) found.emplace_back();
      add(found[at->second], i);
    }
    for (ZeroComponent& c : found) finish(c);
    return found;
  }

 private:
  static HalfEdge key(const TiedPlace& p) { return 2 * p.name + (p.vertex ? 0 : 1); }

  void collect(Index t) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Index a = domain_.from(h), b = domain_.to(h);
      if (domain_.is_zero(a)) places_.push_back({t, fan_name(h), true});
      if (!domain_.is_zero(a) && !domain_.is_zero(b) &&
          kernel::vector_turn(domain_.vector(a), domain_.vector(b)) == Sign::zero &&
          opposite(domain_.vector(a), domain_.vector(b)))
        places_.push_back({t, std::min(h, domain_.twin(h)), false});
    }
  }
  HalfEdge fan_name(HalfEdge h) {
    const auto known = fans_.find(h);
    if (known != fans_.end()) return known->second;
    const Fan fan = domain_.fan(h);
    const HalfEdge name = *std::min_element(fan.leaving.begin(), fan.leaving.end());
    for (const HalfEdge g : fan.leaving) fans_[g] = name;
    if (!fan.closed) open_.insert(name);
    return name;
  }

  void add(ZeroComponent& c, std::size_t i) {
    const TiedPlace& p = places_[i];
    const bool second = !c.triangles.empty() && c.triangles.back() == p.triangle;
    if (!second) c.triangles.push_back(p.triangle);
    if (second && c.item.where != ZeroPlace::region) c.item.where = ZeroPlace::line;
    if (c.place == kNone) {
      c.place = p.name;
      c.item.where = p.vertex ? ZeroPlace::vertex : ZeroPlace::edge;
    }
    if (p.vertex) {
      c.at_boundary = c.at_boundary || open_.count(p.name) > 0;
      for (HalfEdge h = 3 * p.triangle; h < 3 * p.triangle + 3; ++h)
        if (domain_.at_region(h)) c.item.where = ZeroPlace::region;
    } else {
      c.at_boundary = c.at_boundary || domain_.twin(p.name) == kNone;
    }
  }

  void finish(ZeroComponent& c) {
    const ZeroPlace where = c.item.where;
    c.at_boundary = c.at_boundary || where == ZeroPlace::line || where == ZeroPlace::region;
    const Index a = domain_.from(c.place), b = domain_.to(c.place);
    const bool vertex = domain_.is_zero(a);
    c.item.point = domain_.point(a);
    if (!vertex) {
      const double s = std::hypot(domain_.vector(a)[0], domain_.vector(a)[1]);
      const double t = std::hypot(domain_.vector(b)[0], domain_.vector(b)[1]);
      for (std::size_t k = 0; k < 2; ++k)
        c.item.point[k] = (t * domain_.point(a)[k] + s * domain_.point(b)[k]) / (s + t);
    }
    c.item.simplex = where == ZeroPlace::vertex ? a
                     : where == ZeroPlace::edge ? c.place
                                                : c.triangles.front();
    if (c.at_boundary) return;
    int index = 0;
    for (const Index t : c.triangles) index += symbolic_index(domain_, t);
    c.item.index = index;
  }

  const Domain& domain_;
  std::vector<TiedPlace> places_;
  std::unordered_map<HalfEdge, HalfEdge> fans_;
  std::unordered_set<HalfEdge> open_;
};

}  // namespace

int symbolic_index(const Domain& domain, Index t) {
  const auto& corner = domain.field().triangles[t];
  int sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index i = corner[k], j = corner[(k + 1) % 3];
    sum += static_cast<int>(kernel::symbolic_vector_turn(i, domain.vector(i), j, domain.vector(j)));
  }
  return sum / 3;
}

std::array<double, 4> jacobian(const Domain& domain, Index t) {
  const auto [p, v] = domain.corners(t);
  const Vec2 e = p[1] - p[0], f = p[2] - p[0], a = v[1] - v[0], b = v[2] - v[0];
  const double area = cross(e, f);
  return {(a[0] * f[1] - b[0] * e[1]) / area, (b[0] * e[0] - a[0] * f[0]) / area,
          (a[1] * f[1] - b[1] * e[1]) / area, (b[1] * e[0] - a[1] * f[0]) / area};
}

Vec2 zero_in_triangle(const kernel::FieldOnTriangle& data) {
  const auto& [p, v] = data;
  const double l[3] = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
  const double sum = l[0] + l[1] + l[2];
  Vec2 x = p[0];
  for (std::size_t k = 0; k < 2; ++k)
    x[k] += l[1] / sum * (p[1][k] - p[0][k]) + l[2] / sum * (p[2][k] - p[0][k]);
  return x;
}

std::vector<ZeroComponent> find_zeros(const Domain& domain) {
  const Scan scan(domain);
  std::vector<ZeroComponent> found = Components(domain, scan.tied).take();
  for (const auto& [t, turn] : scan.inside) {
    ZeroComponent& c = found.emplace_back();
    c.triangles = {t};
    c.item = classify(domain, t, turn);
  }
  std::sort(found.begin(), found.end(), [](const ZeroComponent& a, const ZeroComponent& b) {
    return a.triangles.front() < b.triangles.front();
  });
  return found;
}

}  // namespace crest::vector_fields
