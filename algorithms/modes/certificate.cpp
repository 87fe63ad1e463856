// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/certificate.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <span>

#include "algorithms/modes/positions.hpp"
#include "algorithms/modes/tensors.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

namespace code = certify::modes_code;

/// Of a record, what some of its trees say; joined in their order. Each edge and arc is in one
/// part.
struct RecordPart {
  certify::ModeLevel level{};
  std::vector<Index> edges{}, arcs{};  ///< whose places, points the part has
  bool placed = true;                  ///< every root has found its place
};

/// Edges of rejected faces, which have no roots.
std::vector<char> clear_edges(const Faces& faces) {
  std::vector<char> clear(faces.edge_count(), 0);
  for (Index f = 0; f < faces.face_count(); ++f)
    if (faces.face(f).state == State::rejected)
      for (const Index e : faces.face(f).edges) clear[e] = 1;
  return clear;
}

/// Trees of edges, with the roots of their leaves.
class EdgeRecorder {
 public:
  EdgeRecorder(Faces& faces, double mode, const std::vector<char>& clear, RecordPart& to,
               RecordedPositions& positions)
      : faces_(faces),
        mode_(mode),
        clear_(clear),
        part_(to),
        to_(to.level),
        positions_(positions) {}

  void record(Index e, bool clear) {
    const Edge& edge = faces_.edge(e);
    clear = clear || clear_[e] != 0;
    if (edge.middle != kNone) {
      to_.codes.push_back(faces_.vertices().cut(edge.middle).n);
      record(edge.part[0], clear);
      record(edge.part[1], clear);
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

  /// Counts the vertex if its mode is near the level.
  template <std::size_t n>
  void count_near(const std::array<Index, n>& corners, const std::array<double, n>& weights,
                  int level) {
    if (is_near<n>(faces_.vertices(), corners, weights, level * mode_)) ++to_.near;
  }

 private:
  void roots(Index e) {
    const RootRange range = faces_.roots(e);
    to_.codes.push_back(static_cast<std::uint8_t>(code::kRoots + range.count));
    const RootNumbers list = faces_.lines().roots(faces_.edge(e).line);
    boost::container::small_vector<certify::RootRecord, 6> records;
    for (std::size_t i = 0; i < range.count; ++i) records.push_back(root(e, list[range.first + i]));
    separate(e, list.part(range.first, range.count), {records.data(), records.size()});
    to_.roots.insert(to_.roots.end(), records.begin(), records.end());
    if (range.count > 0) {
      positions_.places[e] = static_cast<Index>(to_.root_places.size());
      part_.edges.push_back(e);
    }
    place(e, list.part(range.first, range.count), {records.data(), records.size()});
  }

  /// The vertices' places, within the enclosures; what has none lies between its neighbours.
  void place(Index e, RootNumbers list, std::span<const certify::RootRecord> records) {
    const Edge& edge = faces_.edge(e);
    double last = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
      double low = records[i].low, high = records[i].high;
      if (low == high) {
        if (high == 0) high = i + 1 < records.size() ? records[i + 1].low : 1;
        if (low == 1) low = i > 0 ? records[i - 1].high : 0;
      }
      const double t = (faces_.lines().root(list[i]).t - edge.from) / (edge.to - edge.from);
      double x = std::clamp(t, low, high);
      // An infinitesimal off its neighbour: as little as in the output.
      constexpr double room = 1e-13;
      if (x <= last) x = last + std::fmin(room, (high - last) / 2);
      if (x >= 1) x = std::fmax(1 - room, last + (1 - last) / 2);
      part_.placed = part_.placed && last < x && x < 1 && x <= high;
      to_.root_places.push_back(x);
      count_near<2>({edge.second, edge.first}, {x, 1 - x}, records[i].level);
      last = x;
    }
  }

  /// The enclosure on a part of a line.
  certify::RootRecord root(Index e, Index r, bool exactly = false) {
    const Edge& edge = faces_.edge(e);
    Lines& lines = faces_.lines();
    const Root& root = lines.root(r);
    const auto level = static_cast<std::int8_t>(root.side == Side::minus ? -1 : 1);
    if (root.number && lines.compare_place(r, edge.begin) == kernel::Sign::zero)
      return {0, 0, level};
    if (root.number && lines.compare_place(r, edge.end) == kernel::Sign::zero) return {1, 1, level};
    const double begin = edge.from, length = edge.to - begin;
    const double slack = 8 * 0x1p-52 * (2 + 2 / length);  // of begin, end, difference, quotient
    const double low = (root.low - begin) / length - slack,
                 high = (root.high - begin) / length + slack;
    const double free = std::fmin(low, 1 - high);
    if (!exactly && !root.number && slack < 1e-3 * free) {
      const double pad = std::fmin(1e-12, 1e-6 * free);  // for signs that doubles see
      return {low - pad, high + pad, level};
    }
    const kernel::Rational from = edge.begin.value(), size = edge.end.value() - from;
    for (long bits = 128;; bits *= 4) {
      const auto ends = lines.bounds(r, bits);
      const double a = static_cast<double>(kernel::Rational((ends[0] - from) / size)),
                   b = static_cast<double>(kernel::Rational((ends[1] - from) / size));
      // A conversion is off by less than two steps.
      const double step = 4 * 0x1p-52;
      if ((a > 0 && b < 1) || bits > 4096)
        return {std::fmax(0, a * (1 - step)), std::fmin(1, b * (1 + step)), level};
    }
  }

  /// Two roots at one place have one enclosure; others that overlap are converted exactly.
  void separate(Index e, RootNumbers list, std::span<certify::RootRecord> records) {
    for (std::size_t i = 0; i + 1 < records.size(); ++i) {
      auto &a = records[i], &b = records[i + 1];
      if (a.low == a.high || b.low == b.high || b.low >= a.high) continue;
      const Root &x = faces_.lines().root(list[i]), &y = faces_.lines().root(list[i + 1]);
      if (x.number && y.number && kernel::compare(*x.number, *y.number) == kernel::Sign::zero) {
        a.low = b.low = std::fmin(a.low, b.low);
        a.high = b.high = std::fmax(a.high, b.high);
      } else {
        a = root(e, list[i], true);
        b = root(e, list[i + 1], true);
      }
    }
  }

  Faces& faces_;
  double mode_;
  const std::vector<char>& clear_;
  RecordPart& part_;
  certify::ModeLevel& to_;
  RecordedPositions& positions_;
};

/// Writes trees in preorder.
class TreeRecorder {
 public:
  TreeRecorder(Extraction& extraction, const std::vector<char>& clear, RecordPart& to,
               RecordedPositions& positions)
      : extraction_(extraction),
        faces_(extraction.faces()),
        part_(to),
        to_(to.level),
        positions_(positions),
        edges_(faces_, extraction.level().value(), clear, to, positions),
        // lambda belongs to the deviator itself; here it belongs to 3 times the deviator over
        // 2^scale.
        neutral_(extraction.level().neutral()) {}

