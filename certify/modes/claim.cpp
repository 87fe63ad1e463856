// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6, modes: level sets of the mode of a piecewise linear tensor field (SPEC.md). The
// library compares no file with it; the program compares digests (cli/crest_verify.cpp).
#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <numeric>

#include "certify/container/checker.hpp"
#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/modes/decode.hpp"
#include "certify/modes/near_vertices.hpp"
#include "certify/modes/surface.hpp"

namespace crest::certify {
namespace {

using namespace modes;

void require_level(const ModeLevel& level) {
  const std::uint64_t p = level.numerator, q = level.denominator;
  require(p < q && q <= std::uint64_t{1} << 53U && std::gcd(p, q) == 1,
          "level: {} / {} is no fraction in [0, 1) in lowest terms", p, q);
}

/// Calls check(first, end, worker) for successive parts of 0 to count on all cores; adds the
/// workers' counts.
template <class Check>
void check_parts(std::size_t count, const Field& field, Verdict& verdict, const Check& check) {
  std::mutex mutex;
  struct Counted : Worker {
    Counted(const Field& f, std::mutex& m, SignCounts& s) : Worker(f), guard(m), sum(s) {}
    ~Counted() {
      const std::lock_guard lock(guard);
      sum.calls += counts.calls;
      sum.exact += counts.exact;
    }
    std::mutex& guard;
    SignCounts& sum;
  };
  constexpr std::size_t kPart = 64;  // an atomic counter a part
  parallel_for((count + kPart - 1) / kPart,
               [&] { return std::make_unique<Counted>(field, mutex, verdict.signs); },
               [&](auto& worker, std::size_t part) {
                 check(part * kPart, std::min(count, (part + 1) * kPart), *worker);
               });
}
/// Calls check(i, worker) for i < count.
template <class Check>
void check_all(std::size_t count, const Field& field, Verdict& verdict, const Check& check) {
  check_parts(count, field, verdict, [&](std::size_t first, std::size_t end, Worker& worker) {
    for (std::size_t i = first; i < end; ++i) check(i, worker);
  });
}

/// Tetrahedra first to end that are not listed.
void check_unlisted(const LevelContext& context, const Domain& domain,
                    const std::vector<std::uint8_t>& listed, std::size_t first, std::size_t end,
                    Worker& worker) {
  std::vector<std::array<u32, 4>> rejected;
  for (std::size_t t = first; t < end; ++t) {
    if (listed[t] != 0) continue;
    const auto corners = nonzero_corners(context.field, domain.tets[t]);
    if (corners.size() == 4) rejected.push_back(domain.tets[t]);
    if (corners.size() == 2)
      require(zero_free(worker.exact, corners), "edge ({}, {}): the tensor is zero inside",
              corners[0], corners[1]);
  }
  check_rejected(context, rejected, worker);
}

/// Steps 3 to 6 for all simplices that are listed or needed.
std::vector<CellPieces> check_simplices(const LevelContext& context, const Domain& domain,
                                        Verdict& verdict) {
  const Trees& trees = context.trees;
  const Field& field = context.field;
  check_all(trees.edges.size(), field, verdict, [&](std::size_t i, Worker& worker) {
    const EdgeNode& edge = trees.edges[i];
    if (edge.leaf() && edge.needed && !edge.open) check_edge(context, static_cast<u32>(i), worker);
  });
  check_parts(trees.faces.size(), field, verdict, [&](auto first, auto end, Worker& worker) {
    check_faces(context, first, end, worker);
  });
  std::vector<CellPieces> pieces(trees.cells.size());
  check_parts(trees.cells.size(), field, verdict, [&](auto first, auto end, Worker& worker) {
    check_cells(context, std::span(trees.cells).subspan(first, end - first),
                std::span(pieces).subspan(first, end - first), worker);
  });
  std::vector<std::uint8_t> listed(domain.tets.size(), 0);
  for (const u32 t : context.stated.tets) listed[t] = 1;
  check_parts(domain.tets.size(), field, verdict, [&](auto first, auto end, Worker& worker) {
    check_unlisted(context, domain, listed, first, end, worker);
  });
  return pieces;
}

std::string in_words(const SurfaceCounts& counts) {
  std::int64_t characteristic = 0, loops = 0;
  for (const SurfaceComponent& component : counts.components) {
    characteristic += component.euler_characteristic;
    loops += component.boundary_loops;
  }
  std::string text = fmt::format("{} components, Euler characteristic {}, {} boundary loops",
                                 counts.components.size(), characteristic, loops);
  if (counts.touched > 0)
    text += fmt::format("; {} more touch cells where nothing is claimed", counts.touched);
  return text;
}

void require_counts(const SurfaceCounts& stated, const SurfaceCounts& found, const char* level) {
  require(stated.components == found.components && stated.touched == found.touched,
          "level {}: {} stated, {} found", level, in_words(stated), in_words(found));
}

/// Theorem 16 (ii): what is stated of the mode at vertices.
void check_vertices(const LevelContext& context, const Positions& positions, Verdict& verdict) {
  const NearVertices vertices(context, positions);
  const ModeLevel& stated = context.stated;
  std::atomic<u32> near{0}, inside{0};
  check_all(context.trees.edges.size(), context.field, verdict, [&](std::size_t i, Worker& worker) {
    if (const u32 found = vertices.on_edge(context.trees.edges[i], worker)) near += found;
  });
  check_all(context.trees.faces.size(), context.field, verdict, [&](std::size_t i, Worker& worker) {
    if (const u32 found = vertices.on_face(static_cast<u32>(i), worker)) near += found;
  });
  check_all(stated.inner.size(), context.field, verdict, [&](std::size_t i, Worker& worker) {
    if (vertices.inside(stated.inner[i], worker)) ++inside;
  });
  near += inside;
  require(stated.near <= near, "vertices near the level: {} stated, {} found", stated.near,
          near.load());
  prove(verdict,
        "positions: the mode is off by at most 2^-40 at {} of {} listed vertices; of those inside "
        "cells at {} of {}",
        near.load(), vertices.all(), inside.load(), stated.inner.size());
}

/// Theorem 16 (i): what is stated of positions.
void check_positions(const LevelContext& context, const Domain& domain,
                     const std::vector<CellPieces>& pieces, bool embedded, Verdict& verdict) {
  const Positions positions(context);
  if (!positions.stated()) return;
  check_vertices(context, positions, verdict);
  const Trees& trees = context.trees;
  std::atomic<u32> placed{0}, all{0};
  const auto count = [&](const PlacedPieces& found) {
    if (embedded) placed += found.placed;
    all += found.placed + found.not_placed;
  };
  check_all(trees.cells.size(), context.field, verdict, [&](std::size_t i, Worker&) {
    if (!pieces[i].levels.empty()) count(positions.place_cell(trees.cells[i], pieces[i]));
  });
  check_all(domain.tets.size(), context.field, verdict, [&](std::size_t t, Worker&) {
    const auto corners = nonzero_corners(context.field, domain.tets[t]);
    if (corners.size() != 3 || std::ranges::binary_search(trees.open_tets, t)) return;
    count(positions.place_cones(trees.face({corners[0], corners[1], corners[2]})));
  });
  const auto [stated, others] = std::pair(context.stated.placed, context.stated.not_placed);
  require(stated <= placed, "pieces that are simple and nested: {} stated, {} found", stated,
          placed.load());
  require_equal(std::int64_t{stated} + others, all.load(), "pieces");
  prove(verdict, "positions: {} of {} pieces are simple and nested across their directions",
        placed.load(), all.load());
}

void verify_level(const ModeLevel& stated, const Domain& domain, bool embedded, Field& field,
                  Verdict& verdict) {
  require_level(stated);
  field.drop_splits();
  Trees trees = read_trees(stated, domain, field);
  trees.mark_needed(domain, field);
  const LevelContext context(stated, field, trees);
  const std::string mode =
      stated.numerator == 0 ? "0" : fmt::format("{}/{}", stated.numerator, stated.denominator);
  const auto pieces = check_simplices(context, domain, verdict);
  prove(verdict,
        "mode {}: {} roots on {} edges, {} arcs on {} faces, {} cells in {} tetrahedra; the other "
        "tetrahedra are free of the level",
        mode, stated.roots.size(), trees.edges.size(), stated.arcs.size(), trees.faces.size(),
        trees.cells.size(), stated.tets.size());
  const LevelSurfaces surfaces = glue_pieces(context, domain, pieces);
  const auto open = std::ranges::count(trees.cells, modes_code::kOpenTet, &Cell::code) +
                    static_cast<std::ptrdiff_t>(trees.open_tets.size());
  require_equal(stated.open_tets, open, "open cells");
  require_counts(stated.positive, surfaces.positive, "+");
  require_counts(stated.negative, surfaces.negative, "-");
  prove(verdict, "mode {}: {}{}", stated.numerator == 0 ? "0" : "+" + mode,
        in_words(surfaces.positive),
        open == 0 ? "" : fmt::format("; nothing is claimed in {} cells", open));
  if (stated.numerator != 0) prove(verdict, "mode -{}: {}", mode, in_words(surfaces.negative));
  check_positions(context, domain, pieces, embedded, verdict);
}

/// Cost: n log n; some microseconds a cell.
void verify_modes(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                  const VerifyOptions& options, Verdict& verdict) {
  const ModesCertificate c = decode_modes(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare tensors; compare the data digest with the one "
                         "in the output");
  Field field(c.tensors);
  const Domain domain = build_domain(c, field);
  prove(verdict, "data: {} vertices, {} tetrahedra, {} zeros inside; digests match",
        c.points.size(), c.tets.size(), c.zeros.size());
  const bool positions =
      std::ranges::any_of(c.levels, [](const ModeLevel& l) { return !l.root_places.empty(); });
  const bool embedded = positions && is_embedded(c, domain);
  for (const ModeLevel& level : c.levels) verify_level(level, domain, embedded, field, verdict);
}

}  // namespace

extern const ClaimChecker modes_claim;
const ClaimChecker modes_claim = {kModes, kModesVersion, "modes", verify_modes};

}  // namespace crest::certify
