// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 8.1 to 8.6: errors of quadratic super splines and their derivatives by x, of Marschner and
// Lobb's function and of f_test, beside the thesis'.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "algorithms/splines/quadratic.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

constexpr std::size_t kOrders = 3;
/// f, D_x f, D_x^2 f.
using Derivatives = std::array<double, kOrders>;
using DerivativesOf = Derivatives (*)(const Vec3&);

/// Of ml on [-1, 1]^3, by coordinates of the domain scaled to [0, 1].
Derivatives of_marschner_lobb(const Vec3& p) {
  const Vec3 q{2 * p[0] - 1, 2 * p[1] - 1, 2 * p[2] - 1};
  const double pi = std::numbers::pi, r = std::hypot(q[0], q[1]);
  const double c = std::cos(pi * r / 2), s = std::sin(pi * r / 2);
  const double first = 6 * pi * pi * s * std::sin(12 * pi * c);
  const double second =
      3 * pi * pi * pi * (c * std::sin(12 * pi * c) - 12 * pi * s * s * std::cos(12 * pi * c));
  const double scale = 0.25 / 2.5;  // alpha / (2 (1 + alpha))
  if (r == 0) return {marschner_lobb(q), 0, 4 * scale * second};
  const double x = q[0] / r, y = q[1] / r;
  return {marschner_lobb(q), 2 * scale * first * x,
          4 * scale * (second * x * x + first * y * y / r)};
}

Derivatives of_f_test(const Vec3& p) {
  Derivatives d{};
  const auto add = [&](double factor, double power, double at, double rest) {
    const double t = p[0] - at, e = factor * std::exp(-power * (t * t + rest));
    d[0] += e;
    d[1] += -2 * power * t * e;
    d[2] += (4 * power * power * t * t - 2 * power) * e;
  };
  add(0.5, 10, 0.25, square(p[1] - 0.25));
  add(0.75, 16, 0.25, square(p[1] - 0.25) + square(p[2] - 0.25));
  add(0.5, 10, 0.75, square(p[1] - 0.125) + square(p[2] - 0.5));
  add(-0.25, 20, 0.75, square(p[1] - 0.75));
  return d;
}

struct Errors {
  Derivatives sum{}, squares{}, max{}, data{};
  double count = 0;
};

/// What all cubes share: the ten points of each tetrahedron, barycentric (i + 1/4) / 3 with the sum
/// of i 2, and how barycentric coordinates change with x.
struct Pattern {
  std::array<std::array<double, 4>, 10> points;
  std::array<std::array<double, 4>, splines::kTetrahedra> by_x;

  Pattern() {
    using Basis = kernel::SimplexBasis<3, 2>;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) points[i][k] = (Basis::indices[i][k] + 0.25) / 3;
    for (std::size_t t = 0; t < splines::kTetrahedra; ++t) {
      const auto origin = splines::barycentric<double>(t, {0, 0, 0});
      const auto moved = splines::barycentric<double>(t, {1, 0, 0});
      for (std::size_t k = 0; k < 4; ++k) by_x[t][k] = moved[k] - origin[k];
    }
  }
};

/// Of a tetrahedron at barycentric coordinates, in units of the domain.
Derivatives at(const splines::QuadraticNet<double>& net, const std::array<double, 4>& by_x,
               const std::array<double, 4>& l, double h) {
  const auto once = kernel::derivative(net, by_x);
  const double lattice = 2 / h;
  return {kernel::value_at(net, l), kernel::value_at(once, l) * lattice,
          kernel::derivative(once, by_x).c[0] * lattice * lattice};
}

