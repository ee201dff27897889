// SPDX-License-Identifier: MIT
#include "app/page/live_numbers.h"

#include "app/narration/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace polhode {

namespace {

constexpr const char* kDots = "\\ldots";
constexpr const char* kDash = "\\text{–}";
/// So many times of the scene's interval say how wide a number becomes.
constexpr int kWidthTimes = 25;

Math read_math(const std::string& tex, Language language) { return parse_math(tex, {}, language).value(); }

std::string tex_of(const ComputedNumber& number, std::optional<double> value) {
  return value ? number_tex(*value, number.written.digits) : number.row ? kDash : kDots;
}

/// What stands behind the place of the decimal point: "2.25" has ".25", "3{\cdot}10^{8}" all behind the 3.
std::string behind_point(const std::string& tex) {
  if (tex == kDash) return "";
  return tex.substr(std::min(tex.find_first_not_of("-0123456789"), tex.size()));
}

bool is_plain(const std::string& tex) { return tex.find('\\') == tex.npos; }

}  // namespace

double PageNumbers::width_em(const std::string& tex) const {
  MathStyle style;
  style.size = 100;  // on a fine grid
  const auto set = set_math(read_math(tex, lesson_->about.language), style, *fonts_);
  return set ? set->width / style.size : 0.0;
}

void PageNumbers::keep(int id, std::optional<double> value) {
  shown_.insert_or_assign(id, Shown{tex_of(lesson_->numbers[static_cast<std::size_t>(id)], value)});
}

void PageNumbers::run(int id, const std::vector<double>& values) {
  const ComputedNumber& number = lesson_->numbers[static_cast<std::size_t>(id)];
  std::set<std::string> texts;
  for (const double value : values) texts.insert(tex_of(number, value));
  Shown widest;
  for (const std::string& tex : texts)
    if (const double width = width_em(tex); width > widest.width_em) widest = {tex, true, width};
  shown_.insert_or_assign(id, std::move(widest));
}

Math PageNumbers::put_into(const Math& math) const {
  if (math.live.empty()) return math;
  std::vector<ShownNumber> shown;
  for (const LiveNumber& number : math.live) {
    const auto found = shown_.find(number.id);
    if (!number.typed.empty())
      shown.emplace_back();
    else if (found == shown_.end())
      shown.push_back({read_math(kDots, math.language)});
    else
      shown.push_back({read_math(found->second.tex, math.language),
                       found->second.runs ? live_name(static_cast<std::size_t>(number.id)) : ""});
  }
  return with_numbers(math, shown);
}

/// What each number of a column lacks of the widest that stands behind a point there, em.
std::map<int, double> PageNumbers::rooms_behind(const TextTable& table) const {
  std::map<int, double> rooms;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::map<int, double> widths;
    double widest = 0;
    for (const auto& row : table.rows)
      for (const TextSpan& span : row[c])
        for (const LiveNumber& number : span.math.live) {
          const auto shown = shown_.find(number.id);
          if (shown == shown_.end() || !lesson_->numbers[static_cast<std::size_t>(number.id)].row) continue;
          const std::string behind = behind_point(shown->second.tex);
          const double width = behind.empty() ? 0.0 : width_em(behind);
          widths.emplace(number.id, width);
          widest = std::max(widest, width);
        }
    for (const auto& [id, width] : widths) rooms.emplace(id, widest - width);
  }
  return rooms;
}

RichText PageNumbers::put_into(RichText text) const {
  for (TextBlock& block : text) {
    const std::map<int, double> rooms =
        block.is_table() ? rooms_behind(block.table) : std::map<int, double>();
    for (auto& row : block.table.rows)
      for (TextTable::Cell& cell : row)
        for (TextSpan& span : cell) {
          if (span.math.live.size() != 1) continue;
          const auto room = rooms.find(span.math.live.front().id);
          if (room == rooms.end()) continue;
          const std::string space = fmt::format("\\hspace{{{:.4f}em}}", room->second);
          span.math =
              with_numbers(span.math, {{read_math(shown_.at(room->first).tex + space, span.math.language)}});
        }
  }
  for_each_span(text, [this](TextSpan& span) { span.math = put_into(span.math); });
  return text;
}

std::vector<LiveRoom> PageNumbers::take_rooms(DisplayList& list) const {
  std::map<std::int16_t, int> ids;  // by the indices of their names
  for (const auto& [id, shown] : shown_) {
    const auto name =
        std::find(list.names.begin(), list.names.end(), live_name(static_cast<std::size_t>(id)));
    if (name != list.names.end()) ids.emplace(static_cast<std::int16_t>(name - list.names.begin()), id);
  }
  std::vector<LiveRoom> rooms;
  if (ids.empty()) return rooms;
  std::set<int> taken;
  const auto take = [&](const Glyph& glyph) {
    const auto found = ids.find(glyph.naming.term);
    if (found == ids.end()) return false;
    const int id = found->second;
    if (taken.insert(id).second)
      rooms.push_back(
          {id, Vec2(glyph.x, glyph.y), shown_.at(id).width_em * glyph.size, glyph.size, glyph.color});
    return true;
  };
  list.glyphs.erase(std::remove_if(list.glyphs.begin(), list.glyphs.end(), take), list.glyphs.end());
  return rooms;
}

