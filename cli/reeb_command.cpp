// SPDX-License-Identifier: GPL-3.0-or-later
// crest reeb: the Reeb graph of a function linear or quadratic on each face (paper 003).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/contour_tree.hpp"
#include "algorithms/reeb/contours.hpp"
#include "algorithms/reeb/labelled_graph.hpp"
#include "algorithms/reeb/merge_trees.hpp"
#include "algorithms/reeb/persistence.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "certify/certificate.hpp"
#include "cli/reeb_report.hpp"
#include "cli/run.hpp"
#include "io/page/scene.hpp"
#include "io/read/quadratic_reader.hpp"
#include "io/reeb/reeb_picture.hpp"
#include "io/reeb/reeb_writer.hpp"

namespace crest::cli {
namespace {

using kernel::Index;

struct ReebOptions {
  CommonOptions common;
  std::string field, expression;
  bool linear = false, segmentation = false;
  bool contract = false, cancel_loops = false;
  double persistence = 0;
  CLI::Option* persistence_given = nullptr;
  bool join_tree = false, split_tree = false, contour_tree = false;
  std::vector<double> levels;
};

void add_reeb_options(CLI::App& app, ReebOptions& o) {
  auto* field =
      app.add_option("--field", o.field, "scalar field of the file (default: its only one)");
  field->type_name("NAME");
  app.add_option("--expression", o.expression,
                 "function of x, y, z instead of a field, sampled at vertices and, unless it is "
                 "linear, edge midpoints")
      ->type_name("E")
      ->excludes(field);
  app.add_flag("--linear", o.linear, "linear on each face: ignore the midpoints");
  app.add_flag("--contract", o.contract,
               "the graph of the function itself: contract arcs between equal values");
  o.persistence_given = app.add_option("--persistence", o.persistence,
                                       "cancel leaves up to this difference of values");
  o.persistence_given->type_name("P");
  app.add_flag("--cancel-loops", o.cancel_loops, "with --persistence: small loops, too")
      ->needs(o.persistence_given);
  app.add_flag("--join-tree", o.join_tree, "also how the parts below a level merge");
  app.add_flag("--split-tree", o.split_tree, "also how the parts above a level merge");
  app.add_flag("--contour-tree", o.contour_tree,
               "also the contour tree, by merging these two; refused where loops are possible");
  app.add_option("--level", o.levels, "level lines at C, too (repeatable)")
      ->type_name("C")
      ->allow_extra_args(false);
  app.add_flag("--segmentation", o.segmentation,
               "with -o: the monotone tiles with the arc each belongs to");
}

io::FunctionSource function_source(const ReebOptions& o) {
  io::FunctionSource source{o.field, {}, o.linear, o.common.clean, o.common.step};
  if (o.expression.empty()) return source;
  try {
    source.expression = kernel::Expression::parse(o.expression, {"x", "y", "z"});
  } catch (const kernel::ExpressionError& error) {
    throw UsageError(std::string("--expression: ") + error.what());
  }
  return source;
}

std::vector<io::LevelLines> level_lines(const kernel::QuadraticMesh& mesh,
                                        const reeb::TileComplex& tiles,
                                        const std::vector<double>& levels) {
  std::vector<io::LevelLines> lines;
  for (const double level : levels) lines.push_back({level, reeb::contours(mesh, tiles, level)});
  return lines;
}

io::TreeLines contour_tree_lines(const std::string& input, const reeb::OrderedComplex& complex) {
  try {
    return {io::kContourTreeKind, reeb::arcs_of(reeb::contour_tree(complex))};
  } catch (const std::invalid_argument&) {
    throw kernel::InputError(
        input +
        ": surface: is not simply connected, there need not be a contour tree; leave out "
        "--contour-tree, the Reeb graph serves all surfaces");
  }
}

std::vector<io::TreeLines> trees_of(const ReebOptions& o, const reeb::TileComplex& tiles,
                                    const reeb::ReebGraph& graph) {
  std::vector<io::TreeLines> trees;
  if (o.join_tree) {
    const reeb::MergeTree tree = reeb::reduced(reeb::augmented_join_tree(graph));
    trees.push_back({io::kJoinTreeKind, reeb::arcs_of(graph, tree)});
  }
  if (o.split_tree) {
    const reeb::MergeTree tree = reeb::reduced(reeb::augmented_split_tree(graph));
    trees.push_back({io::kSplitTreeKind, reeb::arcs_of(graph, tree)});
  }
  if (o.contour_tree) trees.push_back(contour_tree_lines(o.common.input, reeb::ordered(tiles)));
  return trees;
}

/// The graph that is written, labelled where something is drawn.
struct WrittenGraph : reeb::LabelledGraph {
  bool changed = false;                    ///< asked to be
  std::vector<std::string> simplified_by;  ///< the options that took something away
};

reeb::Simplification simplification_of(const ReebOptions& o) {
  reeb::Simplification wanted{o.contract, {}, o.cancel_loops};
  if (o.persistence_given->count() > 0) wanted.persistence = o.persistence;
  return wanted;
}

void simplify(const reeb::Simplification& wanted, const reeb::TileComplex& tiles,
              const std::vector<reeb::NodePlace>& places, WrittenGraph& w) {
  std::vector<double> values;
  for (const reeb::NodePlace& place : places) values.push_back(place.value);
  const reeb::Simplified done = reeb::simplify(tiles, values, wanted, w);
  w.changed = true;
  if (done.contract) w.simplified_by.push_back("--contract");
  if (done.persistence) w.simplified_by.push_back("--persistence");
  if (done.cancel_loops) w.simplified_by.push_back("--cancel-loops");
}

std::vector<LevelCount> count_lines(const std::vector<io::LevelLines>& lines) {
  std::vector<LevelCount> counts;
  for (const io::LevelLines& level : lines) {
    const auto cycles = static_cast<std::size_t>(
        std::count_if(level.contours.begin(), level.contours.end(),
                      [](const reeb::Contour& contour) { return contour.closed; }));
    counts.push_back({level.level, level.contours.size() - cycles, cycles});
  }
  return counts;
}

/// Everything up to the graph and its certificate.
struct Extraction {
  io::QuadraticFile file;
  reeb::PredicateReport predicates;
  reeb::TileComplex tiles;
  reeb::ReebGraph graph;
  std::vector<Index> arc_of_node;  ///< if arcs are drawn, unless the segmentation has them
  std::string digest;
};

Extraction extract(Run& run, const io::FunctionSource& source, bool labelled) {
  Extraction x{
      run.read([&](const std::string& path) { return io::read_quadratic_mesh(path, source); }),
      {},
      {},
      {},
      {},
      {}};
  x.tiles = run.step("tessellate", "tessellating",
                     [&] { return reeb::tessellate(x.file.mesh, &x.predicates); });
  run.step("graph", "joining contours into the graph", [&] {
    const reeb::OrderedComplex complex = reeb::ordered(x.tiles);
    if (!labelled) {
      x.graph = reeb::reeb_graph(complex);
      return;
    }
    reeb::GraphAndArcs result = reeb::reeb_graph_and_arcs(complex);
    x.graph = std::move(result.graph);
    x.arc_of_node = std::move(result.arc_of_vertex);
  });
  if (!run.wanted("--certificate")) return x;
  const certify::Bytes bytes = run.step("certificate", "composing the certificate", [&] {
    return certify::encode(reeb::make_certificate(x.file.mesh, x.tiles, x.graph));
  });
  x.digest = certify::hex(certify::data_digest(bytes));
  run.report()["data_digest"] = x.digest;
  run.write_certificate("reeb", bytes);
  return x;
}

/// What -o and --picture show; what neither needs is left empty.
struct Shown {
  std::vector<io::TreeLines> trees;
  std::vector<io::LevelLines> levels;
  std::vector<reeb::NodePlace> places;
  WrittenGraph written;
};

/// The largest of the pairs that a node is in.
std::vector<double> node_persistence(const Shown& shown) {
  std::vector<double> values, most(shown.written.graph.nodes.size(), 0);
  for (const reeb::NodePlace& place : shown.places) values.push_back(place.value);
  for (const reeb::PersistencePair& pair : reeb::persistence_pairs(shown.written.graph, values))
    for (const Index node : {pair.lower, pair.upper})
      most[node] = std::max(most[node], pair.persistence);
  return most;
}

void write_scenes(Run& run, const Extraction& x, const Shown& shown) {
  const auto scene = [&](const std::vector<io::LevelLines>& lines) {
    return io::ReebScene{x.file.mesh,
                         x.tiles,
                         shown.places,
                         shown.written.graph,
                         shown.written.arc_of_node,
                         shown.written.arc_of_tile,
                         shown.trees,
                         lines,
                         x.digest,
                         x.file.numbers.faces};
  };
  run.write("-o", [&](const std::string& path) { io::write_reeb(path, scene(shown.levels)); });
  const auto drawn_lines = [&] {
    return shown.levels.empty()
               ? level_lines(x.file.mesh, x.tiles, io::picture_levels(shown.places))
               : shown.levels;
  };
  const std::string note = legend_note("simplified", shown.written.simplified_by);
  run.write("--picture", [&](const std::string& path) {
    const auto lines = drawn_lines();
    io::write_reeb_picture(path, scene(lines), run.viewpoint(), note);
  });
  run.show_page([&] {
    const auto lines = drawn_lines();
    io::Scene page = io::reeb_page_scene(scene(lines), node_persistence(shown), run.viewpoint());
    page.note = note;
    page.data_digest = x.digest;
    return page;
  });
}

Shown compute_shown(Run& run, const ReebOptions& o, Extraction& x, bool drawn) {
  Shown shown;
  shown.trees = run.step("trees", "merging", [&] { return trees_of(o, x.tiles, x.graph); });
  shown.levels = run.step("levels", "drawing level lines",
                          [&] { return level_lines(x.file.mesh, x.tiles, o.levels); });
  const reeb::Simplification simpler = simplification_of(o);
  if (!drawn && !simpler.wanted()) return shown;
  shown.written.graph = x.graph;
  shown.written.arc_of_node = std::move(x.arc_of_node);
  if (drawn || simpler.persistence) {
    shown.places = run.step("places", "placing nodes",
                            [&] { return reeb::node_places(x.file.mesh, x.tiles); });
  }
  if (drawn && o.segmentation)
    run.step("labels", "labelling", [&] { reeb::label(x.tiles, true, shown.written); });
  if (simpler.wanted()) {
    run.step("simplify", "simplifying",
             [&] { simplify(simpler, x.tiles, shown.places, shown.written); });
  }
  return shown;
}

void check_options(const ReebOptions& o) {
  for (const double level : o.levels)
    if (!std::isfinite(level)) throw UsageError("--level: give a finite number");
  if (!(o.persistence >= 0)) throw UsageError("--persistence: give a number from 0 on");
}

Outcome work(Run& run, const ReebOptions& o, const io::FunctionSource& source) {
  const bool drawn = run.wanted("-o") || run.wanted("--picture") || run.wanted("--page");
  Extraction x = extract(run, source, drawn && !o.segmentation);
  const Shown shown = compute_shown(run, o, x, drawn);
  if (drawn) run.step("write", "writing", [&] { write_scenes(run, x, shown); });
  const std::vector<LevelCount> counts = count_lines(shown.levels);
  const ReebRun result{x.file.mesh,
                       x.tiles,
                       x.predicates,
                       x.graph,
                       shown.written.changed ? shown.written.graph : x.graph,
                       shown.trees,
                       x.file.function,
                       counts,
                       run.wanted("--certificate"),
                       shown.written.simplified_by};
  fill_report(run.report(), result);
  std::vector<std::string> references = {"dillard2006tessellation", "edelsbrunner1990simulation"};
  if (run.wanted("--certificate"))
    references.insert(references.end(), {"mcconnell2011certifying", "carr2003contour"});
  return {summary_text(result), references};
}

int run_reeb(const ReebOptions& o) {
  check_options(o);
  const io::FunctionSource source = function_source(o);
  return run_command({"reeb", o.common, {".vtp", ".vtu"}},
                     [&](Run& run) { return work(run, o, source); });
}

std::function<int()> add_reeb(CLI::App& app) {
  auto options = std::make_shared<ReebOptions>();
  add_common_options(
      app, options->common,
      fmt::format("surface with a function, or mesh with --expression ({})", kMeshFormats),
      "graph, critical points and level lines (.vtp) or tiles (.vtu)");
  add_reeb_options(app, *options);
  add_clean_options(app, options->common.clean, false);
  add_step_option(app, options->common);
  return [options] { return run_reeb(*options); };
}

}  // namespace

extern const Command reeb_command;
const Command reeb_command = {
    "reeb",
    "Reeb graph of a function on a surface, linear or quadratic on each face",
    add_reeb,
    {"crest reeb ellipsoid.off --expression 'x*x - y*z' -o reeb.vtp --picture reeb.svg "
     "--page reeb.html",
     "crest reeb ellipsoid.off --expression 'x^3 - 3*x*y^2' --certificate reeb.crest --report "
     "reeb.json"}};

}  // namespace crest::cli
