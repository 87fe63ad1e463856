// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vertices of a level's trees: those of the mesh, and those that cut an edge (a, b) at
// (64 - n) / 64 a + n / 64 b, with their tensors and the signs of f and det there.
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "algorithms/modes/level.hpp"
#include "algorithms/modes/tensors.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::modes {

using kernel::Index;

struct Cut {
  Index a, b;
  std::uint8_t n;  ///< 1 .. 63
};

class Vertices {
 public:
  /// The mesh's vertices come first. Every tensor is scaled by 2^-scale.
  Vertices(std::span<const Symmetric> tensors, int scale, const Level& level);

  Index size() const { return static_cast<Index>(tensors_.size()); }
  Index mesh_size() const { return mesh_size_; }
  bool is_cut(Index v) const { return v >= mesh_size_; }
  /// Requires: is_cut(v).
  const Cut& cut(Index v) const { return cuts_[v - mesh_size_]; }
  const std::vector<Cut>& cuts() const { return cuts_; }

  Index add(Index a, Index b, std::uint8_t n);

  const Deviator& tensor(Index v) const { return tensors_[v]; }
  bool is_zero(Index v) const { return v < mesh_size_ && is_isotropic(given_[v]); }
  /// Finds the signs at all vertices of the mesh, by all threads: many faces ask for each.
  void find_signs();
  /// Requires: not is_zero(v). Several threads may ask.
  PointSigns signs(Index v) { return v < signs_.size() ? signs_[v] : signs_at(v); }

  /// Exactly, times one power of two for all. Several threads may ask.
  template <std::size_t N>
  std::array<Entries<kernel::Integer>, N> exact(const std::array<Index, N>& vertices) {
    std::array<ExactTensor, N> t;
    {
      const std::lock_guard lock(*mutex_);
      for (std::size_t i = 0; i < N; ++i) t[i] = exact_one(vertices[i]);
    }
    return aligned(std::move(t));
  }

 private:
  template <std::size_t N>
  static std::array<Entries<kernel::Integer>, N> aligned(std::array<ExactTensor, N> t) {
    long low = t[0].exponent;
    for (const ExactTensor& x : t) low = std::min(low, x.exponent);
    std::array<Entries<kernel::Integer>, N> r;
    for (std::size_t i = 0; i < N; ++i) {
      r[i] = std::move(t[i].t);
      for (auto& x : r[i]) x <<= static_cast<unsigned long>(t[i].exponent - low);
    }
    return r;
  }
  const ExactTensor& exact_one(Index v);
  PointSigns signs_at(Index v);
  PointSigns exact_signs(Index v);
  std::span<const Symmetric> given_;
  int scale_;
  Level level_;
  Index mesh_size_;
  std::vector<Deviator> tensors_;
  std::vector<Cut> cuts_;
  std::vector<PointSigns> signs_;  ///< of the mesh's vertices, after find_signs()
  // What was asked for, under the mutex.
  std::unordered_map<Index, ExactTensor> exact_;
  std::unordered_map<Index, PointSigns> exact_signs_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
};

}  // namespace crest::modes
