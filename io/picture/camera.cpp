// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "io/picture/standing.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;
using Matrix = std::array<Vec3, 3>;

constexpr double kMargin = 0.04;    // of the width
constexpr double kTilt = 0.42;      // radians off the thinnest axis
constexpr double kTallest = 1.4;    // widths
constexpr double kFlattest = 0.45;  // widths

struct Box {
  Vec3 low, high;
};

Box bounds(const SurfaceView& mesh) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box box{{inf, inf, inf}, {-inf, -inf, -inf}};
  for (const Vec3& p : mesh.points()) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  }
  return box;
}

/// Halves first: the sum of two coordinates may overflow.
Vec3 middle(const Box& box) {
  return combine(0.5, box.low, 0.5, box.high);
}

double extent(const Box& box) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, box.high[k] - box.low[k]);
  return largest > 0 && std::isfinite(largest) ? largest : 1;
}

Matrix covariance(const SurfaceView& mesh) {
  const Box box = bounds(mesh);
  const Vec3 centre = middle(box);
  const double unit = 1 / extent(box);
  Matrix sum{};
  Vec3 mean{};
  double weight = 0;
  const auto local = [&](kernel::Index v) {
    return combine(unit, mesh.points()[v], -unit, centre);
  };
  for (const auto& f : mesh.faces()) {
    const Vec3 a = local(f[0]), b = local(f[1]), c = local(f[2]);
    const Vec3 n = cross(combine(1, b, -1, a), combine(1, c, -1, a));
    const double area = std::sqrt(dot(n, n));
    const Vec3 m = combine(1.0 / 3, combine(1, a, 1, b), 1.0 / 3, c);
    weight += area;
    for (std::size_t i = 0; i < 3; ++i) {
      mean[i] += area * m[i];
      for (std::size_t j = 0; j < 3; ++j) sum[i][j] += area * m[i] * m[j];
    }
  }
  if (!(weight > 0)) return sum;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      sum[i][j] = sum[i][j] / weight - mean[i] * mean[j] / (weight * weight);
  return sum;
}

/// Jacobi rotations; columns of the second are the eigenvectors.
void diagonalise(Matrix& a, Matrix& axes) {
  axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = std::copysign(1 / (std::abs(theta) + std::hypot(theta, 1)), theta);
        const double c = 1 / std::hypot(t, 1), s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
          const double u = axes[k][p], v = axes[k][q];
          axes[k][p] = c * u - s * v;
          axes[k][q] = s * u + c * v;
        }
      }
    }
  }
}

struct PrincipalAxes {
  Matrix axes;
  bool flat;  ///< no extent along the first
};

/// The thinnest first, each with its largest coordinate positive.
PrincipalAxes principal_axes(const SurfaceView& mesh) {
  Matrix a = covariance(mesh), columns;
  diagonalise(a, columns);
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return a[i][i] < a[j][j]; });
  Matrix axes;
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i] = {columns[0][order[i]], columns[1][order[i]], columns[2][order[i]]};
    const auto largest = std::max_element(axes[i].begin(), axes[i].end(), [](double x, double y) {
      return std::abs(x) < std::abs(y);
    });
    if (*largest < 0) axes[i] = combine(-1, axes[i], 0, axes[i]);
  }
  const bool flat = std::abs(a[order[0]][order[0]]) <= 1e-20 * std::abs(a[order[2]][order[2]]);
  return {axes, flat};
}

double facing_area(const SurfaceView& mesh, const Vec3& view) {
  double sum = 0;
  for (const auto& f : mesh.faces()) {
    const auto& p = mesh.points();
    const Vec3 n = cross(combine(1, p[f[1]], -1, p[f[0]]), combine(1, p[f[2]], -1, p[f[0]]));
    sum += std::max(0.0, -dot(n, view));
  }
  return sum;
}

/// Of views along the first axis, to either side, tilted by an angle towards `sideways` times the
/// third and one of `heights` times the second axis. Equal scores keep the first.
Vec3 best_view(const Matrix& axes, double angle, double sideways, std::span<const double> heights,
               const ViewScore& score_of) {
  Vec3 best = axes[0];
  double most = -1;
  for (int sign : {-1, 1}) {
    for (int side : {-1, 1}) {
      for (const double height : heights) {
        const Vec3 tilt = combine(sideways * side, axes[2], height, axes[1]);
        const Vec3 view = combine(sign * std::cos(angle), axes[0], std::sin(angle), tilt);
        const double score = score_of(view);
        if (score > most * (1 + 1e-9)) {
          most = score;
          best = view;
        }
      }
    }
  }
  return best;
}

/// Models stand on the plane y = 0 more often than on z = 0.
Vec3 usual_vertical(const Vec3& view) {
  const Vec3 y = {0, 1, 0}, z = {0, 0, 1};
  return std::abs(dot(normalised(view, z), y)) < 0.9 ? y : z;
}

