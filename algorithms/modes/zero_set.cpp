// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/zero_set.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "algorithms/modes/tensors.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

using kernel::Index;
using kernel::Integer;
using kernel::Rational;
using Corners = std::vector<Index>;

/// Positive numbers of sum 1 with sum b_i T_i = 0, if they are unique up to a factor.
std::optional<std::vector<Rational>> positive_dependency(const std::vector<Entries<Rational>>& t) {
  const std::size_t n = t.size();
  std::vector<std::vector<Rational>> rows(6, std::vector<Rational>(n));
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t i = 0; i < n; ++i) rows[k][i] = t[i][k];
  std::vector<std::size_t> pivots;
  std::size_t row = 0;
  std::size_t free = n;
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t r = row;
    while (r < 6 && rows[r][column] == 0) ++r;
    if (r == 6) {
      if (free != n) return std::nullopt;
      free = column;
      continue;
    }
    std::swap(rows[r], rows[row]);
    for (std::size_t other = 0; other < 6; ++other) {
      if (other == row || rows[other][column] == 0) continue;
      const Rational k = rows[other][column] / rows[row][column];
      for (std::size_t i = column; i < n; ++i) rows[other][i] -= k * rows[row][i];
    }
    pivots.push_back(column);
    ++row;
  }
  if (free == n) return std::nullopt;
  std::vector<Rational> b(n, Rational(0));
  b[free] = 1;
  for (std::size_t k = 0; k < pivots.size(); ++k)
    b[pivots[k]] = -rows[k][free] / rows[k][pivots[k]];
  Rational sum = 0;
  for (const Rational& x : b) {
    if (x <= 0) return std::nullopt;
    sum += x;
  }
  for (Rational& x : b) x /= sum;
  return b;
}

/// The deviator times a power of two, its largest entry between 1 and 2: where a tensor is zero
/// does not depend on the sizes of its corners', of which one may be 2^-600 of another.
Symmetric scaled_deviator(const Symmetric& t) {
  const auto largest = [](const Symmetric& x) {
    double m = 0;
    for (const double e : x) m = std::fmax(m, std::fabs(e));
    return m;
  };
  Symmetric d = deviator(t, largest(t) > 0x1p1000 ? 8 : 0).t;
  if (const double m = largest(d); m > 0)
    for (double& x : d) x = std::ldexp(x, -std::ilogb(m));
  return d;
}

class Inserter {
 public:
  explicit Inserter(ModeField& field) : field_(field) {
    points_ = field.mesh.points();
    tets_ = field.mesh.tets();
    set_.tets = tets_;
    set_.tet_of.resize(tets_.size());
    std::iota(set_.tet_of.begin(), set_.tet_of.end(), Index{0});
    for (const auto& t : field.tensors) {
      deviators_.push_back(scaled_deviator(t));
      zero_.push_back(is_isotropic(t) ? 1 : 0);
    }
  }

  ZeroSet run() {
    for (std::size_t size = 2; size <= 4; ++size) {
      if (changed_) find_suspects();
      for (const Corners& s : candidates(size)) insert(s);
    }
    if (!set_.simplices.empty())
      field_.mesh = kernel::TetMesh(std::move(points_), std::move(tets_));
    return std::move(set_);
  }

