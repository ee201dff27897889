// SPDX-License-Identifier: MIT
#include "render/gl/passes/flat_pass.h"

#include "render/gl/passes/floats.h"
#include "render/gl/shader_sources.h"
#include "render/palette.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

// Sizes relative to the height of the picture.
constexpr double kLabelSize = 0.034;
constexpr double kReadoutSize = 0.0235;
constexpr double kTitleSize = 0.027;
constexpr double kCaptionSize = 0.029;
constexpr double kMargin = 0.03;
constexpr double kLineSpacing = 1.55;

constexpr int kPointsOnGlass = 400;

constexpr Color kPanel = color_from_hex(0xFFFFFF, 0.84F);
constexpr Color kNoColor{0, 0, 0, 0};

/// Inks are made for light backdrops; on a dark one (told by the halo) they are lightened.
Color readable(const Color& ink, const Color& halo) { return is_dark(halo) ? on_dark(ink) : ink; }

PixelBox pixels_of(const Pane& pane, Size size) {
  return {pane.x * size.width, pane.y * size.height, (pane.x + pane.width) * size.width,
          (pane.y + pane.height) * size.height};
}

Vec2 to_pixel(const Pane& pane, const PixelBox& frame, const Vec3& point) {
  const auto p = project(pane.camera, point, frame.width(), frame.height());
  return p ? Vec2(*p + Vec2(frame.x0, frame.y0)) : Vec2(-1e6, -1e6);
}

/// Points a few pixels apart along everything thin: what labels should not cover.
std::vector<Vec2> obstacles_of(const Pane& pane, const PixelBox& frame) {
  std::vector<Vec2> points;
  const double spacing = 0.012 * frame.height();
  const auto add_segment = [&](const Vec3& a, const Vec3& b) {
    const Vec2 p = to_pixel(pane, frame, a), q = to_pixel(pane, frame, b);
    const double length = (q - p).norm();
    if (!(length < 4.0 * frame.width())) return;  // behind the camera
    const int n = std::max(1, static_cast<int>(length / spacing));
    for (int i = 0; i <= n; ++i) points.push_back(p + (q - p) * (static_cast<double>(i) / n));
  };
  for (const Tube& tube : pane.list.tubes) {
    // Closely spaced points would weigh more than far ones: step by screen distance.
    Vec2 last(-1e6, -1e6);
    for (const Vec3& x : tube.points) {
      const Vec2 p = to_pixel(pane, frame, x);
      if ((p - last).norm() < spacing) continue;
      points.push_back(p);
      last = p;
    }
  }
  // Names stand beside the glass rather than on it.
  for (const GlassEllipsoid& e : pane.list.ellipsoids)
    for (int i = 0; i < kPointsOnGlass; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / kPointsOnGlass, r = std::sqrt(1.0 - z * z),
                   turn = 2.39996323 * i;
      const Vec3 n(r * std::cos(turn), r * std::sin(turn), z);  // points of a spiral, evenly spread
      points.push_back(to_pixel(pane, frame, e.center + e.rotation * Vec3(e.semi_axes.cwiseProduct(n))));
    }
  for (const Arrow& arrow : pane.list.arrows)
    for (int weight = 0; weight < (arrow.radius > 0.01 ? 3 : 1); ++weight) add_segment(arrow.tail, arrow.tip);
  return points;
}

/// Boxes along the arrows of vectors, which neither labels nor leader lines may cover.
std::vector<PixelBox> boxes_of_arrows(const Pane& pane, const PixelBox& frame) {
  constexpr double kThin = 0.01;  // axes
  constexpr double kAir = 1.5;    // times the radius
  std::vector<PixelBox> boxes;
  for (const Arrow& arrow : pane.list.arrows) {
    if (arrow.radius <= kThin) continue;
    const Vec2 tail = to_pixel(pane, frame, arrow.tail), tip = to_pixel(pane, frame, arrow.tip);
    const double radius =
        (to_pixel(pane, frame, arrow.tip + arrow.radius * pane.camera.up) - tip).norm() * kAir;
    const double length = (tip - tail).norm();
    if (!(length < 4.0 * frame.width() && radius > 0.0)) continue;  // behind the camera
    const int n = std::clamp(static_cast<int>(length / (2.0 * radius)), 1, 200);
    for (int i = 0; i < n; ++i) {
      const Vec2 p = tail + (tip - tail) * ((i + 0.5) / n);
      boxes.push_back({p.x() - radius, p.y() - radius, p.x() + radius, p.y() + radius});
    }
  }
  return boxes;
}

}  // namespace

