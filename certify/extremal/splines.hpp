// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The coefficients on the grid that a claim is about. Where that is the samples' grid halved, and
// large, they are made a block at a time and thrown away: a file that halves its grid three times
// may not cost 512 times its memory.
#include "certify/container/parallel.hpp"
#include "certify/extremal/fields.hpp"

namespace crest::certify::extremal {

/// Coefficients of some nodes of the grid: for those of one block all that is within reach.
struct Window {
  const Fields* fields;
  Place first;  ///< the window's first node in the whole grid

  /// In the window, the node of the whole grid.
  u32 node(const Grid& whole, u32 of) const {
    if (fields->grid.count == whole.count) return of;
    const Place p = whole.place(of);
    const auto& stride = fields->grid.stride;
    return (p[0] - first[0]) + (p[1] - first[1]) * stride[1] + (p[2] - first[2]) * stride[2];
  }
};

class Splines {
 public:
  /// Halved as often as the data say. A grid of at most so many nodes is held as a whole.
  Splines(const ExtremalData& data, u32 most_whole = 1U << 21);

  const Grid& grid() const { return grid_; }
  bool hessian() const { return fields_.hessian; }
  bool is_whole() const { return halvings_ == 0; }

  u32 blocks() const { return counts_[0] * counts_[1] * counts_[2]; }
  u32 block_of(u32 node) const;
  /// The lowest and the highest node of the block's cells.
  std::array<Place, 2> corners(u32 block) const;
  /// Is L below the level on all of the block, as its coefficients on the samples' grid are?
  bool is_low(u32 block, float level) const;
  /// Calls work(window).
  template <class Work>
  void with_window(u32 block, bool tensors, const Work& work) const {
    if (is_whole()) return work(Window{&fields_, {0, 0, 0}});
    Place first{};
    const Fields part = make_window(block, tensors, first);
    work(Window{&part, first});
  }
  /// Calls body(worker, window, i) for i < count in any order, node_of(i) being in the grid; every
  /// window has a worker made by make(fields).
  template <class NodeOf, class Make, class Body>
  void for_items(size_t count, size_t batch, const NodeOf& node_of, const Make& make,
                 const Body& body) const {
    if (is_whole()) {
      const Window window{&fields_, {0, 0, 0}};
      return parallel_for((count + batch - 1) / batch, [&] { return make(fields_); },
                          [&](auto& worker, size_t i) {
                            const size_t end = std::min(count, (i + 1) * batch);
                            for (i *= batch; i < end; ++i) body(worker, window, i);
                          });
    }
    std::vector<u32> starts(blocks() + 1, 0), order(count);
    for (size_t i = 0; i < count; ++i) ++starts[block_of(node_of(i)) + 1];
    for (u32 b = 0; b < blocks(); ++b) starts[b + 1] += starts[b];
    std::vector<u32> next(starts.begin(), starts.end() - 1);
    for (size_t i = 0; i < count; ++i) order[next[block_of(node_of(i))]++] = static_cast<u32>(i);
    parallel_for(
        blocks(), [] { return 0; },
        [&](int, size_t at) {
          const auto b = static_cast<u32>(at);
          if (starts[b] == starts[b + 1]) return;
          with_window(b, true, [&](const Window& window) {
            auto worker = make(*window.fields);
            for (u32 i = starts[b]; i < starts[b + 1]; ++i) body(worker, window, order[i]);
          });
        });
  }

 private:
  /// The samples' nodes, first and last along each axis, of which the block's coefficients are
  /// made.
  std::array<Place, 2> reach(u32 block) const;
  Fields make_window(u32 block, bool tensors, Place& first) const;

  Fields fields_;      ///< whole, or on the samples' grid
  unsigned halvings_;  ///< of them, still to be done
  Grid grid_;
  Place counts_{1, 1, 1};  ///< blocks along each axis
};

}  // namespace crest::certify::extremal
