// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of pages. That browsers show them is the matter of scripts/test_page.sh.
#include "io/page/page.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>

#include "kernel/geometry/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::io;
using crest::kernel::Vec3;
using Json = nlohmann::json;
using crest::tests::TemporaryFolder;

/// The content of the element with this id.
std::string content(const std::string& page, const std::string& id) {
  const std::size_t at = page.find("id=\"" + id + "\">");
  REQUIRE(at != std::string::npos);
  const std::size_t from = page.find('>', at) + 1;
  return page.substr(from, page.find("</script", from) - from);
}

Json scene_of(const std::string& page) {
  return Json::parse(content(page, "scene"));
}

std::string decoded(const std::string& base64) {
  std::string bytes(base64.size() / 4 * 3, '\0');
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                   reinterpret_cast<const unsigned char*>(base64.data()),
                                   static_cast<int>(base64.size()));
  REQUIRE(size == static_cast<int>(bytes.size()));
  return bytes;
}

std::string arrays_of(const std::string& page) {
  const std::string packed = decoded(content(page, "data"));
  std::string bytes(16 << 20, '\0');
  uLongf size = bytes.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                     reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
  bytes.resize(size);
  return bytes;
}

template <class T>
std::vector<T> array_of(const std::string& page, const Json& place) {
  std::vector<T> values(place[2].get<std::size_t>());
  const std::string all = arrays_of(page);
  REQUIRE(place[1].get<std::size_t>() + values.size() * sizeof(T) <= all.size());
  std::memcpy(values.data(), all.data() + place[1].get<std::size_t>(), values.size() * sizeof(T));
  return values;
}

std::string policy_of(const std::string& page) {
  const std::string start = "Content-Security-Policy\" content=\"";
  const std::size_t at = page.find(start) + start.size();
  return page.substr(at, page.find('"', at) - at);
}

std::string digest(const std::string& text) {
  unsigned char bytes[EVP_MAX_MD_SIZE], base64[2 * EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  EVP_Digest(text.data(), text.size(), bytes, &size, EVP_sha256(), nullptr);
  EVP_EncodeBlock(base64, bytes, static_cast<int>(size));
  return "'sha256-" + std::string(reinterpret_cast<char*>(base64)) + "'";
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++n;
  return n;
}

/// n x n squares, and as many lines as rows.
Scene sheet(crest::kernel::Index n) {
  Scene scene{"Sheet"};
  SceneSurface surface{"sheet", {}, {}};
  SceneField height{"height", {}}, face{"face", {}, true, ColourMap::labels};
  SceneLayer rows{"Rows", {{"row", {10, 20, 30}}}, {{"length", "length"}}};
  for (crest::kernel::Index y = 0; y <= n; ++y) {
    std::vector<Vec3> line;
    for (crest::kernel::Index x = 0; x <= n; ++x) {
      const Vec3 p{x / 7.0, y / 3.0, std::sin(0.1 * x * y)};
      line.push_back(p);
      surface.points.push_back(p);
      height.values.push_back(p[2]);
      if (x == n || y == n) continue;
      const auto at = y * (n + 1) + x;
      surface.faces.push_back({at, at + 1, at + n + 2});
      surface.faces.push_back({at, at + n + 2, at + n + 1});
    }
    rows.add_item().add("length", y / 3.0);
    rows.add_line(line, false, [](std::size_t) { return 0; });
  }
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    face.values.push_back(static_cast<double>(f % 9));
  surface.fields = {height, face};
  scene.surfaces.push_back(surface);
  scene.layers.push_back(rows);
  return scene;
}

}  // namespace

