// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/edges.hpp"

#include <algorithm>
#include <optional>

#include "certify/container/reject.hpp"
#include "certify/exact/sturm.hpp"
#include "certify/modes/invariants.hpp"

namespace crest::certify::modes {
namespace {

constexpr std::int8_t kUnknownState = 2;

template <std::size_t n>
int certain_sign(const std::array<double, n>& c, double error) {
  return certainly_above(c[0], error) ? 1 : certainly_below(c[0], error) ? -1 : 0;
}
template <std::size_t n>
int exact_sign(const std::array<Integer, n>& c) {
  return c[0] > 0 ? 1 : c[0] < 0 ? -1 : 0;
}

/// A polynomial along an edge: sum a_i t^i (1 - t)^(d - i).
struct Line {
  std::array<double, 7> a{};
  std::size_t degree = 0;
  double error = 0;

  template <std::size_t d>
  explicit Line(const Form<double, 2, d>& form) : degree(d), error(form.error) {
    std::ranges::copy(form.c, a.begin());
  }
  /// Bernstein ordinates.
  std::array<double, 7> ordinates() const {
    static constexpr std::array<double, 4> kCubic = {1, 3, 3, 1};
    static constexpr std::array<double, 7> kSextic = {1, 6, 15, 20, 15, 6, 1};
    std::array<double, 7> b{};
    for (std::size_t i = 0; i <= degree; ++i) b[i] = a[i] / (degree == 3 ? kCubic[i] : kSextic[i]);
    return b;
  }
  double most() const {
    double x = 0;
    for (const double c : ordinates()) x = std::max(x, std::fabs(c));
    return x;
  }

  /// The sign at a place in [0, 1]; 0 if it is not certain. The powers' sum is at most 1, and so is
  /// that of the powers times binomial coefficients: the terms' sizes add up to most() at most, and
  /// each has at most 2 d + 8 roundings.
  int sign(double t) const {
    const double s = 1 - t;
    double sum = 0, power = 1;
    for (std::size_t i = degree + 1; i-- > 0;) {
      sum = sum * t + a[i] * power;
      power *= s;
    }
    const double bound = widened(error + 24 * kUnit * most());
    return certainly_above(sum, bound) ? 1 : certainly_below(sum, bound) ? -1 : 0;
  }
};

constexpr int kNotKnown = -1;

/// Roots on (0, 1) by Descartes' rule on dyadic parts, all of them simple, none at a part's end;
/// kNotKnown where doubles or some halvings do not tell. An average adds u |b| to the error.
int count_roots(const std::array<double, 7>& b, std::size_t degree, double error, unsigned depth) {
  int changes = 0, last = 0;
  bool certain = true;
  double most = 0;
  for (std::size_t i = 0; i <= degree; ++i) {
    const int sign = certainly_above(b[i], error) ? 1 : certainly_below(b[i], error) ? -1 : 0;
    if (sign == 0 && (i == 0 || i == degree)) return kNotKnown;
    certain &= sign != 0;
    changes += last * sign < 0;
    last = sign;
    most = std::max(most, std::fabs(b[i]));
  }
  if (certain && changes <= 1) return changes;
  if (depth == 0) return kNotKnown;
  std::array<double, 7> low{}, high = b;
  for (std::size_t k = 0; k <= degree; ++k) {
    low[k] = high[0];
    for (std::size_t i = 0; i + k < degree; ++i) high[i] = (high[i] + high[i + 1]) / 2;
  }
  const double after = widened(error + 8 * kUnit * most);
  const int first = count_roots(low, degree, after, depth - 1);
  if (first == kNotKnown) return kNotKnown;
  const int second = count_roots(high, degree, after, depth - 1);
  return second == kNotKnown ? kNotKnown : first + second;
}

int count_roots(const Line& line) {
  return count_roots(line.ordinates(), line.degree, widened(line.error + kUnit * line.most()), 12);
}

/// The sign of f from the tensor at a place, wrong by much less than the line's coefficients; 0
/// if it is not certain.
int sign_there(const LevelContext& context, const EdgeNode& edge, double t) {
  const auto there = invariants<2>(context.field, {edge.first, edge.second}, std::array{1 - t, t});
  if (!there) return 0;
  const auto [det, det_error, norm, norm_error] = *there;
  if (context.level.neutral)
    return certainly_above(det, det_error) ? 1 : certainly_below(det, det_error) ? -1 : 0;
  const double square = context.level.square, most = widened(norm + norm_error);
  const double first = 54 * det * det, second = square * norm * norm * norm;
  const double bound = widened(54 * (2 * std::fabs(det) + det_error) * det_error +
                               3 * square * most * most * norm_error +
                               20 * kUnit * (first + square * most * most * most));
  const double f = first - second;
  return certainly_above(f, bound) ? 1 : certainly_below(f, bound) ? -1 : 0;
}

/// The listed roots of a leaf, against a polynomial.
class ListedRoots {
 public:
  ListedRoots(const LevelContext& context, u32 node)
      : context_(context),
        node_(context.trees.edges[node]),
        roots_(context.stated.roots.data() + node_.root, node_.roots) {}

