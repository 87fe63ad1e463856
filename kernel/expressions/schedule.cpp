// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/expressions/schedule.hpp"

#include <map>
#include <tuple>

namespace crest::kernel {
namespace {

using Code = Operation::Code;
using Operand = Schedule::Operand;
using Kind = Operand::Kind;

class Scheduler {
 public:
  void add(const Expression& expression) {
    std::vector<Operand> stack;
    for (const Operation& o : expression.program()) {
      const auto argument = static_cast<std::size_t>(o.argument);
      if (o.code == Code::constant) {
        stack.push_back(constant(expression.constants()[argument]));
      } else if (o.code == Code::variable) {
        stack.push_back({Kind::variable, argument});
      } else if (is_binary(o.code)) {
        const Operand last = stack.back();
        stack.pop_back();
        stack.back() = step(o.code, stack.back(), last);
      } else if (o.code == Code::power) {
        stack.back() = integer_power(stack.back(), o.argument);
      } else {
        stack.back() = step(o.code, stack.back(), stack.back());
      }
    }
    result_.results.push_back(stack.back());
  }

  Schedule finish() {
    constexpr std::size_t kAlways = SIZE_MAX;
    std::vector<std::size_t> last_use(result_.steps.size(), 0);
    const auto use = [&](const Operand& x, std::size_t when) {
      if (x.kind == Kind::step) last_use[x.index] = std::max(last_use[x.index], when);
    };
    for (std::size_t i = 0; i < result_.steps.size(); ++i) {
      use(result_.steps[i].first, i);
      use(result_.steps[i].last, i);
    }
    for (const Operand& x : result_.results) use(x, kAlways);

    std::vector<std::size_t> unused;
    const auto release = [&](const Operand& x, std::size_t when) {
      if (x.kind == Kind::step && last_use[x.index] == when)
        unused.push_back(result_.steps[x.index].place);
    };
    for (std::size_t i = 0; i < result_.steps.size(); ++i) {
      Schedule::Step& s = result_.steps[i];
      if (unused.empty()) unused.push_back(result_.places++);
      s.place = unused.back();
      unused.pop_back();
      release(s.first, i);
      if (s.last != s.first) release(s.last, i);
    }
    return std::move(result_);
  }

 private:
  static bool is_binary(Code code) {
    return code == Code::add || code == Code::subtract || code == Code::multiply ||
           code == Code::divide;
  }

  Operand constant(const Constant& c) {
    const auto [found, added] =
        constants_.try_emplace({c.kind, c.exact}, Operand{Kind::constant, constants_.size()});
    if (added) result_.constants.push_back(c);
    return found->second;
  }
  Operand step(Code code, const Operand& first, const Operand& last) {
    const auto [found, added] =
        steps_.try_emplace({code, first, last}, Operand{Kind::step, steps_.size()});
    if (added) result_.steps.push_back({code, first, last, 0});
    return found->second;
  }
  Operand power(const Operand& x, std::int32_t n) {
    if (n == 1) return x;
    if (n % 2 == 1) return step(Code::multiply, power(x, n - 1), x);
    const Operand half = power(x, n / 2);
    return step(Code::multiply, half, half);
  }
  Operand integer_power(const Operand& x, std::int32_t n) {
    if (n == 0) return step(Code::power, x, x);
    return n > 0 ? power(x, n) : step(Code::divide, Operand{Kind::one, 0}, power(x, -n));
  }

  Schedule result_;
  std::map<std::tuple<Constant::Kind, Rational>, Operand> constants_;
  std::map<std::tuple<Code, Operand, Operand>, Operand> steps_;
};

}  // namespace

Schedule schedule(std::span<const Expression> expressions) {
  Scheduler scheduler;
  for (const Expression& e : expressions) scheduler.add(e);
  return scheduler.finish();
}

}  // namespace crest::kernel
