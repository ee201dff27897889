// SPDX-License-Identifier: MIT
// Texts with formulas among controls, set as those of the page are. Each is a picture that is kept until what
// it is made of changes: the text, the room it has, the size of the controls, the theme.
#pragma once

#include "app/narration/still_numbers.h"
#include "app/page/page_theme.h"
#include "render/gl/framebuffer.h"
#include "render/gl/renderer.h"

#include <map>
#include <string>
#include <tuple>

namespace polhode {

/// The role of a text, which gives it its colour; symbols have their own.
enum class TextInk { plain, quiet, right, wrong };

class LessonTexts {
 public:
  /// Both must outlive it.
  LessonTexts(const Gl& gl, Renderer& renderer) : gl_(gl), renderer_(renderer) {}

  /// Before a frame whose controls show texts of this step, at `em` px of the controls' type. What the frame
  /// before did not show is let go. The lesson must outlive the frame.
  void begin_frame(const Lesson& lesson, const Step& step, Theme theme, float em);

  /// As an item of the present ImGui window, as wide as there is room; nothing of an empty text. A new text
  /// takes some 0.3 ms, one that was shown before nothing but its drawing. What cannot be set is shown as it
  /// is written.
  void show(const RichText& text, TextInk ink = TextInk::plain);
  /// The same with room around it, to be clicked; true: it was.
  bool row(const char* id, const RichText& text, TextInk ink = TextInk::plain);

  /// For tests: how many texts were set since the beginning.
  int count() const { return count_; }

 private:
  struct Picture {
    std::optional<Framebuffer> pixels;  ///< absent: the text cannot be set
    double width = 0, height = 0;       ///< of the item, without the margin around it
    unsigned frame = 0;                 ///< in which it was shown last
  };
  float height(const RichText& text, TextInk ink);
  using Key = std::tuple<std::string, TextInk, int>;
  Picture& picture_of(const RichText& text, TextInk ink, int width);
  Picture drawn(const RichText& text, TextInk ink, int width);
  RichText with_numbers(const RichText& text);
  Result<DisplayList> set(const RichText& text, TextInk ink, int width) const;

  const Gl& gl_;
  Renderer& renderer_;
  const Lesson* lesson_ = nullptr;
  const Step* step_ = nullptr;
  Theme theme_ = Theme::paper;
  double em_ = 0;
  std::vector<MathSymbol> symbols_;
  StillNumbers numbers_;
  std::map<Key, Picture> pictures_;
  unsigned frame_ = 0;
  int count_ = 0;
};

}  // namespace polhode
