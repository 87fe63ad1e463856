// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/net_cdf_header.hpp"

#include <array>
#include <cstdint>

#include "io/formats/files.hpp"

namespace crest::io {
namespace {

/// Walks a header: big-endian words; counts have 8 bytes in format 5, offsets also in format 2.
class Header {
 public:
  explicit Header(std::string_view bytes) : left_(bytes), format_(bytes[3]) { skip(4); }

  void walk() {
    count();  // records
    list([&] {
      name();
      count();
    });
    attributes();
    list([&] {
      name();
      const std::uint64_t axes = count();
      for (std::uint64_t i = 0; i < axes; ++i) count();
      attributes();
      word(4);
      count();
      word(format_ == 1 ? 4 : 8);
    });
  }

 private:
  [[noreturn]] static void damaged() {
    fail("file", "its header announces more than it holds", "it is truncated or damaged");
  }
  void skip(std::uint64_t size) {
    if (size > left_.size()) damaged();
    left_.remove_prefix(size);
  }
  std::uint64_t word(std::size_t size) {
    if (size > left_.size()) damaged();
    std::uint64_t x = 0;
    for (std::size_t i = 0; i < size; ++i) x = x << 8U | static_cast<unsigned char>(left_[i]);
    left_.remove_prefix(size);
    return x;
  }
  std::uint64_t count() { return word(format_ == 5 ? 8 : 4); }
  /// Of a list each item has four bytes at least.
  std::uint64_t length() {
    const std::uint64_t n = count();
    if (n > left_.size() / 4) damaged();
    return n;
  }
  void padded(std::uint64_t n, std::uint64_t size) {
    if (n > left_.size() / size) damaged();
    skip((n * size + 3) / 4 * 4);
  }
  void name() { padded(count(), 1); }
  template <class Item>
  void list(const Item& item) {
    word(4);
    for (std::uint64_t n = length(); n > 0; --n) item();
  }
  void attributes() {
    static constexpr std::array<std::uint64_t, 12> kSizes = {1, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    list([&] {
      name();
      const std::uint64_t type = word(4);
      if (type == 0 || type >= kSizes.size()) damaged();
      padded(count(), kSizes[type]);
    });
  }

  std::string_view left_;
  int format_;
};

}  // namespace

bool is_classic_net_cdf(std::string_view bytes) {
  return bytes.size() > 4 && bytes.starts_with("CDF") &&
         (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

void check_classic_net_cdf(std::string_view bytes) {
  Header(bytes).walk();
}

}  // namespace crest::io
