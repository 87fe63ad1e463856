// SPDX-License-Identifier: GPL-3.0-or-later
// Paper 002, case I: certified ridges and umbilics of smooth surfaces, their certificates and the
// checker; surfaces that must be refused; growth as a surface nears a degenerate one.
#include <fmt/format.h>
#include <sched.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "certify/verify.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

using experiments::SmoothSurface;
using smooth_ridges::SmoothRidges;

struct Options {
  std::string table = "surfaces";
  std::vector<std::string> only;
  std::size_t faces = 400000;
  double seconds = 180;
  int runs = 3;
};

constexpr double kOnceFrom = 20;  // s: such runs are not repeated

/// Of this process: what other programs do on the machine hardly matters.
double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

/// Thrown out of the refinement when a surface's time is spent.
struct TimeSpent {
  int round;
  std::size_t faces, left;
};

struct Outcome {
  SmoothRidges result;
  std::vector<double> seconds;
  std::string stopped;  ///< why there is no result
};

/// On one thread.
Outcome run(const SmoothSurface& surface, const Options& o) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  Outcome outcome;
  while (outcome.seconds.size() < static_cast<std::size_t>(o.runs)) {
    const double start = cpu_seconds();
    smooth_ridges::Options options;
    options.refinement.max_faces = o.faces;
    options.refinement.progress = [&](int round, std::size_t faces, std::size_t left) {
      if (left > 0 && cpu_seconds() - start > o.seconds) throw TimeSpent{round, faces, left};
    };
    try {
      outcome.result = smooth_ridges::smooth_ridges(experiments::make_surface(surface), options);
    } catch (const TimeSpent& t) {
      outcome.stopped = fmt::format("stopped after {:.0f} s in round {}: {} faces, {} undecided",
                                    cpu_seconds() - start, t.round, t.faces, t.left);
    } catch (const std::exception& error) {
      outcome.stopped = error.what();
    }
    outcome.seconds.push_back(cpu_seconds() - start);
    if (outcome.seconds.back() > kOnceFrom || !outcome.result.certified) break;
  }
  return outcome;
}

/// Seconds of the checker: CPU, and by the clock with all threads.
struct Checked {
  certify::Verdict verdict;
  double cpu = 0, wall = 0;
};
Checked check(const certify::Bytes& bytes, int runs) {
  std::vector<double> cpu, wall;
  Checked checked;
  // On one processor the checker's threads take turns: nothing waits for another.
  cpu_set_t all, first;
  sched_getaffinity(0, sizeof all, &all);
  CPU_ZERO(&first);
  CPU_SET(0, &first);
  for (const cpu_set_t* processors : {&first, &all}) {
    sched_setaffinity(0, sizeof *processors, processors);
    auto& seconds = processors == &first ? cpu : wall;
    for (int i = 0; i < runs; ++i) {
      const double start = processors == &first ? cpu_seconds() : wall_seconds();
      checked.verdict = certify::verify(bytes);
      seconds.push_back((processors == &first ? cpu_seconds() : wall_seconds()) - start);
    }
  }
  checked.cpu = median(cpu);
  checked.wall = median(wall);
  return checked;
}

/// Why there is no claim, in one line.
std::string reason(const Outcome& outcome) {
  if (!outcome.stopped.empty()) return outcome.stopped;
  std::string text;
  for (const std::string& line : outcome.result.obstacles)
    text += (text.empty() ? "" : "; ") + line;
  if (!outcome.result.undecided.empty()) text += ": " + outcome.result.undecided[0].reason;
  return text;
}

template <class Range, class Predicate>
int count(const Range& range, Predicate&& predicate) {
  return static_cast<int>(std::count_if(range.begin(), range.end(), predicate));
}

std::string counts(const SmoothRidges& r) {
  const auto index = [&](int twice) {
    return count(r.umbilics, [&](const auto& u) { return u.twice_index == twice; });
  };
  const auto kind = [&](int branches) {
    return count(r.umbilics, [&](const auto& u) { return u.branches[0] == branches; });
  };
  const auto ridges = [&](std::size_t colour) {
    const auto of = [&](bool loop) {
      return count(r.ridges, [&](const auto& x) { return x.colour == colour && x.loop == loop; });
    };
    const int turning = count(r.turning_points, [&](const auto& p) { return p.colour == colour; });
    return fmt::format("{} + {}, {}", of(true), of(false), turning);
  };
  return fmt::format("{} | {}, {}; {}, {} | {} | {} | {}", r.euler_characteristic, index(1),
                     index(-1), kind(1), kind(3), ridges(0), ridges(1), r.purple_points.size());
}

