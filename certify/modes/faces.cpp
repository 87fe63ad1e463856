// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/faces.hpp"

#include <algorithm>
#include <tuple>

#include "certify/container/reject.hpp"
#include "certify/modes/root_places.hpp"

namespace crest::certify::modes {
namespace {

using kernel::Rational;

/// Orders the roots of a level in a graph face by t, which is constant along w.
class ArcOrder {
 public:
  ArcOrder(const LevelContext& context, const FaceNode& face, const Direction<3>& w, Worker& worker)
      : context_(context),
        worker_(worker),
        face_(face),
        t_{static_cast<double>(w[1] - w[2]), static_cast<double>(w[2] - w[0]),
           static_cast<double>(w[0] - w[1])},
        roots_(list_roots<double>(context, face)) {}

  std::size_t size() const { return roots_.size(); }

  /// The arcs of one level: roots 2 i and 2 i + 1 of the order.
  void join(int level, std::vector<ArcPair>& arcs) {
    std::vector<unsigned> order;
    for (unsigned i = 0; i < roots_.size(); ++i)
      if (context_.stated.roots[roots_[i].root].level == level) order.push_back(i);
    const auto key = [&](unsigned i) { return std::tuple(middle(i), outward(i), along(i)); };
    const auto wrong = [&](unsigned i, unsigned j) { return !in_order(i, j); };
    std::ranges::sort(order, {}, key);
    auto at = std::ranges::adjacent_find(order, wrong);
    if (at != order.end()) {
      for (const unsigned i : order) narrow(i);
      std::ranges::sort(order, {}, key);
      at = std::ranges::adjacent_find(order, wrong);
    }
    if (at != order.end()) refuse(*at, *(at + 1));
    require(order.size() % 2 == 0, "face ({}, {}, {}): an odd number of roots", face_.corners[0],
            face_.corners[1], face_.corners[2]);
    for (std::size_t i = 0; i < order.size(); i += 2) {
      const auto [first, second] = std::minmax(order[i], order[i + 1]);
      arcs.push_back({static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)});
    }
  }

 private:
  [[noreturn]] void refuse(unsigned i, unsigned j) const {
    const auto a = interval(roots_[i]), b = interval(roots_[j]);
    throw Reject(fmt::format(
        "face ({}, {}, {}): the enclosures do not tell the order across w of roots {} and {}, in "
        "[{}, "
        "{}] and [{}, {}]",
        face_.corners[0], face_.corners[1], face_.corners[2], i, j, a[0], a[1], b[0], b[1]));
  }

  /// Halves the enclosure of a simple root until it is narrow.
  void narrow(unsigned i) {
    auto& root = roots_[i];
    for (int k = 0; k < 45 && root.low < root.high; ++k) {
      bool done = false;
      for (const double part : {0.5, 0.375, 0.625, 0.25, 0.75}) {
        const double t = root.low + part * (root.high - root.low);
        if (!(root.low < t && t < root.high)) break;
        const int there = sign_on_edge(context_, root.node, t, worker_);
        if (there == 0) continue;
        const int low = sign_on_edge(context_, root.node, root.low, worker_);
        if (low == sign_on_edge(context_, root.node, root.high, worker_)) break;  // of a pair
        (there == low ? root.low : root.high) = t;
        done = true;
        break;
      }
      if (!done) break;
    }
    if (!exact_.empty()) exact_[i].low = root.low, exact_[i].high = root.high;
  }

  double start(unsigned i) const { return t_[roots_[i].edge]; }
  double end(unsigned i) const { return t_[(roots_[i].edge + 1) % 3]; }
  /// Direction of t along the root's edge.
  int rise(unsigned i) const { return end(i) > start(i) ? 1 : end(i) < start(i) ? -1 : 0; }

  double middle(unsigned i) const {
    const double s = (roots_[i].place(roots_[i].low) + roots_[i].place(roots_[i].high)) / 2;
    return rise(i) == 0 ? start(i) : start(i) + s * (end(i) - start(i));
  }
  /// An edge along w is at an end of the order: its root comes before, or after, those next to
  /// its vertices on the other edges.
  int outward(unsigned i) const {
    if (rise(i) != 0) return 0;
    return start(i) < t_[(roots_[i].edge + 2) % 3] ? -1 : 1;
  }
  /// Roots next to a vertex between two edges along which t goes the same way: in their order. At
  /// corner 0 those of edge 2 come first.
  int along(unsigned i) const {
    const auto& root = roots_[i];
    const bool after_all = root.edge == 0 && root.low == root.high && root.place(root.low) == 0;
    return rise(i) * static_cast<int>(after_all ? i + roots_.size() : i);
  }

