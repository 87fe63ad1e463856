// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/cubic_extension.hpp"
#include "algorithms/splines/normal_form.hpp"

namespace crest::splines {
namespace {

/// Of the local samples; the thesis states none.
constexpr Scattered::Request kRequest{.radius = 1.6, .growth = 1.15, .least = 40, .most = 120};

/// Of the black tetrahedron: front edge and middle of the bottom face, and the centre.
Vec3 barycentre(const Place& cube) {
  return {cube[0] + 0.5, cube[1] + 0.25, cube[2] + 0.125};
}
Place moved(Place p, std::size_t axis, int by) {
  p[axis] += by;
  return p;
}

class SequentialExtension {
 public:
  SequentialExtension(const Domain& domain, const Scattered& samples,
                      const std::array<bool, 3>& flat)
      : domain_(domain), model_(make_model(domain)) {
    std::vector<Vec3> places;
    for (std::size_t d = 0; d < 3; ++d) round_.cubes[d] = domain.cubes[d] + 2;
    fit_of_cube_.resize(round_.cube_count());
    for_each_place(round_.cubes, [&](const Place& q) {
      const Place cube{q[0] - 1, q[1] - 1, q[2] - 1};
      if (!is_black(cube)) return;
      fit_of_cube_[round_.cube(q)] = places.size();
      places.push_back(barycentre(cube));
    });
    fits_ = fit_at(places, samples, kRequest, flat);
  }

  Extension run() {
    auto size = domain_.cubes;
    for (auto& n : size) ++n;
    for_each_place(size, [&](const Place& v) { vertex(v); });
    for (const std::size_t axis : {0, 1})
      for_each_edge(axis, [&](const Place& v) { horizontal(axis, v); });
    for_each_place(domain_.cubes, [&](const Place& cube) {
      if (is_black(cube)) black_centre(cube);
    });
    for_each_edge(2, [&](const Place& v) { vertical(v); });
    fit_centres(model_, false);
    return {std::move(model_), std::move(fits_)};
  }

 private:
  template <class Visit>
  void for_each_edge(std::size_t axis, const Visit& visit) const {
    auto size = domain_.cubes;
    for (std::size_t d = 0; d < 3; ++d) size[d] += d == axis ? 0 : 1;
    for_each_place(size, visit);
  }
  /// Of a black cube of the domain or of the ring around it.
  const LocalCubic& fit(const Place& cube) const {
    return fits_[fit_of_cube_[round_.cube({cube[0] + 1, cube[1] + 1, cube[2] + 1})]];
  }

  /// Step 1: each vertex is an end of one black tetrahedron's front edge.
  void vertex(const Place& v) {
    const LocalCubic& p = fit(is_black(v) ? v : moved(v, 0, -1));
    const Vec3 g = p.gradient(point(v));
    model_.vertices[domain_.vertex(v)] = {p.value(point(v)), g[0] / 3, g[1] / 3, g[2] / 3};
  }

  /// a(VWX) of the horizontal edge from v along an axis: each is in the bottom of one black cube.
  double blossom(std::size_t axis, const Place& v, const Vec3& x) const {
    const LocalCubic& p = fit(is_black(v) ? v : moved(v, 1 - axis, -1));
    return p.blossom(point(v), point(moved(v, axis, 1)), x);
  }

  /// Half of a(AAB) + a(ABB): what the slopes add to.
  double middle_of_edge(std::size_t axis, const Place& v) const {
    const ValueAndSlope& low = model_.vertices[domain_.vertex(v)];
    const ValueAndSlope& high = model_.vertices[domain_.vertex(moved(v, axis, 1))];
    return (low[0] + high[0] + low[axis + 1] - high[axis + 1]) / 2;
  }

