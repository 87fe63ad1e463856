// SPDX-License-Identifier: GPL-3.0-or-later
// One sheet: matrices, divisions, functionals.
#include "certify/container/reject.hpp"
#include "certify/smooth_witness/loop.hpp"
#include "certify/smooth_witness/parts.hpp"

namespace crest::certify::witness {
namespace {

using smooth::FaceProvers;
using smooth::Piece;

constexpr int kDepth = 5;

/// Pieces with a functional each (0 if there is none to choose): find(prover, piece) is its number,
/// or -1. False if the deepest leave it open.
template <class Find>
bool record_pieces(FaceProvers& provers, const Piece& piece, int depth, const Find& find,
                   Bytes& out) {
  const int order = depth < 2 ? 4 : 5;
  const int found = provers.at_order(order, [&](auto& p) { return find(p, piece); });
  if (found >= 0) {
    out.push_back(static_cast<std::uint8_t>(order - 3 + 8 * found));
    return true;
  }
  if (depth == kDepth) return false;
  out.push_back(static_cast<std::uint8_t>(order - 3 + smooth::DivisionNode::kDivided));
  for (std::size_t k = 0; k < 4; ++k)
    if (!record_pieces(provers, piece.child(k), depth + 1, find, out)) return false;
  return true;
}

/// Does the box, or one half as wide again, hold a point of y?
bool is_near(const std::optional<Ranges>& box, const Ranges& y) {
  for (std::size_t k = 0; box && k < 3; ++k) {
    const double margin = ((*box)[k].high - (*box)[k].low) / 4;
    if ((*box)[k].low - margin > y[k].high || (*box)[k].high + margin < y[k].low) return false;
  }
  return true;
}

class SheetRecorder {
 public:
  SheetRecorder(const Claim& claim, const std::vector<std::optional<Ranges>>& boxes)
      : claim_(claim), boxes_(boxes), provers_(claim) {}

  void record(OneSheetRecord& sheet) {
    const auto fail = [&](const char* what) {
      throw Undecided(fmt::format("one sheet: face {}: {}", sheet.face, what));
    };
    if (!find_matrix(sheet)) fail("no derivative");
    sheet.witness.clear();
    sheet.near.clear();
    const auto injective = [&](auto& prover, const Piece& piece) {
      return smooth::is_injective(prover, claim_.certificate, sheet, piece) ? 0 : -1;
    };
    if (!record_pieces(provers_, Piece::face(), 0, injective, sheet.witness)) fail("it may fold");
    const auto y = smooth::sheet_point(provers_, sheet.face);
    if (!y) fail("no point");
    const smooth::SheetPoint point = {*y, smooth::conormals(claim_.certificate, sheet.face)};
    for (u32 f = 0; f < boxes_.size(); ++f) {
      if (f == sheet.face || !is_near(boxes_[f], *y)) continue;
      const auto functional = [&](auto& prover, const Piece& piece) {
        for (unsigned k = 0; k < 6; ++k)
          if (point.misses(prover, f, piece, k)) return static_cast<int>(k);
        return -1;
      };
      auto& near = sheet.near.emplace_back();
      near.face = f;
      if (!record_pieces(provers_, Piece::face(), 0, functional, near.witness))
        throw Undecided(
            fmt::format("one sheet: face {} may cover a point of face {}", f, sheet.face));
    }
  }

 private:
  /// The inverse of the derivative at y.
  bool find_matrix(OneSheetRecord& sheet) {
    const smooth::Frame along = smooth::frame_of(claim_.certificate.face_records[sheet.face]);
    return provers_.at_order(4, [&](auto& prover) {
      const auto image = prover.image(sheet.face, Piece::point(smooth::kSheetPoint), true);
      if (!image) return false;
      const auto at = [&](std::size_t i, std::size_t k) {
        return middle(smooth::dot(image->derivative[i], along[k]).range());
      };
      const double a = at(0, 0), b = at(1, 0), d = at(0, 1), e = at(1, 1), det = a * e - b * d;
      sheet.matrix = {e / det, -b / det, -d / det, a / det};
      for (double& x : sheet.matrix) x += 0.0;
      return std::isfinite(sheet.matrix[0] + sheet.matrix[1] + sheet.matrix[2] + sheet.matrix[3]);
    });
  }

  const Claim& claim_;
  const std::vector<std::optional<Ranges>>& boxes_;
  FaceProvers provers_;
};

}  // namespace

void record_sheets(const Claim& claim, RidgesSmoothCertificate& c,
                   const std::vector<std::optional<Ranges>>& boxes) {
  for (const OneSheetRecord& sheet : c.one_sheet)
    require(sheet.face < c.faces.size() && !c.face_records[sheet.face].in_patch,
            "one sheet: no face {} outside patches", sheet.face);
  for_all(
      c.one_sheet.size(), [&] { return SheetRecorder(claim, boxes); },
      [&](SheetRecorder& recorder, std::size_t i) { recorder.record(c.one_sheet[i]); });
}

}  // namespace crest::certify::witness
