// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/modes_curves_report.hpp"

#include <fmt/format.h>

#include <array>

namespace crest::cli {
namespace {

using modes::DegenerateCurves;
using modes::SpecialReason;

const char* word(SpecialReason reason) {
  switch (reason) {
    case SpecialReason::zero_tensor:
      return "zero_tensor";
    case SpecialReason::dependent:
      return "dependent";
    case SpecialReason::zero_quartic:
      return "zero_quartic";
    case SpecialReason::multiple_point:
      return "multiple_point";
    case SpecialReason::on_rim:
      return "on_rim";
    case SpecialReason::line_pair:
      return "line_pair";
  }
  return "";
}

struct TypeCounts {
  std::size_t count = 0, closed = 0, at_special = 0, face_points = 0;
  double length = 0;
};

std::array<TypeCounts, 2> count(const DegenerateCurves& curves) {
  std::array<TypeCounts, 2> result;
  for (const auto& c : curves.curves) {
    TypeCounts& t = result[static_cast<std::size_t>(c.type)];
    ++t.count;
    t.closed += c.closed;
    t.at_special += c.at_special;
    t.length += c.length;
  }
  for (const auto& p : curves.points) ++result[static_cast<std::size_t>(p.type)].face_points;
  return result;
}

}  // namespace

Json curves_to_json(const DegenerateCurves& curves, const std::vector<std::int64_t>& cell_of) {
  Json result;
  const auto counts = count(curves);
  for (std::size_t k = 0; k < 2; ++k)
    result[k == 0 ? "linear" : "planar"] = {{"count", counts[k].count},
                                            {"closed", counts[k].closed},
                                            {"at_special", counts[k].at_special},
                                            {"length", counts[k].length},
                                            {"face_points", counts[k].face_points}};
  Json faces = Json::array(), tets = Json::array();
  for (const auto& f : curves.special_faces)
    faces.push_back({{"face", f.face}, {"reason", word(f.reason)}});
  for (const auto& t : curves.special_tets)
    tets.push_back({{"tet", cell_of[t.tet]}, {"reason", word(t.reason)}});
  result["special_faces"] = faces;
  result["special_tets"] = tets;
  result["degenerate_edges"] = curves.degenerate_edges;
  Json undecided = Json::array();
  for (const auto t : curves.undecided) undecided.push_back(cell_of[t]);
  result["undecided"] = undecided;
  result["tests"] = {{"rejected_tets", curves.counts.rejected_tets},
                     {"rejected_faces", curves.counts.rejected_faces},
                     {"triage_faces", curves.counts.triage_faces},
                     {"exact_faces", curves.counts.exact_faces}};
  return result;
}

std::string curves_summary(const DegenerateCurves& curves) {
  std::string text;
  const auto counts = count(curves);
  for (std::size_t k = 0; k < 2; ++k)
    text += fmt::format("{} degenerate curves: {}, {} of them closed, length {:.5g}\n",
                        k == 0 ? "linear" : "planar", counts[k].count, counts[k].closed,
                        counts[k].length);
  return text;
}

std::string curves_warning(const DegenerateCurves& curves) {
  if (curves.special_faces.empty() && curves.special_tets.empty() && curves.undecided.empty())
    return "";
  return fmt::format(
      "degenerate curves: {} faces and {} tetrahedra are special (named in --report), {} not "
      "decided; curves "
      "end there",
      curves.special_faces.size(), curves.special_tets.size(), curves.undecided.size());
}

}  // namespace crest::cli
