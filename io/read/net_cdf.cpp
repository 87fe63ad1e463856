// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/net_cdf.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>
#include <netcdf.h>

#include <cmath>
#include <map>
#include <numbers>

#include "io/formats/files.hpp"
#include "io/read/net_cdf_header.hpp"
#include "io/read/plane_grid.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::Vec2;

constexpr std::size_t kMostSamples = std::size_t{1} << 27U;

void check(int error, const std::string& element) {
  if (error != NC_NOERR)
    fail(element, std::string("cannot be read: ") + nc_strerror(error), "write the file again");
}

struct Variable {
  int id = -1;
  std::string name;
  nc_type type = NC_NAT;
  std::vector<int> axes;
};

class NetCdf {
 public:
  explicit NetCdf(const std::string& path) {
    const FileBytes bytes = load(path);
    if (is_classic_net_cdf(bytes)) {
      check_classic_net_cdf(bytes);
      most_ = std::string_view(bytes).size();
    }
    check(nc_open(path.c_str(), NC_NOWRITE, &file_), "file");
    int count = 0;
    check(nc_inq_nvars(file_, &count), "file");
    for (int i = 0; i < count; ++i) {
      char name[NC_MAX_NAME + 1] = {};
      int axes = 0;
      Variable v{i, {}, NC_NAT, {}};
      check(nc_inq_var(file_, i, name, &v.type, &axes, nullptr, nullptr), "file");
      v.name = name;
      v.axes.resize(static_cast<std::size_t>(axes));
      check(nc_inq_vardimid(file_, i, v.axes.data()), v.name);
      if (v.type >= NC_BYTE && v.type <= NC_UINT64 && v.type != NC_CHAR) variables_.push_back(v);
    }
  }
  ~NetCdf() {
    if (file_ >= 0) nc_close(file_);
  }
  NetCdf(const NetCdf&) = delete;
  NetCdf& operator=(const NetCdf&) = delete;

  const std::vector<Variable>& variables() const { return variables_; }
  const Variable* find(const std::string& name) const {
    for (const Variable& v : variables_)
      if (v.name == name) return &v;
    return nullptr;
  }
  /// Empty if there is none.
  std::string text(const Variable& v, const char* attribute) const {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(file_, v.id, attribute, &type, &length) != NC_NOERR || type != NC_CHAR ||
        length > 10000)
      return {};
    std::string result(length, '\0');
    check(nc_get_att_text(file_, v.id, attribute, result.data()), v.name);
    return result.substr(0, result.find('\0'));
  }
  std::optional<double> number(const Variable& v, const char* attribute) const {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    double x = 0;
    if (nc_inq_att(file_, v.id, attribute, &type, &length) != NC_NOERR || type == NC_CHAR ||
        length != 1 || nc_get_att_double(file_, v.id, attribute, &x) != NC_NOERR)
      return std::nullopt;
    return x;
  }
  std::size_t length(int axis) const {
    std::size_t n = 0;
    check(nc_inq_dimlen(file_, axis, &n), "axis");
    return n;
  }
  std::string axis_name(int axis) const {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_dimname(file_, axis, name), "axis");
    return name;
  }

  /// The numbers of the last `axes` axes, layer `layer` of the others; NaN where missing.
  std::vector<double> numbers(const Variable& v, std::size_t axes, std::size_t layer) const {
    std::vector<std::size_t> start(v.axes.size(), 0), count(v.axes.size(), 1);
    std::size_t all = 1;
    for (std::size_t i = v.axes.size(); i-- > 0;) {
      const std::size_t n = length(v.axes[i]);
      if (i + axes >= v.axes.size()) {
        count[i] = n;
        if (n == 0 || all > most_ / n)
          fail(v.name, "is empty, or larger than the file", "write the file again, or crop it");
        all *= n;
      } else {
        start[i] = layer % n;
        layer /= n;
      }
    }
    std::vector<double> numbers(all);
    check(nc_get_vara_double(file_, v.id, start.data(), count.data(), numbers.data()), v.name);
    unpack(v, numbers);
    return numbers;
  }
  std::size_t layers(const Variable& v, std::size_t axes) const {
    std::size_t all = 1;
    for (std::size_t i = 0; i + axes < v.axes.size(); ++i) {
      const std::size_t n = length(v.axes[i]);
      if (n == 0 || all > kMostSamples / n) fail(v.name, "has no or too many layers", "crop it");
      all *= n;
    }
    return all;
  }

 private:
  void unpack(const Variable& v, std::vector<double>& numbers) const {
    std::vector<double> missing;
    for (const char* key : {"_FillValue", "missing_value"})
      if (const auto x = number(v, key)) missing.push_back(*x);
    if (missing.empty() && v.type == NC_FLOAT) missing.push_back(double{NC_FILL_FLOAT});
    if (missing.empty() && v.type == NC_DOUBLE) missing.push_back(NC_FILL_DOUBLE);
    if (missing.empty() && v.type == NC_SHORT) missing.push_back(NC_FILL_SHORT);
    const double scale = number(v, "scale_factor").value_or(1),
                 offset = number(v, "add_offset").value_or(0);
    for (double& x : numbers)
      x = std::count(missing.begin(), missing.end(), x) > 0 ? std::nan("") : x * scale + offset;
  }

  int file_ = -1;
  std::size_t most_ = kMostSamples;  ///< numbers of a variable
  std::vector<Variable> variables_;
};

