// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/refinement.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/smooth_ridges/patches.hpp"
#include "algorithms/smooth_ridges/timed.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::smooth_ridges {
namespace {

/// SPEC.md, "Corners of the domain": the faces at one must agree, with one arc from there.
void mark_loose_corners(const Triangulation& mesh, const std::vector<FaceResult>& faces,
                        std::vector<Index>& marks) {
  struct Corner {
    std::vector<Index> faces;
    int loose = 0, slope = 0, opposite = 0, along = 0;
    bool shared = false;  ///< a face has another loose corner
  };
  std::map<std::pair<Index, std::size_t>, Corner> corners;
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t j = 0; j < 2; ++j) {
      const int k = faces[f].colour[j].loose_corner;
      if (k >= 0) corners[{mesh.faces()[f][static_cast<std::size_t>(k)], j}].loose += 1;
    }
  if (corners.empty()) return;
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = corners.find({mesh.faces()[f][k], j});
        if (at == corners.end()) continue;
        const ColourResult& c = faces[f].colour[j];
        at->second.faces.push_back(f);
        const int other = faces[f].colour[1 - j].loose_corner;
        at->second.shared = at->second.shared || (other >= 0 && other != static_cast<int>(k));
        at->second.opposite += c.crossed[(k + 1) % 3] ? 1 : 0;
        for (const std::size_t edge : {k, (k + 2) % 3}) {
          if (mesh.neighbours()[f][edge] != kNone) continue;
          at->second.slope += c.slope[edge];
          at->second.along += c.crossed[edge] ? 1 : 0;
        }
      }
  for (const auto& [key, c] : corners)
    if (c.loose != static_cast<int>(c.faces.size()) || std::abs(c.slope) != 2 || c.opposite != 1 ||
        c.along != 1 || c.shared)
      marks.insert(marks.end(), c.faces.begin(), c.faces.end());
}

SurfacePoint middle(const Surface& surface, const std::array<Vertex, 3>& c) {
  Vertex m{};
  for (std::size_t k = 0; k < 6; ++k) m[k] = (c[0][k] + c[1][k] + c[2][k]) / 3;
  SurfacePoint p;
  if (!surface.is_implicit()) {
    p.z = {m[0], m[1]};
    return p;
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(m[3 + k]) > std::fabs(m[3 + axis])) axis = k;
  const auto [i, j] = plane_axes(axis);
  p = {axis, {m[i], m[j]}, m[axis]};
  return p;
}

/// No test: the time is over.
void test_group(const Triangulation& mesh, std::span<const Index> group, FaceTest* test,
                std::vector<FaceResult>& all) {
  std::vector<std::array<Vertex, 3>> faces;
  for (const Index f : group) faces.push_back(mesh.corners(f));
  std::vector<FaceResult> results(group.size());
  if (test != nullptr) (*test)(faces, results);
  for (std::size_t i = 0; i < group.size(); ++i) {
    all[group[i]] = results[i];
    if (test == nullptr) all[group[i]].status = FaceStatus::untested;
  }
}

class Refinement {
 public:
  Refinement(const Surface& surface, Triangulation start, const RefinementOptions& options,
             const Stop& stop)
      : surface_(surface),
        options_(options),
        stop_(stop),
        places_(surface),
        find_umbilic_(surface),
        tests_([&surface] { return FaceTest(surface); }) {
    out_.mesh = std::move(start);
  }

  RefinedSurface run() {
    for (;; ++out_.rounds) {
      timed(out_.seconds.faces, [&] { test_new_faces(); });
      std::vector<Index> marks = timed(out_.seconds.umbilics, [&] {
        seek_umbilics();
        return place_patches();
      });
      mark_failures(marks);
      if (options_.progress) options_.progress(out_.rounds, count(), marks.size());
      const std::vector<Index> undecided = marks;
      leave_singular(marks);
      out_.stopped = !marks.empty() && is_over(stop_);
      if (marks.empty() || out_.stopped || out_.rounds >= options_.max_depth ||
          count() + marks.size() > options_.max_faces || stalls(marks)) {
        list_uncertified(undecided);
        break;
      }
      timed(out_.seconds.bisection, [&] { out_.mesh.refine(marks); });
    }
    sort_patches();
    return std::move(out_);
  }

