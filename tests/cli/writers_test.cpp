// SPDX-License-Identifier: GPL-3.0-or-later
// Every writer of every command on results that are empty, of one vertex or of everything, and on
// scans: a file that VTK opens, the same lines in .obj, never a crash.
#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/formats/vtk_quiet.hpp"
#include "tests/cli/run_crest.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest::tests;

namespace {

using Point = std::array<double, 3>;
using Lines = std::vector<std::vector<Point>>;

template <class Reader>
vtkSmartPointer<vtkDataSet> read_data_set(const fs::path& path) {
  const crest::io::VtkQuiet quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkDataSet> data = reader->GetOutputAsDataSet();
  REQUIRE(data != nullptr);
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    if (data->GetCell(c)->GetNumberOfPoints() < 1) FAIL("an empty cell");
  CHECK(quiet.complaint() == "");
  return data;
}

/// Vertices and lines of a .vtp, sorted.
Lines vtp_lines(const fs::path& path) {
  const auto data = read_data_set<vtkXMLPolyDataReader>(path);
  Lines lines;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
    vtkCell& cell = *data->GetCell(c);
    if (cell.GetCellDimension() > 1) continue;
    auto& line = lines.emplace_back();
    for (vtkIdType i = 0; i < cell.GetNumberOfPoints(); ++i)
      data->GetPoint(cell.GetPointId(static_cast<int>(i)), line.emplace_back().data());
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

/// p and l of an .obj, sorted.
Lines obj_lines(const fs::path& path) {
  std::vector<Point> points;
  Lines lines;
  for (const std::string& text : split_lines(read_text(path))) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    if (word == "v") {
      Point& p = points.emplace_back();
      words >> p[0] >> p[1] >> p[2];
    } else if (word == "p" || word == "l") {
      auto& line = lines.emplace_back();
      for (std::size_t i = 0; words >> i;) line.push_back(points.at(i - 1));
      CHECK((word == "p") == (line.size() == 1));
    }
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

void check_data_set(const fs::path& path) {
  if (path.extension() == ".vtp")
    read_data_set<vtkXMLPolyDataReader>(path);
  else if (path.extension() == ".vtu")
    read_data_set<vtkXMLUnstructuredGridReader>(path);
}

/// Runs `crest COMMAND`, once a name with -o, and looks at what comes out.
void write_all(const TemporaryFolder& folder, const std::string& command,
               const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto run = run_crest("crest " + command + " -o " + name, folder.path());
    INFO(command << " -o " << name << "\n" << run.err);
    REQUIRE(run.exit_code == 0);
    const std::string bytes = read_text(folder / name);
    CHECK(bytes.find("AppendedData") == std::string::npos);
    check_data_set(folder / name);
  }
}

/// A grid of n by n vertices over the unit square with the field `f`.
std::string grid_vtp(int n, double (*f)(int i, int j)) {
  std::string points, values, cells, ends;
  int corners = 0;
  const auto add = [&](int a, int b, int c) {
    cells += fmt::format("{} {} {}\n", a, b, c);
    ends += fmt::format("{}\n", corners += 3);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      points += fmt::format("{} {} {}\n", i / (n - 1.0), j / (n - 1.0), 0.01 * i * j);
      values += fmt::format("{}\n", f(i, j));
      if (i + 1 == n || j + 1 == n) continue;
      const int v = i * n + j;
      add(v, v + n, v + n + 1);
      add(v, v + n + 1, v + 1);
    }
  }
  const auto array = [](const char* type, const std::string& rest, const std::string& text) {
    return fmt::format("<DataArray type=\"{}\" {} format=\"ascii\">\n{}</DataArray>\n", type, rest,
                       text);
  };
  return fmt::format(
             "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"{}\" "
             "NumberOfPolys=\"{}\">\n",
             n * n, corners / 3) +
         "<PointData>" + array("Float64", "Name=\"f\"", values) + "</PointData><Points>" +
         array("Float64", "NumberOfComponents=\"3\"", points) + "</Points><Polys>" +
         array("Int64", "Name=\"connectivity\"", cells) + array("Int64", "Name=\"offsets\"", ends) +
         "</Polys></Piece></PolyData></VTKFile>\n";
}

}  // namespace