using Pair = std::array<const Variable*, 2>;

std::string known(const NetCdf& in) {
  std::string names;
  for (const Variable& v : in.variables())
    if (!v.axes.empty()) names += (names.empty() ? "" : ", ") + v.name.substr(0, 60);
  return "the variables are " + names.substr(0, 400) + "; name two by --vectors U,V";
}

/// The two components.
Pair components(const NetCdf& in, const std::string& wanted) {
  if (!wanted.empty()) {
    const std::size_t comma = wanted.find(',');
    if (comma == wanted.npos) fail(fmt::format("array '{}'", wanted), "is one", known(in));
    const Pair pair = {in.find(wanted.substr(0, comma)), in.find(wanted.substr(comma + 1))};
    if (pair[0] == nullptr || pair[1] == nullptr)
      fail(fmt::format("arrays '{}'", wanted), "do not exist", known(in));
    return pair;
  }
  std::vector<Pair> found;
  const auto named = [&](const std::string& standard) {
    for (const Variable& v : in.variables())
      if (in.text(v, "standard_name") == standard) return &v;
    return static_cast<const Variable*>(nullptr);
  };
  static constexpr const char* kStandard[][2] = {
      {"eastward_wind", "northward_wind"},
      {"x_wind", "y_wind"},
      {"eastward_sea_water_velocity", "northward_sea_water_velocity"},
      {"sea_water_x_velocity", "sea_water_y_velocity"}};
  static constexpr const char* kNames[][2] = {
      {"u", "v"},   {"U", "V"},     {"u10", "v10"},        {"ua", "va"},
      {"uo", "vo"}, {"uas", "vas"}, {"water_u", "water_v"}};
  for (const auto& [u, v] : kStandard)
    if (const Pair pair = {named(u), named(v)}; pair[0] != nullptr && pair[1] != nullptr)
      found.push_back(pair);
  if (found.empty())
    for (const auto& [u, v] : kNames)
      if (const Pair pair = {in.find(u), in.find(v)}; pair[0] != nullptr && pair[1] != nullptr)
        found.push_back(pair);
  if (found.empty()) fail("vectors", "do not exist", known(in));
  if (found.size() > 1) fail("vectors", "there are several", known(in));
  return found[0];
}

/// A coordinate of points with these axes: longitude or x (0), latitude or y (1).
const Variable* coordinate(const NetCdf& in, const std::vector<int>& axes, std::size_t which) {
  static constexpr const char* kNames[2][5] = {{"lon", "longitude", "clon", "nav_lon", "x"},
                                               {"lat", "latitude", "clat", "nav_lat", "y"}};
  const char* const standard = which == 0 ? "longitude" : "latitude";
  for (const Variable& v : in.variables())
    if (v.axes == axes && in.text(v, "standard_name") == standard) return &v;
  for (const char* const name : kNames[which])
    if (const Variable* v = in.find(name); v != nullptr && v->axes == axes) return v;
  return nullptr;
}

/// In degrees, where the file says radians.
std::vector<double> degrees(const NetCdf& in, const Variable& v) {
  std::vector<double> x = in.numbers(v, v.axes.size(), 0);
  if (in.text(v, "units").starts_with("radian"))
    for (double& a : x) a *= 180 / std::numbers::pi;
  for (const double a : x)
    if (!std::isfinite(a)) fail(v.name, "has a number that is missing", "give all coordinates");
  return x;
}

std::size_t chosen_layer(const NetCdf& in, const Pair& uv, std::size_t axes,
                         const VectorRequest& request) {
  const std::size_t layers = in.layers(*uv[0], axes);
  if (layers > 1 && !request.slice)
    fail(uv[0]->name, fmt::format("has {} layers", layers), "choose one with --slice K, from 0");
  const auto layer = static_cast<std::size_t>(request.slice.value_or(0));
  if (layer >= layers)
    fail("slice", fmt::format("{} does not exist", layer), "layers count from 0");
  return layer;
}

