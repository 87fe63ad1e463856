// SPDX-License-Identifier: GPL-3.0-or-later
// Isosurfaces as meshes: known topology, degenerate levels, the checker of their certificates.
#include "algorithms/splines/isosurface.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <set>

#include "algorithms/splines/quadratic_certificate.hpp"
#include "certify/verify.hpp"
#include "io/read/volume_reader.hpp"
#include "tests/splines/volumes.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::operator-;
using splines::extract_isosurface;
using splines::Isosurface;
using splines::QuadraticSpline;

namespace {

/// Decided, and its certificate accepted.
Isosurface certified(const QuadraticSpline& spline, double c) {
  const Isosurface surface = extract_isosurface(spline, c, 30);
  CHECK(surface.undecided.empty());
  const auto verdict =
      certify::verify(certify::encode(splines::isosurface_certificate(spline, c, surface)));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  return surface;
}

double torus(double x, double y, double z) {
  const double r = std::sqrt(x * x + y * y) - 0.6;
  return r * r + z * z;
}

/// A signed permutation of axes: sample and point x go to y[k] = x[axes[k]], from the other end if
/// bit k of `flips` is set.
struct Motion {
  std::array<std::size_t, 3> axes;
  int flips;

  template <class T>
  std::array<T, 3> operator()(const std::array<T, 3>& x, const std::array<T, 3>& last) const {
    std::array<T, 3> y;
    for (std::size_t k = 0; k < 3; ++k)
      y[k] = flips >> k & 1 ? last[axes[k]] - x[axes[k]] : x[axes[k]];
    return y;
  }
};

kernel::SampledGrid moved(const kernel::SampledGrid& grid, const Motion& motion) {
  kernel::SampledGrid other = grid;
  std::array<std::size_t, 3> last, x;
  for (std::size_t k = 0; k < 3; ++k) last[k] = grid.size[k] - 1;
  for (std::size_t k = 0; k < 3; ++k) other.size[k] = grid.size[motion.axes[k]];
  const auto& from = std::get<std::vector<std::int16_t>>(grid.samples);
  auto& to = std::get<std::vector<std::int16_t>>(other.samples);
  std::size_t i = 0;
  for (x[2] = 0; x[2] <= last[2]; ++x[2])
    for (x[1] = 0; x[1] <= last[1]; ++x[1])
      for (x[0] = 0; x[0] <= last[0]; ++x[0]) {
        const auto y = motion(x, last);
        to[y[0] + other.size[0] * (y[1] + other.size[1] * y[2])] = from[i++];
      }
  return other;
}

/// Vertices to 2^-24.
std::set<std::array<long long, 3>> places_of(const std::vector<Vec3>& points) {
  std::set<std::array<long long, 3>> places;
  for (const Vec3& p : points)
    places.insert(
        {std::llround(0x1p24 * p[0]), std::llround(0x1p24 * p[1]), std::llround(0x1p24 * p[2])});
  return places;
}

/// Whether triangles are counter-clockwise seen from where s < c, in sum.
bool faces_below(const Isosurface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const auto edge = [&](std::size_t k) { return surface.points[t[k]] - surface.points[t[0]]; };
    sum += kernel::dot(kernel::cross(edge(1), edge(2)), surface.gradients[t[0]]);
  }
  return sum < 0;
}

/// Six times the volume that a closed surface encloses.
double volume_of(const Isosurface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles)
    sum += kernel::determinant(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
  return sum;
}

}  // namespace

TEST_CASE("spheres: one closed surface of Euler characteristic 2, vertices on it") {
  for (const int n : {8, 16}) {
    const QuadraticSpline spline(sphere_volume(n));
    const double middle = 0.5 * (n - 1), radius = 0.3 * n + 0.013;
    const auto surface = certified(spline, sphere_level(radius));
    CHECK(surface.euler_characteristic == 2);
    CHECK(surface.components == 1);
    CHECK(surface.boundary_loops == 0);
    CHECK(surface.coincident == 0);
    double largest = 0;
    for (const Vec3& p : surface.points)
      largest =
          std::fmax(largest, std::fabs(kernel::distance(p, {middle, middle, middle}) - radius));
    CHECK(largest < 1e-13);
    // s < c inside: triangles are counter-clockwise from there, and so enclose a negative volume.
    CHECK(volume_of(surface) < 0);
  }
}

TEST_CASE("mirrored axes turn the triangles with them") {
  auto grid = sphere_volume(8);
  grid.directions[2] = {0, 0, -1};
  CHECK(volume_of(certified(QuadraticSpline(grid), sphere_level(2.3))) < 0);
}

TEST_CASE("a torus, on three grids, has Euler characteristic 0 and bisected tetrahedra") {
  std::size_t bisected = 0;
  for (const int n : {14, 16, 25}) {
    const auto surface = certified(QuadraticSpline(volume_of<float>(n, torus)), 0.06);
    CHECK(surface.euler_characteristic == 0);
    CHECK(surface.components == 1);
    CHECK(surface.boundary_loops == 0);
    bisected += surface.bisected.size();
  }
  CHECK(bisected > 100);
}

