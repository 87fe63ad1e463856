// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/sectors.hpp"

#include "algorithms/vector_fields/exact.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::dot;
using kernel::operator-;
using kernel::operator*;
using kernel::operator+;

namespace {

int sign(const Rational& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// Directions of the fan's edges from the apex, and the field there.
struct Star {
  std::vector<Exact> r, v;
  std::vector<HalfEdge> edges;   ///< at a vertex: those of the fan, by a half-edge that leaves it
  std::vector<HalfEdge> across;  ///< of each cone the side that faces the apex
  bool closed = true;
  std::size_t cones() const { return closed ? r.size() : r.size() - 1; }
};

Star star_at_vertex(const Domain& domain, HalfEdge place) {
  const Fan fan = domain.fan(place);
  Star star;
  star.closed = fan.closed;
  const Exact apex = exact(domain.point(domain.from(place)));
  const auto add = [&](Index w) {
    star.r.push_back(exact(domain.point(w)) - apex);
    star.v.push_back(exact(domain.vector(w)));
  };
  for (const HalfEdge h : fan.leaving) {
    add(domain.to(h));
    star.across.push_back(Domain::next(h));
    star.edges.push_back(h);
  }
  if (!fan.closed) {
    add(domain.from(Domain::previous(fan.leaving.back())));
    star.edges.push_back(fan.leaving.back());
  }
  return star;
}

Star star_on_edge(const Domain& domain, HalfEdge place) {
  const Index a = domain.from(place), b = domain.to(place);
  const Exact p = exact(domain.point(a)), q = exact(domain.point(b));
  const Exact v = exact(domain.vector(a)), w = exact(domain.vector(b));
  const std::size_t k = v[0] != w[0] ? 0 : 1;
  const Rational s = v[k] / (v[k] - w[k]);
  const Exact apex = p + s * (q - p);
  Star star;
  const auto add = [&](Index i) {
    star.r.push_back(exact(domain.point(i)) - apex);
    star.v.push_back(exact(domain.vector(i)));
  };
  add(b);
  add(domain.from(Domain::previous(place)));
  add(a);
  const HalfEdge twin = domain.twin(place);
  star.closed = twin != kNone;
  star.across = {Domain::next(place), Domain::previous(place)};
  if (star.closed) {
    add(domain.from(Domain::previous(twin)));
    star.across.push_back(Domain::next(twin));
    star.across.push_back(Domain::previous(twin));
  }
  return star;
}

/// det(d, v) on the cone, d = r + t s: a + b t + c t^2.
struct Form {
  Rational a, b, c;
  Rational at(const Rational& t) const { return a + t * (b + t * c); }
  /// The sign for small and for large t.
  int near() const { return sign(a) != 0 ? sign(a) : sign(b) != 0 ? sign(b) : sign(c); }
  int far() const { return sign(c) != 0 ? sign(c) : sign(b) != 0 ? sign(b) : sign(a); }
};

/// A ray with the signs of the turn before and after it.
struct TurningRay {
  Ray ray;
  int before = 0, after = 0;
};

class Portrait {
 public:
  explicit Portrait(const Star& star) : star_(star), n_(star.r.size()) {
    for (std::size_t k = 0; k < star.cones(); ++k) {
      const std::size_t m = (k + 1) % n_;
      forms_.push_back({cross(star.r[k], star.v[k]),
                        cross(star.r[k], star.v[m]) + cross(star.r[m], star.v[k]),
                        cross(star.r[m], star.v[m])});
    }
  }

  FanPortrait make() {
    FanPortrait result;
    result.closed = star_.closed;
    for (std::size_t k = 0; k < n_; ++k) {
      edge_ray(k);
      if (k < forms_.size()) inner_rays(k);
    }
    const std::size_t m = rays_.size();
    for (TurningRay& r : rays_)
      if (r.ray.on_edge) r.ray.edge = star_.edges.empty() ? kNone : star_.edges[r.ray.cone];
    for (std::size_t i = 0; i + (star_.closed ? 0 : 1) < m; ++i)
      sector(i, (i + 1) % m, result.sectors);
    if (!star_.closed && m > 0) half_fans();
    if (m == 0) result.growth = growth();
    for (const TurningRay& r : rays_) result.rays.push_back(r.ray);
    return result;
  }

 private:
  void edge_ray(std::size_t k) {
    if (sign(cross(star_.r[k], star_.v[k])) != 0) return;
    const int mu = sign(dot(star_.r[k], star_.v[k]));
    if (mu == 0) return;  // a wall
    TurningRay r;
    r.ray.cone = k;
    r.ray.on_edge = true;
    r.ray.out = mu > 0;
    r.ray.direction = as_doubles(star_.r[k]);
    const bool first = !star_.closed && k == 0, last = !star_.closed && k + 1 == n_;
    if (!last) r.after = forms_[k].near();
    if (!first) r.before = forms_[(k + n_ - 1) % n_].far();
    rays_.push_back(r);
  }

  void inner_rays(std::size_t k) {
    const Form& f = forms_[k];
    if (sign(f.c) == 0) {
      if (sign(f.a) * sign(f.b) < 0) add(k, -f.a / f.b, f.near(), f.far(), true);
      return;
    }
    if (sign(f.a) == 0) {
      if (sign(f.b) * sign(f.c) < 0) add(k, -f.b / f.c, f.near(), f.far(), true);
      return;
    }
    const Rational turn = -f.b / (2 * f.c), discriminant = f.b * f.b - 4 * f.a * f.c;
    if (discriminant == 0 && turn > 0) add(k, turn, f.near(), f.far(), true);
    if (discriminant <= 0) return;
    const int outer = sign(f.c);  // the form's sign beyond its roots
    if (const auto root = square_root(discriminant)) {
      const Rational half = *root / (2 * abs(f.c));
      if (turn - half > 0) add(k, turn - half, outer, -outer, true);
      if (turn + half > 0) add(k, turn + half, -outer, outer, true);
    } else if (sign(f.a) * outer < 0) {
      isolate(k, 0, {}, f.near(), f.far());
    } else if (turn > 0) {
      isolate(k, 0, turn, outer, -outer);
      isolate(k, turn, {}, -outer, outer);
    }
  }

  /// The only root in (low, high); high: nothing for infinity.
  void isolate(std::size_t k, Rational low, std::optional<Rational> high, int before, int after) {
    const Form& f = forms_[k];
    if (!high) {
      high = low + 1;
      while (sign(f.at(*high)) == before) *high = *high * 2;
    }
    const std::size_t m = (k + 1) % n_;
    // d . v has the sign of det(r, v(d)) there, linear in t.
    const auto out = [&](const Rational& t) {
      return sign(cross(star_.r[k], star_.v[k]) + t * cross(star_.r[k], star_.v[m]));
    };
    for (int halvings = 0;; ++halvings) {
      const Rational t = (low + *high) / 2;
      const int s = sign(f.at(t));
      if (s == 0) return add(k, t, before, after, true);
      (s == before ? low : *high) = t;
      if (halvings > 60 && out(low) == out(*high) && out(low) != 0)
        return add(k, t, before, after, false);
    }
  }

  void add(std::size_t k, const Rational& t, int before, int after, bool exactly) {
    TurningRay r;
    r.ray.cone = k;
    r.ray.ratio = static_cast<double>(t);
    r.ray.side = star_.across[k];
    const std::size_t m = (k + 1) % n_;
    if (exactly) r.ray.direction = as_doubles(star_.r[k] + t * star_.r[m]);
    r.ray.out = sign(cross(star_.r[k], star_.v[k]) + t * cross(star_.r[k], star_.v[m])) > 0;
    r.before = before;
    r.after = after;
    rays_.push_back(r);
  }

  void sector(std::size_t i, std::size_t j, Sectors& sectors) {
    Ray &a = rays_[i].ray, &b = rays_[j].ray;
    const int turn = rays_[i].after;
    if (rays_.size() == 1 || a.out == b.out || turn == 0) {
      // One ray alone: the flow leaves it on one side and comes back to it on the other.
      ++sectors.parabolic;
      return;
    }
    if ((turn > 0) == b.out) {
      ++sectors.hyperbolic;
      a.separatrix = b.separatrix = true;
    } else {
      ++sectors.elliptic;
    }
  }

  /// Rays towards which the flow turns from an end of the fan.
  void half_fans() {
    TurningRay &first = rays_.front(), &last = rays_.back();
    const bool at_start = first.ray.on_edge && first.ray.cone == 0;
    const bool at_end = last.ray.on_edge && last.ray.cone + 1 == n_;
    if (!at_start && first.before != 0 && (first.before > 0) == first.ray.out)
      first.ray.separatrix = true;
    if (!at_end && last.after != 0 && (last.after < 0) == last.ray.out) last.ray.separatrix = true;
  }

  int growth() const {
    int common = 0;
    for (std::size_t k = 0; k < forms_.size(); ++k) {
      const std::size_t m = (k + 1) % n_;
      // Trace of the cone's linear map times det(r, s).
      const int s = sign(cross(star_.v[k], star_.r[m]) + cross(star_.r[k], star_.v[m]));
      if (k > 0 && s != common) return 0;
      common = s;
    }
    return common;
  }

  const Star& star_;
  const std::size_t n_;
  std::vector<Form> forms_;
  std::vector<TurningRay> rays_;
};

ZeroKind kind_of(const FanPortrait& p) {
  if (p.closed && p.rays.empty())
    return p.growth < 0 ? ZeroKind::sink : p.growth > 0 ? ZeroKind::source : ZeroKind::undecided;
  if (!p.closed || p.sectors.elliptic > 0) return ZeroKind::higher_order;
  if (p.sectors.hyperbolic > 0)
    return p.sectors.hyperbolic == 4 && p.sectors.parabolic == 0 ? ZeroKind::saddle
                                                                 : ZeroKind::higher_order;
  bool out = false, in = false;
  for (const Ray& r : p.rays) (r.out ? out : in) = true;
  return out && in ? ZeroKind::higher_order : out ? ZeroKind::source : ZeroKind::sink;
}

}  // namespace

FanPortrait examine_fan(const Domain& domain, const ZeroComponent& zero) {
  const Star star = zero.item.where == ZeroPlace::vertex ? star_at_vertex(domain, zero.place)
                                                         : star_on_edge(domain, zero.place);
  return Portrait(star).make();
}

void classify_fans(const Domain& domain, std::vector<ZeroComponent>& zeros,
                   std::vector<FanPortrait>& portraits) {
  portraits.assign(zeros.size(), {});
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    CriticalPoint& item = zeros[i].item;
    if (item.where != ZeroPlace::vertex && item.where != ZeroPlace::edge) continue;
    kernel::stop_point();
    portraits[i] = examine_fan(domain, zeros[i]);
    item.kind = kind_of(portraits[i]);
    item.focus =
        portraits[i].closed && portraits[i].rays.empty() && item.kind != ZeroKind::undecided;
    item.sectors = portraits[i].sectors;
  }
}

}  // namespace crest::vector_fields
