// SPDX-License-Identifier: MIT
#include "render/typeset/fonts.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <hb-ot.h>
#include <hb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

namespace polhode {
namespace {

struct FontFile {
  const char* name;     ///< for people
  const char* file;     ///< below the folder of the fonts
  const char* package;  ///< that has it
};

const FontFile& file_of(int face) {
  static constexpr std::array<FontFile, kFaceCount> kFiles = {{
      {"TeX Gyre Pagella", "tex-gyre/texgyrepagella-regular.otf", "fonts-texgyre"},
      {"TeX Gyre Pagella Italic", "tex-gyre/texgyrepagella-italic.otf", "fonts-texgyre"},
      {"TeX Gyre Pagella Bold", "tex-gyre/texgyrepagella-bold.otf", "fonts-texgyre"},
      {"TeX Gyre Pagella Bold Italic", "tex-gyre/texgyrepagella-bolditalic.otf", "fonts-texgyre"},
      {"TeX Gyre Pagella Math", "tex-gyre-math/texgyrepagella-math.otf", "fonts-texgyre-math"},
      {"TeX Gyre Heros", "tex-gyre/texgyreheros-regular.otf", "fonts-texgyre"},
      {"TeX Gyre Heros Bold", "tex-gyre/texgyreheros-bold.otf", "fonts-texgyre"},
      {"TeX Gyre Cursor", "tex-gyre/texgyrecursor-regular.otf", "fonts-texgyre"},
  }};
  return kFiles[static_cast<std::size_t>(face)];
}

struct FaceDeleter {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
struct LibraryDeleter {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct FontDeleter {
  void operator()(hb_font_t* font) const { hb_font_destroy(font); }
};
struct BufferDeleter {
  void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};

struct OpenFace {
  std::string path;
  std::unique_ptr<FT_FaceRec_, FaceDeleter> outlines;
  std::unique_ptr<hb_font_t, FontDeleter> font;
  double units_per_em = 1000.0;
  /// Of glyphs asked for: HarfBuzz walks a glyph's outline each time.
  mutable std::unordered_map<std::uint32_t, GlyphBox> boxes;
};

/// Where the file may be: in the folder that $POLHODE_FONTS names, beside the program, as PROGRAM is to
/// PROGRAM/../share/polhode/fonts, in Debian's folders, in the one of TeX Live from upstream.
std::vector<std::filesystem::path> places_of(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> places;
  const char* chosen = std::getenv("POLHODE_FONTS");
  if (chosen && *chosen) places.push_back(chosen / file.filename());
  std::error_code unknown;
  if (const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown); !unknown)
    places.push_back(program.parent_path().parent_path() / "share/polhode/fonts" / file.filename());
  for (const char* folder :
       {"/usr/share/texmf/fonts/opentype/public", "/usr/share/texlive/texmf-dist/fonts/opentype/public",
        "/usr/share/fonts/opentype"})
    places.push_back(folder / file);
  return places;
}

Result<OpenFace> open_face(FT_Library library, const FontFile& wanted) {
  for (const std::filesystem::path& path : places_of(wanted.file)) {
    std::error_code none;
    if (!std::filesystem::exists(path, none)) continue;
    FT_Face outlines = nullptr;
    if (FT_New_Face(library, path.c_str(), 0, &outlines) != 0)
      return failure(
          std::string("font ") + wanted.name + " cannot be read: " + path.string() +
          " is damaged or not readable, or there is too little memory; it belongs to the package " +
          wanted.package);
    OpenFace opened;
    opened.path = path;
    opened.outlines.reset(outlines);
    hb_blob_t* blob = hb_blob_create_from_file(path.c_str());
    hb_face_t* face = hb_face_create(blob, 0);
    opened.font.reset(hb_font_create(face));
    opened.units_per_em = hb_face_get_upem(face);
    const int scale = static_cast<int>(opened.units_per_em);
    hb_font_set_scale(opened.font.get(), scale, scale);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return opened;
  }
  return failure(std::string("font ") + wanted.name + " not found: install the package " + wanted.package);
}

GlyphMask mask_of(const FT_Bitmap& bitmap, int left, int top) {
  GlyphMask mask{static_cast<int>(bitmap.width), static_cast<int>(bitmap.rows), left, top, {}};
  mask.ink.reserve(static_cast<std::size_t>(bitmap.width) * bitmap.rows);
  for (unsigned row = 0; row < bitmap.rows; ++row) {
    const unsigned char* first = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
    mask.ink.insert(mask.ink.end(), first, first + bitmap.width);
  }
  return mask;
}

/// FreeType refuses glyphs a few thousand pixels wide, but draws their parts.
GlyphMask mask_in_parts(FT_Library library, FT_Outline& outline) {
  constexpr int kSide = 1024;
  FT_BBox box;
  FT_Outline_Get_CBox(&outline, &box);
  const auto left = static_cast<int>(box.xMin >> 6), bottom = static_cast<int>(box.yMin >> 6);
  GlyphMask mask{static_cast<int>((box.xMax + 63) >> 6) - left,
                 static_cast<int>((box.yMax + 63) >> 6) - bottom,
                 left,
                 0,
                 {}};
  mask.top = bottom + mask.height;
  mask.ink.assign(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height), 0);
  for (int y = 0; y < mask.height; y += kSide)
    for (int x = 0; x < mask.width; x += kSide) {
      FT_Bitmap part{};
      part.width = static_cast<unsigned>(std::min(kSide, mask.width - x));
      part.rows = static_cast<unsigned>(std::min(kSide, mask.height - y));
      part.pitch = mask.width;
      part.buffer = mask.ink.data() + static_cast<std::ptrdiff_t>(y) * mask.width + x;
      part.num_grays = 256;
      part.pixel_mode = FT_PIXEL_MODE_GRAY;
      const FT_Pos right = 64 * (left + x), up = 64 * (mask.top - y - static_cast<int>(part.rows));
      FT_Outline_Translate(&outline, -right, -up);
      if (FT_Outline_Get_Bitmap(library, &outline, &part) != 0) return {};
      FT_Outline_Translate(&outline, right, up);
    }
  return mask;
}

}  // namespace

struct Fonts::Faces {
  std::unique_ptr<FT_LibraryRec_, LibraryDeleter> library;
  std::array<OpenFace, kFaceCount> faces;  // closed before the library
  std::unique_ptr<hb_buffer_t, BufferDeleter> buffer;