struct FlatPass::Parts {
  const Fonts& fonts;
  Size size;
  double type_px;  ///< what the sizes of type are relative to: the height, or less in a narrow picture
  Color halo;
  Geometry<Vertex> boxes;
  std::vector<PlacedType> lines;

  DisplayList line_of(const std::string& text, double size_px, const Color& ink) const {
    TextStyle style;
    style.size = size_px;
    style.color = ink;
    style.sans = true;
    return set_line(text, style, fonts);
  }

  /// Rounded box centred at `center` (px from the upper left), turned by `angle`; half sizes along its own
  /// axes.
  void add_box(const Vec2& center, const Vec2& half, double angle, double radius, const Color& fill,
               double border) {
    const auto first = static_cast<std::uint32_t>(boxes.vertices.size());
    const Vec2 u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
    for (int k = 0; k < 4; ++k) {
      const Vec2 local((k & 1 ? 1.0 : -1.0) * (half.x() + 1.0), (k & 2 ? 1.0 : -1.0) * (half.y() + 1.0));
      const Vec2 p = center + local.x() * u + local.y() * v;
      boxes.vertices.push_back({{static_cast<float>(p.x()), static_cast<float>(size.height - p.y())},
                                {static_cast<float>(local.x()), static_cast<float>(local.y())},
                                floats(fill),
                                {static_cast<float>(half.x()), static_cast<float>(half.y()),
                                 static_cast<float>(radius), static_cast<float>(border)}});
    }
    for (std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) boxes.indices.push_back(first + k);
  }

  void add_stroke(const Vec2& from, const Vec2& to, double width, const Color& color) {
    const Vec2 d = to - from;
    add_box(0.5 * (from + to), {0.5 * d.norm() + 0.5 * width, 0.5 * width}, std::atan2(d.y(), d.x()),
            0.5 * width, color, 0.0);
  }
};

Result<std::unique_ptr<FlatPass>> FlatPass::create(const Gl& gl, GlyphPass& type, const Fonts& fonts) {
  auto box = Program::create(gl, "box", {shaders::kFlatVert}, {shaders::kBoxFrag});
  if (!box) return failure(box.error());
  return std::unique_ptr<FlatPass>(new FlatPass(gl, type, fonts, std::move(box).value()));
}

void FlatPass::add_line(const std::string& text, double size_px, double x, double y, double align,
                        const Color& ink, const Color& halo, Parts& parts) {
  DisplayList line = parts.line_of(text, size_px, ink);
  const double left = x - align * line.width;
  parts.lines.push_back({.list = std::move(line), .at = {left, y}, .halo = halo, .text = text});
}

void FlatPass::add_color_bar(double x, double y, double width, double marker, Parts& parts) {
  const double em = kReadoutSize * parts.type_px;
  const double height = std::max(2.0, std::round(0.5 * em));
  y = std::round(y);  // slices overlap: soft edges would be denser there
  constexpr int kSlices = 96;
  for (int i = 0; i < kSlices; ++i) {
    const double w = width / kSlices;
    const double overlap = i + 1 < kSlices ? 1.0 : 0.0;  // no seam between the soft edges
    parts.add_box({x + (i + 0.5) * w + 0.5 * overlap, y + 0.5 * height}, {0.5 * (w + overlap), 0.5 * height},
                  0.0, 0.0, family_color((i + 0.5) / kSlices), 0.0);
  }
  const double at = x + marker * width;
  parts.add_box({at, y + 0.5 * height}, {0.14 * em, 0.5 * height + 0.16 * em}, 0.0, 0.14 * em,
                color_from_hex(0xFFFFFF), 0.0);
  parts.add_box({at, y + 0.5 * height}, {0.08 * em, 0.5 * height + 0.10 * em}, 0.0, 0.08 * em,
                kPolhodeRole.paint, 0.0);
  const double below = y + height + 1.05 * em;
  add_line("$I_1$", 0.9 * em, x, below, 0.0, kInk, kNoColor, parts);
  add_line("$L^2/2T$", 0.9 * em, x + 0.5 * width, below, 0.5, kInk, kNoColor, parts);
  add_line("$I_3$", 0.9 * em, x + width, below, 1.0, kInk, kNoColor, parts);
}

