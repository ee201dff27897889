// SPDX-License-Identifier: MIT
// What is visible at one time, as data: the renderer knows nothing but these.
// Lengths and positions in scene units of the pane's frame (space or body); colours are sRGB, straight alpha.
#pragma once

#include "base/color.h"
#include "base/vectors.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// A line with thickness, lit as a cylinder.
struct Tube {
  std::vector<Vec3> points;
  bool closed = false;
  double radius = 0.01;
  Color color;
  double fade_start = 1.0;  ///< factor of alpha at the first point (trails fade in), 1 at the last
  double dash = 0.0;        ///< length of a dash and of a gap; 0: solid
  bool of_body = false;     ///< along the edges of a solid: it has its colour on every ground
};

struct Arrow {
  Vec3 tail, tip;
  double radius = 0.02;
  Color color;
  double dash = 0.0;  ///< as of Tube
};

/// Glass ellipsoid, ray-cast.
struct GlassEllipsoid {
  Vec3 center{0, 0, 0};
  Quat rotation = Quat::Identity();  ///< takes its own axes to the pane's frame
  Vec3 semi_axes{1, 1, 1};
  Color tint;
  double graticule = 1.0;  ///< strength of thin latitude lines; 0: none
};

struct Ball {
  Vec3 center;
  double radius = 0.03;
  Color color;
};

/// Lit mesh, flat or smooth by its normals. If `color` is translucent it is drawn after everything opaque.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;        ///< unit, one for each position
  std::vector<unsigned> triangles;  ///< three indices each
  Color color;
};

/// Horizontal plane with a grid, and the soft shadow and faint mirror image of the first ellipsoid.
struct Floor {
  double z = -1;
  double grid = 0.5;  ///< spacing of the heavier lines; four lighter ones to each
};

/// A rectangle of grid behind all else of its pane, seen only from the side that right × up points to: of a
/// room that encloses what is drawn, no wall then stands before anything.
struct Wall {
  Vec3 center;
  Vec3 right, up;               ///< half its edges, at right angles
  Eigen::Vector2i cells{1, 1};  ///< of the grid, along both
  double radius = 0.004;        ///< half the width of its lines
  Color line, ground;           ///< translucent
};

struct Label {
  std::string text;  ///< as set_line() of render/typeset/paragraph.h sets it, in sans
  Vec3 anchor;       ///< what it names
  Color color;
  double size = 1.0;   ///< relative to the label size of the picture
  bool leader = true;  ///< draw a line to the anchor if it is placed away from it
  /// On the screen, x to the right and y up, unit or zero: the side of the anchor that it keeps to throughout
  /// a film, unless something is in the way there.
  Eigen::Vector2d side{0, 0};
  /// Of an arrow's name where the arrow begins: the name keeps beyond the tip, along the arrow; if it is
  /// `beside` it, next to the shaft.
  std::optional<Vec3> tail{};
  bool beside = false;
};

/// Lines of text in the corner of the pane, as of labels.
struct Readout {
  std::vector<std::string> lines;
  bool color_bar = false;  ///< key of the polhode family: L²/2T from I_min to I_max
  double marker = 0.0;     ///< where this motion lies on the bar, 0…1
};

struct DrawList {
  std::vector<Floor> floors;  ///< at most one
  std::vector<Wall> walls;
  std::vector<GlassEllipsoid> ellipsoids;  ///< at most one takes the shadow
  std::vector<Tube> tubes;
  std::vector<Arrow> arrows;
  std::vector<Ball> balls;
  std::vector<Mesh> meshes;
  std::vector<Label> labels;
  std::vector<Readout> readouts;  ///< at most one
};

}  // namespace polhode