 protected:
  template <class... Arguments>
  void require_here(bool condition, fmt::format_string<Arguments...> text,
                    Arguments&&... arguments) const {
    if (!condition)
      throw Reject(fmt::format("edge ({}, {}): {}", node_.first, node_.second,
                               fmt::format(text, std::forward<Arguments>(arguments)...)));
  }

  static bool flat(const RootRecord& root) { return root.low == root.high; }
  /// Both roots of a pair at one place.
  bool pair_at(std::size_t i) const {
    return i + 1 < roots_.size() && !flat(roots_[i]) && roots_[i].low == roots_[i + 1].low &&
           roots_[i].high == roots_[i + 1].high;
  }

  void check_order() const {
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      const auto& [low, high, level] = roots_[i];
      require_here(level == 1 || (level == -1 && !context_.level.neutral), "a root of level {}",
                   int{level});
      require_here(0 <= low && low <= high && high <= 1, "an enclosure that is none");
      require_here(low < high || (low == 0 && i == 0) || (low == 1 && i + 1 == roots_.size()),
                   "an enclosure without a width");
      if (i > 0 && !pair_at(i - 1))
        require_here(roots_[i - 1].high <= low, "enclosures that overlap");
    }
  }

  /// The enclosures and the gaps between them, in order.
  void walk(const Sturm& sturm, std::size_t from, std::size_t to) const {
    Place at = place(0);
    int sign = sturm.sign(at);
    for (std::size_t i = from; i < to; ++i) {
      const Place low = place(roots_[i].low), high = place(roots_[i].high);
      const int sign_low = sturm.sign(low), sign_high = sturm.sign(high);
      require_here(sign_low == sign && sign_high != 0,
                   "a root before the enclosure [{}, {}], or at its end", roots_[i].low,
                   roots_[i].high);
      check_gap(sturm, at, low, sign);
      const bool pair = pair_at(i);
      const int count = sturm.distinct(low, high);
      require_here(count == 1 && (pair ? sign < 0 && sign_high < 0 : sign_high == -sign),
                   "no single root in the enclosure [{}, {}]: {} there, signs {} and {}",
                   roots_[i].low, roots_[i].high, count, sign, sign_high);
      i += pair;
      at = high;
      sign = sign_high;
    }
    const Place end = place(1);
    require_here(sturm.sign(end) == sign, "a root outside the enclosures");
    check_gap(sturm, at, end, sign);
  }

  /// No root if f < 0 at the ends; where f > 0, it may be zero, not negative, inside.
  void check_gap(const Sturm& sturm, const Place& low, const Place& high, int sign,
                 unsigned depth = 0) const {
    const int count = sturm.distinct(low, high);
    if (count == 0) return;
    require_here(sign > 0, "a root outside the enclosures");
    if (count == 1) return;
    constexpr unsigned kMostHalvings = 1100;  // below the least distance of doubles
    if (depth == kMostHalvings) throw Undecided("edge: roots that are too close");
    for (const unsigned k : {4U, 3U, 5U, 2U, 6U, 1U, 7U}) {
      const Place middle = between(low, high, k);
      const int there = sturm.sign(middle);
      if (there == 0) continue;
      require_here(there > 0, "a root outside the enclosures");
      check_gap(sturm, low, middle, sign, depth + 1);
      return check_gap(sturm, middle, high, sign, depth + 1);
    }
    throw std::logic_error("a polynomial of degree 6 with seven roots");
  }

