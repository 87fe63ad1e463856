// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/face_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/smooth_ridges/face_lanes.hpp"
#include "algorithms/smooth_ridges/frame_jet.hpp"

namespace crest::smooth_ridges {
namespace {

using Model = FaceModel;
template <int K>
using Field = kernel::Jet<Model, 2, K>;

bool holds_zero(const kernel::Range& r) {
  return !(r.low > 0 || r.high < 0);
}
int sign_of(const kernel::Range& r) {
  return r.low > 0 ? 1 : r.high < 0 ? -1 : 0;
}

/// A polynomial in s, by ascending degree.
using EdgePolynomial = std::array<double, 5>;
static_assert(Model::kTable.exponents.back()[0] + 1 == EdgePolynomial{}.size());

constexpr EdgePolynomial times_linear(const EdgePolynomial& p, double at0, double at1) {
  EdgePolynomial r{};
  for (std::size_t n = 0; n < r.size(); ++n)
    r[n] = at0 * p[n] + (n > 0 ? (at1 - at0) * p[n - 1] : 0);
  return r;
}

/// The monomials on edge i, s in [0, 1] from its corner i.
constexpr auto kOnEdges = [] {
  constexpr double u[] = {-0.5, 1, -0.5}, v[] = {-0.5, -0.5, 1};
  std::array<std::array<EdgePolynomial, Model::kCount>, 3> all{};
  for (std::size_t edge = 0; edge < 3; ++edge)
    for (std::size_t k = 0; k < Model::kCount; ++k) {
      EdgePolynomial p{1};
      const std::size_t next = (edge + 1) % 3;
      for (int n = 0; n < Model::kTable.exponents[k][0]; ++n) p = times_linear(p, u[edge], u[next]);
      for (int n = 0; n < Model::kTable.exponents[k][1]; ++n) p = times_linear(p, v[edge], v[next]);
      all[edge][k] = p;
    }
  return all;
}();

/// A model's polynomial on edge i.
EdgePolynomial on_edge(const Model& f, std::size_t edge) {
  EdgePolynomial sum{};
  for (std::size_t k = 0; k < Model::kCount; ++k)
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += f.c[k] * kOnEdges[edge][k][n];
  return sum;
}
double value(const EdgePolynomial& p, double s) {
  return p[0] + s * (p[1] + s * (p[2] + s * (p[3] + s * p[4])));
}

/// The zero on a crossed edge by bisection.
double zero_on_edge(const Model& f, std::size_t edge) {
  const EdgePolynomial p = on_edge(f, edge);
  double low = 0, high = 1;
  const bool rising = p[0] < 0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    ((value(p, middle) < 0) == rising ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

FaceImage image_of(const Chart<Model>& chart) {
  return {chart.x[0].range(), chart.x[1].range(), chart.x[2].range()};
}

/// The derivatives by the model's coordinates at (u, v), without the remainder.
std::array<double, 2> slopes_at(const Model& f, double u, double v) {
  std::array<double, 6> pu{1}, pv{1};
  for (std::size_t n = 1; n < 5; ++n) pu[n] = pu[n - 1] * u, pv[n] = pv[n - 1] * v;
  std::array<double, 2> sum{};
  for (std::size_t k = 1; k < Model::kCount; ++k) {
    const std::size_t i = Model::kTable.exponents[k][0], j = Model::kTable.exponents[k][1];
    if (i > 0) sum[0] += f.c[k] * static_cast<double>(i) * pu[i - 1] * pv[j];
    if (j > 0) sum[1] += f.c[k] * static_cast<double>(j) * pu[i] * pv[j - 1];
  }
  return sum;
}

using Tangents = std::array<std::array<double, 2>, 2>;

/// At the centroid, by the models' u and v.
Tangents tangents_of(const Chart<Model>& chart, bool implicit, const Frame& frame) {
  const auto vectors =
      implicit ? frame_vectors(frame) : std::array<Vec3, 3>{Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Tangents t{};
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < 3; ++i) t[d][k] += vectors[k][i] * chart.x[i].c[2 - d];
  return t;
}

/// Whether E's polynomial shows that its derivatives would not decide the face: along the gradient
/// at the centroid it falls somewhere.
bool slope_turns(const Model& e, const Tangents& tangents) {
  const auto& [tu, tv] = tangents;
  const auto gradient = [&](double u, double v) {  // but for the factor det
    const auto [eu, ev] = slopes_at(e, u, v);
    return std::array{eu * tv[1] - ev * tu[1], ev * tu[0] - eu * tv[0]};
  };
  const auto c = gradient(0, 0);
  constexpr std::array<double, 2> kPoints[] = {{-0.5, -0.5}, {1, -0.5},    {-0.5, 1},
                                               {0.25, -0.5}, {0.25, 0.25}, {-0.5, 0.25}};
  return std::any_of(std::begin(kPoints), std::end(kPoints), [&](const auto& p) {
    const auto g = gradient(p[0], p[1]);
    return c[0] * g[0] + c[1] * g[1] < 0;
  });
}

/// Lemma 5: of the sign of G.
RidgeType arc_type(int sign, std::size_t j) {
  return (sign < 0) == (j == 0) ? RidgeType::elliptic : RidgeType::hyperbolic;
}

/// Two arcs nearly parallel: a combination of E1 and E2 nearly without slope has no zero.
bool apart(const Extremalities<1>& x) {
  std::array<double, 2> slope;
  for (std::size_t j = 0; j < 2; ++j)
    slope[j] = std::hypot(x.e[j].coefficient(1, 0).c[0], x.e[j].coefficient(0, 1).c[0]);
  const double along = x.e[0].coefficient(1, 0).c[0] * x.e[1].coefficient(1, 0).c[0] +
                       x.e[0].coefficient(0, 1).c[0] * x.e[1].coefficient(0, 1).c[0];
  const Model combined = x.e[0][0] * slope[1] - x.e[1][0] * (along > 0 ? slope[0] : -slope[0]);
  return !holds_zero(combined.range());
}

}  // namespace

struct FaceTest::State {
  explicit State(const Surface& surface)
      : implicit(surface.is_implicit()),
        has_corners(!implicit && !surface.any_period()),
        charts(surface),
        lanes(surface) {
    if (implicit) {
      f3.emplace(surface), f4.emplace(surface), f5.emplace(surface);
    } else {
      x3.emplace(surface), x4.emplace(surface), x5.emplace(surface);
      plain_map.emplace(surface);
    }
  }

  template <class Map>
  static auto unit(Map& map, const Chart<Model>& chart) {
    return map(std::array<Model, 2>{chart.x[0], chart.x[1]});
  }

  FaceResult run(const Corners& c) {
    FaceResult r;
    auto chart = charts(c);
    if (!chart) return r;
    r.image = image_of(*chart);
    special = domain_corner(c);
    if (special) corner = at_corner(c[*special]);
    Extremalities<0> values;
    r.status = plain(*chart, c, values, r);
    if (looks_decidable(*chart, values, r)) r.status = ridges(*chart, c, r);
    return r;
  }

  /// Whether an extremality may have zeros, and derivatives may decide.
  bool looks_decidable(const Chart<Model>& chart, const Extremalities<0>& values, FaceResult& r) {
    if (r.status != FaceStatus::proven) return false;
    for (std::size_t j = 0; j < 2; ++j) {
      const Model& e = values.e[j][0];
      r.colour[j].no_zero = !holds_zero(e.range());
      // Derivatives lose more: not worth their cost where the remainder hides E's slope, or E
      // tells.
      if (!r.colour[j].no_zero &&
          (e.radius > 0.5 * (std::fabs(e.c[1]) + std::fabs(e.c[2])) ||
           (!special && slope_turns(e, tangents_of(chart, implicit, r.frame)))))
        r.status = FaceStatus::ridge;
    }
    return r.status == FaceStatus::proven && !(r.colour[0].no_zero && r.colour[1].no_zero);
  }

  std::optional<std::size_t> domain_corner(const Corners& c) const {
    const auto end = [](double x) { return x == 0 || x == 1; };
    for (std::size_t k = 0; has_corners && k < 3; ++k)
      if (end(c[k][0]) && end(c[k][1])) return k;
    return std::nullopt;
  }
  /// w and, by colour, c at a corner of the domain: from that point alone, so that all faces there
  /// choose the same.
  struct Directions {
    std::uint8_t w;
    std::array<std::uint8_t, 2> c;
  };
  Directions at_corner(const Vertex& v) {
    const MapGeometry<double, 4> geometry{(*plain_map)(std::array<double, 2>{v[0], v[1]})};
    const auto forms = forms_of<1>(geometry);
    const auto shape = shape_of(forms.i, forms.l);
    const auto sigma = sqrt(squared_sigma(shape));
    Directions d;
    d.w = along_first(shape.a[0], shape.b[0], shape.c[0], sigma[0]);
    const auto w = direction(d.w);
    Pair<kernel::Jet<double, 2, 1>> v1 = first_principal(times(shape, w), sigma, w);
    for (std::size_t j = 0; j < 2; ++j) {
      const auto e = extremality(forms, j == 0 ? v1 : second_principal(forms.i, v1));
      d.c[j] = nearest_direction(e.coefficient(1, 0), e.coefficient(0, 1));
    }
    return d;
  }
  /// Stage without derivatives: axis, w, (R), values.
  FaceStatus plain(Chart<Model>& chart, const Corners& c, Extremalities<0>& values, FaceResult& r) {
    if (!implicit) return measure<0>(MapGeometry<Model, 3>{unit(*x3, chart)}, values, r, true);
    r.frame = nearest_frame(mean_normal(c));
    const auto f = in_frame((*f3)(chart.x), frame_vectors(r.frame));
    if (!(f.coefficient(0, 0, 1).range().low > 0)) return FaceStatus::chart;
    return measure<0>(GraphGeometry<Model, 3>{GraphJet<Model, 3>::of(f, 2)}, values, r, true);
  }

  /// The same with K derivatives along the surface; implicit, K = 1: and grad F.
  template <int K>
  FaceStatus derived(Chart<Model>& chart, Extremalities<K>& out, FaceResult& r) {
    static_assert(K == 1 || K == 2);
    if (!implicit) {
      if constexpr (K == 1)
        return measure<K>(MapGeometry<Model, 4>{unit(*x4, chart)}, out, r, false);
      else
        return measure<K>(MapGeometry<Model, 5>{unit(*x5, chart)}, out, r, false);
    }
    const auto f = [&] {
      if constexpr (K == 1)
        return (*f4)(chart.x);
      else
        return (*f5)(chart.x);
    }();
    if constexpr (K == 1)
      gradient = {f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)};
    const auto h = GraphJet<Model, K + 3>::of(in_frame(f, frame_vectors(r.frame)), 2);
    return measure<K>(GraphGeometry<Model, K + 3>{h}, out, r, false);
  }

  /// chart.dx: in the frame's coordinates, but for the factor n^2. Requires: derived<1>.
  void set_tangents(Chart<Model>& chart, const Corners& c, const Frame& frame) {
    Charts<Model>::tangents(chart, c, gradient);
    const auto vectors = frame_vectors(frame);
    for (auto& t : chart.dx) {
      const auto x = t;
      for (std::size_t k = 0; k < 3; ++k)
        t[k] = x[0] * vectors[k][0] + x[1] * vectors[k][1] + x[2] * vectors[k][2];
    }
  }

  template <int K, class Geometry>
  FaceStatus measure(const Geometry& geometry, Extremalities<K>& out, FaceResult& r,
                     bool choose) const {
    const auto forms = forms_of<K>(geometry);
    const auto shape = shape_of(forms.i, forms.l);
    const auto squared = squared_sigma(shape);
    if (!(squared[0].range().low > 0)) return FaceStatus::regular;
    const auto sigma = sqrt(squared);
    if (!std::isfinite(sigma[0].radius)) return FaceStatus::regular;
    if (choose)
      r.w = special ? corner.w
                    : along_first(shape.a[0].c[0], shape.b[0].c[0], shape.c[0].c[0], sigma[0].c[0]);
    const auto w = direction(r.w);
    const auto aw = times(shape, w);
    if (!(transverse(forms.i, aw, w)[0].range().low > 0)) return FaceStatus::regular;
    out.v[0] = first_principal(aw, sigma, w);
    out.v[1] = second_principal(forms.i, out.v[0]);
    for (std::size_t j = 0; j < 2; ++j) out.e[j] = extremality(forms, out.v[j]);
    return FaceStatus::proven;
  }

  FaceStatus ridges(Chart<Model>& chart, const Corners& c, FaceResult& r) {
    Extremalities<1> x;
    const FaceStatus status = derived<1>(chart, x, r);
    return status == FaceStatus::proven ? ridges(chart, c, x, r) : status;
  }
  FaceStatus ridges(Chart<Model>& chart, const Corners& c, const Extremalities<1>& x,
                    FaceResult& r) {
    for (std::size_t j = 0; j < 2; ++j)
      if (!r.colour[j].no_zero && !monotone(x.e[j], j, r.colour[j])) return FaceStatus::ridge;
    if (implicit) set_tangents(chart, c, r.frame);
    for (std::size_t j = 0; j < 2; ++j) {
      if (r.colour[j].no_zero) continue;
      decide_edges(chart, x.e[j], r.colour[j]);
      if (is_crossed(r.colour[j]) && !type(chart, x, j, r)) return FaceStatus::type;
    }
    if (is_crossed(r.colour[0]) && is_crossed(r.colour[1]) && !purple(x, r))
      return FaceStatus::purple;
    return FaceStatus::proven;
  }

  static bool is_crossed(const ColourResult& colour) {
    return colour.crossed[0] || colour.crossed[1] || colour.crossed[2];
  }

  /// The direction c, and certain signs at the corners.
  bool monotone(const Field<1>& e, std::size_t j, ColourResult& colour) const {
    const Model &e1 = e.coefficient(1, 0), &e2 = e.coefficient(0, 1);
    if (e1.c[0] == 0 && e2.c[0] == 0) return false;
    colour.monotone = special ? corner.c[j] : nearest_direction(e1.c[0], e2.c[0]);
    const auto c = direction(colour.monotone);
    if (holds_zero((e1 * c[0] + e2 * c[1]).range())) return false;
    std::array<int, 3> signs;
    for (int k = 0; k < 3; ++k) {
      int& sign = signs[static_cast<std::size_t>(k)];
      sign = sign_of(e[0].at_corner(k));
      if (sign != 0) continue;
      if (!special || *special != static_cast<std::size_t>(k)) return false;
      colour.loose_corner = k;
      sign = 1;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      colour.crossed[k] = signs[k] != signs[(k + 1) % 3];
      if (colour.crossed[k]) colour.at[k] = zero_on_edge(e[0], k);
    }
    return true;
  }

  /// Which edges have as many zeros as the signs at their ends say, provably in this face.
  static void decide_edges(const Chart<Model>& chart, const Field<1>& e, ColourResult& colour) {
    std::array<Model, 2> by;  // derivatives by l1 and l2
    for (std::size_t i = 0; i < 2; ++i)
      by[i] = e.coefficient(1, 0) * chart.dx[i][0] + e.coefficient(0, 1) * chart.dx[i][1];
    const std::array<Model, 3> along = {by[0], by[1] - by[0], -by[1]};
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      colour.slope[i] = sign_of(along[i].range_on_edge(k));
      colour.edge_decided[i] =
          colour.slope[i] != 0 || (!colour.crossed[i] && !holds_zero(e[0].range_on_edge(k)));
    }
  }

