// SPDX-License-Identifier: GPL-3.0-or-later
// Winds as GRIB2JSON writes them: two records, eastward and northward.
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/formats/files.hpp"
#include "io/read/plane_grid.hpp"

namespace crest::io {
namespace {

using nlohmann::json;

double number(const json& header, const char* key) {
  const auto at = header.find(key);
  if (at == header.end() || !at->is_number())
    fail(std::string("header ") + key, "is not there", "write the file by grib2json");
  return at->get<double>();
}

struct WindRecord {
  double nx, ny, lo1, lo2, la1, la2, parameter;
  const json* data;
};

WindRecord record_of(const json& j) {
  if (!j.is_object() || !j.contains("header") || !j.contains("data") || !j["data"].is_array())
    fail("record", "has no header or no data", "write the file by grib2json");
  const json& h = j["header"];
  WindRecord r{number(h, "nx"),
               number(h, "ny"),
               number(h, "lo1"),
               number(h, "lo2"),
               number(h, "la1"),
               number(h, "la2"),
               number(h, "parameterNumber"),
               &j["data"]};
  const bool whole = r.nx >= 2 && r.ny >= 2 && r.nx <= 1e6 && r.ny <= 1e6 &&
                     r.nx == std::floor(r.nx) && r.ny == std::floor(r.ny);
  if (!whole || r.data->size() != static_cast<std::size_t>(r.nx * r.ny))
    fail("data", "has not nx times ny numbers", "write the file again");
  return r;
}

double value(const json& x) {
  if (x.is_null()) return std::nan("");
  if (!x.is_number()) fail("data", "has something that is no number", "write the file again");
  return x.get<double>();
}

}  // namespace

PlaneGrid read_wind_json(const std::string& path, PlanarFieldFile& file) {
  const FileBytes bytes = load(path);
  const std::string_view text = bytes;
  const json all = json::parse(text.begin(), text.end(), nullptr, false);
  if (all.is_discarded()) fail("file", "is no JSON, or cut off", "write it again");
  if (!all.is_array() || all.size() != 2)
    fail("file", "has not two records", "give the eastward and the northward wind alone");
  WindRecord u = record_of(all[0]), v = record_of(all[1]);
  if (u.parameter == 3 && v.parameter == 2) std::swap(u, v);
  if (u.parameter != 2 || v.parameter != 3)
    fail("records", "are not eastward (2) and northward (3)", "give these two alone");
  if (u.nx != v.nx || u.ny != v.ny || u.lo1 != v.lo1 || u.la1 != v.la1 || u.lo2 != v.lo2 ||
      u.la2 != v.la2)
    fail("records", "have different grids", "give one grid");
  file.field = "wind";
  PlaneGrid grid{static_cast<std::size_t>(u.nx), static_cast<std::size_t>(u.ny), {}, {}};
  for (std::size_t j = 0; j < grid.ny; ++j)
    for (std::size_t i = 0; i < grid.nx; ++i) {
      const double a = static_cast<double>(i) / (u.nx - 1), b = static_cast<double>(j) / (u.ny - 1);
      grid.points.push_back({u.lo1 + a * (u.lo2 - u.lo1), u.la1 + b * (u.la2 - u.la1)});
      const std::size_t k = j * grid.nx + i;
      grid.vectors.push_back({value((*u.data)[k]), value((*v.data)[k])});
    }
  return grid;
}

}  // namespace crest::io
