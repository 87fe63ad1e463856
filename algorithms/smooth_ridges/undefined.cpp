// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/undefined.hpp"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace crest::smooth_ridges {
namespace {

using kernel::Expression;
using kernel::Interval;
using kernel::Operation;
using Code = Operation::Code;

/// What evaluation of an expression over a cell shows.
struct Finding {
  std::optional<std::size_t> undefined;  ///< the first step whose value is not defined
  bool nowhere = false;                  ///< and it is defined at no point of the cell
  std::optional<std::size_t> rough;      ///< the first whose derivatives are not
  Interval value;                        ///< if defined
};

/// One expression on cells of `Variables` intervals, step by step.
template <int Variables>
class StepByStep {
 public:
  using Cell = std::array<Interval, Variables>;

  explicit StepByStep(const Expression& e) : e_(e) {}

  Finding operator()(const Cell& cell) {
    stack_.clear();
    for (std::size_t k = 0; k < Variables; ++k) {
      const Interval& x = cell[k];
      middle_[k] = Interval(std::clamp(x.inf() / 2 + x.sup() / 2, x.inf(), x.sup()));
      offset_[k] = x - middle_[k];
    }
    Finding found;
    for (std::size_t i = 0; i < e_.program().size(); ++i) {
      nowhere_ = false;
      run(e_.program()[i], cell);
      Value& top = stack_.back();
      top.place = e_.places()[i];
      if (!is_defined(top.over)) {
        found.undefined = i;
        found.nowhere = nowhere_;
        return found;
      }
      if (!sharpen(top) && !found.rough) found.rough = i;
    }
    found.value = stack_.back().over[0];
    return found;
  }

 private:
  using Field = kernel::Jet<Interval, Variables, 1>;
  /// A part of the expression: over the cell, and at its middle.
  struct Value {
    Field over;
    Interval middle;
    Expression::Place place{};
  };

  /// By mean values; false if a derivative is not defined.
  bool sharpen(Value& x) const {
    Interval mean = x.middle;
    for (std::size_t k = 0; k < Variables; ++k) {
      // Of degree one the last variable comes first.
      const Interval& slope = x.over[Variables - k];
      if (!is_defined(slope)) return false;
      mean = mean + slope * offset_[k];
    }
    const Interval& plain = x.over[0];
    const double low = std::max(plain.inf(), mean.inf()), high = std::min(plain.sup(), mean.sup());
    if (is_defined(mean) && low <= high) x.over.set(0, Interval(low, high));
    return true;
  }

  void run(const Operation& o, const Cell& cell) {
    const auto argument = static_cast<std::size_t>(o.argument);
    if (o.code == Code::constant) {
      const Interval c = kernel::as_interval(e_.constants()[argument]);
      return stack_.push_back({Field::constant(c), c});
    }
    if (o.code == Code::variable)
      return stack_.push_back(
          {Field::variable(static_cast<int>(argument), cell[argument]), middle_[argument]});
    if (o.code >= Code::add && o.code <= Code::divide) {
      const Value b = std::move(stack_.back());
      stack_.pop_back();
      return binary(o.code, stack_.back(), b);
    }
    Value& a = stack_.back();
    if (o.code == Code::power) return power(a, o.argument);
    if (o.code == Code::negate) {
      a = {-a.over, -a.middle};
      return;
    }
    const Interval& x = a.over[0];
    nowhere_ = (o.code == Code::log && x.sup() <= 0) || (o.code == Code::sqrt && x.sup() < 0);
    a = {kernel::ElementaryFunctions<Field>::apply(o.code, a.over),
         kernel::ElementaryFunctions<Interval>::apply(o.code, a.middle)};
  }

  void binary(Code code, Value& a, const Value& b) {
    switch (code) {
      case Code::add:
        a = {a.over + b.over, a.middle + b.middle};
        return;
      case Code::subtract:
        a = {a.over - b.over, a.middle - b.middle};
        return;
      case Code::multiply: {
        const bool square = text(a.place) == text(b.place);
        a = {a.over * b.over, a.middle * b.middle};
        if (square) not_negative(a);
        return;
      }
      default:
        nowhere_ = is_zero(b.over[0]);
        a = {a.over / b.over, a.middle / b.middle};
    }
  }

  void power(Value& a, std::int32_t n) {
    const Field one = Field::constant(Interval(1));
    nowhere_ = n < 0 && is_zero(a.over[0]);
    Value r{one, Interval(1)}, square = a;
    for (auto left = static_cast<unsigned>(std::abs(n)); left != 0; left /= 2) {
      if (left % 2 != 0) r = {r.over * square.over, r.middle * square.middle};
      if (left > 1) square = {square.over * square.over, square.middle * square.middle};
    }
    if (n % 2 == 0) not_negative(r);
    if (n < 0) r = {one / r.over, Interval(1) / r.middle};
    a = r;
  }

  static bool is_zero(const Interval& x) { return x.inf() == 0 && x.sup() == 0; }
  static void not_negative(Value& x) {
    const Interval& v = x.over[0];
    if (is_defined(v) && v.inf() < 0) x.over.set(0, Interval(0, std::max(v.sup(), 0.0)));
  }
  std::string_view text(const Expression::Place& p) const {
    return std::string_view(e_.text()).substr(p.begin, p.end - p.begin);
  }

  const Expression& e_;
  std::vector<Value> stack_;
  std::array<Interval, Variables> middle_{}, offset_{};
  bool nowhere_ = false;
};

template <int Variables>
class UndefinedSearch {
 public:
  using Cell = typename StepByStep<Variables>::Cell;

  UndefinedSearch(const Surface& surface, Cell domain) : surface_(surface), domain_(domain) {
    for (const Expression& e : surface.functions()) steps_.emplace_back(e);
  }

