// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/range_coder.hpp"

#include "algorithms/coding/stream_error.hpp"

namespace crest::coding {

void RangeEncoder::shift() {
  const bool carry = low_ >> 32 != 0;
  const auto top = static_cast<std::uint8_t>(low_ >> 24);
  if (carry || top != 0xff) {
    if (held_count_ > 0) {
      bytes_.push_back(static_cast<std::uint8_t>(held_ + (carry ? 1 : 0)));
      for (; held_count_ > 1; --held_count_) bytes_.push_back(carry ? 0x00 : 0xff);
    }
    held_ = top;
    held_count_ = 1;
  } else if (held_count_ > 0) {
    ++held_count_;
  } else {
    // Nothing before it can take a carry, and the first range is below 2^32: there is none.
    bytes_.push_back(top);
  }
  low_ = (low_ & 0x00ffffffu) << 8;
}

Bytes RangeEncoder::finish() {
  for (int zeros = 24; zeros >= 0; zeros -= 8) {
    const std::uint64_t step = std::uint64_t{1} << zeros;
    const std::uint64_t number = (low_ + step - 1) / step * step;
    if (number < low_ + range_) {
      low_ = number;
      break;
    }
  }
  for (int i = 0; i < 5; ++i) shift();
  for (int i = 0; i < 4 && !bytes_.empty() && bytes_.back() == 0; ++i) bytes_.pop_back();
  return std::move(bytes_);
}

RangeDecoder::RangeDecoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
  for (int i = 0; i < 4; ++i) value_ = value_ << 8 | next();
}

std::uint32_t RangeDecoder::missing() {
  if (++past_ > 4) throw StreamError("ends before all is decoded");
  return 0;
}

void RangeDecoder::finish() const {
  if (at_ < bytes_.size()) throw StreamError("has bytes after the last decision");
}

}  // namespace crest::coding