PixelBox FlatPass::add_readout(const Readout& readout, const PixelBox& frame, bool at_bottom, Parts& parts) {
  const double em = kReadoutSize * parts.type_px;
  const double margin = kMargin * parts.type_px;
  const double pad = 0.8 * em;
  double width = 0.0;
  for (const std::string& line : readout.lines) width = std::max(width, parts.line_of(line, em, kInk).width);
  const double bar = readout.color_bar ? 2.2 * em : 0.0;
  const double lines = static_cast<double>(readout.lines.size());
  const double height = 2.0 * pad + (lines - 1.0) * kLineSpacing * em + em + bar;
  const double x = frame.x0 + margin;
  const double y = at_bottom ? frame.y1 - margin - height : frame.y0 + margin;
  const PixelBox panel{x, y, x + width + 2.0 * pad, y + height};

  parts.add_box({0.5 * (panel.x0 + panel.x1), 0.5 * (panel.y0 + panel.y1)},
                {0.5 * panel.width(), 0.5 * panel.height()}, 0.0, 0.45 * em, kPanel, 1.0);
  double baseline = y + pad + 0.82 * em;
  for (const std::string& line : readout.lines) {
    add_line(line, em, x + pad, baseline, 0.0, kInk, kNoColor, parts);  // on the panel, whatever the backdrop
    baseline += kLineSpacing * em;
  }
  if (readout.color_bar) add_color_bar(x + pad, baseline - 0.75 * em, width, readout.marker, parts);
  return panel;
}

namespace {
constexpr double kShortName = 1.6;  ///< em
constexpr double kLeaderDot = 4.5;  ///< widths of a leader: the dot on what it leads to

struct LabelSide {
  Vec2 outward{0, 0};
  bool is_kept = false;
};

/// Of an arrow that is seen from its side that beyond its tip, or next to its shaft: away from what the
/// figure is about, or on the right. Of what else has no leader that away from the middle, where it may go
/// elsewhere.
LabelSide side_of(const Label& label, const Vec2& anchor, double em, const Pane& pane,
                  const PixelBox& frame) {
  if (!label.side.isZero()) return {Vec2(label.side.x(), -label.side.y()), true};
  const Vec2 away = anchor - to_pixel(pane, frame, Vec3::Zero());
  if (label.tail) {
    const Vec2 along = anchor - to_pixel(pane, frame, *label.tail);
    constexpr double kSeenOfShaft = 0.2;  // em, up to where its name stands
    if (along.norm() > em && !label.beside) return {along.normalized(), true};
    if (label.beside && along.norm() > kSeenOfShaft * em) {
      const Vec2 across = Vec2(-along.y(), along.x()).normalized();
      const double apart = across.dot(away);
      const bool is_outer = std::abs(apart) > em ? apart > 0.0 : across.x() > 0.0;
      return {is_outer ? across : Vec2(-across), true};
    }
  }
  const bool has_side = !label.leader && away.norm() > em;
  return {has_side ? Vec2(away.normalized()) : Vec2(0, 0), false};
}
}  // namespace

