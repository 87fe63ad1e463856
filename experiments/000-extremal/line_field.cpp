// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 1, 3 and 4: the line field at half the argument of (z-z1)(z-z2) conj((z-z3)(z-z4)) and
// s = sin(7x+2y) + 0.7 cos(5y-3x) on the unit square, over squares, triangles and quadtrees. Every
// grid must have one odd cell a singularity, and no other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>

#include "experiments/program.hpp"
#include "io/picture/picture_file.hpp"

namespace crest::experiments {
namespace {

using Complex = std::complex<double>;
constexpr Complex kSingular[4] = {{0.31, 0.42}, {0.68, 0.57}, {0.52, 0.23}, {0.44, 0.81}};

double scalar(Complex z) {
  return std::sin(7 * z.real() + 2 * z.imag()) + 0.7 * std::cos(5 * z.imag() - 3 * z.real());
}
Complex gradient(Complex z) {
  const double a = std::cos(7 * z.real() + 2 * z.imag()), b = std::sin(5 * z.imag() - 3 * z.real());
  return {7 * a + 2.1 * b, 2 * a - 3.5 * b};
}
/// Second derivative along n.
double second(Complex z, Complex n) {
  const double a = -std::sin(7 * z.real() + 2 * z.imag()),
               b = -0.7 * std::cos(5 * z.imag() - 3 * z.real());
  const double along = 7 * n.real() + 2 * n.imag(), across = 5 * n.imag() - 3 * n.real();
  return a * along * along + b * across * across;
}
Complex square_of_n(Complex z) {
  return (z - kSingular[0]) * (z - kSingular[1]) *
         std::conj((z - kSingular[2]) * (z - kSingular[3]));
}
/// n, with the argument in (-90, 90] degrees.
Complex direction(Complex z) {
  return std::polar(1.0, std::arg(square_of_n(z)) / 2);
}
double dot(Complex a, Complex b) {
  return (a * std::conj(b)).real();
}

/// Bernstein coefficients of square_of_n on a segment.
std::array<Complex, 5> net(Complex a, Complex b) {
  std::array<Complex, 5> c{1};
  for (std::size_t k = 0; k < 4; ++k) {
    Complex low = a - kSingular[k], high = b - kSingular[k];
    if (k > 1) {
      low = std::conj(low);
      high = std::conj(high);
    }
    const auto degree = static_cast<double>(k + 1);
    std::array<Complex, 5> next{};
    for (std::size_t i = 0; i <= k + 1; ++i) {
      const auto share = static_cast<double>(i) / degree;
      next[i] = (i <= k ? (1 - share) * c[i] * low : 0) + (i > 0 ? share * c[i - 1] * high : 0);
    }
    c = next;
  }
  return c;
}

/// The sign that carries direction() from a to b: parts on which the net stays in a half plane, so
/// that n turns by less than 90 degrees. 0: not decided.
int transported(Complex a, Complex b, int depth = 0) {
  const Complex middle = (a + b) / 2.0, w = square_of_n(middle);
  const auto controls = net(a, b);
  if (std::all_of(controls.begin(), controls.end(), [&](Complex c) {
        return dot(c, w) > 1e-12 * std::abs(c) * std::abs(w) && std::abs(c) > 0;
      }))
    return dot(direction(a), direction(b)) < 0 ? -1 : 1;
  if (depth == 40) return 0;
  return transported(a, middle, depth + 1) * transported(middle, b, depth + 1);
}

struct Crossing {
  Complex place;
  bool extremal;
};

double g(Complex z) {
  return dot(direction(z), gradient(z));
}

/// Halves the edge towards a zero of g, by the certified sign on each half.
Crossing crossing(Complex a, Complex b) {
  for (int i = 0; i < 40; ++i) {
    const Complex middle = (a + b) / 2.0;
    (g(a) * g(middle) * transported(a, middle) < 0 ? b : a) = middle;
  }
  return {a, second(a, direction(a)) > 0};
}

/// A grid: polygons with all vertices on their borders.
struct Cells {
  std::string name;
  std::vector<std::vector<Complex>> cells;
};

Cells squares(int n, bool triangles) {
  Cells result{fmt::format("{} {} x {}", triangles ? "triangles" : "squares", n, n), {}};
  const auto place = [n](int x, int y) { return Complex(double(x) / n, double(y) / n); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const Complex a = place(x, y), b = place(x + 1, y), c = place(x + 1, y + 1),
                    d = place(x, y + 1);
      if (triangles) {
        result.cells.push_back({a, b, c});
        result.cells.push_back({a, c, d});
      } else {
        result.cells.push_back({a, b, c, d});
      }
    }
  return result;
}

/// Leaves are split where n at two corners differs by more than 10 degrees or s_nn changes its sign
/// (section 3).
Cells quadtree(int depth) {
  struct Leaf {
    int x, y, size;
  };
  const int units = 1 << depth;
  const auto place = [units](int x, int y) {
    return Complex(double(x) / units, double(y) / units);
  };
  std::vector<Leaf> open{{0, 0, units}}, leaves;
  while (!open.empty()) {
    const Leaf l = open.back();
    open.pop_back();
    const Complex corners[4] = {place(l.x, l.y), place(l.x + l.size, l.y), place(l.x, l.y + l.size),
                                place(l.x + l.size, l.y + l.size)};
    bool split = l.size > units / 4;
    for (const Complex a : corners)
      for (const Complex b : corners)
        split = split ||
                std::fabs(dot(direction(a), direction(b))) < std::cos(std::numbers::pi / 18) ||
                second(a, direction(a)) * second(b, direction(b)) < 0;
    if (!split || l.size == 1) {
      leaves.push_back(l);
      continue;
    }
    const int h = l.size / 2;
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(h, 0), std::pair(0, h), std::pair(h, h)})
      open.push_back({l.x + x, l.y + y, h});
  }
  std::set<std::pair<int, int>> vertices;
  for (const Leaf& l : leaves)
    for (const int dx : {0, l.size})
      for (const int dy : {0, l.size}) vertices.emplace(l.x + dx, l.y + dy);
  Cells result{fmt::format("quadtree, depth {}, {} leaves", depth, leaves.size()), {}};
  for (const Leaf& l : leaves) {
    std::vector<Complex> cell;
    const auto walk = [&](int x, int y, int dx, int dy) {
      for (int i = 0; i < l.size; ++i)
        if (vertices.count({x + i * dx, y + i * dy})) cell.push_back(place(x + i * dx, y + i * dy));
    };
    walk(l.x, l.y, 1, 0);
    walk(l.x + l.size, l.y, 0, 1);
    walk(l.x + l.size, l.y + l.size, -1, 0);
    walk(l.x, l.y + l.size, 0, -1);
    result.cells.push_back(std::move(cell));
  }
  return result;
}

