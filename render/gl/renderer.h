// SPDX-License-Identifier: MIT
// Draws figures and sheets off-screen: RGBA8, no driver-side sRGB conversion, so that bytes repeat.
#pragma once

#include "render/drawing/sheet.h"
#include "render/figure/figure.h"
#include "render/gl/context/context.h"
#include "render/gl/passes/background.h"
#include "render/image/image.h"
#include "render/typeset/fonts.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

class Framebuffer;

inline constexpr int kMaxImageSide = 16384;  ///< px; llvmpipe's limit

/// How finely a figure is drawn. Its text has soft edges of its own and is the same in all.
struct Quality {
  int samples = 4;  ///< a pixel of meshes and of the lines among them; 0: one
  int supersampling =
      1;  ///< n: all is drawn n times wider and higher, and n x n pixels averaged as displayed
  /// Edges that know how much of a pixel they cover, wherever they can. False: all is drawn by samples, the
  /// common way; slower and coarser, to be measured against.
  bool soft_lines = true;
  bool operator==(const Quality&) const = default;
};

struct PixelRect {
  int x = 0, y = 0;  ///< of the upper left corner
  int width = 0, height = 0;
};

/// A figure set into a sheet.
struct Inset {
  Figure figure;
  PixelRect place;
  Background background;
  Quality quality;
  /// Drawn with this part of its pixels each way, 0 < … ≤ 1, and enlarged, but for what is written in it:
  /// while something moves on a slow machine.
  double resolution = 1;
};

/// Owns all GL objects; one per context, reused for every frame. Compiles its shaders once
/// (0.2-0.4 s on llvmpipe).
class Renderer {
 public:
  /// The error names the function or shader that is missing. Both must outlive the renderer; `fonts` are
  /// those with which the text is laid out that it is to draw.
  static Result<std::unique_ptr<Renderer>> create(const GlContext& context, const Fonts& fonts);
  virtual ~Renderer() = default;

  /// The error says what the driver refused (size, samples, memory).
  virtual Result<Image> draw(const Figure& figure, Size size, const Background& background,
                             const Quality& quality = {}) = 0;
  /// The sheet is laid out for this size. Insets lie over its shapes and under all else, the later over the
  /// earlier; one with an opaque background is the picture that the figure makes alone, byte for byte.
  virtual Result<Image> draw(const Sheet& sheet, std::span<const Inset> insets, Size size,
                             const Background& background) = 0;
  /// The same pixels, premultiplied, into a framebuffer of this context and of the size that the sheet is
  /// laid out for: nothing is read. For windows.
  virtual Status paint(const Sheet& sheet, std::span<const Inset> insets, const Background& background,
                       const Framebuffer& page) = 0;
  Result<Image> draw(const Sheet& sheet, Size size, const Background& background) {
    return draw(sheet, std::span<const Inset>(), size, background);
  }

  /// What it draws text with.
  virtual const Fonts& fonts() const = 0;

  /// That the driver has, of Quality::samples.
  virtual int most_samples() const = 0;

  /// GL_RENDERER and GL_VERSION of the driver, for manifests and failed goldens.
  virtual std::string driver() const = 0;
};

}  // namespace polhode