  std::optional<Undefined> run() {
    {
      const kernel::RoundUpward guard;
      visit(domain_, 0);
    }
    if (found_) describe(surface_.functions()[expression_], step_);
    return found_;
  }

 private:
  static constexpr int kDeepest = 42 * Variables, kDeepestNowhere = 8;
  static constexpr std::size_t kBudget = 100000;

  /// The expression and step that stop the proof on the cell.
  struct Obstacle {
    std::size_t expression, step;
    bool nowhere;
  };
  std::optional<Obstacle> evaluate(const Cell& cell) {
    ++evaluations_;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const Finding f = steps_[k](cell);
      if (f.undefined) return Obstacle{k, *f.undefined, f.nowhere};
      const bool matters = !surface_.is_implicit() || (f.value.inf() <= 0 && f.value.sup() >= 0);
      if (f.rough && matters) return Obstacle{k, *f.rough, false};
    }
    return std::nullopt;
  }

  /// False if the search is over.
  bool visit(const Cell& cell, int depth) {
    if (evaluations_ >= kBudget) return false;
    const auto obstacle = evaluate(cell);
    if (!obstacle) return true;
    if (obstacle->nowhere || depth == kDeepest) {
      report(cell, *obstacle);
      return false;
    }
    const auto [lower, upper] = halves(cell);
    return visit(lower, depth + 1) && visit(upper, depth + 1);
  }

  std::array<Cell, 2> halves(const Cell& cell) const {
    std::size_t axis = 0;
    double longest = -1;
    for (std::size_t k = 0; k < Variables; ++k) {
      const double size = (cell[k].sup() - cell[k].inf()) / (domain_[k].sup() - domain_[k].inf());
      if (size > longest) longest = size, axis = k;
    }
    std::array<Cell, 2> r = {cell, cell};
    const double middle = cell[axis].inf() / 2 + cell[axis].sup() / 2;
    r[0][axis] = Interval(cell[axis].inf(), middle);
    r[1][axis] = Interval(middle, cell[axis].sup());
    return r;
  }

  bool is_nowhere(const Cell& cell, int depth) {
    const auto obstacle = evaluate(cell);
    if (!obstacle || obstacle->nowhere) return obstacle.has_value();
    if (depth == kDeepestNowhere) return false;
    const auto [lower, upper] = halves(cell);
    return is_nowhere(lower, depth + 1) && is_nowhere(upper, depth + 1);
  }

  void report(const Cell& cell, const Obstacle& obstacle) {
    Undefined u;
    u.extent = is_nowhere(domain_, 0) ? Undefined::Extent::nowhere
               : obstacle.nowhere     ? Undefined::Extent::here
                                      : Undefined::Extent::perhaps;
    for (std::size_t k = 0; k < Variables; ++k) u.where[k] = cell[k].inf() / 2 + cell[k].sup() / 2;
    expression_ = obstacle.expression;
    step_ = obstacle.step;
    found_ = u;
  }

  void describe(const Expression& e, std::size_t step);

  const Surface& surface_;
  Cell domain_;
  std::vector<StepByStep<Variables>> steps_;
  std::size_t evaluations_ = 0, expression_ = 0, step_ = 0;
  std::optional<Undefined> found_;
};

/// "column C: PART WHAT (in NAME = TEXT)"
std::string line(const Undefined& u, const Expression& e, std::size_t step,
                 const std::string& what) {
  const auto& [begin, end] = e.places()[step];
  return "column " + std::to_string(u.column) + ": " + e.text().substr(begin, end - begin) + " " +
         what + " (in " + u.name + " = " + e.text() + ")";
}

template <int Variables>
void UndefinedSearch<Variables>::describe(const Expression& e, std::size_t step) {
  Undefined& u = *found_;
  u.column = e.places()[step].begin + 1;
  u.name = surface_.is_implicit() ? "F" : std::string(1, "xyz"[expression_]);
  char place[128];
  if constexpr (Variables == 3)
    std::snprintf(place, sizeof place, "(x, y, z) = (%.6g, %.6g, %.6g)", u.where[0], u.where[1],
                  u.where[2]);
  else
    std::snprintf(place, sizeof place, "(u, v) = (%.6g, %.6g)", u.where[0], u.where[1]);
  std::string what;
  if (u.extent == Undefined::Extent::nowhere)
    what = std::string("is defined nowhere in the ") + (Variables == 3 ? "box" : "domain");
  else if (u.extent == Undefined::Extent::here)
    what = std::string("is not defined at ") + place;
  else
    what = std::string("is not proven to be defined and smooth near ") + place;
  u.text = line(u, e, step, what);
}

}  // namespace

std::optional<Undefined> find_undefined(const Surface& surface) {
  if (surface.is_implicit()) {
    const auto& b = surface.box();
    return UndefinedSearch<3>(surface,
                              {Interval(b[0], b[1]), Interval(b[2], b[3]), Interval(b[4], b[5])})
        .run();
  }
  std::array<Interval, 2> domain;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto bound = [&](std::size_t i) {
      return kernel::mp_jet_evaluator<1, 0>(surface.domain()[i], 106)({})[0];
    };
    domain[k] = Interval(bound(2 * k).lower(), bound(2 * k + 1).upper());
  }
  return UndefinedSearch<2>(surface, domain).run();
}

std::optional<Undefined> find_undefined(const Expression& constant, const std::string& name) {
  const kernel::RoundUpward guard;
  const Finding f = StepByStep<1>(constant)({Interval(0)});
  if (!f.undefined) return std::nullopt;
  Undefined u{Undefined::Extent::nowhere, constant.places()[*f.undefined].begin + 1, name, {}, {}};
  u.text = line(u, constant, *f.undefined, "is not defined");
  return u;
}

}  // namespace crest::smooth_ridges
