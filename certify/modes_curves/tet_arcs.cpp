// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/tet_arcs.hpp"

#include <algorithm>
#include <numeric>

#include "certify/container/reject.hpp"

namespace crest::certify::curves {
namespace {

using Direction = Triple<Range>;

Range exactly(const Integer& x) {
  return {Rational(x), Rational(x)};
}
Direction exactly(const Triple<Integer>& v) {
  return {exactly(v[0]), exactly(v[1]), exactly(v[2])};
}
Direction times(const Matrix<Integer>& m, const Direction& v) {
  Direction w;
  for (unsigned i = 0; i < 3; ++i)
    w[i] = exactly(m[i][0]) * v[0] + exactly(m[i][1]) * v[1] + exactly(m[i][2]) * v[2];
  return w;
}
Range dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Direction turned(const Direction& v) {
  const Range zero = {0, 0};
  return {zero - v[0], zero - v[1], zero - v[2]};
}

/// A vector inside the conic v . m v = 0: those around the axis of the eigenvalue that has another
/// sign than the others, to 45 degrees at least, as the trace is 0.
Triple<Integer> inside(const Matrix<Integer>& m, int sign) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Triple<Integer> c = {x, y, z};
        Integer sum = 0;
        for (unsigned i = 0; i < 3; ++i)
          for (unsigned j = 0; j < 3; ++j) sum += c[i] * m[i][j] * c[j];
        if ((sum > 0) - (sum < 0) == sign) return c;
      }
  throw std::logic_error("no vector inside the conic");
}

/// The points in their order around a vector inside the conic.
class Order {
 public:
  Order(const Matrix<Integer>& conic, std::vector<TetPoint>& points)
      : conic_(conic), points_(points) {
    const Integer det = determinant(conic);
    sign_ = det > 0 ? 1 : -1;
    centre_ = exactly(inside(conic, sign_));
  }

  /// Ascending from point 0 on.
  std::vector<std::size_t> sorted() {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin() + 1, order.end(),
              [&](std::size_t a, std::size_t b) { return a != b && orientation(a, b) > 0; });
    return order;
  }

  /// Whether the form rises from 0 at point 0 where the order goes on.
  int rise(const Matrix<Integer>& form) {
    return certain([&] {
      const Direction v = direction(0);
      Direction w = cross(times(conic_, v), v);
      const int turn = dot(centre_, cross(v, w)).sign();
      if (turn < 0) w = turned(w);
      return turn == 0 ? 0 : dot(v, times(form, w)).sign();
    });
  }

 private:
  int orientation(std::size_t a, std::size_t b) {
    return certain([&] { return dot(direction(0), cross(direction(a), direction(b))).sign(); });
  }

  /// Scaled so that it is on the centre's side of the centre's polar.
  Direction direction(std::size_t i) {
    Direction v = points_[i].point.direction();
    const int side = certain_side(i, v);
    return side * sign_ < 0 ? turned(v) : v;
  }
  int certain_side(std::size_t i, Direction& v) {
    for (int k = 0; k < kMost; ++k) {
      if (const int side = dot(times(conic_, centre_), v).sign(); side != 0) return side;
      points_[i].point.refine();
      v = points_[i].point.direction();
    }
    throw Undecided("conic: a point that cannot be enclosed");
  }

  template <class Sign>
  int certain(const Sign& sign) {
    for (int k = 0; k < kMost; ++k) {
      if (const int found = sign(); found != 0) return found;
      for (TetPoint& point : points_) point.point.refine();
    }
    throw Undecided("conic: points that cannot be told apart");
  }

  static constexpr int kMost = 200;
  const Matrix<Integer>& conic_;
  std::vector<TetPoint>& points_;
  int sign_;
  Direction centre_;
};

/// A column of the adjugate: what a matrix of rank 2 sends to 0.
Triple<Integer> kernel_of(const Matrix<Integer>& m) {
  Triple<Integer> v{};
  for (unsigned i = 0; i < 3; ++i) {
    const auto &p = m[(i + 1) % 3], &q = m[(i + 2) % 3];
    v = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    if (v != Triple<Integer>{}) break;
  }
  return v;
}
Integer form(const Matrix<Integer>& m, const Triple<Integer>& v) {
  Integer sum = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) sum += v[i] * m[i][j] * v[j];
  return sum;
}

