// SPDX-License-Identifier: GPL-3.0-or-later
// crest lineart.
#include <stdexcept>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/line_art/certificate.hpp"
#include "algorithms/line_art/line_art.hpp"
#include "algorithms/line_art/sheets.hpp"
#include "bindings/python/systems.hpp"
#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "io/line_art/view_choice.hpp"

namespace crest::python {
namespace {

line_art::HatchOptions hatch_options(const Arguments& a) {
  line_art::HatchOptions o;
  o.style = a.text("style") == "streamlines" ? line_art::HatchStyle::streamlines
                                             : line_art::HatchStyle::fishbone;
  o.cross_field = a.text("field") == "cross";
  o.tone_style = a.text("tone") == "bands"    ? line_art::ToneStyle::bands
                 : a.text("tone") == "length" ? line_art::ToneStyle::length
                                              : line_art::ToneStyle::width;
  o.cross_hatch = a.flag("cross_hatch");
  o.tone.spacing = a.number("spacing");
  o.smooth = a.number("smooth");
  o.crease = a.maybe_number("crease");
  if (const auto light = a.maybe_numbers<3>("light")) o.light.light = *light;
  if (const auto tones = a.maybe_numbers<2>("tones")) {
    o.tone.darkest = (*tones)[0];
    o.tone.brightest = (*tones)[1];
  }
  return o;
}

void add_hatches(const Arguments& a, const std::vector<kernel::Vec3>& points,
                 const std::vector<kernel::Triangle>& faces, const Progress& progress,
                 line_art::Drawing& drawing) {
  const kernel::TriangleMesh mesh(points, faces);
  const curvature::Result estimate =
      progress.step("curvature", [&] { return curvature::estimate(mesh, {}); });
  std::vector<line_art::PrincipalFrame> frames;
  for (kernel::Index v = 0; v < mesh.vertex_count(); ++v) {
    const curvature::PointCurvature& c = estimate.vertices[v];
    frames.push_back({c.k1, c.k2, c.d1, c.d2, estimate.normals[v]});
  }
  line_art::add_hatches(
      drawing, mesh, frames, hatch_options(a),
      [&](const char* name, const std::function<void()>& part) { progress.step(name, part); });
}

}  // namespace

Output run_lineart(const Arguments& a, const Progress& progress) {
  const auto points = a.rows<3>("V");
  const auto faces = a.cells<3>("F", points.size());
  const io::ViewChoice view{a.maybe_numbers<2>("view"), a.maybe_numbers<3>("up"),
                            a.maybe_numbers<6>("camera"), a.maybe_number("perspective"),
                            a.number("width")};
  line_art::Drawing drawing;
  drawing.scene = line_art::weld(points, faces);
  drawing.view = line_art::make_view(io::view_request(view, drawing.scene), drawing.scene);
  drawing.contours = progress.step("contours", [&] {
    return line_art::find_contours(drawing.scene, drawing.view, {a.maybe_number("crease")});
  });
  drawing.lines = progress.step("strokes of contours", [&] {
    return line_art::draw_contours(drawing.scene, drawing.view, drawing.contours,
                                   {a.number("line_width")});
  });
  if (a.text("style") != "contours") {
    drawing.one_sheet = progress.step("faces through one another",
                                      [&] { return !line_art::meeting_faces(drawing.scene); });
    add_hatches(a, points, faces, progress, drawing);
  }
  drawing.title = a.text("title");
  Output out;
  if (a.flag("certificate"))
    out.values["data_digest"] = progress.step("composing the certificate", [&] {
      auto bytes = certify::encode(line_art::line_art_record(drawing));
      if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
        throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
      return out.certify(std::move(bytes));
    });
  out.geometries["geometry"] = io::geometry_of(io::drawing_poly_data(drawing));
  out.values["svg"] = io::svg_of(drawing);
  out.values["sheets"] = std::string(drawing.one_sheet ? "proved" : "not claimed");
  return out;
}

}  // namespace crest::python
