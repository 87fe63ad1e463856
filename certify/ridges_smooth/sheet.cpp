// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/sheet.hpp"

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"

namespace crest::certify::smooth {
namespace {

using u32 = std::uint32_t;
using Vec3 = std::array<double, 3>;

constexpr int kDepth = 5;
/// Exact, about a third.
constexpr Barycentric kCentre = {349525 * 0x1p-20, 349525 * 0x1p-20, 349526 * 0x1p-20};

class SheetChecker {
 public:
  SheetChecker(const Claim& claim, const std::vector<FaceResult>& faces)
      : claim_(claim), faces_(faces), provers_(claim) {}

  void check(u32 face) {
    require(!claim_.certificate.face_records[face].in_patch,
            "one sheet: the named face {} is in a patch", face);
    face_ = face;
    if (!is_injective()) throw Undecided(fmt::format("one sheet: face {} may fold", face));
    if (!find_point()) throw Undecided(fmt::format("one sheet: a point of face {}", face));
    const Surface& s = claim_.surface;
    for (std::size_t k = 0; k < 3; ++k)
      require(y_[k].low > s.box[2 * k] && y_[k].high < s.box[2 * k + 1],
              "one sheet: face {} is not inside the box", face);
    make_conormals();
    for (u32 other = 0; other < faces_.size(); ++other)
      if (other != face && !(faces_[other].box && apart(*faces_[other].box)) &&
          !misses(other, Piece::face(), 0))
        throw Undecided(
            fmt::format("one sheet: face {} may cover a point of face {}", other, face));
  }

 private:
  using Ranges = std::array<kernel::Range, 3>;
  using Matrix = std::array<Vec3, 2>;

  Frame frame() const { return frame_of(claim_.certificate.face_records[face_]); }

  /// A positive definite symmetric part of C D(projection), C constant: on a convex domain the map
  /// is then injective.
  bool is_injective() {
    Matrix c{};
    const Frame along = frame();
    const bool found = provers_.at_depth(0, [&](auto& prover) {
      const auto image = prover.image(face_, Piece::point(kCentre), true);
      if (!image) return false;
      const auto middle = [&](std::size_t i, std::size_t k) {
        const kernel::Range r = dot(image->derivative[i], along[k]).range();
        return r.low / 2 + r.high / 2;
      };
      const double a = middle(0, 0), b = middle(1, 0), d = middle(0, 1), e = middle(1, 1),
                   det = a * e - b * d;
      c = {Vec3{e / det, -b / det, 0}, Vec3{-d / det, a / det, 0}};
      return true;
    });
    return found && is_injective(Piece::face(), 0, c);
  }

  bool is_injective(const Piece& piece, int depth, const Matrix& c) {
    const Frame along = frame();
    const bool proven = provers_.at_depth(depth, [&](auto& prover) {
      const auto image = prover.image(face_, piece, true);
      if (!image) return false;
      const auto& d = image->derivative;
      const auto entry = [&](std::size_t i, std::size_t j) {
        return dot(d[j], along[0]) * c[i][0] + dot(d[j], along[1]) * c[i][1];
      };
      const auto first = entry(0, 0), twice = entry(0, 1) + entry(1, 0);
      return is_positive(first) && is_positive(first * entry(1, 1) * 4.0 - twice * twice);
    });
    if (proven || depth == kDepth) return proven;
    for (std::size_t k = 0; k < 4; ++k)
      if (!is_injective(piece.child(k), depth + 1, c)) return false;
    return true;
  }

  bool find_point() {
    return provers_.at_depth(0, [&](auto& prover) {
      const auto image = prover.image(face_, Piece::point(kCentre), false);
      if (!image) return false;
      for (std::size_t k = 0; k < 3; ++k) y_[k] = image->x[k].range();
      return true;
    });
  }

  bool apart(const Ranges& box) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (box[k].low > y_[k].high || box[k].high < y_[k].low) return true;
    return false;
  }

  /// Any vectors prove something; these separate neighbours.
  void make_conormals() {
    const auto& corners = claim_.certificate.faces[face_];
    const auto step = [&](std::size_t i, std::size_t j) {
      Vec3 d;
      for (std::size_t k = 0; k < 3; ++k)
        d[k] =
            claim_.certificate.vertices[corners[j]][k] - claim_.certificate.vertices[corners[i]][k];
      return d;
    };
    const Vec3 normal = cross(step(0, 1), step(0, 2));
    for (std::size_t i = 0; i < 3; ++i) conormal_[i] = cross(step(i, (i + 1) % 3), normal);
  }

  /// Some functional differs from its value at y on each piece.
  bool misses(u32 other, const Piece& piece, int depth) {
    const bool proven = provers_.at_depth(depth, [&](auto& prover) {
      const auto image = prover.image(other, piece, false);
      if (!image) return false;
      const auto& x = image->x;
      if (apart({x[0].range(), x[1].range(), x[2].range()})) return true;
      using Model = std::decay_t<decltype(x[0])>;
      std::array<Model, 3> away;
      for (std::size_t k = 0; k < 3; ++k) away[k] = x[k] - constants<Model>(y_[k]);
      for (const Vec3& c : conormal_)
        if (has_no_zero(away[0] * c[0] + away[1] * c[1] + away[2] * c[2])) return true;
      return false;
    });
    if (proven || depth == kDepth) return proven;
    for (std::size_t k = 0; k < 4; ++k)
      if (!misses(other, piece.child(k), depth + 1)) return false;
    return true;
  }

  const Claim& claim_;
  const std::vector<FaceResult>& faces_;
  FaceProvers provers_;
  u32 face_ = 0;
  Ranges y_{};
  std::array<Vec3, 3> conormal_{};
};

}  // namespace

void check_one_sheet(const Claim& claim, const std::vector<FaceResult>& faces) {
  const auto& named = claim.certificate.one_sheet_faces;
  require(named.size() == claim.mesh.components, "one sheet: a named face of each component");
  std::vector<std::uint8_t> seen(claim.mesh.components, 0);
  for (std::size_t i = 0; i < named.size(); ++i) {
    require(named[i] < faces.size(), "one sheet: no face {}", named[i]);
    require(i == 0 || named[i - 1] < named[i], "one sheet: faces not ascending");
    auto& mark = seen[claim.mesh.component[named[i]]];
    require(mark == 0, "one sheet: two faces of one component");
    mark = 1;
  }
  parallel_for(
      named.size(), [&] { return SheetChecker(claim, faces); },
      [&](SheetChecker& checker, std::size_t i) { checker.check(named[i]); });
}

}  // namespace crest::certify::smooth
