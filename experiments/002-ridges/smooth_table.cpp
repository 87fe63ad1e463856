// SPDX-License-Identifier: GPL-3.0-or-later
// Paper 002, case I: certified ridges and umbilics of smooth surfaces, their certificates and the
// checker; surfaces that must be refused; growth as a surface nears a degenerate one.
#include <fmt/format.h>
#include <sched.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "certify/ridges_smooth/encode.hpp"
#include "certify/verify.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/program.hpp"
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
  std::string stopped;  ///< why there is no result
  certify::Verdict verdict;
  std::size_t bytes = 0;  ///< of the certificate
  // s, a run each: processor time on one processor, then time by the clock with all of them.
  std::vector<double> cpu, check_cpu, wall, check_wall;
};

SmoothRidges extract(const SmoothSurface& surface, const Options& o) {
  const double start = cpu_seconds();
  smooth_ridges::Options options;
  options.refinement.max_faces = o.faces;
  options.refinement.progress = [&](int round, std::size_t faces, std::size_t left) {
    if (left > 0 && cpu_seconds() - start > o.seconds) throw TimeSpent{round, faces, left};
  };
  return smooth_ridges::smooth_ridges(experiments::make_surface(surface), options);
}

/// Extraction with its certificate's bytes, then the checker: what is compared runs side by side.
void run_once(const SmoothSurface& surface, const Options& o, double (*clock)(),
              std::vector<double>& extraction, std::vector<double>& check, Outcome& outcome) {
  const double start = clock();
  try {
    outcome.result = extract(surface, o);
  } catch (const TimeSpent& t) {
    outcome.stopped = fmt::format("stopped after {:.0f} s in round {}: {} faces, {} undecided",
                                  clock() - start, t.round, t.faces, t.left);
  } catch (const std::exception& error) {
    outcome.stopped = error.what();
  }
  certify::Bytes bytes;
  if (outcome.result.certified) bytes = certify::encode(outcome.result.certificate);
  outcome.bytes = bytes.size();
  extraction.push_back(clock() - start);
  if (!outcome.result.certified) return;
  cpu_set_t all, first;
  sched_getaffinity(0, sizeof all, &all);
  CPU_ZERO(&first);
  CPU_SET(0, &first);
  // On one processor the checker's threads take turns: nothing waits for another.
  if (clock == cpu_seconds) sched_setaffinity(0, sizeof first, &first);
  const double begin = clock();
  outcome.verdict = certify::verify(bytes);
  check.push_back(clock() - begin);
  sched_setaffinity(0, sizeof all, &all);
}

Outcome run(const SmoothSurface& surface, const Options& o) {
  Outcome outcome;
  for (int i = 0; i < o.runs; ++i) {
    {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      run_once(surface, o, cpu_seconds, outcome.cpu, outcome.check_cpu, outcome);
    }
    if (!outcome.result.certified) break;
    run_once(surface, o, wall_seconds, outcome.wall, outcome.check_wall, outcome);
    if (outcome.cpu.back() > kOnceFrom) break;
  }
  return outcome;
}

double median_quotient(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] /= b[i];
  return median(std::move(a));
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
  const auto ridges = [&](kernel::Colour colour) {
    const auto of = [&](bool loop) {
      return count(r.ridges, [&](const auto& x) { return x.colour == colour && x.loop == loop; });
    };
    const int turning = count(r.turning_points, [&](const auto& p) { return p.colour == colour; });
    return fmt::format("{} + {}, {}", of(true), of(false), turning);
  };
  return fmt::format("{} | {}, {}; {}, {} | {} | {} | {}", r.euler_characteristic, index(1),
                     index(-1), kind(1), kind(3), ridges(kernel::Colour::blue),
                     ridges(kernel::Colour::red), r.purple_points.size());
}

void surface_row(const SmoothSurface& surface, const Options& o) {
  const Outcome outcome = run(surface, o);
  const SmoothRidges& r = outcome.result;
  if (!r.certified) {
    const bool partial = outcome.stopped.empty();
    fmt::print("| {} | | | | | | {} | {} | {} | {:.2f} | | | | not certified: {} |\n", surface.name,
               partial ? std::to_string(r.faces.size()) : "",
               partial ? std::to_string(r.rounds) : "", partial ? std::to_string(r.tests) : "",
               median(outcome.cpu), reason(outcome));
    return;
  }
  fmt::print(
      "| {} | {} | {} | {} | {} | {:.2f}, {:.2f} | {:.2f}, {:.2f} | {:.2f}, {:.2f} | {:.1f} | {} "
      "|\n",
      surface.name, counts(r), r.faces.size(), r.rounds, r.tests, median(outcome.cpu),
      median(outcome.wall), median(outcome.check_cpu), median(outcome.check_wall),
      median_quotient(outcome.check_cpu, outcome.cpu),
      median_quotient(outcome.check_wall, outcome.wall),
      static_cast<double>(outcome.bytes) / static_cast<double>(r.faces.size()),
      outcome.verdict.accepted ? "accepted" : "REJECTED: " + outcome.verdict.reason);
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
             stopped ? "" : std::to_string(r.undecided.size()), median(outcome.cpu),
             reason(outcome));
}

