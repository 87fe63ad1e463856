// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/chains.hpp"

#include <algorithm>
#include <iterator>

#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

class Chainer {
 public:
  Chainer(const kernel::TriangleMesh& mesh, const EdgeStates& states,
          const std::vector<Index>& owner, Colour colour)
      : mesh_(mesh), states_(states), owner_(owner), colour_(colour), seen_(mesh.edge_count(), 0) {}

  void append_to(std::vector<Chain>& chains) {
    for (Index e = 0; e < mesh_.edge_count(); ++e)
      if (!seen_[e] && is_node(e)) chains.push_back(component(e));
  }

 private:
  bool is_node(Index e) const {
    if (!states_.is_crossed(e, colour_)) return false;
    const kernel::Edge& edge = mesh_.edges()[e];
    if (edge.f0 == kernel::kNone || edge.f1 == kernel::kNone) return true;
    return owner_[edge.f0] == kernel::kNone || owner_[edge.f0] != owner_[edge.f1];
  }

  // The other crossed side of a regular triangle, or kNone with the end that stops there.
  Index across(Index e, Index f, RidgeEnd& end) const {
    if (f == kernel::kNone) {
      end = {EndKind::boundary, kernel::kNone};
      return kernel::kNone;
    }
    if (owner_[f] != kernel::kNone) {
      end = {EndKind::umbilic, owner_[f]};
      return kernel::kNone;
    }
    for (Index other : mesh_.face_edges()[f])
      if (other != e && states_.is_crossed(other, colour_)) return other;
    return kernel::kNone;  // impossible: a triangle outside the patches has 0 or 2 crossings
  }

  // Follows the chain from edge e into face f; appends edges after e. True if it returns to e.
  bool walk(Index start, Index f, std::vector<Index>& edges, RidgeEnd& end) {
    Index e = start;
    while (true) {
      const Index next = across(e, f, end);
      if (next == kernel::kNone) return false;
      if (next == start) return true;
      seen_[next] = 1;
      edges.push_back(next);
      const kernel::Edge& edge = mesh_.edges()[next];
      f = edge.f0 == f ? edge.f1 : edge.f0;
      e = next;
    }
  }

  Chain component(Index e) {
    Chain chain;
    chain.colour = colour_;
    seen_[e] = 1;
    std::vector<Index> forward, backward;
    chain.loop = walk(e, mesh_.edges()[e].f0, forward, chain.ends[1]);
    if (chain.loop) {
      chain.ends[1] = {};
      chain.edges.push_back(e);
      if (forward.back() < forward.front()) std::reverse(forward.begin(), forward.end());
      chain.edges.insert(chain.edges.end(), forward.begin(), forward.end());
      return chain;
    }
    walk(e, mesh_.edges()[e].f1, backward, chain.ends[0]);
    chain.edges.assign(backward.rbegin(), backward.rend());
    chain.edges.push_back(e);
    chain.edges.insert(chain.edges.end(), forward.begin(), forward.end());
    const auto rank = [](const RidgeEnd& end) {
      return std::pair(static_cast<int>(end.kind), end.umbilic);
    };
    const bool reversed = chain.edges.size() > 1 ? chain.edges.back() < chain.edges.front()
                                                 : rank(chain.ends[1]) < rank(chain.ends[0]);
    if (reversed) {
      std::reverse(chain.edges.begin(), chain.edges.end());
      std::swap(chain.ends[0], chain.ends[1]);
    }
    return chain;
  }

  const kernel::TriangleMesh& mesh_;
  const EdgeStates& states_;
  const std::vector<Index>& owner_;
  Colour colour_;
  std::vector<std::uint8_t> seen_;
};

}  // namespace

std::vector<Chain> chain_crossings(const kernel::TriangleMesh& mesh, const EdgeStates& states,
                                   const std::vector<Index>& owner) {
  std::vector<Chain> chains, red;
  kernel::parallel_invoke([&] { Chainer(mesh, states, owner, Colour::blue).append_to(chains); },
                          [&] { Chainer(mesh, states, owner, Colour::red).append_to(red); });
  std::move(red.begin(), red.end(), std::back_inserter(chains));
  return chains;
}

}  // namespace crest::ridges