  const LevelContext& context_;
  const EdgeNode& node_;
  std::span<const RootRecord> roots_;
};

class EdgeCheck : public ListedRoots {
 public:
  EdgeCheck(const LevelContext& context, u32 node, Worker& worker)
      : ListedRoots(context, node),
        worker_(worker),
        products_(approximate_products<2>(context.field, {node_.first, node_.second})),
        forms_(products_) {}

  void run() {
    ++worker_.counts.calls;
    check_order();
    const bool done = context_.level.neutral ? by_doubles(Line(forms_.cube()))
                                             : by_doubles(Line(forms_.pair(context_.level)));
    if (!done) {
      ++worker_.counts.exact;
      by_integers();
    }
    check_levels();
  }

 private:
  /// Whether doubles tell that the roots are right, with integers for signs next to a root.
  bool by_doubles(const Line& line) {
    const int count = count_roots(line);
    if (count == kNotKnown) return false;
    require_here(static_cast<std::size_t>(count) == roots_.size(), "{} roots listed, {} found",
                 roots_.size(), count);
    for (const RootRecord& root : roots_) {
      if (flat(root)) return false;
      const int low = sign(line, root.low), high = sign(line, root.high);
      if (low == 0 || high == 0) return false;
      require_here(low != high, "no single root in the enclosure [{}, {}]", root.low, root.high);
    }
    // Each enclosure holds an odd number of them, they do not overlap.
    for (std::size_t i = 0; i + 1 < roots_.size(); ++i)
      if (pair_at(i)) return false;
    return true;
  }

  const SimplexForms<Integer, 2>& exact_forms() {
    if (!exact_) {
      exact_products_ = exact_products<2>(worker_.exact, {node_.first, node_.second});
      exact_.emplace(exact_products_);
    }
    return *exact_;
  }

  /// f in integers.
  const std::vector<Integer>& exact_line() {
    if (exact_line_.empty()) {
      if (context_.level.neutral) {
        const auto form = exact_forms().cube();
        exact_line_.assign(form.c.begin(), form.c.end());
      } else {
        const auto form = exact_forms().pair(context_.level);
        exact_line_.assign(form.c.begin(), form.c.end());
      }
    }
    return exact_line_;
  }
  int sign(const Line& line, double t) {
    if (const int certain = line.sign(t); certain != 0) return certain;
    if (const int certain = sign_there(context_, node_, t); certain != 0) return certain;
    return sign_at(exact_line(), place(t));
  }

  void by_integers() {
    const auto& a = exact_line();
    const auto nonzero = [](const Integer& x) { return x != 0; };
    const auto first = std::ranges::find_if(a, nonzero);
    if (first == a.end()) return require_here(roots_.empty(), "f = 0 on it, yet it has roots");
    const auto last = std::find_if(a.rbegin(), a.rend(), nonzero).base();
    const bool before = first != a.begin() && *first < 0;
    const bool after = last != a.end() && *(last - 1) < 0;
    std::size_t from = 0, to = roots_.size();
    const bool listed = to > 0 && flat(roots_[0]) && roots_[0].low == 0;
    require_here(listed == before, "the root next to the first end");
    from += before;
    require_here((to > from && flat(roots_[to - 1])) == after, "the root next to the second end");
    to -= after;
    walk(Sturm({first, last}), from, to);
  }

  /// The levels of the roots are the signs of det where f > 0 beside them.
  void check_levels() {
    State state = context_.state(node_.first, worker_);
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      const State level = roots_[i].level;
      if (state != 0) {
        require_here(level == state, "the level of a root");
        state = 0;
        continue;
      }
      state = level;
      if (i + 1 < roots_.size()) check_between(i);
    }
    require_here(state == context_.state(node_.second, worker_), "the number of roots");
  }

