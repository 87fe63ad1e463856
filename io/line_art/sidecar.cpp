// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/line_art/sidecar.hpp"

#include <nlohmann/json.hpp>

#include "io/formats/files.hpp"

namespace crest::io {
namespace {

using Json = nlohmann::ordered_json;
using namespace line_art;
using Field = Region::Field;

constexpr const char* kFields[] = {"max", "min", "angle", "coons", "off"};

Json view_json(const View& view) {
  Json json = {{"parallel", !view.eye.finite},
               {"eye", view.eye.at},
               {"up", view.up},
               {"x", view.x},
               {"y", view.y},
               {"z", view.z},
               {"origin", view.origin},
               {"scale", view.scale},
               {"page", view.page}};
  return json;
}

Json field_json(const Region& region) {
  if (region.field == Field::angle) return {{"angle", region.angle}};
  if (region.field == Field::coons) return {{"coons", region.coons}};
  return kFields[static_cast<std::size_t>(region.field)];
}

Json segments_json(const Drawing& drawing) {
  Json list = Json::array();
  for (const Region& region : drawing.regions) {
    Json item = {{"id", list.size()}, {"rings", region.rings}, {"field", field_json(region)}};
    if (region.tones) item["tones"] = *region.tones;
    if (region.gauss > 0) item["filter"] = {{"gauss", region.gauss}};
    if (region.median > 0) item["filter"]["median"] = region.median;
    list.push_back(std::move(item));
  }
  for (const Segment& s : drawing.segments)
    list.push_back({{"id", list.size()}, {"backbone", s.backbone}, {"key_ribs", s.key_ribs}});
  return list;
}

const char* kind_of(const ContourEdge& e) {
  return e.crease ? "crease" : e.boundary ? "boundary" : "contour";
}

Json contours_json(const Drawing& drawing) {
  Json list = Json::array();
  for (const ContourEdge& e : drawing.contours.edges) {
    Json pieces = Json::array();
    for (Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
      const Piece& p = drawing.contours.pieces[i];
      pieces.push_back({p.from, p.to, p.in_front - p.touching});
    }
    list.push_back({{"a", drawing.scene.input_vertex[e.a]},
                    {"b", drawing.scene.input_vertex[e.b]},
                    {"kind", kind_of(e)},
                    {"pieces", std::move(pieces)}});
  }
  return list;
}

void add_strokes(const std::vector<Stroke>& strokes, Json& list) {
  for (const Stroke& s : strokes)
    list.push_back({{"kind", name_of(s.kind)},
                    {"segment", s.segment == kNone ? Json() : Json(s.segment)},
                    {"points", s.points},
                    {"widths", s.widths}});
}

/// Errors name the element they are in.
class Reader {
 public:
  explicit Reader(std::string element) : element_(std::move(element)) {}
  [[noreturn]] void refuse(const std::string& problem) const {
    fail(element_, problem, "save the sidecar again and edit that");
  }
  double number(const Json& json, const char* what) const {
    if (!json.is_number()) refuse(std::string(what) + " is no number");
    const double x = json.get<double>();
    if (!std::isfinite(x)) refuse(std::string(what) + " is not finite");
    return x;
  }
  template <std::size_t N>
  std::array<double, N> numbers(const Json& json, const char* what) const {
    if (!json.is_array() || json.size() != N)
      refuse(std::string(what) + " is not a list of " + std::to_string(N) + " numbers");
    std::array<double, N> x;
    for (std::size_t k = 0; k < N; ++k) x[k] = number(json[k], what);
    return x;
  }
  std::vector<Vec2> line(const Json& json, const char* what, std::size_t least) const {
    if (!json.is_array() || json.size() < least)
      refuse(std::string(what) + " has fewer than " + std::to_string(least) + " points");
    std::vector<Vec2> points;
    for (const Json& p : json) points.push_back(numbers<2>(p, what));
    return points;
  }

