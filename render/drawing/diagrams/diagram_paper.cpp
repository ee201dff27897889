// SPDX-License-Identifier: MIT
#include "render/drawing/diagrams/diagram_paper.h"

#include "base/numbers.h"
#include "render/drawing/log_axis.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode::diagrams {
namespace {

MathSymbol symbol(const char* tex, const Color& color) { return {tex, parse_math(tex).value(), color}; }

std::string fixed_or_short(double value, int decimals) {
  constexpr std::size_t kMostSigns = 64;
  const std::string text = fixed(value, decimals);
  return text.size() <= kMostSigns ? text : short_number(value);
}

}  // namespace

NumberForm::NumberForm(double largest, int digits) : decimals_(digits - 1) {
  if (!(largest > 0.0) || !std::isfinite(largest)) return;
  const int magnitude = static_cast<int>(std::floor(std::log10(largest)));
  if (magnitude < -1 || magnitude > 3) exponent_ = 3 * static_cast<int>(std::floor(magnitude / 3.0));
  decimals_ = std::clamp(digits - 1 - (magnitude - exponent_), 0, digits);
}

std::string NumberForm::text(double value) const {
  if (!std::isfinite(value)) return "–";
  const std::string digits = fixed_or_short(std::abs(value) * std::pow(10.0, -exponent_), decimals_);
  const bool is_zero = digits.find_first_of("123456789") == digits.npos;
  return (value < 0.0 && !is_zero ? "−" : "") + digits;
}

std::string NumberForm::residual(double value) const {
  return signed_short(value * std::pow(10.0, -exponent_));
}

std::string NumberForm::unit(const std::string& unit) const {
  return exponent_ == 0 ? unit : power_of_ten(exponent_) + " " + unit;
}

std::string NumberForm::times_unit(const std::string& unit) const {
  return (exponent_ == 0 ? " " : " × ") + this->unit(unit);
}

std::string signed_short(double value) {
  if (!std::isfinite(value)) return "–";
  return (value < 0.0 ? "−" : "") + short_number(std::abs(value));
}

std::string two_digits(double value) {
  if (!std::isfinite(value)) return "–";
  if (value == 0.0) return "0";
  const std::string text = scientific(std::abs(value), 1);  // d.de±dd
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  const std::string sign = value < 0.0 ? "−" : "";
  if (exponent >= -2 && exponent <= 1) return sign + fixed_or_short(std::abs(value), 1 - exponent);
  return sign + text.substr(0, e) + " × " + power_of_ten(exponent);
}

std::string plain_number(double value) { return shortest(value); }

int third_at(const SceneModel& model, double t_s) {
  const double turns = t_s / model.span_s, part = turns - std::floor(turns);
  return std::isfinite(part) ? std::min(2, static_cast<int>(3.0 * part)) : 0;
}

double largest_over_span(const SceneModel& model, double t_s,
                         const std::function<Vec3(const Vec3& w_B)>& quantity) {
  constexpr int kSamples = 96;
  double largest = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = i == 0 ? t_s : std::min(model.span_s * i / kSamples, model.reach_s);
    const double value = quantity(model.motion->w_B_at(t)).cwiseAbs().maxCoeff();
    if (value > largest && std::isfinite(value)) largest = value;
  }
  return largest;
}

DiagramPaper::DiagramPaper(const Vec2& extent, const PixelBox& box, const DiagramStyle& style,
                           const Fonts& fonts)
    : style_(style),
      fonts_(fonts),
      extent_(extent),
      unit_(box.width() / extent.x()),
      corner_(box.x0, box.y0) {
  symbols_ = {symbol("\\vec\\omega", ink_of(kOmegaRole)), symbol("\\dot{\\vec\\omega}", ink_of(kOmegaRole)),
              symbol("\\vec L", ink_of(kLRole)), symbol("\\vec N", ink_of(kNRole))};
}

DisplayList DiagramPaper::set(const std::string& tex, double size, bool quiet) const {
  MathStyle style;
  style.size = size * unit_;
  style.display = true;
  style.color = quiet ? style_.muted : style_.ink;
  style.symbols = quiet ? nullptr : &symbols_;
  return set_math(parse_math(tex).value(), style, fonts_).value();
}

void DiagramPaper::place(DisplayList list, const Vec2& at, double align, const std::string& text) {
  const Vec2 where = px(at);
  const double left = where.x() - align * list.width;
  sheet_.texts.push_back({.list = std::move(list), .at = {left, std::round(where.y())}, .text = text});
}

void DiagramPaper::math(const std::string& tex, const Vec2& at, const Type& type) {
  place(set(tex, type.size, type.quiet), at, type.align, '$' + tex + '$');
}

void DiagramPaper::text(const std::string& text, const Vec2& at, const Type& type) {
  TextStyle style;
  style.size = type.size * unit_;
  style.color = type.quiet ? style_.muted : style_.ink;
  style.sans = true;
  style.bold = type.bold;
  place(set_line(text, style, fonts_), at, type.align, text);
}

void DiagramPaper::line(const Vec2& from, const Vec2& to, double width, const Color& color, double dash) {
  sheet_.shapes.push_back(Stroke{{px(from), px(to)}, width * unit_, color, dash * unit_});
}

void DiagramPaper::path(std::vector<Vec2> points, double width, const Color& color) {
  for (Vec2& p : points) p = px(p);
  sheet_.shapes.push_back(Stroke{std::move(points), width * unit_, color, 0.0});
}

void DiagramPaper::area(std::vector<Vec2> points, const Color& color) {
  for (Vec2& p : points) p = px(p);
  sheet_.shapes.push_back(Area{std::move(points), color});
}

void DiagramPaper::bar(const Vec2& corner, const Vec2& opposite, const Color& color) {
  area({corner, {opposite.x(), corner.y()}, opposite, {corner.x(), opposite.y()}}, color);
}

void DiagramPaper::panel(const Vec2& corner, const Vec2& opposite, const Color& color) {
  constexpr double kRadius = 0.3;
  constexpr int kSteps = 6;  // of a quarter of a circle
  const Vec2 low = corner.cwiseMin(opposite), high = corner.cwiseMax(opposite);
  std::vector<Vec2> points;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec2 middle(quarter == 0 || quarter == 3 ? high.x() - kRadius : low.x() + kRadius,
                      quarter < 2 ? high.y() - kRadius : low.y() + kRadius);
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = 0.5 * std::numbers::pi * (quarter + static_cast<double>(i) / kSteps);
      points.push_back(middle + kRadius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  area(std::move(points), color);
}

void DiagramPaper::disc(const Vec2& middle, double radius, const Color& color) {
  line(middle, middle, 2.0 * radius, color);
}

void DiagramPaper::plot(const WorkPrecisionPlot& plot, const Vec2& corner, const Vec2& opposite) {
  WorkPrecisionPlot on_paper = plot;
  on_paper.paper = style_.paper;
  on_paper.ink = style_.ink;
  on_paper.muted = style_.muted;
  on_paper.grid = style_.line;
  const Vec2 from = px(corner), size = px(opposite) - from;
  append(sheet_, lay_out(on_paper, size.x(), size.y(), fonts_), from);
}

}  // namespace polhode::diagrams
