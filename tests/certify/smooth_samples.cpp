// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/smooth_samples.hpp"

#include <algorithm>
#include <cmath>

#include "certify/ridges_smooth/immersion.hpp"
#include "certify/ridges_smooth/mesh.hpp"

namespace crest::tests {

using namespace certify;
using namespace certify::smooth;
using u32 = std::uint32_t;

SmoothSampler::SmoothSampler(RidgesSmoothCertificate& c)
    : c_(c),
      surface_(parse_surface(c.surface)),
      immersion_(kernel::jet_evaluator<double, 2, 5>(std::span(surface_.texts).first<3>())) {
  for (std::size_t k = 0; k < 4; ++k)
    domain_[k] = kernel::double_evaluator(surface_.texts[3 + k])({});
}

SmoothSampler::Forms SmoothSampler::forms_at(const std::array<double, 2>& x) {
  using Jet = kernel::Jet<double, 2, 5>;
  const std::array<Jet, 2> at = {Jet::variable(0, x[0]) * (domain_[1] - domain_[0]) + domain_[0],
                                 Jet::variable(1, x[1]) * (domain_[3] - domain_[2]) + domain_[2]};
  return immersion_forms<2, 5, double>(immersion_.all<3>(at));
}

std::array<double, 2> SmoothSampler::point(u32 face, const Barycentric& l) {
  std::array<double, 2> x{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 2; ++d)
      x[d] += l[i] * (c_.vertices[c_.faces[face][i]][d] + lift_of(c_, face, i, d));
  return x;
}

SmoothSampler::Sample SmoothSampler::sample(u32 face, const Barycentric& l, int w) {
  const Forms f = forms_at(point(face, l));
  const auto a = shape(f);
  const auto d = direction(w);
  Sample s;
  s.s = inner(f.i, d, apply(a, d)).value();
  auto v = principal(a, d);
  for (std::size_t j = 0; j < 2; ++j) {
    s.e[j] = extremality(f, v);
    const auto g = v[0].truncated<1>() * s.e[j].slope(0) + v[1].truncated<1>() * s.e[j].slope(1);
    s.growth[j] = g.value();
    s.turn[j] = s.e[j].d(1, 0) * g.d(0, 1) - s.e[j].d(0, 1) * g.d(1, 0);
    v = turned(f.i, v);
  }
  return s;
}

std::optional<Umbilic> SmoothSampler::newton(u32 face) {
  std::array<double, 2> x = point(face, {1 / 3.0, 1 / 3.0, 1 / 3.0});
  const auto start = x, corner = point(face, {1, 0, 0});
  const double reach = 6 * std::max(std::fabs(corner[0] - x[0]), std::fabs(corner[1] - x[1]));
  double det = 0;
  for (int step = 0; step < 12; ++step) {
    const auto a = shape(forms_at(x));
    det = a.a.d(1, 0) * a.b.d(0, 1) - a.a.d(0, 1) * a.b.d(1, 0);
    const double du = (a.b.d(0, 1) * a.a.value() - a.a.d(0, 1) * a.b.value()) / det;
    const double dv = (a.a.d(1, 0) * a.b.value() - a.b.d(1, 0) * a.a.value()) / det;
    x = {x[0] - du, x[1] - dv};
    if (!(std::fabs(x[0] - start[0]) < reach && std::fabs(x[1] - start[1]) < reach))
      return std::nullopt;
  }
  for (std::size_t d = 0; d < 2; ++d)
    if (!surface_.periodic[d] && (x[d] < 0 || x[d] > 1)) return std::nullopt;
  return Umbilic{x, det > 0 ? 1 : -1, face};
}

std::vector<Umbilic> SmoothSampler::umbilics() {
  std::vector<Umbilic> found;
  std::vector<double> off;  // of the face from the umbilic
  for (u32 f = 0; f < c_.faces.size(); ++f) {
    const auto u = newton(f);
    if (!u) continue;
    const auto at = point(f, {1 / 3.0, 1 / 3.0, 1 / 3.0});
    const double distance = std::hypot(at[0] - u->at[0], at[1] - u->at[1]);
    bool fresh = true;
    for (std::size_t k = 0; k < found.size() && fresh; ++k) {
      double apart = 0;
      for (std::size_t d = 0; d < 2; ++d) {
        const double step = u->at[d] - found[k].at[d];
        apart = std::max(apart, std::fabs(step - std::nearbyint(step)));
      }
      if (apart > 1e-6) continue;
      fresh = false;
      if (distance < off[k]) found[k] = *u, off[k] = distance;
    }
    if (fresh) found.push_back(*u), off.push_back(distance);
  }
  return found;
}

double SmoothSampler::distance(const Umbilic& u, u32 face) const {
  double far = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 2; ++d) {
      double off = c_.vertices[c_.faces[face][i]][d] + lift_of(c_, face, i, d) - u.at[d];
      if (surface_.periodic[d]) off -= std::nearbyint(off);
      far = std::max(far, std::fabs(off));
    }
  return far;
}

