// SPDX-License-Identifier: MIT
// A headless Firefox that a test holds by Marionette, the protocol below its WebDriver: opens a page, presses
// keys, asks what is shown, and what a screen reader is told.
#pragma once

#include "tests/app/run_program.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace polhode {

class Firefox {
 public:
  /// Null where no Firefox is installed. Its window is so large that a page has this room.
  static std::unique_ptr<Firefox> start(int width, int height);
  ~Firefox();
  Firefox(const Firefox&) = delete;
  Firefox& operator=(const Firefox&) = delete;

  /// Returns when the page has loaded.
  void open(const std::filesystem::path& file);
  void resize(int width, int height);
  /// "light" or "dark", as its user prefers.
  void prefer(const std::string& color_scheme);
  /// "Tab" or "Shift+Tab", "Enter", "Escape", " ", or a letter.
  void press(const std::string& key);
  /// The value of an expression. @throws std::runtime_error if it throws
  nlohmann::json value_of(const std::string& expression);
  /// What assistive technology is told of each formula, in the order of the page.
  std::vector<std::string> names_of_formulas();
  /// PNG, of what is seen.
  std::string screenshot();
  /// What the page complained of since it was opened: errors, what its policy blocked, and requests to
  /// anywhere.
  std::vector<std::string> complaints();

 private:
  Firefox() = default;
  void connect();
  nlohmann::json call(const std::string& command,
                      const nlohmann::json& parameters = nlohmann::json::object());
  nlohmann::json receive();
  /// Of a script with the rights of the browser itself.
  nlohmann::json value_inside(const std::string& script);

  ScratchFolder home_;
  pid_t process_ = -1;
  int socket_ = -1;
  int last_id_ = 0;
  std::string received_;
};

}  // namespace polhode