/// Two unit vectors that make a right angle with `up` and with one another; the shape's covariance
/// is least along the first of all such.
std::array<Vec3, 2> horizontal_axes(const Matrix& spread, const Vec3& up) {
  const Vec3 helper = std::abs(up[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 a = normalised(cross(up, helper), {0, 0, 1}), b = cross(up, a);
  const auto form = [&](const Vec3& x, const Vec3& y) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum += x[i] * spread[i][j] * y[j];
    return sum;
  };
  const double turn = 0.5 * std::atan2(2 * form(a, b), form(a, a) - form(b, b));
  const Vec3 wide = combine(std::cos(turn), a, std::sin(turn), b);
  return {cross(up, wide), wide};
}

Camera fit_camera(const SurfaceView& mesh, const Vec3& view, const Vec3& vertical, int width) {
  Camera camera{};
  camera.forward = normalised(view, {0, 0, -1});
  camera.right = normalised(cross(camera.forward, vertical), {1, 0, 0});
  camera.up = cross(camera.right, camera.forward);
  camera.centre = middle(bounds(mesh));
  constexpr double inf = std::numeric_limits<double>::infinity();
  double low[2] = {inf, inf}, high[2] = {-inf, -inf};
  for (const Vec3& p : mesh.points()) {
    const Vec3 q = combine(1, p, -1, camera.centre);
    const double at[2] = {dot(camera.right, q), dot(camera.up, q)};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  const Vec3 across =
      combine(0.5 * (low[0] + high[0]), camera.right, 0.5 * (low[1] + high[1]), camera.up);
  camera.centre = combine(1, camera.centre, 1, across);
  const double w = std::max(high[0] - low[0], 1e-300), h = std::max(high[1] - low[1], 1e-300);
  const double inner = (1 - 2 * kMargin) * width;
  const double tall = std::clamp(h / w, kFlattest, kTallest);
  camera.width = width;
  camera.height = static_cast<int>(std::lround(tall * inner + 2 * kMargin * width));
  camera.scale = std::min(inner / w, (camera.height - 2 * kMargin * width) / h);
  return camera;
}

Camera upright_camera(const SurfaceView& mesh, const Vec3& up, int width, const ViewScore& score) {
  const auto [thin, wide] = horizontal_axes(covariance(mesh), up);
  constexpr double above[] = {-0.75};
  const Vec3 view = best_view({thin, up, wide}, kTilt, 0.66, above, score);
  return fit_camera(mesh, view, up, width);
}

/// Whether a camera shows the shape upright, or from above or below.
bool shows_upright(const Camera& camera, const Vec3& up) {
  return dot(camera.up, up) > 0.5 || std::abs(dot(camera.forward, up)) > 0.8;
}

}  // namespace

Vec3 normalised(const Vec3& a, const Vec3& fallback) {
  const double largest = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (!(largest > 0) || !std::isfinite(largest)) return fallback;
  const Vec3 b = {a[0] / largest, a[1] / largest, a[2] / largest};
  return combine(1 / std::sqrt(dot(b, b)), b, 0, b);
}

std::vector<Vec3> vertex_normals(const SurfaceView& mesh) {
  // In units of the mesh's size, lest products overflow or vanish.
  const double unit = 1 / extent(bounds(mesh));
  std::vector<Vec3> normals(mesh.points().size(), Vec3{});
  for (const auto& f : mesh.faces()) {
    const auto& p = mesh.points();
    const Vec3 n =
        cross(combine(unit, p[f[1]], -unit, p[f[0]]), combine(unit, p[f[2]], -unit, p[f[0]]));
    for (kernel::Index v : f) normals[v] = combine(1, normals[v], 1, n);
  }
  for (Vec3& n : normals) n = normalised(n, {0, 0, 0});
  return normals;
}

Camera make_camera(const SurfaceView& mesh, const Viewpoint& wanted, int width,
                   const ViewScore& score, bool tilt_flat) {
  const ViewScore score_of =
      score ? score : [&](const Vec3& view) { return facing_area(mesh, view); };
  if (wanted.view) {
    const Vec3 view = normalised(*wanted.view, {0, 0, -1});
    const Vec3 up =
        wanted.up ? *wanted.up : standing_direction(mesh).value_or(usual_vertical(view));
    const bool along = std::abs(dot(normalised(up, view), view)) > 0.999;
    return fit_camera(mesh, view, along ? usual_vertical(view) : up, width);
  }
  if (wanted.up) return upright_camera(mesh, normalised(*wanted.up, {0, 1, 0}), width, score_of);
  const PrincipalAxes principal = principal_axes(mesh);
  constexpr double heights[] = {-0.8, 0.8};
  const Vec3 view = principal.flat && !tilt_flat
                        ? combine(-1, principal.axes[0], 0, principal.axes[0])
                        : best_view(principal.axes, kTilt, 0.6, heights, score_of);
  const Camera own = fit_camera(mesh, view, usual_vertical(view), width);
  const std::optional<Vec3> up = principal.flat ? std::nullopt : standing_direction(mesh);
  return up && !shows_upright(own, *up) ? upright_camera(mesh, *up, width, score_of) : own;
}

void check_viewpoint(const Viewpoint& wanted) {
  const auto require = [](bool sound, const char* what) {
    if (!sound) throw kernel::InputError(what);
  };
  const auto is_direction = [](const std::optional<Vec3>& v) {
    return !v || (dot(*v, *v) > 0 && std::isfinite(dot(*v, *v)));
  };
  require(is_direction(wanted.view),
          "picture: the view is no direction; give three numbers that are not all zero");
  require(is_direction(wanted.up),
          "picture: up is no direction; give three numbers that are not all zero");
  if (!wanted.view || !wanted.up) return;
  const Vec3 turned = cross(normalised(*wanted.view, {}), normalised(*wanted.up, {}));
  require(dot(turned, turned) > 1e-6,
          "picture: up is along the view; give a direction that shows in the picture");
}

}  // namespace crest::io