/// Where E_j changes its sign along the edge.
SmoothSampler::Sample SmoothSampler::at_crossing(u32 face, std::size_t colour, std::size_t edge,
                                                 int w) {
  double low = 0, high = 1;
  const auto at = [&](double t) {
    Barycentric l{};
    l[edge] = 1 - t;
    l[(edge + 1) % 3] = t;
    return sample(face, l, w);
  };
  const double start = at(0).e[colour].value();
  for (int step = 0; step < 50; ++step) {
    const double t = (low + high) / 2;
    (at(t).e[colour].value() * start > 0 ? low : high) = t;
  }
  return at(low);
}

namespace {

int nearest_direction(double x, double y) {
  int best = 0;
  double most = -1;
  for (int k = 0; k < 128; ++k) {
    const auto d = direction(k);
    const double cosine = std::fabs(d[0] * x + d[1] * y) / std::hypot(d[0], d[1]);
    if (cosine > most) most = cosine, best = k;
  }
  return best;
}

}  // namespace

void SmoothSampler::fill(u32 face, std::array<unsigned, 2>& crossed) {
  SmoothFaceRecord& r = c_.face_records[face];
  const Barycentric centre = {1 / 3.0, 1 / 3.0, 1 / 3.0};
  const auto a = shape(forms_at(point(face, centre)));
  const double p = a.a.value(), q = a.b.value(), s = a.c.value();
  const double sigma = std::sqrt(p * p + q * s);
  r.w = static_cast<std::uint8_t>(p > 0 ? nearest_direction(sigma + p, s)
                                        : nearest_direction(q, sigma - p));
  std::vector<Sample> samples;
  constexpr int kSteps = 4;
  std::array<std::size_t, 3> corner{};
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const Barycentric l = {(kSteps - i - j) / double{kSteps}, i / double{kSteps},
                             j / double{kSteps}};
      for (std::size_t k = 0; k < 3; ++k)
        if (l[k] == 1) corner[k] = samples.size();
      samples.push_back(sample(face, l, r.w));
    }
  const Sample middle = sample(face, centre, r.w);
  crossed = {};
  for (std::size_t j = 0; j < 2; ++j) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const Sample& x : samples) {
      least = std::min(least, x.e[j].value());
      most = std::max(most, x.e[j].value());
    }
    r.verdict[j] = SmoothFaceRecord::kNoZero;
    r.type[j] = 0;
    if (std::min(std::fabs(least), std::fabs(most)) > 0.1 * (most - least) && least * most > 0)
      continue;
    r.verdict[j] =
        static_cast<std::uint8_t>(nearest_direction(middle.e[j].d(1, 0), middle.e[j].d(0, 1)));
    for (std::size_t i = 0; i < 3; ++i)
      if (samples[corner[i]].e[j].value() * samples[corner[(i + 1) % 3]].e[j].value() < 0)
        crossed[j] |= 1U << i;
    if (crossed[j] == 0) continue;
    bool negative = false, positive = false;
    for (std::size_t i = 0; i < 3; ++i)
      if ((crossed[j] >> i & 1U) != 0)
        (at_crossing(face, j, i, r.w).growth[j] < 0 ? negative : positive) = true;
    r.type[j] = negative == positive ? 3 : negative == (j == 0) ? 1 : 2;
  }
  r.purple = false;
  if (crossed[0] == 0 || crossed[1] == 0) return;
  double product = 1;
  for (std::size_t i = 0; i < 3; ++i)
    if ((crossed[0] >> i & 1U) != 0)
      product *= at_crossing(face, 0, i, r.w).e[1].value() > 0 ? 1 : -1;
  r.purple = product < 0;
}

}  // namespace crest::tests
