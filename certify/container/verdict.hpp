// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the checkers are asked, and what they answer.
#include <array>
#include <functional>
#include <optional>
#include <stdexcept>

#include "certify/certificate.hpp"

namespace crest::certify {

enum class Arithmetic {
  doubles,  ///< double with derived bounds, guarded intervals; rationals and MPFR where undecided
  mpfr      ///< MPFR directed rounding for every sign and angle; rationals where undecided
};

/// A mesh from elsewhere; how its file was read is no part of any claim.
struct InputMesh {
  std::string name;
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

struct VerifyOptions {
  Arithmetic arithmetic = Arithmetic::doubles;
  std::optional<InputMesh> input;  ///< the data must agree with it
  /// Called with each line of the verdict as soon as it is proved.
  std::function<void(const std::string&)> progress = {};
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
  std::function<void(const std::string&)> progress;  ///< of the options
  std::string reason;                                ///< why not accepted; empty otherwise
  std::optional<Digest> data;                        ///< digest of the data section, as recomputed
  /// Of what files may be compared with: each field, as a claim about it alone has it, if several;
  /// a stream.
  std::vector<Digest> fields;
  SignCounts signs;
  AngleCounts angles;
};

/// The comparison with an input mesh cannot be made for this claim.
class TieUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace crest::certify