 private:
  std::size_t count() const { return out_.mesh.faces().size(); }

  void test_new_faces() {
    std::vector<Index> fresh;
    known_.resize(count(), UINT64_MAX);
    out_.faces.resize(count());
    for (Index f = 0; f < count(); ++f)
      if (known_[f] != out_.mesh.ids()[f]) fresh.push_back(f);
    constexpr std::size_t kTogether = 64;
    const std::size_t groups = (fresh.size() + kTogether - 1) / kTogether;
    kernel::parallel_for(std::size_t{0}, groups, [&](std::size_t g) {
      const std::size_t begin = g * kTogether, count = std::min(kTogether, fresh.size() - begin);
      const auto group = std::span(fresh).subspan(begin, count);
      test_group(out_.mesh, group, is_over(stop_) ? nullptr : &tests_.local(), out_.faces);
    });
    for (const Index f : fresh) known_[f] = out_.mesh.ids()[f];
    out_.tests += fresh.size();
    fresh_ = std::move(fresh);
  }

  /// Newton's method from the new faces that are not regular; a new umbilic is proven at once.
  void seek_umbilics() {
    constexpr int kGiveUp = 32;  // a sphere has as many as one likes
    for (const Index f : fresh_) {
      if (out_.faces[f].status != FaceStatus::regular || degenerate_ > kGiveUp) continue;
      if (is_over(stop_)) return;
      const auto corners = out_.mesh.corners(f);
      const double size = longest(corners);
      const SurfacePoint start = middle(surface_, corners);
      auto found = find_umbilic_(start, surface_.is_implicit() ? 3 * size : 0.25);
      if (!found || !bring_inside(*found)) continue;
      const Vec3 place = point(*found);
      if (std::any_of(seen_.begin(), seen_.end(), [&](const Vec3& other) {
            return norm(place - other) < 1e-9 * (1 + norm(place));
          }))
        continue;
      seen_.push_back(place);
      if (auto proven = prove_umbilic(surface_, *found, largest_radius(*found)))
        out_.patches.push_back({*proven, {}, false, {}, 0});
      else
        ++degenerate_;
    }
  }

  Vec3 point(const SurfacePoint& p) {
    if (surface_.is_implicit()) return in_space(p);
    return places_({p.z[0], p.z[1]});
  }

  /// Brings unit coordinates back into the period; false outside the domain or the box.
  bool bring_inside(SurfacePoint& p) const {
    if (surface_.is_implicit()) {
      const Vec3 x = in_space(p);
      for (std::size_t k = 0; k < 3; ++k)
        if (x[k] < surface_.box()[2 * k] || x[k] > surface_.box()[2 * k + 1]) return false;
      return true;
    }
    for (std::size_t d = 0; d < 2; ++d) {
      if (surface_.periodic(d)) p.z[d] -= std::floor(p.z[d]);
      if (!(p.z[d] > 0 && p.z[d] < 1)) return false;
    }
    return true;
  }
  /// Q must stay in the domain.
  double largest_radius(const SurfacePoint& p) const {
    if (surface_.is_implicit()) {
      double size = 0;
      for (std::size_t k = 0; k < 3; ++k)
        size = std::max(size, surface_.box()[2 * k + 1] - surface_.box()[2 * k]);
      return size / 16;
    }
    double r = 0.25;
    for (std::size_t d = 0; d < 2; ++d)
      if (!surface_.periodic(d)) r = std::min({r, 0.9 * p.z[d], 0.9 * (1 - p.z[d])});
    return r;
  }