void surface_row(const SmoothSurface& surface, const Options& o) {
  const Outcome outcome = run(surface, o);
  const SmoothRidges& r = outcome.result;
  const double seconds = median(outcome.seconds);
  if (!r.certified) {
    const bool partial = outcome.stopped.empty();
    fmt::print("| {} | | | | | | {} | {} | {} | {:.2f} | | | | not certified: {} |\n", surface.name,
               partial ? std::to_string(r.faces.size()) : "",
               partial ? std::to_string(r.rounds) : "", partial ? std::to_string(r.tests) : "",
               seconds, reason(outcome));
    return;
  }
  const certify::Bytes bytes = certify::encode(r.certificate);
  const Checked checked = check(bytes, o.runs);
  fmt::print("| {} | {} | {} | {} | {} | {:.2f} | {:.1f} | {:.2f} | {:.2f} | {} |\n", surface.name,
             counts(r), r.faces.size(), r.rounds, r.tests, seconds,
             static_cast<double>(bytes.size()) / static_cast<double>(r.faces.size()), checked.cpu,
             checked.wall,
             checked.verdict.accepted ? "accepted" : "REJECTED: " + checked.verdict.reason);
}

void refusal_row(const SmoothSurface& surface, const Options& o) {
  const Outcome outcome = run(surface, o);
  const SmoothRidges& r = outcome.result;
  const bool stopped = !outcome.stopped.empty();
  fmt::print("| {} | {} | {} | {} | {:.2f} | {} |\n", surface.name,
             r.certified           ? "CERTIFIED"
             : stopped             ? "-"
             : r.undecided.empty() ? "1"
                                   : "4",
             stopped ? "" : std::to_string(r.faces.size()),
             stopped ? "" : std::to_string(r.undecided.size()), median(outcome.seconds),
             reason(outcome));
}

bool is_wanted(const std::string& name, const Options& o) {
  return o.only.empty() || std::any_of(o.only.begin(), o.only.end(), [&](const std::string& part) {
           return name.find(part) != std::string::npos;
         });
}

void run_table(const Options& o) {
  const bool refusals = o.table == "refusals";
  fmt::print(
      "{}\n",
      refusals
          ? "| surface | exit code | faces | undecided | s | reason |\n|---|---|---|---|---|---|"
          : "| surface | chi | umbilics +1/2, -1/2; 1-ridge, 3-ridge | blue loops + paths, turning "
            "points | red loops + paths, turning points | purple points | triangles | rounds | "
            "face "
            "tests | s | bytes a triangle | checker s | with two threads | verdict "
            "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  const auto surfaces = refusals              ? experiments::degenerate_surfaces()
                        : o.table == "growth" ? experiments::growing_surfaces()
                                              : experiments::generic_surfaces();
  for (const SmoothSurface& surface : surfaces) {
    if (!is_wanted(surface.name, o)) continue;
    (refusals ? refusal_row : surface_row)(surface, o);
    std::fflush(stdout);
  }
  fmt::print(
      "\nSeconds are processor time of one thread, the median of {} runs (of one from {} s on); "
      "the "
      "column\n\"with two threads\" is by the clock. At most {} faces and {} s a surface.\n",
      o.runs, kOnceFrom, o.faces, o.seconds);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  CLI::App app{"Certified ridges of smooth surfaces"};
  app.add_option("--table", o.table, "surfaces, refusals or growth")
      ->check(CLI::IsMember({"surfaces", "refusals", "growth"}));
  app.add_option("--only", o.only, "surfaces whose name contains one of these");
  app.add_option("--faces", o.faces, "a surface's budget");
  app.add_option("--seconds", o.seconds, "a surface's time");
  app.add_option("--runs", o.runs, "whose median is shown")->check(CLI::Range(1, 100));
  CLI11_PARSE(app, argc, argv);
  fmt::print("Command:");
  for (int i = 0; i < argc; ++i)
    fmt::print(" {}", i == 0 ? "experiments/002-ridges/smooth_table" : argv[i]);
  fmt::print("\n\n");
  try {
    crest::kernel::require_sound_floating_point();
    crest::run_table(o);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
  return 0;
}
