// SPDX-License-Identifier: GPL-3.0-or-later
// Who may include whom (CONTRIBUTING.md, "Layers"). Any other arrow fails.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

struct Include {
  std::string target;
  bool quoted;
};

std::optional<Include> parse_include(const std::string& line) {
  std::istringstream words(line);
  std::string directive, target;
  words >> directive;
  if (directive == "#") {
    words >> target;
    directive += target;
  }
  if (directive != "#include" || !(words >> target) || target.size() < 3) return std::nullopt;
  return Include{target.substr(1, target.size() - 2), target.front() == '"'};
}

/// "kernel/arithmetic", "algorithms/ridges", else the first folder.
std::string layer_of(const std::string& path) {
  const auto first = path.find('/');
  if (first == std::string::npos) return "";
  const std::string top = path.substr(0, first);
  if (top != "kernel" && top != "algorithms") return top;
  return path.substr(0, path.find('/', first + 1));
}

/// The result headers of the systems: what io writes and draws. A new system adds its own here.
const std::set<std::string>& result_headers() {
  static const std::set<std::string> headers = {
      "algorithms/curvature/curvature.hpp",
      "algorithms/curvature/focal.hpp",
      "algorithms/extremal/extremal_result.hpp",
      "algorithms/feature_lines/feature_graph.hpp",
      "algorithms/line_art/buffers.hpp",
      "algorithms/line_art/face_locator.hpp",
      "algorithms/line_art/line_art_result.hpp",
      "algorithms/line_art/stroke.hpp",
      "algorithms/line_art/view.hpp",
      "algorithms/modes/degenerate_result.hpp",
      "algorithms/modes/mode_surface.hpp",
      "algorithms/reeb/contours.hpp",
      "algorithms/reeb/reeb_graph.hpp",
      "algorithms/reeb/tile_complex.hpp",
      "algorithms/ridges/ridge_graph.hpp",
      "algorithms/smooth_ridges/smooth_ridges_result.hpp",
      "algorithms/splines/cubic_model.hpp",
      "algorithms/splines/isosurface.hpp",
      "algorithms/splines/pinhole.hpp",
      "algorithms/splines/quadratic.hpp",
      "algorithms/splines/value_and_gradient.hpp",
      "algorithms/strips/strips.hpp",
      "algorithms/vector_fields/importance.hpp",
      "algorithms/vector_fields/planar_field.hpp",
      "algorithms/vector_fields/skeleton_result.hpp",
  };
  return headers;
}

/// What a result header may not reach, lest everything that reads results is slow to compile.
bool is_heavy(const std::string& target) {
  static const std::vector<std::string> heavy = {"kernel/arithmetic/taylor",
                                                 "kernel/arithmetic/interval",
                                                 "kernel/arithmetic/rational",
                                                 "kernel/arithmetic/mp_",
                                                 "Eigen/",
                                                 "CGAL/",
                                                 "boost/multiprecision/",
                                                 "gmp",
                                                 "mpfr"};
  return std::any_of(heavy.begin(), heavy.end(),
                     [&](const std::string& prefix) { return has_prefix(target, prefix); });
}

/// What io's rooms may include of io besides themselves; the others are the systems' rooms.
std::string room_objection(const std::string& file, const std::string& target) {
  static const std::map<std::string, std::set<std::string>> rooms = {
      {"formats", {}},
      {"clean", {"formats"}},
      {"read", {"formats", "clean"}},
      {"write", {"formats"}},
      {"picture", {"formats", "write"}},
      {"page", {"formats", "write", "picture"}}};
  static const std::set<std::string> ground = {"formats", "write", "picture", "page"};
  const auto room_of = [](const std::string& path) {
    return path.substr(3, path.find('/', 3) - 3);
  };
  const std::string from = room_of(file), to = room_of(target);
  const auto room = rooms.find(from);
  const std::set<std::string>& allowed = room == rooms.end() ? ground : room->second;
  return from == to || allowed.count(to) > 0 ? "" : "io/" + from + " may not see io/" + to;
}

/// What a producer of certificates needs of certify/.
bool is_producers_header(const std::string& target) {
  return target == "certify/certificate.hpp" || target == "certify/smooth_witness/record.hpp" ||
         (has_prefix(target, "certify/") &&
          (has_suffix(target, "/records.hpp") || has_suffix(target, "/encode.hpp")));
}

