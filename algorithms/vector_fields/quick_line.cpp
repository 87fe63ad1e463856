// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/quick_line.hpp"

#include <algorithm>

#include "algorithms/vector_fields/starts.hpp"

namespace crest::vector_fields {

namespace {

constexpr int kDegree = 14, kMostPieces = 4000, kMostNewton = 60;
/// Lines that creep for so long are tried as corridors, too, of this half width.
constexpr int kManyPieces = 48;
constexpr double kHalfWidth = 0x1p-38;
constexpr double kSamePlace = 0x1p-10;  ///< in shares of the distance to the nearer end

using Series = std::array<double, kDegree + 1>;

struct Values {
  double value, slope;
};
Values evaluate(const Series& c, int first, double s) {
  double value = 0, slope = 0;
  for (int k = kDegree; k >= first; --k) {
    slope = slope * s + value;
    value = value * s + c[static_cast<std::size_t>(k)];
  }
  return {value, slope};
}

/// The root in (0, high], where the value is not positive while it is near 0.
double root(const Series& c, int first, double high) {
  double low = 0, s = high;
  for (int i = 0; i < kMostNewton; ++i) {
    const auto [value, slope] = evaluate(c, first, s);
    if (value == 0) return s;
    (value > 0 ? low : high) = s;
    double next = slope < 0 ? s - value / slope : (low + high) / 2;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::fabs(next - s) <= 0x1p-52 * s || !(low < next && next < high)) return next;
    s = next;
  }
  return s;
}

/// Where the coordinate falls to zero first, 2: nowhere. `first`: its lowest coefficient that is
/// not zero.
double leaves(const Series& c, int first) {
  const auto [end, slope] = evaluate(c, first, 1);
  if (!(end > 0)) return root(c, first, 1);
  if (!(c[static_cast<std::size_t>(first) + 1] < 0) || !(slope > 0)) return 2;
  // It falls, then rises: its least value.
  double low = 0, high = 1;
  for (int i = 0; i < 40 && high - low > 0x1p-20; ++i) {
    const double middle = (low + high) / 2;
    const auto at = evaluate(c, first, middle);
    if (!(at.value > 0)) return root(c, first, middle);
    (at.slope < 0 ? low : high) = middle;
  }
  return 2;
}

class Crossing {
 public:
  Crossing(const kernel::FieldOnTriangle& data, int corner, bool forward)
      : frame_(data, corner, forward, 0x1p-53) {
    norm_ = std::max(std::fabs(frame_.a[0][0]) + std::fabs(frame_.a[0][1]),
                     std::fabs(frame_.a[1][0]) + std::fabs(frame_.a[1][1]));
  }

  int piece = 0;             ///< pieces that it took
  std::vector<Vec2> points;  ///< if they are wanted, where pieces end, in the frame
  bool keep_points = false;

  /// From the point `share` of the side that leaves the corner. Sides: 0 is that one.
  QuickEnd run(double share, const TrapShape* trap, int& side, double& exit) {
    double x = share, y = 0;
    if (trap) find_rays();
    for (piece = 0; piece < kMostPieces; ++piece) {
      if (!expand(x, y) || (piece == 0 && !(b_[1] > 0))) return QuickEnd::lost;
      // The side 0 is where b vanishes, side 1 where 1 - a - b does, side 2 where a does.
      const double s0 = leaves(b_, piece == 0 ? 1 : 0), s1 = leaves(c_, 0), s2 = leaves(a_, 0);
      const double s = std::min({s0, s1, s2});
      if (s <= 1) {
        const double a = evaluate(a_, 0, s).value, b = evaluate(b_, 0, s).value;
        side = s == s0 ? 0 : s == s1 ? 1 : 2;
        exit = side == 0 ? a : side == 1 ? b : 1 - b;
        return exit > kNearVertex && exit < 1 - kNearVertex ? QuickEnd::crossed : QuickEnd::lost;
      }
      x = evaluate(a_, 0, 1).value;
      y = evaluate(b_, 0, 1).value;
      if (keep_points) points.push_back({x, y});
      if (trap && (holds(*trap, x, y) || between_rays(x, y))) return QuickEnd::trapped;
    }
    return QuickEnd::lost;
  }

