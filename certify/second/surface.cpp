// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/surface.hpp"

#include "certify/second/periods.hpp"

namespace crest::recheck {

Surface::Surface(const Certificate& c) : implicit_(c.implicit) {
  const Scope scope;
  context.precision = 128;
  const std::vector<std::string> xyz = {"x", "y", "z"}, uv = {"u", "v"};
  for (Index k = 0; k < c.texts.size(); ++k)
    parts_.push_back(Expression::parse(c.texts[k], implicit_ ? xyz
                                                   : k < 3   ? uv
                                                             : std::vector<std::string>()));
  if (implicit_) return;
  for (std::size_t d = 0; d < 2; ++d) {
    const Ball length = parts_[4 + 2 * d].evaluate<Ball>({}) - parts_[3 + 2 * d].evaluate<Ball>({});
    if (!length.is_positive()) throw Rejected("the domain's bounds are not certainly in order");
    if (c.periodic[d]) prove_period(d);
  }
}

void Surface::prove_period(std::size_t direction) const {
  const auto from = linear_in_pi(parts_[3 + 2 * direction]),
             to = linear_in_pi(parts_[4 + 2 * direction]);
  const std::string name = direction == 0 ? "u" : "v";
  if (!from || !to || !(to->a - from->a).is_zero())
    throw Rejected("the domain's length in " + name + " is not shown to be a multiple of 2 pi");
  const Rational q = (to->b - from->b) / Rational(2);
  for (Index k = 0; k < 3; ++k)
    if (!is_invariant(parts_[k], static_cast<int>(direction), q))
      throw Rejected("the period in " + name + " is not shown for coordinate " + "xyz"[k]);
}

}  // namespace crest::recheck