/// Points on two lines that meet in a vector outside the tetrahedron.
class LinePair {
 public:
  LinePair(const Triple<Integer>& centre, std::vector<TetPoint>& points)
      : centre_(exactly(centre)), points_(points) {}

  /// On each line, from the centre on, every second part is inside.
  std::vector<std::array<std::size_t, 2>> arcs() {
    std::vector<std::size_t> first = {0}, second;
    for (std::size_t i = 1; i < points_.size(); ++i)
      (same_line(0, i) ? first : second).push_back(i);
    std::vector<std::array<std::size_t, 2>> list;
    for (auto* line : {&first, &second}) {
      require(line->size() % 2 == 0, "pair of lines: an odd number of points on one");
      if (line->empty()) continue;
      const std::size_t of = line->front();  // one, while the sort moves them
      std::ranges::sort(
          *line, [&](std::size_t a, std::size_t b) { return a != b && order(of, a, b) > 0; });
      for (std::size_t i = 0; i < line->size(); i += 2)
        list.push_back({(*line)[i], (*line)[i + 1]});
    }
    return list;
  }

 private:
  Direction direction(std::size_t i) { return points_[i].point.direction(); }
  Direction normal(std::size_t i) { return cross(centre_, direction(i)); }

  /// The lines are across each other: normals are parallel, or at right angles.
  bool same_line(std::size_t a, std::size_t b) {
    return certain([&] {
             if (dot(normal(a), normal(b)).sign() != 0) return 1;
             return dot(centre_, cross(direction(a), direction(b))).sign() != 0 ? -1 : 0;
           }) > 0;
  }
  /// Of a and b by their angles from the centre, turned as to `of`, a point of the line.
  int order(std::size_t of, std::size_t a, std::size_t b) {
    return certain([&] {
      const Direction n = normal(of), across = cross(n, centre_), v = direction(a),
                      w = direction(b);
      return dot(across, v).sign() * dot(across, w).sign() * dot(n, cross(v, w)).sign();
    });
  }
  template <class Sign>
  int certain(const Sign& sign) {
    for (int k = 0; k < 200; ++k) {
      if (const int found = sign(); found != 0) return found;
      for (TetPoint& point : points_) point.point.refine();
    }
    throw Undecided("pair of lines: points that cannot be told apart");
  }

  Direction centre_;
  std::vector<TetPoint>& points_;
};

/// Nothing if the lines meet in the closed tetrahedron, or the weights there do not tell.
std::optional<std::vector<std::array<std::size_t, 2>>> arcs_on_lines(
    const Matrix<Integer>& conic, const std::vector<Matrix<Integer>>& dual,
    std::vector<TetPoint>& points) {
  const auto centre = kernel_of(conic);
  bool plus = false, minus = false;
  for (const auto& b : dual) {
    const Integer weight = form(b, centre);
    plus |= weight > 0, minus |= weight < 0;
  }
  if (!plus || !minus) return std::nullopt;
  return LinePair(centre, points).arcs();
}

}  // namespace

std::optional<std::vector<std::array<std::size_t, 2>>> find_arcs(modes::ExactTensors& exact,
                                                                 const std::array<u32, 4>& corners,
                                                                 std::vector<TetPoint>& points) {
  const auto tensors = matrices(exact, corners);
  const auto rest = complement(tensors);
  if (rest.empty()) return std::nullopt;
  require(points.size() % 2 == 0, "tetrahedron ({}, {}, {}, {}): an odd number of points",
          corners[0], corners[1], corners[2], corners[3]);
  if (points.empty()) return std::vector<std::array<std::size_t, 2>>();
  const auto dual = dual_basis(tensors);
  if (determinant(rest[0]) == 0) return arcs_on_lines(rest[0], dual, points);
  if (points.size() == 2) return std::vector<std::array<std::size_t, 2>>{{0, 1}};
  Order order(rest[0], points);
  const auto sorted = order.sorted();
  const bool ahead = order.rise(dual[points[0].opposite]) == points[0].point.type;
  std::vector<std::array<std::size_t, 2>> arcs;
  for (std::size_t i = 0; i < sorted.size(); i += 2) {
    const std::size_t first = ahead ? i : i + 1;
    arcs.push_back({sorted[first], sorted[(first + 1) % sorted.size()]});
  }
  return arcs;
}

}  // namespace crest::certify::curves
