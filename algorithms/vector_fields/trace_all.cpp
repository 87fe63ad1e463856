// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>

#include "algorithms/vector_fields/annulus.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::vector_fields {

namespace {

/// The attempts at one line, by a thread that knew only the annuli there were at the beginning.
struct Followed {
  std::vector<Trace> attempts;
  AnnulusNotes notes;
};

/// The line up to its first gate inside an annulus: of the first attempt that has one.
std::optional<Trace> cut(const std::vector<Trace>& attempts, std::span<const Annulus> annuli) {
  for (const Trace& t : attempts)
    for (std::size_t i = 0; i < t.gates.size(); ++i) {
      const PassedGate& g = t.gates[i];
      const auto inside = std::find_if(annuli.begin(), annuli.end(), [&](const Annulus& a) {
        return a.side == g.side && a.forward == t.start.forward &&
               strictly_inside(Gate<double>{g.side, g.left, g.right},
                               Gate<double>{a.side, a.left, a.right});
      });
      if (inside == annuli.end()) continue;
      Trace r = t;
      r.end = EndKind::closed_orbit;
      r.target = static_cast<Index>(inside - annuli.begin());
      r.reason = OpenReason::none;
      r.turns.resize(g.turns);
      std::erase_if(r.special, [&](const auto& s) { return s.first >= g.turns; });
      r.line.resize(t.line.size() - (t.gates.size() - 1 - i));
      r.gates.resize(i + 1);
      r.width = g.width;
      return r;
    }
  return std::nullopt;
}

/// Whether lines may enter annuli that are found later.
bool unsettled(const Trace& t) {
  return t.end == EndKind::closed_orbit || t.end == EndKind::undecided;
}

/// Whether a line that found annuli of its own would have gone another way, had it known others.
bool disturbed(const Followed& f, std::span<const Annulus> others) {
  const bool forward = f.attempts.front().start.forward;
  for (const PassedGate& g : f.notes.asked)
    for (const Annulus& a : others)
      if (overlaps(a, forward, g)) return true;
  return cut(f.attempts, others).has_value();
}

Followed follow(const Surroundings& around, const Start& start, std::span<const Annulus> annuli) {
  Followed f;
  f.notes.known = annuli;
  f.attempts = trace(around, start, f.notes);
  if (!unsettled(f.attempts.back()) && f.notes.found.empty()) {
    f.attempts.erase(f.attempts.begin(), f.attempts.end() - 1);
    f.attempts.back().gates = {};
    f.notes.asked = {};
  }
  return f;
}

}  // namespace

std::vector<Trace> trace_all(const Surroundings& around, const std::vector<Start>& starts,
                             std::vector<Annulus>& annuli) {
  const std::size_t first = annuli.size();
  std::vector<Followed> lines(starts.size());
  kernel::parallel_for(std::size_t{0}, starts.size(),
                       [&](std::size_t i) { lines[i] = follow(around, starts[i], annuli); });
  // As if they had been followed one after the other.
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Followed& f = lines[i];
    std::size_t known = first;
    if (!f.notes.found.empty() && disturbed(f, std::span(annuli).subspan(first))) {
      f = follow(around, starts[i], annuli);
      known = annuli.size();
    }
    Trace& t = f.attempts.back();
    if (t.end == EndKind::closed_orbit && t.target >= known)
      t.target += static_cast<Index>(annuli.size() - known);
    std::move(f.notes.found.begin(), f.notes.found.end(), std::back_inserter(annuli));
    f.notes = {};
  }
  std::vector<Trace> traces;
  for (Followed& f : lines) {
    std::optional<Trace> shorter;
    if (unsettled(f.attempts.back())) shorter = cut(f.attempts, annuli);
    traces.push_back(shorter ? std::move(*shorter) : std::move(f.attempts.back()));
    traces.back().gates = {};
    f = {};
  }
  return traces;
}

}  // namespace crest::vector_fields
