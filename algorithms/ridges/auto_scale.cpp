// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/auto_scale.hpp"

#include <algorithm>
#include <array>

namespace crest::ridges {
namespace {

constexpr std::array kSupports = {30, 45, 68, 100, 150, 230, 340};
constexpr double kEnough = 0.97;  // of the largest mean

double quotient(double s, double length) {
  return length > 0 ? s * s / length : 0;
}

SupportTrial tried(const kernel::TriangleMesh& mesh, FitOptions options, int points,
                   const GraphOptions& graph_options, const SalienceOptions& salience,
                   const Workers* workers) {
  options.rings = 0;
  options.scale = 0;
  options.min_points = points;
  options.errors = true;
  const FitResult fit = fit_monge_forms(mesh, options, workers);
  RidgeGraph graph = extract_ridge_graph(mesh, fit.forms, graph_options, nullptr, workers);
  const SalienceReport r = mark_salience(mesh, fit, graph, salience);
  return {points, r.length, r.length_unweighted, r.length_significant,
          quotient(r.length_unweighted, r.length)};
}

/// J fell at the last two trials.
bool falling(const std::vector<SupportTrial>& trials) {
  const std::size_t n = trials.size();
  return n >= 3 && trials[n - 1].j < trials[n - 2].j && trials[n - 2].j < trials[n - 3].j;
}

/// J by the significant length that a neighbouring support confirms.
void judge_by_significant(std::vector<SupportTrial>& trials) {
  for (std::size_t i = 0; i < trials.size(); ++i) {
    double confirmed = 0;
    if (i > 0) confirmed = trials[i - 1].significant_length;
    if (i + 1 < trials.size()) confirmed = std::max(confirmed, trials[i + 1].significant_length);
    trials[i].j = quotient(std::min(trials[i].significant_length, confirmed), trials[i].length);
  }
}

/// The mean of J over each trial, twice, and its neighbours; an end is its own neighbour.
std::vector<double> smoothed(const std::vector<SupportTrial>& trials) {
  std::vector<double> mean;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const double before = trials[i > 0 ? i - 1 : i].j;
    const double after = trials[i + 1 < trials.size() ? i + 1 : i].j;
    mean.push_back((before + 2 * trials[i].j + after) / 4);
  }
  return mean;
}

}  // namespace

SupportChoice choose_support(const kernel::TriangleMesh& mesh, const FitOptions& options,
                             const GraphOptions& graph_options, const SalienceOptions& salience,
                             const Workers* workers) {
  SupportChoice choice;
  for (const int points : kSupports) {
    choice.trials.push_back(tried(mesh, options, points, graph_options, salience, workers));
    if (falling(choice.trials)) break;
  }
  if (std::all_of(choice.trials.begin(), choice.trials.end(),
                  [](const SupportTrial& t) { return !(t.j > 0); }))
    judge_by_significant(choice.trials);
  const std::vector<double> j = smoothed(choice.trials);
  const double enough = kEnough * *std::max_element(j.begin(), j.end());
  if (!(enough > 0)) return choice;
  const auto first = std::find_if(j.begin(), j.end(), [&](double x) { return x >= enough; });
  choice.points = choice.trials[static_cast<std::size_t>(first - j.begin())].points;
  return choice;
}

}  // namespace crest::ridges
