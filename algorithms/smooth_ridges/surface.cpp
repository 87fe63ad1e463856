// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/surface.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/smooth_ridges/undefined.hpp"

namespace crest::smooth_ridges {
namespace {

using kernel::Expression;

Expression parse(const std::string& name, const std::string& text,
                 const std::vector<std::string>& variables) {
  const bool printable =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (!printable)
    throw std::invalid_argument(name + ": the text holds a character that is not printable ASCII");
  try {
    Expression expression = Expression::parse(text, variables);
    if (expression.program().size() > certify::kMostWords)
      throw std::invalid_argument(name + ": " + std::to_string(expression.program().size()) +
                                  " numbers, names and operators; at most " +
                                  std::to_string(certify::kMostWords) +
                                  " can be evaluated: use fewer terms");
    return expression;
  } catch (const kernel::ExpressionError& error) {
    const std::string what = error.what();
    throw kernel::ExpressionError(
        error.column(), what.substr(what.find(": ") + 2) + " (in " + name + " = " + text + ")");
  }
}

void require_defined(const std::optional<Undefined>& undefined) {
  if (undefined && undefined->extent == Undefined::Extent::nowhere)
    throw std::invalid_argument(undefined->text);
}

/// Throws unless lower < upper, with enough bits for any sensible domain.
void require_order(const Expression& lower, const Expression& upper, const std::string& name) {
  constexpr mpfr_prec_t kBits = 256;
  const auto value = [](const Expression& e) {
    return kernel::mp_jet_evaluator<1, 0>(e, kBits)({})[0];
  };
  const kernel::MpInterval length = value(upper) - value(lower);
  if (!(length.lower() > 0 && length.upper() < HUGE_VAL))
    throw std::invalid_argument("the domain: " + name + "0 = " + lower.text() + " is not below " +
                                name + "1 = " + upper.text());
}

}  // namespace

Surface Surface::implicit(const std::string& f, const Box& box) {
  Surface s;
  s.functions_.push_back(parse("F", f, {"x", "y", "z"}));
  for (std::size_t i = 0; i < 6; ++i) {
    if (!std::isfinite(box[i])) throw std::invalid_argument("the box: a bound is not finite");
    s.box_[i] = box[i] + 0.0;  // one form of zero
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box[2 * i] < box[2 * i + 1]))
      throw std::invalid_argument(std::string("the box: the upper bound of ") + "xyz"[i] +
                                  " is not above the lower one");
  require_defined(find_undefined(s));
  return s;
}

Surface Surface::parametric(const std::array<std::string, 3>& coordinates,
                            const std::array<std::string, 4>& domain,
                            const std::array<bool, 2>& periodic) {
  Surface s;
  s.implicit_ = false;
  s.periodic_ = periodic;
  const std::array<std::string, 3> names = {"x", "y", "z"};
  const std::array<std::string, 4> bounds = {"u0", "u1", "v0", "v1"};
  for (std::size_t i = 0; i < 3; ++i)
    s.functions_.push_back(parse(names[i], coordinates[i], {"u", "v"}));
  for (std::size_t i = 0; i < 4; ++i) {
    s.domain_.push_back(parse(bounds[i], domain[i], {}));
    require_defined(find_undefined(s.domain_[i], bounds[i]));
  }
  const auto name = [](std::size_t i) { return std::string(1, "uv"[i]); };
  for (std::size_t i = 0; i < 2; ++i)
    require_order(s.domain_[2 * i], s.domain_[2 * i + 1], name(i));
  require_defined(find_undefined(s));
  for (std::size_t i = 0; i < 2; ++i)
    if (periodic[i] && !provably_periodic(s.functions_, s.domain_[2 * i], s.domain_[2 * i + 1], i))
      throw std::invalid_argument(
          "periodic in " + name(i) + ": x, y, z must be made of sin and cos of " +
          "rational multiples of " + name(i) + ", and the domain a whole number of their periods");
  return s;
}

certify::SmoothSurfaceData Surface::data() const {
  certify::SmoothSurfaceData d;
  d.kind = implicit_ ? 0 : 1;
  for (const Expression& f : functions_) d.texts.push_back(f.text());
  for (const Expression& f : domain_) d.texts.push_back(f.text());
  d.box = box_;
  d.periodic = static_cast<std::uint8_t>((periodic_[0] ? 1 : 0) + (periodic_[1] ? 2 : 0));
  return d;
}

}  // namespace crest::smooth_ridges
