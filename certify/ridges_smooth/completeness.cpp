// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/box.hpp"
#include "certify/ridges_smooth/sheet.hpp"

namespace crest::certify::smooth {
namespace {

using kernel::Sign;
using u32 = std::uint32_t;

constexpr std::array<double, 3> kA = {8, -5, 2}, kB = {3, 7, -9};
constexpr int kDeepest = 80;

Box box_of(const std::array<double, 6>& b) {
  return {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

class TreeReader {
 public:
  explicit TreeReader(const RidgesSmoothCertificate& c) : tree_(c.tree) {
    cells_.push_back({box_of(c.surface.box), 0});
    while (!cells_.empty()) {
      const Cell cell = cells_.back();
      cells_.pop_back();
      const std::uint8_t code = next();
      require(code <= 6, "tree: unknown code");
      if (code < 3)
        split(cell, code);
      else
        leaves_.push_back({cell.box, code, code == 6 ? index() : 0});
    }
    require(at_ == tree_.size(), "tree: bytes left over");
  }
  std::vector<TreeLeaf>& leaves() { return leaves_; }

 private:
  struct Cell {
    Box box;
    int depth;
  };

  std::uint8_t next() {
    require(at_ < tree_.size(), "tree: it ends early");
    return tree_[at_++];
  }
  u32 index() {
    u32 value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= u32{next()} << (8 * i);
    return value;
  }
  void split(const Cell& cell, std::size_t axis) {
    require(cell.depth < kDeepest, "tree: too deep");
    const auto halves = cell.box.split(axis);
    require(halves.has_value(), "tree: a cell that cannot be split");
    cells_.push_back({(*halves)[1], cell.depth + 1});
    cells_.push_back({(*halves)[0], cell.depth + 1});
  }

  const Bytes& tree_;
  std::size_t at_ = 0;
  std::vector<Cell> cells_;
  std::vector<TreeLeaf> leaves_;
};

bool touches(const Box& cell, const Box& whole) {
  for (std::size_t i = 0; i < 3; ++i)
    if (cell.low[i] == whole.low[i] || cell.high[i] == whole.high[i]) return true;
  return false;
}

bool inside(const Box& cell, const Box& box) {
  for (std::size_t i = 0; i < 3; ++i)
    if (cell.low[i] < box.low[i] || cell.high[i] > box.high[i]) return false;
  return true;
}

template <class T>
void check_leaf(const Claim& claim, BoxProver<T>& prover, const TreeLeaf& leaf,
                std::size_t number) {
  const RidgesSmoothCertificate& c = claim.certificate;
  if (leaf.code != 3) {
    require(!touches(leaf.cell, box_of(c.surface.box)),
            "tree: leaf {} touches the boundary of the box", number);
    if (leaf.code == 6) {
      require(leaf.graph_box < c.graph_boxes.size() &&
                  inside(leaf.cell, box_of(c.graph_boxes[leaf.graph_box].box)),
              "tree: leaf {} is in no graph box", number);
      return;
    }
  }
  if (!nonzero(prover.on_box(leaf.cell, leaf_direction(leaf.code))))
    throw Undecided(fmt::format("tree: leaf {}, code {}", number, leaf.code));
}

/// S is a graph over one side of the box, and Phi(vertex) is on it.
template <class T>
void check_graph_box(const Claim& claim, BoxProver<T>& prover, FaceProvers& faces,
                     std::size_t number) {
  const GraphBoxRecord& record = claim.certificate.graph_boxes[number];
  const Box box = box_of(record.box);
  for (std::size_t i = 0; i < 3; ++i)
    require(box.low[i] < box.high[i], "graph box {}: empty", number);
  const std::size_t m = record.axis;
  std::array<double, 3> axis{};
  axis[m] = 1;
  Box below = box, above = box;
  below.high[m] = box.low[m];
  above.low[m] = box.high[m];
  WitnessReader in(record.witness, "graph box", number);
  const Sign low = prover.on_pieces(below, nullptr, in),
             high = prover.on_pieces(above, nullptr, in);
  require(low != high, "graph box {}: no zero between its sides", number);
  prover.on_pieces(box, &axis, in);
  in.end();
  require(record.vertex < claim.certificate.vertices.size(), "graph box {}: no such vertex",
          number);
  const auto& topology = claim.mesh.topology;
  const u32 corner =
      *std::min_element(topology.ring.begin() + topology.ring_start[record.vertex],
                        topology.ring.begin() + topology.ring_start[record.vertex + 1]);
  const bool inside_box = faces.at_order(4, [&](auto& p) {
    const auto image = p.image(corner / 3, Piece::point(on_edge(corner % 3, 0)), false);
    if (!image) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const kernel::Range x = image->x[i].range();
      if (!(x.low > box.low[i] && x.high < box.high[i])) return false;
    }
    return true;
  });
  if (!inside_box) throw Undecided(fmt::format("graph box {}: the vertex is not inside", number));
}

template <class T>
std::size_t check_with(const Claim& claim) {
  const std::vector<TreeLeaf> leaves = leaves_of(claim.certificate);
  struct Worker {
    BoxProver<T> boxes;
    FaceProvers faces;
  };
  const std::size_t graphs = claim.certificate.graph_boxes.size();
  parallel_for(
      graphs + leaves.size(),
      [&] {
        return Worker{BoxProver<T>(claim.surface), FaceProvers(claim)};
      },
      [&](Worker& worker, std::size_t i) {
        if (i < graphs)
          check_graph_box(claim, worker.boxes, worker.faces, i);
        else
          check_leaf(claim, worker.boxes, leaves[i - graphs], i - graphs);
      });
  return leaves.size();
}

}  // namespace

std::vector<TreeLeaf> leaves_of(const RidgesSmoothCertificate& c) {
  return std::move(TreeReader(c).leaves());
}

const std::array<double, 3>* leaf_direction(std::uint8_t code) {
  return code == 3 ? nullptr : code == 4 ? &kA : &kB;
}

std::size_t check_completeness(const Claim& claim) {
  return claim.arithmetic == Arithmetic::mpfr ? check_with<kernel::MpInterval>(claim)
                                              : check_with<kernel::Interval>(claim);
}

}  // namespace crest::certify::smooth
