// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/edge_states.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <array>

#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/acute_rule.hpp"
#include "kernel/predicates/extremality_sign.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;
using kernel::Stage;

std::int8_t as_int(kernel::Sign s) {
  return static_cast<std::int8_t>(s);
}

kernel::Decision plain_acute_rule(const Vec3& d, const Vec3& e) {
  return {kernel::dot(d, e) < 0 ? kernel::Sign::negative : kernel::Sign::positive, Stage::triage};
}

struct SignCounts {
  StageCounts stages;
  std::array<Index, 2> zeros{};  ///< by colour
};

void decide_extremalities(const kernel::MeshPiece& piece, const std::vector<MongeForm>& forms,
                          EdgeStates& s) {
  for (auto& signs : s.extremality) signs.resize(forms.size());
  tbb::enumerable_thread_specific<SignCounts> counts;
  kernel::parallel_for(
      tbb::blocked_range<std::size_t>(0, forms.size(), 8192), [&](const auto& range) {
        SignCounts& local = counts.local();
        for (std::size_t v = range.begin(); v != range.end(); ++v)
          for (std::size_t c = 0; c < 2; ++c) {
            const kernel::Decision d =
                kernel::extremality_sign(c == 0 ? forms[v].b0 : forms[v].b3, forms[v].d1);
            s.extremality[c][v] = as_int(d.sign);
            if (!piece.owns(static_cast<Index>(v))) continue;
            local.stages.add(d.stage);
            local.zeros[c] += d.stage == Stage::symbolic;
          }
      });
  for (const SignCounts& local : counts) {
    s.extremality_counts += local.stages;
    for (std::size_t c = 0; c < 2; ++c) s.zero_extremalities[c] += local.zeros[c];
  }
}

}  // namespace

EdgeStates edge_states(const kernel::MeshPiece& piece, const std::vector<MongeForm>& forms,
                       bool guarded) {
  const kernel::TriangleMesh& mesh = piece.mesh();
  EdgeStates s;
  decide_extremalities(piece, forms, s);
  s.acute.resize(mesh.edge_count());
  s.crossed.resize(mesh.edge_count());
  tbb::enumerable_thread_specific<StageCounts> counts;
  kernel::parallel_for(
      tbb::blocked_range<Index>(0, mesh.edge_count(), 8192), [&](const auto& range) {
        StageCounts local;
        for (Index e = range.begin(); e != range.end(); ++e) {
          const Index p = mesh.edges()[e].v0, q = mesh.edges()[e].v1;
          if (!piece.is_inner(p) || !piece.is_inner(q)) continue;
          const kernel::Decision d = guarded ? kernel::acute_rule(forms[p].d1, forms[q].d1)
                                             : plain_acute_rule(forms[p].d1, forms[q].d1);
          if (piece.owns(p)) local.add(d.stage);
          s.acute[e] = as_int(d.sign);
          unsigned bits = 0;
          for (unsigned c = 0; c < 2; ++c)
            if (s.acute[e] * s.extremality[c][p] * s.extremality[c][q] < 0) bits |= 1u << c;
          s.crossed[e] = static_cast<std::uint8_t>(bits);
        }
        counts.local() += local;
      });
  for (const StageCounts& c : counts) s.acute_counts += c;
  s.ambiguous_edges = static_cast<Index>(s.acute_counts.symbolic);
  return s;
}

}  // namespace crest::ridges