bool inside(const std::vector<Complex>& cell, Complex z) {
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Complex a = cell[i], d = cell[(i + 1) % cell.size()] - a;
    if ((std::conj(d) * (z - a)).imag() < 0) return false;
  }
  return true;
}

struct Extracted {
  std::size_t critical = 0, extremal = 0, undecided = 0, odd = 0, wrong = 0, ends = 0;
  std::vector<std::array<Crossing, 2>> segments;
  std::vector<Complex> odd_centres;
};

/// One vertex a cell; pairs of crossings of a cell with more are joined in the order of its border.
Extracted extract(const Cells& grid) {
  Extracted r;
  std::map<std::pair<double, double>, Crossing> seen;  // by the edge's middle
  for (const auto& cell : grid.cells) {
    std::vector<Crossing> crossings;
    Complex centre = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      Complex a = cell[i], b = cell[(i + 1) % cell.size()];
      centre += a / static_cast<double>(cell.size());
      if (std::pair(b.real(), b.imag()) < std::pair(a.real(), a.imag())) std::swap(a, b);
      const int sign = transported(a, b);
      r.undecided += sign == 0 ? 1 : 0;
      if (g(a) * g(b) * sign >= 0) continue;
      const Complex middle = (a + b) / 2.0;
      const auto [at, is_new] = seen.emplace(std::pair(middle.real(), middle.imag()), Crossing{});
      if (is_new) {
        at->second = crossing(a, b);
        ++r.critical;
        r.extremal += at->second.extremal ? 1 : 0;
      }
      crossings.push_back(at->second);
    }
    const bool odd = crossings.size() % 2 == 1;
    std::size_t singular = 0;
    for (const Complex z : kSingular) singular += inside(cell, z) ? 1 : 0;
    r.odd += odd ? 1 : 0;
    r.wrong += odd != (singular % 2 == 1) ? 1 : 0;
    if (odd) r.odd_centres.push_back(centre);
    for (std::size_t i = 0; i + 1 < crossings.size() && !odd; i += 2) {
      r.ends += crossings[i].extremal != crossings[i + 1].extremal ? 1 : 0;
      r.segments.push_back({crossings[i], crossings[i + 1]});
    }
    for (std::size_t i = 0; odd && i < crossings.size(); ++i)
      r.segments.push_back({crossings[i], {centre, crossings[i].extremal}});
  }
  return r;
}

