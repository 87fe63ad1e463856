// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/domain.hpp"

#include <algorithm>
#include <functional>

#include "certify/container/reject.hpp"

namespace crest::certify::modes {
namespace {

using kernel::Rational;

Rational power_of_two(long exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(std::labs(exponent));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

/// Whether the tensors have one relation, up to a factor, and its numbers are positive.
bool positive_relation(ExactTensors& exact, std::span<const u32> corners) {
  const std::size_t n = corners.size();
  std::array<std::array<Rational, 4>, 6> rows;
  for (std::size_t j = 0; j < n; ++j) {
    const ExactTensor t = exact(corners[j]);
    const Rational unit = power_of_two(t.exponent);
    for (std::size_t i = 0; i < 6; ++i) rows[i][j] = Rational(t.entries[i]) * unit;
  }
  // Gauss-Jordan: n - 1 pivots are needed, in all columns but the last.
  for (std::size_t column = 0; column + 1 < n; ++column) {
    std::size_t pivot = column;
    while (pivot < 6 && rows[pivot][column] == 0) ++pivot;
    if (pivot == 6) return false;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == column || rows[i][column] == 0) continue;
      const Rational factor = rows[i][column] / rows[column][column];
      for (std::size_t j = column; j < n; ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  for (std::size_t i = n - 1; i < 6; ++i)
    if (rows[i][n - 1] != 0) return false;
  // With the last number 1, number i is -last / pivot.
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (!(rows[i][n - 1] * rows[i][i] < 0)) return false;
  return true;
}

bool holds(const std::array<u32, 4>& tet, const std::vector<u32>& simplex) {
  return std::ranges::all_of(simplex,
                             [&](u32 v) { return std::ranges::find(tet, v) != tet.end(); });
}

/// Zeros by their corners, for the look-up from a tetrahedron.
class ZeroTable {
 public:
  explicit ZeroTable(const std::vector<ZeroRecord>& zeros) : zeros_(zeros) {
    for (u32 i = 0; i < zeros.size(); ++i) order_.push_back(i);
    std::ranges::sort(
        order_, {}, [&](u32 i) -> const auto& { return zeros[i].corners; });
    for (u32 i = 1; i < order_.size(); ++i)
      require(zeros[order_[i - 1]].corners != zeros[order_[i]].corners,
              "zeros: two in one simplex");
  }

  /// Those in the simplices of a tetrahedron, in the order of insertion.
  std::vector<u32> inside(const std::array<u32, 4>& tet) const {
    std::vector<u32> found;
    for (unsigned subset = 1; subset < 16; ++subset) {
      std::vector<u32> simplex;
      for (unsigned i = 0; i < 4; ++i)
        if (subset >> i & 1U) simplex.push_back(tet[i]);
      const auto at = std::ranges::lower_bound(
          order_, simplex, {}, [&](u32 i) -> const auto& { return zeros_[i].corners; });
      if (at != order_.end() && zeros_[*at].corners == simplex) found.push_back(*at);
    }
    std::ranges::sort(found);
    return found;
  }

 private:
  const std::vector<ZeroRecord>& zeros_;
  std::vector<u32> order_;
};

void insert_zeros(const ModesCertificate& c, Field& field, std::vector<std::array<u32, 4>>& tets) {
  ExactTensors exact(field);
  const ZeroTable table(c.zeros);
  for (const ZeroRecord& zero : c.zeros) {
    const auto& s = zero.corners;
    require(std::ranges::is_sorted(s, std::less_equal<>()) && s.back() < c.points.size(),
            "zeros: corners are not ascending vertices");
    for (const u32 v : s) require(!field.zero(v), "zeros: at vertex {} the tensor is zero", v);
    require(positive_relation(exact, s), "zeros: no single zero inside the simplex at vertex {}",
            s.front());
  }
  const auto first = static_cast<u32>(field.fixed());
  for (std::size_t i = 0; i < c.zeros.size(); ++i) field.add_zero();
  std::vector<std::uint8_t> used(c.zeros.size(), 0);
  const std::size_t count = tets.size();
  for (std::size_t t = 0; t < count; ++t) {
    std::vector<std::array<u32, 4>> parts = {tets[t]}, next;
    for (const u32 zero : table.inside(tets[t])) {
      next.clear();
      for (const auto& part : parts) {
        if (!holds(part, c.zeros[zero].corners)) {
          next.push_back(part);
          continue;
        }
        used[zero] = 1;
        for (const u32 corner : c.zeros[zero].corners) {
          next.push_back(part);
          std::ranges::replace(next.back(), corner, first + zero);
        }
      }
      parts.swap(next);
    }
    tets[t] = parts[0];
    tets.insert(tets.end(), parts.begin() + 1, parts.end());
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    require(used[i] != 0, "zeros: {} is in no simplex of the complex", i);
}

}  // namespace

Domain build_domain(const ModesCertificate& c, Field& field) {
  Domain domain;
  require(c.points.size() >= 4 && !c.tets.empty(), "data: no tetrahedra");
  require(c.points.size() + c.zeros.size() < kNone / 2 && c.tets.size() < kNone / 64,
          "data: more simplices than there are numbers");
  domain.tets = c.tets;
  for (u32 i = 0; i < domain.tets.size(); ++i) {
    auto& t = domain.tets[i];
    std::ranges::sort(t);
    require(t[3] < c.points.size(), "data: tetrahedron {} has no vertex {}", i, t[3]);
    require(t[0] != t[1] && t[1] != t[2] && t[2] != t[3], "data: tetrahedron {} has a corner twice",
            i);
  }
  if (!c.zeros.empty()) {
    list_faces(domain.tets, field.fixed());
    insert_zeros(c, field, domain.tets);
    for (auto& t : domain.tets) std::ranges::sort(t);
  }
  domain.faces = list_faces(domain.tets, field.fixed());
  return domain;
}

Corners nonzero_corners(const Field& field, const std::array<u32, 4>& tet) {
  Corners corners;
  for (const u32 v : tet)
    if (!field.zero(v)) corners.list[corners.count++] = v;
  return corners;
}

/// Zero is in the convex hull iff it is strictly inside that of a least set of corners, whose
/// tensors then have a single relation.
bool zero_free(ExactTensors& exact, std::span<const u32> corners) {
  for (unsigned subset = 1; subset < 1U << corners.size(); ++subset) {
    std::vector<u32> some;
    for (unsigned i = 0; i < corners.size(); ++i)
      if (subset >> i & 1U) some.push_back(corners[i]);
    if (positive_relation(exact, some)) return false;
  }
  return true;
}

}  // namespace crest::certify::modes
