// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/lineart_report.hpp"

#include <fmt/format.h>

namespace crest::cli {
namespace {

using namespace line_art;

Json to_json(const kernel::StageCounts& c) {
  return {
      {"calls", c.calls}, {"interval", c.interval}, {"exact", c.exact}, {"symbolic", c.symbolic}};
}

Json contours(const Drawing& drawing) {
  const ContourCounts& c = drawing.contours.counts;
  return {{"edges", c.edges},
          {"creases", c.creases},
          {"crossings", c.crossings},
          {"piercings", c.piercings},
          {"cusps", c.cusps},
          {"pieces", c.pieces},
          {"visible", c.visible},
          {"hidden", c.hidden},
          {"edge_on", c.edge_on},
          {"contact", c.contact},
          {"suppressed",
           {{"count", drawing.lines.suppressed}, {"length", drawing.lines.suppressed_length}}},
          {"visible_length", drawing.lines.visible_length},
          {"sheets", drawing.one_sheet ? "proved" : "not claimed"}};
}

void report_hatches(Report& report, const Drawing& drawing) {
  const HatchCounts& h = drawing.counts;
  report["field"] = Json({{"singularities", h.singularities}, {"index_sum", h.index_sum}});
  report["segments"] =
      Json({{"count", h.segments}, {"key_ribs", h.key_ribs}, {"blended", h.blended}});
  report["strokes"] = Json({{"count", drawing.hatches.size()},
                            {"length", h.length},
                            {"median_length", h.median_length},
                            {"spacing", {{"p5", h.p5}, {"median", h.median}, {"p95", h.p95}}},
                            {"bare", h.bare},
                            {"over_contours", h.over_contours}});
  report["tone_error"] = Json({{"mean", h.tone.mean},
                               {"p95", h.tone.p95},
                               {"max", h.tone.max},
                               {"cells", h.tone.cells.size()}});
}

}  // namespace

void report_line_art(Report& report, const Drawing& drawing) {
  report["vertices"] = drawing.scene.points.size();
  report["faces"] = drawing.scene.faces.size();
  report["page"] = std::vector<double>(drawing.view.page.begin(), drawing.view.page.end());
  report["contours"] = contours(drawing);
  if (!drawing.hatches.empty()) report_hatches(report, drawing);
  const kernel::SightCounts& d = drawing.contours.decisions;
  report["predicates"] = Json({{"side_of_edge", to_json(d.side)},
                               {"volume", to_json(d.volume)},
                               {"event_order", to_json(d.order)}});
}

std::string line_art_summary(const Drawing& drawing) {
  const ContourCounts& c = drawing.contours.counts;
  return fmt::format(
      "contours: {}, {}, {}; {} of {} visible\n"
      "strokes: {} of contours, {} of hatches\n",
      plural(c.edges, "edge"), plural(c.crossings, "crossing"), plural(c.piercings, "piercing"),
      c.visible, plural(c.pieces, "piece"), drawing.lines.strokes.size(), drawing.hatches.size());
}

}  // namespace crest::cli
