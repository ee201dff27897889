// SPDX-License-Identifier: MIT
// What lies flat on the picture: labels with halo and leader lines, readouts, titles, the caption. Drawn on
// the resolved picture with analytic edges. Internal to render/gl/.
#pragma once

#include "render/drawing/label_layout.h"
#include "render/figure/figure.h"
#include "render/gl/passes/glyph_pass.h"

namespace polhode {

class FlatPass {
 public:
  /// `type` and `fonts` must outlive the pass.
  static Result<std::unique_ptr<FlatPass>> create(const Gl& gl, GlyphPass& type, const Fonts& fonts);

  /// Draws into the bound framebuffer of this size. `halo` is the colour behind text (straight alpha).
  void draw(const Figure& figure, Size size, const Color& halo);
  /// What it writes there, without drawing.
  static std::vector<PlacedType> type_on(const Figure& figure, Size size, const Color& halo,
                                         const Fonts& fonts);

 private:
  struct Vertex {
    std::array<float, 2> position;
    std::array<float, 2> local;
    std::array<float, 4> ink;
    std::array<float, 4> halo;
  };
  struct Parts;  // what one picture is made of, gathered before it is drawn

  FlatPass(const Gl& gl, GlyphPass& type, const Fonts& fonts, Program box)
      : type_(type), fonts_(fonts), box_(std::move(box)), stream_(gl, {2, 2, 4, 4}) {}
  static Parts parts_of(const Figure& figure, Size size, const Color& halo, const Fonts& fonts);
  static void add_labels(const Pane& pane, const PixelBox& frame, const std::vector<PixelBox>& taken,
                         Parts& parts);
  static PixelBox add_readout(const Readout& readout, const PixelBox& frame, bool at_bottom, Parts& parts);
  static void add_color_bar(double x, double y, double width, double marker, Parts& parts);
  /// `align` is the part of the line that lies left of x.
  static void add_line(const std::string& text, double size_px, double x, double y, double align,
                       const Color& ink, const Color& halo, Parts& parts);
  static void add_frame_titles(const Figure& figure, Size size, Parts& parts);
  void draw_parts(const Parts& parts, Size size);

  GlyphPass& type_;
  const Fonts& fonts_;
  Program box_;
  VertexStream stream_;
};

}  // namespace polhode
