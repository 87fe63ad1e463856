// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The cubes of the domain (SPEC.md, step 1).
#include "certify/spline_cubic/records.hpp"

namespace crest::certify::spline_cubic {

class Domain {
 public:
  /// Throws Reject unless the runs are ascending, apart and cubes of the box, at least one, and
  /// all numbers of sites without a cube are 0.
  explicit Domain(const SplineCubicData& data);

  bool holds(std::size_t cube) const { return cubes_[cube] != 0; }
  std::size_t size() const { return size_; }

 private:
  void mark(const SplineCubicData& data);

  std::vector<std::uint8_t> cubes_;
  std::size_t size_ = 0;
};

}  // namespace crest::certify::spline_cubic
