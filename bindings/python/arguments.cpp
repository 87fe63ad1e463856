// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/arguments.hpp"

#include <fmt/format.h>

#include <limits>

#include "certify/certificate.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::python {

bool Arguments::has(const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() && !std::holds_alternative<std::monostate>(found->second);
}

int Arguments::integer(const std::string& name) const {
  const std::int64_t x = std::get<std::int64_t>(at(name));
  if (x < std::numeric_limits<int>::min() || x > std::numeric_limits<int>::max())
    throw kernel::InputError(fmt::format("{}: {} is out of range; give a smaller number", name, x));
  return static_cast<int>(x);
}

double Arguments::number(const std::string& name) const {
  const Value& value = at(name);
  const auto* const whole = std::get_if<std::int64_t>(&value);
  return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

void Arguments::require_indices(const std::string& name, const std::vector<std::int64_t>& x,
                                std::size_t width, std::size_t count) {
  if (count >= kernel::kNone || x.size() / width >= kernel::kNone / 3)
    throw kernel::InputError(name + ": has more elements than 32-bit indices can name; cut it up");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < 0)
      throw kernel::InputError(
          fmt::format("{}[{}]: names vertex {}; count from 0", name, i / width, x[i]));
    if (x[i] >= static_cast<std::int64_t>(count))
      throw kernel::InputError(fmt::format("{}[{}]: names vertex {}, there are {}; count from 0",
                                           name, i / width, x[i], count));
  }
}

std::string Output::certify(std::vector<std::uint8_t> bytes) {
  certificate = std::move(bytes);
  return certify::hex(certify::data_digest(certificate));
}

}  // namespace crest::python
