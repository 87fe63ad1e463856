// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report and the summary of crest skeleton.
#include <string>

#include "algorithms/vector_fields/importance.hpp"
#include "cli/report.hpp"

namespace crest::cli {

/// The keys of `skeleton`; importance: its weights or none.
Json skeleton_in_words(const vector_fields::PlanarField& field,
                       const vector_fields::Skeleton& skeleton,
                       const vector_fields::Importance* importance = nullptr);

/// What `simplify` says of weights, split at a threshold.
Json importance_in_words(const vector_fields::Importance& importance, double threshold,
                         vector_fields::Laplacian laplacian);

std::string importance_summary(const vector_fields::Importance& importance, double threshold);

std::string skeleton_summary(const vector_fields::Skeleton& skeleton);

/// Separatrices without a named end.
std::size_t undecided_count(const vector_fields::Skeleton& skeleton);

}  // namespace crest::cli
