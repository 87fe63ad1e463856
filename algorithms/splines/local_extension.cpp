// SPDX-License-Identifier: GPL-3.0-or-later

#include "algorithms/splines/cubic_extension.hpp"
#include "algorithms/splines/normal_form.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {
namespace {

using kernel::operator+;

/// Whether a cube has one of the box's edges, which no other cube has.
bool at_box_edge(const Domain& domain, const Place& cube) {
  int ends = 0;
  for (std::size_t d = 0; d < 3; ++d)
    ends += cube[d] == 0 || cube[d] + 1 == static_cast<int>(domain.cubes[d]) ? 1 : 0;
  return ends >= 2;
}

class LocalExtension {
 public:
  LocalExtension(const Domain& domain, const Scattered& samples, const std::array<bool, 3>& flat)
      : domain_(domain), fit_of_cube_(domain.cube_count()) {
    std::vector<Vec3> places;
    for_each_place(domain.cubes, [&](const Place& cube) {
      if (!is_black(cube) && !at_box_edge(domain, cube)) return;
      fit_of_cube_[domain.cube(cube)] = places.size();
      places.push_back(middle(cube));
    });
    fits_ = fit_at(places, samples, {}, flat);
    model_ = make_model(domain);
  }

  Extension run() {
    const auto [nx, ny, nz] = domain_.cubes;
    kernel::parallel_for(0, static_cast<int>(nz) + 1, [&, nx = nx, ny = ny](int k) {
      for (int j = 0; j <= static_cast<int>(ny); ++j)
        for (int i = 0; i <= static_cast<int>(nx); ++i) {
          vertex({i, j, k});
          for (std::size_t a = 0; a < 3; ++a) edge({i, j, k}, a);
        }
    });
    fit_centres(model_, true);
    return {std::move(model_), std::move(fits_)};
  }

 private:
  struct Fits {
    std::array<const LocalCubic*, 8> fit;
    std::size_t count = 0;
    auto begin() const { return fit.begin(); }
    auto end() const { return fit.begin() + count; }
  };
  /// The fits of the black cubes that touch a vertex or, with `axis` 0 to 2, the edge from it; if
  /// there are none, of the white ones.
  Fits around(const Place& at, std::size_t axis = 3) const {
    Fits found;
    for (const bool black : {true, false}) {
      for (std::size_t c = 0; c < 8 && (black || found.count == 0); ++c) {
        if (axis < 3 && is_upper(c, axis)) continue;
        Place cube = at;
        for (std::size_t d = 0; d < 3; ++d) cube[d] -= is_upper(c, d) ? 1 : 0;
        if (domain_.has_cube(cube) && is_black(cube) == black)
          found.fit[found.count++] = &fits_[fit_of_cube_[domain_.cube(cube)]];
      }
    }
    return found;
  }

  void vertex(const Place& at) {
    const Fits fits = around(at);
    ValueAndSlope& mean = model_.vertices[domain_.vertex(at)];
    for (const LocalCubic* fit : fits) {
      mean[0] += fit->value(point(at));
      const Vec3 g = fit->gradient(point(at));
      for (std::size_t d = 0; d < 3; ++d) mean[d + 1] += g[d] / 3;
    }
    for (double& x : mean) x /= static_cast<double>(fits.count);
  }

  void edge(const Place& at, std::size_t axis) {
    Place end = at;
    if (++end[axis] > static_cast<int>(domain_.cubes[axis])) return;
    const Fits fits = around(at, axis);
    Vec3 sum{};
    for (const LocalCubic* fit : fits) sum = sum + fit->slope(point(at), point(end));
    for (std::size_t i = 0; i < 2; ++i)
      model_.slopes[domain_.vertex(at)][2 * axis + i] =
          sum[kAcross[axis][i]] / static_cast<double>(fits.count);
  }

  const Domain& domain_;
  std::vector<std::size_t> fit_of_cube_;
  std::vector<LocalCubic> fits_;
  CubicModel model_;
};

}  // namespace

Extension extend_locally(const Domain& domain, const Scattered& samples,
                         const std::array<bool, 3>& flat) {
  return LocalExtension(domain, samples, flat).run();
}

}  // namespace crest::splines
