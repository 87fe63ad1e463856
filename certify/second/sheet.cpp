// SPDX-License-Identifier: GPL-3.0-or-later
// SPEC.md, "One sheet, kind 0" and "A component's one sheet".
#include <set>

#include "certify/second/boxes.hpp"
#include "certify/second/vectors.hpp"

namespace crest::recheck {
namespace {

constexpr int kFunctionals = 6;

class SheetProof {
 public:
  SheetProof(const Problem& problem, const std::vector<FaceOutcome>& outcomes,
             const SheetRecord& record)
      : problem_(problem), outcomes_(outcomes), record_(record) {}

  void check() {
    const Certificate& c = problem_.certificate;
    if (c.records[record_.face].in_patch) throw Rejected("one sheet: its face is in a patch");
    find_point();
    Reader in(record_.division.data(), record_.division.size(), "one sheet, " + name());
    read_division(in, Piece::face(), kTriangleDepth, 0, [&](const Piece& piece, unsigned) {
      shown<Piece>(piece, kFurther, [&](const Piece& p) { injective_on(p); });
    });
    in.finish();
    auto other = record_.others.begin();
    for (Index f = 0; f < c.faces.size(); ++f) {
      if (other != record_.others.end() && other->face == f) {
        if (f == record_.face) in.fail("lists its own face");
        Reader division(other->division.data(), other->division.size(), "one sheet, " + name());
        read_division(
            division, Piece::face(), kTriangleDepth, 56,
            [&](const Piece& piece, unsigned byte) { apart(division, f, piece, byte >> 3 & 7); });
        division.finish();
        ++other;
      } else if (f != record_.face) {
        apart_at_once(f);
      }
    }
    if (other != record_.others.end()) in.fail("faces are unknown or out of order");
  }

 private:
  std::string name() const { return "face " + std::to_string(record_.face); }
  template <class T = Model>
  Foot<T> foot(Index face, const Piece& piece) const {
    return problem_.surface.foot(problem_.fibre<T>(face, piece, outcomes_[face].c),
                                 piece.is_point() ? 6 : 0);
  }

  void find_point() {
    const double unit = 1 / 1048576.0;
    const auto y =
        foot<Ball>(record_.face, Piece::point({349525 * unit, 349525 * unit, 349526 * unit}));
    for (Index k = 0; k < 3; ++k) {
      y_[k] = range_of(y.x[k]);
      const auto& box = problem_.certificate.box;
      require(y_[k].inside(box[2 * k], box[2 * k + 1]), "one sheet: the point lies in the box");
    }
    const auto corner = [&](Index i) {
      const auto& x = problem_.certificate.vertices[problem_.certificate.faces[record_.face][i]];
      return std::array<double, 3>{x[0], x[1], x[2]};
    };
    const auto normal = cross(minus(corner(1), corner(0)), minus(corner(2), corner(0)));
    for (Index i = 0; i < 3; ++i) {
      functional_[i][i] = 1;
      functional_[i + 3] = cross(minus(corner((i + 1) % 3), corner(i)), normal);
    }
  }

  void injective_on(const Piece& piece) const {
    const Scope scope(1);
    const Index face = record_.face;
    const auto fibre = problem_.fibre<Model>(face, piece, outcomes_[face].c);
    const auto foot = problem_.surface.foot(fibre, 0);
    const Frame axes = frame_of(problem_.certificate.records[face].frame);
    const Jet3<Model> f = problem_.surface.expand(foot.x, axes, 1);
    const Vector<Model> gradient = {f[1], f[2], f[3]}, along = in_frame(axes, fibre.along);
    const Model q = inverse(dot(gradient, along));
    std::array<Vector<Model>, 2> image;
    for (Index j = 0; j < 2; ++j) {
      const Vector<Model> d = in_frame(axes, problem_.chord(face, 0, j + 1, foot.s));
      image[j] = moved(d, -(dot(gradient, d) * q), along);
    }
    const auto m = [&](Index i, Index j) {
      return Model(record_.matrix[2 * i]) * image[j][0] +
             Model(record_.matrix[2 * i + 1]) * image[j][1];
    };
    const Model m11 = m(0, 0), m22 = m(1, 1), off = m(0, 1) + m(1, 0);
    require(m11.sign() > 0 && (scaled(m11 * m22, 4) - off * off).sign() > 0,
            "one sheet: the projection is injective");
  }

  bool has_zero(const Foot<Model>& foot, Index functional) const {
    Model value;
    for (Index k = 0; k < 3; ++k)
      value += Model(functional_[functional][k]) * (foot.x[k] - Model(y_[k].ball()));
    return value.sign() == 0;
  }
  void apart(const Reader& in, Index face, const Piece& piece, Index functional) const {
    if (functional >= kFunctionals) in.fail("an unknown functional");
    shown<Piece>(piece, kFurther, [&](const Piece& p) {
      require(!has_zero(foot(face, p), functional), "one sheet: a face is apart from the point");
    });
  }
  void apart_at_once(Index face) const {
    for (Index k = 0; k < 3; ++k)
      if (disjoint((*outcomes_[face].image)[k], y_[k])) return;
    shown<Piece>(Piece::face(), kFurther, [&](const Piece& p) {
      const Scope scope;
      context.order = outcomes_[face].order;
      const auto at = foot(face, p);
      require(!has_zero(at, 0) || !has_zero(at, 1) || !has_zero(at, 2),
              "one sheet: a face that is not listed is apart from the point");
    });
  }

  const Problem& problem_;
  const std::vector<FaceOutcome>& outcomes_;
  const SheetRecord& record_;
  std::array<Interval, 3> y_;
  std::array<std::array<double, 3>, kFunctionals> functional_{};
};

}  // namespace

void check_sheets(const Problem& problem, const std::vector<FaceOutcome>& outcomes) {
  const Certificate& c = problem.certificate;
  std::set<Index> components;
  for (Index i = 0; i < c.sheets.size(); ++i) {
    const Index face = c.sheets[i].face;
    if (face >= c.faces.size() || (i > 0 && face <= c.sheets[i - 1].face) ||
        !components.insert(problem.complex.component_of[face]).second)
      throw Rejected("one sheet: the components' faces are unknown or out of order");
  }
  in_parallel(c.sheets.size(),
              [&](Index i) { SheetProof(problem, outcomes, c.sheets[i]).check(); });
}

}  // namespace crest::recheck
