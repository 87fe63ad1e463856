// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/positions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "algorithms/coding/position_routine.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::coding {
namespace {

constexpr std::int64_t kExactIntegers = std::int64_t{1} << 53;
constexpr int kLowBits = 33;  ///< of a double's 53, that are 0 in a step
constexpr std::int64_t kMostMultiple = std::int64_t{1} << 31;

/// 10^0 .. 10^22: all are doubles.
constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// How an axis' doubles are integers.
enum class Form : std::uint32_t { decimal, float_decimal, floats, doubles };

struct AxisForm {
  Form form = Form::doubles;
  std::uint32_t exponent = 0;  ///< of decimals
};

/// Integers in the order of the numbers; -0 before 0.
std::int64_t ordered(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
}
double from_ordered(std::int64_t k) {
  return std::bit_cast<double>(k < 0 ? std::numeric_limits<std::int64_t>::min() - k - 1 : k);
}
std::int64_t ordered(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits < 0 ? std::int64_t{std::numeric_limits<std::int32_t>::min()} - bits - 1 : bits;
}
float from_ordered_float(std::int64_t k) {
  const auto bits = static_cast<std::int32_t>(k);
  return std::bit_cast<float>(
      bits < 0 ? static_cast<std::int32_t>(std::numeric_limits<std::int32_t>::min() -
                                           std::int64_t{bits} - 1)
               : bits);
}

double number(AxisForm form, std::int64_t k) {
  switch (form.form) {
    case Form::decimal:
      return static_cast<double>(k) / kPowers[form.exponent];
    case Form::float_decimal:
      return static_cast<double>(
          static_cast<float>(static_cast<double>(k) / kPowers[form.exponent]));
    case Form::floats:
      return static_cast<double>(from_ordered_float(k));
    case Form::doubles:
      break;
  }
  return from_ordered(k);
}

double checked_number(AxisForm form, std::int64_t k) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  const bool decimal = form.form == Form::decimal || form.form == Form::float_decimal;
  if ((form.form == Form::floats && k != static_cast<std::int32_t>(k)) ||
      (decimal && (k < -most || k > most)))
    throw StreamError("has a coordinate beyond its range");
  return number(form, k);
}

/// The integer whose number is x, or is near it.
std::int64_t integer(AxisForm form, double x) {
  switch (form.form) {
    case Form::decimal:
    case Form::float_decimal: {
      const double k = std::nearbyint(x * kPowers[form.exponent]);
      const auto limit = static_cast<double>(kExactIntegers - 1);
      return static_cast<std::int64_t>(std::clamp(k, -limit, limit));
    }
    case Form::floats:
      return ordered(static_cast<float>(x));
    case Form::doubles:
      break;
  }
  return ordered(x);
}

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
bool same(double x, double y) {
  return bits_of(x) == bits_of(y);
}

/// Vertices whose coordinate the form does not give, or nothing if they are too many.
bool exceptions(AxisForm form, std::span<const Point> points, std::size_t axis,
                std::vector<Index>& found) {
  found.clear();
  for (Index v = 0; v < points.size(); ++v) {
    const double x = points[v][axis];
    if (form.form == Form::floats && !(std::fabs(x) <= std::numeric_limits<float>::max()))
      return false;
    if (same(number(form, integer(form, x)), x)) continue;
    found.push_back(v);
    if (100 * found.size() > points.size()) return false;
  }
  return true;
}

/// About how many bits the form costs: of the differences from one vertex to the next.
double cost(AxisForm form, std::span<const Point> points, std::size_t axis,
            std::size_t exceptions) {
  double bits = 80.0 * static_cast<double>(exceptions);
  std::int64_t before = 0;
  for (const Point& p : points) {
    const std::int64_t k = integer(form, p[axis]);
    bits += static_cast<double>(
        std::bit_width(static_cast<std::uint64_t>(k) - static_cast<std::uint64_t>(before)));
    before = k;
  }
  return bits;
}

struct Axis {
  AxisForm form;
  std::vector<Index> exceptions;
};

Axis choose_form(std::span<const Point> points, std::size_t axis) {
  std::vector<AxisForm> forms;
  for (const Form form : {Form::decimal, Form::float_decimal})
    for (std::uint32_t e = 0; e < kPowers.size(); ++e) forms.push_back({form, e});
  forms.push_back({Form::floats, 0});
  Axis best;
  double least = cost(best.form, points, axis, 0);
  bool found_decimal[2] = {false, false};
  std::vector<Index> found;
  for (const AxisForm form : forms) {
    const bool decimal = form.form == Form::decimal || form.form == Form::float_decimal;
    if (decimal && found_decimal[static_cast<std::size_t>(form.form)]) continue;
    if (!exceptions(form, points, axis, found)) continue;
    if (decimal) found_decimal[static_cast<std::size_t>(form.form)] = true;
    const double bits = cost(form, points, axis, found.size());
    if (bits < least) {
      least = bits;
      best = {form, found};
    }
  }
  return best;
}

/// Parameters first, then the integers.
template <class Range>
class ExactRoutine {
 public:
  ExactRoutine(Range& range, const Surface& surface, std::span<Point> points,
               std::array<Axis, 3> axes)
      : range_(range), surface_(surface), points_(points), axes_(std::move(axes)) {}

