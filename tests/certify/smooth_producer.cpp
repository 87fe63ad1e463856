// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/smooth_producer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "certify/smooth_witness/record.hpp"
#include "certify/surface/mesh_checks.hpp"
#include "tests/certify/smooth_samples.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using u32 = std::uint32_t;

/// Patches grow from the vertex nearest to each umbilic.
class ClaimFiller {
 public:
  ClaimFiller(RidgesSmoothCertificate& c, int rings) : c_(c), sampler_(c), rings_(rings) {
    topology_ = build_topology(c.faces, c.vertices.size());
    patch_of_.assign(c.faces.size(), kNone);
    c.face_records.assign(c.faces.size(), {});
    c.patches.clear();
    for (const Umbilic& u : sampler_.umbilics()) c.patches.push_back(make_patch(u));
    std::sort(c.patches.begin(), c.patches.end(),
              [](auto& a, auto& b) { return a.faces.front() < b.faces.front(); });
    for (u32 p = 0; p < c.patches.size(); ++p)
      for (const u32 f : c.patches[p].faces) {
        patch_of_[f] = p;
        c.face_records[f] = {};
        c.face_records[f].in_patch = true;
      }
    for (u32 f = 0; f < c.faces.size(); ++f)
      if (patch_of_[f] == kNone) sampler_.fill(f, crossed_[f]);
    fill_counts();
  }

 private:
  SmoothPatchRecord make_patch(const Umbilic& u) {
    SmoothPatchRecord p;
    p.centre = u.at;
    p.twice_index = static_cast<std::int8_t>(u.index);
    std::set<u32> faces = {u.face};
    for (int ring = 0; ring < rings_; ++ring) {
      std::set<u32> vertices;
      for (const u32 f : faces) vertices.insert(c_.faces[f].begin(), c_.faces[f].end());
      for (const u32 v : vertices)
        for (u32 i = topology_.ring_start[v]; i < topology_.ring_start[v + 1]; ++i)
          faces.insert(topology_.ring[i] / 3);
    }
    p.faces.assign(faces.begin(), faces.end());
    double far = 0;
    for (const u32 f : p.faces) far = std::max(far, sampler_.distance(u, f));
    p.radius = far * 1.1;
    p.rho = p.radius * 0x1p-20;
    return p;
  }

  bool inside(u32 side) const { return side == kNone || patch_of_[side / 3] != kNone; }

  /// Branches from crossed border edges; loops and paths by union of edges.
  void fill_counts() {
    c_.euler_characteristic = static_cast<std::int32_t>(topology_.euler_characteristic);
    c_.boundary_loops = topology_.boundary_loops;
    c_.components = 1;
    for (std::size_t j = 0; j < 2; ++j) {
      std::vector<u32> parent(topology_.edges.size());
      for (u32 e = 0; e < parent.size(); ++e) parent[e] = e;
      const auto root = [&](u32 e) {
        while (parent[e] != e) e = parent[e] = parent[parent[e]];
        return e;
      };
      std::map<u32, int> ends;  // by component
      std::set<u32> nodes;
      for (u32 f = 0; f < c_.faces.size(); ++f) {
        if (patch_of_[f] != kNone) continue;
        std::vector<u32> on;
        for (u32 i = 0; i < 3; ++i)
          if ((crossed_[f][j] >> i & 1U) != 0) on.push_back(topology_.edge_of[3 * f + i]);
        nodes.insert(on.begin(), on.end());
        if (on.size() == 2) parent[root(on[0])] = root(on[1]);
      }
      for (const u32 e : nodes) {
        const Edge& edge = topology_.edges[e];
        ends[root(e)] += (inside(edge.forward) ? 1 : 0) + (inside(edge.backward) ? 1 : 0);
        for (const u32 side : {edge.forward, edge.backward})
          if (side != kNone && patch_of_[side / 3] != kNone)
            ++c_.patches[patch_of_[side / 3]].branches[j];
      }
      c_.counts[2 * j] = c_.counts[2 * j + 1] = c_.turning_points[j] = 0;
      for (const auto& [component, n] : ends) ++c_.counts[2 * j + (n > 0 ? 1 : 0)];
      for (const auto& r : c_.face_records) c_.turning_points[j] += r.type[j] == 3;
    }
    c_.purple_points = 0;
    for (const auto& r : c_.face_records) c_.purple_points += r.purple;
    c_.umbilics = {};
    for (const auto& p : c_.patches) {
      ++c_.umbilics[p.twice_index > 0 ? 0 : 1];
      ++c_.umbilics[p.branches[0] == 1 ? 2 : 3];
    }
  }

