// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From local polynomials to splines in normal form.
#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/splines/cubic_model.hpp"
#include "algorithms/splines/local_cubic.hpp"
#include "algorithms/splines/scattered.hpp"

namespace crest::splines {

struct Extension {
  CubicModel model;
  std::vector<LocalCubic> fits;
};

/// One fit a black cube, at its centre; the numbers of a vertex or an edge are the mean over the
/// black cubes that it touches (of none, over white cubes, which then have fits, too); the centres
/// by least squares on r. `flat`: axes on which the fits do not depend.
Extension extend_locally(const Domain& domain, const Scattered& samples,
                         const std::array<bool, 3>& flat);

/// The thesis' extension (section 9.4.2): one fit a black tetrahedron, also round the domain; the
/// other numbers in six steps (README.md beside this file).
Extension extend_sequentially(const Domain& domain, const Scattered& samples,
                              const std::array<bool, 3>& flat);

/// An empty model.
CubicModel make_model(const Domain& domain);

/// Fits at places, in parallel.
std::vector<LocalCubic> fit_at(const std::vector<Vec3>& places, const Scattered& samples,
                               const Scattered::Request& request, const std::array<bool, 3>& flat);

/// 4 a(ACC) as the corners of a cube ask for it.
std::array<double, 8> fourfold_targets(const CubicModel& model, const Place& cube);

/// Sets the centres of the white cubes, or of all, by least squares on r.
void fit_centres(CubicModel& model, bool black);

}  // namespace crest::splines
