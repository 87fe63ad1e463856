// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a call hands over and gets back, free of Python: a system's source sees nothing else, so
// that only module.cpp is compiled against Python's headers and all work goes on without its lock.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/write/geometry.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"
#include "kernel/geometry/sampled_grid.hpp"

namespace crest::python {

/// A copy of an array, the last index fastest.
struct Array {
  std::vector<std::size_t> shape;
  kernel::SampledGrid::Samples data;

  std::size_t rows() const { return shape.empty() ? 0 : shape[0]; }
};

using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                           std::vector<double>, std::vector<std::string>, Array>;

/// Keyword arguments by name. The package's functions have checked their types and shapes; asking
/// for another type throws std::bad_variant_access, a bug.
class Arguments {
 public:
  explicit Arguments(std::map<std::string, Value> values) : values_(std::move(values)) {}

  /// Whether it is given and not None.
  bool has(const std::string& name) const;
  bool flag(const std::string& name) const { return std::get<bool>(at(name)); }
  int integer(const std::string& name) const;
  /// Of a number of either type.
  double number(const std::string& name) const;
  const std::string& text(const std::string& name) const { return std::get<std::string>(at(name)); }
  const std::vector<double>& numbers(const std::string& name) const {
    return std::get<std::vector<double>>(at(name));
  }
  const std::vector<std::string>& texts(const std::string& name) const {
    return std::get<std::vector<std::string>>(at(name));
  }
  const Array& array(const std::string& name) const { return std::get<Array>(at(name)); }
  std::optional<double> maybe_number(const std::string& name) const {
    return has(name) ? std::optional(number(name)) : std::nullopt;
  }

  /// N numbers.
  template <std::size_t N>
  std::optional<std::array<double, N>> maybe_numbers(const std::string& name) const {
    if (!has(name)) return std::nullopt;
    std::array<double, N> x{};
    std::copy_n(numbers(name).begin(), N, x.begin());
    return x;
  }
  /// (n, N) doubles as n points.
  template <std::size_t N>
  std::vector<std::array<double, N>> rows(const std::string& name) const {
    const auto& x = std::get<std::vector<double>>(array(name).data);
    std::vector<std::array<double, N>> out(x.size() / N);
    for (std::size_t i = 0; i < x.size(); ++i) out[i / N][i % N] = x[i];
    return out;
  }
  /// (m, N) integers as cells of `count` points. Throws: kernel::InputError for an index that is
  /// negative or not below `count`.
  template <std::size_t N>
  std::vector<std::array<kernel::Index, N>> cells(const std::string& name,
                                                  std::size_t count) const {
    const auto& x = std::get<std::vector<std::int64_t>>(array(name).data);
    require_indices(name, x, N, count);
    std::vector<std::array<kernel::Index, N>> out(x.size() / N);
    for (std::size_t i = 0; i < x.size(); ++i) out[i / N][i % N] = static_cast<kernel::Index>(x[i]);
    return out;
  }

 private:
  const Value& at(const std::string& name) const { return values_.at(name); }
  static void require_indices(const std::string& name, const std::vector<std::int64_t>& x,
                              std::size_t width, std::size_t count);

  std::map<std::string, Value> values_;
};

/// What a system gives: what its .vtp file would hold, and more, by name.
struct Output {
  std::map<std::string, io::Geometry> geometries;
  std::map<std::string, Value> values;
  std::vector<std::uint8_t> certificate;  ///< empty: none
  std::vector<std::string> warnings;

  /// Keeps a certificate, and returns its data digest in hexadecimal.
  std::string certify(std::vector<std::uint8_t> bytes);
};

/// An (n, N) array of doubles.
template <std::size_t N>
Array array_of(const std::vector<std::array<double, N>>& rows) {
  std::vector<double> x;
  x.reserve(rows.size() * N);
  for (const auto& row : rows) x.insert(x.end(), row.begin(), row.end());
  return {{rows.size(), N}, std::move(x)};
}
/// An (n, N) array of indices.
template <std::size_t N>
Array array_of(const std::vector<std::array<kernel::Index, N>>& rows) {
  std::vector<std::int64_t> x;
  x.reserve(rows.size() * N);
  for (const auto& row : rows) x.insert(x.end(), row.begin(), row.end());
  return {{rows.size(), N}, std::move(x)};
}
inline Array array_of(std::vector<double> x) {
  return {{x.size()}, std::move(x)};
}
inline Array array_of(const std::vector<kernel::Index>& x) {
  return {{x.size()}, std::vector<std::int64_t>(x.begin(), x.end())};
}
inline Array array_of(std::vector<std::uint8_t> x) {
  return {{x.size()}, std::move(x)};
}

}  // namespace crest::python
