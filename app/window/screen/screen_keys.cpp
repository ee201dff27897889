// SPDX-License-Identifier: MIT
// What keys do in the window: in a field, in a panel, on the page, before an audience.
#include "app/session/answers/answer_keys.h"
#include "app/session/command.h"
#include "app/window/controls/widgets.h"
#include "app/window/screen/screen.h"
#include "base/words/window_words.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {

namespace {

/// Of a field in which a text is typed: what makes or moves over characters, and what every field has with
/// Ctrl.
bool is_for_field(std::string_view key) {
  static constexpr std::array<std::string_view, 12> kWithCtrl = {
      "Ctrl+A",    "Ctrl+C",     "Ctrl+V",    "Ctrl+X",   "Ctrl+Y",         "Ctrl+Z",
      "Ctrl+Left", "Ctrl+Right", "Ctrl+Home", "Ctrl+End", "Ctrl+Backspace", "Ctrl+Delete"};
  if (key.starts_with("Ctrl+")) return std::find(kWithCtrl.begin(), kWithCtrl.end(), key) != kWithCtrl.end();
  return !(key.size() > 1 && key[0] == 'F');
}

/// What moves in a panel that has the keys. In one where there is nothing to choose they scroll, and the rest
/// is the page's.
bool is_for_panel(Panel panel, std::string_view key) {
  static constexpr std::array<std::string_view, 6> kScroll = {"Up",       "Down", "PageUp",
                                                              "PageDown", "Home", "End"};
  if (panel == Panel::help) return std::find(kScroll.begin(), kScroll.end(), key) != kScroll.end();
  static constexpr std::array<std::string_view, 13> kOfPanels = {
      "Left",      "Right",  "Up",       "Down", "Space", "Enter",    "Tab",
      "Shift+Tab", "PageUp", "PageDown", "Home", "End",   "Backspace"};
  return std::find(kOfPanels.begin(), kOfPanels.end(), key) != kOfPanels.end();
}

/// A remote clicker has no others: before an audience they walk, whatever has the keyboard.
bool is_of_clicker(std::string_view key) { return key == "PageUp" || key == "PageDown"; }

}  // namespace

bool Screen::press(LessonSession& session, std::string_view key, bool is_repeated) {
  ImGui::SetCurrentContext(imgui_);
  const bool typing = ImGui::GetIO().WantTextInput;
  if (!is_repeated) session.begin_change();
  pointer_is_left_ = true;
  if (has_menu_ && key == "Escape" && !session.is_black()) {
    has_menu_ = false;
    return true;
  }
  if (typing && key == "Escape") {  // of the field alone: the panel stays
    ImGui::SetWindowFocus(nullptr);
    return true;
  }
  const bool is_of_panel = panels_.has_focus() && is_for_panel(session.panel, key);
  if (is_of_panel && (key == "Tab" || key == "Shift+Tab")) {  // out of a field, too
    panels_.tab(key == "Tab" ? 1 : -1);
    return true;
  }
  const bool walks = session.is_presenting() && is_of_clicker(key);
  if (!walks && ((typing && is_for_field(key)) || is_of_panel)) return false;
  if (session.panel == Panel::question && !is_repeated) {
    if (answer_by_key(session, key)) return true;
    // While the motion answers, a letter that was a choice a moment ago is no command.
    if (const std::string why = why_no_choice(session, key);
        !why.empty() && (!command_of(key) || awaits_answer(session))) {
      tell(why);
      return true;
    }
  }
  const bool goes_on_typing = !typing && (types_ahead_ || !typed_ahead_.empty());
  if (goes_on_typing && (is_character(key) || key == "Space")) {
    types_ahead_ = true;
    return false;
  }
  if (const Ask* begun = typing ? nullptr : begun_by_letter(session, key)) {
    types_ahead_ = true;
    begun_ = begun;
    return false;
  }
  if (session.is_presenting() && press_while_presenting(session, key)) return true;
  const auto command = command_of(key);
  if (!command) return false;
  if (key == "F5" && session.is_presenting()) {  // which begins a talk on every desk, and ends none
    tell(said(session, session.has_speaker() ? words::kPresentingWithSpeaker : words::kPresenting));
    return true;
  }
  if (is_character(key) && panels_.awaits_text()) return false;
  if (is_character(key) && !session.preferences.letter_keys) {
    if (!session.is_presenting()) tell(said(session, words::kLettersAreNoCommands));
    return false;
  }
  if (is_repeated && !facts_of(*command).repeats) return true;
  const Panel before = session.panel;
  requests_.leave_full_screen = *command == Command::leave && before == Panel::none &&
                                session.lit().empty() && !session.is_presenting();
  const bool was_presenting = session.is_presenting();
  const bool goes_on = *command == Command::next_step || *command == Command::next_stage;
  if (goes_on && holds_back(session, is_repeated)) return true;
  if (const std::string why = why_idle(session, *command); !why.empty()) {
    tell(why);
    idle_ = *command;
    return true;
  }
  if (do_command(session, *command)) {
    if (session.is_presenting() && !was_presenting && !session.has_speaker())
      tell(said(session, words::kHowToPresent));
    panel_takes_focus_ = session.panel != before && session.panel != Panel::none;
    if (*command == Command::leave) {
      symbols_.leave(session);
      choice_in_focus_.reset();
      ImGui::SetWindowFocus(nullptr);
    }
    return true;
  }
  return do_in_window(session, *command);
}

