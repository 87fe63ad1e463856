// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Attributes, bit for bit: predicted and coded as positions are (docs/cmc-format.md, "Attributes").
#include <span>
#include <vector>

#include "algorithms/coding/range_coder.hpp"
#include "algorithms/coding/surface.hpp"
#include "kernel/geometry/attribute.hpp"

namespace crest::coding {

/// Throws: kernel::InputError naming the attribute unless it has words for all places of its site,
/// numbers of its type, and zeros where it has none.
void require_sound(const kernel::Attribute& attribute, Index vertices, Index faces);

/// The section's bytes for sound attributes, at least one, in the decoded order.
Bytes encode_attributes(const Surface& decoded, std::span<const kernel::Attribute> attributes);

/// Bit for bit what encode_attributes() was given; more than `max_numbers` numbers are refused
/// before room is made for any.
/// Throws: StreamError; kernel::InputError for so many numbers.
std::vector<kernel::Attribute> decode_attributes(std::span<const std::uint8_t> bytes,
                                                 const Surface& decoded, std::size_t max_numbers);

/// The attribute whose place p is `source[p]` of this one's.
kernel::Attribute rearranged(const kernel::Attribute& attribute, std::span<const Index> source);

}  // namespace crest::coding