 private:
  /// Of a node: its zero and directions.
  void find_rays() {
    const double a = frame_.a[0][0], b = frame_.a[0][1], c = frame_.a[1][0], d = frame_.a[1][1];
    const double half = (a + d) / 2, det = a * d - b * c, square = half * half - det;
    if (!(det > 0) || !(square > 0x1p-20 * half * half)) return;
    zero_ = {(frame_.w[1] * b - frame_.w[0] * d) / det, (frame_.w[0] * c - frame_.w[1] * a) / det};
    const double root = half < 0 ? -std::sqrt(square) : std::sqrt(square);
    const double fast = half + root, slow = det / fast;
    std::size_t i = 0;
    for (const double l : {fast, slow}) {
      const bool second = std::fabs(c) + std::fabs(l - d) > std::fabs(b) + std::fabs(l - a);
      rays_[i++] = second ? Vec2{l - d, c} : Vec2{b, l - a};
    }
    node_ = true;
  }
  /// At a node both components of a line shrink: it stays in the parallelogram that they span.
  bool between_rays(double x, double y) const {
    if (!node_) return false;
    const Vec2 at = {x - zero_[0], y - zero_[1]};
    const double whole = kernel::cross(rays_[0], rays_[1]);
    const double s = kernel::cross(at, rays_[1]) / whole, t = kernel::cross(rays_[0], at) / whole;
    const auto in = [&](double k, const Vec2& r) {
      const double u = zero_[0] + k * r[0], v = zero_[1] + k * r[1];
      return u > kNearVertex && v > kNearVertex && u + v < 1 - kNearVertex;
    };
    return in(s, rays_[0]) && in(t, rays_[1]);
  }
  bool expand(double x, double y) {
    const double u = frame_.w[0] + frame_.a[0][0] * x + frame_.a[0][1] * y;
    const double v = frame_.w[1] + frame_.a[1][0] * x + frame_.a[1][1] * y;
    const double m = std::max(std::fabs(u), std::fabs(v));
    if (!(m > 0)) return false;
    const double h = 1 / (2 * norm_ + m / 2);
    a_[0] = x;
    b_[0] = y;
    c_[0] = 1 - x - y;
    a_[1] = h * u;
    b_[1] = h * v;
    c_[1] = -(a_[1] + b_[1]);
    for (std::size_t k = 1; k < kDegree; ++k) {
      const double f = h / static_cast<double>(k + 1);
      a_[k + 1] = f * (frame_.a[0][0] * a_[k] + frame_.a[0][1] * b_[k]);
      b_[k + 1] = f * (frame_.a[1][0] * a_[k] + frame_.a[1][1] * b_[k]);
      c_[k + 1] = -(a_[k + 1] + b_[k + 1]);
    }
    return true;
  }
  /// The ellipse is in the frame of corner 0.
  bool holds(const TrapShape& trap, double x, double y) const {
    const double z = 1 - x - y;
    if (frame_.origin == 0) return trap.holds(x, y);
    return frame_.origin == 1 ? trap.holds(z, x) : trap.holds(y, z);
  }

  TriangleFrame<double> frame_;
  double norm_;
  bool node_ = false;
  Vec2 zero_{};
  std::array<Vec2, 2> rays_{};
  Series a_, b_, c_;
};

/// A few triangles of the mesh as a domain of their own.
struct Part {
  Part(const CollapseMesh& mesh, const std::vector<Index>& numbers) : triangles(numbers) {
    std::vector<Index> vertices;
    for (const Index t : triangles) {
      auto& corners = field.triangles.emplace_back();
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        const auto known = std::find(vertices.begin(), vertices.end(), mesh.from(h));
        corners[h % 3] = static_cast<Index>(known - vertices.begin());
        if (known == vertices.end()) {
          vertices.push_back(mesh.from(h));
          field.points.push_back(mesh.point(mesh.from(h)));
          field.vectors.push_back(mesh.vector(mesh.from(h)));
        }
      }
    }
    domain.emplace(field);
  }
  HalfEdge here(HalfEdge h) const {
    const auto at = std::find(triangles.begin(), triangles.end(), h / 3);
    return 3 * static_cast<Index>(at - triangles.begin()) + h % 3;
  }
  HalfEdge there(HalfEdge h) const { return 3 * triangles[h / 3] + h % 3; }

  std::vector<Index> triangles;
  PlanarField field;
  std::optional<Domain> domain;
};

}  // namespace

bool provable(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
              const TrapShape* trap) {
  const Part part(mesh, {entry / 3});
  BarrierMaker<double> maker(*part.domain, kDoubles);
  const auto on_side = [](double t) { return t <= 0.5 ? t : t - 1; };
  const Gate<double> gate{part.here(entry), on_side(share - kHalfWidth),
                          on_side(share + kHalfWidth)};
  return cross_cell(maker, forward, gate, trap).end != CellEnd::open;
}

bool TriedPlaces::provable(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
                           const TrapShape* trap) {
  auto& places = places_[{mesh.from(entry), mesh.to(entry), mesh.from(Domain::previous(entry)),
                          forward ? 1U : 0U}];
  const double near = kSamePlace * std::min(share, 1 - share);
  for (const Place& p : places)
    if (std::fabs(p.share - share) <= near) return p.provable;
  places.push_back({share, vector_fields::provable(mesh, forward, entry, share, trap)});
  return places.back().provable;
}