/// What a prediction asks is told by the next step: who has not answered is asked to, once each time that he
/// comes to it. Before an audience nobody is.
bool Screen::holds_back(const LessonSession& session, bool is_repeated) {
  if (session.is_presenting() || !has_open_prediction(session)) return false;
  if (!is_repeated && held_back_ == session.place()) return false;
  if (!is_repeated) held_back_ = session.place();
  tell(said(session, words::kAnswerFirst));
  return true;
}

bool Screen::press_from_afar(LessonSession& session, std::string_view key, bool is_repeated) {
  if (key == "Ctrl+F") return false;  // words are typed in this window, which the audience sees
  ImGui::SetCurrentContext(imgui_);
  ImGui::SetWindowFocus(nullptr);
  ImGui::GetIO().WantTextInput = false;
  panels_.leave_keys();
  const bool is_done = press(session, key, is_repeated);
  panel_takes_focus_ = false;
  return is_done;
}

/// The number of a stage as far as it was typed: with it goes what was told of it.
std::string Screen::take_number(const LessonSession& session) {
  const Language language = session.lesson().about.language;
  if (!digits_.empty() && notices_.told() == words::kEnterGoesToStage.with(language, {digits_})) tell("");
  return std::exchange(digits_, "");
}

/// B is the key for a black screen on every desk. Digits are the number of a stage, which Enter goes to.
/// Clickers send the period: it is a command for who wants no letters, too, and so is that number.
bool Screen::press_while_presenting(LessonSession& session, std::string_view key) {
  // No number begins with 0, which alone is a command.
  const bool is_digit = key.size() == 1 && key[0] >= (digits_.empty() ? '1' : '0') && key[0] <= '9';
  if (is_digit && session.panel == Panel::none && digits_.size() < 4) {
    digits_ += key;
    tell(words::kEnterGoesToStage.with(session.lesson().about.language, {digits_}));
    return true;
  }
  if (is_character(key) && key != "." && !is_digit && !session.preferences.letter_keys) return false;
  const std::string digits = take_number(session);
  if (key == "Escape" && !digits.empty()) return true;
  if (key == "Enter" && !digits.empty()) {
    const std::vector<std::size_t> stages = session.counted_stages();
    const std::size_t number = std::stoul(digits), last = stages.size();
    tell(number >= 1 && number <= last
             ? ""
             : words::kNoSuchStage.with(session.lesson().about.language,
                                        {std::to_string(number), std::to_string(last)}));
    if (number >= 1 && number <= last) session.go_to({stages[number - 1], 0});
    return true;
  }
  const bool was_black = session.is_black();
  session.set_black(false);
  if (key == "B" || key == ".") session.set_black(!was_black);
  return was_black || key == "B" || key == ".";
}