/// Where one thread's time goes, in per cent.
void phases_row(const SmoothSurface& surface, const Options& o) {
  std::array<std::vector<double>, 8> shares;
  for (int i = 0; i < o.runs; ++i) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const double start = wall_seconds();
    const SmoothRidges r = extract(surface, o);
    const double extracted = wall_seconds();
    const certify::Bytes bytes = certify::encode(r.certificate);
    const double all = wall_seconds() - start;
    const auto& s = r.seconds;
    const double times[] = {
        s.completeness,         s.start, s.faces, s.umbilics, s.bisection, s.graph,
        start + all - extracted};
    for (std::size_t k = 0; k < std::size(times); ++k) shares[k].push_back(100 * times[k] / all);
    shares[7].push_back(1e6 * s.faces / static_cast<double>(r.tests));
  }
  fmt::print("| {} |", surface.name);
  for (const auto& share : shares) fmt::print(" {:.1f} |", median(share));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print(" {} |\n", usage.ru_maxrss / 1024);
}

bool is_wanted(const std::string& name, const Options& o) {
  return o.only.empty() || std::any_of(o.only.begin(), o.only.end(), [&](const std::string& part) {
           return name.find(part) != std::string::npos;
         });
}

struct Table {
  std::string heading;
  std::vector<SmoothSurface> surfaces;
  void (*row)(const SmoothSurface&, const Options&);
  const char* note;
};
Table table_of(const std::string& name) {
  if (name == "refusals")
    return {"surface | exit code | faces | undecided | s | reason",
            experiments::degenerate_surfaces(), refusal_row,
            "Seconds: processor time of one thread. The exit code is that of `crest ridges` for "
            "this result: 4 with undecided\ncells, 1 without a triangulation."};
  if (name == "phases")
    return {
        "surface | all components | start | faces | umbilics | bisection | graph | encoding | "
        "us a face test | peak MB so far",
        experiments::generic_surfaces(), phases_row,
        "Per cent of one thread's time by the clock, encoding included: the box's search for "
        "components and the proof that each\nis covered once; the first triangulation; tests of "
        "faces; umbilics and their patches; making of faces; the graph and\nthe certificate's "
        "contents. Peak memory is the program's, over all rows so far."};
  return {
      "surface | chi | umbilics +1/2, -1/2; 1-ridge, 3-ridge | blue loops + paths, turning "
      "points | red loops + paths, turning points | purple points | triangles | rounds | face "
      "tests | s: one thread, two | checker s: one, two | quotients | bytes a triangle | verdict",
      name == "growth"     ? experiments::growing_surfaces()
      : name == "reported" ? experiments::reported_surfaces()
                           : experiments::generic_surfaces(),
      surface_row,
      "Seconds: processor time of one thread, time by the clock of two, encoding included. "
      "Quotients: checker over extraction,\nof runs side by side, on one thread and on two."};
}

void run_table(const Options& o) {
  const auto [heading, surfaces, print_row, note] = table_of(o.table);
  std::string rule = "|---";
  for (const char c : heading)
    if (c == '|') rule += "|---";
  fmt::print("| {} |\n{}|\n", heading, rule);
  for (const SmoothSurface& surface : surfaces) {
    if (!is_wanted(surface.name, o)) continue;
    print_row(surface, o);
    std::fflush(stdout);
  }
  fmt::print(
      "\n{}\nMedians of {} runs (of one from {} s on); at most {} faces and {} s a surface.\n",
      note, o.runs, kOnceFrom, o.faces, o.seconds);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("Certified ridges of smooth surfaces");
  program.option("--table", o.table, "surfaces, reported, refusals, growth or phases",
                 {"surfaces", "reported", "refusals", "growth", "phases"});
  program.option("--only", o.only, "surfaces whose name contains one of these");
  program.option("--faces", o.faces, "a surface's budget");
  program.option("--seconds", o.seconds, "a surface's time");
  program.option("--runs", o.runs, "whose median is shown", {1, 100});
  return program.run(argc, argv, [&] {
    crest::kernel::require_sound_floating_point();
    crest::run_table(o);
    return 0;
  });
}