  const OpenFace& operator[](Face face) const { return faces[static_cast<std::size_t>(face)]; }
};

Fonts::Fonts(std::unique_ptr<Faces> faces) : faces_(std::move(faces)) {}
Fonts::Fonts(Fonts&&) noexcept = default;
Fonts& Fonts::operator=(Fonts&&) noexcept = default;
Fonts::~Fonts() = default;

Result<Fonts> Fonts::open() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return failure("FreeType could not be started");
  auto faces = std::make_unique<Faces>();
  faces->library.reset(library);
  for (int i = 0; i < kFaceCount; ++i) {
    Result<OpenFace> face = open_face(library, file_of(i));
    if (!face) return failure(face.error());
    faces->faces[static_cast<std::size_t>(i)] = std::move(*face);
  }
  faces->buffer.reset(hb_buffer_create());
  return Fonts(std::move(faces));
}

std::optional<std::uint32_t> Fonts::glyph(Face face, char32_t character) const {
  hb_codepoint_t found = 0;
  if (!hb_font_get_nominal_glyph((*faces_)[face].font.get(), character, &found)) return std::nullopt;
  return found;
}

double Fonts::advance(Face face, std::uint32_t glyph) const {
  const OpenFace& f = (*faces_)[face];
  return hb_font_get_glyph_h_advance(f.font.get(), glyph) / f.units_per_em;
}

