// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 9.5: cubic splines of noisy samples of f_test.
#include <fmt/format.h>

#include <algorithm>

#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_fit.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

constexpr double kRange = 1.52;  ///< of f_test, as the thesis has it
struct Noise {
  double percent, thesis;
};
constexpr Noise kNoise[] = {{0.5, 0.0038}, {1, 0.0075}, {2.5, 0.019}};

int work(std::size_t count) {
  fmt::print(
      "{} samples, uniform noise of at most the percentage of the range {}; seed 1. |s - d|: "
      "to the noisy values,\n|s - f|: to the function, both at the samples.\n\n",
      count, kRange);
  fmt::print(
      "| extension | n | noise | thesis | mean noise | mean \\|s - d\\| | mean \\|s - f\\| | max "
      "\\|s - f\\| |\n|---|---|---|---|---|---|---|---|\n");
  const Samples s = samples_of(f_test, count, 1);
  for (const splines::Smoothness mode :
       {splines::Smoothness::c1, splines::Smoothness::local, splines::Smoothness::sequential})
    for (const kernel::Index n : {29U, 23U})
      for (const Noise& noise : kNoise) {
        Uniform draw(2);
        std::vector<double> noisy = s.values;
        double sum = 0;
        for (double& x : noisy) {
          const double e = (2 * draw() - 1) * noise.percent / 100 * kRange;
          sum += std::fabs(e);
          x += e;
        }
        const auto fit = splines::fit_cubic(s.points, noisy,
                                            {mode, {{n, n, n}}, {{Vec3{0, 0, 0}, Vec3{1, 1, 1}}}});
        const auto at = splines::evaluate(fit.model, s.points);
        double to_data = 0, to_f = 0, worst = 0;
        for (std::size_t i = 0; i < count; ++i) {
          to_data += std::fabs(at[i].value - noisy[i]);
          to_f += std::fabs(at[i].value - s.values[i]);
          worst = std::max(worst, std::fabs(at[i].value - s.values[i]));
        }
        const auto m = static_cast<double>(count);
        constexpr const char* names[] = {"c1", "local", "sequential"};
        fmt::print("| {} | {} | {} % | {} | {:.4f} | {:.4f} | {:.4f} | {:.3f} |\n",
                   names[static_cast<int>(mode)], n, noise.percent, noise.thesis, sum / m,
                   to_data / m, to_f / m, worst);
      }
  return 0;
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::size_t count = 128000;
  crest::experiments::Program program("Figure 9.5: noisy samples");
  program.option("--samples", count, "their number (128000)");
  return program.run(argc, argv, [&] { return crest::experiments::work(count); });
}
