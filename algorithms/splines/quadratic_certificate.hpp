// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a quadratic spline's certificates hold (certify/spline_rays/SPEC.md,
// certify/spline_isosurface/SPEC.md).
#include "algorithms/splines/isosurface.hpp"
#include "algorithms/splines/rays.hpp"
#include "certify/spline_isosurface/encode.hpp"
#include "certify/spline_rays/encode.hpp"

namespace crest::splines {

/// The samples, their grid and the level, for both claims.
certify::SplineVolume volume_record(const QuadraticSpline& spline, double level);

/// Requires: a hit a ray.
certify::SplineRaysCertificate rays_certificate(const QuadraticSpline& spline, double level,
                                                std::span<const Ray> rays,
                                                std::span<const Hit> hits);

/// Requires: nothing of the surface is undecided.
certify::SplineIsosurfaceCertificate isosurface_certificate(const QuadraticSpline& spline,
                                                            double level,
                                                            const Isosurface& surface);

}  // namespace crest::splines
