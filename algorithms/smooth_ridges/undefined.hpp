// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a surface's expressions are not defined, or not analytic where that matters (certify/
// SPEC.md, claim 4, condition (A)): a search that names the place before anything else is tried.
//
// Cells are evaluated operation by operation with intervals and mean values, and halved where an
// operation is not proven. Parametric: every part of x, y, z is to be analytic on the whole domain.
// Implicit: every part of F is to be defined in the whole box, and analytic where F may vanish.
#include <optional>
#include <string>

#include "algorithms/smooth_ridges/surface.hpp"

namespace crest::smooth_ridges {

struct Undefined {
  enum class Extent {
    nowhere,  ///< the part is defined at no point of the domain
    here,     ///< it is not defined at `where`
    perhaps   ///< it is not proven to be defined and analytic near `where`
  };
  Extent extent;
  std::size_t column;  ///< of the least part of the text that is not defined, from 1
  std::string name;    ///< of the expression: F, x, y, z, u0, ...
  Vec3 where;          ///< implicit: x, y, z; parametric: u, v
  std::string text;    ///< one line
};

/// Nothing if all is proven, or if that takes too many cells: then the charts decide.
/// Cost: one evaluation where every part is certain at once, as of polynomials.
std::optional<Undefined> find_undefined(const Surface& surface);

/// Of an expression without variables: the first part that is not defined and finite.
std::optional<Undefined> find_undefined(const kernel::Expression& constant,
                                        const std::string& name);

}  // namespace crest::smooth_ridges
