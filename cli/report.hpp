// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The JSON report: the part all commands share (docs/conventions.md, "Reports").
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "io/clean/clean_up.hpp"

namespace crest::cli {

/// "1 loop", "2 loops".
inline std::string plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// The counts of `cleanup`.
Json to_json(const io::CleanUp& done);

/// Collects the keys in the order they are written; a command adds its own.
class Report {
 public:
  Report(const std::string& command, const std::string& input, int threads);

  /// A key of the command.
  Json& operator[](const std::string& key) { return json_[key]; }

  /// Runs `work`, adds its wall time to seconds[phase] and returns its result.
  template <class Work>
  auto timed(const std::string& phase, Work&& work) {
    const Stopwatch stopwatch{*this, phase};
    return std::forward<Work>(work)();
  }
  void add_seconds(const std::string& phase, double seconds);
  double elapsed() const { return seconds_since(start_); }

  void warn(const std::string& what) { warnings_.push_back(what); }
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// A certificate that was written; `undecided`: cells of which it states nothing.
  void set_certificate(const std::string& claim, std::size_t undecided);

  /// seconds.total so far and peak_rss_bytes, then Json::text().
  std::string text();

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  struct Stopwatch {
    Report& report;
    std::string phase;
    Clock::time_point start = Clock::now();
    ~Stopwatch() { report.add_seconds(phase, seconds_since(start)); }
  };

  Json json_;
  std::vector<std::pair<std::string, double>> seconds_;
  std::vector<std::string> warnings_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace crest::cli