PlacedType live_number_in(const LiveRoom& room, const ComputedNumber& number, std::optional<double> value,
                          Language language, const Fonts& fonts) {
  const Math math = read_math(tex_of(number, value), language);
  MathStyle style;
  style.size = room.size;
  style.color = room.color;
  DisplayList list = set_math(math, style, fonts).value();
  if (list.width > room.width * (1 + 1e-9)) {
    style.size *= room.width / list.width;
    list = set_math(math, style, fonts).value();
  }
  const Vec2 at = room.at + Vec2(room.width - list.width, 0);
  return {.list = std::move(list), .at = at};
}

std::map<int, std::vector<double>> values_over(const SceneModel& model, const Lesson& lesson,
                                               const std::vector<int>& ids) {
  std::map<int, std::vector<double>> values;
  if (ids.empty()) return values;
  for (int n = -1; n < kWidthTimes; ++n) {
    const double t_s =
        n < 0 ? still_time_s(model.scene) : std::min(model.span_s, model.reach_s) * n / (kWidthTimes - 1);
    const auto live = live_state(model, t_s);
    for (const int id : ids)
      if (const auto value =
              live ? value_of(lesson.numbers[static_cast<std::size_t>(id)], *live) : std::nullopt)
        values[id].push_back(*value);
  }
  return values;
}

LongestNumbers longest_in_captions(const Lesson& lesson, const Step& step, const SceneModel& model) {
  LongestNumbers longest;
  const std::vector<const SceneModel*> shown = shown_models(model);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const RichText* caption = caption_of(step, i);
    if (caption == nullptr) continue;
    for (const auto& [id, values] : values_over(*shown[i], lesson, numbers_in(*caption)))
      for (const double value : values) {
        const std::string tex = tex_of(lesson.numbers[static_cast<std::size_t>(id)], value);
        if (tex.size() > longest[id].size() && is_plain(tex)) longest[id] = tex;
      }
  }
  return longest;
}

namespace {

/// @param written as the scene has it; `caption`, read
std::string caption_at(const Lesson& lesson, const std::string& written, const RichText* caption,
                       const SceneModel& model, double t_s, const LongestNumbers& longest,
                       CaptionBlanks blanks) {
  if (caption == nullptr || written.empty() || numbers_in(*caption).empty()) return written;
  const auto live = live_state(model, t_s);
  std::string line, lacking;
  const auto add_formula = [&](const TextSpan& span) {
    std::string tex;
    std::size_t at = 0;
    for (const LiveNumber& number : span.math.live) {
      if (!number.typed.empty()) continue;
      tex += span.text.substr(at, number.whole.begin - at);
      at = number.whole.end;
      const ComputedNumber& computed = lesson.numbers[static_cast<std::size_t>(number.id)];
      const std::string now = tex_of(computed, live ? value_of(computed, *live) : std::nullopt);
      const auto widest = longest.find(number.id);
      if (widest != longest.end() && is_plain(now) && now.size() < widest->second.size())
        (blanks == CaptionBlanks::behind ? lacking : tex) +=
            "\\hphantom{" + widest->second.substr(0, widest->second.size() - now.size()) + '}';
      tex += '{' + now + '}' + unit_tex(number.unit);
    }
    line += '$' + tex + span.text.substr(at) + '$';
  };
  for_each_span(*caption, [&](const TextSpan& span) {
    if (span.kind == TextSpan::Kind::math) return add_formula(span);
    for (const char c : span.text) line += c == '$' ? std::string("\\$") : std::string(1, c);
  });
  return lacking.empty() ? line : line + '$' + lacking + '$';
}

}  // namespace

std::vector<std::string> captions_at(const Lesson& lesson, const Step& step, const SceneModel& model,
                                     double t_s, const LongestNumbers& longest, CaptionBlanks blanks) {
  std::vector<std::string> captions;
  for (const SceneModel* shown : shown_models(model))
    captions.push_back(caption_at(lesson, shown->scene.caption, caption_of(step, captions.size()), *shown,
                                  t_s, longest, blanks));
  return captions;
}

std::vector<std::string> lesson_captions_at(const Lesson& lesson, const Step& step, const SceneModel& model,
                                            double t_s, const LongestNumbers& longest, CaptionBlanks blanks) {
  const std::vector<const Scene*> scenes = shown_scenes(*step.scene);
  std::vector<std::string> captions;
  for (const SceneModel* shown : shown_models(model)) {
    const std::size_t i = std::min(captions.size(), scenes.size() - 1);
    captions.push_back(
        caption_at(lesson, scenes[i]->caption, caption_of(step, i), *shown, t_s, longest, blanks));
  }
  return captions;
}

}  // namespace polhode
