// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 2 as a table: edges that are taken for critical, or missed, by the test of dot products
// (section 2.1.1) and by the 10-degree search of the paper, against the certified flags; of one
// field on grids of steps 1, 2, 4 and 8, and where n twists along an edge.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "algorithms/extremal/extraction.hpp"
#include "experiments/000-extremal/inputs.hpp"
#include "experiments/program.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::experiments {
namespace {

using namespace extremal;
using kernel::Vec3;
constexpr double kTenDegrees = std::numbers::pi / 18;

/// The paper's search: halves where the acute angle of the directions at the ends exceeds 10
/// degrees. Returns the sign that carries n from one end to the other. `at`: n on [0, 1].
template <class At>
int transported(const At& at, double low, double high, const Vec3& a, const Vec3& b, int depth,
                int& halvings) {
  const double c = kernel::dot(a, b);
  if (std::fabs(c) >= std::cos(kTenDegrees) || depth == 14) return c < 0 ? -1 : 1;
  ++halvings;
  const double middle = (low + high) / 2;
  const Vec3 m = at(middle);
  return transported(at, low, middle, a, m, depth + 1, halvings) *
         transported(at, middle, high, m, b, depth + 1, halvings);
}

struct Wrong {
  std::size_t edges = 0, critical = 0, listed = 0;
  std::size_t dot_false = 0, dot_missed = 0, ten_false = 0, ten_missed = 0;
};

/// n and v = grad s anywhere on the grid.
class Anywhere {
 public:
  explicit Anywhere(const Fields& fields) : fields_(fields) {}
  Local at(const Vec3& x) const {
    Node v{};
    Vec3 t{};
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = std::min(static_cast<int>(std::floor(x[k])), std::max(fields_.grid().size[k] - 2, 0));
      t[k] = x[k] - v[k];
    }
    return fields_.at(v, t);
  }
  Vec3 direction(const Vec3& x) const { return dominant_direction(at(x).tensor); }

 private:
  const Fields& fields_;
};

/// The edge of `step` unit edges from v along the axis, if all their ends are active.
void count_edge(const Extraction& e, const Anywhere& field, const Node& v, std::size_t axis,
                int step, Wrong& wrong) {
  const Grid& grid = e.fields().grid();
  Node u = v;
  bool critical = false, listed = false;
  for (int i = 0; i < step; ++i, ++u[axis]) {
    const auto edge = static_cast<kernel::Index>(3 * grid.index(u) + axis);
    const EdgeState state = e.edges().state(edge);
    if (state == EdgeState::untested) return;
    listed = listed || state == EdgeState::undecided;
    critical = critical != e.edges().critical(edge);
  }
  ++wrong.edges;
  if (listed) {
    ++wrong.listed;
    return;
  }
  wrong.critical += critical ? 1 : 0;
  const Vec3 from = {double(v[0]), double(v[1]), double(v[2])};
  const auto place = [&](double t) {
    Vec3 x = from;
    x[axis] += t * step;
    return x;
  };
  const Vec3 a = field.direction(place(0)), b = field.direction(place(1));
  const double ga = kernel::dot(a, field.at(place(0)).gradient),
               gb = kernel::dot(b, field.at(place(1)).gradient);
  const bool by_dot = ga * gb * kernel::dot(a, b) < 0;
  int halvings = 0;
  const int sign =
      transported([&](double t) { return field.direction(place(t)); }, 0, 1, a, b, 0, halvings);
  const bool by_ten = ga * gb * sign < 0;
  wrong.dot_false += by_dot && !critical ? 1 : 0;
  wrong.dot_missed += !by_dot && critical ? 1 : 0;
  wrong.ten_false += by_ten && !critical ? 1 : 0;
  wrong.ten_missed += !by_ten && critical ? 1 : 0;
}

void rows(const std::string& name, const extremal::Volume& volume, const Options& options,
          const std::vector<int>& steps) {
  const Extraction e(Fields(volume, options), options);
  const Grid& grid = e.fields().grid();
  const Anywhere field(e.fields());
  for (const int step : steps) {
    Wrong w;
    Node v{};
    for (v[2] = 0; v[2] < grid.size[2]; v[2] += step)
      for (v[1] = 0; v[1] < grid.size[1]; v[1] += step)
        for (v[0] = 0; v[0] < grid.size[0]; v[0] += step)
          for (std::size_t axis = 0; axis < 3; ++axis)
            if (v[axis] + step < grid.size[axis]) count_edge(e, field, v, axis, step, w);
    fmt::print("| {} | {} | {} | {} | {} | {} / {} | {} / {} | {} |\n", name,
               options.definition == Definition::hessian ? "hessian" : "structure", step, w.edges,
               w.critical, w.dot_false, w.dot_missed, w.ten_false, w.ten_missed, w.listed);
    std::fflush(stdout);
  }
}

