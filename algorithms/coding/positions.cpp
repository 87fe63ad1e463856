// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/positions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "algorithms/coding/real_form.hpp"
#include "algorithms/coding/triple_model.hpp"
#include "algorithms/coding/visit_order.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::coding {
namespace {

constexpr int kLowBits = 33;  ///< of a double's 53, that are 0 in a step
constexpr std::int64_t kMostMultiple = std::int64_t{1} << 31;

/// All vertices' integers.
template <class Model>
void code_vertices(const Surface& surface, Model& model) {
  model.code_hints();
  VisitOrder order(surface);
  for (Index v = order.take(); v != kNone; v = order.take()) {
    kernel::stop_point();
    model.code(
        v, surroundings(
               surface, [&](auto&& each) { surface.around(v, each); },
               [&](Index h) { return surface.from(h); }, [&](Index w) { return order.known(w); }));
    order.visit(v);
  }
}

using Axes = std::array<RealChannel, 3>;

/// Parameters first, then the integers, then the exceptions among `numbers`.
template <class Range>
void code_exact(Range& range, const Surface& surface, std::span<Triple> values, Axes& axes,
                std::array<std::vector<double>, 3>& numbers, std::array<Hint, 3> hints) {
  for (RealChannel& axis : axes) code_form(range, axis.form);
  const bool wide = std::any_of(axes.begin(), axes.end(),
                                [](const RealChannel& axis) { return axis.form.wide(); });
  with_model(range, values, 3, wide, hints, [&](auto&& model) { code_vertices(surface, model); });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if constexpr (!Range::kEncodes)
      for (const Triple& value : values)
        numbers[axis].push_back(checked_number(axes[axis].form, value[axis]));
    code_exceptions(range, axes[axis].exceptions, numbers[axis]);
  }
}

template <class Range>
void code_multiples(Range& range, const Surface& surface, std::span<Triple> values, double& step,
                    std::array<Hint, 3> hints) {
  step =
      std::bit_cast<double>(LargeNumber::code_lower(range, std::bit_cast<std::uint64_t>(step), 64));
  if (!std::isnormal(step) || step < 0 ||
      std::bit_cast<std::uint64_t>(step) << (64 - kLowBits) != 0)
    throw StreamError("has a step that is no positive number of 20 bits");
  TripleModel<Range, std::int64_t> model(range, values, 3, -kMostMultiple + 1, kMostMultiple - 1,
                                         hints);
  code_vertices(surface, model);
}

template <class Encode>
Bytes smallest(const Surface& surface, std::span<const Triple> values, Encode&& encode) {
  const auto each_edge = [&](auto&& each) {
    for (Index h = 0; h < 3 * surface.face_count(); ++h) each(surface.from(h), surface.to(h));
  };
  return smallest(values, 3, each_edge, encode).second;
}

}  // namespace

Bytes encode_exact(const Surface& decoded, std::span<const Point> points) {
  Axes axes;
  std::array<std::vector<double>, 3> numbers;
  std::vector<Triple> values(points.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Point& p : points) numbers[axis].push_back(p[axis]);
    axes[axis] = choose_form(numbers[axis]);
    for (std::size_t v = 0; v < points.size(); ++v)
      values[v][axis] = integer(axes[axis].form, points[v][axis]);
  }
  return smallest(decoded, values, [&](std::array<Hint, 3> hints) {
    RangeEncoder range;
    code_exact(range, decoded, std::span<Triple>(values), axes, numbers, hints);
    return range.finish();
  });
}

std::vector<Point> decode_exact(std::span<const std::uint8_t> bytes, const Surface& decoded) {
  Axes axes;
  std::array<std::vector<double>, 3> numbers;
  RangeDecoder range(bytes);
  std::vector<Triple> values(decoded.counts().vertices);
  with_position(range, [&] {
    code_exact(range, decoded, std::span<Triple>(values), axes, numbers, {});
    range.finish();
  });
  std::vector<Point> points(values.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[v][axis] = numbers[axis][v];
      if (!std::isfinite(points[v][axis])) throw StreamError("has a coordinate that is not finite");
    }
  return points;
}

double step_within(double tolerance) {
  // t 2^j = tolerance with t of 53 bits; m 2^(j + e) with m of 20 bits is a step if
  // 3 m^2 2^(2 e) <= 4 t^2: at most 112 bits, as e is 33 or 34.
  int exponent = 0;
  const auto t = static_cast<Int128>(std::ldexp(std::frexp(tolerance, &exponent), 53));
  int e = 34;
  Int128 m = (Int128{1} << 20) - 1;
  const auto fits = [&] { return 3 * m * m << (2 * e) <= 4 * t * t; };
  Int128 low = Int128{1} << 19, high = Int128{1} << 20;
  m = low;
  if (!fits()) --e;
  while (high - low > 1) {
    m = (low + high) / 2;
    (fits() ? low : high) = m;
  }
  const double step = std::ldexp(static_cast<double>(low), exponent - 53 + e);
  if (step < std::numeric_limits<double>::min())
    throw kernel::InputError("tolerance: is too small for doubles; give a larger one or --exact");
  return step;
}

bool in_reach(const Point& point, double step) {
  return std::all_of(point.begin(), point.end(), [&](double x) {
    return std::fabs(std::nearbyint(x / step)) < static_cast<double>(kMostMultiple);
  });
}

Point rounded(const Point& point, double step) {
  Point place;
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = (std::nearbyint(point[axis] / step) + 0.0) * step;  // no -0
  return place;
}

Bytes encode_rounded(const Surface& decoded, std::span<const Point> points, double step) {
  std::vector<Triple> values(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[v][axis] = static_cast<std::int64_t>(std::nearbyint(points[v][axis] / step));
  return smallest(decoded, values, [&](std::array<Hint, 3> hints) {
    RangeEncoder range;
    code_multiples(range, decoded, values, step, hints);
    return range.finish();
  });
}

std::vector<Point> decode_rounded(std::span<const std::uint8_t> bytes, const Surface& decoded) {
  std::vector<Triple> values(decoded.counts().vertices);
  RangeDecoder range(bytes);
  double step = 0;
  with_position(range, [&] {
    code_multiples(range, decoded, std::span<Triple>(values), step, {});
    range.finish();
  });
  std::vector<Point> points(values.size());
  for (std::size_t v = 0; v < values.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[v][axis] = static_cast<double>(values[v][axis]) * step;
      if (!std::isfinite(points[v][axis])) throw StreamError("has a coordinate that is not finite");
    }
  return points;
}

}  // namespace crest::coding