TEST_CASE("a hyperboloid of two sheets has two disks, of one sheet an annulus") {
  const QuadraticSpline spline(
      volume_of<double>(13, [](double x, double y, double z) { return z * z - x * x - y * y; }));
  const auto two = certified(spline, 0.1), one = certified(spline, -0.1);
  CHECK(two.components == 2);
  CHECK(two.euler_characteristic == 2);
  CHECK(two.boundary_loops == 2);
  CHECK(one.components == 1);
  CHECK(one.euler_characteristic == 0);
  CHECK(one.boundary_loops == 2);
}

TEST_CASE(
    "levels through vertices and samples: zero counts as +, coincident vertices are counted") {
  const QuadraticSpline spline(sphere_volume(14));
  // Radius 4: through six vertices of the partition, tangent there to planes of faces.
  const auto through = certified(spline, sphere_level(4));
  CHECK(through.euler_characteristic == 2);
  CHECK(through.exact_corners >= 6);
  CHECK(through.coincident > 0);
  const auto samples = certified(spline, 4 * 9 + 3);
  CHECK(samples.euler_characteristic == 2);
  CHECK(samples.components == 1);
}

TEST_CASE("the 48 motions of the grid carry vertices into vertices, bisected tetrahedra too") {
  const auto grid = random_volume<std::int16_t>({5, 6, 4}, 1000, kSeed + 30);
  const auto plain = extract_isosurface(QuadraticSpline(grid), 17.3, 30);
  REQUIRE(plain.bisected.size() > 100);
  REQUIRE(plain.boundary_loops > 0);
  Motion motion{{0, 1, 2}, 0};
  do
    for (motion.flips = 0; motion.flips < 8; ++motion.flips) {
      const auto surface = extract_isosurface(QuadraticSpline(moved(grid, motion)), 17.3, 30);
      std::vector<Vec3> points;
      for (const Vec3& p : plain.points) points.push_back(motion(p, Vec3{4, 5, 3}));
      CHECK(places_of(surface.points) == places_of(points));
      CHECK(surface.triangles.size() == plain.triangles.size());
      CHECK(surface.bisected.size() == plain.bisected.size());
      CHECK(surface.trees.size() == plain.trees.size());
      CHECK(surface.euler_characteristic == plain.euler_characteristic);
      CHECK(surface.components == plain.components);
      CHECK(surface.boundary_loops == plain.boundary_loops);
      CHECK(faces_below(surface));
    }
  while (std::next_permutation(motion.axes.begin(), motion.axes.end()));
}