  /// f > 0 between root i and the next.
  void check_between(std::size_t i) {
    if (context_.level.neutral) return;
    const int level = roots_[i].level;
    const bool pair = pair_at(i);
    if (!pair) {
      const int sign = Line(forms_.cube()).sign(roots_[i].high);
      if (sign != 0) return require_here(sign == level, "the level of a root");
    }
    const auto form = exact_forms().cube();
    auto first = form.c.begin(), last = form.c.end();
    while (first != last && *first == 0) ++first;
    while (first != last && *(last - 1) == 0) --last;
    require_here(first != last, "det is zero on it");
    const Sturm cube({first, last});
    const Place low = place(roots_[i].low), high = place(roots_[i].high);
    require_here(cube.sign(high) == level, "the level of a root");
    if (pair)
      require_here(cube.sign(low) == level && cube.distinct(low, high) == 0,
                   "the level of a pair of roots, or a wide enclosure of it");
  }

  Worker& worker_;
  Products<double, 2> products_;
  SimplexForms<double, 2> forms_;
  Products<Integer, 2> exact_products_;
  std::optional<SimplexForms<Integer, 2>> exact_;
  std::vector<Integer> exact_line_;
};

}  // namespace

LevelContext::LevelContext(const ModeLevel& stated_level, const Field& the_field,
                           const Trees& the_trees)
    : stated(stated_level), field(the_field), trees(the_trees), states_(the_field.vertices()) {
  const double mu = static_cast<double>(stated.numerator) / static_cast<double>(stated.denominator);
  const Integer p(stated.numerator), q(stated.denominator);
  level = {mu * mu, p * p, q * q, stated.numerator == 0};
  for (auto& state : states_) state.store(kUnknownState, std::memory_order_relaxed);
}

State LevelContext::state(u32 vertex, Worker& worker) const {
  auto& known = states_[vertex];
  if (const State state = known.load(std::memory_order_relaxed); state != kUnknownState)
    return state;
  const auto products = approximate_products<1>(field, {vertex});
  const SimplexForms<double, 1> forms(products);
  int det = certain_sign(forms.cube().c, forms.cube().error), f = det;
  if (!level.neutral) {
    const auto pair = forms.pair(level);
    f = certain_sign(pair.c, pair.error);
  }
  if (f == 0 || (f > 0 && det == 0)) {
    const auto exact = exact_products<1>(worker.exact, {vertex});
    const SimplexForms<Integer, 1> integers(exact);
    det = exact_sign(integers.cube().c);
    f = level.neutral ? det : exact_sign(integers.pair(level).c);
  }
  const int found = f < 0 ? 0 : level.neutral ? 1 : det;
  known.store(static_cast<State>(found), std::memory_order_relaxed);
  return static_cast<State>(found);
}

int sign_on_edge(const LevelContext& context, u32 node, double t, Worker& worker) {
  const EdgeNode& edge = context.trees.edges[node];
  const std::array<u32, 2> ends = {edge.first, edge.second};
  const auto products = approximate_products<2>(context.field, ends);
  const SimplexForms<double, 2> forms(products);
  const bool neutral = context.level.neutral;
  if (const int sign =
          neutral ? Line(forms.cube()).sign(t) : Line(forms.pair(context.level)).sign(t);
      sign != 0)
    return sign;
  const auto exact = exact_products<2>(worker.exact, ends);
  const SimplexForms<Integer, 2> integers(exact);
  std::vector<Integer> a;
  if (neutral) {
    const auto form = integers.cube();
    a.assign(form.c.begin(), form.c.end());
  } else {
    const auto form = integers.pair(context.level);
    a.assign(form.c.begin(), form.c.end());
  }
  return sign_at(a, place(t));
}

void check_edge(const LevelContext& context, u32 node, Worker& worker) {
  EdgeCheck(context, node, worker).run();
}

}  // namespace crest::certify::modes