void FlatPass::add_labels(const Pane& pane, const PixelBox& frame, const std::vector<PixelBox>& taken,
                          Parts& parts) {
  const double base = kLabelSize * parts.type_px;
  std::vector<LabelRequest> requests;
  std::vector<DisplayList> lines;
  std::vector<TypeBox> inks;
  for (const Label& label : pane.list.labels) {
    const double em = base * label.size;
    lines.push_back(parts.line_of(label.text, em, readable(label.color, parts.halo)));
    inks.push_back(ink_box(lines.back(), parts.fonts));
    const Vec2 anchor = to_pixel(pane, frame, label.anchor);
    const LabelSide side = side_of(label, anchor, em, pane, frame);
    requests.push_back({.anchor = anchor,
                        .width = inks.back().x1 - inks.back().x0,
                        .height = inks.back().y1 - inks.back().y0,
                        .unit = 0.95 * em,
                        .outward = side.outward,
                        .keeps_side = side.is_kept,
                        .beside = label.beside,
                        .leader = label.leader,
                        // A number or letter that stands away from its point looks like "−1" behind its line.
                        .close = label.leader && inks.back().x1 - inks.back().x0 < kShortName * em});
  }
  const PixelBox inside = frame.grown(-kMargin * parts.type_px);
  // Boxes of ink have no space of their own around them.
  constexpr LabelRules kRules{
      .rounds = 1, .cost_covered = 0.15, .air = 0.3, .leader_gap = 0.28, .level_gap = 0.7, .cost_level = 0.8};
  const auto placed = place_labels(requests, obstacles_of(pane, frame), taken, inside, kRules);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Label& label = pane.list.labels[i];
    const double em = base * label.size;
    const PixelBox& box = placed[i].box;
    const Color ink = readable(label.color, parts.halo);
    if (placed[i].has_leader) {
      const double width = std::max(1.0, 0.055 * em);
      const Vec2 &anchor = requests[i].anchor, &end = placed[i].leader_end;
      parts.add_stroke(anchor, end, 3.2 * width, parts.halo);
      parts.add_stroke(anchor, end, width, ink);
      parts.add_stroke(anchor, anchor + 1e-3 * (end - anchor), kLeaderDot * width, ink);
    }
    parts.lines.push_back({.list = std::move(lines[i]),
                           .at = {box.x0 - inks[i].x0, box.y0 - inks[i].y0},
                           .halo = parts.halo,
                           .text = label.text});
  }
}

void FlatPass::add_frame_titles(const Figure& figure, Size size, Parts& parts) {
  const double em = parts.type_px, margin = kMargin * em;
  const double bottom = size.height - margin;
  for (const Pane& pane : figure.panes) {
    const PixelBox frame = pixels_of(pane, size);
    if (!pane.title.empty())
      add_line(pane.title, kTitleSize * em, 0.5 * (frame.x0 + frame.x1), frame.y0 + margin + kTitleSize * em,
               0.5, readable(kAxesRole.ink, parts.halo), parts.halo, parts);
    if (frame.x0 > 0.0)
      parts.add_stroke({frame.x0, frame.y0 + margin}, {frame.x0, bottom}, 0.0018 * em,
                       color_from_hex(0xA9B0B8));
  }
}

FlatPass::Parts FlatPass::parts_of(const Figure& figure, Size size, const Color& halo, const Fonts& fonts) {
  const double type_px = figure.caption_px > 0.0 ? figure.caption_px / kCaptionSize
                                                 : std::min<double>(size.height, size.width * 9.0 / 16.0);
  Parts parts{.fonts = fonts, .size = size, .type_px = type_px, .halo = halo, .boxes = {}, .lines = {}};
  add_frame_titles(figure, size, parts);
  for (const Pane& pane : figure.panes) {
    const PixelBox frame = pixels_of(pane, size);
    std::vector<PixelBox> taken;
    for (const PlacedType& line : parts.lines) {
      const TypeBox ink = ink_box(line.list, parts.fonts);
      taken.push_back(
          {line.at.x() + ink.x0, line.at.y() + ink.y0, line.at.x() + ink.x1, line.at.y() + ink.y1});
    }
    for (const Readout& readout : pane.list.readouts)
      taken.push_back(add_readout(readout, frame, figure.panes.size() > 1, parts));
    const std::vector<PixelBox> arrows = boxes_of_arrows(pane, frame);
    taken.insert(taken.end(), arrows.begin(), arrows.end());
    add_labels(pane, frame, taken, parts);
  }
  return parts;
}

void FlatPass::draw(const Figure& figure, Size size, const Color& halo) {
  draw_parts(parts_of(figure, size, halo, fonts_), size);
}

std::vector<PlacedType> FlatPass::type_on(const Figure& figure, Size size, const Color& halo,
                                          const Fonts& fonts) {
  return parts_of(figure, size, halo, fonts).lines;
}

void FlatPass::draw_parts(const Parts& parts, Size size) {
  box_.use();
  box_.set("u_size", static_cast<float>(size.width), static_cast<float>(size.height));
  stream_.draw(parts.boxes);
  type_.draw(parts.lines, size);
}

}  // namespace polhode
