// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_splines/reference_volume.hpp"

#include <bit>

namespace crest::tests {

namespace {

/// Rows of the inverse of the matrix whose columns are A, B, D.
std::array<Exact3, 3> inverse_rows(const std::array<Int3, 4>& v) {
  const auto minor = [&](std::size_t i, std::size_t r, std::size_t k) {
    const Int3 &a = v[1 + (i + 1) % 3], &b = v[1 + (i + 2) % 3];
    return a[r] * b[k] - a[k] * b[r];
  };
  std::array<Exact3, 3> rows;
  const int det = v[1][0] * minor(0, 1, 2) + v[1][1] * minor(0, 2, 0) + v[1][2] * minor(0, 0, 1);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 3; ++d)
      rows[i][d] = Rational(minor(i, (d + 1) % 3, (d + 2) % 3)) / det;
  return rows;
}

}  // namespace

const std::array<ReferenceTet, 24>& reference_tets() {
  static const auto all = [] {
    std::array<ReferenceTet, 24> tets{};
    std::size_t i = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (const int side : {-1, 1})
        for (std::size_t m = 0; m < 3; ++m) {
          if (m == a) continue;
          for (const int outer : {-1, 1}) {
            Int3 d{};
            d[a] = side;
            Int3 low = d;
            low[m] = outer;
            Int3 high = low;
            low[3 - a - m] = -1;
            high[3 - a - m] = 1;
            tets[i].vertices = {{{0, 0, 0}, low, high, d}};
            tets[i].rows = inverse_rows(tets[i].vertices);
            ++i;
          }
        }
    return tets;
  }();
  return all;
}

std::array<Rational, 4> ReferenceTet::barycentrics(const Exact3& d) const {
  std::array<Rational, 4> l;
  l[0] = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    l[i + 1] = rows[i][0] * d[0] + rows[i][1] * d[1] + rows[i][2] * d[2];
    l[0] -= l[i + 1];
  }
  return l;
}

Rational ReferenceSpline::sample(Int3 node) const {
  for (std::size_t d = 0; d < 3; ++d) {
    const int last = static_cast<int>(volume_.nodes[d]) - 1;
    if (node[d] >= 0 && node[d] <= last) continue;
    Int3 one = node, two = node;
    one[d] = node[d] < 0 ? 0 : last;
    two[d] = node[d] < 0 ? 1 : last - 1;
    return 2 * sample(one) - sample(two);
  }
  const std::size_t i = static_cast<std::size_t>(
      node[0] + static_cast<int>(volume_.nodes[0]) *
                    (node[1] + static_cast<int>(volume_.nodes[1]) * node[2]));
  if (volume_.type == 0) return static_cast<std::int8_t>(volume_.samples[i]);
  double x;
  std::memcpy(&x, volume_.samples.data() + 8 * i, 8);
  return x;
}

/// (8.1)
Rational ReferenceSpline::edge(const Int3& cube, const Int3& p) const {
  std::array<std::size_t, 2> across{};
  for (std::size_t d = 0, k = 0; d < 3; ++d)
    if (p[d] != 0) across[k++] = d;
  const int first = volume_.extended ? 0 : 1;
  Rational sum = 0;
  for (int i = 0; i < 4; ++i) {
    Int3 node = cube;
    for (int& x : node) x += first;
    node[across[0]] += i % 2 * p[across[0]] / 2;
    node[across[1]] += i / 2 * p[across[1]] / 2;
    sum += sample(node);
  }
  return sum / 4;
}

Rational ReferenceSpline::coefficient(const Int3& cube, const Int3& p) const {
  const auto [at, is_new] = known_.try_emplace({cube, p});
  if (is_new) at->second = average(cube, p);
  return at->second;
}