TEST_CASE("isosurfaces are the same for any number of threads") {
  const QuadraticSpline spline(random_volume<float>({9, 8, 11}, 1000, kSeed + 31));
  std::vector<certify::Bytes> files;
  std::vector<std::vector<Vec3>> points, gradients;
  for (const std::size_t threads : {1, 2, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const auto surface = extract_isosurface(spline, 17.3, 30);
    files.push_back(certify::encode(splines::isosurface_certificate(spline, 17.3, surface)));
    points.push_back(surface.points);
    gradients.push_back(surface.gradients);
  }
  for (std::size_t i = 1; i < files.size(); ++i) {
    CHECK(files[i] == files[0]);
    CHECK(points[i] == points[0]);
    CHECK(gradients[i] == gradients[0]);
  }
}

TEST_CASE("without bisections what is not simple is listed") {
  const QuadraticSpline spline(volume_of<float>(14, torus));
  CHECK_FALSE(extract_isosurface(spline, 0.06, 0).undecided.empty());
  CHECK(extract_isosurface(QuadraticSpline(sphere_volume(16)), sphere_level(4.813), 0)
            .undecided.empty());
}

TEST_CASE("integer data with a plateau: listed at its level, decided beside it") {
  // 20 inside, falling outside: s is exactly 20 in a ball.
  const QuadraticSpline spline(volume_of<std::int16_t>(9, [](double x, double y, double z) {
    return std::min(20.0, std::round(45 - 40 * std::sqrt(x * x + y * y + z * z)));
  }));
  CHECK_FALSE(extract_isosurface(spline, 20, 4).undecided.empty());
  // Values at corners of leaves are multiples of small powers of two, this level is of none.
  const auto surface = certified(spline, 19.517);
  CHECK(surface.exact_corners == 0);
  CHECK(surface.coincident == 0);
  CHECK(surface.boundary_loops == 0);
  CHECK(surface.euler_characteristic == 2);
}

TEST_CASE("a level at a saddle of a piece is not decided, and listed") {
  // s = x y + c at the middle sample: a saddle inside the central cube.
  auto grid = volume_of<double>(5, [](double x, double y, double z) { return x * y + 0 * z; });
  const QuadraticSpline spline(grid);
  const auto surface = extract_isosurface(spline, 0, 5);
  CHECK_FALSE(surface.undecided.empty());
  for (const Vec3& p : surface.undecided) CHECK(std::fabs(p[0] * p[1]) < 0.1);
  CHECK(certify::verify(certify::encode(splines::isosurface_certificate(spline, 0, surface)))
            .accepted == false);
}

TEST_CASE("a thin tube is decided, however many bisections its tetrahedra take") {
  // Of radius 0.02 about an axis of samples' distances.
  const QuadraticSpline spline(
      volume_of<double>(4, [](double x, double y, double) { return 9 * (x * x + y * y); }));
  const auto surface = certified(spline, 2 + 4 * 0.02 * 0.02);
  CHECK(surface.components == 1);
  CHECK(surface.euler_characteristic == 0);
  CHECK(surface.boundary_loops == 2);
}

TEST_CASE("a plateau at the level is listed, a level beside it is decided") {
  const QuadraticSpline spline(volume_of<std::int8_t>(
      6, [](double x, double y, double z) { return std::floor(3 * (x + 0.4 * y + 0.2 * z)); }));
  CHECK_FALSE(extract_isosurface(spline, 0, 1).undecided.empty());
  const auto surface = certified(spline, 0.4137);
  CHECK(surface.components == 1);
}

TEST_CASE("random data: whatever the topology, the certificate is accepted") {
  for (std::uint64_t i = 0; i < scaled(4); ++i) {
    const QuadraticSpline spline(random_volume<std::int16_t>({6, 5, 7}, 1000, kSeed + 20 + i),
                                 i % 2 ? splines::Border::extend : splines::Border::none);
    const auto surface = certified(spline, 17.3);
    CHECK(surface.triangles.size() > 100);
  }
}

TEST_CASE("samples times a power of two, up to the ends of doubles, have the same mesh") {
  const auto scaled = [](double scale) {
    auto grid = random_volume<double>({6, 5, 7}, 9, kSeed + 7);
    for (double& x : std::get<std::vector<double>>(grid.samples)) x *= scale;
    return grid;
  };
  const Isosurface one = certified(QuadraticSpline(scaled(1)), 0.3125);
  CHECK(one.bisected.size() > 20);
  for (const int power : {-1067, -1060, -1020, -900, -530, -140, -110, 120, 500, 1000, 1017}) {
    INFO(power);
    const double scale = std::ldexp(1.0, power);
    const Isosurface other = certified(QuadraticSpline(scaled(scale)), 0.3125 * scale);
    CHECK(other.bisected == one.bisected);
    CHECK(other.trees == one.trees);
    CHECK(other.triangles == one.triangles);
    CHECK(other.points == one.points);
  }
}

TEST_CASE("a long volume: pieces 2^20 cubes apart are two pieces") {
  const auto noise = random_volume<std::uint8_t>({4, 4, 6}, 255, kSeed + 30);
  const auto& layers = std::get<std::vector<std::uint8_t>>(noise.samples);
  const auto surface_of = [&](std::size_t apart) {
    SampledGrid grid;
    grid.size = {4, 4, apart + 22};
    std::vector<std::uint8_t> samples(16 * grid.size[2], 0);
    for (const std::size_t z : {std::size_t{2}, 2 + apart})
      std::copy(layers.begin(), layers.end(),
                samples.begin() + static_cast<std::ptrdiff_t>(16 * z));
    grid.samples = std::move(samples);
    return extract_isosurface(QuadraticSpline(grid), 100.3, 30);
  };
  const auto near = surface_of(18), far = surface_of(std::size_t{1} << 20);
  CHECK(near.components > 0);
  CHECK(near.triangles.size() == far.triangles.size());
  CHECK(near.euler_characteristic == far.euler_characteristic);
  CHECK(near.undecided.size() == far.undecided.size());
}

TEST_CASE("vertices are on the level, however small it and the samples there are beside others") {
  for (const int power : {-300, -560, -700, -1000, -1070}) {
    INFO(power);
    SampledGrid grid;
    grid.size = {7, 5, 4};
    std::vector<double> samples;
    for (int i = 0; i < 140; ++i) samples.push_back(std::ldexp(i % 7, power));
    samples.back() = 1;  // at (6, 4, 3), where little is decided
    grid.samples = std::move(samples);
    const QuadraticSpline spline(grid);
    const auto surface = extract_isosurface(spline, std::ldexp(2.25, power), 1);
    std::size_t flat = 0;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
      if (surface.points[i][0] > 4) continue;
      CHECK(std::fabs(surface.points[i][0] - 2.25) < 1e-14);
      CHECK(surface.brackets[i][1] - surface.brackets[i][0] < 1e-12);
      ++flat;
    }
    CHECK(flat > 50);
  }
}

TEST_CASE("an empty surface has a certificate, too") {
  const auto surface = certified(QuadraticSpline(sphere_volume(6)), -5);
  CHECK(surface.triangles.empty());
  CHECK(surface.components == 0);
}

TEST_CASE("isosurfaces of the volume neghip") {
  const auto path = shared_data("volumes/neghip.nrrd");
  if (!path) return;
  const QuadraticSpline spline(io::read_volume(*path).grid);
  for (const double c : {90.37}) {
    const auto surface = certified(spline, c);
    CHECK(surface.triangles.size() > 1000);
    CHECK(surface.coincident == 0);
  }
}
