// SPDX-License-Identifier: GPL-3.0-or-later
// Section 5.6.3: fields compressed with what weighs less than w0 let go, the distribution of
// weights (figure 5.19), and the field at w0 of its way to the smoothed one. Processor times.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/certificate.hpp"
#include "certify/verify.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using namespace vector_fields;

PlanarField field_of(const sampling::PlanarSample& s) {
  return {s.points, s.vectors, s.triangles};
}

void row(const std::string& name, const PlanarField& field, double threshold) {
  CompressionOptions options;
  options.simplify = threshold;
  certify::CompressionCertificate record;
  const double start = processor_seconds();
  const Compression c = compress(field, options, record);
  const double seconds = processor_seconds() - start;
  const auto important = std::count_if(c.importance->zeros.begin(), c.importance->zeros.end(),
                                       [&](const ZeroWeight& z) { return z.weight >= threshold; });
  const Skeleton at =
      extract_skeleton(blended(field, smoothed(field, options.laplacian), threshold));
  const auto verdict = certify::verify(certify::encode(record.output));
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {:.1f} | {} | {:.1f} | {} | {} |\n", name,
             threshold, c.importance->zeros.size(), c.importance->pairs,
             c.importance->zeros.size() - 2 * c.importance->pairs, important, c.counts.cancelled,
             c.field.triangles.size(),
             100 - 100.0 * static_cast<double>(c.field.triangles.size()) /
                       static_cast<double>(field.triangles.size()),
             c.counts.left_below, seconds, at.critical_points.size(),
             !c.same_skeleton    ? "differ: " + c.difference
             : !verdict.accepted ? "refused: " + verdict.reason
                                 : "same; accepted");
}

template <class Items, class Weight>
void histogram(const std::string& name, const Items& items, Weight&& weight) {
  std::array<int, 10> bins{};
  for (const auto& x : items) ++bins[static_cast<std::size_t>(std::min(9.0, 10 * weight(x)))];
  fmt::print("| {} |", name);
  for (const int n : bins)
    fmt::print(" {} ({:.0f} %) |", n, 100.0 * n / static_cast<double>(items.size()));
  fmt::print("\n");
}

void histograms(const std::string& name, const PlanarField& field) {
  const Importance w = weigh(field, smoothed(field), extract_skeleton(field));
  histogram(name + ": zeros, first", w.zeros, [](const ZeroWeight& z) { return z.first; });
  histogram(name + ": zeros, consistent", w.zeros, [](const ZeroWeight& z) { return z.weight; });
  histogram(name + ": separatrices", w.separatrices, [](double x) { return x; });
}

void table() {
  const std::pair<std::string, PlanarField> fields[] = {
      {"skin friction (twin)", field_of(sampling::twin_skin())},
      {"Bodden (twin)", field_of(sampling::twin_bodden())}};
  fmt::print(
      "| field | w0 | zeros | pairs | unpaired | important | cancelled | triangles left | saved, % "
      "| below w0 left | s | zeros of v(., w0) | important part; the output's certificate |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [name, field] : fields)
    for (const double threshold : {0.0, 0.5, 1.0}) row(name, field, threshold);
  fmt::print("\n| weights from i/10 to (i + 1)/10, 1 among the last |");
  for (int i = 0; i < 10; ++i) fmt::print(" 0.{} |", i);
  fmt::print("\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [name, field] : fields) histograms(name, field);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  crest::experiments::Program program("Weights, and fields compressed with the small ones let go.");
  return program.run(argc, argv, [] {
    crest::experiments::table();
    return 0;
  });
}
