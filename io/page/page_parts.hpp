// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The page's own files (page.html, page.css and the scripts), put into strings by the build.

namespace crest::io {

const char* page_markup();
const char* page_style();
const char* page_script();

}  // namespace crest::io
