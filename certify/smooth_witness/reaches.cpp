// SPDX-License-Identifier: GPL-3.0-or-later
// Kind 0: lengths of fibres from samples in plain double; about twice what is needed.
#include <algorithm>
#include <cmath>

#include "certify/container/reject.hpp"
#include "certify/smooth_witness/loop.hpp"
#include "certify/smooth_witness/parts.hpp"

namespace crest::certify::witness {
namespace {

using Vec3 = std::array<double, 3>;

/// F with its first n derivatives.
template <int n>
class Sampler {
 public:
  using Jet = kernel::Jet<double, 3, n>;
  explicit Sampler(const smooth::Surface& surface)
      : evaluate_(kernel::jet_evaluator<double, 3, n>(surface.texts[0])) {}
  Jet operator()(const Vec3& x) {
    const std::array<Jet, 3> at = {Jet::variable(0, x[0]), Jet::variable(1, x[1]),
                                   Jet::variable(2, x[2])};
    return evaluate_(at);
  }

 private:
  kernel::Evaluator<Jet> evaluate_;
};

constexpr std::array<Vec3, 4> kPlaces = {
    {{1 / 3.0, 1 / 3.0, 1 / 3.0}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

/// 1.5 times the largest s of Newton's first step, and a length that makes no difference.
double face_reach(Sampler<1>& sample, const RidgesSmoothCertificate& c, u32 face) {
  const auto& corners = c.faces[face];
  double most = 0, size = 0, length = 0;
  for (const Vec3& l : kPlaces) {
    Vec3 x{}, m{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        x[k] += l[i] * c.vertices[corners[i]][k];
        m[k] += l[i] * c.vertices[corners[i]][k + 3];
      }
    const auto f = sample(x);
    most = std::fmax(most, std::fabs(f[0] / smooth::dot(smooth::gradient(f), m)));
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = c.vertices[corners[i]], &b = c.vertices[corners[(i + 1) % 3]];
      size = std::fmax(size, std::fabs(a[k] - b[k]));
      length = std::fmax(length, std::fabs(a[k + 3]));
    }
  return 1.5 * most + size / length * 0x1p-10;
}

/// A patch's graph m = g(p, q), of degree two at the centre, and how far S is from it over Q.
class Graph {
 public:
  Graph(Sampler<2>& sample, SmoothPatchRecord& p) : sample_(sample), p_(p), m_(p.axis) {}

  double fit() {
    const std::array<std::size_t, 2> axes = {(m_ + 1) % 3, (m_ + 2) % 3};
    const double height = height_at(p_.centre, p_.height[0] / 2 + p_.height[1] / 2);
    const auto f = sample_(point(p_.centre, height));
    const auto derivative = [&](std::size_t a, std::size_t b) {
      std::array<int, 3> e{};
      ++e[a];
      if (b < 3) ++e[b];
      return f.derivative(e[0], e[1], e[2]);
    };
    const double slope = derivative(m_, 3), mm = derivative(m_, m_);
    std::array<double, 2> h{};
    for (std::size_t i = 0; i < 2; ++i) h[i] = -derivative(axes[i], 3) / slope;
    const auto second = [&](std::size_t i, std::size_t k) {
      return -(derivative(axes[i], axes[k]) + derivative(axes[i], m_) * h[k] +
               derivative(axes[k], m_) * h[i] + mm * h[i] * h[k]) /
             slope;
    };
    p_.graph = {height, h[0], h[1], second(0, 0) / 2, second(0, 1), second(1, 1) / 2};
    double most = 0;
    for (int i = -2; i <= 2; ++i)
      for (int k = -2; k <= 2; ++k) {
        const double a = i * p_.radius / 2, b = k * p_.radius / 2;
        const auto& g = p_.graph;
        const double guess = g[0] + a * (g[1] + a * g[3] + b * g[4]) + b * (g[2] + b * g[5]);
        const double found = height_at({p_.centre[0] + a, p_.centre[1] + b}, guess);
        most = std::fmax(most, std::fabs(found - guess));
      }
    for (double& x : p_.graph) x += 0.0;
    return 1.5 * most + p_.radius * 0x1p-10;
  }

 private:
  Vec3 point(const std::array<double, 2>& at, double height) const {
    Vec3 x{};
    x[(m_ + 1) % 3] = at[0];
    x[(m_ + 2) % 3] = at[1];
    x[m_] = height;
    return x;
  }
  /// Newton's method.
  double height_at(const std::array<double, 2>& at, double m) {
    for (int i = 0; i < 20; ++i) {
      const auto f = sample_(point(at, m));
      const double next =
          std::clamp(m - f[0] / smooth::gradient(f)[m_], p_.height[0], p_.height[1]);
      if (!(std::fabs(next - m) > 0)) break;
      m = next;
    }
    return m;
  }

  Sampler<2>& sample_;
  SmoothPatchRecord& p_;
  std::size_t m_;
};

}  // namespace

std::vector<int> face_reaches(const Claim& claim) {
  const RidgesSmoothCertificate& c = claim.certificate;
  std::vector<int> reaches(c.faces.size());
  for_all(
      reaches.size(), [&] { return Sampler<1>(claim.surface); },
      [&](Sampler<1>& sample, std::size_t f) {
        reaches[f] = exponent_above(face_reach(sample, c, static_cast<u32>(f)), "face", f);
      });
  return reaches;
}

std::vector<int> patch_reaches(const smooth::Surface& surface, RidgesSmoothCertificate& c) {
  Sampler<2> sample(surface);
  std::vector<int> reaches;
  for (std::size_t p = 0; p < c.patches.size(); ++p) {
    require(c.patches[p].height[0] < c.patches[p].height[1], "patch {}: no height", p);
    reaches.push_back(exponent_above(Graph(sample, c.patches[p]).fit(), "patch", p));
  }
  return reaches;
}

}  // namespace crest::certify::witness
