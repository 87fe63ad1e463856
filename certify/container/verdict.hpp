// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the checkers are asked, and what they answer.
#include <optional>
#include <stdexcept>

#include "certify/certificate.hpp"

namespace crest::certify {

enum class Arithmetic {
  doubles,  ///< double with derived bounds, guarded intervals; rationals and MPFR where undecided
  mpfr      ///< MPFR directed rounding for every sign and angle; rationals where undecided
};

struct VerifyOptions {
  Arithmetic arithmetic = Arithmetic::doubles;
  std::optional<std::string> input;  ///< a mesh file the data must agree with
};

/// How often each stage was reached.
struct SignCounts {
  std::uint64_t calls = 0, interval = 0, exact = 0;
};
struct AngleCounts {
  std::uint64_t edges = 0, mpfr_edges = 0, ties = 0, mpfr_faces = 0;
};

struct Verdict {
  bool accepted = false;
  bool undecided = false;          ///< rejected only because a number could not be enclosed
  std::vector<std::string> lines;  ///< one per claim proved, in order
  std::string reason;              ///< why not accepted; empty otherwise
  std::optional<Digest> data;      ///< digest of the data section, as recomputed
  SignCounts signs;
  AngleCounts angles;
};

/// The comparison with an input file cannot be made for this format.
class TieUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// The input file cannot be read as a mesh.
class InputUnreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace crest::certify