std::vector<Vec2> points_along(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
                               std::size_t triangles) {
  std::vector<Vec2> result;
  for (std::size_t k = 0; k < triangles && entry != kNone; ++k) {
    const std::size_t c = entry % 3;
    const auto data = mesh.data(entry / 3);
    const Vec2 &o = data.p[c], &p = data.p[(c + 1) % 3], &q = data.p[(c + 2) % 3];
    const auto place = [&](const Vec2& x) {
      return Vec2{o[0] + x[0] * (p[0] - o[0]) + x[1] * (q[0] - o[0]),
                  o[1] + x[0] * (p[1] - o[1]) + x[1] * (q[1] - o[1])};
    };
    result.push_back(place({share, 0}));
    Crossing crossing(data, static_cast<int>(c), forward);
    crossing.keep_points = true;
    int side = 0;
    if (crossing.run(share, nullptr, side, share) != QuickEnd::crossed) break;
    for (const Vec2& x : crossing.points) result.push_back(place(x));
    entry =
        mesh.twin(3 * (entry / 3) + static_cast<Index>((c + static_cast<std::size_t>(side)) % 3));
    share = 1 - share;
  }
  return result;
}

bool inside(const std::vector<Vec2>& polygon, const Vec2& x) {
  bool in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if ((p[1] > x[1]) != (q[1] > x[1]) &&
        x[0] < p[0] + (x[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
      in = !in;
  }
  return in;
}

bool closes(const CollapseMesh& mesh, const AnnulusDoor& door, const std::vector<HalfEdge>& exits) {
  std::vector<Index> triangles;
  for (const HalfEdge h : exits) triangles.push_back(h / 3);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  const Part part(mesh, triangles);
  BarrierMaker<double> maker(*part.domain, kDoubles);
  const auto on_side = [](double t) { return t <= 0.5 ? t : t - 1; };
  const Gate<double> first{part.here(door.side), on_side(door.low), on_side(door.high)};
  Gate<double> at = first;
  for (std::size_t k = 0; k < exits.size(); ++k) {
    const auto cell = cross_cell(maker, door.forward, at, nullptr);
    if (cell.end != CellEnd::crossed) return false;
    at = cell.gate;
  }
  return at.side == first.side && strictly_inside(at, first);
}

QuickEnd cross_quickly(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
                       const TrapShape* trap, Step& step, TriedPlaces* tried) {
  const int corner = static_cast<int>(entry % 3);
  Crossing crossing(mesh.data(entry / 3), corner, forward);
  int side = 0;
  const QuickEnd end = crossing.run(share, trap, side, step.share);
  if (crossing.piece > kManyPieces && tried != nullptr &&
      !tried->provable(mesh, forward, entry, share, trap))
    return QuickEnd::lost;
  step.exit = 3 * (entry / 3) + static_cast<Index>((corner + side) % 3);
  return end;
}

Start start_now(const CollapseMesh& mesh, Index vertex, bool forward) {
  std::vector<HalfEdge> fan;
  mesh.fan(vertex, fan);
  std::vector<Index> triangles;
  for (const HalfEdge h : fan) triangles.push_back(h / 3);
  const Part part(mesh, triangles);
  Start start = start_at_vertex(*part.domain, part.domain->fan(part.here(fan.front())), forward);
  if (start.kind != StartKind::none) start.place = part.there(start.place);
  return start;
}

QuickEnd begin_quickly(const CollapseMesh& mesh, const Start& start, const TrapShape* trap,
                       Step& step) {
  const bool whole_fan = start.from_switch_point && start.vertex != kNone;
  std::vector<Index> triangles;
  if (whole_fan) {
    std::vector<HalfEdge> fan;
    mesh.fan(mesh.from(start.vertex), fan);
    for (const HalfEdge h : fan) triangles.push_back(h / 3);
  } else {
    triangles = {start.place / 3};
  }
  const Part part(mesh, triangles);
  Start local = start;
  if (whole_fan)
    local = start_at_vertex(*part.domain, part.domain->fan(part.here(start.vertex)), start.forward);
  else
    local.place = part.here(start.place);
  if (local.kind == StartKind::none) return QuickEnd::lost;
  BarrierMaker<double> maker(*part.domain, kDoubles);
  Trace trace;
  const CellResult<double> cell = begin(maker, local, trace, trap);
  if (cell.end == CellEnd::trapped) return QuickEnd::trapped;
  if (cell.end == CellEnd::open) return QuickEnd::lost;
  HalfEdge side = cell.gate.side;
  double t = near_middle(cell.gate);
  if (cell.end == CellEnd::crossed) {
    side = part.domain->twin(side);
    t = from_other_side(t);
  }
  step = {part.there(side), t > 0 ? t : 1 + t};
  return QuickEnd::crossed;
}

}  // namespace crest::vector_fields
