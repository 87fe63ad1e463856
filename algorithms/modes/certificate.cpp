// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/certificate.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/modes/extraction.hpp"

namespace crest::modes {
namespace {

namespace code = certify::modes_code;

/// Writes trees in preorder.
class Recorder {
 public:
  Recorder(Extraction& extraction, certify::ModeLevel& to)
      : extraction_(extraction), faces_(extraction.faces()), to_(to) {
    // lambda belongs to the deviator itself; here it belongs to 3 times the deviator over
    // 2^scale.
    lambda_ = extraction.level().neutral() ? 1 : std::ldexp(1.0, extraction.scale()) / 3;
  }

  void record() {
    mark_clear();
    std::vector<std::pair<std::array<Index, 3>, Index>> faces;
    for (const auto& [mesh_face, f] : extraction_.mesh_faces())
      if (faces_.face(f).split >= 0 || faces_.face(f).state != State::rejected)
        faces.emplace_back(faces_.face(f).corners, f);
    std::sort(faces.begin(), faces.end());
    std::vector<std::pair<std::array<Index, 2>, Index>> edges;
    for (const auto& [corners, f] : faces)
      for (const Index e : faces_.face(f).edges)
        edges.push_back({{faces_.edge(e).first, faces_.edge(e).second}, e});
    for (const Cone& c : extraction_.cones())
      if (c.zeros.size() == 2)
        edges.push_back(
            {{c.others[0], c.others[1]}, extraction_.edge_between(c.others[0], c.others[1])});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [corners, e] : edges) {
      to_.edges.push_back(corners);
      edge(e, false);
    }
    for (const auto& [corners, f] : faces) {
      to_.faces.push_back(corners);
      face(f);
    }
    for (const Extraction::Tree& tree : extraction_.trees()) {
      to_.tets.push_back(tree.tet);
      cell(tree.cell);
    }
  }

 private:
  /// Edges of rejected faces have no roots.
  void mark_clear() {
    for (Index f = 0; f < faces_.face_count(); ++f)
      if (faces_.face(f).state == State::rejected)
        for (const Index e : faces_.face(f).edges) {
          if (clear_.size() <= e) clear_.resize(e + 1, 0);
          clear_[e] = 1;
        }
  }

  void edge(Index e, bool clear) {
    const Edge edge = faces_.edge(e);
    clear = clear || (e < clear_.size() && clear_[e] != 0);
    if (edge.middle != kNone) {
      to_.codes.push_back(faces_.vertices().cut(edge.middle).n);
      this->edge(edge.part[0], clear);
      this->edge(edge.part[1], clear);
      return;
    }
    if (clear) {
      to_.codes.push_back(code::kRoots);
      return;
    }
    if (!faces_.lines().line(edge.line).known) {
      to_.codes.push_back(code::kOpenEdge);
      return;
    }
    roots(e);
  }

  void roots(Index e) {
    const Edge& edge = faces_.edge(e);
    const RootRange range = faces_.roots(e);
    to_.codes.push_back(static_cast<std::uint8_t>(code::kRoots + range.count));
    const auto& list = faces_.lines().roots(edge.line);
    const double begin = edge.begin.lower(), length = edge.end.lower() - begin;
    std::vector<certify::RootRecord> records;
    for (std::size_t i = 0; i < range.count; ++i) {
      const Index r = list[range.first + i];
      const Root& root = faces_.lines().root(r);
      certify::RootRecord x{(root.low - begin) / length, (root.high - begin) / length,
                            static_cast<std::int8_t>(root.side == Side::minus ? -1 : 1)};
      if (root.number && faces_.lines().compare_place(r, edge.begin) == kernel::Sign::zero)
        x.low = x.high = 0;
      else if (root.number && faces_.lines().compare_place(r, edge.end) == kernel::Sign::zero)
        x.low = x.high = 1;
      records.push_back(x);
    }
    widen(records, 4 * 0x1p-52 * (2 + 2 / length));
    to_.roots.insert(to_.roots.end(), records.begin(), records.end());
  }