  void whole_edge(Index e) {
    to_.edges.push_back({faces_.edge(e).first, faces_.edge(e).second});
    edges_.record(e, false);
  }
  void whole_face(Index f) {
    to_.faces.push_back(faces_.face(f).corners);
    face(f);
  }
  void whole_tet(const Extraction::Tree& tree) {
    to_.tets.push_back(tree.tet);
    if (tree.cell != kNone) return cell(tree.cell);
    to_.codes.push_back(code::kOpenTet);
    ++to_.open_tets;
  }

 private:
  void arc(Index a) {
    to_.arcs.push_back({faces_.arcs()[a].numbers[0], faces_.arcs()[a].numbers[1]});
    auto& points = positions_.points[a];
    points.first = to_.points.size();
    part_.arcs.push_back(a);
    for (const auto& p : extraction_.polyline(a))
      if (p[0] > 0 && p[1] > 0 && p[0] + p[1] < 1) {
        to_.points.push_back({p[0], p[1]});
        const Arc& arc = faces_.arcs()[a];
        edges_.count_near<3>(faces_.face(arc.face).corners, {p[0], p[1], 1 - p[0] - p[1]},
                             arc.side == Side::minus ? -1 : 1);
      }
    points.count = to_.points.size() - points.first;
    to_.arc_points.push_back(static_cast<std::uint16_t>(points.count));
  }

