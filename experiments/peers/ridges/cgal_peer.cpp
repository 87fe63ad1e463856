// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/peers/ridges/cgal_peer.hpp"

#define CGAL_EIGEN3_ENABLED 1
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Ridges.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Umbilics.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

namespace crest::peers {
namespace {

class CgalRidges {
 public:
  CgalRidges(const kernel::TriangleMesh& mesh, const CgalOptions& options) : options_(options) {
    Stopwatch watch;
    for (const auto& p : mesh.points()) mesh_.add_vertex(Point(p[0], p[1], p[2]));
    for (const auto& f : mesh.faces())
      if (mesh_.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2])) == Mesh::null_face())
        throw std::runtime_error("CGAL::Surface_mesh refuses a face");
    result_.mesh = watch.lap();
    fit(mesh);
    watch.lap();
    find_umbilics();
    result_.umbilics = watch.lap();
    find_ridges();
  }
  const CgalResult& result() const { return result_; }

 private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;
  using Numbers = Mesh::Property_map<Vertex, double>;
  using Vectors = Mesh::Property_map<Vertex, Vector>;
  using Fitting = CGAL::Monge_via_jet_fitting<Kernel>;
  using Ridges = CGAL::Ridge_approximation<Mesh, Numbers, Vectors>;
  using Line = Ridges::Ridge_line;

  Numbers numbers(const char* name) {
    return mesh_.add_property_map<Vertex, double>(name, 0).first;
  }
  Vectors vectors(const char* name) {
    return mesh_.add_property_map<Vertex, Vector>(name, Vector(0, 0, 0)).first;
  }

  /// The vertex and rings around it until there are enough points.
  void gather(const kernel::TriangleMesh& mesh, kernel::Index v) {
    gathered_.assign(1, v);
    mark_[v] = v;
    for (std::size_t begin = 0; gathered_.size() < options_.min_points;) {
      const std::size_t end = gathered_.size();
      for (std::size_t i = begin; i < end; ++i)
        for (const kernel::Index w : mesh.ring(gathered_[i]))
          if (std::exchange(mark_[w], v) != v) gathered_.push_back(w);
      if (gathered_.size() == end) break;
      begin = end;
    }
  }

  std::vector<Vector> vertex_normals(const kernel::TriangleMesh& mesh) const {
    std::vector<Vector> normals(mesh.vertex_count(), Vector(0, 0, 0));
    for (const auto& f : mesh.faces()) {
      const Point &a = mesh_.point(Vertex(f[0])), &b = mesh_.point(Vertex(f[1])),
                  &c = mesh_.point(Vertex(f[2]));
      const Vector n = CGAL::cross_product(b - a, c - a);
      for (const kernel::Index v : f) normals[v] = normals[v] + n / std::sqrt(n.squared_length());
    }
    return normals;
  }

  void fit(const kernel::TriangleMesh& mesh) {
    mark_.assign(mesh.vertex_count(), kernel::kNone);
    const std::vector<Vector> normals = vertex_normals(mesh);
    Stopwatch watch;
    std::vector<Point> points;
    for (kernel::Index v = 0; v < mesh.vertex_count(); ++v) {
      gather(mesh, v);
      points.clear();
      for (const kernel::Index w : gathered_) points.push_back(mesh_.point(Vertex(w)));
      result_.gather += watch.lap();
      if (points.size() < 15) throw std::runtime_error("too few points for CGAL's fit");
      Fitting fitting;
      auto m = fitting(points.begin(), points.end(), 4, 4);
      m.comply_wrt_given_normal(normals[v]);
      store(Vertex(v), m);
      result_.fit += watch.lap();
    }
  }

  void store(Vertex v, const Fitting::Monge_form& m) {
    const std::vector<double> c = m.coefficients();  // k1 k2 b0 b1 b2 b3 c0 .. c4
    d1_[v] = m.maximal_principal_direction();
    d2_[v] = m.minimal_principal_direction();
    k1_[v] = c[0];
    k2_[v] = c[1];
    b0_[v] = c[2];
    b3_[v] = c[5];
    p1_[v] = 3 * c[3] * c[3] + (c[0] - c[1]) * (c[6] - 3 * c[0] * c[0] * c[0]);
    p2_[v] = 3 * c[4] * c[4] + (c[1] - c[0]) * (c[10] - 3 * c[1] * c[1] * c[1]);
  }

  void find_umbilics() {
    std::vector<CGAL::Umbilic<Mesh>*> found;
    CGAL::compute_umbilics(mesh_, k1_, k2_, d1_, d2_, std::back_inserter(found),
                           options_.umbilic_size);
    for (const auto* raw : found) {
      const std::unique_ptr<const CGAL::Umbilic<Mesh>> umbilic(raw);
      // CGAL calls index +1/2 elliptic.
      if (umbilic->umbilic_type() == CGAL::ELLIPTIC_UMBILIC)
        ++result_.plus;
      else if (umbilic->umbilic_type() == CGAL::HYPERBOLIC_UMBILIC)
        ++result_.minus;
      else
        ++result_.other;
    }
  }

  void find_ridges() {
    Stopwatch watch;
    Ridges ridges(mesh_, k1_, k2_, b0_, b3_, d1_, d2_, p1_, p2_);
    result_.setup = watch.lap();
    std::vector<Line*> blue, red, crest;
    ridges.compute_max_ridges(std::back_inserter(blue), CGAL::Ridge_order_4);
    result_.blue = watch.lap();
    ridges.compute_min_ridges(std::back_inserter(red), CGAL::Ridge_order_4);
    result_.red = watch.lap();
    ridges.compute_crest_ridges(std::back_inserter(crest), CGAL::Ridge_order_4);
    result_.crest = watch.lap();
    result_.blue_lines = merge(blue);
    result_.red_lines = merge(red);
    for (auto* lines : {&blue, &red, &crest})
      for (Line* line : *lines) delete line;
  }

  /// Nodes are mesh edges, links join consecutive edges of a line.
  MergedLines merge(const std::vector<Line*>& lines) const {
    std::map<Mesh::Edge_index, std::set<Mesh::Edge_index>> links;
    for (const Line* line : lines) {
      const auto& edges = *line->line();
      for (auto at = edges.begin(); at != edges.end(); ++at) {
        const auto next = std::next(at);
        const Mesh::Edge_index a = mesh_.edge(at->first);
        links[a];
        if (next == edges.end() || mesh_.edge(next->first) == a) continue;
        links[a].insert(mesh_.edge(next->first));
        links[mesh_.edge(next->first)].insert(a);
      }
    }
    MergedLines merged;
    merged.lines = static_cast<int>(lines.size());
    std::set<Mesh::Edge_index> seen;
    for (const auto& [start, unused] : links) {
      if (!seen.insert(start).second) continue;
      std::vector<Mesh::Edge_index> todo{start};
      int ends = 0;
      while (!todo.empty()) {
        const auto& around = links.at(todo.back());
        todo.pop_back();
        ends += around.size() == 1 ? 1 : around.empty() ? 2 : 0;
        for (const auto e : around)
          if (seen.insert(e).second) todo.push_back(e);
      }
      ++merged.components;
      merged.loops += ends == 0;
      merged.open_ends += ends;
    }
    return merged;
  }

  CgalOptions options_;
  Mesh mesh_;
  Numbers k1_ = numbers("v:k1"), k2_ = numbers("v:k2"), b0_ = numbers("v:b0"),
          b3_ = numbers("v:b3"), p1_ = numbers("v:P1"), p2_ = numbers("v:P2");
  Vectors d1_ = vectors("v:d1"), d2_ = vectors("v:d2");
  std::vector<kernel::Index> gathered_, mark_;
  CgalResult result_;
};

}  // namespace

CgalResult run_cgal(const kernel::TriangleMesh& mesh, const CgalOptions& options) {
  return CgalRidges(mesh, options).result();
}

CgalResult run_cgal_within(unsigned seconds, const kernel::TriangleMesh& mesh,
                           const CgalOptions& options) {
  struct Message {
    CgalResult result;
    char error[200] = "";
  } message;
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    try {
      message.result = run_cgal(mesh, options);
    } catch (const std::exception& error) {
      std::strncpy(message.error, error.what(), sizeof message.error - 1);
    }
    _exit(write(ends[1], &message, sizeof message) == sizeof message ? 0 : 1);
  }
  close(ends[1]);
  const bool got = child > 0 && read(ends[0], &message, sizeof message) == sizeof message;
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  const bool late =
      WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  if (!got)
    throw std::runtime_error(late ? "not done after " + std::to_string(seconds) + " s" : "died");
  if (message.error[0] != 0) throw std::runtime_error(message.error);
  return message.result;
}

}  // namespace crest::peers
