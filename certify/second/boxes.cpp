// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/boxes.hpp"

namespace crest::recheck {
namespace {

constexpr int kTreeDepth = 80, kBoxDepth = 16, kFurtherHalves = 6;
constexpr std::array<double, 3> kA = {8, -5, 2}, kB = {3, 7, -9};
constexpr Index kChunk = 64;

using Bounds = std::array<double, 6>;

Box middle_of(const Box& box) {
  Box c;
  for (Index i = 0; i < 3; ++i) c.side[i] = box.side[i].middle();
  return c;
}

Interval slope_of(const Surface& surface, const Box& box, const std::array<double, 3>& d) {
  const Scope scope(1);
  std::vector<Jet<Interval, 1>> x;
  for (Index i = 0; i < 3; ++i) x.emplace_back(box.side[i], std::array<Interval, 1>{d[i]});
  return surface.f().evaluate(x)[1];
}

Jet<Interval, 3> jet_of(const Surface& surface, const Box& box, int degree) {
  const Scope scope(degree);
  std::vector<Jet<Interval, 3>> x;
  for (Index i = 0; i < 3; ++i) {
    std::array<Interval, 3> slopes;
    slopes[i] = Interval(1.0);
    x.emplace_back(box.side[i], slopes);
  }
  return surface.f().evaluate(x);
}

struct Cell {
  Bounds bounds;
  int code;
  std::uint32_t graph_box;
};

class TreeReader {
 public:
  explicit TreeReader(const Certificate& c)
      : certificate_(c), in_(c.tree.data(), c.tree.size(), "tree") {
    read(c.box, 0);
    in_.finish();
  }
  std::vector<Cell> cells;

 private:
  void read(const Bounds& b, int depth) {
    const unsigned code = in_.u8();
    if (code > 6) in_.fail("an unknown code");
    if (code < 3) {
      if (depth == kTreeDepth) in_.fail("is deeper than 80");
      const Index lower = 2 * code, upper = lower + 1;
      const double m = (b[lower] + b[upper]) / 2;
      if (!(b[lower] <= m && m <= b[upper])) in_.fail("a cell cannot be split");
      Bounds first = b, second = b;
      first[upper] = second[lower] = m;
      read(first, depth + 1);
      read(second, depth + 1);
      return;
    }
    Cell cell = {b, static_cast<int>(code), code == 6 ? in_.u32() : 0};
    for (Index i = 0; i < 6; ++i)
      if (code != 3 && b[i] == certificate_.box[i])
        in_.fail("a cell at the box's boundary has code " + std::to_string(code));
    if (code == 6) in_graph_box(cell);
    cells.push_back(cell);
  }
  void in_graph_box(const Cell& cell) const {
    if (cell.graph_box >= certificate_.graph_boxes.size()) in_.fail("an unknown graph box");
    const Bounds& k = certificate_.graph_boxes[cell.graph_box].bounds;
    for (Index i = 0; i < 6; i += 2)
      if (cell.bounds[i] < k[i] || cell.bounds[i + 1] > k[i + 1])
        in_.fail("a cell is not in its graph box");
  }