/// n twists in a plane by an angle along an edge, grad s is constant and at 20.6 degrees to n at
/// the lower end. T = n n^T lies in the triangle of its values at the ends and the meeting point of
/// the tangents there: three controls for the cone test.
struct Twist {
  double angle;
  static constexpr double kGradient = 0.36;  // 20.6 degrees: no angle of the table is a tie
  double at(double t) const { return angle * t; }
  Vec3 direction(double t) const { return {std::cos(at(t)), std::sin(at(t)), 0}; }
  double g(double t) const { return std::cos(at(t) - kGradient); }
  bool critical() const {
    // g = 0 at odd multiples of 90 degrees from grad s, each a change of sign
    const double turns = (angle - kGradient) / std::numbers::pi + 0.5;
    return std::fmod(std::floor(turns), 2) != 0;
  }
  static kernel::Symmetric3<double> tensor(double twice, double length) {
    return {0.5 + length * std::cos(twice) / 2,
            0.5 - length * std::cos(twice) / 2,
            0,
            length * std::sin(twice) / 2,
            0,
            0};
  }
  bool passes(double low, double high) const {
    const double middle = at(low) + at(high), half = at(high) - at(low);
    if (half >= std::numbers::pi / 2) return false;  // the tangents do not meet on this side
    const Vec3 w = direction((low + high) / 2);
    for (const auto& t :
         {tensor(2 * at(low), 1), tensor(2 * at(high), 1), tensor(middle, 1 / std::cos(half))})
      if (kernel::cone_test(t, w).sign != kernel::Sign::positive) return false;
    return true;
  }
  int transport(double low, double high, int depth, int& tests) const {
    ++tests;
    if (passes(low, high)) return kernel::dot(direction(low), direction(high)) < 0 ? -1 : 1;
    if (depth == 14) return 0;
    const double middle = (low + high) / 2;
    return transport(low, middle, depth + 1, tests) * transport(middle, high, depth + 1, tests);
  }
};

void twists() {
  fmt::print(
      "\nA twist of n by an angle along an edge, grad s constant (figure 2b): is there an odd "
      "number of critical points?\n\n"
      "| angle | truth | dot product | 10 degrees (halvings) | cone test (tests) "
      "|\n|---|---|---|---|---|\n");
  std::size_t dot_wrong = 0, ten_wrong = 0, cone_wrong = 0;
  const auto word = [](bool critical, bool truth) {
    return fmt::format("{}{}", critical ? "critical" : "no", critical == truth ? "" : " WRONG");
  };
  for (int degrees = 10; degrees <= 540; degrees += 5) {
    const Twist twist{degrees * std::numbers::pi / 180};
    const Vec3 a = twist.direction(0), b = twist.direction(1);
    const bool truth = twist.critical();
    const double product = twist.g(0) * twist.g(1);
    int halvings = 0, tests = 0;
    const bool by_dot = product * kernel::dot(a, b) < 0;
    const bool by_ten = product * transported([&](double t) { return twist.direction(t); }, 0, 1, a,
                                              b, 0, halvings) <
                        0;
    const bool by_cone = product * twist.transport(0, 1, 0, tests) < 0;
    dot_wrong += by_dot != truth;
    ten_wrong += by_ten != truth;
    cone_wrong += by_cone != truth;
    if (degrees % 30 == 0 || degrees == 10 || by_ten != truth)
      fmt::print("| {} | {} | {} | {} ({}) | {} ({}) |\n", degrees, truth ? "critical" : "no",
                 word(by_dot, truth), word(by_ten, truth), halvings, word(by_cone, truth), tests);
  }
  fmt::print(
      "\nOf 107 angles from 10 to 540 in steps of 5: wrong by dot products {}, by 10 degrees {}, "
      "by the cone test {}.\n",
      dot_wrong, ten_wrong, cone_wrong);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest;
  int nodes = 64;
  std::vector<int> steps{1, 2, 4, 8};
  std::vector<std::string> volumes;
  std::string only;
  double min_value = 0;
  experiments::Program program("Edges that other tests take for critical or miss.");
  program.option("--nodes", nodes, "of the phantoms", {8, 256});
  program.list("--steps", steps, "of the grids");
  program.list("--volume", volumes, "instead of the phantoms: volumes, each with --min-value");
  program.option("--min-value", min_value, "of volumes");
  program.option("--only", only, "a definition: structure, hessian", {"structure", "hessian"});
  return program.run(argc, argv, [&] {
    fmt::print(
        "False / missed critical edges; a long edge is critical if an odd number of its unit edges "
        "is certified so\n\n"
        "| field | definition | step | edges | critical | dot product | 10 degrees | not decided "
        "|\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (const bool hessian : {false, true}) {
      if (only == (hessian ? "structure" : "hessian")) continue;
      for (const auto& path : volumes) {
        auto options = experiments::ridge_options(hessian, min_value);
        experiments::rows(path.substr(path.rfind('/') + 1),
                          experiments::volume_of(io::read_volume(path).grid), options, steps);
      }
      if (!volumes.empty()) continue;
      for (const auto& p : sampling::volume_phantoms())
        experiments::rows(p.name, experiments::phantom(p.name, static_cast<std::size_t>(nodes)),
                          experiments::ridge_options(hessian, 0.4), steps);
    }
    if (volumes.empty()) experiments::twists();
    return 0;
  });
}
