// SPDX-License-Identifier: GPL-3.0-or-later
// Salient ridges against the noise-free graph, on surfaces without ridges, and on scans.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <numbers>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "experiments/002-ridges/line_match.hpp"
#include "experiments/002-ridges/remeshed.hpp"
#include "experiments/program.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/ridges/ridge_picture.hpp"

namespace crest {
namespace {

namespace fs = std::filesystem;
using experiments::dashes;
using experiments::near_share;

struct Options {
  std::string table = "noise";
  fs::path data = "../shared/data/meshes", pictures;
  std::string part = "fandisk.off";
  std::vector<double> percent = {0, 0.1, 0.3, 1, 3};
  std::vector<std::string> surfaces = {"ellipsoid", "blend"};
  std::vector<std::string> meshes = {"max-planck_decimated.obj", "rocker-arm.obj", "armadillo.off",
                                     "stanford-bunny.obj", "horse.ply"};
  std::vector<int> points;
  int vertices = 0;
  int seeds = 1;
  double z = 4, weight = 1.5;
  ridges::SalienceOptions salience() const { return {z, weight}; }
};

struct Marked {
  ridges::RidgeGraph graph;
  ridges::SalienceReport report;
  double fit = 0, extract = 0, mark = 0;
  double radius = 0;  ///< of the supports, on average
};

Marked marked(const kernel::TriangleMesh& mesh, int points, const ridges::SalienceOptions& o) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point a, Clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
  };
  ridges::FitOptions options;
  options.min_points = points;
  options.errors = true;
  const auto t0 = Clock::now();
  const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
  const auto t1 = Clock::now();
  Marked m{ridges::extract_ridge_graph(mesh, fit.forms), {}};
  const auto t2 = Clock::now();
  m.report = ridges::mark_salience(mesh, fit, m.graph, o);
  for (const ridges::CurvatureError& e : fit.errors)
    m.radius += e.radius / static_cast<double>(fit.errors.size());
  m.fit = seconds(t0, t1);
  m.extract = seconds(t1, t2);
  m.mark = seconds(t2, Clock::now());
  return m;
}

kernel::TriangleMesh noisy(const sampling::SurfaceSample& clean, double percent, int seed) {
  std::vector<sampling::Vec3> points = clean.points;
  const double edge = sampling::mean_edge_length(clean.points, clean.faces);
  if (percent > 0)
    sampling::add_normal_noise(points, sampling::normals(clean), percent / 100 * edge,
                               static_cast<std::uint64_t>(seed));
  return {std::move(points), clean.faces};
}

/// "+1/2: 4, -1/2: 2, others: 1, of index 0: 12"
std::string regions_text(const std::vector<ridges::UmbilicRegion>& regions) {
  int plus = 0, minus = 0, other = 0, zero = 0;
  for (const ridges::UmbilicRegion& r : regions)
    ++(r.twice_index == 0 ? zero : !r.is_umbilic() ? other : r.twice_index > 0 ? plus : minus);
  return fmt::format("{}, {}, {} ({})", plus, minus, other, zero);
}

/// How many regions are one umbilic of index +1/2, of -1/2.
std::pair<int, int> signs_of(const std::vector<ridges::UmbilicRegion>& regions) {
  std::pair<int, int> signs(0, 0);
  for (const ridges::UmbilicRegion& r : regions)
    if (r.is_umbilic()) ++(r.twice_index > 0 ? signs.first : signs.second);
  return signs;
}

int vertices_of(const std::string& surface, const Options& o) {
  return o.vertices > 0 ? o.vertices : surface == "blend" ? 40000 : 10000;
}

int chosen(const kernel::TriangleMesh& mesh, const Options& o, std::size_t i) {
  if (i < o.points.size()) return o.points[i];
  return ridges::choose_support(mesh, {}, {}, o.salience()).points;
}

/// What a table says of one noisy mesh, and of a level's meshes on average.
struct Shares {
  double significant[2], salient[2];  ///< precision and recall
  bool umbilics;                      ///< the regions of index +-1/2 are those without noise
};

