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
  void tell(const std::string& text, double clock_s);
  const std::string& told() const { return text_; }  ///< last
  double told_at_s() const { return told_s_; }       ///< by the clock
  void set_lesson_errors(std::string errors) { lesson_errors_ = std::move(errors); }
  void set_page_error(std::string error) { page_error_ = std::move(error); }

  /// Just above the lower edge of the page, no wider than the words.
  void draw(const Region& page, Theme theme, float padding, double clock_s) const;
  /// Until what was told goes; nothing: it is gone.
  std::optional<double> seconds_left(double clock_s) const;

 private:
  std::string text_, lesson_errors_, page_error_;
  double told_s_ = 0, until_s_ = 0;  ///< of the clock
};

}  // namespace polhode