  const Certificate& certificate_;
  Reader in_;
};

void check_cell(const Surface& surface, const Cell& cell) {
  if (cell.code == 6) return;
  shown<Box>(box_of(cell.bounds), kFurtherHalves, [&](const Box& b) {
    const int sign =
        cell.code == 3 ? value_sign(surface, b) : slope_sign(surface, b, cell.code == 4 ? kA : kB);
    require(sign != 0, "completeness: a cell of the tree");
  });
}

void check_graph_box(const Problem& problem, const GraphBox& k,
                     const std::vector<FaceOutcome>& outcomes, Index face) {
  const Surface& surface = problem.surface;
  const auto axis = static_cast<Index>(k.axis);
  const Box box = box_of(k.bounds);
  Box lower = box, upper = box;
  lower.side[axis] = Interval(k.bounds[2 * axis]);
  upper.side[axis] = Interval(k.bounds[2 * axis + 1]);
  std::array<double, 3> d{};
  d[axis] = 1;
  Reader in(k.witness.data(), k.witness.size(), "graph box");
  const auto value = [&](const Box& b) { return value_sign(surface, b); };
  const int below = divided_sign(in, lower, value), above = divided_sign(in, upper, value);
  divided_sign(in, box, [&](const Box& b) { return slope_sign(surface, b, d); });
  in.finish();
  if (below == above) throw Rejected("graph box: F has one sign on both sides");
  Index corner = 0;
  while (problem.certificate.faces[face][corner] != k.vertex) ++corner;
  const auto foot = surface.foot(
      problem.fibre<Ball>(face, Piece::point(unit_corner(corner)), outcomes[face].c), 4);
  for (Index i = 0; i < 3; ++i)
    require(range_of(foot.x[i]).inside(k.bounds[2 * i], k.bounds[2 * i + 1]),
            "graph box: its vertex lies in it");
}

}  // namespace

std::array<Box, 2> Box::halves(Index axis) const {
  std::array<Box, 2> h = {*this, *this};
  const double m = side[axis].middle();
  h[0].side[axis] = {side[axis].lower(), m};
  h[1].side[axis] = {m, side[axis].upper()};
  return h;
}
std::vector<Box> Box::children() const {
  Index widest = 0;
  const auto width = [&](Index i) { return side[i].upper() - side[i].lower(); };
  for (Index i = 1; i < 3; ++i)
    if (width(widest) < width(i)) widest = i;
  const auto h = halves(widest);
  return {h[0], h[1]};
}
Box box_of(const Bounds& b) {
  Box box;
  for (Index i = 0; i < 3; ++i) {
    if (b[2 * i] > b[2 * i + 1]) throw Rejected("a box is empty");
    box.side[i] = {b[2 * i], b[2 * i + 1]};
  }
  return box;
}

int value_sign(const Surface& surface, const Box& box) {
  const auto& k = box.side;
  const int sign = surface.f().evaluate<Interval>({k[0], k[1], k[2]}).sign();
  if (sign != 0) return sign;
  try {
    const Box c = middle_of(box);
    const Jet<Interval, 3> f = jet_of(surface, box, 1);
    Interval v = surface.f().evaluate<Interval>({c.side[0], c.side[1], c.side[2]});
    for (Index i = 0; i < 3; ++i) v.add_product(f[i + 1], k[i] - c.side[i]);
    return v.sign();
  } catch (const Undefined&) {  // defined, and not regular
    return 0;
  }
}

int slope_sign(const Surface& surface, const Box& box, const std::array<double, 3>& d) {
  const int sign = slope_of(surface, box, d).sign();
  if (sign != 0) return sign;
  const Box c = middle_of(box);
  const Jet<Interval, 3> f = jet_of(surface, box, 2);
  const auto& three = Monomials<3>::get();
  Interval v = slope_of(surface, c, d);
  for (Index i = 0; i < 3; ++i) {
    Interval second;
    for (Index j = 0; j < 3; ++j)
      second.add_product(Interval(i == j ? 2 * d[j] : d[j]), f[three.product[i + 1][j + 1]]);
    v.add_product(second, box.side[i] - c.side[i]);
  }
  return v.sign();
}

namespace {

int divided_sign_at(Reader& in, const Box& box, const std::function<int(const Box&)>& sign,
                    int depth) {
  const unsigned code = in.u8();
  if (code > 3) in.fail("a division of a box has an unknown code");
  if (code < 3) {
    if (depth == kBoxDepth) in.fail("a division of a box is deeper than 16");
    const auto h = box.halves(code);
    const int first = divided_sign_at(in, h[0], sign, depth + 1);
    if (divided_sign_at(in, h[1], sign, depth + 1) != first) in.fail("a box has two signs");
    return first;
  }
  int common = 0;
  shown<Box>(box, kFurtherHalves, [&](const Box& b) {
    const int found = sign(b);
    require(found != 0 && found != -common, "a box: one sign");
    common = found;
  });
  return common;
}

}  // namespace

int divided_sign(Reader& in, const Box& box, const std::function<int(const Box&)>& sign) {
  return divided_sign_at(in, box, sign, 0);
}

void check_completeness(const Problem& problem, const std::vector<FaceOutcome>& outcomes) {
  const Certificate& c = problem.certificate;
  const TreeReader tree(c);
  in_parallel((tree.cells.size() + kChunk - 1) / kChunk, [&](Index chunk) {
    for (Index i = chunk * kChunk; i < std::min((chunk + 1) * kChunk, tree.cells.size()); ++i)
      check_cell(problem.surface, tree.cells[i]);
  });
  std::vector<Index> least(c.vertices.size(), Complex::kNone);
  for (Index f = c.faces.size(); f-- > 0;)
    for (const std::uint32_t v : c.faces[f]) least[v] = f;
  in_parallel(c.graph_boxes.size(), [&](Index i) {
    check_graph_box(problem, c.graph_boxes[i], outcomes, least[c.graph_boxes[i].vertex]);
  });
}

}  // namespace crest::recheck
