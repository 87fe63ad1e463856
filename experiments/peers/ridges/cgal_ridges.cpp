// SPDX-License-Identifier: GPL-3.0-or-later
// Crest beside CGAL on one mesh in one run: time by phase, memory, and what comes out.
//
// Every measurement is a process of its own (its peak memory is its own, and a crash of one does
// not end the run); repetitions of the systems are interleaved, medians reported.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "experiments/peers/ridges/cgal_peer.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "experiments/program.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest::peers {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string mesh, json, certificate;
  int repetitions = 5, cgal_repetitions = 5;
  CgalOptions cgal;
};

long peak_rss() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

/// What work returns, from a child process; its peak memory is added. Null if the child dies.
/// Requires: no threads in this process.
Json in_child(const std::function<Json()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    close(ends[0]);
    int status = 1;
    try {
      Json result = work();
      result["peak_rss_bytes"] = peak_rss();
      const std::string text = result.dump();
      if (write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size())) status = 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    close(ends[1]);
    _exit(status);
  }
  close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0 ? Json::parse(text) : Json();
}

Json measure_cgal(const kernel::TriangleMesh& mesh, const Options& o) {
  const CgalResult r = run_cgal(mesh, o.cgal);
  const auto lines = [](const MergedLines& m) {
    return Json{{"lines", m.lines},
                {"components", m.components},
                {"loops", m.loops},
                {"unjoined_ends", m.open_ends}};
  };
  return {{"seconds",
           {{"gather", r.gather},
            {"fit", r.fit},
            {"umbilics", r.umbilics},
            {"setup", r.setup},
            {"blue", r.blue},
            {"red", r.red},
            {"crest", r.crest},
            {"total", r.total()},
            {"mesh", r.mesh}}},
          {"umbilics", {{"plus", r.plus}, {"minus", r.minus}, {"other", r.other}}},
          {"index_sum", r.index_sum()},
          {"blue", lines(r.blue_lines)},
          {"red", lines(r.red_lines)}};
}

Json measure_crest(const kernel::TriangleMesh& given, const Options& o, bool guarded,
                   std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Stopwatch watch;
  const kernel::TriangleMesh mesh(given.points(), given.faces());
  const double mesh_seconds = watch.lap();
  const ridges::FitResult fit = ridges::fit_monge_forms(mesh, {});
  const double fit_seconds = watch.lap();
  ridges::GraphOptions options;
  options.guarded = guarded;
  const ridges::CertifiedRidges result = ridges::extract_certified(mesh, fit.forms, options);
  const double extract_seconds = watch.lap();
  certify::write_file(o.certificate, result.certificate);
  CrestResult r = count(result.graph);
  r.write = watch.lap();
  r.mesh = mesh_seconds;
  r.fit = fit_seconds;
  r.extract = extract_seconds;
  const auto lines = [](const CrestResult::Ridges& c) {
    return Json{{"components", c.components()}, {"loops", c.loops}, {"segments", c.segments}};
  };
  return {{"seconds",
           {{"fit", r.fit},
            {"extract", r.extract},
            {"write", r.write},
            {"total", r.total()},
            {"mesh", r.mesh}}},
          {"certificate_bytes", result.certificate.size()},
          {"umbilics", {{"plus", r.plus}, {"minus", r.minus}, {"other", r.other}}},
          {"index_sum", r.index_sum},
          {"blue", lines(r.blue)},
          {"red", lines(r.red)},
          {"unjoined_ends", r.open_ends},
          {"conflict_triangles", r.conflict_triangles}};
}

struct System {
  std::string name;
  int repetitions;
  std::function<Json()> run;
  std::vector<Json> results;

  /// Median of one phase, seconds.
  double seconds(const std::string& phase) const {
    std::vector<double> all;
    for (const Json& r : results) all.push_back(r["seconds"][phase].get<double>());
    std::sort(all.begin(), all.end());
    const std::size_t n = all.size();
    return n % 2 ? all[n / 2] : (all[n / 2 - 1] + all[n / 2]) / 2;
  }
};

void measure(std::vector<System>& systems) {
  int rounds = 0;
  for (const System& s : systems) rounds = std::max(rounds, s.repetitions);
  for (int round = 0; round < rounds; ++round)
    for (System& s : systems) {
      if (round >= s.repetitions) continue;
      Json result = in_child(s.run);
      if (result.is_null())
        std::fprintf(stderr, "%s died\n", s.name.c_str());
      else
        s.results.push_back(std::move(result));
    }
}

void print_times(const std::vector<System>& systems, double vertices) {
  fmt::print("\n| system | runs | phase | seconds | us/vertex |\n|---|---|---|---|---|\n");
  for (const System& s : systems) {
    if (s.results.empty()) continue;
    for (const auto& [phase, unused] : s.results.front()["seconds"].items())
      fmt::print("| {} | {} | {} | {:.4f} | {:.3f} |\n", s.name, s.results.size(),
                 phase == "mesh" ? "(mesh, not in total)" : phase, s.seconds(phase),
                 1e6 * s.seconds(phase) / vertices);
  }
}