  bool type(Chart<Model>& chart, const Extremalities<1>& x, std::size_t j, FaceResult& r) {
    ColourResult& colour = r.colour[j];
    const Model g =
        x.v[j][0][0] * x.e[j].coefficient(1, 0) + x.v[j][1][0] * x.e[j].coefficient(0, 1);
    const int sign = sign_of(g.range());
    if (sign != 0) {
      colour.type = arc_type(sign, j);
      return true;
    }
    if (colour.loose_corner >= 0) return false;
    Extremalities<2> y;
    if (derived<2>(chart, y, r) != FaceStatus::proven) return false;
    const auto e1 = partial<1>(y.e[j], 1, 0), e2 = partial<1>(y.e[j], 0, 1);
    const auto along = partial<1>(y.v[j][0], 0, 0) * e1 + partial<1>(y.v[j][1], 0, 0) * e2;
    const Model det = e1[0] * along.coefficient(0, 1) - e2[0] * along.coefficient(1, 0);
    if (holds_zero(det.range())) return false;
    // The curve G = 0 leaves the face through a crossed edge: what counts is G at the crossings.
    int sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!colour.crossed[k]) continue;
      const double at = value(on_edge(along[0], k), colour.at[k]);
      if (!(std::fabs(at) > 4 * along[0].radius)) return false;
      sum += at > 0 ? 1 : -1;
    }
    colour.type = sum == 0 ? RidgeType::turning : arc_type(sum, j);
    return true;
  }
  /// Whether the two arcs cross; false if that is not decided.
  static bool purple(const Extremalities<1>& x, FaceResult& r) {
    const Model det = x.e[0].coefficient(1, 0) * x.e[1].coefficient(0, 1) -
                      x.e[0].coefficient(0, 1) * x.e[1].coefficient(1, 0);
    if (holds_zero(det.range()) || r.colour[0].loose_corner >= 0 || r.colour[1].loose_corner >= 0)
      return apart(x);
    int product = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!r.colour[0].crossed[k]) continue;
      const Model& red = x.e[1][0];
      int sign = sign_of(red.at_corner(static_cast<int>(k)));
      if (r.colour[1].crossed[k]) {
        const double blue_at = r.colour[0].at[k], red_at = r.colour[1].at[k];
        const double between = 0.5 * (blue_at + red_at);
        for (const Extremalities<1>* both = &x; const auto& e : both->e)
          if (!(std::fabs(value(on_edge(e[0], k), between)) > 2 * e[0].radius)) return false;
        if (blue_at > red_at) sign = -sign;
      }
      product *= sign;
    }
    r.purple = product < 0;
    return true;
  }

  bool implicit, has_corners;
  std::optional<std::size_t> special;  ///< corner of the present face that is one of the domain
  Directions corner{};                 ///< there
  std::optional<ParametricMap<double, 4>> plain_map;
  std::array<Model, 3> gradient{};  ///< of F on the present face
  Charts<Model> charts;
  FaceLanes lanes;
  std::optional<ImplicitMap<Model, 3>> f3;
  std::optional<ImplicitMap<Model, 4>> f4;
  std::optional<ImplicitMap<Model, 5>> f5;
  std::optional<ParametricMap<Model, 3>> x3;
  std::optional<ParametricMap<Model, 4>> x4;
  std::optional<ParametricMap<Model, 5>> x5;
};