Rational ReferenceSpline::average(const Int3& cube, const Int3& p) const {
  int ones = 0, twos = 0;
  std::size_t two = 0, zero = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    ones += std::abs(p[d]) == 1;
    twos += std::abs(p[d]) == 2;
    if (std::abs(p[d]) == 2) two = d;
    if (p[d] == 0) zero = d;
  }
  const auto with = [&](std::size_t d, int value) {
    Int3 q = p;
    q[d] = value;
    return q;
  };
  if (twos == 2) return edge(cube, with(zero, 0));
  if (twos == 3) {  // (8.2)
    Int3 next = cube;
    next[0] += p[0] / 2;
    return (edge(cube, with(0, 0)) + edge(next, with(0, 0))) / 2;
  }
  const std::size_t b = (two + 1) % 3, c = (two + 2) % 3;
  if (twos == 1 && ones == 2) {  // (8.3)
    Int3 first = with(b, 0), second = with(c, 0);
    first[c] *= 2;
    second[b] *= 2;
    return (edge(cube, first) + edge(cube, second)) / 2;
  }
  const auto other = [&](const Int3& q) { return coefficient(cube, q); };
  if (twos == 1) {
    Int3 first = p, second = p;
    first[b] = first[c] = 1;
    second[b] = second[c] = -1;
    return (other(first) + other(second)) / 2;
  }
  if (ones == 3)  // (8.4)
    return other({2 * p[0], p[1], p[2]}) + other({p[0], 2 * p[1], p[2]}) -
           (other({2 * p[0], 2 * p[1], 2 * p[2]}) + other({2 * p[0], 2 * p[1], 0})) / 2;
  Rational corners = 0, faces = 0;
  for (int i = 0; i < 8; ++i) {
    const Int3 q = {i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1};
    bool beside = true;
    for (std::size_t d = 0; d < 3; ++d) beside = beside && (p[d] == 0 || p[d] == q[d]);
    if (beside) corners += other(q);
  }
  if (ones == 1) return corners / 4;
  for (const Int3& q : {Int3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
    faces += other(q);
  return faces / 3 - corners / 8;  // (8.5)
}

const std::array<std::array<Rational, 4>, 4>& ReferenceSpline::form(const Int3& cube,
                                                                    std::size_t tet) const {
  const auto [at, is_new] = forms_.try_emplace({cube, tet});
  const auto& v = reference_tets()[tet].vertices;
  for (std::size_t i = 0; is_new && i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      at->second[i][j] =
          coefficient(cube, {v[i][0] + v[j][0], v[i][1] + v[j][1], v[i][2] + v[j][2]});
  return at->second;
}

Rational ReferenceSpline::polynomial(const Int3& cube, std::size_t tet, const Exact3& x) const {
  Exact3 d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = x[k] - (2 * cube[k] + 1);
  const auto l = reference_tets()[tet].barycentrics(d);
  const auto& a = form(cube, tet);
  Rational sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    Rational row = 0;
    for (std::size_t j = 0; j < 4; ++j) row += l[j] * a[i][j];
    sum += l[i] * row;
  }
  return sum;
}

SplineVolume sampled_volume(const std::array<std::uint32_t, 3>& nodes, double level,
                            const std::function<double(double, double, double)>& f, bool extended) {
  SplineVolume volume;
  volume.type = 9;
  volume.nodes = nodes;
  volume.level = level;
  volume.extended = extended;
  for (std::uint32_t k = 0; k < nodes[2]; ++k)
    for (std::uint32_t j = 0; j < nodes[1]; ++j)
      for (std::uint32_t i = 0; i < nodes[0]; ++i) {
        const double x = f(i, j, k) + 0.0;
        const std::size_t at = volume.samples.size();
        volume.samples.resize(at + 8);
        std::memcpy(volume.samples.data() + at, &x, 8);
      }
  return volume;
}

double least_double(double low, double high, const std::function<bool(double)>& holds) {
  auto a = std::bit_cast<std::uint64_t>(low), b = std::bit_cast<std::uint64_t>(high);
  while (a < b) {
    const std::uint64_t middle = a + (b - a) / 2;
    if (holds(std::bit_cast<double>(middle)))
      b = middle;
    else
      a = middle + 1;
  }
  return std::bit_cast<double>(b);
}

}  // namespace crest::tests