/// A claim's room of certify/, or empty.
std::string claim_of(const std::string& path) {
  if (layer_of(path) != "certify") return "";
  const std::size_t slash = path.find('/', 8);
  if (slash == std::string::npos) return "";
  const std::string room = path.substr(8, slash - 8);
  return room == "container" || room == "exact" || room == "surface" ? "" : room;
}

/// Prefixes of what each layer may include besides itself.
const std::map<std::string, std::vector<std::string>>& arrows() {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"kernel/arithmetic", {}},
      {"kernel/polynomial", {"kernel/arithmetic/"}},
      {"kernel/predicates", {"kernel/arithmetic/", "kernel/polynomial/"}},
      {"kernel/expressions", {"kernel/arithmetic/", "kernel/polynomial/", "kernel/predicates/"}},
      {"kernel/geometry", {"kernel/arithmetic/", "kernel/polynomial/", "kernel/predicates/"}},
      {"certify", {"kernel/arithmetic/", "kernel/expressions/"}},
      {"io", {"kernel/"}},
      {"cli", {"kernel/", "certify/", "io/", "algorithms/"}},
      {"bindings", {"kernel/", "certify/", "io/", "algorithms/"}},
      {"distributed", {"kernel/", "certify/", "io/", "algorithms/", "cli/"}},
      {"experiments", {"kernel/", "certify/", "io/", "algorithms/"}},
      {"tests", {"kernel/", "certify/", "io/", "algorithms/", "cli/"}},
  };
  return table;
}

/// An empty string, or why `file` may not include `target`.
std::string objection(const std::string& file, const std::string& target) {
  const std::string from = layer_of(file), to = layer_of(target);
  const bool in_second = has_prefix(file, "certify/second/");
  if (in_second != has_prefix(target, "certify/second/") && (in_second || from != "tests"))
    return "the second checker shares nothing with the project";
  if (file == "cli/crest_verify.cpp" || has_prefix(file, "cli/input_mesh.") ||
      has_prefix(file, "cli/verify_page/")) {
    const bool own = target == "cli/input_mesh.hpp" || (has_prefix(file, "cli/verify_page/") &&
                                                        has_prefix(target, "cli/verify_page/"));
    return own || to == "certify" || has_prefix(to, "kernel/") ? ""
                                                               : "sees certify and kernel only";
  }
  if (from == "io" && to == "io") return room_objection(file, target);
  // The room of claim 4's witnesses searches with the checker's enclosures; claim 10 compares what
  // claim 9 has proven of two fields.
  const bool guest = (claim_of(file) == "smooth_witness" && claim_of(target) == "ridges_smooth") ||
                     (claim_of(file) == "compression" && claim_of(target) == "skeleton");
  if (from == "certify" && !claim_of(target).empty() && claim_of(target) != claim_of(file) &&
      !guest)
    return "only a claim's own room sees it";
  if (from == to) return "";
  if (has_prefix(from, "algorithms/")) {
    if (has_prefix(to, "kernel/") || is_producers_header(target)) return "";
    return "systems see kernel, themselves and certify/*/encode.hpp and records.hpp";
  }
  const bool ground = has_prefix(file, "io/picture/") || has_prefix(file, "io/write/") ||
                      has_prefix(file, "io/formats/") || has_prefix(file, "io/clean/") ||
                      has_prefix(file, "io/read/") || has_prefix(file, "io/page/");
  if (from == "io" && !ground && result_headers().count(target) > 0) return "";
  const auto allowed = arrows().find(from);
  if (allowed == arrows().end()) return "is in no known layer";
  for (const std::string& prefix : allowed->second)
    if (has_prefix(target, prefix)) return "";
  return from + " may not see " + to;
}

