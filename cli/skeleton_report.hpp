// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report and the summary of crest skeleton.
#include <string>

#include "algorithms/vector_fields/skeleton_result.hpp"
#include "cli/report.hpp"

namespace crest::cli {

/// The keys of `skeleton`.
Json skeleton_in_words(const vector_fields::PlanarField& field,
                       const vector_fields::Skeleton& skeleton);

std::string skeleton_summary(const vector_fields::Skeleton& skeleton);

/// Separatrices without a named end.
std::size_t undecided_count(const vector_fields::Skeleton& skeleton);

}  // namespace crest::cli
