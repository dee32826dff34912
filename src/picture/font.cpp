// SPDX-License-Identifier: Apache-2.0
#include "picture/font.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include "picture/font_file.hpp"

namespace crossgrain {
namespace {

/// The code points of a UTF-8 text, with question marks for invalid bytes.
std::vector<int> code_points(std::string_view text) {
  std::vector<int> out;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i++]);
    int more = byte < 0x80 ? 0 : byte >> 5 == 6 ? 1 : byte >> 4 == 14 ? 2 : byte >> 3 == 30 ? 3 : -1;
    int code = more <= 0 ? byte : byte & (0x3f >> more);
    for (; more > 0 && i < text.size(); --more)
      code = code << 6 | (static_cast<unsigned char>(text[i++]) & 63);
    out.push_back(more != 0 ? '?' : code);
  }
  return out;
}

}  // namespace

struct Font::Info {
  stbtt_fontinfo font;

  /// Calls use(glyph, place) for every letter, in units of the font. Returns the end of the text.
  template <class Use>
  int for_glyphs(std::string_view text, const Use& use) const {
    int place = 0, before = 0;
    for (const int code : code_points(text)) {
      const int glyph = stbtt_FindGlyphIndex(&font, code);
      if (before != 0) place += stbtt_GetGlyphKernAdvance(&font, before, glyph);
      use(glyph, place);
      int advance = 0, bearing = 0;
      stbtt_GetGlyphHMetrics(&font, glyph, &advance, &bearing);
      place += advance;
      before = glyph;
    }
    return place;
  }

  float scale(double size) const { return stbtt_ScaleForMappingEmToPixels(&font, static_cast<float>(size)); }
};

Font::Font() {
  static Info info;
  if (!stbtt_InitFont(&info.font, reinterpret_cast<const unsigned char*>(font_file().data()), 0))
    throw std::logic_error("the built-in font is damaged");
  info_ = &info;
}

const Font& Font::sans() {
  static const Font font;
  return font;
}

double Font::width(std::string_view text, double size) const {
  return info_->scale(size) * info_->for_glyphs(text, [](int, int) {});
}

double Font::capital_height(double size) const {
  int left = 0, bottom = 0, right = 0, top = 0;
  stbtt_GetCodepointBox(&info_->font, 'H', &left, &bottom, &right, &top);
  return info_->scale(size) * static_cast<float>(top);
}

void Font::draw(std::string_view text, double left, double baseline, double size,
                const std::function<void(int, int, float)>& put) const {
  const float scale = info_->scale(size);
  const double row = std::round(baseline);
  std::vector<unsigned char> coverage;
  info_->for_glyphs(text, [&](int glyph, int place) {
    const double exact = left + static_cast<double>(scale) * place, column = std::floor(exact);
    const auto shift = static_cast<float>(exact - column);
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&info_->font, glyph, scale, scale, shift, 0, &x0, &y0, &x1, &y1);
    const int width = x1 - x0, height = y1 - y0;
    if (width <= 0 || height <= 0) return;
    coverage.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    stbtt_MakeGlyphBitmapSubpixel(&info_->font, coverage.data(), width, height, width, scale, scale, shift, 0,
                                  glyph);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const unsigned char value = coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                             static_cast<std::size_t>(x)];
        if (value > 0) put(static_cast<int>(column) + x0 + x, static_cast<int>(row) + y0 + y, value / 255.0f);
      }
    }
  });
}

}  // namespace crossgrain
