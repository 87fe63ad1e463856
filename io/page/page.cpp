// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/page.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "io/page/page_parts.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/finite.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using Json = nlohmann::ordered_json;

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("a page's scene: ") + what);
}

std::string base64(std::string_view bytes) {
  constexpr std::size_t kPiece = 3 << 20;  // no padding but at the end; lengths are ints there
  std::string text, piece(4 * kPiece / 3 + 1, '\0');
  for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
    const std::string_view part = bytes.substr(at, kPiece);
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(piece.data()),
                                       reinterpret_cast<const unsigned char*>(part.data()),
                                       static_cast<int>(part.size()));
    text.append(piece, 0, static_cast<std::size_t>(length));
  }
  return text;
}

/// How a content security policy names a script or a style.
std::string policy_digest(std::string_view text) {
  std::string digest(EVP_MAX_MD_SIZE, '\0');
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), reinterpret_cast<unsigned char*>(digest.data()), &size,
                 EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL has no SHA-256");
  digest.resize(size);
  return "'sha256-" + base64(digest) + "'";
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6) != Z_OK)
    throw std::bad_alloc();
  out.resize(size);
  return out;
}

/// All arrays behind one another, little-endian, each from a multiple of eight bytes on.
class Arrays {
 public:
  /// Shapes: what the page needs to find it: [type, offset, count].
  template <class T>
  Json add(const char* type, const std::vector<T>& values) {
    const std::size_t at = reserve(values.size() * sizeof(T));
    if (!values.empty()) std::memcpy(bytes_.data() + at, values.data(), values.size() * sizeof(T));
    return {type, at, values.size()};
  }
  Json numbers(const std::string& what, const std::vector<double>& values) {
    for (const double x : values) require_finite(x, what);
    return add("f64", values);
  }
  /// As differences modulo 2^32, which deflate better.
  Json indices(const std::vector<std::uint32_t>& values) {
    std::vector<std::uint32_t> differences;
    differences.reserve(values.size());
    std::uint32_t last = 0;
    for (const std::uint32_t i : values) {
      differences.push_back(i - last);
      last = i;
    }
    return add("d32", differences);
  }
  Json bytes(const std::string& bytes) {
    bytes_.replace(reserve(bytes.size()), bytes.size(), bytes);
    return {"u8", bytes_.size() - padded(bytes.size()), bytes.size()};
  }
  const std::string& all() const { return bytes_; }

 private:
  static std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }
  std::size_t reserve(std::size_t size) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + padded(size), '\0');
    return at;
  }
  std::string bytes_;
};

std::string hex(Rgb c) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red, c.green, c.blue);
  return text;
}

/// The middle and half the diagonal of everything: the page's units.
struct Frame {
  kernel::Vec3 centre{0, 0, 0};
  double radius = 1;
};

Frame frame_of(const Scene& scene) {
  kernel::Vec3 least{HUGE_VAL, HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  const auto reach = [&](const std::vector<kernel::Vec3>& places) {
    for (const kernel::Vec3& p : places) {
      for (std::size_t k = 0; k < 3; ++k) {
        require_finite(p[k], "place");
        least[k] = std::min(least[k], p[k]);
        most[k] = std::max(most[k], p[k]);
      }
    }
  };
  for (const SceneSurface& surface : scene.surfaces) reach(surface.points);
  for (const SceneLayer& layer : scene.layers) reach(layer.places);
  Frame frame;
  if (least[0] > most[0]) return frame;
  const kernel::Vec3 half = combine(0.5, most, -0.5, least);
  frame.centre = combine(0.5, least, 0.5, most);
  const double radius = std::hypot(half[0], half[1], half[2]);
  if (radius > 0) frame.radius = radius;
  return frame;
}

Json surface_json(const SceneSurface& surface, const Frame& frame, Arrays& arrays) {
  std::vector<float> points;
  points.reserve(3 * surface.points.size());
  for (const kernel::Vec3& p : surface.points)
    for (std::size_t k = 0; k < 3; ++k)
      points.push_back(static_cast<float>((p[k] - frame.centre[k]) / frame.radius));
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * surface.faces.size());
  for (const kernel::Triangle& f : surface.faces) {
    for (const kernel::Index v : f) {
      require(v < surface.points.size(), "a face has a corner that is not there");
      corners.push_back(v);
    }
  }
  constexpr const char* kMaps[] = {"sequential", "diverging", "pale", "grey", "labels"};
  Json fields = Json::array();
  for (const SceneField& field : surface.fields) {
    require(field.values.size() == (field.per_face ? surface.faces.size() : surface.points.size()),
            "a field's length");
    fields.push_back({{"name", field.name},
                      {"face", field.per_face},
                      {"map", kMaps[static_cast<std::size_t>(field.map)]},
                      {"values", arrays.numbers(field.name, field.values)}});
  }
  return {{"name", surface.name},
          {"colour", surface.colour ? Json(hex(*surface.colour)) : Json()},
          {"opacity", surface.opacity},
          {"coloured", surface.coloured},
          {"points", arrays.add("f32", points)},
          {"faces", arrays.indices(corners)},
          {"fields", fields}};
}

