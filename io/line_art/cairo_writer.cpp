// SPDX-License-Identifier: GPL-3.0-or-later
// PDF and EPS by cairo.
#include <cairo/cairo-pdf.h>
#include <cairo/cairo-ps.h>

#include <memory>
#include <stdexcept>

#include "io/line_art/drawing_writer.hpp"

namespace crest::io {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr double kError = 0.01;                        // mm, of outlines
constexpr const char* kDate = "1970-01-01T00:00:00Z";  // the same bytes every time

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void fill(cairo_t* context, const std::vector<line_art::Vec2>& polygon, double grey) {
  if (polygon.empty()) return;
  cairo_set_source_rgb(context, grey, grey, grey);
  for (const auto& p : line_art::simplified(polygon, kError)) cairo_line_to(context, p[0], p[1]);
  cairo_close_path(context);
  cairo_fill(context);
}

void fill(cairo_t* context, const line_art::Stroke& stroke) {
  if (stroke.band > 0) fill(context, line_art::band_outline(stroke), 1);
  fill(context, line_art::outline(stroke), 0);
}

/// Paints on a surface that appends to `bytes` and finishes it.
void paint(cairo_surface_t* raw, const line_art::Drawing& drawing) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      raw, cairo_surface_destroy);
  {
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(raw),
                                                                     cairo_destroy);
    cairo_scale(context.get(), kPointsPerMm, kPointsPerMm);
    for (const line_art::Stroke& s : drawing.hatches) fill(context.get(), s);
    for (const line_art::Stroke& s : drawing.lines.strokes) fill(context.get(), s);
    cairo_show_page(context.get());
  }
  cairo_surface_finish(raw);
  if (const cairo_status_t status = cairo_surface_status(raw); status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

}  // namespace

std::string pdf_of(const line_art::Drawing& drawing) {
  std::string bytes;
  cairo_surface_t* const surface =
      cairo_pdf_surface_create_for_stream(append_bytes, &bytes, drawing.view.page[0] * kPointsPerMm,
                                          drawing.view.page[1] * kPointsPerMm);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, kDate);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, drawing.parameters.c_str());
  paint(surface, drawing);
  return bytes;
}

std::string eps_of(const line_art::Drawing& drawing) {
  std::string bytes;
  cairo_surface_t* const surface =
      cairo_ps_surface_create_for_stream(append_bytes, &bytes, drawing.view.page[0] * kPointsPerMm,
                                         drawing.view.page[1] * kPointsPerMm);
  cairo_ps_surface_set_eps(surface, 1);
  paint(surface, drawing);
  // Cairo knows no other date than today's.
  constexpr std::string_view key = "%%CreationDate:";
  if (const std::size_t at = bytes.find(key); at != std::string::npos)
    bytes.replace(at, bytes.find('\n', at) - at, std::string(key) + " " + kDate);
  return bytes;
}

}  // namespace crest::io