TEST_CASE("features: no vertex, one vertex and all vertices marked") {
  const TemporaryFolder folder;
  write_text(folder / "peak.vtp",
             grid_vtp(9, [](int i, int j) { return i == 4 && j == 4 ? 1. : 0.; }));
  write_text(folder / "peaks.vtp",
             grid_vtp(9, [](int i, int j) { return i % 4 == 2 && j % 4 == 2 ? 1. : 0.; }));
  write_text(folder / "ends.vtp",
             grid_vtp(9, [](int i, int j) { return j == 4 && (i < 3 || i > 4) ? 1. : 0.; }));
  REQUIRE(run_crest("crest sample ellipsoid --vertices 300 -o e.off", folder.path()).exit_code ==
          0);
  for (const std::string input :
       {"peak.vtp --field f --value 0.5", "peak.vtp --field f --value 2", "peak.vtp --threshold 0",
        "peak.vtp --field f --threshold 0", "peaks.vtp --field f --value 0.5",
        "ends.vtp --field f --value 0.5", "e.off --value 1e9", "e.off --threshold 0", "e.off",
        "e.off --angle 5", "e.off --angle 0", "e.off --angle 180", "peak.vtp --angle 0.001",
        "e.off --angle 5 --over 2", "peak.vtp --angle 0 --over 1"}) {
    const std::string line = "features " + input;
    INFO(line);
    write_all(folder,
              line + " --picture p.svg --certificate c.crest --report r.json --patches q.vtp",
              {"o.vtp", "o.obj"});
    check_data_set(folder / "q.vtp");
    CHECK(run_crest("crest-verify c.crest", folder.path()).exit_code == 0);
    CHECK(vtp_lines(folder / "o.vtp") == obj_lines(folder / "o.obj"));
  }
  write_all(folder, "features peak.vtp --field f --value 0.5", {"o.vtp"});
  CHECK(vtp_lines(folder / "o.vtp") == Lines{{{0.5, 0.5, 0.16}}});
}

TEST_CASE("ridges, curvature and reeb: empty results and full ones") {
  const TemporaryFolder folder;
  write_text(folder / "flat.vtp", grid_vtp(9, [](int, int) { return 3.; }));
  for (const char* sample : {"plane --vertices 200 -o plane.off", "sphere --vertices 300 -o s.off",
                             "blend --vertices 900 -o b.off"})
    REQUIRE(run_crest(std::string("crest sample ") + sample, folder.path()).exit_code == 0);
  for (const std::string input :
       {"plane.off", "s.off", "b.off", "flat.vtp", "b.off --min-strength 1e300",
        "b.off --crest-only --min-length 1e9", "b.off --crest-only"}) {
    write_all(folder, "ridges " + input + " --picture p.svg --report r.json",
              {"o.vtp", "o.obj", "o.ply"});
    CHECK(vtp_lines(folder / "o.vtp") == obj_lines(folder / "o.obj"));
  }
  for (const std::string input : {"plane.off", "s.off", "flat.vtp", "s.off --method jet"}) {
    write_all(folder, "curvature " + input + " --focal f.vtp --focal-picture p.svg",
              {"o.vtp", "o.vtu", "o.ply"});
    check_data_set(folder / "f.vtp");
  }
  for (const std::string input :
       {"plane.off --expression 0*x", "s.off --expression z --level 1e9 --level 0",
        "s.off --expression 0*x --segmentation --join-tree --split-tree --contour-tree",
        "flat.vtp --field f --contract --segmentation", "flat.vtp --field f --level 3"})
    write_all(folder, "reeb " + input + " --picture p.svg --report r.json", {"o.vtp", "o.vtu"});
  write_all(folder, "sample sphere --vertices 100", {"o.off", "o.obj", "o.ply", "o.vtp"});
}

