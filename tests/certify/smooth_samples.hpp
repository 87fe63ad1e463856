// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values of the forms of claim 4, kind 1, in plain double, for the tests' producer.
#include <optional>

#include "certify/ridges_smooth/forms.hpp"
#include "certify/ridges_smooth/surface.hpp"

namespace crest::tests {

struct Umbilic {
  std::array<double, 2> at;
  int index;           ///< twice
  std::uint32_t face;  ///< the one about it
};

class SmoothSampler {
 public:
  explicit SmoothSampler(certify::RidgesSmoothCertificate& c);

  std::vector<Umbilic> umbilics();
  /// Of the face's corners from the umbilic, by the larger coordinate.
  double distance(const Umbilic& u, std::uint32_t face) const;
  /// w, verdicts, types, purple bit of a face; crossed edges by colour.
  void fill(std::uint32_t face, std::array<unsigned, 2>& crossed);

 private:
  using Forms = certify::smooth::Forms<double, 2>;
  using Field = certify::smooth::Local<double, 2>;
  struct Sample {
    std::array<Field, 2> e;
    std::array<double, 2> growth, turn;
    double s;
  };
  using Barycentric = std::array<double, 3>;

  Forms forms_at(const std::array<double, 2>& x);
  std::array<double, 2> point(std::uint32_t face, const Barycentric& l);
  Sample sample(std::uint32_t face, const Barycentric& l, int w);
  std::optional<Umbilic> newton(std::uint32_t face);
  Sample at_crossing(std::uint32_t face, std::size_t colour, std::size_t edge, int w);

  certify::RidgesSmoothCertificate& c_;
  certify::smooth::Surface surface_;
  kernel::Evaluator<kernel::Jet<double, 2, 5>> immersion_;
  std::array<double, 4> domain_{};
};

}  // namespace crest::tests
