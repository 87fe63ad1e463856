// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_splines/reference_cubic.hpp"

#include <algorithm>
#include <cmath>

namespace crest::tests {
namespace {

using certify::SplineCubicData;

Exact3 exact(const Int3& x) {
  return {x[0], x[1], x[2]};
}
int odd_count(const Letter& a) {
  return (a[0] & 1) + (a[1] & 1) + (a[2] & 1);
}
std::size_t vertex_number(const SplineCubicData& data, const Letter& at) {
  const std::size_t i = static_cast<std::size_t>(at[0] / 2),
                    j = static_cast<std::size_t>(at[1] / 2),
                    k = static_cast<std::size_t>(at[2] / 2);
  return i + (data.cubes[0] + 1) * (j + (data.cubes[1] + 1) * k);
}
std::size_t cube_number(const SplineCubicData& data, const Int3& at) {
  return static_cast<std::size_t>(at[0] + static_cast<int>(data.cubes[0]) *
                                              (at[1] + static_cast<int>(data.cubes[1]) * at[2]));
}
std::size_t slope_place(std::size_t along, std::size_t across) {
  const std::size_t first = along == 0 ? 1 : 0;
  return 2 * along + (across == first ? 0 : 1);
}
Letter corner_of(const Int3& cube, const Int3& corner) {
  return {2 * cube[0] + 1 + corner[0], 2 * cube[1] + 1 + corner[1], 2 * cube[2] + 1 + corner[2]};
}
std::vector<Int3> corners() {
  std::vector<Int3> all;
  for (int i = 0; i < 8; ++i) all.push_back({i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1});
  return all;
}

}  // namespace

Rational ReferenceCubic::vertex(const Letter& at, std::size_t k) const {
  return data_.vertices[vertex_number(data_, at)][k];
}
Rational ReferenceCubic::slope(const Letter& middle, std::size_t along, std::size_t across) const {
  Letter low = middle;
  low[along] -= 1;
  return data_.slopes[vertex_number(data_, low)][slope_place(along, across)];
}
/// a(AAX)
Rational ReferenceCubic::at_vertex(const Letter& a, const Exact3& x) const {
  Rational sum = vertex(a, 0);
  for (std::size_t d = 0; d < 3; ++d) sum += vertex(a, d + 1) * (x[d] - a[d]) / 2;
  return sum;
}
/// a(ABX): linear along the edge, and the slopes.
Rational ReferenceCubic::at_edge(const Letter& a, const Letter& b, const Exact3& x) const {
  std::size_t along = 0;
  while (a[along] == b[along]) ++along;
  Letter middle = a;
  middle[along] = (a[along] + b[along]) / 2;
  const Rational part = (x[along] - a[along]) / (b[along] - a[along]);
  Rational sum = (1 - part) * at_vertex(a, exact(b)) + part * at_vertex(b, exact(a));
  for (std::size_t d = 0; d < 3; ++d)
    if (d != along) sum += slope(middle, along, d) * (x[d] - a[d]) / 2;
  return sum;
}
Rational ReferenceCubic::at_centre(const Int3& cube, const Exact3& x) const {
  const auto& c = data_.centres[cube_number(data_, cube)];
  Rational sum = c[0];
  for (std::size_t d = 0; d < 3; ++d) sum += Rational(c[d + 1]) * (x[d] - (2 * cube[d] + 1)) / 2;
  return sum;
}

Rational ReferenceCubic::coefficient(const Int3& cube, Word word) const {
  // Vertices first, then face centres, then the centre.
  std::ranges::sort(word, {}, [](const Letter& a) { return odd_count(a); });
  if (odd_count(word[1]) == 3) return at_centre(cube, exact(word[0]));
  if (word[0] == word[1] && odd_count(word[0]) == 0) return at_vertex(word[0], exact(word[2]));
  if (word[1] == word[2] && odd_count(word[1]) == 0) return at_vertex(word[1], exact(word[0]));
  if (odd_count(word[1]) == 0)
    return word[0] == word[2] ? at_vertex(word[0], exact(word[1]))
                              : at_edge(word[0], word[1], exact(word[2]));
  // With a face centre D: means over edges of its face.
  const Letter d = odd_count(word[0]) == 2 ? word[0] : word[1];
  std::size_t normal = 0;
  while (d[normal] % 2 != 0) ++normal;
  const std::size_t b = (normal + 1) % 3, c = (normal + 2) % 3;
  const auto place = [&](int i, int j) {
    Letter x = d;
    x[b] += i;
    x[c] += j;
    return x;
  };
  if (odd_count(word[0]) == 0) {
    const Letter& a = word[0];
    Letter first = a, second = a;
    first[b] = 2 * d[b] - a[b];
    second[c] = 2 * d[c] - a[c];
    const Exact3 x = exact(word[2]);
    return (at_edge(a, first, x) + at_edge(a, second, x)) / 2;
  }
  const Exact3 x = exact(word[2]);
  Rational sum = 0;
  for (const int i : {-1, 1}) {
    sum += at_edge(place(i, -1), place(i, 1), x);
    sum += at_edge(place(-1, i), place(1, i), x);
  }
  return sum / 4;
}

Rational ReferenceCubic::target(const Int3& cube, const Int3& corner) const {
  const Letter a = corner_of(cube, corner), c = corner_of(cube, {0, 0, 0});
  Rational sum = -coefficient(cube, {a, a, c});
  for (std::size_t d = 0; d < 3; ++d) {
    Letter b = a;
    b[d] -= 2 * corner[d];
    sum += coefficient(cube, {a, b, c});
  }
  return sum / 2;
}
Rational ReferenceCubic::residual(const Int3& cube, const Int3& corner) const {
  return at_centre(cube, exact(corner_of(cube, corner))) - target(cube, corner);
}

Rational ReferenceCubic::polynomial(const Int3& cube, std::size_t tet, const Exact3& x) const {
  const auto [at, is_new] = forms_.try_emplace({cube, tet});
  std::vector<Rational>& a = at->second;
  if (is_new) {
    std::array<Letter, 4> v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = corner_of(cube, reference_tets()[tet].vertices[i]);
    for (std::size_t i = 0; i < 64; ++i)
      a.push_back(coefficient(cube, {v[i / 16], v[i / 4 % 4], v[i % 4]}));
  }
  Exact3 d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = x[k] - (2 * cube[k] + 1);
  const auto l = reference_tets()[tet].barycentrics(d);
  // De Casteljau's steps without the sharing of equal words.
  std::vector<Rational> step = a;
  while (step.size() > 1) {
    std::vector<Rational> next;
    for (std::size_t i = 0; i < step.size(); i += 4)
      next.push_back(l[0] * step[i] + l[1] * step[i + 1] + l[2] * step[i + 2] + l[3] * step[i + 3]);
    step = next;
  }
  return step[0];
}

Rational ReferenceCubic::value(const std::array<double, 3>& world) const {
  Exact3 x;
  for (std::size_t d = 0; d < 3; ++d)
    x[d] = (Rational(world[d]) - Rational(data_.box[2 * d])) * 2 * data_.cubes[d] /
           (Rational(data_.box[2 * d + 1]) - Rational(data_.box[2 * d]));
  for (const Int3& cube : domain_cubes(data_)) {
    Exact3 from_centre;
    for (std::size_t d = 0; d < 3; ++d) from_centre[d] = x[d] - (2 * cube[d] + 1);
    for (std::size_t tet = 0; tet < 24; ++tet) {
      const auto l = reference_tets()[tet].barycentrics(from_centre);
      if (std::ranges::all_of(l, [](const Rational& b) { return b >= 0; }))
        return polynomial(cube, tet, x);
    }
  }
  throw std::logic_error("a point outside the domain");
}

std::vector<Int3> domain_cubes(const SplineCubicData& data) {
  std::vector<Int3> cubes;
  const int nx = static_cast<int>(data.cubes[0]), ny = static_cast<int>(data.cubes[1]);
  for (const auto& run : data.domain)
    for (std::uint32_t i = 0; i < run.length; ++i) {
      const int cube = static_cast<int>(run.first + i);
      cubes.push_back({cube % nx, cube / nx % ny, cube / nx / ny});
    }
  return cubes;
}

namespace {

/// The last corner, or the last edge, of each cube takes what is left over, cube by cube.
void march(SplineCubicData& data) {
  const ReferenceCubic spline(data);
  for (const Int3& cube : domain_cubes(data)) {
    const Letter c = corner_of(cube, {0, 0, 0}), last = corner_of(cube, {1, 1, 1});
    Rational sum = 0;  // (V)
    for (const Int3& s : corners()) {
      const Letter a = corner_of(cube, s);
      sum += s[0] * s[1] * s[2] * spline.coefficient(cube, {a, a, c});
    }
    data.vertices[vertex_number(data, last)][0] -= static_cast<double>(sum);
  }
  for (std::size_t a = 0; a < 3; ++a)  // (E_a)
    for (const Int3& cube : domain_cubes(data)) {
      const std::size_t b = a == 0 ? 1 : 0, c = 3 - a - b;
      Rational sum = 0;
      for (const Int3& s : corners()) sum += s[b] * s[c] * spline.target(cube, s);
      // Both ends of the edge at the upper sides have t_b with weight -1/2 in the sum of targets
      // / 2.
      Int3 low = {1, 1, 1};
      low[a] = -1;
      const Letter at = corner_of(cube, low);
      data.slopes[vertex_number(data, at)][slope_place(a, b)] += static_cast<double>(2 * sum);
    }
  for (const Int3& cube : domain_cubes(data)) {
    auto& centre = data.centres[cube_number(data, cube)];
    std::array<Rational, 4> sums;
    sums.fill(0);
    for (const Int3& s : corners()) {
      const Rational target = spline.target(cube, s);
      sums[0] += target / 8;
      for (std::size_t d = 0; d < 3; ++d) sums[d + 1] += s[d] * target / 4;
    }
    for (std::size_t k = 0; k < 4; ++k) centre[k] = static_cast<double>(sums[k]);
  }
}

double uniform(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace

certify::SplineCubicCertificate random_cubic(const std::array<std::uint32_t, 3>& cubes,
                                             bool doubles, Random& random) {
  certify::SplineCubicCertificate c;
  SplineCubicData& data = c.data;
  data.box = {-1, 2, 0.3, 1.7, 5, 5.5};
  data.cubes = cubes;
  const std::uint32_t all = cubes[0] * cubes[1] * cubes[2];
  data.domain = {{0, all}};
  data.integers = !doubles;
  data.exponent = doubles ? 0 : -40;
  const double u = std::ldexp(1.0, data.exponent);
  const auto number = [&](double unit) {
    return doubles ? uniform(random) - 0.5
                   : unit * (static_cast<double>(random() % 2000001) - 1000000);
  };
  for (std::uint32_t k = 0; k <= cubes[2]; ++k)
    for (std::uint32_t j = 0; j <= cubes[1]; ++j)
      for (std::uint32_t i = 0; i <= cubes[0]; ++i) {
        data.vertices.push_back({number(u), number(2 * u), number(2 * u), number(2 * u)});
        std::array<double, 6> slopes{};
        const std::array<std::uint32_t, 3> at = {i, j, k};
        for (std::size_t d = 0; d < 3; ++d)
          if (at[d] < cubes[d])
            for (std::size_t m = 0; m < 2; ++m) slopes[2 * d + m] = number(u);
        data.slopes.push_back(slopes);
      }
  data.centres.resize(all);
  for (auto& centre : data.centres)
    for (double& x : centre) x = doubles ? number(0) : 0;
  if (!doubles) march(data);
  const ReferenceCubic spline(data);
  for (int i = 0; i < 24; ++i) {
    std::array<double, 3> x;
    for (std::size_t d = 0; d < 3; ++d) {
      // Some on planes between cubes, some on the box's sides.
      const double part = i % 3 == 0 ? static_cast<double>(random() % 5) / 4 : uniform(random);
      x[d] = std::min(data.box[2 * d] + part * (data.box[2 * d + 1] - data.box[2 * d]),
                      data.box[2 * d + 1]);
    }
    const auto value = static_cast<double>(spline.value(x));
    data.samples.push_back({x[0], x[1], x[2], value + (i % 2 == 0 ? 0 : 1e-3 * uniform(random))});
  }
  data.outside = 7;
  c.jump = least_jump(data);
  c.error = least_error(data);
  return c;
}

double least_jump(const SplineCubicData& data) {
  const ReferenceCubic spline(data);
  Rational most = 0, slope = 0;
  for (const Int3& cube : domain_cubes(data))
    for (const Int3& corner : corners()) {
      const Rational r = spline.residual(cube, corner);
      most = std::max(most, Rational(r * r));
    }
  for (std::size_t a = 0; a < 3; ++a) {
    Rational sum = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const Rational h =
          (Rational(data.box[2 * d + 1]) - Rational(data.box[2 * d])) / data.cubes[d];
      if (d != a) sum += 1 / (h * h);
    }
    slope = std::max(slope, sum);
  }
  const Rational square = 9 * most * slope;
  return least_double(0, 1e300, [&](double j) { return Rational(j) * Rational(j) >= square; });
}

double least_error(const SplineCubicData& data) {
  const ReferenceCubic spline(data);
  Rational most = 0;
  for (const auto& sample : data.samples) {
    const Rational e = spline.value({sample[0], sample[1], sample[2]}) - Rational(sample[3]);
    most = std::max(most, Rational(abs(e)));
  }
  return least_double(0, 1e300, [&](double e) { return Rational(e) >= most; });
}

}  // namespace crest::tests
