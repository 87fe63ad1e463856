// SPDX-License-Identifier: GPL-3.0-or-later
// The files of ../shared/data/reported as soups: everything that is in them, nothing mended.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/io/soups.hpp"
#include "tests/support/shared_data.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;

enum class Shape { ellipsoid, torus, other };

struct Reported {
  const char* file;
  const char* counts;
  Shape shape = Shape::ellipsoid;
  const char* fields = "";
  const char* warning = "";
};

const char* const kEllipsoid = "642 points, 1280 of type 5";
const char* const kManyFields =
    "with nan 1, with inf 1, sentinel 1, fltmax 1, u8 1, i64 1, i32 1, constant 1, f32 1, velocity "
    "3, label 1, H\xc3\xb6he \xc3\xbc"
    "ber NN [m] 1, tiny 1, huge 1; cells: area 1";

const Reported kReported[] = {
    {"geo_cube_8.off", "386 points, 768 of type 5", Shape::other},
    {"geo_cylinder.off", "1008 points, 1920 of type 5", Shape::other},
    {"geo_scale_1e100.off", kEllipsoid, Shape::other},
    {"geo_zero_edge.off", kEllipsoid},
    {"msh_22_binary.msh", kEllipsoid, Shape::ellipsoid},
    {"msh_22_tets_beside.msh", "642 points, 1280 of type 5, 1 of type 10", Shape::ellipsoid, "u 1"},
    {"msh_22_two_steps.msh", kEllipsoid, Shape::ellipsoid, "u 1",
     "took time step 1 of field 'u', its last; --step chooses another of 0, 1"},
    {"n_list.ply", kEllipsoid, Shape::ellipsoid, "Normals 3*, texcoord 0"},
    {"n_unref.ply", "643 points, 1280 of type 5", Shape::ellipsoid, "Normals 3*"},
    {"obj_quad_torus.obj", "800 points, 800 of type 9", Shape::torus},
    {"obj_uv_seams_doubled.obj", "861 points, 1600 of type 5", Shape::torus},
    {"off_cr_only.off", kEllipsoid},
    {"off_crlf_bom.off", kEllipsoid},
    {"off_nan_unreferenced.off", "647 points, 1280 of type 5"},
    {"off_quad_cube.off", "8 points, 6 of type 9", Shape::other},
    {"off_two_counts.off", kEllipsoid},
    {"off_wrapped_lines.off", kEllipsoid},
    {"ply_blank_header_line.ply", kEllipsoid},
    {"ply_coordinates_int.ply", kEllipsoid, Shape::other},
    {"ply_index_ushort_le.ply", kEllipsoid},
    {"ply_nan_face_property_ascii.ply", kEllipsoid, Shape::ellipsoid, "; cells: quality 1"},
    {"ply_nan_quality_ascii.ply", kEllipsoid, Shape::ellipsoid, "quality 1"},
    {"ply_reeb_quality.ply", kEllipsoid, Shape::ellipsoid, "quality 1"},
    {"ply_soup_of_triangles.ply", "3840 points, 1280 of type 5"},
    {"ply_tristrips.ply", "800 points, 40 of type 6", Shape::torus},
    {"stl_binary_solid_trailing_bytes.stl", kEllipsoid},
    {"stl_text_end_solid.stl", kEllipsoid},
    {"stl_text_no_endsolid.stl", kEllipsoid, Shape::ellipsoid, "",
     "the file ends without 'endsolid'"},
    {"stl_text_upper.stl", kEllipsoid},
    {"stl_zero_facets.stl", "98 points, 194 of type 5", Shape::other},
    {"top_bow_tie_vertex.off", "1284 points, 2560 of type 5", Shape::other},
    {"top_duplicate_faces.off", "642 points, 1290 of type 5", Shape::other},
    {"top_inside_out.off", kEllipsoid, Shape::other},
    {"top_repeated_index.off", "642 points, 1282 of type 5"},
    {"vtk_polydata_42_txt.vtk", kEllipsoid, Shape::ellipsoid, "height 1"},
    {"vtk_polydata_51_bin.vtk", kEllipsoid, Shape::ellipsoid, "height 1"},
    {"vtp_fields.vtp", kEllipsoid, Shape::ellipsoid, kManyFields},
    {"vtp_quads.vtp", "800 points, 800 of type 9", Shape::torus, "height 1"},
    {"vtu_binary.vtu", kEllipsoid, Shape::ellipsoid, "height 1"},
    {"vtu_mixed.vtu", "800 points, 800 of type 5, 400 of type 9", Shape::torus, "height 1"},
};

