// SPDX-License-Identifier: GPL-3.0-or-later
// Multilevel B-splines of scattered samples, the algorithm MBA of Lee, Wolberg and Shin (1997) with
// its refinement, written here as their paper has it (no library's code), beside Crest's cubic
// splines of the same samples of f_test: processor time on one thread and errors. (<ctime>:
// programs that read clocks are optimised.)
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>

#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_fit.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

/// A uniform cubic B-spline on [0, 1]^3 with m cells along each axis: (m + 3)^3 numbers.
class BSpline {
 public:
  explicit BSpline(std::size_t cells) : m_(cells), numbers_((m_ + 3) * (m_ + 3) * (m_ + 3)) {}

  /// Their algorithm BA: each sample asks for numbers of least squares, numbers take weighted
  /// means.
  static BSpline approximate(std::size_t cells, const Samples& s) {
    BSpline spline(cells);
    std::vector<double> weights(spline.numbers_.size());
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const Place at = spline.place(s.points[i]);
      double squares = 1;
      for (const auto& b : at.basis)
        squares *= b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + b[3] * b[3];
      spline.visit(at, [&](std::size_t n, double w) {
        spline.numbers_[n] += w * w * (w * s.values[i] / squares);
        weights[n] += w * w;
      });
    }
    for (std::size_t n = 0; n < weights.size(); ++n)
      if (weights[n] > 0) spline.numbers_[n] /= weights[n];
    return spline;
  }

  double operator()(const Vec3& p) const {
    double sum = 0;
    visit(place(p), [&](std::size_t n, double w) { sum += w * numbers_[n]; });
    return sum;
  }

  /// The same function with twice the cells: along each axis (1, 6, 1) / 8 and (4, 4) / 8.
  BSpline refined() const {
    BSpline fine(2 * m_);
    std::array<std::size_t, 3> size = {m_ + 3, m_ + 3, m_ + 3};
    std::vector<double> numbers = numbers_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
      const std::size_t before = size[axis], after = 2 * m_ + 3;
      size[axis] = after;
      std::vector<double> next(size[0] * size[1] * size[2]);
      for (std::size_t n = 0; n < next.size(); ++n) {
        const std::size_t i = n / stride % after,
                          low = n % stride + n / stride / after * stride * before;
        const double* const from = numbers.data() + low + i / 2 * stride;
        next[n] = i % 2 == 0 ? (from[0] + from[stride]) / 2
                             : (from[0] + 6 * from[stride] + from[2 * stride]) / 8;
      }
      numbers = std::move(next);
    }
    fine.numbers_ = std::move(numbers);
    return fine;
  }
  BSpline& operator+=(const BSpline& o) {
    for (std::size_t n = 0; n < numbers_.size(); ++n) numbers_[n] += o.numbers_[n];
    return *this;
  }

 private:
  struct Place {
    std::array<std::size_t, 3> cell;
    std::array<std::array<double, 4>, 3> basis;
  };
  Place place(const Vec3& p) const {
    Place at;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p[k] * static_cast<double>(m_);
      at.cell[k] = std::min(static_cast<std::size_t>(x), m_ - 1);
      const double t = x - static_cast<double>(at.cell[k]), s = 1 - t;
      at.basis[k] = {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6,
                     (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6};
    }
    return at;
  }
  template <class Visit>
  void visit(const Place& at, const Visit& visit) const {
    for (std::size_t z = 0; z < 4; ++z)
      for (std::size_t y = 0; y < 4; ++y) {
        const std::size_t row =
            at.cell[0] + (m_ + 3) * (at.cell[1] + y + (m_ + 3) * (at.cell[2] + z));
        const double w = at.basis[1][y] * at.basis[2][z];
        for (std::size_t x = 0; x < 4; ++x) visit(row + x, w * at.basis[0][x]);
      }
  }

  std::size_t m_;
  std::vector<double> numbers_;
};

/// Their algorithm MBA: each level approximates what the levels before leave.
BSpline multilevel(const Samples& s, int levels) {
  std::size_t cells = 2;
  BSpline sum = BSpline::approximate(cells, s);
  BSpline last = sum;
  Samples left = s;
  for (int level = 1; level < levels; ++level) {
    for (std::size_t i = 0; i < left.points.size(); ++i) left.values[i] -= last(left.points[i]);
    cells *= 2;
    last = BSpline::approximate(cells, left);
    sum = sum.refined() += last;
  }
  return sum;
}

using Values = std::function<std::vector<double>(const std::vector<Vec3>&)>;

/// Errors at the samples, and at as many other random points.
void row(const std::string& name, const Samples& s, double fit, const Values& values) {
  const Samples other = samples_of(f_test, s.points.size(), 2);
  const double start = processor_seconds();
  const auto there = values(other.points);
  const double each = (processor_seconds() - start) / static_cast<double>(there.size());
  const auto at = values(s.points);
  double mean = 0, data = 0, max = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    mean += std::fabs(at[i] - s.values[i]) / static_cast<double>(at.size());
    data = std::max(data, std::fabs(at[i] - s.values[i]));
    max = std::max(max, std::fabs(there[i] - other.values[i]));
  }
  fmt::print("| {} | {} | {:.2f} s | {:.2f} us | {:.1e} | {:.1e} | {:.1e} |\n", s.points.size(),
             name, fit, 1e6 * each, mean, data, max);
}

void compare(std::size_t count, const std::vector<int>& levels) {
  const Samples s = samples_of(f_test, count, 1);
  for (const int n : levels) {
    const double start = processor_seconds();
    const BSpline spline = multilevel(s, n);
    const double fit = processor_seconds() - start;
    row(fmt::format("MBA, {} levels, {}^3 cells", n, 1 << n), s, fit,
        [&](const std::vector<Vec3>& points) {
          std::vector<double> values;
          for (const Vec3& p : points) values.push_back(spline(p));
          return values;
        });
  }
  for (const auto& [name, mode] : {std::pair{"Crest, `local`", splines::Smoothness::local},
                                   std::pair{"Crest, `c1`", splines::Smoothness::c1}}) {
    splines::CubicOptions options;
    options.smoothness = mode;
    options.box = {Vec3{0, 0, 0}, Vec3{1, 1, 1}};
    const double start = processor_seconds();
    const auto model = splines::fit_cubic(s.points, s.values, options).model;
    const double fit = processor_seconds() - start;
    row(fmt::format("{}, {}^3 cubes", name, model.domain.cubes[0]), s, fit,
        [&](const std::vector<Vec3>& points) {
          std::vector<double> values;
          for (const auto& at : splines::evaluate(model, points)) values.push_back(at.value);
          return values;
        });
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  std::vector<int> samples = {128000, 1024000}, levels = {6, 7, 8};
  Program program("multilevel B-splines of scattered samples beside Crest's cubic splines");
  program.list("--samples", samples, "numbers of them (128000 1024000)");
  program.list("--levels", levels, "of the B-splines, 2^3 cells at the first (6 7 8)");
  return program.run(argc, argv, [&] {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    fmt::print(
        "| samples of f_test | spline | fit | a point | mean error at the samples | max there | "
        "max "
        "at as many other points |\n|---|---|---|---|---|---|---|\n");
    for (const int n : samples) compare(static_cast<std::size_t>(n), levels);
    return 0;
  });
}