TEST_CASE("page: numbers come back as they were, single precision where the page says so") {
  Scene scene = sheet(5);
  const SceneSurface surface = scene.surfaces[0];
  const std::string page = page_bytes(scene, {"crest test", "1", "words\n", {"careful"}, ""});
  const Json json = scene_of(page);
  CHECK(json["title"] == "Sheet");
  CHECK(json["command"] == "crest test");
  CHECK(json["warnings"] == Json{"careful"});
  CHECK(json["certificate"].is_null());
  const Json& field = json["surfaces"][0]["fields"][0];
  CHECK(field["name"] == "height");
  CHECK(array_of<double>(page, field["values"]) == surface.fields[0].values);
  const auto points = array_of<float>(page, json["surfaces"][0]["points"]);
  REQUIRE(points.size() == 3 * surface.points.size());
  const double radius = json["radius"];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double back = json["centre"][i % 3].get<double>() + radius * points[i];
    CHECK(std::abs(back - surface.points[i / 3][i % 3]) <= 1e-7 * radius);
    CHECK(std::abs(points[i]) <= 1);
  }
  auto corners = array_of<std::uint32_t>(page, json["surfaces"][0]["faces"]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i > 0) corners[i] += corners[i - 1];
    CHECK(corners[i] == surface.faces[i / 3][i % 3]);
  }
  const Json& layer = json["layers"][0];
  CHECK(layer["count"] == 6);
  CHECK(array_of<double>(page, layer["places"]).size() == 3 * scene.layers[0].places.size());
  CHECK(array_of<double>(page, layer["columns"][0]["values"])[4] == 4 / 3.0);
  CHECK(layer["filters"][0]["column"] == "length");
}

TEST_CASE(
    "page: the policy allows the page's own script and style by their digests, nothing else") {
  const Scene scene = sheet(2);
  for (const std::string checker : {"", "globalThis.crestVerify = 1; // </script>"}) {
    for (const std::string certificate : {"", "proof"}) {
      const std::string page = page_bytes(scene, {"", "", "", {}, certificate}, checker);
      const std::string policy = policy_of(page);
      INFO(policy);
      const bool verifies = !checker.empty() && !certificate.empty();
      CHECK(policy.rfind("default-src 'none'; ", 0) == 0);
      CHECK(policy.find("unsafe-inline") == std::string::npos);
      CHECK(policy.find("connect-src") == std::string::npos);
      CHECK((policy.find("wasm-unsafe-eval") != std::string::npos) == verifies);
      CHECK((policy.find("worker-src blob:") != std::string::npos) == verifies);
      const std::size_t script = page.rfind("<script>") + 8;
      CHECK(policy.find(digest(page.substr(script, page.rfind("</script>") - script))) !=
            std::string::npos);
      const std::size_t style = page.find("<style>") + 7;
      CHECK(policy.find(digest(page.substr(style, page.find("</style>") - style))) !=
            std::string::npos);
      CHECK(content(page, "checker") ==
            (verifies ? "globalThis.crestVerify = 1; // <\\/script>" : ""));
      // Nothing that a browser would fetch.
      for (const char* fetched : {"src=", "href=", "http:", "https:", "@import", "url("})
        CHECK(page.find(fetched) == std::string::npos);
      CHECK(count(page, "<script") == 4);
      CHECK(count(page, "</script") == 4);
    }
  }
}

TEST_CASE("page: words from files stay words") {
  const std::string hostile =
      "</script><script>alert(1)</script><!--\x01\xff\"'&@DATA@\xe2\x82\xac";
  Scene scene = sheet(2);
  scene.title = scene.note = hostile;
  scene.surfaces[0].name = scene.surfaces[0].fields[0].name = hostile;
  scene.layers[0].name = scene.layers[0].kinds[0].label = hostile;
  SceneLayer texts{"Texts", {{"point", {1, 2, 3}}}};
  texts.add_item().add("text", hostile);
  texts.add_run(0, std::vector<Vec3>{{1, 1, 1}});
  scene.layers.push_back(texts);
  const std::string page = page_bytes(scene, {hostile, hostile, hostile, {hostile}, ""});
  CHECK(page.find("alert(1)</script>") == std::string::npos);
  CHECK(count(page, "<script") == 4);
  CHECK(count(page, "<!--") == 0);
  const Json json = scene_of(page);
  const std::string shown =
      "</script><script>alert(1)</script><!--\x01\xef\xbf\xbd\"'&@DATA@\xe2\x82\xac";
  for (const Json& words :
       {json["title"], json["command"], json["summary"], json["warnings"][0], json["note"],
        json["surfaces"][0]["name"], json["surfaces"][0]["fields"][0]["name"],
        json["layers"][0]["kinds"][0]["label"], json["layers"][1]["columns"][0]["texts"][0]})
    CHECK(words == shown);
}