TEST_CASE("default options on scans and models: every command answers, its files open") {
  std::vector<std::string> files;
  for (const char* name :
       {"meshes/anchor.off", "meshes/bunny_3k.off", "meshes/dino.off", "meshes/elephant.off",
        "meshes/fandisk.off", "meshes/joint.off", "meshes/knot1.off", "meshes/man.off",
        "meshes/pinion.off", "meshes/rotor.off", "meshes/rocker-arm.obj",
        "reported/geo_cube_8.off"}) {
    const auto path = shared_data(name);
    if (!path) return;
    files.push_back(*path);
  }
  const TemporaryFolder folder;
  for (const std::string& file : files) {
    for (const std::string command : {"features", "ridges"}) {
      write_all(folder, command + " '" + file + "'", {"o.vtp", "o.obj"});
      CHECK(vtp_lines(folder / "o.vtp") == obj_lines(folder / "o.obj"));
    }
    write_all(folder, "curvature '" + file + "' --focal f.vtp", {"o.vtu"});
    check_data_set(folder / "f.vtp");
    write_all(folder, "reeb '" + file + "' --expression z", {"o.vtp"});
  }
}

TEST_CASE(
    "meshes too large or too small for curvatures are refused with the factor that mends it") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --vertices 300 -o e.off", folder.path()).exit_code ==
          0);
  const auto lines = split_lines(read_text(folder / "e.off"));
  const std::size_t vertices = std::stoul(lines.at(1));
  const auto scaled = [&](const std::string& name, int power) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::istringstream words(lines[i]);
      Point p;
      if (i >= 2 && i < 2 + vertices && words >> p[0] >> p[1] >> p[2])
        for (double& x : p) text += fmt::format("{} ", x * std::pow(10, power));
      else
        text += lines[i];
      text += '\n';
    }
    write_text(folder / name, text);
  };
  scaled("s.off", 0);
  for (const int power : {80, 100, 200, 307, -80, -100, -200, -307}) {
    scaled("t.off", power);
    for (const std::string command :
         {"ridges t.off", "features t.off", "features t.off --method ne", "curvature t.off"}) {
      const auto run = run_crest("crest " + command + " -o o.vtp --report r.json", folder.path());
      INFO(command << " " << power << "\n" << run.err);
      CHECK(run.exit_code == 3);
      CHECK(is_one_line(run.err));
      CHECK(run.err.starts_with("crest: t.off: points: "));
      CHECK(run.err.find("scale the mesh by 1e") != std::string::npos);
      CHECK_FALSE(fs::exists(folder / "o.vtp"));
      CHECK_FALSE(fs::exists(folder / "r.json"));
    }
    write_all(folder, "reeb t.off --expression z --level 0 --picture p.svg --report r.json",
              {"o2.vtp", "o2.vtu"});
    for (const char* name : {"o2.vtp", "o2.vtu", "r.json"}) fs::remove(folder / name);
  }
  // What is in range, up to its end, has the answer of the mesh itself.
  const auto graph_of = [&](const std::string& name) {
    REQUIRE(run_crest("crest ridges " + name + " --report g.json", folder.path()).exit_code == 0);
    const auto report = read_json(folder / "g.json");
    return std::array<int, 5>{report["umbilics"]["count"], report["ridges"]["blue"]["loops"],
                              report["ridges"]["blue"]["segments"],
                              report["ridges"]["red"]["loops"],
                              report["ridges"]["red"]["segments"]};
  };
  const auto expected = graph_of("s.off");
  for (const int power : {-69, -40, 40, 69}) {
    scaled("t.off", power);
    CHECK(graph_of("t.off") == expected);
  }
  if (const auto file = shared_data("reported/geo_scale_1e100.off"))
    for (const std::string command : {"ridges", "features", "curvature"})
      CHECK(run_crest("crest " + command + " '" + *file + "'", folder.path()).exit_code == 3);
}
