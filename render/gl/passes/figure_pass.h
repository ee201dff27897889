// SPDX-License-Identifier: MIT
// The space of a figure: backdrop, floor, glass ellipsoids, lines and solids; no text. Internal to
// render/gl/.
//
// Two ways. Figures of lines, arrows and balls are painted from far to near, one sample a pixel, with edges
// that know how much of a pixel they cover; the depth buffer holds off only what comes out of order. Figures
// with meshes have those, and the lines among them, in a layer of several samples, which is laid over
// backdrop, floor and the far side of the glass.
#pragma once

#include "render/figure/figure.h"
#include "render/gl/framebuffer.h"
#include "render/gl/passes/background.h"
#include "render/gl/passes/strokes.h"
#include "render/gl/passes/viewpoint.h"
#include "render/gl/shader.h"
#include "render/gl/stream.h"

#include <memory>
#include <vector>

namespace polhode {

class FigurePass {
 public:
  /// The error names the shader that the driver refuses.
  static Result<std::unique_ptr<FigurePass>> create(const Gl& gl);

  /// Into the whole of `target`, premultiplied; blending is on, the depth test off. `fineness`: pixels to a
  /// side of `target` that will be averaged into one. `layer`, of the same size, is for figures with meshes.
  void draw(const Figure& figure, const Background& background, int fineness, const Framebuffer& target,
            const Framebuffer* layer);

  /// The common way, to be measured against: all in one target with several samples and a depth buffer.
  void draw_by_samples(const Figure& figure, const Background& background, int fineness,
                       const Framebuffer& target);

  /// A premultiplied picture over the viewport, whose lower left corner is at (x, y).
  void lay_over(const Framebuffer& picture, int x, int y) const;

 private:
  /// The floor alone, with the ellipsoid's shadow, and with that and its image.
  struct Floors {
    Program plain, shaded, mirroring;
  };
  struct Programs {
    Program studio;
    Floors on_color, on_studio, from_below;
    Program wall;
    Program glass, far_glass, near_glass;
    Program line_depth;
    std::array<Program, 3> line, cone, ball;  ///< behind so many glasses
    Program tube, mesh, layer;
  };
  struct Shown;  // a pane on its target
  FigurePass(const Gl& gl, Programs programs);

  Shown show(const Pane& pane, const Framebuffer& target, const Background& background, int fineness) const;
  void draw_layer(const Shown& shown, const std::vector<PixelArea>& parts);
  void lay_over(const Framebuffer& layer, const std::vector<PixelArea>& parts) const;
  void clear(const Background& background, GLbitfield buffers) const;
  void draw_surroundings(const Shown& shown);
  void draw_walls(const Shown& shown);
  void draw_floor(const Shown& shown, const Floors& programs, const ClipBox& box);
  void draw_floor_from_below(const Shown& shown);
  void draw_glass(const Shown& shown, const Program& program);
  void draw_near_glass(const Shown& shown);
  void draw_strokes(const Shown& shown, const std::array<float, 2>& strengths);
  void draw_depth_of_whole_pixels(const Strokes& strokes);
  const Program& program_of(Strokes::Kind kind, std::size_t glasses) const;
  void draw_solids(const Shown& shown);
  void draw_box(const Program& program, const ClipBox& box);
  void set_floor(const Program& program, const Shown& shown);
  void set_ball(const Program& program, const GlassEllipsoid& e, float image, const Shown& shown);
  void set_window(const Program& program, const Shown& shown);

  const Gl& gl_;
  Programs programs_;
  VertexStream tubes_, meshes_, lines_, solids_, outlines_, nothing_;
};

}  // namespace polhode
