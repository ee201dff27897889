// SPDX-License-Identifier: MIT
#include "app/window/screen/page_view.h"

#include "app/page/text/text_column.h"
#include "render/gl/type_on_figure.h"
#include "render/typeset/paragraph.h"

#include <algorithm>

namespace polhode {

namespace {

PageRequest request_of(const LessonSession& session, const PageLook& look) {
  const auto number = session.stage_number(session.place().stage);
  return {
      .lesson = session.lesson(),
      .stage = session.stage(),
      .number = static_cast<int>(session.place().stage) + 1,
      .counted_as = number ? std::optional(PageRequest::Count{number->number, number->count}) : std::nullopt,
      .step = static_cast<int>(session.place().step) + 1,
      .model = session.model(),
      .t_s = session.t_s(),
      .size = look.size,
      .theme = session.preferences.theme,
      .quality = {},
      .text_scale = session.preferences.text_scale,
      .runs = true,
      .scrolls = !look.fits,
      .display_scale = look.scale,
      .covered = look.covered,
      .derivation = session.shown_derivation()};
}

/// Of the column, what is scrolled away under the figure above it: lines as a whole, boxes and bars in part.
void hide_above_ceiling(Page& page) {
  const auto shapes = static_cast<std::ptrdiff_t>(page.column_shapes);
  const auto is_hidden = [&](FlatShape& shape) {
    const Stroke* stroke = std::get_if<Stroke>(&shape);
    const double highest = page.ceiling + (stroke ? 0.5 * stroke->width : 0.0);
    return std::visit(
        [&](auto& drawn) {
          bool is_seen = false;
          for (Vec2& point : drawn.points) {
            is_seen = is_seen || point.y() > highest;
            point.y() = std::max(point.y(), highest);
          }
          return !is_seen;
        },
        shape);
  };
  std::vector<FlatShape>& all = page.sheet.shapes;
  all.erase(std::remove_if(all.begin(), all.begin() + shapes, is_hidden), all.begin() + shapes);
  for (std::size_t i = 0; i < page.column_texts; ++i) {
    constexpr double kTall = 0.75;  // of the type's size, above its line
    PlacedType& text = page.sheet.texts[i];
    std::erase_if(text.list.glyphs, [&](const Glyph& glyph) {
      return text.at.y() + glyph.y - kTall * static_cast<double>(glyph.size) < page.ceiling;
    });
    std::erase_if(text.list.rules,
                  [&](const Rule& rule) { return text.at.y() + std::min(rule.y0, rule.y1) < page.ceiling; });
  }
}

}  // namespace

PageView::PageKey PageView::key_of(const LessonSession& session, const PageLook& look) const {
  const SceneModel* model = session.model();
  return {{session.loaded_pointer(), session.place(), session.stage_number(session.place().stage),
           session.model_number(), look.size, look.scale, session.has_scene() ? 0 : look.covered,
           session.preferences, session.shown_derivation()},
          look,
          session.t_s(),
          session.transition(),
          session.camera(),
          model ? model->scene.quality : QualityLevel::normal,
          session.lit(),
          hidden_};
}

Status PageView::compose(const LessonSession& session, const PageKey& key) {
  PageRequest request = request_of(session, key.look);
  const Fonts& fonts = renderer_.fonts();
  const bool may_keep = text_ && key.look.keep_text && text_key_->place == key.text.place &&
                        text_key_->loaded == key.text.loaded && text_key_->size == key.text.size;
  if (!may_keep && !(text_ && text_key_ == key.text)) {
    if (!text_key_ || text_key_->loaded != key.text.loaded) still_numbers_ = StillNumbers(session.effort());
    request.still_numbers = &still_numbers_;
    request.effort = session.effort();
    Result<FittedText> text = text_of_page(request, fonts);
    if (!text) return failure(text.error());  // what there is stays whole
    from_ = text_ && is_step_before(*text_key_, key.text) ? std::move(text_) : std::nullopt;
    text_ = std::move(text).value();
    text_key_ = key.text;
  }
  if (hidden_) scroll_to(*text_, *hidden_);
  if (session.transition() < 1 && !from_ && request.step > 1) {  // seen again
    PageRequest before = request;
    --before.step;
    if (Result<FittedText> text = text_of_page(before, fonts)) from_ = std::move(text).value();
  }
  if (session.transition() < 1)
    request.entrance = TurningInto{from_ ? &*from_ : nullptr, session.transition()};
  page_ =
      key.look.is_enlarged ? compose_picture(request, *text_, fonts) : compose_page(request, *text_, fonts);
  hold_frame(key);
  symbols_ = symbols_on(page_.sheet, fonts);
  column_symbols_ = 0;
  figure_names_.reset();
  type_beside_text_.reset();
  if (page_.overflow > 0) {
    const auto first = page_.sheet.texts.begin();
    Sheet column{.shapes = {}, .over_insets = {}, .texts = {}};
    column.texts.assign(first, first + static_cast<std::ptrdiff_t>(page_.column_texts));
    column_symbols_ = symbols_on(column, fonts).size();
    if (page_.hidden > 0 && page_.ceiling > 0) hide_above_ceiling(page_);
  }
  const PageColors& colors = colors_of(request.theme);
  for (FlatShape& mark : marks_of(symbols_, key.lit, key.look.focus, colors.marked, colors.question,
                                  page_.scale * 16 * key.look.scale))
    page_.sheet.shapes.push_back(std::move(mark));
  for (Inset& inset : page_.insets) inset.resolution = key.look.resolution;
  return success();
}

void PageView::hold_frame(const PageKey& key) {
  Frame now{key.text.place, key.look.size, key.look.covered, key.look.is_enlarged};
  for (const Inset& inset : page_.insets)
    for (const Pane& pane : inset.figure.panes) now.cameras.push_back(pane.camera);
  if (!key.look.holds_frame || !frame_.is_for(now)) {
    frame_ = std::move(now);
    return;
  }
  auto held = frame_.cameras.begin();
  for (Inset& inset : page_.insets)
    for (Pane& pane : inset.figure.panes) pane.camera = *held++;
}

bool PageView::reads_the_same(const TextKey& before, const TextKey& now) {
  return before.loaded == now.loaded && before.place == now.place && before.size == now.size &&
         before.covered == now.covered && before.preferences.text_scale == now.preferences.text_scale &&
         before.derivation == now.derivation;
}

bool PageView::scroll(double by_px) {
  if (!text_) return false;
  const double before = hidden_.value_or(text_->hidden);
  hidden_ = std::clamp(before + by_px, 0.0, text_->overflow);
  return *hidden_ != before;
}

bool PageView::has_small_type() const {
  const double least = kLeastSmall * (shown_ ? shown_->look.scale : 1.0) - 0.01;
  const auto is_small = [least](const PlacedType& text) {
    double size = 0;  // without what is raised or lowered in it
    for (const Glyph& glyph : text.list.glyphs) size = std::max(size, glyph.size);
    return size > 0 && size < least;
  };
  const std::vector<PlacedType>& texts = page_.sheet.texts;
  return std::any_of(texts.begin() + static_cast<std::ptrdiff_t>(page_.column_texts), texts.end(), is_small);
}

void PageView::scroll_to_see(double y0, double y1) {
  if (!text_ || !picture_) return;
  const double bottom = std::max(page_.column.y0, page_.column.y1);
  if (y0 < page_.column.y0) scroll(y0 - page_.column.y0);
  if (y0 >= page_.column.y0 && y1 > bottom) scroll(y1 - bottom);
}

std::size_t PageView::first_seen() const {
  std::size_t first = 0;
  while (is_scrolled(first) && symbols_[first].box.y0 < page_.column.y0) ++first;
  return first;
}

std::optional<std::size_t> PageView::symbol_under(const Vec2& at, double reach) const {
  const auto hidden = static_cast<std::ptrdiff_t>(at.y() < page_.ceiling ? column_symbols_ : 0);
  if (hidden == 0) return symbol_at(symbols_, at, reach);
  const std::vector<PageSymbol> seen(symbols_.begin() + hidden, symbols_.end());
  const auto found = symbol_at(seen, at, reach);
  return found ? std::optional(*found + static_cast<std::size_t>(hidden)) : std::nullopt;
}

std::optional<PageSymbol> PageView::figure_name_at(const LessonSession& session, const Vec2& at,
                                                   double reach) const {
  const Fonts& fonts = renderer_.fonts();
  if (!figure_names_) {
    const std::vector<MathSymbol> symbols = symbols_of(session.lesson(), session.preferences.theme);
    figure_names_.emplace();
    for (const Inset& inset : page_.insets) {
      const Vec2 corner(inset.place.x, inset.place.y);
      for (const PlacedType& text : type_on_figure(inset, fonts)) {
        TextStyle style;
        style.size = text.list.glyphs.empty() ? 1 : text.list.glyphs.front().size;
        style.sans = true;
        style.symbols = &symbols;
        Sheet sheet{.shapes = {}, .over_insets = {}, .texts = {}};
        sheet.texts.push_back({.list = set_line(text.text, style, fonts), .at = text.at + corner});
        for (PageSymbol& symbol : symbols_on(sheet, fonts)) figure_names_->push_back(std::move(symbol));
      }
    }
  }
  const auto found = symbol_at(*figure_names_, at, reach);
  return found ? std::optional((*figure_names_)[*found]) : std::nullopt;
}

const std::vector<PixelBox>& PageView::type_beside_text() const {
  if (type_beside_text_) return *type_beside_text_;
  type_beside_text_.emplace();
  const auto add = [&](const PlacedType& text, const Vec2& corner) {
    const Vec2 at = text.at + corner;
    type_beside_text_->push_back(
        {at.x(), at.y() - text.list.ascent, at.x() + text.list.width, at.y() + text.list.depth});
  };
  for (const Inset& inset : page_.insets)
    for (const PlacedType& text : type_on_figure(inset, renderer_.fonts()))
      add(text, Vec2(inset.place.x, inset.place.y));
  for (std::size_t i = page_.column_texts; i < page_.sheet.texts.size(); ++i)
    add(page_.sheet.texts[i], Vec2(0, 0));
  return *type_beside_text_;
}

const ColumnPiece* PageView::piece_at(const Vec2& at) const {
  if (!text_ || at.y() < page_.ceiling) return nullptr;
  const double reach = 4 * page_.scale;
  const auto holds = [&](const PlacedType& text) {
    const Vec2 from = text.at + text_->corner;
    return at.x() >= from.x() - reach && at.x() < from.x() + text.list.width + reach &&
           at.y() >= from.y() - text.list.ascent - reach && at.y() < from.y() + text.list.depth + reach;
  };
  const ColumnPiece* found = nullptr;
  for (const ColumnPiece& piece : text_->stack.pieces)
    if (std::any_of(piece.sheet.texts.begin(), piece.sheet.texts.end(), holds)) found = &piece;
  return found;
}

bool PageView::speaks_of_shown_motion(const LessonSession& session, const PageSymbol& symbol) const {
  const TypeBox& box = symbol.box;
  const ColumnPiece* piece = piece_at({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)});
  if (piece == nullptr || piece->step == 0) return true;
  const Step& step = session.stage().steps[static_cast<std::size_t>(piece->step) - 1];
  if (&step == &session.step()) return true;
  return step.scene && session.has_scene() && same_course(*step.scene, *session.step().scene);
}

