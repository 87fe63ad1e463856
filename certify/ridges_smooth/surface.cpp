// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/surface.hpp"

#include "certify/container/reject.hpp"

namespace crest::certify::smooth {
namespace {

constexpr mpfr_prec_t kBits = 192;

kernel::Expression parse(const std::string& text, const std::vector<std::string>& variables,
                         const char* name) {
  try {
    auto expression = kernel::Expression::parse(text, variables);
    require(expression.program().size() <= kMostWords,
            "surface: {}: {} numbers, names and operators; at most {} can be evaluated", name,
            expression.program().size(), kMostWords);
    return expression;
  } catch (const kernel::ExpressionError& problem) {
    throw Reject(fmt::format("surface: {}: {}", name, problem.what()));
  }
}

kernel::MpInterval value_of(const kernel::Expression& constant) {
  const auto convert = [](const kernel::Constant& c) { return kernel::as_mp_interval(c, kBits); };
  return kernel::Evaluator<kernel::MpInterval>(constant, convert,
                                               kernel::MpInterval(1.0, kBits))({});
}

}  // namespace

Surface parse_surface(const SmoothSurfaceData& data) {
  Surface s{data.kind == 0, {}, {(data.periodic & 1U) != 0, (data.periodic & 2U) != 0}, data.box};
  if (s.implicit) {
    s.texts.push_back(parse(data.texts[0], {"x", "y", "z"}, "F"));
    for (std::size_t i = 0; i < 3; ++i)
      require(data.box[2 * i] < data.box[2 * i + 1], "surface: an empty box");
    return s;
  }
  const std::array names = {"x", "y", "z", "u0", "u1", "v0", "v1"};
  for (std::size_t i = 0; i < 7; ++i)
    s.texts.push_back(parse(data.texts[i],
                            i < 3 ? std::vector<std::string>{"u", "v"} : std::vector<std::string>{},
                            names[i]));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto length = value_of(s.texts[4 + 2 * i]) - value_of(s.texts[3 + 2 * i]);
    require(certain_sign(length) == kernel::Sign::positive,
            "surface: the domain's length in {} is not certain to be positive", i == 0 ? "u" : "v");
    if (s.periodic[i]) prove_period(s.texts, i);
  }
  return s;
}

Frame frame_of(const SmoothFaceRecord& record) {
  const double e = record.frame[0], f = record.frame[1], g = record.frame[2], h = record.frame[3];
  const double ee = e * e, ff = f * f, gg = g * g, hh = h * h;
  return {{{ee + ff - gg - hh, 2 * (f * g + e * h), 2 * (f * h - e * g)},
           {2 * (f * g - e * h), ee - ff + gg - hh, 2 * (g * h + e * f)},
           {2 * (f * h + e * g), 2 * (g * h - e * f), ee - ff - gg + hh}}};
}

}  // namespace crest::certify::smooth