  std::vector<Index> place_patches() {
    std::vector<Index> marks;
    out_.patch_of.assign(count(), kNone);
    for (std::size_t k = 0; k < out_.patches.size(); ++k) {
      UmbilicPatch& patch = out_.patches[k];
      const auto meets = [&](Index f) { return may_meet(surface_, out_.mesh, patch.umbilic, f); };
      std::erase_if(patch.near, [&](Index f) { return !meets(f); });
      for (; patch.looked_at < count(); ++patch.looked_at)
        if (const auto f = static_cast<Index>(patch.looked_at); meets(f)) patch.near.push_back(f);
      PatchSearch search =
          find_patch(surface_, out_.mesh, patch.umbilic, patch.near, tests_.local());
      // Faces within Q wait for the others: refining them would only cost.
      patch.faces = std::move(search.faces);
      patch.complete = search.too_large.empty();
      marks.insert(marks.end(), search.too_large.begin(), search.too_large.end());
      for (const Index f : patch.faces) {
        if (out_.patch_of[f] != kNone) marks.push_back(f);
        out_.patch_of[f] = static_cast<Index>(k);
      }
    }
    return marks;
  }

  void mark_failures(std::vector<Index>& marks) {
    for (Index f = 0; f < count(); ++f) {
      if (out_.patch_of[f] != kNone) continue;
      if (out_.faces[f].status != FaceStatus::proven) {
        marks.push_back(f);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
        if (!edge_decided(f, k)) marks.push_back(f);
    }
    mark_loose_corners(out_.mesh, out_.faces, marks);
    // Crossings at a patch's border must be its branches.
    for (const UmbilicPatch& patch : out_.patches)
      if (patch.complete && !border_agrees(patch))
        marks.insert(marks.end(), patch.faces.begin(), patch.faces.end());
    std::sort(marks.begin(), marks.end());
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  }

  bool edge_decided(Index f, std::size_t k) const {
    const Index n = out_.mesh.neighbours()[f][k];
    const bool outside =
        n != kNone && out_.patch_of[n] == kNone && out_.faces[n].status == FaceStatus::proven;
    for (std::size_t j = 0; j < 2; ++j) {
      const auto decides = [j](const FaceResult& r, std::size_t edge) {
        return r.colour[j].no_zero || r.colour[j].edge_decided[edge];
      };
      if (decides(out_.faces[f], k) || at_loose_corner(out_.faces[f].colour[j], k)) continue;
      if (!outside || !decides(out_.faces[n], out_.mesh.edge_towards(n, f))) return false;
    }
    return true;
  }

  /// Whether edge k ends at a corner of the domain where the sign is not certain.
  static bool at_loose_corner(const ColourResult& c, std::size_t k) {
    return c.loose_corner >= 0 && static_cast<std::size_t>(c.loose_corner) != (k + 2) % 3;
  }

  /// False if the crossings at a patch's border are known and are not its branches.
  bool border_agrees(const UmbilicPatch& patch) const {
    std::array<int, 2> crossed{};
    for (const Index f : patch.faces)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index n = out_.mesh.neighbours()[f][k];
        if (n == kNone) return false;
        if (out_.patch_of[n] == out_.patch_of[f]) continue;
        if (out_.patch_of[n] != kNone) return false;
        if (out_.faces[n].status != FaceStatus::proven) return true;
        const std::size_t edge = out_.mesh.edge_towards(n, f);
        if (!edge_decided(n, edge)) return true;
        for (std::size_t j = 0; j < 2; ++j)
          crossed[j] += out_.faces[n].colour[j].crossed[edge] ? 1 : 0;
      }
    return crossed == patch.umbilic.branches.count;
  }