  /// Enclosures grow, for what was rounded and so that doubles see the signs at their ends, as far
  /// as their neighbours let them.
  static void widen(std::vector<certify::RootRecord>& records, double rounding) {
    const auto same_place = [&](std::size_t i) {
      return i + 1 < records.size() && records[i + 1].low <= records[i].high;
    };
    double last = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
      auto& r = records[i];
      if (r.low == r.high && (r.low == 0 || r.low == 1)) continue;
      const bool pair = same_place(i);
      const std::size_t next = i + (pair ? 2 : 1);
      const double limit = next < records.size() ? records[next].low : 1;
      const double room = (limit - r.high) / 4;
      const double free = std::fmin(r.low - last, limit - r.high);
      const double pad = std::fmax(2 * rounding, std::fmin(1e-12, 1e-6 * free));
      const double low = std::fmax(r.low - pad, last), high = r.high + std::fmin(pad, room);
      r.low = low;
      r.high = std::fmin(1, high);
      last = r.high;
      if (pair) {
        records[i + 1].low = r.low;
        records[i + 1].high = r.high;
        ++i;
      }
    }
  }

  void face(Index f) {
    const Face& face = faces_.face(f);
    if (face.split >= 0) {
      to_.codes.push_back(static_cast<std::uint8_t>(face.split));
      edge(face.inner, false);
      this->face(face.part[0]);
      this->face(face.part[1]);
      return;
    }
    if (face.state == State::rejected) {
      to_.codes.push_back(code::kRejectedFace);
    } else if (face.state == State::graph) {
      to_.codes.push_back(code::kGraphFace);
      to_.face_witnesses.push_back(
          {{face.witness.w[0], face.witness.w[1]}, lambda_ * face.witness.lambda});
      for (Index a = face.first_arc; a < face.first_arc + face.arc_count; ++a)
        to_.arcs.push_back({faces_.arcs()[a].numbers[0], faces_.arcs()[a].numbers[1]});
    } else {
      to_.codes.push_back(code::kOpenFace);
    }
  }

  void cell(Index c) {
    const Cell& cell = extraction_.cells().cell(c);
    if (cell.part[0] != kNone) {
      const auto [i, j] = cell.split;
      to_.codes.push_back(static_cast<std::uint8_t>(i == 0 ? j - 1 : i == 1 ? j + 1 : 5));
      face(cell.inner);
      this->cell(cell.part[0]);
      this->cell(cell.part[1]);
      return;
    }
    if (cell.state == State::rejected) {
      to_.codes.push_back(code::kRejectedTet);
    } else if (cell.state == State::graph) {
      to_.codes.push_back(code::kGraphTet);
      const auto& p = cell.pieces;
      const std::uint8_t plus = extraction_.level().neutral() ? p[1] : p[2];
      to_.tet_witnesses.push_back({{cell.witness.w[0], cell.witness.w[1], cell.witness.w[2]},
                                   lambda_ * cell.witness.lambda,
                                   {plus, p[0]}});
    } else {
      to_.codes.push_back(code::kOpenTet);
      ++to_.open_tets;
    }
  }

  Extraction& extraction_;
  Faces& faces_;
  certify::ModeLevel& to_;
  double lambda_;
  std::vector<char> clear_;
};

certify::SurfaceCounts counts_of(const ModeSurface& surface) {
  certify::SurfaceCounts counts;
  for (const SurfaceComponent& c : surface.components)
    if (c.complete)
      counts.components.push_back({static_cast<std::int32_t>(c.euler_characteristic),
                                   static_cast<std::uint32_t>(c.boundary_loops)});
    else
      ++counts.touched;
  std::sort(counts.components.begin(), counts.components.end());
  return counts;
}

}  // namespace

ModeResult extract(const ModeField& field, const Level& level, const ModeOptions& options,
                   certify::ModeLevel& record) {
  Extraction e(field, level, options);
  ModeResult r = e.result();
  record.numerator = static_cast<std::uint64_t>(level.p);
  record.denominator = static_cast<std::uint64_t>(level.q);
  Recorder(e, record).record();
  record.positive = counts_of(r.surfaces[0]);
  if (!level.neutral()) record.negative = counts_of(r.surfaces[1]);
  return r;
}

certify::ModesCertificate make_certificate(const ModeField& field, const ZeroSet& zeros,
                                           std::vector<certify::ModeLevel> levels) {
  certify::ModesCertificate c;
  const std::size_t given = field.tensors.size() - zeros.simplices.size();
  const auto end = static_cast<std::ptrdiff_t>(given);
  c.points.assign(field.mesh.points().begin(), field.mesh.points().begin() + end);
  c.tensors.assign(field.tensors.begin(), field.tensors.begin() + end);
  c.tets = zeros.tets;
  for (const auto& s : zeros.simplices) c.zeros.push_back({s});
  c.levels = std::move(levels);
  return c;
}

}  // namespace crest::modes