TEST_CASE("page: 20 000 triangles are less than 1 MB, the same bytes each time") {
  const Scene scene = sheet(100);
  REQUIRE(scene.surfaces[0].faces.size() == 20000);
  const std::string page = page_bytes(scene, {});
  CHECK(page.size() < 1000000);
  CHECK(page == page_bytes(sheet(100), {}));
}

TEST_CASE("page: nothing to show, one point, and what a scene may not hold") {
  const Json empty = scene_of(page_bytes(Scene{"Nothing"}, {}));
  CHECK(empty["radius"] == 1);
  CHECK(empty["surfaces"].empty());
  Scene point{"Point"};
  point.layers.push_back({"Points", {{"point", {0, 0, 0}}}});
  point.layers[0].add_item();
  point.layers[0].add_run(0, std::vector<Vec3>{{3, 4, 5}});
  CHECK(scene_of(page_bytes(point, {}))["centre"] == Json{3, 4, 5});

  const auto refused = [](const auto& spoil) {
    Scene scene = sheet(2);
    spoil(scene);
    CHECK_THROWS(page_bytes(scene, {}));
  };
  refused([](Scene& s) { s.surfaces[0].faces[0][1] = 9; });
  refused([](Scene& s) { s.surfaces[0].fields[0].values.pop_back(); });
  refused([](Scene& s) { s.surfaces[0].fields[1].values.push_back(0); });
  refused([](Scene& s) { s.surfaces[0].fields[0].values[0] = NAN; });
  refused([](Scene& s) { s.surfaces[0].points[0][2] = HUGE_VAL; });
  refused([](Scene& s) { s.layers[0].places[0][0] = NAN; });
  refused([](Scene& s) { s.layers[0].runs[0].kind = 1; });
  refused([](Scene& s) { s.layers[0].runs[0].item = 3; });
  refused([](Scene& s) { s.layers[0].item_count = 7; });
}

TEST_CASE("page: lines are divided where their kinds change") {
  SceneLayer layer{"Lines", {{"a", {0, 0, 0}}, {"b", {0, 0, 0}}}};
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<int> kinds = {0, 0, 1, -1};
  layer.add_item();
  layer.add_line(square, true, [&](std::size_t i) { return kinds[i]; });
  REQUIRE(layer.runs.size() == 2);
  CHECK(layer.runs[0].first == 0);
  CHECK(layer.runs[1].first == 3);
  CHECK(layer.places == std::vector<Vec3>{square[0], square[1], square[2], square[2], square[3]});
  layer.add_line(square, true, [](std::size_t) { return 1; });
  CHECK(layer.places.size() == 10);  // it returns to its start
  CHECK(layer.places.back() == square[0]);
  layer.add_line({square[0]}, false, [](std::size_t) { return 0; });
  CHECK(layer.runs.size() == 3);
}

TEST_CASE("page: the checker of the environment, or one line that says that it is not there") {
  const TemporaryFolder folder;
  crest::tests::write_text(folder / "checker.js", "globalThis.crestVerify = null;");
  setenv("CREST_VERIFY_JS", (folder / "checker.js").c_str(), 1);
  CHECK(page_checker() == "globalThis.crestVerify = null;");
  setenv("CREST_VERIFY_JS", (folder / "none.js").c_str(), 1);
  CHECK_THROWS_AS(page_checker(), crest::kernel::InputError);
  unsetenv("CREST_VERIFY_JS");
}
