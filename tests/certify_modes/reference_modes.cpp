// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_modes/reference_modes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "certify/container/reject.hpp"
#include "certify/exact/sturm.hpp"
#include "certify/modes/surface.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using namespace certify::modes;

using Edge = std::array<u32, 2>;
using Face = std::array<u32, 3>;
using Tet = std::array<u32, 4>;

template <std::size_t n>
std::array<u32, n> sorted(std::array<u32, n> x) {
  std::ranges::sort(x);
  return x;
}

constexpr std::array<std::array<unsigned, 2>, 6> kEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Numbers x with rows x > 0, by the perceptron.
std::optional<std::array<double, 4>> positive_on(const std::vector<std::array<double, 4>>& rows,
                                                 std::size_t used) {
  std::array<double, 4> x{};
  std::vector<std::array<double, 4>> unit;
  for (const auto& row : rows) {
    double norm = 0;
    for (std::size_t i = 0; i < used; ++i) norm += row[i] * row[i];
    if (norm == 0) return std::nullopt;
    auto scaled = row;
    for (double& c : scaled) c /= std::sqrt(norm);
    unit.push_back(scaled);
    for (std::size_t i = 0; i < used; ++i) x[i] += scaled[i] / static_cast<double>(rows.size());
  }
  for (int step = 0; step < 600; ++step) {
    const std::array<double, 4>* worst = nullptr;
    double least = 1e300, size = 0;
    for (std::size_t i = 0; i < used; ++i) size += x[i] * x[i];
    for (const auto& row : unit) {
      double dot = 0;
      for (std::size_t i = 0; i < used; ++i) dot += row[i] * x[i];
      if (dot < least) least = dot, worst = &row;
    }
    if (least > 0.002 * std::sqrt(size)) return x;
    for (std::size_t i = 0; i < used; ++i) x[i] += 0.3 * (*worst)[i];
  }
  return std::nullopt;
}

CellPieces check_one(const LevelContext& context, const Cell& cell, Worker& worker) {
  CellPieces pieces;
  check_cells(context, {&cell, 1}, {&pieces, 1}, worker);
  return pieces;
}

class Producer {
 public:
  Producer(Field& field, const Domain& domain, const MadeLevel& level, unsigned most_depth)
      : field_(field), domain_(domain), most_depth_(most_depth) {
    made_.numerator = level.numerator;
    made_.denominator = level.denominator;
  }

  ModeLevel run() {
    for (;;) {
      field_.drop_splits();
      worker_ = std::make_unique<Worker>(field_);
      subdivide();
      emit();
      if (finish()) return made_;
    }
  }

 private:
  /// Numbers of vertices may be others the next time.
  using CellKey = std::array<std::array<double, 6>, 4>;
  CellKey key_of(const Tet& cell) const {
    CellKey key;
    for (unsigned i = 0; i < 4; ++i) key[i] = field_.approximate(cell[i]).entries;
    std::ranges::sort(key);
    return key;
  }

