// SPDX-License-Identifier: GPL-3.0-or-later
// The other school (section 1.3): n is oriented once and for all, node by node along the most
// parallel edges, and g = n . grad s is contoured by marching tetrahedra. On a one-sided sheet
// there is no such orientation: a seam must be left.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "algorithms/extremal/extraction.hpp"
#include "experiments/000-extremal/inputs.hpp"
#include "experiments/program.hpp"
#include "io/extremal/extremal_picture.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::experiments {
namespace {

using namespace extremal;
using kernel::Vec3;

/// Signs of directions at the nodes along a maximal spanning forest of |n . n'|.
class GreedyOrientation {
 public:
  explicit GreedyOrientation(const Extraction& e) : e_(e), sign_(e.fields().grid().nodes(), 1) {
    struct Link {
      double parallel;
      std::size_t a, b;
    };
    const Grid& grid = e.fields().grid();
    std::vector<Link> links;
    for (std::size_t v = 0; v < grid.nodes(); ++v)
      for (std::size_t k = 0; k < 3; ++k) {
        if (grid.node(v)[k] + 1 >= grid.size[k]) continue;
        const std::size_t w = v + grid.stride[k];
        if (e.nodes().active(v) && e.nodes().active(w))
          links.push_back({std::fabs(kernel::dot(unit_direction(v), unit_direction(w))), v, w});
      }
    std::stable_sort(links.begin(), links.end(),
                     [](const Link& a, const Link& b) { return a.parallel > b.parallel; });
    // Trees with their members, the smaller joined to the larger.
    std::vector<std::size_t> tree(grid.nodes());
    std::iota(tree.begin(), tree.end(), std::size_t{0});
    std::vector<std::vector<std::size_t>> members(grid.nodes());
    for (std::size_t v = 0; v < grid.nodes(); ++v) members[v] = {v};
    for (const Link& link : links) {
      std::size_t a = tree[link.a], b = tree[link.b];
      if (a == b) continue;
      const bool turn = kernel::dot(oriented(link.a), oriented(link.b)) < 0;
      if (members[a].size() < members[b].size()) std::swap(a, b);
      for (const std::size_t v : members[b]) {
        tree[v] = a;
        if (turn) sign_[v] = -sign_[v];
        members[a].push_back(v);
      }
      members[b].clear();
    }
  }
  double g(std::size_t v) const {
    return kernel::dot(oriented(v), e_.fields().at_node(e_.fields().grid().node(v)).gradient);
  }

