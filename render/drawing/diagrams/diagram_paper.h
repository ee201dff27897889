// SPDX-License-Identifier: MIT
// What diagrams are drawn on, and what they have in common. Internal to render/drawing/diagrams/. Lengths are
// in sizes of type, from the diagram's upper left corner, y down.
#pragma once

#include "render/drawing/diagrams/diagrams.h"
#include "render/drawing/plots/plot.h"
#include "render/palette.h"
#include "render/typeset/math/math.h"

#include <array>
#include <functional>
#include <limits>
#include <string>

namespace polhode::diagrams {

/// A diagram's numbers of one kind: multiples of one power of ten, with the same decimals.
class NumberForm {
 public:
  /// So many digits of the largest, ≥ 0.
  explicit NumberForm(double largest, int digits = 3);
  /// "−0.25"; a dash for what is not finite.
  std::string text(double value) const;
  /// Two digits of a value that may be far smaller: "−3 × 10⁻¹⁷", "0".
  std::string residual(double value) const;
  /// "N m"; "10⁻⁶ N m"
  std::string unit(const std::string& unit) const;
  /// What stands behind a number: " N m"; " × 10⁻⁶ N m"
  std::string times_unit(const std::string& unit) const;

 private:
  int exponent_ = 0, decimals_ = 2;
};

/// Two digits and a sign: "−3 × 10⁻¹⁷", "0"; a dash for what is not finite.
std::string signed_short(double value);

/// The same with both digits always: "0.30", "−3.0 × 10⁻¹⁷".
std::string two_digits(double value);

/// As few digits as tell it from other doubles: "4.56", "0.001".
std::string plain_number(double value);

/// Which third of the model's span t lies in, 0, 1 or 2; the span repeats.
int third_at(const SceneModel& model, double t_s);

/// The largest absolute value of a component of `quantity` over the model's span and at t: what a diagram's
/// scale and decimals go by, so that they stand still in a film. 97 evaluations of ω.
double largest_over_span(const SceneModel& model, double t_s,
                         const std::function<Vec3(const Vec3& w_B)>& quantity);

/// (x, y, z) → (y z, z x, x y)
inline Vec3 cyclic_products(const Vec3& a) { return {a[1] * a[2], a[2] * a[0], a[0] * a[1]}; }
/// (I3 − I2, I1 − I3, I2 − I1)
inline Vec3 cyclic_differences(const Vec3& a) { return {a[2] - a[1], a[0] - a[2], a[1] - a[0]}; }

class DiagramPaper {
 public:
  /// @param box that it fills (diagram_box); extent: its width and height in sizes of its type
  DiagramPaper(const Vec2& extent, const PixelBox& box, const DiagramStyle& style, const Fonts& fonts);

  const DiagramStyle& style() const { return style_; }
  const Vec2& extent() const { return extent_; }
  Color ink_of(const Role& role) const { return on_its_paper(role.ink); }
  Color paint_of(const Role& role) const { return on_its_paper(role.paint); }
  /// Of what belongs to axis i = 0, 1, 2.
  Color paint_of_axis(int i) const { return on_its_paper(kBodyAxisRoles[static_cast<std::size_t>(i)].paint); }

  struct Type {
    double align = 0;  ///< 0: `at` is the left end of the baseline, 0.5: its middle, 1: its right end
    double size = 1;
    bool quiet = false;
    bool bold = false;
  };
  /// A formula in display style; ω, L, N have the colours of their roles.
  void math(const std::string& tex, const Vec2& at, const Type& type);
  void math(const std::string& tex, const Vec2& at) { math(tex, at, Type()); }
  /// A line of sans text, formulas between `$`.
  void text(const std::string& text, const Vec2& at, const Type& type);
  void text(const std::string& line, const Vec2& at) { text(line, at, Type()); }

  void line(const Vec2& from, const Vec2& to, double width, const Color& color, double dash = 0);
  void path(std::vector<Vec2> points, double width, const Color& color);
  /// A filled rectangle between any two opposite corners.
  void bar(const Vec2& corner, const Vec2& opposite, const Color& color);
  void area(std::vector<Vec2> points, const Color& color);
  /// Round corners.
  void panel(const Vec2& corner, const Vec2& opposite, const Color& color);
  void disc(const Vec2& middle, double radius, const Color& color);
  /// A plot on paper of its own, between any two corners.
  void plot(const WorkPrecisionPlot& plot, const Vec2& corner, const Vec2& opposite);

  Sheet take() { return std::move(sheet_); }

 private:
  Color on_its_paper(const Color& color) const { return is_dark(style_.paper) ? on_dark(color) : color; }
  Vec2 px(const Vec2& at) const { return corner_ + unit_ * at; }
  void place(DisplayList list, const Vec2& at, double align, const std::string& text);
  DisplayList set(const std::string& tex, double size, bool quiet) const;

  DiagramStyle style_;
  const Fonts& fonts_;
  Vec2 extent_;
  double unit_;
  Vec2 corner_;
  std::vector<MathSymbol> symbols_;
  Sheet sheet_;
};

enum class Arrangement { wide, tall };

/// What a diagram draws, and the room it needs for that.
struct DiagramKind {
  Vec2 wide, tall;  ///< equal where there is one arrangement alone
  void (*draw)(const SceneModel& model, double t_s, Arrangement arrangement, DiagramPaper& paper);
  /// Of one that takes all the room of its box: how far it grows beyond `wide`, which is the least then.
  /// Zero: it does not.
  Vec2 most = {0, 0};
};

/// The overlays on paper; each kind is defined in the file of its name.
extern const DiagramKind kTensorBars, kCofactors, kCyclicWheel, kEnergyRows, kMomentumRows, kCards,
    kMethodTable, kOrderPlot;
struct OverlayKind {
  Overlay overlay;
  const DiagramKind* kind;
};
inline constexpr std::array kKinds = {
    OverlayKind{Overlay::tensor_bars, &kTensorBars},     OverlayKind{Overlay::cofactors, &kCofactors},
    OverlayKind{Overlay::cyclic_wheel, &kCyclicWheel},   OverlayKind{Overlay::energy_rows, &kEnergyRows},
    OverlayKind{Overlay::momentum_rows, &kMomentumRows}, OverlayKind{Overlay::cards, &kCards},
    OverlayKind{Overlay::method_table, &kMethodTable},   OverlayKind{Overlay::order_plot, &kOrderPlot}};

}  // namespace polhode::diagrams