/// How far the point is from the shape, in its equation.
double distance(Shape shape, const crest::kernel::Vec3& p) {
  if (shape == Shape::ellipsoid)
    return std::abs(p[0] * p[0] + p[1] * p[1] / 2.25 + p[2] * p[2] / 4 - 1);
  return std::abs(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4);
}

Soup reported(const std::string& file, const std::string& path, const FieldRequest& request) {
  return crest::io::soup_reader(lower_extension(file))(load(path), request);
}

}  // namespace

TEST_CASE("reported files are read as they stand", "[io]") {
  for (const Reported& r : kReported) {
    const auto path = shared_data(std::string("reported/") + r.file);
    if (!path) return;
    INFO(r.file);
    const Soup soup = reported(r.file, *path, {true, ""});
    CHECK(counts(soup) == r.counts);
    CHECK(field_names(soup) == r.fields);
    const std::string warning = r.warning;
    CHECK(soup.warnings ==
          (warning.empty() ? std::vector<std::string>() : std::vector<std::string>{warning}));
    for (const Field& f : soup.point_fields)
      if (f.components > 0)
        CHECK(f.size() == soup.points.size() * static_cast<std::size_t>(f.components));
    for (const Field& f : soup.cell_fields) CHECK(f.size() == soup.cells.size());
    if (r.shape == Shape::other) continue;
    double worst = 0;
    for (const auto& p : soup.points)
      if (std::isfinite(p[0])) worst = std::max(worst, distance(r.shape, p));
    // n_unref.ply has its unused vertex elsewhere.
    if (std::string(r.file) != "n_unref.ply") CHECK(worst < 1e-4);
    const double volume = r.shape == Shape::ellipsoid ? 12.56 : 3.15;
    CHECK(signed_volume(soup) == Approx(volume).epsilon(0.04));
  }
}

TEST_CASE("values of reported files", "[io]") {
  const auto read = [](const char* file, const FieldRequest& request) {
    const auto path = shared_data(std::string("reported/") + file);
    return path ? reported(file, *path, request) : Soup();
  };
  const Soup fields = read("vtp_fields.vtp", {true, ""});
  if (fields.points.empty()) return;
  const auto with_nan = numbers_of<double>(fields.point_fields, "with nan"),
             with_inf = numbers_of<double>(fields.point_fields, "with inf");
  CHECK(std::count_if(with_nan.begin(), with_nan.end(), [](double x) { return std::isnan(x); }) >
        0);
  CHECK(std::count_if(with_inf.begin(), with_inf.end(), [](double x) { return std::isinf(x); }) >
        0);
  CHECK(numbers_of<std::int64_t>(fields.point_fields, "i64").size() == 642);
  CHECK(numbers_of<double>(fields.cell_fields, "area").back() == 1279);

  const Soup nan = read("ply_nan_quality_ascii.ply", {true, "quality"});
  CHECK(std::isnan(numbers_of<double>(nan.point_fields, "quality")[0]));
  CHECK(numbers_of<double>(nan.point_fields, "quality")[1] == 1);

  const Soup quality = read("ply_reeb_quality.ply", {true, "quality"});
  for (std::size_t v = 0; v < quality.points.size(); ++v)
    CHECK(numbers_of<double>(quality.point_fields, "quality")[v] == quality.points[v][2]);

  // Both steps of u are there: z and, one later, -z.
  const Soup first = read("msh_22_two_steps.msh", {.wanted = true, .step = 0});
  const Soup last = read("msh_22_two_steps.msh", {.wanted = true});
  const auto u0 = numbers_of<double>(first.point_fields, "u"),
             u1 = numbers_of<double>(last.point_fields, "u");
  REQUIRE(u0.size() == 642);
  REQUIRE(u1.size() == 642);
  for (std::size_t v = 0; v < u0.size(); ++v) {
    CHECK(u0[v] == first.points[v][2]);
    CHECK(u1[v] == -u0[v]);
  }
  CHECK(first.warnings.empty());

  const Soup bad = read("off_nan_unreferenced.off", {});
  REQUIRE(bad.lines_not_finite.size() == 5);
  CHECK(bad.point_name(642) == "vertex 642 (line 645)");
  CHECK(bad.point_name(641) == "vertex 641");

  const Soup text = read("vtk_polydata_42_txt.vtk", {true, "height"}),
             binary = read("vtk_polydata_51_bin.vtk", {true, "height"});
  const auto of_text = numbers_of<double>(text.point_fields, "height"),
             of_binary = numbers_of<double>(binary.point_fields, "height");
  for (std::size_t v = 0; v < 642; ++v) {
    CHECK(of_text[v] == text.points[v][2]);
    CHECK(of_binary[v] == Approx(of_text[v]).margin(1e-10));
  }
}
