// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/near_vertices.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/modes/invariants.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::modes {
namespace {

using kernel::Rational;

double stated_mode(const LevelContext& context, int level) {
  const ModeLevel& stated = context.stated;
  return level * (static_cast<double>(stated.numerator) / static_cast<double>(stated.denominator));
}

/// Nothing where doubles do not tell. With mode = 3 sqrt(6) det / |D|^3 and n below |D|^2, an error
/// of det counts 3 sqrt(6) < 7.4 over n^(3/2); one of |D|^2 at most 1.5 |det| / n as much, by the
/// mean value of x^(-3/2); the quotient and the level are rounded fewer than 16 times.
std::optional<bool> is_near_in_doubles(const Invariants& there, double level) {
  const double least = there.norm - there.norm_error;
  if (!(least > 0)) return std::nullopt;
  const double mode = 3 * std::sqrt(6.0) * there.det / (there.norm * std::sqrt(there.norm));
  const double error =
      widened(7.4 * (there.det_error + 1.5 * std::fabs(there.det) * there.norm_error / least) /
                  (least * std::sqrt(least)) +
              16 * kUnit * (1 + std::fabs(mode)));
  const double off = std::fabs(mode - level);
  if (off + error < kNear * (1 - 0x1p-20)) return true;
  if (off - error > kNear * (1 + 0x1p-20)) return false;
  return std::nullopt;
}

template <std::size_t n>
Tensor<Rational> exact_average(const std::array<u32, n>& corners,
                               const std::array<double, n - 1>& weights, ExactTensors& exact) {
  std::array<ExactTensor, n> tensors;
  long least = 0;
  for (std::size_t i = 0; i < n; ++i) {
    tensors[i] = exact(corners[i]);
    least = i == 0 ? tensors[i].exponent : std::min(least, tensors[i].exponent);
  }
  Tensor<Rational> sum;
  Rational left = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational weight = i + 1 < n ? Rational(weights[i]) : left;
    left -= weight;
    for (std::size_t k = 0; k < 6; ++k)
      sum[k] += weight * Rational(Integer(tensors[i].entries[k]
                                          << static_cast<unsigned>(tensors[i].exponent - least)));
  }
  return sum;
}

/// With c = level det and |D|^6 = s: mode <= mu + near iff c <= 0 or 54 c^2 <= (mu + near)^2 s;
/// mode
/// >= mu - near iff c >= 0 and 54 c^2 >= (mu - near)^2 s, or, where that is negative, c >= 0 or 54
/// c^2 <= (mu - near)^2 s.
bool is_near_exactly(const Tensor<Rational>& d, const ModeLevel& stated, int level) {
  const Rational c =
      level * Rational(d[0] * (d[1] * d[2] - d[4] * d[4]) - d[3] * (d[3] * d[2] - d[4] * d[5]) +
                       d[5] * (d[3] * d[4] - d[1] * d[5]));
  const Rational norm =
      d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 2 * (d[3] * d[3] + d[4] * d[4] + d[5] * d[5]);
  if (norm == 0) return false;
  const Rational mu = Rational(stated.numerator) / Rational(stated.denominator);
  const Rational high = mu + Rational(kNear), low = mu - Rational(kNear);
  const Rational cube = norm * norm * norm, square = 54 * c * c;
  if (c > 0 && square > high * high * cube) return false;
  if (low >= 0) return c >= 0 && square >= low * low * cube;
  return c >= 0 || square <= low * low * cube;
}

}  // namespace

template <std::size_t n>
bool is_near(const LevelContext& context, const std::array<u32, n>& corners,
             const std::array<double, n - 1>& weights, int level, ExactTensors& exact) {
  std::array<double, n> all{};
  double left = 1;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    all[i] = weights[i];
    left -= weights[i];
  }
  all[n - 1] = std::max(0.0, left);
  if (const auto there = invariants<n>(context.field, corners, all))
    if (const auto near = is_near_in_doubles(*there, stated_mode(context, level))) return *near;
  return is_near_exactly(exact_average<n>(corners, weights, exact), context.stated, level);
}

template bool is_near<2>(const LevelContext&, const std::array<u32, 2>&,
                         const std::array<double, 1>&, int, ExactTensors&);
template bool is_near<3>(const LevelContext&, const std::array<u32, 3>&,
                         const std::array<double, 2>&, int, ExactTensors&);
template bool is_near<4>(const LevelContext&, const std::array<u32, 4>&,
                         const std::array<double, 3>&, int, ExactTensors&);

NearVertices::NearVertices(const LevelContext& context, const Positions& positions)
    : context_(context), positions_(positions) {
  const ModeLevel& stated = context.stated;
  cell_of_.assign(stated.tet_witnesses.size(), kNone);
  for (u32 i = 0; i < context.trees.cells.size(); ++i) {
    const Cell& cell = context.trees.cells[i];
    if (cell.code == modes_code::kGraphTet || cell.code == modes_code::kPlainTet)
      cell_of_[cell.witness] = i;
  }
  const auto order = [](const InnerVertex& v) {
    return std::tuple(v.witness, -v.level, v.weights);
  };
  require(std::ranges::is_sorted(stated.inner, std::less_equal<>(), order),
          "inner vertices: not in their order, or one twice");
  for (const auto& [witness, level, weights] : stated.inner) {
    require((level == 1 || level == -1) && witness < stated.tet_witnesses.size() &&
                stated.tet_witnesses[witness].pieces[level > 0 ? 0 : 1] > 0,
            "inner vertices: witness {} has no piece of level {}", witness, int{level});
    const auto& [a, b, c] = weights;
    require(a >= 0 && b >= 0 && c >= 0 && a + b + c < 1, "inner vertices: one outside its cell");
  }
}

std::size_t NearVertices::all() const {
  const ModeLevel& stated = context_.stated;
  return stated.root_places.size() + stated.points.size() + stated.inner.size();
}

u32 NearVertices::on_edge(const EdgeNode& edge, Worker& worker) const {
  u32 count = 0;
  for (u32 i = edge.root; edge.leaf() && i < edge.root + edge.roots; ++i)
    count += is_near<2>(context_, {edge.second, edge.first}, {context_.stated.root_places[i]},
                        context_.stated.roots[i].level, worker.exact);
  return count;
}

u32 NearVertices::on_face(u32 face, Worker& worker) const {
  std::vector<FaceArc> arcs;
  if (context_.trees.faces[face].leaf()) list_arcs(context_, face, arcs);
  u32 count = 0;
  for (const FaceArc& arc : arcs)
    for (const auto& weights : positions_.points_of(arc.arc))
      count += is_near<3>(context_, context_.trees.faces[face].corners, weights, arc.level,
                          worker.exact);
  return count;
}

bool NearVertices::inside(const InnerVertex& vertex, Worker& worker) const {
  return is_near<4>(context_, context_.trees.cells[cell_of_[vertex.witness]].corners,
                    vertex.weights, vertex.level, worker.exact);
}

}  // namespace crest::certify::modes