  double angle(u32 a, u32 b) const {
    const auto &s = field_.approximate(a).entries, &t = field_.approximate(b).entries;
    const auto inner = [](const auto& x, const auto& y) {
      return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] +
             2 * (x[3] * y[3] + x[4] * y[4] + x[5] * y[5]);
    };
    return inner(s, t) / std::sqrt(inner(s, s) * inner(t, t));
  }

  /// The edge with the largest angle, ties by numbers.
  template <std::size_t n>
  Edge longest(const std::array<u32, n>& corners) const {
    Edge best{};
    double least = 2;
    const auto all = sorted(corners);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        if (const double cosine = angle(all[i], all[j]); cosine < least)
          least = cosine, best = {all[i], all[j]};
    return best;
  }

  u32 middle(const Edge& edge) {
    const auto at = split_.find(edge);
    if (at != split_.end()) return at->second;
    const u32 v = field_.split(edge[0], edge[1], 32);
    split_[edge] = v;
    return v;
  }
  template <std::size_t n>
  static std::array<u32, n> replaced(std::array<u32, n> corners, u32 from, u32 to) {
    std::ranges::replace(corners, from, to);
    return corners;
  }

  template <std::size_t n>
  bool rejected(const std::array<u32, n>& corners) {
    const LevelContext context(made_, field_, none_);
    try {
      check_rejected(context, std::span(&corners, 1), *worker_);
      return true;
    } catch (const Reject&) {
      return false;
    }
  }

  struct Witness {
    std::array<std::int16_t, 3> w{};
    double lambda = 0;
    bool plain = false;
  };

  template <std::size_t n>
  std::optional<Witness> witness(const std::array<u32, n>& corners) {
    const auto order = sorted(corners);
    const auto key = std::vector<u32>(order.begin(), order.end());
    if (!witnesses_.contains(key)) witnesses_[key] = search(order);
    auto found = witnesses_[key];
    if (!found) return found;
    std::map<u32, std::int16_t> by_vertex;
    int rest = 0;
    for (std::size_t k = 0; k + 1 < n; ++k) by_vertex[order[k]] = found->w[k], rest -= found->w[k];
    by_vertex[order[n - 1]] = static_cast<std::int16_t>(rest);
    for (std::size_t k = 0; k + 1 < n; ++k) found->w[k] = by_vertex[corners[k]];
    return found;
  }

  template <std::size_t n>
  std::optional<Witness> search(const std::array<u32, n>& corners) {
    const auto products = approximate_products<n>(field_, corners);
    const SimplexForms<double, n> forms(products);
    const LevelContext context(made_, field_, none_);
    const Level& level = context.level;
    for (const bool plain : {true, false}) {
      std::vector<std::array<double, 4>> rows;
      const auto fill = [&](const auto& form, std::size_t column) {
        rows.resize(form.c.size());
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i][column] = form.c[i];
      };
      for (std::size_t k = 0; k + 1 < n; ++k) {
        typename SimplexForms<double, n>::Numbers w{};
        w[k] = 1, w[n - 1] = -1;
        if (plain)
          fill(forms.plain(w), k);
        else if (level.neutral)
          fill(forms.neutral_witness(w, 0), k);
        else
          fill(forms.witness(w, 0, level), k);
      }
      if (!plain && level.neutral) fill(forms.cube(), n - 1);
      if (!plain && !level.neutral) fill(forms.pair(level), n - 1);
      const auto x = positive_on(rows, plain ? n - 1 : n);
      if (!x) continue;
      Witness found;
      found.plain = plain;
      double most = 0;
      for (std::size_t k = 0; k + 1 < n; ++k) most = std::max(most, std::fabs((*x)[k]));
      for (std::size_t k = 0; k + 1 < n; ++k)
        found.w[k] = static_cast<std::int16_t>(std::lround((*x)[k] / most * 9000));
      if (!plain) {
        found.lambda = (*x)[n - 1] / most * 9000;
        if (!level.neutral)
          found.lambda = std::ldexp(found.lambda / 3, static_cast<int>(products.exponent));
      }
      try {
        Witnessed<n> tried{corners, {}, plain ? std::nullopt : std::optional(found.lambda)};
        for (std::size_t k = 0; k + 1 < n; ++k)
          tried.w[k] = found.w[k], tried.w[n - 1] -= found.w[k];
        check_witnesses(context, std::span<const Witnessed<n>>(&tried, 1), *worker_);
        return found;
      } catch (const Reject&) {
      }
    }
    return std::nullopt;
  }

  enum class Fate { split, rejected, graph, open };

  Fate fate(const Tet& cell, unsigned depth) {
    if (forced_.contains(key_of(cell))) return depth < most_depth_ ? Fate::split : Fate::open;
    if (rejected(cell)) return Fate::rejected;
    if (witness(cell)) return Fate::graph;
    return depth < most_depth_ ? Fate::split : Fate::open;
  }

  void divide_cell(const Tet& cell, unsigned depth) {
    const Fate found = fate(cell, depth);
    fates_[sorted(cell)] = found;
    if (found == Fate::graph)
      for (unsigned i = 0; i < 4; ++i) certify_.push_back(facet(cell, i));
    if (found != Fate::split) return;
    const Edge edge = longest(cell);
    const u32 m = middle(edge);
    for (const u32 v : cell)
      if (v != edge[0] && v != edge[1]) face_split_[sorted(Face{edge[0], edge[1], v})] = edge;
    divide_cell(replaced(cell, edge[1], m), depth + 1);
    divide_cell(replaced(cell, edge[0], m), depth + 1);
  }
  static Face facet(const Tet& tet, unsigned opposite) {
    Face corners{};
    unsigned at = 0;
    for (unsigned i = 0; i < 4; ++i)
      if (i != opposite) corners[at++] = tet[i];
    return corners;
  }

  /// Divides a face until all parts are decided.
  void divide_face(const Face& face, unsigned depth) {
    const Face key = sorted(face);
    if (!face_split_.contains(key)) {
      if (rejected(key))
        face_fates_[key] = Fate::rejected;
      else if (witness(key))
        face_fates_[key] = Fate::graph;
      else if (depth > most_depth_ + 20)
        face_fates_[key] = Fate::open;
      else
        face_split_[key] = longest(key);
      if (!face_split_.contains(key)) return;
    }
    const Edge edge = face_split_[key];
    const u32 m = middle(edge);
    divide_face(replaced(key, edge[1], m), depth + 1);
    divide_face(replaced(key, edge[0], m), depth + 1);
  }

  void subdivide() {
    split_.clear(), face_split_.clear(), fates_.clear(), face_fates_.clear();
    witnesses_.clear(), certify_.clear(), leaves_.clear(), roots_of_.clear();
    for (u32 t = 0; t < domain_.tets.size(); ++t) {
      const auto corners = nonzero_corners(field_, domain_.tets[t]);
      if (corners.size() == 4) divide_cell(domain_.tets[t], 0);
      if (corners.size() == 3) certify_.push_back({corners[0], corners[1], corners[2]});
    }
    for (const Face& face : certify_) divide_face(face, 0);
  }

  void emit() {
    made_ =
        ModeLevel{made_.numerator, made_.denominator, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0};
    std::set<Edge> edges;
    std::vector<Face> faces;
    for (const auto& face : domain_.faces) {
      const Face key = face.corners;
      const bool listed = face_split_.contains(key) || face_fates_.contains(key);
      if (!listed) continue;
      faces.push_back(key);
      edges.insert({key[0], key[1]});
      edges.insert({key[0], key[2]});
      edges.insert({key[1], key[2]});
    }
    for (const auto& tet : domain_.tets)
      if (const auto ends = nonzero_corners(field_, tet); ends.size() == 2)
        edges.insert({ends[0], ends[1]});
    for (const Edge& edge : edges) {
      made_.edges.push_back(edge);
      emit_edge(edge[0], edge[1]);
    }
    for (const Face& face : faces) {
      made_.faces.push_back(face);
      emit_face(face);
    }
    for (u32 t = 0; t < domain_.tets.size(); ++t) {
      if (nonzero_corners(field_, domain_.tets[t]).size() != 4) continue;
      if (fates_[domain_.tets[t]] == Fate::rejected) continue;
      made_.tets.push_back(t);
      emit_cell(domain_.tets[t]);
    }
  }

  void emit_edge(u32 first, u32 second) {
    if (const auto at = split_.find(sorted(Edge{first, second})); at != split_.end()) {
      made_.codes.push_back(32);
      emit_edge(first, at->second);
      emit_edge(at->second, second);
      return;
    }
    const auto roots = isolate(first, second);
    made_.codes.push_back(static_cast<std::uint8_t>(modes_code::kRoots + roots.size()));
    made_.roots.insert(made_.roots.end(), roots.begin(), roots.end());
    roots_of_[sorted(Edge{first, second})] = static_cast<u32>(roots.size());
  }

  std::vector<RootRecord> isolate(u32 first, u32 second) {
    const auto products = exact_products<2>(worker_->exact, {first, second});
    const SimplexForms<Integer, 2> forms(products);
    const LevelContext context(made_, field_, none_);
    std::vector<Integer> a;
    if (context.level.neutral) {
      const auto f = forms.cube();
      a.assign(f.c.begin(), f.c.end());
    } else {
      const auto f = forms.pair(context.level);
      a.assign(f.c.begin(), f.c.end());
    }
    std::vector<RootRecord> roots;
    std::size_t from = 0, to = a.size();
    while (from < to && a[from] == 0) ++from;
    while (to > from && a[to - 1] == 0) --to;
    if (from == to) return roots;
    if (from > 0 && a[from] < 0) roots.push_back({0, 0, 0});
    const Sturm sturm(std::vector<Integer>(a.begin() + static_cast<std::ptrdiff_t>(from),
                                           a.begin() + static_cast<std::ptrdiff_t>(to)));
    const std::function<void(double, double, int)> search = [&](double low, double high,
                                                                int depth) {
      const int count = sturm.distinct(place(low), place(high));
      if (count == 0) return;
      const int at_low = sturm.sign(place(low)), at_high = sturm.sign(place(high));
      if (count == 1 && at_low > 0 && at_high > 0) return;
      if (count == 1 && depth > 40) {
        roots.push_back({low, high, 0});
        if (at_low < 0 && at_high < 0) roots.push_back({low, high, 0});
        return;
      }
      for (const double k : {0.5, 0.4375, 0.5625, 0.375, 0.625, 0.25, 0.75}) {
        const double mid = low + (high - low) * k;
        if (sturm.sign(place(mid)) == 0) continue;
        search(low, mid, depth + 1);
        search(mid, high, depth + 1);
        return;
      }
    };
    search(0, 1, 0);
    if (to < a.size() && a[to - 1] < 0) roots.push_back({1, 1, 0});
    const SimplexForms<double, 2> doubles(approximate_products<2>(field_, {first, second}));
    set_levels(roots, doubles.cube(), context.state(first, *worker_), context.level.neutral);
    return roots;
  }

  static void set_levels(std::vector<RootRecord>& roots, const Form<double, 2, 3>& cube,
                         State state, bool neutral) {
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (state != 0) {
        roots[i].level = state, state = 0;
        continue;
      }
      const double t = roots[i].high, s = 1 - t;
      const double det = cube.c[0] * s * s * s + cube.c[1] * s * s * t + cube.c[2] * s * t * t +
                         cube.c[3] * t * t * t;
      roots[i].level = det > 0 || neutral ? 1 : -1;
      state = roots[i].level;
    }
  }

  u32 count_roots(u32 a, u32 b) {
    const Edge key = sorted(Edge{a, b});
    if (const auto at = split_.find(key); at != split_.end())
      return count_roots(a, at->second) + count_roots(at->second, b);
    return roots_of_[key];
  }

  void emit_face(const Face& corners) {
    const Face key = sorted(corners);
    if (const auto at = face_split_.find(key); at != face_split_.end()) {
      const Edge edge = at->second;
      const u32 m = split_[edge];
      for (unsigned k = 0; k < 3; ++k) {
        if (sorted(Edge{corners[k], corners[(k + 1) % 3]}) != edge) continue;
        made_.codes.push_back(static_cast<std::uint8_t>(k));
        emit_edge(corners[(k + 2) % 3], m);
        emit_face(replaced(corners, corners[(k + 1) % 3], m));
        emit_face(replaced(corners, corners[k], m));
        return;
      }
    }
    const auto at = face_fates_.find(key);
    if (at == face_fates_.end() || at->second == Fate::open)
      return made_.codes.push_back(modes_code::kOpenFace);
    if (at->second == Fate::rejected) return made_.codes.push_back(modes_code::kRejectedFace);
    const Witness found = *witness(corners);
    made_.codes.push_back(found.plain ? modes_code::kPlainFace : modes_code::kGraphFace);
    made_.face_witnesses.push_back({{found.w[0], found.w[1]}, found.lambda});
    u32 roots = 0;
    for (unsigned k = 0; k < 3; ++k) roots += count_roots(corners[k], corners[(k + 1) % 3]);
    // Which arcs: found later.
    for (u32 i = 0; i < roots / 2; ++i) made_.arcs.push_back({0, 0});
  }

  void emit_cell(const Tet& cell) {
    const Fate found = fates_[sorted(cell)];
    if (found != Fate::split) leaves_.push_back(key_of(cell));
    if (found == Fate::split) {
      const Edge edge = longest(cell);
      const u32 m = split_[edge];
      for (unsigned k = 0; k < 6; ++k) {
        const auto [i, j] = kEdges[k];
        if (sorted(Edge{cell[i], cell[j]}) != edge) continue;
        made_.codes.push_back(static_cast<std::uint8_t>(k));
        Face inner{};
        unsigned at = 0;
        for (unsigned v = 0; v < 4; ++v)
          if (v != i && v != j) inner[at++] = cell[v];
        inner[2] = m;
        emit_face(inner);
        emit_cell(replaced(cell, cell[j], m));
        emit_cell(replaced(cell, cell[i], m));
        return;
      }
    }
    if (found == Fate::rejected) return made_.codes.push_back(modes_code::kRejectedTet);
    if (found == Fate::open) {
      ++made_.open_tets;
      return made_.codes.push_back(modes_code::kOpenTet);
    }
    const Witness w = *witness(cell);
    made_.codes.push_back(w.plain ? modes_code::kPlainTet : modes_code::kGraphTet);
    made_.tet_witnesses.push_back({w.w, w.lambda, {0, 0}});
  }

  /// Arcs, pieces by trying, counts as found. False: cells must be divided further.
  bool finish() {
    field_.drop_splits();
    worker_ = std::make_unique<Worker>(field_);
    Trees trees = read_trees(made_, domain_, field_);
    trees.mark_needed(domain_, field_);
    const LevelContext context(made_, field_, trees);
    for (const FaceNode& face : trees.faces)
      if (face.arcs > 0)
        std::ranges::copy(find_arcs(context, face, *worker_), made_.arcs.begin() + face.arc);
    std::vector<CellPieces> pieces;
    bool good = true;
    for (std::size_t i = 0; i < trees.cells.size(); ++i) {
      const auto found = try_pieces(context, trees.cells[i]);
      if (!found) {
        forced_.insert(leaves_[i]);
        good = false;
      } else if (good) {
        pieces.push_back(*found);
      }
    }
    if (!good) return false;
    const LevelSurfaces surfaces = glue_pieces(context, domain_, pieces);
    made_.positive = surfaces.positive;
    made_.negative = surfaces.negative;
    return true;
  }

  std::optional<CellPieces> try_pieces(const LevelContext& context, const Cell& cell) {
    if (cell.code != modes_code::kGraphTet && cell.code != modes_code::kPlainTet)
      return check_one(context, cell, *worker_);
    for (std::uint8_t plus = 0; plus < 6; ++plus)
      for (std::uint8_t minus = 0; minus < 6; ++minus) {
        made_.tet_witnesses[cell.witness].pieces = {plus, minus};
        try {
          return check_one(context, cell, *worker_);
        } catch (const Reject&) {
        }
      }
    return std::nullopt;
  }

  Field& field_;
  const Domain& domain_;
  unsigned most_depth_;
  const Trees none_;
  std::unique_ptr<Worker> worker_;
  ModeLevel made_;
  std::map<Edge, u32> split_, roots_of_;
  std::map<Face, Edge> face_split_;
  std::map<Tet, Fate> fates_;
  std::map<Face, Fate> face_fates_;
  std::map<std::vector<u32>, std::optional<Witness>> witnesses_;
  std::vector<Face> certify_;
  std::vector<CellKey> leaves_;
  std::set<CellKey> forced_;
};

}  // namespace

ModesCertificate reference_modes(const ModesInput& input, const std::vector<MadeLevel>& levels,
                                 unsigned most_depth, std::vector<ZeroRecord> zeros) {
  ModesCertificate c;
  c.points = input.points;
  c.tets = input.tets;
  c.tensors = input.tensors;
  c.zeros = std::move(zeros);
  Field field(c.tensors);
  const Domain domain = build_domain(c, field);
  for (const MadeLevel& level : levels)
    c.levels.push_back(Producer(field, domain, level, most_depth).run());
  return c;
}

}  // namespace crest::tests