Json columns_json(const SceneLayer& layer, Arrays& arrays) {
  Json columns = Json::array();
  for (const auto& array : layer.rows.arrays()) {
    require(array->GetNumberOfTuples() == static_cast<vtkIdType>(layer.item_count),
            "a column's length");
    Json column = {{"name", array->GetName()}};
    if (auto* texts = vtkStringArray::SafeDownCast(array)) {
      column["texts"] = Json::array();
      for (vtkIdType i = 0; i < texts->GetNumberOfTuples(); ++i)
        column["texts"].push_back(std::string(texts->GetValue(i)));
    } else {
      std::vector<double> values;
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        values.push_back(array->GetVariantValue(i).ToDouble());
      column["values"] = arrays.numbers(array->GetName(), values);
      for (const SceneWords& words : layer.words)
        if (words.column == array->GetName()) column["words"] = words.words;
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

Json layer_json(const SceneLayer& layer, Arrays& arrays) {
  Json kinds = Json::array(), filters = Json::array();
  for (const SceneKind& kind : layer.kinds) {
    kinds.push_back({{"label", kind.label},
                     {"colour", hex(kind.colour)},
                     {"width", kind.width},
                     {"shown", kind.shown}});
  }
  for (const SceneFilter& filter : layer.filters) {
    filters.push_back({{"column", filter.column},
                       {"label", filter.label},
                       {"start", filter.start ? Json(*filter.start) : Json()}});
  }
  std::vector<std::uint32_t> items, kind_of, first;
  for (const SceneLayer::Run& run : layer.runs) {
    require(run.item < layer.item_count && run.kind < layer.kinds.size() &&
                run.first < layer.places.size(),
            "a run names what is not there");
    items.push_back(run.item);
    kind_of.push_back(run.kind);
    first.push_back(run.first);
  }
  std::vector<double> places;
  places.reserve(3 * layer.places.size());
  for (const kernel::Vec3& p : layer.places) places.insert(places.end(), p.begin(), p.end());
  return {{"name", layer.name},
          {"count", layer.item_count},
          {"kinds", kinds},
          {"filters", filters},
          {"columns", columns_json(layer, arrays)},
          {"items", arrays.indices(items)},
          {"runs", arrays.indices(kind_of)},
          {"first", arrays.indices(first)},
          {"places", arrays.add("f64", places)}};
}

Camera camera_of(const Scene& scene) {
  if (scene.camera) return *scene.camera;
  for (const SceneSurface& surface : scene.surfaces)
    if (!surface.faces.empty())
      return make_camera(SurfaceView(surface.points, surface.faces), {}, 1200);
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, 1, 1200, 1200};
}

Json scene_json(const Scene& scene, const PageContext& context, Arrays& arrays) {
  const Frame frame = frame_of(scene);
  Json surfaces = Json::array(), layers = Json::array();
  for (const SceneSurface& surface : scene.surfaces)
    surfaces.push_back(surface_json(surface, frame, arrays));
  for (const SceneLayer& layer : scene.layers) layers.push_back(layer_json(layer, arrays));
  const Camera camera = camera_of(scene);  // of surfaces that are checked by now
  return {
      {"title", scene.title},
      {"command", context.command},
      {"version", context.version},
      {"summary", context.summary},
      {"warnings", context.warnings},
      {"note", scene.note},
      {"digest", scene.data_digest},
      {"flat", scene.flat},
      {"right", camera.right},
      {"up", camera.up},
      {"forward", camera.forward},
      {"centre", frame.centre},
      {"radius", frame.radius},
      {"surfaces", surfaces},
      {"layers", layers},
      {"certificate", context.certificate.empty() ? Json() : arrays.bytes(context.certificate)}};
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// JSON as the content of a <script>: without a `<` nothing in it ends the element or starts a
/// comment. Bytes that are no UTF-8 become U+FFFD.
std::string embedded(const Json& json) {
  return replaced(json.dump(-1, ' ', false, Json::error_handler_t::replace), "<", "\\u003c");
}

/// Fills the first `slot` of `page`.
void fill(std::string& page, std::string_view slot, std::string_view text) {
  const std::size_t at = page.find(slot);
  require(at != std::string::npos, "the template lacks a slot");
  page.replace(at, slot.size(), text);
}

}  // namespace

std::string page_bytes(const Scene& scene, const PageContext& context, const std::string& checker) {
  Arrays arrays;
  const std::string json = embedded(scene_json(scene, context, arrays));
  const bool verifies = !checker.empty() && !context.certificate.empty();
  // A script's text cannot hold its own end; in JavaScript's strings \/ is /.
  const std::string safe_checker = verifies ? replaced(checker, "</", "<\\/") : "";
  std::string policy = "default-src 'none'; script-src " + policy_digest(page_script()) +
                       "; style-src " + policy_digest(page_style()) + "; img-src data: blob:";
  if (verifies) {
    policy = replaced(policy, "; style-src", " 'wasm-unsafe-eval' blob:; style-src") +
             "; worker-src blob:";
  }
  policy += "; base-uri 'none'; form-action 'none'";
  std::string page = page_markup();
  // From the last slot to the first, so that none is looked for in what came from a file.
  fill(page, "@SCRIPT@", page_script());
  fill(page, "@CHECKER@", safe_checker);
  fill(page, "@DATA@", base64(deflated(arrays.all())));
  fill(page, "@SCENE@", json);
  fill(page, "@STYLE@", page_style());
  fill(page, "@POLICY@", policy);
  return page;
}

std::string page_checker() {
  const char* named = std::getenv("CREST_VERIFY_JS");
  const std::string path = named && *named ? named : CREST_VERIFY_JS;
  if (path.empty()) return "";
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (file && !text.str().empty()) return text.str();
  if (named && *named)
    throw kernel::InputError(path +
                             ": file: cannot be read; CREST_VERIFY_JS names the checker "
                             "that pages carry, unset it to have none");
  return "";
}

void write_page(const std::string& path, const Scene& scene, const PageContext& context) {
  write_atomically(path,
                   page_bytes(scene, context, context.certificate.empty() ? "" : page_checker()));
}

}  // namespace crest::io
