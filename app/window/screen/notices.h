// SPDX-License-Identifier: MIT
// The strip above the bar: errors of the lesson until they are mended, and what is told for a few seconds.
#pragma once

#include "app/page/page_theme.h"
#include "app/window/panels/panel_context.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// The text on lines of at most this width: broken at spaces, and where a word alone is wider, a path say,
/// behind a slash of it, so that the names of folders and files stay whole. What has neither is left as it
/// is.
std::string on_lines(std::string_view text, float width,
                     const std::function<float(std::string_view)>& width_of);

class Notices {
 public:
  void tell(const std::string& text);
  const std::string& told() const { return text_; }  ///< last
  /// Whether no frame has begun since it was told.
  bool is_new() const { return !until_s_; }
  /// What is told is told from the frame on that shows it, however long nobody did anything before.
  void begin_frame(double clock_s);
  void set_lesson_errors(std::string errors) { lesson_errors_ = std::move(errors); }
  void set_page_error(std::string error) { page_error_ = std::move(error); }

  /// Just above the lower edge of the page, no wider than the words.
  void draw(const Region& page, Theme theme, float padding, double clock_s) const;
  /// How high it is there with what is between it and the edge; 0: nothing is told.
  float height(const Region& page, float padding, double clock_s) const;
  /// Until what was told goes; nothing: it is gone.
  std::optional<double> seconds_left(double clock_s) const;

 private:
  std::string shown(double clock_s) const;
  static std::string on_lines_of(const Region& page, float padding, const std::string& text);

  std::string text_, lesson_errors_, page_error_;
  std::optional<double> until_s_;  ///< of the clock; nothing: it is new
};

}  // namespace polhode