  /// The vertices of one side inside a cell that is recorded last, each place once.
  void inner(Index c, Side side) {
    const std::int8_t level = side == Side::minus ? -1 : 1;
    std::vector<std::array<double, 3>> places;
    for (auto b : extraction_.inner(c, side)) {
      // Rounding may have put it just outside.
      while (b[0] + b[1] + b[2] >= 1)
        for (double& x : b) x *= 1 - 0x1p-52;
      places.push_back({b[0], b[1], b[2]});
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const auto& [x, y, z] : places) {
      to_.inner.push_back(
          {static_cast<std::uint32_t>(to_.tet_witnesses.size() - 1), level, {x, y, z}});
      edges_.count_near<4>(extraction_.cells().cell(c).corners, {x, y, z, 1 - x - y - z}, level);
    }
  }

  /// Exact: it is a multiple of 3.
  double lambda(std::int16_t x) const {
    return neutral_ ? x : std::ldexp(x / 3, extraction_.scale());
  }
  void face(Index f) {
    const Face& face = faces_.face(f);
    if (face.split >= 0) {
      to_.codes.push_back(static_cast<std::uint8_t>(face.split));
      edges_.record(face.inner, false);
      this->face(face.part[0]);
      this->face(face.part[1]);
      return;
    }
    if (face.state == State::rejected) {
      to_.codes.push_back(code::kRejectedFace);
    } else if (face.state == State::graph) {
      to_.codes.push_back(code::kGraphFace);
      to_.face_witnesses.push_back(
          {{face.witness.w[0], face.witness.w[1]}, lambda(face.witness.lambda)});
      for (Index a = face.first_arc; a < face.first_arc + face.arc_count; ++a) arc(a);
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
                                   lambda(cell.witness.lambda),
                                   {plus, p[0]}});
      inner(c, neutral_ ? Side::neutral : Side::plus);
      if (!neutral_) inner(c, Side::minus);
    } else {
      to_.codes.push_back(code::kOpenTet);
      ++to_.open_tets;
    }
  }

  Extraction& extraction_;
  Faces& faces_;
  RecordPart& part_;
  certify::ModeLevel& to_;
  RecordedPositions& positions_;
  EdgeRecorder edges_;
  bool neutral_;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Adds what comes next, and moves its places, points and witnesses to where they are then.
void join(certify::ModeLevel& to, RecordedPositions& positions, RecordPart& part) {
  certify::ModeLevel& from = part.level;
  for (const Index e : part.edges) positions.places[e] += static_cast<Index>(to.root_places.size());
  for (const Index a : part.arcs) positions.points[a].first += to.points.size();
  for (certify::InnerVertex& v : from.inner)
    v.witness += static_cast<std::uint32_t>(to.tet_witnesses.size());
  append(to.edges, from.edges);
  append(to.faces, from.faces);
  append(to.tets, from.tets);
  append(to.codes, from.codes);
  append(to.roots, from.roots);
  append(to.face_witnesses, from.face_witnesses);
  append(to.arcs, from.arcs);
  append(to.tet_witnesses, from.tet_witnesses);
  append(to.root_places, from.root_places);
  append(to.arc_points, from.arc_points);
  append(to.points, from.points);
  append(to.inner, from.inner);
  to.open_tets += from.open_tets;
  to.near += from.near;
}