Shares noise_row(const std::string& surface, const sampling::SurfaceSample& clean,
                 const Marked& truth, double percent, int seed, std::size_t which,
                 const Options& o) {
  const kernel::TriangleMesh mesh = noisy(clean, percent, seed);
  const int points = chosen(mesh, o, which);
  const Marked m = marked(mesh, points, o.salience());
  const double size = m.graph.model_size, near = 0.06 * size;
  const auto whole = dashes(truth.graph, 0), salient = dashes(truth.graph, 2);
  const auto got1 = dashes(m.graph, 1), got2 = dashes(m.graph, 2);
  const Shares shares = {{near_share(got1, whole, near), near_share(whole, got1, near)},
                         {near_share(got2, salient, near), near_share(salient, got2, near)},
                         signs_of(m.report.regions) == signs_of(truth.report.regions)};
  fmt::print(
      "| {} | {} | {} | {} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.2f} | {:.3f} | {:.3f} | {} | "
      "{} |\n",
      surface, percent, seed, points, m.report.length / size, length_of(got1) / size,
      shares.significant[0], shares.significant[1], length_of(got2) / size, shares.salient[0],
      shares.salient[1], regions_text(m.report.regions), 0.5 * m.graph.twice_index_sum);
  std::fflush(stdout);
  return shares;
}

void print_level(const std::string& surface, double percent, const std::vector<Shares>& rows) {
  if (rows.size() < 2) return;
  const auto text = [&](auto&& value) {
    double sum = 0, least = 1, most = 0;
    for (const Shares& s : rows) {
      sum += value(s);
      least = std::min(least, value(s));
      most = std::max(most, value(s));
    }
    return fmt::format("{:.3f} ({:.3f} to {:.3f})", sum / static_cast<double>(rows.size()), least,
                       most);
  };
  std::size_t right = 0;
  for (const Shares& s : rows) right += s.umbilics;
  fmt::print(
      "| {} | {} | mean (least to most) of {} | | | | {} | {} | | {} | {} | right in {} | |\n",
      surface, percent, rows.size(), text([](const Shares& s) { return s.significant[0]; }),
      text([](const Shares& s) { return s.significant[1]; }),
      text([](const Shares& s) { return s.salient[0]; }),
      text([](const Shares& s) { return s.salient[1]; }), right);
  std::fflush(stdout);
}

void noise_table(const Options& o) {
  fmt::print(
      "| surface | noise % | seed | points | graph | significant | precision | recall | salient | "
      "precision "
      "| recall | regions +1/2, -1/2, other (0) | index sum "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& surface : o.surfaces) {
    const std::vector<double> parameters =
        surface == "ellipsoid" ? std::vector<double>{1, 1.5, 2} : std::vector<double>{};
    const sampling::SurfaceSample clean =
        sampling::sample(surface, parameters, vertices_of(surface, o), true);
    const Marked truth = marked(noisy(clean, 0, 1), 30, o.salience());
    for (const double percent : o.percent)
      for (std::size_t i = 0; i < std::max<std::size_t>(o.points.size(), 1); ++i) {
        std::vector<Shares> rows;
        for (int seed = 1; seed <= (percent == 0 ? 1 : o.seeds); ++seed)
          rows.push_back(noise_row(surface, clean, truth, percent, seed, i, o));
        print_level(surface, percent, rows);
      }
  }
}

void print_marked(const std::string& name, int points, const Marked& m) {
  const auto& r = m.report;
  const double size = m.graph.model_size;
  fmt::print(
      "| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {} | {}, {}, {}, {}, {}, {} | {} | {} | {} "
      "| {:.2f} {:.2f} {:.2f} |\n",
      name, points, r.length / size, r.length_significant / size, r.length_unweighted / size,
      r.length_salient / size, m.graph.ridges.size(), r.significant, r.salient, r.insignificant,
      r.short_runs, r.not_crest, r.light, m.graph.umbilics.size(), regions_text(r.regions),
      0.5 * m.graph.twice_index_sum, m.fit, m.extract, m.mark);
  std::fflush(stdout);
}

