// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/chart.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace crest::recheck {
namespace {

Barycentric middle(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The affine function with these values at the piece's corners.
template <class T>
T affine(const Piece& piece, const std::array<Ball, 3>& value) {
  if constexpr (std::is_same_v<T, Ball>)
    return value[0];
  else
    return Model::linear(value[0], value[1] - value[0],
                         piece.is_segment() ? Ball() : value[2] - value[0]);
}

/// While it lives, sums and products of balls without radius are exact.
class Exact : public Scope {
 public:
  Exact() { context.precision = ARF_PREC_EXACT; }
};

}  // namespace

std::vector<Piece> Piece::children() const {
  if (is_point()) return {};
  const auto& [a, b, c] = corner;
  if (is_segment()) {
    const Barycentric m = middle(a, b);
    return {segment(a, m), segment(m, b)};
  }
  const Barycentric m01 = middle(a, b), m12 = middle(b, c), m20 = middle(c, a);
  return {{{a, m01, m20}}, {{b, m12, m01}}, {{c, m20, m12}}, {{m12, m20, m01}}};
}
Barycentric unit_corner(Index k) {
  Barycentric l{};
  l[k % 3] = 1;
  return l;
}

int order_of(Reader& in, unsigned byte, unsigned allowed) {
  const int order = 3 + static_cast<int>(byte & 3);
  if (order > 5 || (byte & ~(3 | allowed)) != 0) in.fail("a division has unknown bits");
  return order;
}

Ball Problem::h(int c) const {
  Ball one(1);
  arb_mul_2exp_si(one.get(), one.get(), certificate.k0 - c);
  return one;
}

template <class T>
Fibre<T> Problem::fibre(Index face, const Piece& piece, int c) const {
  Fibre<T> f;
  f.h = h(c);
  for (Index k = 0; k < 6; ++k) {
    std::array<Ball, 3> value;
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 3; ++j)
        value[i].add_product(Ball(piece.corner[i][j]),
                             Ball(certificate.vertices[certificate.faces[face][j]][k]));
    (k < 3 ? f.base[k] : f.along[k - 3]) = affine<T>(piece, value);
  }
  return f;
}
template Fibre<Ball> Problem::fibre(Index, const Piece&, int) const;
template Fibre<Model> Problem::fibre(Index, const Piece&, int) const;

Vector<Model> Problem::chord(Index face, Index i, Index j, const Model& s) const {
  const auto &from = certificate.vertices[certificate.faces[face][i]],
             &to = certificate.vertices[certificate.faces[face][j]];
  Vector<Model> d;
  for (Index k = 0; k < 3; ++k)
    d[k] = Model(Ball(to[k]) - Ball(from[k])) + s * Model(Ball(to[k + 3]) - Ball(from[k + 3]));
  return d;
}

Ball Problem::lifted(Index face, Index corner, std::size_t direction) const {
  const Exact exact;
  const double x = certificate.vertices[certificate.faces[face][corner]][direction];
  return Ball(x) + Ball(certificate.lifts[face] >> (corner + 3 * direction) & 1);
}

template <class T>
std::array<T, 2> Problem::unit(Index face, const Piece& piece) const {
  std::array<T, 2> uv;
  for (std::size_t d = 0; d < 2; ++d) {
    std::array<Ball, 3> value;
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 3; ++j)
        value[i].add_product(Ball(piece.corner[i][j]), lifted(face, j, d));
    uv[d] = affine<T>(piece, value);
  }
  return uv;
}
template std::array<Ball, 2> Problem::unit(Index, const Piece&) const;
template std::array<Model, 2> Problem::unit(Index, const Piece&) const;

namespace {

void check_coordinates(const Certificate& c) {
  for (const auto& x : c.vertices)
    for (std::size_t d = 0; d < 2; ++d)
      if (x[d] < 0 || x[d] > 1 || (c.periodic[d] && x[d] == 1))
        throw Rejected("a vertex is outside the unit square");
  const unsigned allowed = (c.periodic[0] ? 7U : 0U) | (c.periodic[1] ? 56U : 0U);
  for (const unsigned bits : c.lifts)
    if ((bits & ~allowed) != 0) throw Rejected("a lift is in a direction that is not periodic");
}

bool on_one_side(const Certificate& c, Index face, Index side) {
  const auto &a = c.vertices[c.faces[face][side]], &b = c.vertices[c.faces[face][(side + 1) % 3]];
  for (std::size_t d = 0; d < 2; ++d)
    if (!c.periodic[d] && a[d] == b[d] && (a[d] == 0 || a[d] == 1)) return true;
  return false;
}

void check_areas(const Problem& problem) {
  Ball sum;
  for (Index f = 0; f < problem.certificate.faces.size(); ++f) {
    const auto side = [&](Index k, std::size_t d) {
      return problem.lifted(f, k, d) - problem.lifted(f, 0, d);
    };
    const Ball area = side(1, 0) * side(2, 1) - side(2, 0) * side(1, 1);
    if (area.sign() <= 0)
      throw Rejected("face " + std::to_string(f) + ": has no positive area in unit coordinates");
    sum = sum + area;
  }
  // Twice the areas.
  if ((sum - Ball(1)).sign() <= 0 || (Ball(3) - sum).sign() <= 0)
    throw Rejected("the faces' areas do not sum to about 1");
}

}  // namespace

void check_parametric_chart(const Problem& problem) {
  const Certificate& c = problem.certificate;
  const Exact exact;
  check_coordinates(c);
  check_areas(problem);
  for (const Edge& e : problem.complex.edges) {
    if (e.faces == 1) {
      if (!on_one_side(c, e.face[0], e.side[0]))
        throw Rejected("face " + std::to_string(e.face[0]) +
                       ": a boundary edge is not on a side of the square");
      continue;
    }
    for (std::size_t d = 0; d < 2; ++d) {
      const auto along = [&](Index i, Index from, Index to) {
        return problem.lifted(e.face[i], (e.side[i] + to) % 3, d) -
               problem.lifted(e.face[i], (e.side[i] + from) % 3, d);
      };
      if (!(along(0, 0, 1) - along(1, 1, 0)).is_zero())
        throw Rejected("face " + std::to_string(e.face[0]) + ": an edge's lifts differ");
    }
  }
}

void in_parallel(Index n, const std::function<void(Index)>& work) {
  std::atomic<Index> next = 0;
  std::mutex mutex;
  Index failed = n;
  std::exception_ptr problem;
  const auto run = [&] {
    for (Index i = next++; i < n; i = next++) try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        next = n;
        if (i < failed) {
          failed = i;
          problem = std::current_exception();
        }
      }
  };
  std::vector<std::thread> threads;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) threads.emplace_back(run);
  run();
  for (std::thread& t : threads) t.join();
  if (problem) std::rethrow_exception(problem);
}

}  // namespace crest::recheck