/// The edges and faces of the mesh with trees that are told, in their corners' order.
struct Told {
  std::vector<Index> faces{}, edges{};

  explicit Told(Extraction& extraction) {
    const Faces& trees = extraction.faces();
    // Faces of the mesh come in their corners' order.
    for (const Index f : extraction.mesh_faces())
      if (f != kNone && (trees.face(f).split >= 0 || trees.face(f).state != State::rejected))
        faces.push_back(f);
    std::vector<bool> listed(trees.edge_count());
    const auto list = [&](Index e) {
      if (!listed[e]) edges.push_back(e);
      listed[e] = true;
    };
    for (const Index f : faces)
      for (const Index e : trees.face(f).edges) list(e);
    for (const Cone& c : extraction.cones())
      if (c.zeros.size() == 2) list(extraction.edge_between(c.others[0], c.others[1]));
    std::sort(edges.begin(), edges.end(), [&](Index a, Index b) {
      const Edge &x = trees.edge(a), &y = trees.edge(b);
      return x.first != y.first ? x.first < y.first : x.second < y.second;
    });
  }
};

/// The trees of tetrahedra, and open ones with a zero corner, which have none.
std::vector<Extraction::Tree> told_trees(const Extraction& extraction) {
  auto trees = extraction.trees();
  for (const Cone& c : extraction.cones())
    if (c.open) trees.push_back({c.tet, kNone});
  std::sort(trees.begin(), trees.end(), [](const auto& a, const auto& b) { return a.tet < b.tet; });
  return trees;
}

/// Trees only share what was found before: they are recorded by all threads, a few hundred at a
/// time.
void record_level(Extraction& extraction, certify::ModeLevel& to) {
  const Told told(extraction);
  const auto trees = told_trees(extraction);
  const std::vector<char> clear = clear_edges(extraction.faces());
  RecordedPositions positions{
      std::vector<Index>(extraction.faces().edge_count(), kNone),
      std::vector<RecordedPositions::Points>(extraction.faces().arcs().size())};
  constexpr std::size_t kTrees = 512;
  const std::size_t count = told.edges.size() + told.faces.size() + trees.size();
  std::vector<RecordPart> parts((count + kTrees - 1) / kTrees);
  kernel::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    TreeRecorder recorder(extraction, clear, parts[p], positions);
    for (std::size_t i = p * kTrees; i < std::min(count, (p + 1) * kTrees); ++i)
      if (i < told.edges.size())
        recorder.whole_edge(told.edges[i]);
      else if (i < told.edges.size() + told.faces.size())
        recorder.whole_face(told.faces[i - told.edges.size()]);
      else
        recorder.whole_tet(trees[i - told.edges.size() - told.faces.size()]);
  });
  bool placed = true;
  for (RecordPart& part : parts) {
    join(to, positions, part);
    placed = placed && part.placed;
    part = {};
  }
  if (placed) return count_placed(extraction, positions, to);
  to.root_places.clear();
  to.arc_points.clear();
  to.points.clear();
  to.inner.clear();
  to.near = 0;
}

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
                   certify::ModeLevel& record, const Workers* workers) {
  constexpr int most = 1000;  // lambda is below 2^14 times that power of two
  if (!level.neutral() && scale_of(field.tensors) > most)
    throw kernel::InputError(
        "tensors: entries of 1e301 and more have no certificate; divide all by one number, which "
        "leaves the mode as it is");
  Extraction e(field, level, options, workers);
  ModeResult r = e.result();
  record.numerator = static_cast<std::uint64_t>(level.p);
  record.denominator = static_cast<std::uint64_t>(level.q);
  record_level(e, record);
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
  if (!is_embedded(zeros.simplices.empty() ? field.mesh : kernel::TetMesh(c.points, c.tets)))
    for (certify::ModeLevel& level : c.levels) {
      level.not_placed += level.placed;
      level.placed = 0;
    }
  return c;
}

}  // namespace crest::modes
