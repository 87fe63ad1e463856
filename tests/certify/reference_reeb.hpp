// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A second, slow producer of Reeb graph certificates, straight from certify/reeb/SPEC.md in
// rationals: the graph is found by listing the contours between all successive nodes. It knows
// nothing of theorem 6.
#include <optional>

#include "certify/reeb/encode.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "tests/certify/sample_meshes.hpp"

namespace crest::tests {

class ReferenceReeb {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  using Rational = kernel::Rational;

  struct Arc {
    std::uint32_t lower, upper;  ///< positions in critical()
    std::uint32_t node;          ///< the least w with lower -> w crossed
    bool cycle;                  ///< its contours are cycles
    auto operator<=>(const Arc&) const = default;
  };

  /// Of the data alone; claims are not read.
  explicit ReferenceReeb(const certify::ReebCertificate& data);

  /// Do the data meet the requirements? Nothing else may be called if not.
  bool valid() const { return valid_; }
  const std::vector<Arc>& arcs() const { return arcs_; }
  const std::vector<std::uint32_t>& critical() const { return critical_; }
  std::int64_t loops() const;
  const Rational& value(std::uint32_t node) const { return value_[node]; }

  /// With cuts that satisfy theorem 6, chosen at random; `extra`: the part of the other arcs that
  /// is cut too.
  certify::ReebCertificate certificate(Random& random, double extra = 0) const;

  /// Does the claim say what is true of its own data? Cuts may be any that exist.
  static bool is_true(const certify::ReebCertificate& claim);

 private:
  bool check_requirements();
  void find_nodes();
  void find_tiles();
  void cut_face(const Corners& face, const std::array<std::uint32_t, 3>& line, std::size_t f);
  void sort_nodes();
  void find_types();
  void sweep();
  std::vector<bool> choose_cuts(Random& random, double extra) const;

  Rational on_edge(std::size_t edge, const Rational& t) const;
  std::array<Rational, 6> nodal(std::size_t face) const;
  std::uint32_t edge(std::uint32_t a, std::uint32_t b) const;
  bool is_saddle(std::size_t face, std::size_t side) const;

  const std::vector<Corners> faces_;
  certify::ReebCertificate data_;
  bool valid_ = false;
  std::vector<std::array<std::uint32_t, 2>> mesh_edges_;  ///< lexicographic
  std::vector<std::optional<Rational>> line_position_;    ///< an edge
  std::vector<std::uint32_t> line_node_, face_node_;      ///< of an edge, a face; or none
  std::vector<Rational> value_;                           ///< N
  std::vector<Corners> tiles_;
  std::vector<std::uint32_t> order_, rank_, critical_;
  std::vector<std::int64_t> index_;          ///< of critical_
  std::vector<std::uint32_t> multiplicity_;  ///< of critical_; 0 for extrema
  std::uint32_t minima_ = 0, maxima_ = 0, saddles_ = 0, line_count_ = 0, face_count_ = 0;
  std::uint32_t boundary_loops_ = 0, components_ = 0;
  std::vector<Arc> arcs_;
};

}  // namespace crest::tests