  /// Step 2: the slopes of x- and y-edges, such that a(ABD), D in the bottom of that cube, and
  /// a(ABC) are its polynomial's.
  void horizontal(std::size_t axis, const Place& v) {
    const std::size_t across = 1 - axis;
    const double inward = is_black(v) ? 0.5 : -0.5;
    Vec3 x = point(v);
    x[axis] += 0.5;
    x[across] += inward;
    const double abd = blossom(axis, v, x);
    x[2] += 0.5;
    const double abc = blossom(axis, v, x);
    auto& t = model_.slopes[domain_.vertex(v)];
    t[2 * axis] = (abd - middle_of_edge(axis, v)) / inward;
    t[2 * axis + 1] = (abc - abd) / 0.5;
  }

  /// Step 3.
  void black_centre(const Place& cube) {
    const LocalCubic& p = fit(cube);
    const Vec3 g = p.gradient(middle(cube));
    model_.centres[domain_.cube(cube)] = {p.value(middle(cube)), g[0] / 3, g[1] / 3, g[2] / 3};
  }

  /// Steps 4 and 5: the slopes of a z-edge.
  void vertical(const Place& v) {
    const Place top = moved(v, 2, 1);
    // The black cube of which this is a front edge, and its direction from the edge.
    const Place cube = is_black(v) ? v : moved(v, 0, -1);
    const double sx = is_black(v) ? 1 : -1;
    const double along =
        2 * ((demand(v, cube) + demand(top, cube)) / 2 - middle_of_edge(2, v));  // sx t_x + t_y
    const double against = sx * across_diagonals(v, top, 0) - across_diagonals(v, top, 1);
    auto& t = model_.slopes[domain_.vertex(v)];
    t[4] = sx * (along + against) / 2;
    t[5] = (along - against) / 2;
  }

  /// a(AZC) of the z-edge at corner A of a black cube, if r is to be 0 there.
  double demand(const Place& a, const Place& cube) const {
    const Vec3 c = middle(cube);
    const ValueAndSlope& v = model_.vertices[domain_.vertex(a)];
    double demanded = 2 * fit(cube).blossom(c, point(a)) + v[0];
    for (std::size_t d = 0; d < 3; ++d) demanded += v[d + 1] * (c[d] - a[d]);
    for (const std::size_t axis : {0, 1})
      demanded -= blossom(axis, a[axis] == cube[axis] ? a : moved(a, axis, -1), c);
    return demanded;
  }

  /// The slope along `axis` as a(ATT) - 2 a(ADT) = a(ALL) - 2 a(ADL) has it in the mean over the
  /// domain's faces at the edge and both its ends; T is the z-edge's other end, L that of the
  /// face's horizontal edge at A.
  double across_diagonals(const Place& low, const Place& top, std::size_t axis) const {
    double sum = 0;
    int count = 0;
    for (const int side : {-1, 1}) {
      const int beside = low[axis] + side;
      if (beside < 0 || beside > static_cast<int>(domain_.cubes[axis])) continue;
      for (const bool upper : {false, true}) {
        const Place& a = upper ? top : low;
        const Place l = moved(a, axis, side), edge = side > 0 ? a : l;
        const ValueAndSlope& at_l = model_.vertices[domain_.vertex(l)];
        const ValueAndSlope& at_t = model_.vertices[domain_.vertex(upper ? low : top)];
        const double all = at_l[0] - side * at_l[axis + 1];
        const double att = at_t[0] + (upper ? 1 : -1) * at_t[3];
        const double towards_d =
            (upper ? -0.5 : 0.5) * model_.slopes[domain_.vertex(edge)][2 * axis + 1];
        const double adl = middle_of_edge(axis, edge) + towards_d;
        const double adt = adl + (att - all) / 2;
        sum += 2 * side * (adt - middle_of_edge(2, low));
        ++count;
      }
    }
    return sum / count;
  }

  const Domain& domain_;
  Domain round_;  ///< with a ring of cubes
  std::vector<std::size_t> fit_of_cube_;
  std::vector<LocalCubic> fits_;
  CubicModel model_;
};

}  // namespace

Extension extend_sequentially(const Domain& domain, const Scattered& samples,
                              const std::array<bool, 3>& flat) {
  return SequentialExtension(domain, samples, flat).run();
}

}  // namespace crest::splines
