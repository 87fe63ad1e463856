// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of expressions: any text gives a program or an error with a column.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "kernel/expressions/evaluate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto expression = crest::kernel::Expression::parse(text, {"x", "y", "z"});
    const double at[] = {0.5, -2, 3};
    crest::kernel::double_evaluator(expression)(at);
  } catch (const crest::kernel::ExpressionError& error) {
    if (error.column() < 1 || error.column() > size + 1) abort();
  }
  return 0;
}