 private:
  std::string element_;
};

void read_field(const Reader& reader, const Json& json, Region& region) {
  if (json.is_string()) {
    const std::string word = json.get<std::string>();
    for (std::size_t k = 0; k < std::size(kFields); ++k)
      if (word == kFields[k] && word != "angle" && word != "coons") {
        region.field = static_cast<Field>(k);
        return;
      }
    reader.refuse("the field '" + word + "' is none of max, min, off");
  }
  if (json.is_object() && json.contains("angle")) {
    region.field = Field::angle;
    region.angle = reader.number(json["angle"], "the angle");
  } else if (json.is_object() && json.contains("coons") && json["coons"].is_array() &&
             json["coons"].size() == 4) {
    region.field = Field::coons;
    for (std::size_t k = 0; k < 4; ++k)
      region.coons[k] = reader.line(json["coons"][k], "a curve of the Coons patch", 2);
  } else {
    reader.refuse("the field is neither a word, an angle nor four curves");
  }
}

Region read_region(const Reader& reader, const Json& json) {
  Region region;
  if (json.contains("rings")) {
    if (!json["rings"].is_array()) reader.refuse("the rings are no list");
    for (const Json& ring : json["rings"]) region.rings.push_back(reader.line(ring, "a ring", 3));
  }
  if (json.contains("field")) read_field(reader, json["field"], region);
  if (json.contains("tones")) {
    region.tones = reader.numbers<2>(json["tones"], "tones");
    if (!(0 <= (*region.tones)[0] && (*region.tones)[0] <= (*region.tones)[1] &&
          (*region.tones)[1] <= 1))
      reader.refuse("the tones do not ascend within 0 to 1");
  }
  if (json.contains("filter")) {
    const Json& filter = json["filter"];
    const auto size = [&](const char* name) {
      const double x = filter.contains(name) ? reader.number(filter[name], name) : 0;
      if (x < 0 || x > 10) reader.refuse("the filter's size is not within 0 to 10 mm");
      return x;
    };
    if (!filter.is_object()) reader.refuse("the filter is no object");
    region.gauss = size("gauss");
    region.median = size("median");
  }
  return region;
}

void require_same_view(const Json& json, const View& view) {
  const Json own = view_json(view);
  if (!json.is_object()) fail("view", "is missing", "save the sidecar again");
  for (const auto& [key, value] : own.items())
    if (!json.contains(key) || json[key] != value)
      fail("view", "'" + key + "' is that of another view",
           "draw from the view the sidecar was saved with, or save one from this view");
}

}  // namespace

std::string sidecar_of(const Drawing& drawing) {
  Json json;
  json["view"] = view_json(drawing.view);
  json["segments"] = segments_json(drawing);
  json["contours"] = contours_json(drawing);
  json["strokes"] = Json::array();
  add_strokes(drawing.hatches, json["strokes"]);
  add_strokes(drawing.lines.strokes, json["strokes"]);
  json["suppressed"] = {{"count", drawing.lines.suppressed},
                        {"length", drawing.lines.suppressed_length}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Steering read_sidecar(const std::string& path, const View& view) {
  Steering steering;
  read_named(path, [&] {
    const FileBytes bytes = load(path);
    const Json json = Json::parse(std::string_view(bytes), nullptr, false);
    if (json.is_discarded() || !json.is_object())
      fail("file", "is no JSON object", "give a file written by --save-sidecar");
    require_same_view(json.contains("view") ? json["view"] : Json(), view);
    if (!json.contains("segments")) return;
    if (!json["segments"].is_array()) fail("segments", "are no list", "save the sidecar again");
    for (std::size_t k = 0; k < json["segments"].size(); ++k) {
      const Reader reader("segment " + std::to_string(k));
      const Json& item = json["segments"][k];
      if (!item.is_object()) reader.refuse("is no object");
      if (!item.contains("backbone")) {
        steering.regions.push_back(read_region(reader, item));
        continue;
      }
      Segment segment{reader.line(item["backbone"], "the backbone", 2), {}};
      if (item.contains("key_ribs") && !item["key_ribs"].is_array())
        reader.refuse("key_ribs are no list");
      if (item.contains("key_ribs"))
        for (const Json& arc : item["key_ribs"])
          segment.key_ribs.push_back(reader.number(arc, "a key rib"));
      steering.segments.push_back(std::move(segment));
    }
  });
  return steering;
}

}  // namespace crest::io
