// SPDX-License-Identifier: GPL-3.0-or-later
// Plane vector fields from every format, and what is said of those that are none.
#include <netcdf.h>

#include <catch2/catch.hpp>
#include <functional>

#include "io/read/planar_field_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace crest;
using namespace crest::io;
using crest::tests::TemporaryFolder;

namespace {

std::string corpus(const std::string& name) {
  std::string path = CREST_SOURCE_DIR "/tests/fuzz/corpus/planar_";
  path += name;  // GCC 12 warns of bounds in a chain of sums
  return path;
}
VectorRequest layer(int k) {
  VectorRequest request;
  request.slice = k;
  return request;
}

/// What is wrong with a file, without its name.
std::string complaint(const std::string& path, const VectorRequest& request = {}) {
  try {
    static_cast<void>(read_planar_field(path, request));
  } catch (const kernel::InputError& error) {
    const std::string line = error.what();
    CHECK(line.starts_with(path + ": "));
    CHECK(line.find('\n') == std::string::npos);
    CHECK(line.find("; ") != std::string::npos);
    return line.substr(path.size() + 2);
  }
  return "";
}
bool holds(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// Two variables with as many axes as names; `more` adds attributes and coordinates.
void write_net_cdf(const std::string& path, const std::vector<std::size_t>& size,
                   const std::function<void(int file, const int* axes, const int* uv)>& more) {
  int file = 0, axes[4] = {}, uv[2] = {};
  REQUIRE(nc_create(path.c_str(), NC_CLOBBER, &file) == NC_NOERR);
  const char* const names[] = {"a", "b", "c", "d"};
  std::size_t count = 1;
  for (std::size_t i = 0; i < size.size(); ++i) {
    nc_def_dim(file, names[i], size[i], &axes[i]);
    count *= size[i];
  }
  nc_def_var(file, "u", NC_DOUBLE, static_cast<int>(size.size()), axes, &uv[0]);
  nc_def_var(file, "v", NC_DOUBLE, static_cast<int>(size.size()), axes, &uv[1]);
  more(file, axes, uv);
  nc_enddef(file);
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<double>(i);
  nc_put_var_double(file, uv[0], numbers.data());
  nc_put_var_double(file, uv[1], numbers.data());
  nc_close(file);
}

}  // namespace

TEST_CASE("planar fields: NRRD, with directions, spacings, layers", "[io]") {
  const auto file = read_planar_field(corpus("nrrd/text.nrrd"), {});
  CHECK(file.points.size() == 9);
  CHECK(file.triangles.size() == 8);
  CHECK(file.field == "vectors");
  CHECK(file.points[0] == kernel::Vec2{-1, 2});
  const auto last = std::max_element(file.points.begin(), file.points.end());
  CHECK(*last == kernel::Vec2{0, 2.5});
  CHECK(file.vectors[0] == kernel::Vec2{-1.5, 1});

  CHECK(holds(complaint(corpus("nrrd/layers.nrrd")), "has 2 layers; choose one with --slice"));
  CHECK(holds(complaint(corpus("nrrd/layers.nrrd"), layer(2)), "slice: 2 does not exist"));
  const auto upper = read_planar_field(corpus("nrrd/layers.nrrd"), layer(1));
  CHECK(upper.points.size() == 4);
  CHECK(upper.points[2] != upper.points[0]);
  CHECK(upper.vectors[0] == kernel::Vec2{2, 3});  // numbers 12 and 13

  const TemporaryFolder folder;
  const auto wrong = [&](const std::string& header) {
    const std::string path = folder / "wrong.nrrd";
    std::ofstream(path) << "NRRD0004\ntype: double\nencoding: text\n"
                        << header << "\n\n1 2 3 4 5 6 7 8\n";
    return complaint(path);
  };
  CHECK(holds(wrong("dimension: 3\nsizes: 2 2 2"), "do not say that the first axis holds vectors"));
  CHECK(holds(wrong("dimension: 2\nsizes: 2 4"), "not those of vectors on a grid"));
  CHECK(holds(wrong("dimension: 3\nsizes: 4 2 1\nkinds: 4-vector space space"), "not those of"));
  CHECK(holds(wrong("dimension: 3\nsizes: 2 2 2\nspace directions: none (1,0,1) (0,1,0)"),
              "leave the plane"));
  CHECK(holds(wrong("dimension: 3\nsizes: 2 2 2\nspace directions: none (1e308,0) (0,1)\n"
                    "space origin: (1e308,0)"),
              "lead beyond all numbers"));
  VectorRequest named;
  named.field = "wind";
  CHECK(holds(complaint(corpus("nrrd/text.nrrd"), named), "an NRRD file has one, 'vectors'"));
}

TEST_CASE("planar fields: NetCDF by the conventions, packed, with a missing vector", "[io]") {
  const std::string path = corpus("nc/cf.nc");
  CHECK(holds(complaint(path), "u: has 2 layers; choose one with --slice"));
  const auto file = read_planar_field(path, layer(0));
  // Of 2 x 3 cells the one at the missing vector is none.
  CHECK(file.triangles.size() == 10);
  CHECK(file.points.size() == 11);
  CHECK(file.field == "u,v");
  CHECK(file.points[0] == kernel::Vec2{0, 60});
  CHECK(file.vectors[0] == kernel::Vec2{-5 * 0.5 + 1, -6 * 0.5 + 1});
  CHECK(file.warnings.size() == 1);
  CHECK(read_planar_field(path, layer(1)).triangles.size() == 12);
  VectorRequest named = layer(1);
  named.field = "v,u";
  CHECK(read_planar_field(path, named).vectors[0][1] ==
        read_planar_field(path, layer(1)).vectors[0][0]);
  named.field = "u";
  CHECK(holds(complaint(path, named), "name two by --vectors U,V"));
  named.field = "u,w";
  CHECK(holds(complaint(path, named), "do not exist; the variables are lat, lon, u, v"));
}

TEST_CASE("planar fields: NetCDF at the centres of cells, triangulated", "[io]") {
  const auto file = read_planar_field(corpus("nc/icon.nc"), {});
  CHECK(file.points.size() == 7);
  CHECK(file.triangles.size() == 6);                            // a hexagon of six around the first
  for (const auto& p : file.points) CHECK(std::abs(p[0]) < 6);  // degrees: 0.1 in the file
  CHECK(std::max_element(file.points.begin(), file.points.end())->at(0) > 5);
}

TEST_CASE("planar fields: NetCDF that is no plane field", "[io]") {
  const TemporaryFolder folder;
  const std::string path = folder / "wrong.nc";
  const auto nothing = [](int, const int*, const int*) {};
  write_net_cdf(path, {3, 3}, nothing);
  CHECK(holds(complaint(path), "u: has no coordinates"));
  write_net_cdf(path, {9}, nothing);
  CHECK(holds(complaint(path), "have one axis"));
  // Coordinates of every point, as curvilinear grids have them.
  const auto points = [](int file, const int* axes, const int*) {
    for (const char* name : {"nav_lon", "nav_lat"}) {
      int id = 0;
      nc_def_var(file, name, NC_DOUBLE, 2, axes, &id);
    }
  };
  write_net_cdf(path, {3, 3}, points);  // fill values
  CHECK(holds(complaint(path), "nav_lon: has a number that is missing"));
  const auto two = [](int file, const int* axes, const int*) {
    for (const char* name : {"uo", "vo"}) {
      int id = 0;
      nc_def_var(file, name, NC_DOUBLE, 2, axes, &id);
    }
  };
  write_net_cdf(path, {3, 3}, two);
  CHECK(holds(complaint(path), "there are several; the variables are u, v, uo, vo"));
  // A header that announces more than the file holds: the library would allocate it.
  std::string bytes = tests::read_text(corpus("nc/icon.nc"));
  bytes[132] = 0x20;  // the number of an attribute list
  std::ofstream(path) << bytes;
  CHECK(holds(complaint(path), "announces more than it holds"));
  bytes[132] = 0;
  bytes[29] = 1;  // 65543 cells
  std::ofstream(path) << bytes;
  CHECK(holds(complaint(path), "file: cannot be read"));
  std::ofstream(path) << "CDF\003....";
  CHECK(holds(complaint(path), "file: cannot be read"));
  std::ofstream(path) << "";
  CHECK_FALSE(complaint(path).empty());
}

TEST_CASE("planar fields: winds, velocimetry and VTK's grids", "[io]") {
  // A null in the first corner.
  CHECK(read_planar_field(corpus("json/wind.json"), {}).triangles.size() == 6);
  CHECK(read_planar_field(corpus("txt/davis.txt"), {}).triangles.size() == 8);
  VectorRequest all;
  all.all = true;
  for (const char* name : {"txt/openpiv.txt", "vec/run.vec"}) {
    CHECK(holds(complaint(corpus(name)), "has no cell with four vectors"));
    CHECK(read_planar_field(corpus(name), all).triangles.size() == 8);
  }
  for (const char* name : {"vti/grid.vti", "vtr/grid.vtr", "vts/grid.vts", "vtk/grid.vtk"}) {
    INFO(name);
    CHECK(read_planar_field(corpus(name), {}).triangles.size() == 8);
    CHECK(holds(complaint(corpus(name), layer(1)), "slice: 1 does not exist"));
  }
  CHECK(read_planar_field(corpus("vtk/mesh.vtk"), {}).triangles.size() == 3);
  VectorRequest cells;
  cells.cell_to_point = true;
  const auto means = read_planar_field(corpus("vtk/mesh.vtk"), cells);
  CHECK(means.vectors[1] == kernel::Vec2{0.5, 0.5});
}

TEST_CASE("planar fields: the data set's NRRD", "[io]") {
  const auto path = tests::shared_data("vectorfields/sqflow2D-1608.nrrd");
  if (!path) return;
  const auto file = read_planar_field(*path, {});
  CHECK(file.points.size() == 192 * 64);
  CHECK(file.triangles.size() == 2 * 191 * 63);
  CHECK(std::abs(file.points[0][0] + 11.916666666666666) < 1e-12);
}
