// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/sheet.hpp"

#include <algorithm>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/box_pairs.hpp"

namespace crest::certify::smooth {
namespace {

using u32 = std::uint32_t;
using Vec3 = std::array<double, 3>;

class SheetChecker {
 public:
  explicit SheetChecker(const Claim& claim) : claim_(claim), provers_(claim) {}

  /// Returns an enclosure of y.
  Ranges check(const OneSheetRecord& sheet) {
    const u32 face = sheet.face;
    require(!claim_.certificate.face_records[face].in_patch,
            "one sheet: the named face {} is in a patch", face);
    WitnessReader in(sheet.witness, "one sheet: face", face);
    const bool injective = provers_.on_pieces(
        Piece::face(), in, [&](auto& prover, const Piece& piece, unsigned functional) {
          in.check(functional == 0, "says what no piece has");
          return is_injective(prover, claim_.certificate, sheet, piece);
        });
    if (!injective) in.fail("it may fold");
    in.end();
    const auto point = sheet_point(provers_, face);
    if (!point) throw Undecided(fmt::format("one sheet: a point of face {}", face));
    const Surface& s = claim_.surface;
    for (std::size_t k = 0; k < 3; ++k)
      require((*point)[k].low > s.box[2 * k] && (*point)[k].high < s.box[2 * k + 1],
              "one sheet: face {} is not inside the box", face);
    for (std::size_t i = 0; i < sheet.near.size(); ++i)
      check_near(sheet, i, {*point, conormals(claim_.certificate, face)});
    return *point;
  }

 private:
  void check_near(const OneSheetRecord& sheet, std::size_t i, const SheetPoint& y) {
    const auto& near = sheet.near[i];
    require(near.face < claim_.certificate.faces.size() && near.face != sheet.face &&
                (i == 0 || sheet.near[i - 1].face < near.face),
            "one sheet: the faces near face {}", sheet.face);
    WitnessReader in(near.witness, "one sheet: near face", near.face);
    const bool misses = provers_.on_pieces(
        Piece::face(), in, [&](auto& prover, const Piece& piece, unsigned functional) {
          in.check(functional < 6, "names no functional");
          return y.misses(prover, near.face, piece, functional);
        });
    if (!misses) in.fail(fmt::format("it may cover the point of face {}", sheet.face));
    in.end();
  }

  const Claim& claim_;
  FaceProvers provers_;
};

/// No face but those listed has a box that meets y.
void check_far(const Claim& claim, const std::vector<FaceResult>& faces,
               const std::vector<Ranges>& points) {
  const auto& sheets = claim.certificate.one_sheet;
  std::vector<Ranges> boxes;
  std::vector<u32> face_of;
  std::size_t listed = 0;
  std::vector<u32> without;  // faces without a box
  for (u32 f = 0; f < faces.size(); ++f) {
    if (!faces[f].box) {
      without.push_back(f);
      continue;
    }
    boxes.push_back(*faces[f].box);
    face_of.push_back(f);
  }
  const auto is_listed = [&](const OneSheetRecord& sheet, u32 face) {
    const auto found = std::lower_bound(sheet.near.begin(), sheet.near.end(), face,
                                        [](const auto& n, u32 f) { return n.face < f; });
    return sheet.face == face || (found != sheet.near.end() && found->face == face);
  };
  for (const OneSheetRecord& sheet : sheets) {
    listed += 1 + sheet.near.size();
    // As many comparisons as bytes: a list that is shorter lacks one.
    require(without.size() <= 1 + sheet.near.size(), "one sheet: faces without a box");
    for (const u32 f : without)
      require(is_listed(sheet, f), "one sheet: face {} may cover a point of face {}", f,
              sheet.face);
  }
  for (const auto& [point, box] : meeting_boxes(points, boxes, listed))
    require(is_listed(sheets[point], face_of[box]),
            "one sheet: face {} may cover a point of face {}", face_of[box], sheets[point].face);
}

}  // namespace

std::optional<Ranges> sheet_point(FaceProvers& provers, u32 face) {
  return provers.at_order(4, [&](auto& prover) -> std::optional<Ranges> {
    const auto image = prover.image(face, Piece::point(kSheetPoint), false);
    if (!image) return std::nullopt;
    return Ranges{image->x[0].range(), image->x[1].range(), image->x[2].range()};
  });
}

std::array<Vec3, 3> conormals(const RidgesSmoothCertificate& c, u32 face) {
  const auto& corners = c.faces[face];
  const auto step = [&](std::size_t i, std::size_t j) {
    Vec3 d;
    for (std::size_t k = 0; k < 3; ++k)
      d[k] = c.vertices[corners[j]][k] - c.vertices[corners[i]][k];
    return d;
  };
  const Vec3 normal = cross(step(0, 1), step(0, 2));
  return {cross(step(0, 1), normal), cross(step(1, 2), normal), cross(step(2, 0), normal)};
}

void check_one_sheet(const Claim& claim, const std::vector<FaceResult>& faces) {
  const auto& sheets = claim.certificate.one_sheet;
  require(sheets.size() == claim.mesh.components, "one sheet: a named face of each component");
  std::vector<std::uint8_t> seen(claim.mesh.components, 0);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const u32 face = sheets[i].face;
    require(face < faces.size(), "one sheet: no face {}", face);
    require(i == 0 || sheets[i - 1].face < face, "one sheet: faces not ascending");
    auto& mark = seen[claim.mesh.component[face]];
    require(mark == 0, "one sheet: two faces of one component");
    mark = 1;
  }
  std::vector<Ranges> points(sheets.size());
  parallel_for(
      sheets.size(), [&] { return SheetChecker(claim); },
      [&](SheetChecker& checker, std::size_t i) { points[i] = checker.check(sheets[i]); });
  check_far(claim, faces, points);
}

}  // namespace crest::certify::smooth
