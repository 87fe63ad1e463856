// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/expression.hpp"

#include <algorithm>
#include <cstdlib>

namespace crest::recheck {
namespace {

constexpr std::size_t kWords = 8192, kNumber = 1000;
constexpr int kNesting = 200, kExponent = 1000, kDecimal = 400;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

}  // namespace

class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& variables)
      : text_(text), variables_(variables) {}
  Expression all() {
    sum();
    skip();
    if (at_ < text_.size()) fail("the end");
    return std::move(made_);
  }

 private:
  using Code = Step::Code;
  [[noreturn]] void fail(const std::string& expected) const {
    throw Rejected("expression, column " + std::to_string(at_ + 1) + ": expected " + expected);
  }
  struct Nested {
    explicit Nested(Parser& p) : parser(p) {
      if (++parser.depth_ > kNesting) parser.fail("less nesting");
    }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    ~Nested() { --parser.depth_; }
    Parser& parser;
  };
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void word() {
    if (++words_ > kWords) fail("at most 8192 words");
  }
  void emit(Code code, int argument = 0, Function f = {}) {
    made_.steps_.push_back({code, argument, f});
  }

  void sum() {
    product();
    while (true) {
      if (take('+')) {
        product();
        emit(Code::add);
      } else if (take('-')) {
        word();
        product();
        emit(Code::subtract);
      } else {
        return;
      }
    }
  }
  void product() {
    sign();
    while (true) {
      const bool times = take('*');
      if (!times && !take('/')) return;
      word();
      sign();
      emit(times ? Code::multiply : Code::divide);
    }
  }
  void sign() {
    if (take('+')) {
      const Nested nested(*this);
      sign();
    } else if (take('-')) {
      const Nested nested(*this);
      word();
      sign();
      emit(Code::negate);
    } else {
      power();
    }
  }
  void power() {
    atom();
    if (!take('^')) return;
    word();
    emit(Code::power, exponent());
  }
  int exponent() {
    const Nested nested(*this);
    if (take('+')) return exponent();
    if (take('-')) return -exponent();
    int base = 0;
    if (take('(')) {
      base = exponent();
      if (!take(')')) fail("\")\"");
    } else {
      if (at_ == text_.size() || !is_digit(text_[at_])) fail("an integer");
      for (; at_ < text_.size() && is_digit(text_[at_]); ++at_) {
        base = 10 * base + (text_[at_] - '0');
        if (base > kExponent) fail("an exponent of at most 1000");
      }
    }
    if (!take('^')) return base;
    const int n = exponent();
    if (n < 0 && std::abs(base) != 1) fail("an exponent that is an integer");
    if (base == 0 || base == 1) return n == 0 ? 1 : base;
    if (base == -1) return n % 2 == 0 ? 1 : -1;
    int result = 1;
    for (int k = 0; k < n; ++k) {
      result *= base;
      if (std::abs(result) > kExponent) fail("an exponent of at most 1000");
    }
    return result;
  }

  void atom() {
    skip();
    if (take('(')) return parenthesis();
    if (at_ == text_.size()) fail("a number, a name or \"(\"");
    if (is_digit(text_[at_]) || text_[at_] == '.') return number();
    if (!is_letter(text_[at_])) fail("a number, a name or \"(\"");
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    name(std::string(text_.substr(begin, at_ - begin)));
  }
  void parenthesis() {
    const Nested nested(*this);
    sum();
    if (!take(')')) fail("\")\"");
  }
  void name(const std::string& name) {
    word();
    const auto variable = std::find(variables_.begin(), variables_.end(), name);
    if (variable != variables_.end())
      return emit(Code::variable, static_cast<int>(variable - variables_.begin()));
    if (name == "pi") return emit(Code::pi);
    if (name == "e") return emit(Code::e);
    using Kind = Function::Kind;
    static constexpr std::pair<const char*, Kind> functions[] = {{"sqrt", Kind::sqrt},
                                                                 {"exp", Kind::exp},
                                                                 {"log", Kind::log},
                                                                 {"sin", Kind::sin},
                                                                 {"cos", Kind::cos}};
    for (const auto& [word, kind] : functions)
      if (name == word) {
        if (!take('(')) fail("\"(\"");
        parenthesis();
        return emit(Code::apply, 0, {kind});
      }
    fail("a known name");
  }
  void number() {
    word();
    const std::size_t begin = at_;
    std::string digits;
    long exponent = 0;
    const auto read_digits = [&](std::string& into) {
      const std::size_t first = at_;
      while (at_ < text_.size() && is_digit(text_[at_])) into += text_[at_++];
      return static_cast<long>(at_ - first);
    };
    long count = read_digits(digits);
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      const long fraction = read_digits(digits);
      count += fraction;
      exponent = -fraction;
    }
    if (count == 0) fail("digits");
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      const std::size_t mark = at_++;
      const bool negative = at_ < text_.size() && text_[at_] == '-';
      if (negative || (at_ < text_.size() && text_[at_] == '+')) ++at_;
      std::string written;
      if (read_digits(written) == 0) {
        at_ = mark;
      } else {
        written.erase(0, std::min(written.find_first_not_of('0'), written.size() - 1));
        const long value = written.size() > 6 ? 1000000 : std::stol(written);
        exponent += negative ? -value : value;
      }
    }
    if (at_ - begin > kNumber) fail("a number of at most 1000 characters");
    emit(Code::number, static_cast<int>(made_.numbers_.size()));
    made_.numbers_.push_back(decimal(digits, exponent));
  }
  Rational decimal(const std::string& digits, long exponent) const {
    const std::size_t first = digits.find_first_not_of('0');
    Rational r;
    if (first == std::string::npos) return r;
    const long leading =
        static_cast<long>(digits.size() - first) + exponent;  // 10^(leading - 1) <= r
    if (leading > kDecimal + 1 || leading < 1 - kDecimal) fail("a number between 1e-400 and 1e400");
    fmpz_set_str(fmpq_numref(r.get()), digits.c_str(), 10);
    fmpz_t ten;
    fmpz_init_set_ui(ten, 10);
    fmpz_pow_ui(ten, ten, static_cast<ulong>(std::labs(exponent)));
    if (exponent < 0)
      fmpq_div_fmpz(r.get(), r.get(), ten);
    else
      fmpq_mul_fmpz(r.get(), r.get(), ten);
    fmpz_clear(ten);
    return r;
  }

  std::string_view text_;
  const std::vector<std::string>& variables_;
  std::size_t at_ = 0, words_ = 0;
  int depth_ = 0;
  Expression made_;
};

Expression Expression::parse(std::string_view text, const std::vector<std::string>& variables) {
  return Parser(text, variables).all();
}

Ball Expression::constant(const Step& s) const {
  if (s.code == Step::Code::number) return Ball(number(s));
  Ball b;
  if (s.code == Step::Code::pi)
    arb_const_pi(b.get(), context.precision);
  else
    arb_const_e(b.get(), context.precision);
  return b;
}

}  // namespace crest::recheck