  void run(std::span<Triple> values, std::array<Hint, 3> hints) {
    for (Axis& axis : axes_) code_form(axis);
    bool wide = false;
    for (const Axis& axis : axes_) wide = wide || axis.form.form == Form::doubles;
    if (wide) {
      TripleRoutine<Range, Int128>(range_, surface_, values,
                                   std::numeric_limits<std::int64_t>::min(),
                                   std::numeric_limits<std::int64_t>::max(), hints)
          .run();
    } else {
      TripleRoutine<Range, std::int64_t>(range_, surface_, values, -kExactIntegers, kExactIntegers,
                                         hints)
          .run();
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if constexpr (!Range::kEncodes)
        for (std::size_t v = 0; v < values.size(); ++v)
          points_[v][axis] = checked_number(axes_[axis].form, values[v][axis]);
      code_exceptions(axes_[axis].exceptions, axis);
    }
  }

 private:
  void code_form(Axis& axis) {
    axis.form.form =
        static_cast<Form>(code_bits(range_, static_cast<std::uint32_t>(axis.form.form), 2));
    if (axis.form.form == Form::decimal || axis.form.form == Form::float_decimal)
      axis.form.exponent = code_below(range_, axis.form.exponent, kPowers.size());
  }
  void code_exceptions(std::vector<Index>& list, std::size_t axis) {
    SmallNumber count, gap;
    const std::uint32_t n = count.code(range_, static_cast<std::uint32_t>(list.size()));
    std::uint64_t v = 0;
    for (std::uint32_t i = 0; i < n; ++i, ++v) {
      v += gap.code(range_, Range::kEncodes ? static_cast<std::uint32_t>(list[i] - v) : 0);
      if (v >= points_.size()) throw StreamError("has an exception beyond the last vertex");
      double& x = points_[v][axis];
      x = std::bit_cast<double>(LargeNumber::code_lower(range_, bits_of(x), 64));
    }
  }

  Range& range_;
  const Surface& surface_;
  std::span<Point> points_;
  std::array<Axis, 3> axes_;
};

template <class Range>
void code_multiples(Range& range, const Surface& surface, std::span<Triple> values, double& step,
                    std::array<Hint, 3> hints) {
  step = std::bit_cast<double>(LargeNumber::code_lower(range, bits_of(step), 64));
  if (!std::isnormal(step) || step < 0 || bits_of(step) << (64 - kLowBits) != 0)
    throw StreamError("has a step that is no positive number of 20 bits");
  TripleRoutine<Range, std::int64_t>(range, surface, values, -kMostMultiple + 1, kMostMultiple - 1,
                                     hints)
      .run();
}

/// Few values, far from filling their range? A sample does not tell: the values of a scan may recur
/// only late in the file.
bool worth_a_table(std::span<const Triple> values, std::size_t axis) {
  std::vector<std::int64_t> all;
  for (const Triple& value : values) all.push_back(value[axis]);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const auto range =
      static_cast<std::uint64_t>(all.back()) - static_cast<std::uint64_t>(all.front());
  return 2 * all.size() <= values.size() && all.size() <= range / 2 + 1;
}

/// Which hints may pay on an axis.
std::vector<Hint> plausible(const Surface& surface, std::span<const Triple> values,
                            std::size_t axis) {
  std::vector<Hint> hints;
  if (worth_a_table(values, axis)) hints.push_back(Hint::table);
  std::size_t equal = 0;
  for (Index h = 0; h < 3 * surface.face_count(); ++h)
    equal += values[surface.from(h)][axis] == values[surface.to(h)][axis] ? 1 : 0;
  if (4 * equal >= 3 * std::size_t{surface.face_count()}) hints.push_back(Hint::repeats);
  return hints;
}

/// The smallest of the encodings with hints, tried axis by axis.
template <class Encode>
Bytes smallest(const Surface& surface, std::span<const Triple> values, const Encode& encode) {
  std::array<Hint, 3> hints{};
  Bytes best = encode(hints);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Hint before = hints[axis];
    Hint kept = before;
    for (const Hint hint : plausible(surface, values, axis)) {
      hints[axis] = hint;
      if (Bytes bytes = encode(hints); bytes.size() < best.size()) {
        best = std::move(bytes);
        kept = hint;
      }
    }
    hints[axis] = kept;
  }
  return best;
}

}  // namespace

Bytes encode_exact(const Surface& decoded, std::span<const Point> points) {
  std::array<Axis, 3> axes;
  std::vector<Triple> values(points.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes[axis] = choose_form(points, axis);
    for (std::size_t v = 0; v < points.size(); ++v)
      values[v][axis] = integer(axes[axis].form, points[v][axis]);
  }
  std::vector<Point> copy(points.begin(), points.end());
  return smallest(decoded, values, [&](std::array<Hint, 3> hints) {
    RangeEncoder range;
    ExactRoutine(range, decoded, std::span<Point>(copy), axes).run(values, hints);
    return range.finish();
  });
}

std::vector<Point> decode_exact(std::span<const std::uint8_t> bytes, const Surface& decoded) {
  std::vector<Point> points(decoded.counts().vertices);
  RangeDecoder range(bytes);
  std::vector<Triple> values(points.size());
  with_position(range, [&] {
    ExactRoutine(range, decoded, std::span<Point>(points), {}).run(values, {});
    range.finish();
  });
  for (const Point& p : points)
    for (const double x : p)
      if (!std::isfinite(x)) throw StreamError("has a coordinate that is not finite");
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
