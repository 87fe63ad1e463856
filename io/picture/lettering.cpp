// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/lettering.hpp"

#include <cairo/cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace crest::io {
namespace {

constexpr Rgb kInk = {40, 40, 44};

/// A mask to write on, in samples, with the font set.
class Page {
 public:
  Page(int width, int height, double size)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height), cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_select_font_face(context(), "@cairo:", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context(), size);
    const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
        cairo_font_options_create(), cairo_font_options_destroy);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context(), options.get());
  }

  double width_of(const std::string& text) const {
    cairo_text_extents_t extents;
    cairo_text_extents(context(), text.c_str(), &extents);
    require_sound();
    return extents.x_advance;
  }

  Mask write(double x, double baseline, const std::string& text) const {
    cairo_move_to(context(), x, baseline);
    cairo_show_text(context(), text.c_str());
    cairo_surface_flush(surface_.get());
    require_sound();
    return {cairo_image_surface_get_data(surface_.get()),
            cairo_image_surface_get_width(surface_.get()),
            cairo_image_surface_get_height(surface_.get()),
            cairo_image_surface_get_stride(surface_.get())};
  }

 private:
  cairo_t* context() const { return context_.get(); }
  void require_sound() const {
    const cairo_status_t status = cairo_status(context());
    if (status != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error(std::string("cairo cannot write: ") +
                               cairo_status_to_string(status));
  }

  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

}  // namespace

double text_width(const std::string& text, double size) {
  return Page(1, 1, size).width_of(text);
}

void draw_text(Canvas& canvas, double x, double y, double size, const std::string& text) {
  // The page starts at a whole sample.
  const double left = std::floor(x * kSamples), base = std::floor(y * kSamples);
  const double height = std::ceil(1.2 * size * kSamples), below = std::ceil(0.4 * size * kSamples);
  const double width = std::ceil((text_width(text, size) + size) * kSamples);
  const Page page(static_cast<int>(width), static_cast<int>(height + below), size * kSamples);
  canvas.stamp(static_cast<int>(left), static_cast<int>(base - height),
               page.write(x * kSamples - left, height + (y * kSamples - base), text), kInk);
}

}  // namespace crest::io
