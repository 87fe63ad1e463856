// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/hysteresis.hpp"

#include <algorithm>
#include <cmath>

namespace crest::ridges {
namespace {

/// The profile read from a start, so that a loop is a line that ends where it began.
class Line {
 public:
  Line(const Profile& profile, std::size_t start) : p_(profile), start_(start), place_(1, 0.0) {
    for (std::size_t i = 0; i < p_.gap.size(); ++i) place_.push_back(place_[i] + p_.gap[index(i)]);
  }
  std::size_t size() const { return p_.z.size(); }
  std::size_t index(std::size_t i) const { return (start_ + i) % size(); }
  double z(std::size_t i) const { return p_.z[index(i)]; }
  double around() const { return place_.back(); }
  /// From i to j; past the end once around.
  double length(std::size_t i, std::size_t j) const {
    const std::size_t n = size();
    return place_[j % n] - place_[i % n] + static_cast<double>(j / n - i / n) * around();
  }
  double radius(std::size_t i, std::size_t j) const {
    return (p_.radius[index(i)] + p_.radius[index(j)]) / 2;
  }

 private:
  const Profile& p_;
  std::size_t start_;
  std::vector<double> place_;
};

double strong_share(const Profile& p, double threshold) {
  double all = 0, strong = 0;
  for (std::size_t i = 0; i < p.gap.size(); ++i) {
    const std::size_t j = (i + 1) % p.z.size();
    all += p.gap[i];
    strong += p.gap[i] * ((p.z[i] >= threshold ? 0.5 : 0) + (p.z[j] >= threshold ? 0.5 : 0));
  }
  if (!(all > 0)) return p.z.front() >= threshold ? 1 : 0;
  return strong / all;
}

/// Runs with z >= threshold / 2 that hold a point with z >= threshold.
std::vector<Run> strong_runs(const Line& line, double threshold) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t count = 0;
    bool strong = false;
    for (; i + count < line.size() && line.z(i + count) >= threshold / 2; ++count)
      strong = strong || line.z(i + count) >= threshold;
    if (strong) runs.push_back({i, count});
    i += count + 1;
  }
  return runs;
}

/// Runs with the gaps of at most R between them closed.
std::vector<Run> join_runs(const Line& line, const std::vector<Run>& runs, std::size_t& closed) {
  std::vector<Run> joined;
  for (const Run& run : runs) {
    const std::size_t last = joined.empty() ? 0 : joined.back().first + joined.back().count - 1;
    if (!joined.empty() && line.length(last, run.first) <= line.radius(last, run.first)) {
      joined.back().count = run.first + run.count - joined.back().first;
      ++closed;
    } else {
      joined.push_back(run);
    }
  }
  return joined;
}

/// Closes gaps at ends that hold.
void reach_ends(const Line& line, const Profile& p, std::vector<Run>& runs, std::size_t& closed) {
  const std::size_t n = line.size(), first = runs.front().first;
  const std::size_t end = runs.back().first + runs.back().count;
  const auto near = [&](std::size_t i, std::size_t j) {
    return line.length(i, j) <= line.radius(i, j);
  };
  if (p.holds[1] && end < n && near(end - 1, n - 1)) {
    runs.back().count += n - end;
    ++closed;
  }
  if (p.holds[0] && first > 0 && near(0, first)) {
    runs.front().count += first;
    runs.front().first = 0;
    ++closed;
  }
}

/// Closes a loop's gap between its last run and its first.
void close_loop(const Line& line, std::vector<Run>& runs, std::size_t& closed) {
  const std::size_t n = line.size(), first = runs.front().first;
  const std::size_t end = runs.back().first + runs.back().count;
  if (line.around() - line.length(first, end - 1) > line.radius(first, end - 1)) return;
  ++closed;
  if (runs.size() == 1) {
    runs.front() = {0, n};
    return;
  }
  runs.back().count = n - runs.back().first + first + runs.front().count;
  runs.erase(runs.begin());
}

}  // namespace

Run crease_piece(const Profile& profile, const Run& run) {
  const std::size_t n = profile.z.size();
  std::vector<std::size_t> at;  // from the run's first point on
  for (std::size_t i = 0; i < run.count; ++i)
    if (std::isinf(profile.z[(run.first + i) % n])) at.push_back(i);
  if (at.empty()) return {run.first, 0};
  if (!profile.loop || run.count < n)
    return {(run.first + at.front()) % n, at.back() - at.front() + 1};
  std::size_t first = at.front(), gap = at.front() + n - at.back();  // the widest, before first
  for (std::size_t i = 1; i < at.size(); ++i)
    if (at[i] - at[i - 1] > gap) {
      gap = at[i] - at[i - 1];
      first = at[i];
    }
  return {(run.first + first) % n, n - gap + 1};
}

Runs hysteresis(const Profile& p, double threshold) {
  constexpr double kWhole = 0.8;
  Runs result;
  const std::size_t n = p.z.size();
  if (n == 0) return result;
  const auto weak =
      std::find_if(p.z.begin(), p.z.end(), [&](double z) { return !(z >= threshold / 2); });
  if (strong_share(p, threshold) >= kWhole) return {{{0, n}}, 1, 0};
  // A run of at least R, or else the piece of a crease in it.
  const auto keep = [&](const Run& run, bool as_it_is) {
    const Run kept = as_it_is ? run : crease_piece(p, run);
    if (as_it_is || kept.count > 1) result.kept.push_back(kept);
  };
  const bool even = p.loop && weak == p.z.end();
  const Line line(p, p.loop && !even ? static_cast<std::size_t>(weak - p.z.begin()) : 0);
  if (even) {
    result.found = *std::max_element(p.z.begin(), p.z.end()) >= threshold ? 1 : 0;
    if (result.found > 0) keep({0, n}, line.around() >= line.radius(0, 0));
    return result;
  }
  std::vector<Run> runs = strong_runs(line, threshold);
  result.found = runs.size();
  if (runs.empty()) return result;
  runs = join_runs(line, runs, result.closed);
  if (p.loop)
    close_loop(line, runs, result.closed);
  else
    reach_ends(line, p, runs, result.closed);
  for (const Run& run : runs) {
    const std::size_t last = run.first + run.count - 1;
    const bool whole = run.count == n;
    keep({whole ? 0 : line.index(run.first), run.count},
         line.length(run.first, last) >= line.radius(run.first, last) ||
             (whole && p.between_umbilics));
  }
  return result;
}

}  // namespace crest::ridges