  RidgesSmoothCertificate& c_;
  SmoothSampler sampler_;
  int rings_;
  Topology topology_;
  std::vector<u32> patch_of_;
  std::map<u32, std::array<unsigned, 2>> crossed_;
};

}  // namespace

RidgesSmoothCertificate smooth_grid(const SmoothSurfaceData& surface, int nu, int nv, double jitter,
                                    int rings, std::uint64_t seed) {
  RidgesSmoothCertificate c;
  c.surface = surface;
  const int periodic[] = {surface.periodic & 1, surface.periodic >> 1 & 1};
  const int n[] = {nu, nv}, points[] = {nu + 1 - periodic[0], nv + 1 - periodic[1]};
  Random random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  for (int j = 0; j < points[1]; ++j)
    for (int i = 0; i < points[0]; ++i) {
      const int at[] = {i, j};
      std::array<double, 6> v{};
      for (std::size_t d = 0; d < 2; ++d) {
        const bool fixed = at[d] == 0 || at[d] == n[d];
        v[d] = (at[d] + (fixed ? 0 : shift(random))) / n[d];
      }
      c.vertices.push_back(v);
    }
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i)
      for (int half = 0; half < 2; ++half) {
        const int corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
        std::array<u32, 3> face{};
        unsigned lift = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          int x = i + corner[half][k][0], y = j + corner[half][k][1];
          if (x == points[0]) x = 0, lift |= 1U << k;
          if (y == points[1]) y = 0, lift |= 8U << k;
          face[k] = static_cast<u32>(y * points[0] + x);
        }
        c.faces.push_back(face);
        c.lifts.push_back(static_cast<std::uint8_t>(lift));
      }
  if (surface.periodic == 0) c.lifts.clear();
  const ClaimFiller filler(c, rings);
  if (const auto open = record_witnesses(c)) throw std::runtime_error(*open);
  return c;
}

SmoothSurfaceData parametric(std::string x, std::string y, std::string z,
                             std::array<std::string, 4> domain, int periodic) {
  SmoothSurfaceData s;
  s.kind = 1;
  s.texts = {std::move(x), std::move(y), std::move(z)};
  s.texts.insert(s.texts.end(), domain.begin(), domain.end());
  s.periodic = static_cast<std::uint8_t>(periodic);
  return s;
}
std::vector<NamedSmoothClaim> smooth_claims() {
  const auto field = parametric("u", "v",
                                "0.3*u^2 + 0.1*v^2 + 0.1*u^3 - 0.05*u*v^2 + 0.02*v^4 + "
                                "0.07*u^2*v + 0.06*v^3",
                                {"0", "1", "0", "1"});
  const auto lemon = parametric("u", "v",
                                "(u^2 + v^2)/2 + 0.5*u^3 + 0.1*u^2*v + 0.2*u*v^2 + 0.15*v^3 + "
                                "0.1*u^4",
                                {"-0.1", "0.1", "-0.1", "0.1"});
  const auto star = parametric("u", "v",
                               "(u^2 + v^2)/2 + 0.2*u^3 - 0.6*u*v^2 + 0.15*u^2*v + 0.1*u^4 + "
                               "0.07*v^4",
                               {"-0.1", "0.1", "-0.1", "0.1"});
  const std::string radius = "(1 + 0.1*sin(2*u + 0.3) + 0.2*v + 0.05*v^2)";
  const auto tube = parametric(radius + "*cos(u)", radius + "*sin(u)", "v + 0.05*cos(u)",
                               {"0", "2*pi", "0", "0.5"}, 1);
  return {{"height field", smooth_grid(field, 12, 12, 0.1, 2, 7)},
          {"index +1/2", smooth_grid(lemon, 16, 16, 0.1, 3, 1)},
          {"index -1/2", smooth_grid(star, 16, 16, 0.1, 3, 1)},
          {"tube", smooth_grid(tube, 48, 8, 0.1, 2, 1)}};
}

}  // namespace crest::tests