/// To the next symbol, and behind the last one to the choices that can still be picked. It begins with what
/// is seen of a long stage.
void Screen::move_focus_on_page(LessonSession& session, int by) {
  const std::vector<const Page::Choice*> choices = open_choices(session);
  const auto symbols = static_cast<int>(page_->symbols().size()),
             all = symbols + static_cast<int>(choices.size());
  if (all == 0) return tell(said(session, words::kNothingHasNote));
  int present = by > 0 ? static_cast<int>(page_->first_seen()) - 1 : all;
  if (const auto place = symbols_.place(); place && static_cast<int>(*place) < symbols)
    present = static_cast<int>(*place);
  if (choice_in_focus_ && *choice_in_focus_ < choices.size())
    present = symbols + static_cast<int>(*choice_in_focus_);
  const int next = (present + by + all) % all;
  choice_in_focus_.reset();
  if (next < symbols) {
    symbols_.reach(session, page_->symbols(), static_cast<std::size_t>(next));
    const auto& box = page_->symbols()[static_cast<std::size_t>(next)].box;
    if (page_->is_scrolled(static_cast<std::size_t>(next))) page_->scroll_to_see(box.y0, box.y1);
    return;
  }
  symbols_.leave(session);
  choice_in_focus_ = static_cast<std::size_t>(next - symbols);
  const PixelBox& box = choices[*choice_in_focus_]->box;
  page_->scroll_to_see(box.y0, box.y1);
}

/// Enter on the choice that keys have reached. False: they have reached none.
bool Screen::pick_in_focus(LessonSession& session) {
  const std::vector<const Page::Choice*> choices = open_choices(session);
  const auto reached = std::exchange(choice_in_focus_, std::nullopt);
  if (!reached || *reached >= choices.size()) return false;
  pick(session, *choices[*reached]);
  return true;
}

bool Screen::do_in_window(LessonSession& session, Command command) {
  constexpr double kScrolled = 4;  // em
  switch (command) {
    case Command::switch_focus:
      if (session.panel == Panel::none) {
        tell(said(session, words::kNoPanelIsOpen));
      } else if (panels_.has_focus()) {
        ImGui::SetWindowFocus(nullptr);
      } else {
        panels_.take_keys();
        ImGui::SetWindowFocus("panel");
      }
      break;
    case Command::next_symbol:
      move_focus_on_page(session, 1);
      break;
    case Command::scroll_down:
      if (!page_->scroll(kScrolled * sizes_->em)) tell(said(session, words::kTextEnds));
      break;
    case Command::scroll_up:
      if (!page_->scroll(-kScrolled * sizes_->em)) tell(said(session, words::kTextBegins));
      break;
    case Command::copy_step:
      requests_.clipboard = words_of_step(session);
      break;
    case Command::read_aloud:
      requests_.read_aloud = words_of_step(session);
      break;
    case Command::previous_symbol:
      move_focus_on_page(session, -1);
      break;
    case Command::explain:
      if (pick_in_focus(session)) break;
      if (symbols_.focused(page_->symbols()).empty())
        tell(said(session, words::kTabFirst));
      else if (!follow(session, symbols_.focused(page_->symbols())))
        symbols_.explain();
      break;
    case Command::find:
      session.panel = Panel::outline;
      requests_.find = true;
      break;
    case Command::save_page:
      requests_.save_as = SaveAs::page;
      break;
    case Command::full_screen:
      requests_.full_screen = true;
      break;
    case Command::quit:
      requests_.quit = true;
      break;
    default:
      return false;
  }
  return true;
}

/// What is typed on the page before its field has the keyboard waits, and then comes first.
void Screen::type_ahead(LessonSession& session) {
  ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
  if (std::exchange(types_ahead_, false) && !ImGui::GetIO().WantTextInput) {
    typed_ahead_.insert(typed_ahead_.end(), typed.begin(), typed.end());
    typed.resize(0);
    session.panel = Panel::question;
    requests_.type_answer = true;
    requests_.type_answer_to = begun_;
  } else if (ImGui::GetIO().WantTextInput && !typed_ahead_.empty()) {
    type_at_end();
    typed_ahead_.insert(typed_ahead_.end(), typed.begin(), typed.end());
    typed.resize(0);
    for (const unsigned character : std::exchange(typed_ahead_, {}))
      typed.push_back(static_cast<ImWchar>(character));
  } else if (session.panel != Panel::question) {
    typed_ahead_.clear();
  }
}

}  // namespace polhode
