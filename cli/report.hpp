// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The JSON report: the part all commands share (docs/conventions.md, "Reports").
#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace crest::cli {

using Json = nlohmann::ordered_json;

/// Collects the keys in the order they are written; a command adds its own through json().
class Report {
 public:
  Report(const std::string& command, const std::string& input, int threads);

  Json& json() { return json_; }

  /// Runs `work`, adds its wall time to seconds[phase] and returns its result.
  template <class Work>
  auto timed(const std::string& phase, Work&& work) {
    const Stopwatch stopwatch{*this, phase};
    return std::forward<Work>(work)();
  }

  void warn(const std::string& what) { json_["warnings"].push_back(what); }

  /// A certificate that was written: `claims` are all decided.
  void set_certificate(const std::string& claim);

  /// seconds.total so far and peak_rss_bytes, then the text (two spaces, one final newline).
  /// Numbers that are not finite are null; bytes that are not UTF-8 are replaced.
  std::string text();
  double elapsed() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Stopwatch {
    Report& report;
    std::string phase;
    Clock::time_point start = Clock::now();
    ~Stopwatch() { report.add_seconds(phase, Clock::now() - start); }
  };
  void add_seconds(const std::string& phase, Clock::duration time);

  Json json_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace crest::cli
