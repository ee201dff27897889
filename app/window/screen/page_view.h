// SPDX-License-Identifier: MIT
// The page of a session in a framebuffer: the page that export writes, drawn anew only where something has
// changed.
#pragma once

#include "app/narration/still_numbers.h"
#include "app/page/page.h"
#include "app/page/text/page_text.h"
#include "app/session/lesson_session.h"
#include "app/session/page_symbols.h"
#include "render/gl/framebuffer.h"

namespace polhode {

/// What decides a page's pixels apart from the session.
struct PageLook {
  Size size;
  double scale = 1;                    ///< of the display: 1 for about 96 dots per inch
  std::optional<std::size_t> focus{};  ///< place among symbols(): has a ring
  double resolution = 1;               ///< of figures, while something moves
  bool keep_text = false;              ///< while ω is dragged: the text as it was set before
  bool holds_frame = false;            ///< the cameras stand as they are: a hand changes the body
  double covered = 0;                  ///< px at the right edge that a panel lies over
  bool is_enlarged = false;            ///< the figure and its plots alone
  bool fits = false;                   ///< nothing is scrolled: the text is as small as it has to be
  bool operator==(const PageLook&) const = default;
};

class PageView {
 public:
  /// Both outlive it.
  PageView(const Gl& gl, Renderer& renderer) : gl_(gl), renderer_(renderer) {}

  /// Draws what has changed; false: nothing has. Text that cannot be set (a symbol that no font has) is an
  /// error.
  Result<bool> show(const LessonSession& session, const PageLook& look);

  /// Moves the text of the shown step up, px, as far as there is more of it. Another step, or another size,
  /// begins where it is read from. False: there is no more of it.
  bool scroll(double by_px);
  /// Of the symbols, those that are not above what is seen of a text that is scrolled: the first of them.
  std::size_t first_seen() const;
  /// Whether it goes with the text that is scrolled.
  bool is_scrolled(std::size_t symbol) const { return symbol < column_symbols_; }
  /// So that what stands from y0 to y1 of the picture is seen.
  void scroll_to_see(double y0, double y1);

  const Framebuffer& picture() const { return *picture_; }  ///< precondition: shown
  const std::vector<PageSymbol>& symbols() const { return symbols_; }
  /// The place among them of the one within `reach` px of the pointer; none of what is scrolled away under
  /// the figure.
  std::optional<std::size_t> symbol_under(const Vec2& at, double reach) const;
  /// The name of a symbol in a figure that stands within `reach` px of the pointer; nothing: none does.
  std::optional<PageSymbol> figure_name_at(const LessonSession& session, const Vec2& at, double reach) const;
  /// Where type stands beside the text: names in figures, captions, plots. Precondition: shown
  const std::vector<PixelBox>& type_beside_text() const;
  /// Whether what the symbol stands in speaks of the motion that the figure shows: not a step above that has
  /// another.
  bool speaks_of_shown_motion(const LessonSession& session, const PageSymbol& symbol) const;
  /// The part of the stage's text that stands there; null: none does.
  const Block* block_at(const LessonSession& session, const Vec2& at) const;
  const std::vector<Inset>& insets() const { return page_.insets; }
  const Page& page() const { return page_; }
  /// Whether its diagrams have type that is too small to be read on a screen: they are as large as there is
  /// room for.
  bool has_small_type() const;

 private:
  /// What the layout of the text depends on.
  struct TextKey {
    std::shared_ptr<const LoadedLesson> loaded;
    StepPlace place;
    std::optional<LessonSession::StageNumber> number;
    unsigned model_number = 0;
    Size size;
    double scale = 1;
    double covered = 0;  ///< of a page without a figure, whose text stands aside
    Preferences preferences;
    ShownDerivation derivation;
    bool operator==(const TextKey&) const = default;
  };
  /// And the rest of the page.
  struct PageKey {
    TextKey text;
    PageLook look;
    double t_s = 0, transition = 1;
    CameraSpec camera;
    QualityLevel quality = QualityLevel::normal;
    std::string lit;
    std::optional<double> hidden{};
    bool operator==(const PageKey&) const = default;
  };
  PageKey key_of(const LessonSession& session, const PageLook& look) const;
  static bool reads_the_same(const TextKey& before, const TextKey& now);
  static bool is_step_before(const TextKey& before, const TextKey& now);
  Status compose(const LessonSession& session, const PageKey& key);
  void hold_frame(const PageKey& key);
  const ColumnPiece* piece_at(const Vec2& at) const;

  const Gl& gl_;
  Renderer& renderer_;
  std::optional<PageKey> shown_;
  std::optional<TextKey> text_key_;
  std::optional<FittedText> text_, from_;  ///< of this step, and of the one it was reached from
  std::optional<double> hidden_;           ///< where a reader has scrolled it to
  StillNumbers still_numbers_;             ///< of the lesson that text_key_ names
  Page page_;
  std::vector<PageSymbol> symbols_;
  mutable std::optional<std::vector<PageSymbol>>
      figure_names_;  ///< absent: not asked for since the page was made
  mutable std::optional<std::vector<PixelBox>> type_beside_text_;  ///< likewise
  /// Of the figures as they were fitted last, on this page.
  struct Frame {
    StepPlace place;
    Size size;
    double covered = 0;
    bool is_enlarged = false;
    std::vector<Camera> cameras{};
    bool is_for(const Frame& other) const {
      return place == other.place && size == other.size && covered == other.covered &&
             is_enlarged == other.is_enlarged && cameras.size() == other.cameras.size();
    }
  };
  Frame frame_;
  std::size_t column_symbols_ = 0;  ///< so many of the first are scrolled; 0: none
  std::optional<Framebuffer> picture_;
};

}  // namespace polhode