  /// Takes the faces around singularities of ridges off the marks. They are looked for where the
  /// undecided faces do not become fewer: along regular ridges they do.
  void leave_singular(std::vector<Index>& marks) {
    constexpr std::size_t kFirstRound = 8, kRounds = 4;
    undecided_.push_back(marks.size());
    const std::size_t n = undecided_.size();
    if (n > kFirstRound && undecided_[n - 1] >= undecided_[n - 1 - kRounds]) {
      if (!finder_) finder_.emplace(surface_);
      for (const Index f : marks) {
        const FaceResult& face = out_.faces[f];
        if (face.status != FaceStatus::ridge || is_left(f)) continue;
        const auto corners = out_.mesh.corners(f);
        for (const Colour colour : {Colour::blue, Colour::red}) {
          if (face.colour[static_cast<std::size_t>(colour)].no_zero) continue;
          const double size = longest(corners);
          if (const auto found = finder_->near(middle(surface_, corners), colour, size))
            out_.singularities.push_back({point(*found), colour, 3 * size});
        }
      }
    }
    if (!out_.singularities.empty()) std::erase_if(marks, [&](Index f) { return is_left(f); });
  }
  bool is_left(Index f) {
    const Vec3 p = point(middle(surface_, out_.mesh.corners(f)));
    return std::any_of(out_.singularities.begin(), out_.singularities.end(),
                       [&](const auto& s) { return norm(s.place - p) < s.reach; });
  }

  /// Whether the undecided part has not lost half its area in six rounds: around points and
  /// curves it loses more; a sphere or a surface of revolution keeps all of it.
  bool stalls(const std::vector<Index>& marks) {
    constexpr std::size_t kRounds = 6;
    double area = 0;
    for (const Index f : marks) {
      const auto c = out_.mesh.corners(f);
      const std::array<Vec3, 3> x = {places_(c[0]), places_(c[1]), places_(c[2])};
      area += norm(cross(x[1] - x[0], x[2] - x[0]));
    }
    undecided_area_.push_back(area);
    const std::size_t n = undecided_area_.size();
    return n > kRounds && area > 0.5 * undecided_area_[n - 1 - kRounds];
  }

  void list_uncertified(const std::vector<Index>& marks) {
    for (const Index f : marks) {
      const auto corners = out_.mesh.corners(f);
      Vertex m{};
      for (std::size_t k = 0; k < 6; ++k)
        m[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
      out_.uncertified.push_back({f, out_.faces[f].status, places_(m), longest(corners)});
    }
  }

  double longest(const std::array<Vertex, 3>& c) {
    const std::array<Vec3, 3> x = {places_(c[0]), places_(c[1]), places_(c[2])};
    return std::max({norm(x[0] - x[1]), norm(x[1] - x[2]), norm(x[2] - x[0])});
  }

  void sort_patches() {
    std::erase_if(out_.patches, [](const UmbilicPatch& p) { return !p.complete; });
    std::sort(out_.patches.begin(), out_.patches.end(),
              [](const UmbilicPatch& a, const UmbilicPatch& b) { return a.faces[0] < b.faces[0]; });
    out_.patch_of.assign(count(), kNone);
    for (std::size_t k = 0; k < out_.patches.size(); ++k)
      for (const Index f : out_.patches[k].faces) out_.patch_of[f] = static_cast<Index>(k);
  }

  const Surface& surface_;
  const RefinementOptions& options_;
  const Stop& stop_;
  Places places_;
  UmbilicFinder find_umbilic_;
  tbb::enumerable_thread_specific<FaceTest> tests_;
  RefinedSurface out_;
  std::vector<std::uint64_t> known_;  ///< the id that faces[f] speaks of
  std::vector<Index> fresh_;
  std::vector<Vec3> seen_;  ///< umbilics found so far
  int degenerate_ = 0;      ///< umbilics found but not proven
  std::optional<SingularityFinder> finder_;
  std::vector<std::size_t> undecided_;  ///< by round
  std::vector<double> undecided_area_;  ///< by round
};

}  // namespace

RefinedSurface refine(const Surface& surface, Triangulation start, const RefinementOptions& options,
                      const Stop& stop) {
  return Refinement(surface, std::move(start), options, stop).run();
}

Places::Places(const Surface& surface) {
  if (!surface.is_implicit()) map_.emplace(surface);
}

Vec3 Places::operator()(const Vertex& v) {
  if (!map_) return {v[0], v[1], v[2]};
  const auto x = (*map_)(std::array<double, 2>{v[0], v[1]});
  return {x[0][0], x[1][0], x[2][0]};
}

}  // namespace crest::smooth_ridges