/// Libraries that only one folder (and the tests and measurements of it) may know.
std::string foreign_objection(const std::string& file, const std::string& target) {
  const std::string layer = layer_of(file);
  const bool outer = layer == "tests" || layer == "experiments";
  if (target == "vtk_diy2.h" || target == "mpi.h" || target == "VTK_DIY2")
    return layer == "distributed" ? "" : "only distributed knows MPI and DIY";
  if (has_prefix(target, "vtk") && layer != "io" && !outer) return "only io knows VTK";
  if (has_prefix(target, "pybind11/") && file != "bindings/python/module.cpp")
    return "only the module's own source knows Python";
  if (has_prefix(target, "CLI/") && layer != "cli" && !outer) return "only cli knows CLI11";
  if (has_prefix(target, "nlohmann/") && layer != "cli" && file != "io/read/wind_json.cpp" &&
      file != "io/line_art/sidecar.cpp" && file != "io/page/page.cpp" && !outer)
    return "only cli writes JSON";
  return "";
}

}  // namespace

TEST_CASE("every include follows the layers' arrows") {
  std::size_t includes = 0;
  for (const std::string& file : project_files()) {
    if (!is_cpp(file)) continue;
    std::size_t number = 0;
    for (const std::string& line : lines_of(file)) {
      ++number;
      const auto include = parse_include(line);
      if (!include) continue;
      INFO(file << ":" << number << ": " << line);
      if (has_prefix(file, "examples/") && include->quoted) {
        // As users see them, once they are installed.
        CHECK(has_prefix(include->target, "crest/"));
        CHECK(fs::exists(fs::path(CREST_SOURCE_DIR) / include->target.substr(6)));
        continue;
      }
      const bool own = fs::exists(fs::path(CREST_SOURCE_DIR) / include->target) ||
                       include->target == "cli/version.hpp";
      if (include->quoted) {
        CHECK(own);
        CHECK(objection(file, include->target) == "");
        ++includes;
      } else {
        CHECK_FALSE(own);
        CHECK(foreign_objection(file, include->target) == "");
      }
    }
  }
  CHECK(includes > 50);
}

TEST_CASE("the result headers of the systems are light") {
  for (const std::string& header : result_headers()) {
    INFO(header);
    REQUIRE(fs::exists(fs::path(CREST_SOURCE_DIR) / header));
    std::set<std::string> seen = {header};
    std::vector<std::string> left = {header};
    while (!left.empty()) {
      const std::string file = left.back();
      left.pop_back();
      for (const std::string& line : lines_of(file)) {
        const auto include = parse_include(line);
        if (!include || !seen.insert(include->target).second) continue;
        INFO(file << " includes " << include->target);
        CHECK_FALSE(is_heavy(include->target));
        if (include->quoted) left.push_back(include->target);
      }
    }
  }
  for (const char* target :
       {"kernel/arithmetic/taylor_model.hpp", "kernel/arithmetic/rational.hpp", "Eigen/Dense",
        "CGAL/Interval_nt.h", "gmp.h", "gmpxx.h", "mpfr.h", "boost/multiprecision/gmp.hpp"})
    CHECK(is_heavy(target));
  CHECK_FALSE(is_heavy("kernel/arithmetic/vec3.hpp"));
}