 private:
  Vec3 unit_direction(std::size_t v) const {
    const Vec3 n = e_.nodes().direction(v);
    return (1 / kernel::norm(n)) * n;
  }
  Vec3 oriented(std::size_t v) const { return static_cast<double>(sign_[v]) * unit_direction(v); }
  const Extraction& e_;
  std::vector<int> sign_;
};

/// Marching tetrahedra on g in the cells whose nodes are active and bright.
class Marching {
 public:
  Marching(const Extraction& e, const GreedyOrientation& orientation, double min_value)
      : grid_(e.fields().grid()), edges_(e.edges()) {
    std::vector<double> g(grid_.nodes());
    std::vector<char> use(grid_.nodes());
    for (std::size_t v = 0; v < grid_.nodes(); ++v)
      if (e.nodes().active(v) && value(e, grid_.node(v)) >= min_value) {
        use[v] = 1;
        g[v] = orientation.g(v);
      }
    for (std::size_t v = 0; v < grid_.nodes(); ++v) {
      if (!grid_.is_cell(grid_.node(v))) continue;
      // Six tetrahedra round the diagonal.
      std::array<std::size_t, 3> order = {0, 1, 2};
      do {
        std::array<std::size_t, 4> t = {v, 0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i) t[i + 1] = t[i] + grid_.stride[order[i]];
        if (use[t[0]] && use[t[1]] && use[t[2]] && use[t[3]]) add(t, g);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
  Result result() const {
    Result r;
    r.points = points_;
    r.corners = corners_;
    for (std::size_t i = 3; i <= corners_.size(); i += 3)
      r.first.push_back(static_cast<kernel::Index>(i));
    r.critical_type.assign(corners_.size() / 3, 1);
    for (std::size_t i = 0; i < corners_.size(); i += 3)
      r.plateness.push_back(
          seam_[corners_[i]] || seam_[corners_[i + 1]] || seam_[corners_[i + 2]] ? 0.5 : 1);
    r.normals.assign(points_.size(), Vec3{});
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      const Vec3 n = kernel::cross(points_[corners_[i + 1]] - points_[corners_[i]],
                                   points_[corners_[i + 2]] - points_[corners_[i]]);
      for (std::size_t k = 0; k < 3; ++k) {
        Vec3& sum = r.normals[corners_[i + k]];
        sum = kernel::dot(sum, n) < 0 ? sum - n : sum + n;  // one-sided: on either side
      }
    }
    for (Vec3& n : r.normals) n = (1 / std::max(kernel::norm(n), 1e-300)) * n;
    return r;
  }

 private:
  /// An edge of the grid that is certified not to be critical.
  bool is_false(std::size_t a, std::size_t b) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = static_cast<kernel::Index>(3 * a + k);
      if (b == a + grid_.stride[k]) return edges_.tested(edge) && !edges_.critical(edge);
    }
    return false;
  }
  static double value(const Extraction& e, Node v) {
    Vec3 t{};
    for (std::size_t k = 0; k < 3; ++k)
      if (v[k] == e.fields().grid().size[k] - 1) {
        --v[k];
        t[k] = 1;
      }
    return e.fields().at(v, t).value;
  }
  kernel::Index cut(std::size_t a, std::size_t b, const std::vector<double>& g) {
    if (a > b) std::swap(a, b);
    const auto [at, is_new] =
        cuts_.emplace(std::pair(a, b), static_cast<kernel::Index>(points_.size()));
    if (is_new) {
      const double t = g[a] / (g[a] - g[b]);
      const auto place = [&](std::size_t v) {
        const Node n = grid_.node(v);
        return grid_.position({double(n[0]), double(n[1]), double(n[2])});
      };
      points_.push_back((1 - t) * place(a) + t * place(b));
      seam_.push_back(is_false(a, b));
    }
    return at->second;
  }
  void add(const std::array<std::size_t, 4>& t, const std::vector<double>& g) {
    std::vector<std::size_t> high, low;
    for (const std::size_t v : t) (g[v] > 0 ? high : low).push_back(v);
    if (high.size() == 2) {
      const kernel::Index q[4] = {cut(high[0], low[0], g), cut(high[0], low[1], g),
                                  cut(high[1], low[1], g), cut(high[1], low[0], g)};
      for (const std::size_t i : {0, 1, 2, 0, 2, 3}) corners_.push_back(q[i]);
    } else if (high.size() == 1 || low.size() == 1) {
      const auto& one = high.size() == 1 ? high : low;
      const auto& three = high.size() == 1 ? low : high;
      for (const std::size_t v : three) corners_.push_back(cut(one[0], v, g));
    }
  }
  Grid grid_;
  const Edges& edges_;
  std::vector<char> seam_;  ///< points on such edges
  std::map<std::pair<std::size_t, std::size_t>, kernel::Index> cuts_;
  std::vector<Vec3> points_;
  std::vector<kernel::Index> corners_;
};

struct Topology {
  std::int64_t euler;
  std::size_t components, rim;
};

Topology topology_of(const Result& r) {
  std::map<std::pair<kernel::Index, kernel::Index>, int> edges;
  kernel::DisjointSets sets(static_cast<kernel::Index>(r.points.size()));
  for (std::size_t i = 0; i < r.corners.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = r.corners[i + k], b = r.corners[i + (k + 1) % 3];
      ++edges[std::minmax(a, b)];
      sets.unite(a, b);
    }
  std::size_t rim = 0;
  for (const auto& [edge, count] : edges) rim += count == 1 ? 1 : 0;
  return {static_cast<std::int64_t>(r.points.size()) - static_cast<std::int64_t>(edges.size()) +
              static_cast<std::int64_t>(r.corners.size() / 3),
          sets.count(), rim};
}

void row(const std::string& name, int nodes, const std::string& picture) {
  const double min_value = 0.4;
  const Options options = ridge_options(false, min_value);
  const Extraction e(Fields(phantom(name, static_cast<std::size_t>(nodes)), options), options);
  const GreedyOrientation orientation(e);
  const Grid& grid = e.fields().grid();
  std::size_t critical = 0, false_ones = 0, missed = 0;
  for (std::size_t v = 0; v < grid.nodes(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = static_cast<kernel::Index>(3 * v + k);
      if (!e.edges().tested(edge)) continue;
      const bool truth = e.edges().critical(edge);
      const bool greedy = orientation.g(v) * orientation.g(v + grid.stride[k]) < 0;
      critical += truth ? 1 : 0;
      false_ones += greedy && !truth ? 1 : 0;
      missed += !greedy && truth ? 1 : 0;
    }
  const Result r = Marching(e, orientation, min_value).result();
  const Topology t = topology_of(r);
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, nodes, critical, false_ones,
             missed, r.polygons(), t.components, t.euler, t.rim);
  if (!picture.empty()) io::write_extremal_picture(picture, r);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest;
  int nodes = 48;
  std::string picture, only;
  experiments::Program program("Marching tetrahedra after a greedy orientation of n.");
  program.option("--nodes", nodes, "along each axis", {8, 256});
  program.option("--only", only, "one phantom");
  program.option("--picture", picture, "of the last mesh");
  return program.run(argc, argv, [&] {
    fmt::print(
        "Structure, sigma 1, min-value 0.4; of the picture the triangles on false edges are blue. "
        "False and missed: edges of the grid against the "
        "certified flags\n\n"
        "| sheet | nodes | critical edges | false | missed | triangles | components | chi | edges "
        "of valence 1 |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& p : sampling::volume_phantoms())
      if (only.empty() || p.name == only) experiments::row(p.name, nodes, picture);
    return 0;
  });
}
