// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing as SVG by hand: other writers lose groups and data.
#include "io/line_art/drawing_writer.hpp"
#include "io/write/text.hpp"

namespace crest::io {
namespace {

using line_art::Stroke, line_art::StrokeKind;

constexpr double kOutlineError = 0.01;  // mm, of outlines

/// Text between tags.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  return result;
}

/// In steps of a micrometre, without zeros at the end and -0.
void add_number(Text& text, double x) {
  const double rounded = std::round(x * 1000) / 1000 + 0.0;
  text.add("{:.6g}", rounded);
}

void add_stroke(Text& text, const Stroke& stroke, bool band = false) {
  if (!band && stroke.band > 0) add_stroke(text, stroke, true);
  const auto polygon = line_art::simplified(
      band ? line_art::band_outline(stroke) : line_art::outline(stroke), kOutlineError);
  if (polygon.empty()) return;
  text.add("<path");
  if (band) text.add(" fill=\"#fff\"");
  if (stroke.segment != line_art::kNone) text.add(" data-segment=\"{}\"", stroke.segment);
  text.add(" data-rank=\"{}\" d=\"M", stroke.rank);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (i > 0) text.add("{}", i == 1 ? "L" : " ");
    add_number(text, polygon[i][0]);
    text.add(" ");
    add_number(text, polygon[i][1]);
  }
  text.add("Z\"/>\n");
}

void add_group(Text& text, const char* name, const std::vector<Stroke>& strokes, bool cross,
               bool contours) {
  text.add("<g id=\"{}\">\n", name);
  for (const Stroke& s : strokes)
    if (contours || (s.kind == StrokeKind::cross) == cross) add_stroke(text, s);
  text.add("</g>\n");
}

}  // namespace

std::string svg_of(const line_art::Drawing& drawing) {
  Text text;
  const auto& page = drawing.view.page;
  text.add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" ",
           page[0], page[1]);
  text.add("viewBox=\"0 0 {:.3f} {:.3f}\">\n", page[0], page[1]);
  text.add("<title>{}</title>\n<desc>{}</desc>\n", escaped(drawing.title),
           escaped(drawing.parameters));
  text.add("<rect id=\"page\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
  add_group(text, "hatch", drawing.hatches, false, false);
  add_group(text, "cross-hatch", drawing.hatches, true, false);
  add_group(text, "contours", drawing.lines.strokes, false, true);
  text.add("</svg>\n");
  return text.text();
}

}  // namespace crest::io