TEST_CASE("the include rules refuse the arrows that design forbids") {
  CHECK(objection("kernel/arithmetic/a.hpp", "kernel/predicates/b.hpp") != "");
  CHECK(objection("kernel/polynomial/a.hpp", "kernel/predicates/b.hpp") != "");
  CHECK(objection("kernel/predicates/a.hpp", "kernel/geometry/b.hpp") != "");
  CHECK(objection("kernel/geometry/a.hpp", "certify/certificate.hpp") != "");
  CHECK(objection("certify/a.cpp", "kernel/geometry/b.hpp") != "");
  CHECK(objection("certify/a.cpp", "kernel/predicates/b.hpp") != "");
  CHECK(objection("certify/a.cpp", "kernel/polynomial/b.hpp") != "");
  CHECK(objection("certify/a.cpp", "algorithms/ridges/ridges.hpp") != "");
  CHECK(objection("algorithms/ridges/a.cpp", "algorithms/sampling/b.hpp") != "");
  CHECK(objection("algorithms/ridges/a.cpp", "certify/verify.hpp") != "");
  CHECK(objection("algorithms/ridges/a.cpp", "certify/ridges_mesh/signs.hpp") != "");
  CHECK(objection("certify/reeb/a.cpp", "certify/ridges_mesh/records.hpp") != "");
  CHECK(objection("certify/surface/a.cpp", "certify/ridges_mesh/records.hpp") != "");
  CHECK(objection("certify/a.hpp", "certify/reeb/records.hpp") != "");
  CHECK(objection("certify/ridges_smooth/a.cpp", "certify/smooth_witness/record.hpp") != "");
  CHECK(objection("algorithms/smooth_ridges/a.cpp", "certify/smooth_witness/parts.hpp") != "");
  CHECK(objection("certify/skeleton/a.cpp", "certify/compression/records.hpp") != "");
  CHECK(objection("certify/compression/a.cpp", "certify/modes/surface.hpp") != "");
  CHECK(objection("algorithms/ridges/a.cpp", "io/read/mesh_reader.hpp") != "");
  CHECK(objection("io/ridges/a.cpp", "algorithms/ridges/jet_fit.hpp") != "");
  CHECK(objection("io/ridges/a.cpp", "algorithms/smooth_ridges/smooth_ridges.hpp") != "");
  CHECK(objection("io/ridges/a.cpp", "certify/certificate.hpp") != "");
  CHECK(objection("io/ridges/a.cpp", "io/reeb/graph_layout.hpp") != "");
  CHECK(objection("io/picture/a.cpp", "algorithms/ridges/ridge_graph.hpp") != "");
  CHECK(objection("io/picture/a.cpp", "io/ridges/ridge_drawing.hpp") != "");
  CHECK(objection("io/page/a.cpp", "algorithms/ridges/ridge_graph.hpp") != "");
  CHECK(objection("io/picture/a.cpp", "io/page/scene.hpp") != "");
  CHECK(objection("io/formats/a.cpp", "io/read/mesh_reader.hpp") != "");
  CHECK(objection("cli/crest_verify.cpp", "io/read/mesh_reader.hpp") != "");
  CHECK(objection("cli/input_mesh.cpp", "io/read/mesh_reader.hpp") != "");
  CHECK(objection("io/clean/a.cpp", "io/read/mesh_reader.hpp") != "");
  CHECK(objection("io/ridges/a.cpp", "io/clean/surface.hpp") != "");
  CHECK(objection("certify/second/a.cpp", "kernel/arithmetic/b.hpp") != "");
  CHECK(objection("certify/second/a.cpp", "certify/certificate.hpp") != "");
  CHECK(objection("certify/reeb/a.cpp", "certify/second/b.hpp") != "");
  CHECK(objection("cli/crest_verify.cpp", "certify/second/b.hpp") != "");
  CHECK(objection("certify/second/a.cpp", "certify/second/b.hpp") == "");
  CHECK(objection("tests/recheck/a.cpp", "certify/second/b.hpp") == "");
  CHECK(objection("experiments/a/b.cpp", "cli/report.hpp") != "");
  CHECK(objection("io/ridges/a.cpp", "algorithms/ridges/ridge_graph.hpp") == "");
  CHECK(objection("io/ridges/a.cpp", "io/picture/drawing.hpp") == "");
  CHECK(objection("algorithms/ridges/a.cpp", "certify/ridges_mesh/encode.hpp") == "");
  CHECK(objection("certify/reeb/a.cpp", "certify/reeb/b.hpp") == "");
  CHECK(objection("certify/smooth_witness/a.cpp", "certify/ridges_smooth/patch.hpp") == "");
  CHECK(objection("algorithms/smooth_ridges/a.cpp", "certify/smooth_witness/record.hpp") == "");
  CHECK(objection("certify/reeb/a.cpp", "certify/surface/b.hpp") == "");
  CHECK(objection("certify/compression/a.cpp", "certify/skeleton/proof.hpp") == "");
  CHECK(foreign_objection("kernel/geometry/a.cpp", "vtkPolyData.h") != "");
  CHECK(foreign_objection("io/a.cpp", "vtkPolyData.h") == "");
  CHECK(objection("bindings/python/a.cpp", "cli/run.hpp") != "");
  CHECK(foreign_objection("bindings/python/a.cpp", "pybind11/numpy.h") != "");
}

TEST_CASE("include lines are recognised in every spelling") {
  CHECK(parse_include("#include \"a/b.hpp\"")->target == "a/b.hpp");
  CHECK(parse_include("  #  include <vector>  // why")->target == "vector");
  CHECK_FALSE(parse_include("// #include \"a/b.hpp\""));
}
