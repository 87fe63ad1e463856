// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/smooth_witness/record.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "certify/container/reject.hpp"
#include "certify/smooth_witness/parts.hpp"

namespace crest::certify {
namespace witness {

int exponent_above(double x, const char* what, std::size_t number) {
  require(x > 0 && x < HUGE_VAL, "{} {}: no length of its fibres", what, number);
  int exponent = 0;
  return std::frexp(x, &exponent) == 0.5 ? exponent - 1 : exponent;
}

void put_f32(Bytes& out, double x) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(x));
  for (unsigned i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}
void put_f64(Bytes& out, double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  for (unsigned i = 0; i < 8; ++i) out.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}

unsigned direction_near(double a, double b, double c) {
  const double sigma = std::sqrt(std::fmax(a * a + b * c, 0));
  const std::array<double, 2> w = a > 0 ? std::array{sigma + a, c} : std::array{b, sigma - a};
  // Number k is the point (32, k - 32) or (96 - k, 32) of the square.
  const double x = std::fabs(w[0]), y = std::fabs(w[1]);
  if (!(x + y > 0)) return 0;
  if (x > y) return static_cast<unsigned>(std::clamp(std::lround(32 + 32 * w[1] / w[0]), 0L, 63L));
  return static_cast<unsigned>(std::clamp(std::lround(96 - 32 * w[0] / w[1]), 64L, 127L));
}

std::array<double, 2> as_floats(double a, double b) {
  const double size = std::fmax(std::fabs(a), std::fabs(b));
  if (!(size > 0 && size < HUGE_VAL)) return {1, 0};
  // + 0.0: no -0.
  return {double{static_cast<float>(a / size)} + 0.0, double{static_cast<float>(b / size)} + 0.0};
}

/// One of the two alone, if it has no zero; else one that is large in the middle.
std::vector<std::array<double, 2>> combinations(const std::array<kernel::Range, 2>& e) {
  for (std::size_t j = 0; j < 2; ++j)
    if (smooth::nonzero(kernel::certain_sign(e[j])))
      return {j == 0 ? std::array{1.0, 0.0} : std::array{0.0, 1.0}};
  const double u = e[0].high - e[0].low, v = e[1].high - e[1].low;
  return {as_floats(middle(e[0]) / u / u, middle(e[1]) / v / v)};
}

namespace {

void record_all(RidgesSmoothCertificate& c) {
  const smooth::Surface surface = smooth::parse_surface(c.surface);
  const smooth::Mesh mesh = smooth::check_mesh(c);
  const smooth::Claim claim{surface, c, mesh, Arithmetic::doubles};
  c.loose_corners = 0;
  if (surface.implicit) {
    const std::vector<int> faces = face_reaches(claim), patches = patch_reaches(surface, c);
    // Room for lengths that turn out to be too short.
    int most = *std::max_element(faces.begin(), faces.end());
    for (const int k : patches) most = std::max(most, k);
    c.reach = static_cast<std::int16_t>(most + 4);
    const auto steps = [&](int k) { return static_cast<std::uint8_t>(std::min(c.reach - k, 255)); };
    for (std::size_t f = 0; f < faces.size(); ++f)
      c.face_records[f].witness.assign(1, steps(faces[f]));
    for (std::size_t p = 0; p < patches.size(); ++p) c.patches[p].reach = steps(patches[p]);
  }
  const auto boxes = record_faces(claim, c);
  if (surface.implicit) {
    record_sheets(claim, c, boxes);
    record_completeness(claim, c);
  }
  record_patches(claim, c);
}

}  // namespace
}  // namespace witness

std::optional<std::string> record_witnesses(RidgesSmoothCertificate& c) {
  try {
    witness::record_all(c);
    return std::nullopt;
  } catch (const Reject& open) {
    return open.what();
  }
}

}  // namespace crest::certify
