// SPDX-License-Identifier: GPL-3.0-or-later
// Table 9.1: errors of cubic splines of scattered samples, all three extensions, beside the
// thesis'; of f_test, of a function on which nothing was chosen, and of g.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "algorithms/splines/cubic_fit.hpp"
#include "experiments/001-splines/cubic_errors.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using splines::Smoothness;

struct Row {
  std::size_t samples;
  kernel::Index cubes;
  double mean, data, max;  ///< the thesis'
};
constexpr Row kThesis[] = {{1000, 4, 0.05612090, 0.16392300, 0.18640600},
                           {2000, 5, 0.01758270, 0.07843640, 0.08240110},
                           {4000, 7, 0.00247124, 0.02297960, 0.02867510},
                           {8000, 9, 0.00076832, 0.00766123, 0.00922203},
                           {16000, 11, 0.00030479, 0.00374684, 0.00429214},
                           {32000, 14, 0.00010208, 0.00147255, 0.00168576},
                           {64000, 18, 0.00003375, 0.00054775, 0.00062212},
                           {128000, 23, 0.00001175, 0.00021318, 0.00023703},
                           {256000, 29, 0.00000441, 0.00008587, 0.00009686},
                           {512000, 37, 0.00000160, 0.00003636, 0.00004275},
                           {1024000, 46, 0.00000065, 0.00001530, 0.00001765},
                           {2048000, 58, 0.00000025, 0.00000618, 0.00000747},
                           {4096000, 74, 0.00000009, 0.00000292, 0.00000375}};
constexpr Row kPowers[] = {{8000, 9, 0.00000950, 0.00010017, 0.00011770}};

struct Named {
  const char* name;
  Smoothness mode;
};
constexpr Named kModes[] = {
    {"local", Smoothness::local}, {"c1", Smoothness::c1}, {"sequential", Smoothness::sequential}};

struct Choice {
  std::size_t seeds = 50, least_samples = 0, most_samples = 4096000, all_seeds_up_to = 32000;
  std::string only;
};

/// Fewer seeds where a row takes long.
std::size_t seeds_of(const Row& row, const Choice& choice) {
  if (row.samples <= choice.all_seeds_up_to) return choice.seeds;
  return std::max<std::size_t>(1, std::min<std::size_t>(choice.seeds, 3 * 64000 / row.samples));
}

void table_of(const char* title, Function f, std::span<const Row> rows, bool has_thesis,
              const Named& mode, const Choice& choice) {
  const auto wanted = [&](const Row& row) {
    return choice.least_samples <= row.samples && row.samples <= choice.most_samples;
  };
  if (std::none_of(rows.begin(), rows.end(), wanted)) return;
  fmt::print("\n{}, `{}`\n\n", title, mode.name);
  fmt::print("| N | n | seeds |{} mean | data | max | interior mean | data | max | order | s |\n",
             has_thesis ? " thesis mean | data | max |" : "");
  fmt::print("|---|---|---|{}---|---|---|---|---|---|---|---|\n", has_thesis ? "---|---|---|" : "");
  double previous = 0, previous_n = 0;
  for (const Row& row : rows) {
    if (!wanted(row)) continue;
    CubicErrors sum;
    double seconds = 0;
    const std::size_t seeds = seeds_of(row, choice);
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const Samples s = samples_of(f, row.samples, seed);
      const auto start = std::chrono::steady_clock::now();
      const auto fit = splines::fit_cubic(
          s.points, s.values,
          {mode.mode, {{row.cubes, row.cubes, row.cubes}}, {{Vec3{0, 0, 0}, Vec3{1, 1, 1}}}});
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      sum.add(cubic_errors(fit.model, s, f), 1 / static_cast<double>(seeds));
    }
    fmt::print("| {} | {} | {} |", row.samples, row.cubes, seeds);
    if (has_thesis) fmt::print(" {:.2e} | {:.2e} | {:.2e} |", row.mean, row.data, row.max);
    fmt::print(" {:.2e} | {:.2e} | {:.2e} | {:.2e} | {:.2e} | {:.2e} | ", sum.mean, sum.data,
               sum.max, sum.interior_mean, sum.interior_data, sum.interior_max);
    if (previous > 0)
      fmt::print("{:.1f}", std::log(previous / sum.mean) / std::log(row.cubes / previous_n));
    fmt::print(" | {:.2f} |\n", seconds / static_cast<double>(seeds));
    std::fflush(stdout);
    previous = sum.mean;
    previous_n = row.cubes;
  }
}

int work(const Choice& choice) {
  fmt::print(
      "Means over the seeds 1, 2, ..; errors at the samples (mean, largest: data) and at 20 points "
      "a "
      "tetrahedron\n(max), on the whole box and in the cubes that are not at its border. Order: of "
      "the "
      "mean, by the cubes' side.\nThe thesis counts cubes of the interior, 50 distributions a "
      "row.\n");
  for (const Named& mode : kModes) {
    if (!choice.only.empty() && choice.only != mode.name) continue;
    table_of("f_test", f_test, kThesis, true, mode, choice);
    table_of("f_other", f_other, kThesis, false, mode,
             {std::min<std::size_t>(choice.seeds, 10),
              choice.least_samples,
              choice.most_samples,
              choice.all_seeds_up_to,
              {}});
    table_of("g", g_powers, kPowers, true, mode, choice);
  }
  return 0;
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Choice choice;
  Program program("Table 9.1: errors of cubic splines of scattered samples");
  program.option("--seeds", choice.seeds, "distributions of the samples (50)");
  program.option("--all-seeds-up-to", choice.all_seeds_up_to,
                 "samples; above there are fewer seeds: 192000 / N, at least one (32000)");
  program.option("--least", choice.least_samples, "samples of the first row (1000)");
  program.option("--most", choice.most_samples, "samples of the last row (4096000)");
  program.option("--only", choice.only, "one extension", {"local", "c1", "sequential"});
  return program.run(argc, argv, [&] { return work(choice); });
}