void cube_errors(const splines::QuadraticSpline& spline, const splines::Cube& cube,
                 const Pattern& pattern, DerivativesOf f, double h, bool points, Errors& e) {
  const auto coefficients = splines::cube_coefficients(spline.stencil<double>(cube));
  const auto place = [&](std::size_t d, double lattice) { return (cube[d] + 1 + lattice / 2) * h; };
  // The sample is evaluated in a tetrahedron of the +x pyramid.
  constexpr std::size_t to_the_right = 4;
  const auto exact = f({place(0, 0), place(1, 0), place(2, 0)});
  const auto centre = at(splines::tetrahedron_net(coefficients, to_the_right),
                         pattern.by_x[to_the_right], {1, 0, 0, 0}, h);
  for (std::size_t o = 0; o < kOrders; ++o)
    e.data[o] = std::max(e.data[o], std::fabs(centre[o] - exact[o]));
  if (!points) return;
  for (std::size_t t = 0; t < splines::kTetrahedra; ++t) {
    const auto net = splines::tetrahedron_net(coefficients, t);
    for (const auto& l : pattern.points) {
      Vec3 p;
      for (std::size_t d = 0; d < 3; ++d) {
        double lattice = 0;
        for (std::size_t k = 0; k < 4; ++k)
          lattice += l[k] * splines::kTetrahedron[t].corners[k][d];
        p[d] = place(d, lattice);
      }
      const auto s = at(net, pattern.by_x[t], l, h), g = f(p);
      for (std::size_t o = 0; o < kOrders; ++o) {
        const double error = std::fabs(s[o] - g[o]);
        e.sum[o] += error;
        e.squares[o] += error * error;
        e.max[o] = std::max(e.max[o], error);
      }
      e.count += 1;
    }
  }
}

/// Of samples at the multiples of h; tetrahedra of the cubes whose indices `stride` divides.
Errors errors_of(DerivativesOf f, int samples, int stride) {
  kernel::SampledGrid grid;
  const auto n = static_cast<std::size_t>(samples) + 1;
  const double h = 1.0 / samples;
  grid.size = {n, n, n};
  grid.spacing = {h, h, h};
  std::vector<double> values(grid.count());
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t k) {
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        values[i + n * (j + n * k)] = f({static_cast<double>(i) * h, static_cast<double>(j) * h,
                                         static_cast<double>(k) * h})[0];
  });
  grid.samples = std::move(values);
  const splines::QuadraticSpline spline(std::move(grid));
  const Pattern pattern;
  const int cubes = samples - 1;
  std::vector<Errors> slabs(static_cast<std::size_t>(cubes));
  tbb::parallel_for(0, cubes, [&](int k) {
    Errors& e = slabs[static_cast<std::size_t>(k)];
    for (int j = 0; j < cubes; ++j)
      for (int i = 0; i < cubes; ++i)
        cube_errors(spline, {i, j, k}, pattern, f, h,
                    i % stride == 0 && j % stride == 0 && k % stride == 0, e);
  });
  Errors all;
  for (const Errors& e : slabs) {
    all.count += e.count;
    for (std::size_t o = 0; o < kOrders; ++o) {
      all.sum[o] += e.sum[o];
      all.squares[o] += e.squares[o];
      all.max[o] = std::max(all.max[o], e.max[o]);
      all.data[o] = std::max(all.data[o], e.data[o]);
    }
  }
  return all;
}

struct Table {
  const char* title;
  std::array<std::array<double, 4>, 5> thesis;  ///< mean, rms, max, data; h = 1/16 to 1/256
};
constexpr Table kMarschnerLobb[] = {{"Table 8.1: ml",
                                     {{{0.0637338, 0.0763573, 0.1794933, 0.0886842},
                                       {0.0469557, 0.0548679, 0.1202057, 0.0923545},
                                       {0.0175995, 0.0206885, 0.0395824, 0.0368751},
                                       {0.0049393, 0.0058288, 0.0105322, 0.0103358},
                                       {0.0012735, 0.0015042, 0.0026710, 0.0026593}}}},
                                    {"Table 8.2: D_x ml",
                                     {{{4.0446910, 5.1182602, 12.3920158, 10.0356594},
                                       {3.2655525, 4.3084310, 12.8719495, 12.5411960},
                                       {1.2419448, 1.6807952, 5.6377440, 5.6073735},
                                       {0.3483834, 0.4733294, 1.6051045, 1.5936699},
                                       {0.0896466, 0.1220021, 0.4144013, 0.4115753}}}},
                                    {"Table 8.3: D_x^2 ml",
                                     {{{329.2754617, 460.6656652, 1381.6373930, 1140.3801860},
                                       {285.6398127, 405.5817230, 1504.0177006, 1008.4225786},
                                       {149.7005648, 217.5784357, 1188.2312690, 427.7408473},
                                       {70.6715715, 107.0387996, 656.3764722, 239.3863193},
                                       {34.0443422, 53.1077465, 335.8704193, 123.7781568}}}}};
