// SPDX-License-Identifier: MIT
// What lies flat on the picture: labels with halo and leader lines, readouts, titles, the caption. Drawn on
// the resolved picture with analytic edges. Internal to render/gl.
#pragma once

#include "render/gl/label_layout.h"
#include "render/gl/shader.h"
#include "render/gl/stream.h"
#include "render/image/image.h"
#include "render/scene/figure.h"
#include "render/type/font.h"

#include <map>
#include <string>
#include <utility>

namespace polhode {

class FlatPass {
 public:
  static Result<std::unique_ptr<FlatPass>> create(const Gl& gl);
  ~FlatPass();
  FlatPass(const FlatPass&) = delete;
  FlatPass& operator=(const FlatPass&) = delete;

  /// Draws into the bound framebuffer of this size. `halo` is the colour behind text (straight alpha).
  void draw(const Figure& figure, Size size, const Color& halo);

 private:
  struct Vertex {
    std::array<float, 2> position;
    std::array<float, 2> local;
    std::array<float, 4> ink;
    std::array<float, 4> halo;
  };
  struct Line;   // a line of text and where it goes
  struct Sheet;  // what one picture is made of, gathered before it is drawn

  FlatPass(const Gl& gl, LabelFont font, Program text, Program box);
  const TextMask& mask(const std::string& text, double size_px, double halo_px);
  void add_labels(const Pane& pane, const PixelBox& frame, const std::vector<PixelBox>& taken, Sheet& sheet);
  PixelBox add_readout(const Readout& readout, const PixelBox& frame, bool at_bottom, Sheet& sheet);
  void add_color_bar(double x, double y, double width, double marker, Sheet& sheet);
  void add_line(const std::string& text, double size_px, double x, double y, double align, const Color& ink,
                Sheet& sheet);
  void add_frame_titles(const Figure& figure, Size size, Sheet& sheet);
  void draw_sheet(const Sheet& sheet, Size size);

  const Gl& gl_;
  LabelFont font_;
  Program text_, box_;
  VertexStream stream_;
  GLuint texture_ = 0;
  std::map<std::pair<std::string, int>, TextMask> masks_;  ///< by text and size in 1/64 px
};

}  // namespace polhode