 private:
  /// Tetrahedra that may hold a zero.
  void find_suspects() {
    std::vector<char> suspect(tets_.size());
    kernel::parallel_for(tbb::blocked_range<std::size_t>(0, tets_.size(), 4096),
                         [&](const auto& range) {
                           for (std::size_t t = range.begin(); t < range.end(); ++t)
                             suspect[t] = in_half_space(tets_[t]) ? 0 : 1;
                         });
    suspects_.clear();
    for (std::size_t t = 0; t < tets_.size(); ++t)
      if (suspect[t] != 0) suspects_.push_back(t);
    changed_ = false;
  }
  /// Simplices of that many corners, none zero, whose tensors are nearly dependent; ascending.
  std::set<Corners> candidates(std::size_t size) const {
    std::set<Corners> found;
    for (const std::size_t suspect : suspects_) {
      auto t = tets_[suspect];
      std::sort(t.begin(), t.end());
      for (unsigned mask = 1; mask < 16; ++mask) {
        Corners s;
        for (std::size_t i = 0; i < 4; ++i)
          if ((mask >> i & 1U) != 0) s.push_back(t[i]);
        if (s.size() == size && is_candidate(s)) found.insert(s);
      }
    }
    return found;
  }
  /// Whether all tensors have products with one that doubles are sure to be positive.
  bool in_half_space(const kernel::TetMesh::Tet& t) const {
    Symmetric sum{};
    std::array<double, 4> size{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Symmetric& x = deviators_[t[i]];
      size[i] = std::sqrt(product(x, x));
      for (std::size_t k = 0; k < 6; ++k) sum[k] += x[k] / size[i];
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (!(product(sum, deviators_[t[i]]) > 1e-9 * size[i])) return false;
    return true;
  }
  /// By Gram-Schmidt: the last tensor left over is tiny. Rejects what doubles are sure of.
  bool is_candidate(const Corners& s) const {
    for (const Index v : s)
      if (zero_[v] != 0) return false;
    if (s.size() == 2) {
      const auto &a = deviators_[s[0]], &b = deviators_[s[1]];
      const double c = product(a, b);
      return c < 0 && c * c > (1 - 1e-9) * product(a, a) * product(b, b);
    }
    std::vector<Symmetric> basis;
    for (const Index v : s) {
      Symmetric x = deviators_[v];
      const double size = std::sqrt(product(x, x));
      for (double& e : x) e /= size;
      for (int twice = 0; twice < 2; ++twice)
        for (const Symmetric& b : basis) {
          const double c = product(x, b);
          for (std::size_t k = 0; k < 6; ++k) x[k] -= c * b[k];
        }
      const double left = std::sqrt(product(x, x));
      if (!(left > 1e-7)) return true;
      for (double& e : x) e /= left;
      basis.push_back(x);
    }
    return false;
  }

  Entries<Rational> exact(Index v) const {
    const ExactTensor t = exact_deviator(field_.tensors[v], 0);
    Entries<Rational> r;
    const Rational unit = kernel::Dyadic{Integer(1), t.exponent}.value();
    for (std::size_t k = 0; k < 6; ++k) r[k] = Rational(t.t[k]) * unit;
    return r;
  }

  void insert(const Corners& s) {
    std::vector<Entries<Rational>> tensors;
    for (const Index v : s) tensors.push_back(exact(v));
    const auto b = positive_dependency(tensors);
    if (!b) return;
    const std::size_t count = tets_.size();
    const auto vertex = static_cast<Index>(points_.size());
    bool used = false;
    for (std::size_t t = 0; t < count; ++t) {
      const auto whole = tets_[t];
      const auto has = [&](Index v) {
        return std::find(whole.begin(), whole.end(), v) != whole.end();
      };
      if (!std::all_of(s.begin(), s.end(), has)) continue;
      for (std::size_t i = 0; i < s.size(); ++i) {
        auto part = whole;
        std::replace(part.begin(), part.end(), s[i], vertex);
        if (i == 0) {
          tets_[t] = part;
        } else {
          tets_.push_back(part);
          set_.tet_of.push_back(set_.tet_of[t]);
        }
      }
      used = true;
    }
    if (!used) return;  // what held it has been cut by another zero
    kernel::Vec3 p{};
    for (std::size_t i = 0; i < s.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) p[k] += static_cast<double>((*b)[i]) * points_[s[i]][k];
    changed_ = true;
    points_.push_back(p);
    field_.tensors.push_back({});
    deviators_.push_back({});
    zero_.push_back(1);
    set_.simplices.push_back(s);
  }

  ModeField& field_;
  std::vector<kernel::Vec3> points_;
  std::vector<kernel::TetMesh::Tet> tets_;
  std::vector<Symmetric> deviators_;
  std::vector<char> zero_;
  std::vector<std::size_t> suspects_;
  bool changed_ = true;  ///< the suspects are not known
  ZeroSet set_;
};

}  // namespace

ZeroSet insert_zeros(ModeField& field) {
  return Inserter(field).run();
}

}  // namespace crest::modes