GlyphBox Fonts::box(Face face, std::uint32_t glyph) const {
  const OpenFace& f = (*faces_)[face];
  const auto [known, is_new] = f.boxes.try_emplace(glyph);
  if (!is_new) return known->second;
  hb_glyph_extents_t e{};
  hb_font_get_glyph_extents(f.font.get(), glyph, &e);
  return known->second = {e.x_bearing / f.units_per_em, (e.y_bearing + e.height) / f.units_per_em,
                          (e.x_bearing + e.width) / f.units_per_em, e.y_bearing / f.units_per_em};
}

std::vector<ShapedGlyph> Fonts::shape(Face face, std::string_view utf8) const {
  const OpenFace& f = (*faces_)[face];
  hb_buffer_t* buffer = faces_->buffer.get();
  hb_buffer_clear_contents(buffer);
  hb_buffer_add_utf8(buffer, utf8.data(), static_cast<int>(utf8.size()), 0, static_cast<int>(utf8.size()));
  hb_buffer_set_direction(buffer, HB_DIRECTION_LTR);
  hb_buffer_set_script(buffer, HB_SCRIPT_LATIN);
  hb_buffer_set_language(buffer, hb_language_from_string("en", -1));
  hb_shape(f.font.get(), buffer, nullptr, 0);

  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer, &count);
  std::vector<ShapedGlyph> shaped;
  shaped.reserve(count);
  int pen = 0;
  for (unsigned i = 0; i < count; ++i) {
    shaped.push_back({infos[i].codepoint, (pen + positions[i].x_offset) / f.units_per_em,
                      positions[i].y_offset / f.units_per_em, positions[i].x_advance / f.units_per_em,
                      infos[i].cluster});
    pen += positions[i].x_advance;
  }
  return shaped;
}

hb_font_t* Fonts::harfbuzz(Face face) const { return (*faces_)[face].font.get(); }
double Fonts::units_per_em(Face face) const { return (*faces_)[face].units_per_em; }

const std::string& Fonts::path(Face face) const { return (*faces_)[face].path; }

GlyphMask Fonts::mask(Face face, std::uint32_t glyph, double size_px, double shift_x, double shift_y) const {
  FT_Face outlines = (*faces_)[face].outlines.get();
  if (FT_Set_Char_Size(outlines, 0, std::lround(64.0 * size_px), 72, 72) != 0) return {};
  if (FT_Load_Glyph(outlines, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return {};
  const FT_GlyphSlot slot = outlines->glyph;
  FT_Outline_Translate(&slot->outline, std::lround(64.0 * shift_x), -std::lround(64.0 * shift_y));
  if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0)
    return mask_in_parts(faces_->library.get(), slot->outline);
  return mask_of(slot->bitmap, slot->bitmap_left, slot->bitmap_top);
}

TypeBox ink_box(const DisplayList& list, const Fonts& fonts) {
  TypeBox all{1e300, 1e300, -1e300, -1e300};
  const auto take = [&](double x0, double y0, double x1, double y1) {
    all = {std::min(all.x0, x0), std::min(all.y0, y0), std::max(all.x1, x1), std::max(all.y1, y1)};
  };
  for (const Glyph& g : list.glyphs) {
    const GlyphBox b = fonts.box(g.face, g.id);
    if (b.left < b.right)
      take(g.x + b.left * g.size, g.y - b.top * g.size, g.x + b.right * g.size, g.y - b.bottom * g.size);
  }
  for (const Rule& r : list.rules) {
    const double length = std::hypot(r.x1 - r.x0, r.y1 - r.y0), half = 0.5 * r.thickness;
    const double nx = length > 0.0 ? half * std::abs(r.y1 - r.y0) / length : half,
                 ny = length > 0.0 ? half * std::abs(r.x1 - r.x0) / length : half;
    take(std::min(r.x0, r.x1) - nx, std::min(r.y0, r.y1) - ny, std::max(r.x0, r.x1) + nx,
         std::max(r.y0, r.y1) + ny);
  }
  return all.empty() ? TypeBox{} : all;
}

}  // namespace polhode