  /// The interval of t of a root.
  template <class Number>
  std::array<Number, 2> interval(const RootOnFace<Number>& root) const {
    const Number from(t_[root.edge]), to(t_[(root.edge + 1) % 3]);
    const Number a = from + root.place(root.low) * (to - from);
    const Number b = from + root.place(root.high) * (to - from);
    if (b < a) return {b, a};
    return {a, b};
  }

  /// Whether root i comes before root j, certainly; they are neighbours in the order.
  bool in_order(unsigned i, unsigned j) {
    if (roots_[i].edge == roots_[j].edge) return rise(i) != 0 && (rise(i) > 0) == (i < j);
    const double size = std::fabs(t_[0]) + std::fabs(t_[1]) + std::fabs(t_[2]);
    const double error = widened(2 * size * (kPlaceError + 8 * kUnit));
    if (interval(roots_[i])[1] + 2 * error <= interval(roots_[j])[0]) return true;
    if (exact_.empty()) {
      exact_ = list_roots<Rational>(context_, face_);
      for (std::size_t k = 0; k < exact_.size(); ++k)
        exact_[k].low = roots_[k].low, exact_[k].high = roots_[k].high;
    }
    return interval(exact_[i])[1] <= interval(exact_[j])[0];
  }

  const LevelContext& context_;
  Worker& worker_;
  const FaceNode& face_;
  std::array<double, 3> t_;
  std::vector<RootOnFace<double>> roots_;
  std::vector<RootOnFace<Rational>> exact_;
};

Direction<3> direction(const LevelContext& context, const FaceNode& face) {
  const auto& w = context.stated.face_witnesses[face.witness].w;
  return {w[0], w[1], -(w[0] + w[1])};
}

}  // namespace

std::vector<ArcPair> find_arcs(const LevelContext& context, const FaceNode& face, Worker& worker) {
  ArcOrder order(context, face, direction(context, face), worker);
  std::vector<ArcPair> arcs;
  order.join(1, arcs);
  if (!context.level.neutral) order.join(-1, arcs);
  require(2 * arcs.size() == order.size(), "face ({}, {}, {}): an odd number of roots",
          face.corners[0], face.corners[1], face.corners[2]);
  std::ranges::sort(arcs, {}, &ArcPair::first);
  return arcs;
}

namespace {

void check_arcs(const LevelContext& context, const FaceNode& face, Worker& worker) {
  const auto [a, b, c] = face.corners;
  const auto arcs = find_arcs(context, face, worker);
  require(arcs.size() == face.arcs, "face ({}, {}, {}): {} arcs listed, {} found", a, b, c,
          face.arcs, arcs.size());
  for (u32 i = 0; i < arcs.size(); ++i) {
    const ArcPair& stated = context.stated.arcs[face.arc + i];
    require(stated.first == arcs[i].first && stated.second == arcs[i].second,
            "face ({}, {}, {}): roots {} and {} joined, listed are {} and {}", a, b, c,
            arcs[i].first, arcs[i].second, stated.first, stated.second);
  }
}

}  // namespace

void check_faces(const LevelContext& context, std::size_t first, std::size_t end, Worker& worker) {
  std::vector<std::array<u32, 3>> rejected;
  std::vector<Witnessed<3>> graphs;
  std::vector<const FaceNode*> with_arcs;
  for (const FaceNode& face : std::span(context.trees.faces).subspan(first, end - first)) {
    if (!face.leaf() || !face.needed || face.code == modes_code::kOpenFace) continue;
    if (face.code == modes_code::kRejectedFace) {
      rejected.push_back(face.corners);
      continue;
    }
    const double lambda = context.stated.face_witnesses[face.witness].lambda;
    const bool plain = face.code == modes_code::kPlainFace;
    const auto [a, b, c] = face.corners;
    require(!plain || lambda == 0, "face ({}, {}, {}): lambda is not 0", a, b, c);
    graphs.push_back(
        {face.corners, direction(context, face), plain ? std::nullopt : std::optional(lambda)});
    with_arcs.push_back(&face);
  }
  check_rejected(context, rejected, worker);
  check_witnesses(context, graphs, worker);
  for (const FaceNode* face : with_arcs) check_arcs(context, *face, worker);
}

}  // namespace crest::certify::modes
