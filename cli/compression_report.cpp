// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/compression_report.hpp"

#include <fmt/format.h>
#include <lzma.h>

#include <stdexcept>
#include <vector>

#include "cli/skeleton_report.hpp"

namespace crest::cli {
namespace {

using namespace vector_fields;

double saved(const PlanarField& before, const PlanarField& after) {
  return 100 - 100.0 * static_cast<double>(after.triangles.size()) /
                   static_cast<double>(before.triangles.size());
}

/// Positions, vectors and triangles.
std::vector<std::uint8_t> bytes(const PlanarField& field) {
  std::vector<std::uint8_t> result;
  const auto add = [&](const auto& items) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(items.data());
    result.insert(result.end(), first, first + items.size() * sizeof items[0]);
  };
  add(field.points);
  add(field.vectors);
  add(field.triangles);
  return result;
}

/// Bytes of that as an .xz file.
std::size_t packed(const std::vector<std::uint8_t>& raw) {
  std::vector<std::uint8_t> result(lzma_stream_buffer_bound(raw.size()));
  std::size_t size = 0;
  if (lzma_easy_buffer_encode(LZMA_PRESET_DEFAULT, LZMA_CHECK_CRC64, nullptr, raw.data(),
                              raw.size(), result.data(), &size, result.size()) != LZMA_OK)
    throw std::runtime_error("xz: the arrays cannot be packed");
  return size;
}

}  // namespace

void report_compression(Report& report, const PlanarField& field, const CompressionOptions& options,
                        const Compression& r) {
  const char* notions[] = {"strong", "original", "relaxed"};
  report["equivalence"] = notions[static_cast<std::size_t>(options.equivalence)];
  report["test"] = options.test == CollapseTest::thesis ? "thesis" : "retrace";
  report["triangles_before"] = field.triangles.size();
  report["triangles_after"] = r.field.triangles.size();
  report["ratio"] = saved(field, r.field);
  report["vertices_before"] = field.points.size();
  report["vertices_after"] = r.field.points.size();
  const auto before = bytes(field), after = bytes(r.field);
  report["bytes"] = {{"before", before.size()},
                     {"after", after.size()},
                     {"xz_before", packed(before)},
                     {"xz_after", packed(after)}};
  const CompressionCounts& c = r.counts;
  report["passes"] = c.passes;
  report["collapses"] = c.collapses;
  report["filled"] = c.filled;
  report["flips"] = c.flips;
  report["tests"] = c.tests;
  report["refused"] = {{"geometry", c.refused.geometry},
                       {"boundary", c.refused.boundary},
                       {"critical_points", c.refused.critical_points},
                       {"ends", c.refused.ends},
                       {"order", c.refused.order},
                       {"orbit", c.refused.orbit},
                       {"undecided", c.refused.undecided}};
  report["retraced_crossings"] = c.retraced_crossings;
  report["ordered_by_inheritance"] = c.inherited;
  report["rounds"] = c.rounds;
  report["pinned"] = c.pinned;
  report["same_skeleton"] = r.importance ? Json() : Json(r.same_skeleton);
  if (r.importance) {
    Json simplify = importance_in_words(*r.importance, *options.simplify, options.laplacian);
    simplify["important_same"] = r.same_skeleton;
    simplify["cancelled"] = c.cancelled;
    simplify["left_below"] = c.left_below;
    report["simplify"] = simplify;
  }
  report["skeleton"] = skeleton_in_words(r.field, r.after);
}

std::string compression_summary(const PlanarField& field, const Compression& r) {
  const std::string open =
      r.counts.undecided == 0
          ? ""
          : fmt::format(", but for {} undecided separatrices", r.counts.undecided);
  if (r.importance)
    return fmt::format(
               "{} triangles of {}: {:.1f} % saved, {} collapses in {} passes\n"
               "{} critical points are gone, {} unimportant ones left; what is important is the "
               "same in both proven skeletons{}, which no certificate states:\n",
               r.field.triangles.size(), field.triangles.size(), saved(field, r.field),
               r.counts.collapses, r.counts.passes, r.counts.cancelled, r.counts.left_below, open) +
           skeleton_summary(r.after);
  return fmt::format(
             "{} triangles of {}: {:.1f} % saved, {} collapses in {} passes\n"
             "the same skeleton, proven for both fields{}:\n",
             r.field.triangles.size(), field.triangles.size(), saved(field, r.field),
             r.counts.collapses, r.counts.passes, open) +
         skeleton_summary(r.after);
}

}  // namespace crest::cli
