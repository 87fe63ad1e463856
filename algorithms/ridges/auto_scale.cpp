// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/auto_scale.hpp"

#include <algorithm>
#include <array>

namespace crest::ridges {
namespace {

constexpr std::array kSupports = {30, 45, 68, 100, 150, 230, 340};

double quotient(double s, double length) {
  return length > 0 ? s * s / length : 0;
}

SupportTrial tried(const kernel::TriangleMesh& mesh, FitOptions options, int points,
                   const GraphOptions& graph_options, const SalienceOptions& salience) {
  options.rings = 0;
  options.scale = 0;
  options.min_points = points;
  options.errors = true;
  const FitResult fit = fit_monge_forms(mesh, options);
  RidgeGraph graph = extract_ridge_graph(mesh, fit.forms, graph_options);
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

}  // namespace

SupportChoice choose_support(const kernel::TriangleMesh& mesh, const FitOptions& options,
                             const GraphOptions& graph_options, const SalienceOptions& salience) {
  SupportChoice choice;
  for (const int points : kSupports) {
    choice.trials.push_back(tried(mesh, options, points, graph_options, salience));
    if (falling(choice.trials)) break;
  }
  const auto less = [](const SupportTrial& a, const SupportTrial& b) { return a.j < b.j; };
  const auto largest = [&] {
    return std::max_element(choice.trials.begin(), choice.trials.end(), less)->j;
  };
  if (!(largest() > 0)) judge_by_significant(choice.trials);
  const double enough = 0.95 * largest();
  if (!(enough > 0)) return choice;
  choice.points =
      std::find_if(choice.trials.begin(), choice.trials.end(), [&](const SupportTrial& t) {
        return t.j >= enough;
      })->points;
  return choice;
}

}  // namespace crest::ridges