void print_head() {
  fmt::print(
      "| model | points | graph | significant | salient, W >= 0 | salient | ridges | significant, "
      "salient, insignificant, short, not crest, light | umbilics | regions +1/2, -1/2, other (0) "
      "| "
      "index sum | fit, extract, mark s |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void samples_table(const Options& o) {
  print_head();
  for (const std::string& surface : o.surfaces) {
    // name or name:1,2,3
    const std::size_t colon = surface.find(':');
    std::vector<double> parameters;
    for (std::size_t at = colon; at != std::string::npos && at < surface.size();) {
      parameters.push_back(std::stod(surface.substr(at + 1)));
      at = surface.find('/', at + 1);
    }
    const std::string name = surface.substr(0, colon);
    const sampling::SurfaceSample clean =
        sampling::sample(name, parameters, vertices_of(name, o), true);
    for (const double percent : o.percent)
      for (int seed = 1; seed <= (percent == 0 ? 1 : o.seeds); ++seed) {
        const kernel::TriangleMesh mesh = noisy(clean, percent, seed);
        for (const int points : o.points.empty() ? std::vector<int>{chosen(mesh, o, 0)} : o.points)
          print_marked(fmt::format("{}, {} %", surface, percent), points,
                       marked(mesh, points, o.salience()));
      }
  }
}

/// What `crest ridges --picture` draws, smaller.
void draw(const Options& o, const std::string& file, const kernel::TriangleMesh& mesh, Marked m) {
  if (o.pictures.empty()) return;
  fs::create_directories(o.pictures);
  ridges::FilterOptions significant;
  significant.min_level = 1;
  ridges::filter(m.graph, significant);
  io::PictureOptions options;
  options.width = 800;
  options.by_salience = true;
  options.note = "subset by significance";
  options.spur = m.radius;
  const std::string name = "salience-" + fs::path(file).stem().string() + ".png";
  io::write_picture((o.pictures / name).string(), mesh, m.graph, options);
}

void scans_table(const Options& o) {
  print_head();
  for (const std::string& file : o.meshes) {
    const fs::path path = o.data / file;
    if (!fs::exists(path)) {
      std::cerr << path.string() << ": not there (see --data): skipped\n";
      continue;
    }
    const kernel::TriangleMesh mesh = io::read_mesh(path.string()).mesh;
    for (const int points : o.points.empty() ? std::vector<int>{chosen(mesh, o, 0)} : o.points) {
      const Marked m = marked(mesh, points, o.salience());
      print_marked(file, points, m);
      draw(o, file, mesh, m);
    }
  }
}

/// Crest pieces in the order of falling sharpness, up to a length; levels are set to 2.
ridges::RidgeGraph sharpest(ridges::RidgeGraph graph, double length) {
  ridges::FilterOptions crest;
  crest.crest_only = true;
  ridges::filter(graph, crest);
  std::stable_sort(graph.ridges.begin(), graph.ridges.end(),
                   [](const auto& a, const auto& b) { return a.sharpness > b.sharpness; });
  double sum = 0;
  for (ridges::Ridge& r : graph.ridges) {
    for (ridges::Crossing& c : r.crossings) c.level = sum < length ? 2 : 0;
    sum += r.length;
  }
  return graph;
}

/// Both ways, within 2 % of the model size of the first.
double agreement(const ridges::RidgeGraph& a, const ridges::RidgeGraph& b) {
  const double near = 0.02 * a.model_size;
  const auto p = dashes(a, 2, near / 8), q = dashes(b, 2, near / 8);
  return (near_share(p, q, near) + near_share(q, p, near)) / 2;
}

/// A row: salient lines of two meshes of one scan against each other, each on its own support,
/// beside the sharpest crest lines of the same length.
void repeat_row(const std::string& file, const std::string& change,
                const std::array<kernel::TriangleMesh, 2>& meshes, const Options& o) {
  const int points[2] = {chosen(meshes[0], o, 0), chosen(meshes[1], o, 0)};
  const Marked a = marked(meshes[0], points[0], o.salience());
  const Marked b = marked(meshes[1], points[1], o.salience());
  const double size = a.graph.model_size;
  const auto sharp = [](const Marked& m) { return sharpest(m.graph, m.report.length_salient); };
  fmt::print("| {} | {} | {}, {} | {:.2f}, {:.2f} | {:.3f} | {:.3f} |\n", file, change, points[0],
             points[1], a.report.length_salient / size, b.report.length_salient / size,
             agreement(a.graph, b.graph), agreement(sharp(a), sharp(b)));
  std::fflush(stdout);
}

/// Isotropic noise of 5 % of the mean edge.
kernel::TriangleMesh scan_with_noise(const kernel::TriangleMesh& mesh, int seed) {
  std::vector<sampling::Vec3> moved = mesh.points();
  const double edge = sampling::mean_edge_length(mesh.points(), mesh.faces());
  sampling::add_normal_noise(moved, {}, 0.05 * edge, static_cast<std::uint64_t>(seed));
  return {std::move(moved), mesh.faces()};
}

/// Two noisy copies of a scan; a scan and itself halved, remeshed.
void repeat_table(const Options& o) {
  fmt::print(
      "| scan | change | points | salient length | agreement, salience | sharpness at equal length "
      "|\n|---|---|---|---|---|---|\n");
  for (const std::string& file : o.meshes) {
    const fs::path path = o.data / file;
    if (!fs::exists(path)) continue;
    const kernel::TriangleMesh mesh = io::read_mesh(path.string()).mesh;
    for (int seed = 1; seed < 2 * o.seeds; seed += 2)
      repeat_row(file, fmt::format("5 % noise, seeds {}, {}", seed, seed + 1),
                 {scan_with_noise(mesh, seed), scan_with_noise(mesh, seed + 1)}, o);
    repeat_row(file, "half the edges", {mesh, experiments::decimated(mesh)}, o);
    repeat_row(file, "remeshed", {mesh, experiments::remeshed(mesh)}, o);
  }
}

/// The edges of dihedral angle over the given degrees, in dashes.
std::vector<experiments::Dash> sharp_edges(const kernel::TriangleMesh& mesh, double degrees,
                                           double step) {
  const double cosine = std::cos(degrees * std::numbers::pi / 180);
  const auto normal = [&](kernel::Index f) {
    const auto [a, b, c] = mesh.faces()[f];
    const auto& p = mesh.points();
    const kernel::Vec3 n =
        kernel::cross(kernel::operator-(p[b], p[a]), kernel::operator-(p[c], p[a]));
    return kernel::operator*(1 / kernel::norm(n), n);
  };
  std::vector<experiments::Dash> all;
  for (const kernel::Edge& e : mesh.edges()) {
    if (e.f0 == kernel::kNone || e.f1 == kernel::kNone) continue;
    if (kernel::dot(normal(e.f0), normal(e.f1)) > cosine) continue;
    experiments::add_dashes(mesh.points()[e.v0], mesh.points()[e.v1], ridges::Colour::blue, step,
                            all);
  }
  return all;
}

/// A part, fandisk: how much of the edges over 40 degrees has a line within 1, 1.5, 2 mean edges,
/// how much of the lines has no feature, an edge over 15 degrees, within two.
void fandisk_table(const Options& o) {
  const fs::path path = o.data / o.part;
  if (!fs::exists(path)) return;
  const kernel::TriangleMesh mesh = io::read_mesh(path.string()).mesh;
  const double edge = sampling::mean_edge_length(mesh.points(), mesh.faces());
  const auto sharp = sharp_edges(mesh, 40, edge / 4), features = sharp_edges(mesh, 15, edge / 4);
  fmt::print(
      "| points | lines | length / size | sharp length covered within 1 | 1.5 | 2 edges | off any "
      "feature |\n|---|---|---|---|---|---|---|\n");
  for (const int points : o.points.empty() ? std::vector<int>{chosen(mesh, o, 0)} : o.points) {
    const Marked m = marked(mesh, points, o.salience());
    const auto row = [&](const char* name, const std::vector<experiments::Dash>& lines) {
      fmt::print("| {} | {} | {:.2f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", points, name,
                 length_of(lines) / m.graph.model_size, near_share(sharp, lines, edge, true),
                 near_share(sharp, lines, 1.5 * edge, true),
                 near_share(sharp, lines, 2 * edge, true),
                 1 - near_share(lines, features, 2 * edge, true));
    };
    const char* names[] = {"graph", "significant", "salient"};
    for (const int level : {0, 1, 2}) row(names[level], dashes(m.graph, level, edge / 4));
    for (const int level : {0, 1, 2})
      row(fmt::format("{}, with ends in patches", names[level]).c_str(),
          experiments::dashes_with_ends(m.graph, level, edge / 4));
    row("sharpest at the salient length",
        dashes(sharpest(m.graph, m.report.length_salient), 2, edge / 4));
  }
}

/// Processor time of the fit and the extraction alone, and with the errors and the salience: five
/// rounds in turns, medians; the quotient is that of each round.
void cost_table(const Options& o) {
  fmt::print(
      "| model | points | fit | extraction | fit with errors | salience | quotient (least to most) "
      "|\n|---|---|---|---|---|---|---|\n");
  const auto seconds = [](auto&& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  for (const std::string& file : o.meshes) {
    const fs::path path = o.data / file;
    if (!fs::exists(path)) continue;
    const kernel::TriangleMesh mesh = io::read_mesh(path.string()).mesh;
    for (const int points : o.points.empty() ? std::vector<int>{30, 100} : o.points) {
      std::array<std::vector<double>, 5> rounds;
      ridges::FitResult fit;
      ridges::RidgeGraph graph;
      ridges::FitOptions options;
      options.min_points = points;
      for (int i = 0; i < 5; ++i) {
        options.errors = false;
        const double plain = seconds([&] { fit = ridges::fit_monge_forms(mesh, options); });
        const double extract =
            seconds([&] { graph = ridges::extract_ridge_graph(mesh, fit.forms); });
        options.errors = true;
        const double full = seconds([&] { fit = ridges::fit_monge_forms(mesh, options); });
        const double again = seconds([&] { graph = ridges::extract_ridge_graph(mesh, fit.forms); });
        const double mark = seconds([&] { ridges::mark_salience(mesh, fit, graph, o.salience()); });
        const double quotient = (full + again + mark) / (plain + extract);
        for (std::size_t k = 0; const double x : {plain, extract, full, mark, quotient})
          rounds[k++].push_back(x);
      }
      for (std::vector<double>& r : rounds) std::sort(r.begin(), r.end());
      fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} ({:.2f} to {:.2f}) |\n",
                 file, points, rounds[0][2], rounds[1][2], rounds[2][2], rounds[3][2], rounds[4][2],
                 rounds[4].front(), rounds[4].back());
      std::fflush(stdout);
    }
  }
}

int run(const Options& o) {
  if (o.table == "cost") cost_table(o);
  if (o.table == "repeat") repeat_table(o);
  if (o.table == "fandisk") fandisk_table(o);
  if (o.table == "noise") noise_table(o);
  if (o.table == "samples") samples_table(o);
  if (o.table == "scans") scans_table(o);
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("Salient ridges of samples and scans");
  program.option("--table", o.table, "what to print",
                 {"noise", "samples", "scans", "repeat", "fandisk", "cost"});
  program.option("--data", o.data, "folder of meshes");
  program.option("--pictures", o.pictures, "folder for pictures of the scans (default: none)");
  program.list("--noise", o.percent, "percents of the mean edge length");
  program.option("--part", o.part, "mesh of the table fandisk");
  program.option("--surfaces", o.surfaces, "samples, NAME or NAME:P/P/P");
  program.option("--meshes", o.meshes, "scans");
  program.list("--points", o.points, "supports (default: chosen)");
  program.option("--vertices", o.vertices, "of a sample");
  program.option("--seeds", o.seeds, "noisy meshes a level");
  program.option("--significance", o.z, "Z");
  program.option("--min-weight", o.weight, "W");
  return program.run(argc, argv, [&] { return crest::run(o); });
}