void print_answers(const std::vector<System>& systems) {
  fmt::print(
      "\n| system | umbilics +1/2, -1/2, other | index sum | blue components (loops) | red "
      "components (loops) | unjoined ends | peak RSS MB |\n|---|---|---|---|---|---|---|\n");
  for (const System& s : systems) {
    if (s.results.empty()) {
      fmt::print("| {} | died | | | | | |\n", s.name);
      continue;
    }
    const Json& r = s.results.front();
    const auto colour = [&](const char* name) {
      return fmt::format("{} ({})", r[name]["components"].get<int>(), r[name]["loops"].get<int>());
    };
    const int ends = r.contains("unjoined_ends") ? r["unjoined_ends"].get<int>()
                                                 : r["blue"]["unjoined_ends"].get<int>() +
                                                       r["red"]["unjoined_ends"].get<int>();
    fmt::print("| {} | {}, {}, {} | {} | {} | {} | {} | {:.0f} |\n", s.name,
               r["umbilics"]["plus"].get<int>(), r["umbilics"]["minus"].get<int>(),
               r["umbilics"]["other"].get<int>(), r["index_sum"].get<double>(), colour("blue"),
               colour("red"), ends, r["peak_rss_bytes"].get<double>() / 1e6);
  }
}

struct Ratio {
  std::string name;
  double value;
};
std::vector<Ratio> ratios(const std::vector<System>& systems) {
  const auto find = [&](const std::string& name) -> const System* {
    for (const System& s : systems)
      if (s.name == name && !s.results.empty()) return &s;
    return nullptr;
  };
  const System *cgal = find("CGAL"), *one = find("Crest, 1 thread"),
               *two = find("Crest, 2 threads"), *plain = find("Crest unguarded, 1 thread");
  std::vector<Ratio> list;
  const auto add = [&](const char* name, const System* a, const System* b, const char* phase_a,
                       const char* phase_b) {
    if (a && b) list.push_back({name, a->seconds(phase_a) / b->seconds(phase_b)});
  };
  add("CGAL total / Crest total (1 thread, with certificate)", cgal, one, "total", "total");
  add("CGAL fit / Crest fit (1 thread)", cgal, one, "fit", "fit");
  add("Crest total, 1 thread / 2 threads", one, two, "total", "total");
  add("Crest fit, 1 thread / 2 threads", one, two, "fit", "fit");
  add("Crest graph and certificate, 1 thread / 2 threads", one, two, "extract", "extract");
  add("Crest total, guarded / unguarded", one, plain, "total", "total");
  add("Crest graph and certificate, guarded / unguarded", one, plain, "extract", "extract");
  return list;
}

void write_json(const std::string& path, const Options& o, const kernel::TriangleMesh& mesh,
                const std::vector<System>& systems) {
  Json all{{"mesh", std::filesystem::path(o.mesh).filename().string()},
           {"vertices", mesh.vertex_count()},
           {"faces", mesh.face_count()},
           {"euler_characteristic", mesh.euler_characteristic()},
           {"cgal_umbilic_size", o.cgal.umbilic_size}};
  for (const System& s : systems) {
    Json medians;
    if (!s.results.empty())
      for (const auto& [phase, unused] : s.results.front()["seconds"].items())
        medians[phase] = s.seconds(phase);
    all["systems"].push_back({{"name", s.name}, {"median_seconds", medians}, {"runs", s.results}});
  }
  for (const Ratio& r : ratios(systems)) all["ratios"][r.name] = r.value;
  std::ofstream(path) << all.dump(2) << '\n';
}

int run(const Options& o) {
  const kernel::TriangleMesh mesh = io::read_mesh(o.mesh).mesh;
  const auto crest = [&](bool guarded, std::size_t threads) {
    return [&mesh, &o, guarded, threads] { return measure_crest(mesh, o, guarded, threads); };
  };
  std::vector<System> systems = {
      {"Crest, 1 thread", o.repetitions, crest(true, 1), {}},
      {"Crest unguarded, 1 thread", o.repetitions, crest(false, 1), {}},
      {"Crest, 2 threads", o.repetitions, crest(true, 2), {}},
      {"Crest unguarded, 2 threads", o.repetitions, crest(false, 2), {}},
      {"CGAL", o.cgal_repetitions, [&] { return measure_cgal(mesh, o); }, {}}};
  measure(systems);
  fmt::print("{}: {} vertices, {} faces, Euler characteristic {}\n",
             std::filesystem::path(o.mesh).filename().string(), mesh.vertex_count(),
             mesh.face_count(), mesh.euler_characteristic());
  print_answers(systems);
  print_times(systems, mesh.vertex_count());
  fmt::print("\n| ratio | times |\n|---|---|\n");
  for (const Ratio& r : ratios(systems)) fmt::print("| {} | {:.2f} |\n", r.name, r.value);
  if (!o.json.empty()) write_json(o.json, o, mesh, systems);
  std::filesystem::remove(o.certificate);
  return 0;
}

}  // namespace
}  // namespace crest::peers

int main(int argc, char** argv) {
  crest::peers::Options o;
  o.certificate =
      (std::filesystem::temp_directory_path() / fmt::format("cgal_ridges_{}.crest", getpid()))
          .string();
  crest::experiments::Program program("Ridges and umbilics of a mesh: Crest beside CGAL");
  program.option("MESH", o.mesh, "triangle mesh (.off)");
  program.option("--json", o.json, "also write every run to this file");
  program.option("--repetitions", o.repetitions, "of each Crest setting (default 5)");
  program.option("--cgal-repetitions", o.cgal_repetitions, "of CGAL (default 5; 0: leave it out)");
  program.option("--umbilic-size", o.cgal.umbilic_size, "CGAL's umbilic patch size (default 2)");
  return program.run(argc, argv, [&] { return crest::peers::run(o); });
}