const Block* PageView::block_at(const LessonSession& session, const Vec2& at) const {
  const ColumnPiece* piece = piece_at(at);
  const void* found = piece != nullptr ? piece->of : nullptr;
  for (const Step& step : session.stage().steps)
    for (const Block& block : step.blocks)
      if (&block == found) return &block;
  return nullptr;
}

bool PageView::is_step_before(const TextKey& before, const TextKey& now) {
  return before.loaded == now.loaded && before.place.stage == now.place.stage &&
         before.place.step + 1 == now.place.step && before.size == now.size &&
         before.preferences == now.preferences;
}

Result<bool> PageView::show(const LessonSession& session, const PageLook& look) {
  PageKey key = key_of(session, look);
  if (text_key_ && !reads_the_same(*text_key_, key.text)) key.hidden = hidden_ = std::nullopt;
  if (shown_ == key && picture_) return false;
  if (Status composed = compose(session, key); !composed) return failure(composed.error());
  if (!picture_ || picture_->size() != look.size) {
    picture_.reset();
    auto made = Framebuffer::create(gl_, look.size, 0);
    if (!made) return failure(made.error());
    picture_ = std::move(made).value();
  }
  const Background paper{Background::Kind::color, colors_of(session.preferences.theme).paper};
  if (Status painted = renderer_.paint(page_.sheet, page_.insets, paper, *picture_); !painted)
    return failure(painted.error());
  shown_ = key;
  return true;
}

}  // namespace polhode