constexpr Table kTest[] = {{"Table 8.4: f_test",
                            {{{0.0038309, 0.0066271, 0.0429973, 0.0430021},
                              {0.0009200, 0.0016158, 0.0109885, 0.0109880},
                              {0.0002248, 0.0003975, 0.0027622, 0.0027620},
                              {0.0000555, 0.0000985, 0.0006915, 0.0006914},
                              {0.0000138, 0.0000245, 0.0001729, 0.0001729}}}},
                           {"Table 8.5: D_x f_test",
                            {{{0.0203633, 0.0333122, 0.2238992, 0.1562143},
                              {0.0050603, 0.0083125, 0.0603967, 0.0393916},
                              {0.0012533, 0.0020636, 0.0152990, 0.0098670},
                              {0.0003114, 0.0005133, 0.0038459, 0.0024764},
                              {0.0000776, 0.0001280, 0.0009622, 0.0006192}}}},
                           {"Table 8.6: D_x^2 f_test",
                            {{{0.6418473, 0.9323099, 6.6045684, 5.8388519},
                              {0.3094677, 0.4531853, 3.3131101, 3.0231247},
                              {0.1524176, 0.2239878, 1.6240159, 1.5090936},
                              {0.0757079, 0.1114145, 0.8012538, 0.7509042},
                              {0.0377399, 0.0555706, 0.3980345, 0.3742364}}}}};

void print(DerivativesOf f, std::span<const Table> tables, int most_samples, int fine) {
  std::vector<Errors> rows;
  for (int samples = 16; samples <= most_samples; samples *= 2)
    rows.push_back(errors_of(f, samples, samples > fine ? samples / fine : 1));
  for (std::size_t o = 0; o < kOrders; ++o) {
    fmt::print("\n{}\n\n| h | thesis mean | rms | max | data | mean | rms | max | data |\n",
               tables[o].title);
    fmt::print("|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto& t = tables[o].thesis[r];
      const Errors& e = rows[r];
      fmt::print(
          "| 1/{} | {:.7f} | {:.7f} | {:.7f} | {:.7f} | {:.7f} | {:.7f} | {:.7f} | {:.7f} |\n",
          16 << r, t[0], t[1], t[2], t[3], e.sum[o] / e.count, std::sqrt(e.squares[o] / e.count),
          e.max[o], e.data[o]);
    }
  }
}

int work(int most_samples, int fine) {
  fmt::print(
      "Samples at the multiples of h on [0, 1]^3 (of ml on [-1, 1]^3, scaled), cubes round those "
      "of "
      "the interior, derivatives\nby the scaled domain. Data: at the samples, in a tetrahedron of "
      "the "
      "+x pyramid. The others: at the points with\nbarycentric coordinates (i + 1/4) / 3, ten a "
      "tetrahedron, in cubes at most {} along an axis, evenly chosen.\n",
      fine);
  print(of_marschner_lobb, kMarschnerLobb, most_samples, fine);
  print(of_f_test, kTest, most_samples, fine);
  return 0;
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int most_samples = 256, fine = 128;
  crest::experiments::Program program("Tables 8.1 to 8.6");
  program.option("--most", most_samples, "1/h of the last row (256)");
  program.option("--fine", fine,
                 "cubes along an axis whose tetrahedra are measured, at most (128)");
  return program.run(argc, argv, [&] { return crest::experiments::work(most_samples, fine); });
}
