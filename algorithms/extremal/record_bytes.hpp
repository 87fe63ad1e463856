// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Records as bytes, to be sent to another process of the same program or kept for a restart.
#include <span>

#include "algorithms/extremal/records.hpp"

namespace crest::extremal {

std::vector<std::uint8_t> to_bytes(const Records& records);
/// Throws std::runtime_error if the bytes end before the records do, or behind them.
Records records_from(std::span<const std::uint8_t> bytes);

}  // namespace crest::extremal
