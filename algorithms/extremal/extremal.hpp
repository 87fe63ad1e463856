// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public call of extremal curves and surfaces (theory and limits: README.md beside this file).
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "algorithms/extremal/extremal_result.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::certify {
struct ExtremalCertificate;
}

namespace crest::extremal {

/// Samples at the nodes of a grid, the first index fastest. An image has size[2] = 1.
struct Volume {
  std::array<kernel::Index, 3> size{};
  kernel::Vec3 spacing{1, 1, 1};  ///< 2^-60 to 2^60; an image's third is not used
  kernel::Vec3 origin{0, 0, 0};
  std::variant<std::vector<float>, std::vector<double>> samples;

  int dimension() const { return size[2] == 1 ? 2 : 3; }
};

/// Points with normals whose signs do not matter.
struct OrientedPoints {
  std::vector<kernel::Vec3> points, normals;
};

enum class Definition : std::uint8_t { structure, hessian };
enum class Side : std::uint8_t { ridge, valley };

inline constexpr int kMostRefined = 3;

struct Options {
  Definition definition = Definition::structure;
  Side side = Side::ridge;
  double sigma = 1;                    ///< in the smallest spacing
  std::optional<double> tensor_sigma;  ///< sigma unless given
  std::optional<double> min_value;     ///< keeps L >= it
  double min_strength = 0;             ///< keeps s_nn >= it
  bool critical = false;               ///< keeps the merely critical, too
  int refine = 0;  ///< 0 to kMostRefined: so often the grid is halved, the field stays
};

struct PointOptions {
  std::optional<double> radius;  ///< unless given, the median distance to the 10th neighbour
  int depth = 10;
  bool critical = false;
};

/// The extremal surface of a volume, or the extremal curves of an image.
/// Guarantees: the same result for any number of threads. With `certificate` it is filled, too.
/// Throws kernel::InputError: a sample that is not finite (the first, with its index), fewer than 4
///   nodes along an axis, a size that is not that of the samples, spacing or options out of range.
Result extract(const Volume& volume, const Options& options,
               certify::ExtremalCertificate* certificate = nullptr);
/// The same, of samples that are thrown away as soon as they are smoothed: less memory.
Result extract(Volume&& volume, const Options& options,
               certify::ExtremalCertificate* certificate = nullptr);

/// The extremal surface of points on an octree. Throws kernel::InputError: no point, all normals
/// zero, numbers that are not finite. Points whose normal is zero are dropped and counted.
Result extract(const OrientedPoints& points, const PointOptions& options,
               certify::ExtremalCertificate* certificate = nullptr);

}  // namespace crest::extremal