void draw(const Cells& grid, const Extracted& r, const std::string& path) {
  constexpr int size = 800;
  io::Canvas canvas(size, size);
  const auto pixel = [](Complex z) {
    return kernel::Vec3{size * z.real(), size * (1 - z.imag()), 0};
  };
  for (int y = 0; y < size; y += 4)
    for (int x = 0; x < size; x += 4) {
      const double s = scalar({(x + 2.0) / size, 1 - (y + 2.0) / size});
      const auto grey = static_cast<std::uint8_t>(185 + 40 * s);
      canvas.fill_box(x, y, x + 4, y + 4, {grey, grey, grey});
    }
  for (const auto& cell : grid.cells)
    for (std::size_t i = 0; i < cell.size(); ++i)
      canvas.draw_stroke(pixel(cell[i]), pixel(cell[(i + 1) % cell.size()]), 0.7, {120, 150, 120});
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k) {
      const Complex z((i + 0.5) / 40, (k + 0.5) / 40), n = 0.008 * direction(z);
      canvas.draw_stroke(pixel(z - n), pixel(z + n), 1, {60, 60, 60});
    }
  for (const auto& [a, b] : r.segments) {
    const bool extremal = a.extremal && b.extremal;
    canvas.draw_stroke(pixel(a.place), pixel(b.place), 4,
                       extremal ? io::Rgb{215, 30, 25} : io::Rgb{40, 90, 220});
  }
  for (const Complex z : kSingular) canvas.fill_disk(pixel(z), 6, {250, 190, 0});
  io::write_canvas(path, canvas, size, size);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  std::string pictures;
  Program program(
      "Figures 1, 3 and 4: critical and extremal curves of a line field on three kinds of grids.");
  program.option("--pictures", pictures, "a folder for pictures");
  return program.run(argc, argv, [&] {
    std::vector<Cells> grids;
    for (const int n : {8, 16, 32}) grids.push_back(squares(n, false));
    for (const int n : {8, 16}) grids.push_back(squares(n, true));
    for (const int depth : {5, 6}) grids.push_back(quadtree(depth));
    fmt::print(
        "Wrong: cells that are odd without a singularity, or hold one and are even\n\n"
        "| grid | critical edges | extremal | odd cells | wrong | cells with both types | "
        "undecided edges |\n"
        "|---|---|---|---|---|---|---|\n");
    std::size_t number = 0;
    for (const Cells& grid : grids) {
      const Extracted r = extract(grid);
      fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", grid.name, r.critical, r.extremal, r.odd,
                 r.wrong, r.ends, r.undecided);
      if (!pictures.empty())
        draw(grid, r,
             (std::filesystem::path(pictures) / fmt::format("line-field-{}.png", ++number))
                 .string());
    }
    return 0;
  });
}
