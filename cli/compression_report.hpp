// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `compress` says about its result.
#include <string>

#include "algorithms/vector_fields/compression_result.hpp"
#include "cli/report.hpp"

namespace crest::cli {

void report_compression(Report& report, const vector_fields::PlanarField& field,
                        const vector_fields::CompressionOptions& options,
                        const vector_fields::Compression& result);

std::string compression_summary(const vector_fields::PlanarField& field,
                                const vector_fields::Compression& result);

}  // namespace crest::cli
