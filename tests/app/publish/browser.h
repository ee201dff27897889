// SPDX-License-Identifier: MIT
// A headless Chromium that a test holds by its DevTools protocol, over a pipe: opens a page, presses keys,
// asks what is shown.
#pragma once

#include "base/vectors.h"
#include "tests/app/run_program.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace polhode {

class Browser {
 public:
  /// What draws its pages; WebGL is by Chromium's own software, which needs no graphics card.
  enum class Graphics { plain, webgl };
  /// Null where no Chromium is installed.
  static std::unique_ptr<Browser> start(int width, int height, Graphics graphics = Graphics::plain);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// A file, with what follows it in its address ("#part"); returns when the page has loaded.
  void open(const std::filesystem::path& file, const std::string& hash = "");
  void reload();
  /// As KeyboardEvent.key has it ("ArrowRight", "n"); "Shift+ArrowRight" with Shift held.
  void press(const std::string& key);
  void click(double x, double y);
  /// A finger that goes from one place to another.
  void swipe(double from_x, double to_x, double y);
  /// A finger put down and lifted.
  void tap(double x, double y);
  /// Two fingers beside this place, moved apart.
  void spread(const Vec2& about, double from_px, double to_px);
  /// The left button pressed, moved so often on a straight line, and let go.
  void drag(const Vec2& from, const Vec2& to);
  static constexpr int kMovesOfADrag = 5;
  void resize(int width, int height);
  /// A telephone of this size, with two pixels to each of CSS, whose reader has fingers alone.
  void become_phone(int width, int height);
  /// Pages opened from now on run no script; value_of() does.
  void forbid_scripts();
  /// "light" or "dark", as its user prefers.
  void prefer(const std::string& color_scheme);
  /// The value of an expression; a promise's when it comes. @throws std::runtime_error if it throws
  nlohmann::json value_of(const std::string& expression);
  /// Waits until the expression has the value, up to five seconds; returns what it has then.
  nlohmann::json wait_for(const std::string& expression, const nlohmann::json& value);
  /// What assistive technology is told of each formula, in the order of the page.
  std::vector<std::string> names_of_formulas();
  /// PNG.
  std::string screenshot();
  /// The bytes that an address of base64 holds ("data:image/png;base64,…").
  static std::string data_in(const std::string& address);
  /// PDF, as the page is printed.
  std::string print();
  /// What the page complained of: errors, warnings, blocked by its policy, and requests to anywhere.
  const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  Browser() = default;
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());
  nlohmann::json receive();
  void note(const nlohmann::json& event);
  void wait_for_load();

  ScratchFolder home_;
  pid_t process_ = -1;
  int to_ = -1, from_ = -1;
  int last_id_ = 0;
  int loads_ = 0;
  std::string received_, session_;
  std::vector<std::string> complaints_;
};

}  // namespace polhode
