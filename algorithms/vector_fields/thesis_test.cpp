// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/thesis_test.hpp"

#include <algorithm>
#include <cmath>

namespace crest::vector_fields {

using kernel::Sign;

ThesisTest::ThesisTest(const SearchState& state, const Collapse& plan,
                       const std::vector<Index>& lines)
    : star_(plan.star) {
  const CollapseMesh& mesh = state.mesh;
  for (const Index t : plan.star)
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (mesh.from(h) != plan.from && mesh.to(h) != plan.from)
        ring_.push_back({mesh.from(h), mesh.to(h)});
  closed_ = plan.gone[0] != plan.gone[1];
  std::sort(star_.begin(), star_.end());
  if (!closed_) return;
  add_switches(state);
  std::vector<Mark> marks = switches_;
  once_ = add_lines(state, lines, marks);
  before_ = circular(std::move(marks));
}

std::size_t ThesisTest::side_of(Index from, Index to) const {
  return static_cast<std::size_t>(std::find(ring_.begin(), ring_.end(), std::pair{from, to}) -
                                  ring_.begin());
}

/// Changes of the flow across the ring, inside sides and at corners.
void ThesisTest::add_switches(const SearchState& state) {
  const CollapseMesh& mesh = state.mesh;
  Index label = 2 * state.line_count();
  const auto across = [&](std::size_t side, Index v) {
    return kernel::flow_across(mesh.point(ring_[side].first), mesh.point(ring_[side].second),
                               mesh.vector(v));
  };
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const auto [p, q] = ring_[i];
    const std::size_t last = (i + ring_.size() - 1) % ring_.size();
    const Sign at_p = across(i, p), at_q = across(i, q);
    if (across(last, p) != at_p) switches_.push_back({i, 0, label++});
    if (at_p * at_q != Sign::negative) continue;
    const auto flow = [&](Index v) {
      return std::fabs(
          kernel::FlowAcross{mesh.point(p), mesh.point(q), mesh.vector(v)}.value<double>());
    };
    switches_.push_back({i, flow(p) / (flow(p) + flow(q)), label++});
  }
}

bool ThesisTest::add_lines(const SearchState& state, const std::vector<Index>& lines,
                           std::vector<Mark>& marks) const {
  const CollapseMesh& mesh = state.mesh;
  bool once = true;
  for (const Index number : lines) {
    const SearchLine& line = state.lines[number];
    std::size_t entries = 0;
    bool inside = false;
    for (std::size_t k = 0; k <= line.steps.size(); ++k) {
      const Index t = state.triangle_of(line, k);
      const bool now = std::binary_search(star_.begin(), star_.end(), t);
      if (now != inside && k > 0) {
        const Step& s = line.steps[k - 1];
        const Index p = mesh.from(s.exit), q = mesh.to(s.exit);
        if (now)
          marks.push_back({side_of(q, p), 1 - s.share, 2 * number});
        else
          marks.push_back({side_of(p, q), s.share, 2 * number + 1});
      }
      entries += now && !inside ? 1 : 0;
      inside = now;
    }
    once = once && entries <= 1;
  }
  return once;
}

/// Labels around the ring, from the least on.
std::vector<Index> ThesisTest::circular(std::vector<Mark> marks) {
  std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
    return std::tie(a.side, a.share, a.label) < std::tie(b.side, b.share, b.label);
  });
  std::vector<Index> labels;
  for (const Mark& m : marks) labels.push_back(m.label);
  if (!labels.empty())
    std::rotate(labels.begin(), std::min_element(labels.begin(), labels.end()), labels.end());
  return labels;
}

bool ThesisTest::allows(const SearchState& state, const std::vector<Index>& lines) const {
  if (!closed_) return true;
  if (!once_) return false;
  std::vector<Mark> marks = switches_;
  add_lines(state, lines, marks);
  return circular(std::move(marks)) == before_;
}

}  // namespace crest::vector_fields
