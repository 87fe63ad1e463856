// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 5.1 and 5.2: fields compressed under three notions of equal skeletons, by both tests; each
// certificate checked. Processor times of all threads.
#include <fmt/format.h>

#include <string>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/certificate.hpp"
#include "certify/verify.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using namespace vector_fields;

void row(const std::string& name, const sampling::PlanarSample& sample, Equivalence e,
         CollapseTest test, bool flips = true) {
  const PlanarField field{sample.points, sample.vectors, sample.triangles};
  CompressionOptions options;
  options.equivalence = e;
  options.test = test;
  options.flips = flips;
  certify::CompressionCertificate record;
  double start = processor_seconds();
  const Compression c = compress(field, options, record);
  const double seconds = processor_seconds() - start;
  const char* notions[] = {"5.3 strong", "5.2 original", "5.4 relaxed"};
  fmt::print("| {} | {} | {} | {} | {} | {:.1f} | {} | {} | {} | {:.1f} |", name,
             notions[static_cast<std::size_t>(e)],
             test == CollapseTest::thesis ? "printed"
             : flips                      ? "re-trace"
                                          : "re-trace, no flips",
             field.triangles.size(), c.field.triangles.size(),
             100 - 100.0 * static_cast<double>(c.field.triangles.size()) /
                       static_cast<double>(field.triangles.size()),
             c.counts.collapses, c.counts.retraced_crossings, c.counts.rounds, seconds);
  if (!c.same_skeleton) {
    fmt::print(" differ: {} | |\n", c.difference);
    return;
  }
  start = processor_seconds();
  const auto bytes = certify::encode(record);
  const auto verdict = certify::verify(bytes);
  fmt::print(" {} | {:.2f} |\n",
             !verdict.accepted         ? "refused: " + verdict.reason
             : c.counts.undecided == 0 ? "accepted"
                                       : fmt::format("accepted, {} undecided", c.counts.undecided),
             processor_seconds() - start);
}

/// Lattice fields, every second one with a hole: how many skeletons are equal by the two files
/// alone.
void random_fields(int count) {
  fmt::print(
      "\n| notion | fields | equal, accepted | with undecided separatrices | mean saved, % | s | "
      "checks, s |\n|---|---|---|---|---|---|---|\n");
  for (const Equivalence e : {Equivalence::strong, Equivalence::original, Equivalence::relaxed}) {
    int accepted = 0, open = 0;
    std::string exceptions;
    double saved = 0, seconds = 0, checks = 0;
    for (int seed = 1; seed <= count; ++seed) {
      const auto sample =
          sampling::lattice_field(static_cast<std::uint64_t>(seed), 40, seed % 2 == 0);
      const PlanarField field{sample.points, sample.vectors, sample.triangles};
      CompressionOptions options;
      options.equivalence = e;
      certify::CompressionCertificate record;
      double start = processor_seconds();
      const Compression c = compress(field, options, record);
      seconds += processor_seconds() - start;
      saved += 100 - 100.0 * static_cast<double>(c.field.triangles.size()) /
                         static_cast<double>(field.triangles.size());
      open += c.counts.undecided > 0 ? 1 : 0;
      start = processor_seconds();
      const auto verdict = certify::verify(certify::encode(record));
      checks += processor_seconds() - start;
      if (c.same_skeleton && verdict.accepted)
        ++accepted;
      else
        exceptions += fmt::format(", L({}): {}", seed,
                                  c.same_skeleton ? "refused: " + verdict.reason : c.difference);
    }
    const char* notions[] = {"strong", "original", "relaxed"};
    fmt::print("| {} | {} | {}{} | {} | {:.1f} | {:.1f} | {:.1f} |\n",
               notions[static_cast<std::size_t>(e)], count, accepted, exceptions, open,
               saved / count, seconds, checks);
  }
}

void table(int seeds) {
  fmt::print(
      "| field | algorithm | test | triangles | left | saved, % | collapses | crossings | rounds | "
      "s | certificate | its check, s |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const auto rows = [](const std::string& name, const sampling::PlanarSample& sample, bool both) {
    for (const Equivalence e : {Equivalence::strong, Equivalence::original, Equivalence::relaxed})
      row(name, sample, e, CollapseTest::retrace);
    if (!both) return;
    row(name, sample, Equivalence::original, CollapseTest::retrace, false);
    row(name, sample, Equivalence::relaxed, CollapseTest::retrace, false);
    row(name, sample, Equivalence::original, CollapseTest::thesis);
    row(name, sample, Equivalence::relaxed, CollapseTest::thesis);
  };
  rows("Bodden (twin)", sampling::twin_bodden(), true);
  rows("skin friction (twin)", sampling::twin_skin(), true);
  for (int seed = 1; seed <= seeds; ++seed)
    rows(fmt::format("L({}){}", seed, seed % 2 == 0 ? " hole" : ""),
         sampling::lattice_field(static_cast<std::uint64_t>(seed), 40, seed % 2 == 0), false);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int seeds = 4, random = 0;
  crest::experiments::Program program("Compressed plane fields with the same skeleton.");
  program.option("--seeds", seeds, "lattice fields after the twins", {0, 100});
  program.option("--random", random, "of so many lattice fields the sums alone", {0, 10'000});
  return program.run(argc, argv, [&] {
    if (random > 0)
      crest::experiments::random_fields(random);
    else
      crest::experiments::table(seeds);
    return 0;
  });
}