/// On a grid: its columns and rows, or points.
PlaneGrid grid_of(const NetCdf& in, const Pair& uv, const VectorRequest& request) {
  const auto& axes = uv[0]->axes;
  const std::vector<int> last(axes.end() - 2, axes.end());
  PlaneGrid grid{in.length(last[1]), in.length(last[0]), {}, {}};
  const Variable *x = in.find(in.axis_name(last[1])), *y = in.find(in.axis_name(last[0]));
  const bool rows = x != nullptr && y != nullptr && x->axes.size() == 1 && y->axes.size() == 1 &&
                    x->axes[0] == last[1] && y->axes[0] == last[0];
  if (!rows) {
    x = coordinate(in, last, 0);
    y = coordinate(in, last, 1);
    if (x == nullptr || y == nullptr)
      fail(uv[0]->name, "has no coordinates", "give longitudes and latitudes of its points");
  }
  const std::size_t layer = chosen_layer(in, uv, 2, request);
  const auto u = in.numbers(*uv[0], 2, layer), v = in.numbers(*uv[1], 2, layer),
             a = degrees(in, *x), b = degrees(in, *y);
  for (std::size_t j = 0; j < grid.ny; ++j)
    for (std::size_t i = 0; i < grid.nx; ++i) {
      const std::size_t k = j * grid.nx + i;
      grid.points.push_back(rows ? Vec2{a[i], b[j]} : Vec2{a[k], b[k]});
      grid.vectors.push_back({u[k], v[k]});
    }
  return grid;
}

/// At the centres of cells, with the triangles between them.
void add_cells(const NetCdf& in, const Pair& uv, const Variable& lon, const Variable& lat,
               const VectorRequest& request, PlanarFieldFile& file) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Delaunay =
      CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  const std::size_t layer = chosen_layer(in, uv, 1, request);
  const auto u = in.numbers(*uv[0], 1, layer), v = in.numbers(*uv[1], 1, layer),
             x = degrees(in, lon), y = degrees(in, lat);
  std::vector<std::pair<Delaunay::Point, std::size_t>> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({{x[i], y[i]}, i});
  const Delaunay triangulation(points.begin(), points.end());
  std::vector<Index> number(x.size(), kernel::kNone);
  const auto use = [&](std::size_t i) {
    if (number[i] == kernel::kNone) {
      number[i] = static_cast<Index>(file.points.size());
      file.points.push_back({x[i], y[i]});
      file.vectors.push_back({u[i], v[i]});
    }
    return number[i];
  };
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& face : triangulation.finite_face_handles()) {
    std::array<std::size_t, 3> t{};
    for (int k = 0; k < 3; ++k) t[static_cast<std::size_t>(k)] = face->vertex(k)->info();
    const bool there = std::all_of(t.begin(), t.end(), [&](std::size_t i) {
      return std::isfinite(u[i]) && std::isfinite(v[i]);
    });
    if (!there) continue;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  for (const auto& [a, b, c] : triangles) {
    const Index i = use(a), j = use(b), k = use(c);
    file.cell_of.push_back(static_cast<std::int64_t>(file.triangles.size()));
    file.triangles.push_back({i, j, k});
  }
  if (file.triangles.empty())
    fail(uv[0]->name, "has no three points with vectors", "give a field in the plane");
  if (triangulation.number_of_vertices() < x.size())
    file.warnings.push_back(fmt::format("{} points that coincide with others left out",
                                        x.size() - triangulation.number_of_vertices()));
}

}  // namespace

void read_net_cdf(const std::string& path, const VectorRequest& request, PlanarFieldFile& file) {
  const NetCdf in(path);
  const Pair uv = components(in, request.field);
  file.field = uv[0]->name + "," + uv[1]->name;
  if (uv[0]->axes != uv[1]->axes || uv[0]->axes.empty())
    fail(file.field, "have different axes", "give two components of one grid");
  const std::vector<int> cells = {uv[0]->axes.back()};
  const Variable *lon = coordinate(in, cells, 0), *lat = coordinate(in, cells, 1);
  if (lon != nullptr && lat != nullptr) return add_cells(in, uv, *lon, *lat, request, file);
  if (uv[0]->axes.size() < 2)
    fail(file.field, "have one axis", "give longitudes and latitudes of the cells");
  add_triangles(grid_of(in, uv, request), request.diagonal, file);
}

}  // namespace crest::io