/// Many faces, several at a time: those with ridges wait for others of their kind.
struct FaceTest::Together {
  State& test;
  std::span<const Corners> faces;
  std::span<FaceResult> results;

  void run() {
    constexpr std::size_t kWide = FaceLanes::kCount;
    std::vector<std::size_t> group;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (test.domain_corner(faces[f]))
        results[f] = test.run(faces[f]);
      else
        group.push_back(f);
      if (group.size() == kWide) start(std::exchange(group, {}));
      if (waiting.size() >= kWide) derive();
    }
    start(group);
    while (!waiting.empty()) derive();
  }

  /// Fewer faces go alone: lanes cost as much as this many, or more.
  static constexpr std::size_t kWorthwhile = 3;
  struct Waiting {
    std::size_t face;
    FaceLanes::Start start;
  };
  std::vector<Waiting> waiting{};

  void start(const std::vector<std::size_t>& group) {
    std::vector<const Corners*> corners;
    for (const std::size_t f : group) corners.push_back(&faces[f]);
    std::vector<FaceLanes::Start> starts(group.size());
    if (group.size() < kWorthwhile || !test.lanes.start(corners, starts)) {
      for (const std::size_t f : group) results[f] = test.run(faces[f]);
      return;
    }
    test.special.reset();
    for (std::size_t k = 0; k < group.size(); ++k) {
      FaceResult& r = results[group[k]] = {};
      FaceLanes::Start& s = starts[k];
      using Passed = FaceLanes::Passed;
      if (s.passed == Passed::none) continue;
      r.image = s.image;
      r.frame = s.frame;
      r.w = s.w;
      r.status = s.passed == Passed::regular                  ? FaceStatus::proven
                 : s.passed == Passed::wide                   ? FaceStatus::ridge
                 : test.implicit && s.passed == Passed::chart ? FaceStatus::chart
                                                              : FaceStatus::regular;
      if (test.looks_decidable(s.chart, s.values, r)) waiting.push_back({group[k], std::move(s)});
    }
  }

  /// The last faces that wait, as many as there are lanes.
  void derive() {
    const std::size_t count = std::min(waiting.size(), FaceLanes::kCount);
    const auto group = std::span(waiting).last(count);
    std::vector<const FaceLanes::Start*> starts;
    for (const Waiting& w : group) starts.push_back(&w.start);
    std::vector<FaceLanes::Derived> derived(count);
    const bool together = count >= kWorthwhile && test.lanes.derive(starts, derived);
    test.special.reset();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t f = group[k].face;
      FaceResult& r = results[f];
      Chart<Model>& chart = group[k].start.chart;
      if (!together) {
        r.status = test.ridges(chart, faces[f], r);
      } else if (derived[k].passed != FaceLanes::Passed::regular) {
        r.status =
            derived[k].passed == FaceLanes::Passed::wide ? FaceStatus::ridge : FaceStatus::regular;
      } else {
        test.gradient = derived[k].gradient;
        r.status = test.ridges(chart, faces[f], derived[k].values, r);
      }
    }
    waiting.resize(waiting.size() - count);
  }
};

FaceTest::FaceTest(const Surface& surface) : state_(std::make_unique<State>(surface)) {}
FaceTest::~FaceTest() = default;
FaceTest::FaceTest(FaceTest&&) noexcept = default;

FaceResult FaceTest::operator()(const Corners& corners) {
  return state_->run(corners);
}

void FaceTest::operator()(std::span<const Corners> faces, std::span<FaceResult> results) {
  Together{*state_, faces, results}.run();
}

std::optional<FaceImage> FaceTest::image(const Corners& corners) {
  const auto chart = state_->charts(corners);
  if (!chart) return std::nullopt;
  return image_of(*chart);
}

}  // namespace crest::smooth_ridges
