// SPDX-License-Identifier: MIT
#include "lessons/math_text.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

namespace polhode {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

class MathScan {
 public:
  MathScan(std::string_view tex, SourcePlace start, Report& report)
      : tex_(tex), cursor_(tex, start), report_(report) {}

  MathNames run() {
    while (i_ < tex_.size()) step();
    if (too_deep_) return std::move(names_);
    for (const Open& open : open_) report_.error(open.place, open.what + " is never closed");
    return std::move(names_);
  }

 private:
  struct Open {
    std::string what;     // as written: "{", "\left", "\begin{aligned}"
    std::string partner;  // what closes it
    SourcePlace place;
  };

  void step() {
    const char c = tex_[i_];
    if (c == '\\') {
      command();
    } else if (c == '{') {
      open("{", "}");
      i_ = std::min(i_ + 1, tex_.size());
    } else if (c == '}') {
      close("}");
      ++i_;
    } else if (c == '%') {
      i_ = std::min(tex_.find('\n', i_), tex_.size());
    } else {
      ++i_;
    }
  }

  void command() {
    const std::size_t begin = i_++;
    while (i_ < tex_.size() && is_letter(tex_[i_])) ++i_;
    const std::string_view name = tex_.substr(begin + 1, i_ - begin - 1);
    if (name.empty()) {
      if (i_ < tex_.size()) ++i_;  // \{ and the like
      return;
    }
    command_begin_ = begin;
    if (name == "left")
      open("\\left", "\\right");
    else if (name == "right")
      close("\\right");
    else if (name == "begin")
      environment([this](const std::string& e) { open("\\begin" + e, "\\end" + e); });
    else if (name == "end")
      environment([this](const std::string& e) { close("\\end" + e); });
    else if (name == "tag")
      argument("\\tag", names_.tags);
    else if (name == "term")
      term();
    // The bracket of \left\{ and \right\} belongs to it.
    if ((name == "left" || name == "right") && tex_.substr(i_, 1) == "\\") i_ = std::min(i_ + 2, tex_.size());
    command_begin_ = kNone;
  }

  SourcePlace here() { return cursor_.advance_to(std::min(open_place_or_command(), tex_.size())); }
  std::size_t open_place_or_command() const { return command_begin_ != kNone ? command_begin_ : i_; }

  void open(std::string what, std::string partner) {
    if (open_.size() == kMaxMathNesting) {
      report_.error(here(), "braces are nested deeper than " + std::to_string(kMaxMathNesting));
      too_deep_ = true;
      i_ = tex_.size();
      return;
    }
    open_.push_back({std::move(what), std::move(partner), here()});
    command_begin_ = kNone;
  }

  void close(const std::string& what) {
    const SourcePlace place = here();
    command_begin_ = kNone;
    if (!open_.empty() && open_.back().partner == what) {
      open_.pop_back();
      return;
    }
    std::string hint;
    if (!open_.empty()) {
      hint = open_.back().what + " at line " + std::to_string(open_.back().place.line) + ", column " +
             std::to_string(open_.back().place.column) + " waits for " + open_.back().partner;
    }
    report_.error(place, what + " closes nothing", std::move(hint));
  }

  // Calls f("{name}") for \begin{name} and \end{name}; the name is left behind.
  template <class F>
  void environment(F f) {
    const std::size_t end = tex_.find_first_of("}\n", i_);
    if (tex_.substr(i_, 1) != "{" || end == std::string_view::npos || tex_[end] != '}') return;
    const std::string name(tex_.substr(i_, end + 1 - i_));
    i_ = end + 1;
    f(name);
  }

  // Text of the braces that follow, which hold no braces themselves.
  bool argument(std::string_view command, std::vector<PlacedText>& into) {
    const SourcePlace place = here();
    command_begin_ = kNone;
    const std::size_t end = tex_.find_first_of("{}\n", i_ + 1);
    if (tex_.substr(i_, 1) != "{" || end == std::string_view::npos || tex_[end] != '}') {
      report_.error(place, std::string(command) + " needs text in braces", std::string(command) + "{…}");
      return false;
    }
    const std::string_view text = trimmed(tex_.substr(i_ + 1, end - i_ - 1));
    into.push_back({std::string(text), cursor_.advance_to(i_ + 1)});
    i_ = end + 1;
    return true;
  }

  void term() {
    if (!argument("\\term", names_.terms)) return;
    const PlacedText& id = names_.terms.back();
    if (!is_id(id.text)) {
      report_.error(id.place, "bad term id " + in_quotes(id.text), std::string(kIdRule));
    }
    if (tex_.substr(i_, 1) != "{") {
      report_.error(cursor_.advance_to(i_), "\\term needs its formula in braces",
                    "\\term{" + id.text + "}{…}");
    }
  }

  static constexpr std::size_t kNone = std::string_view::npos;

  std::string_view tex_;
  PlaceCursor cursor_;
  Report& report_;
  std::size_t i_ = 0;
  std::size_t command_begin_ = kNone;  // of the command being read
  std::vector<Open> open_;
  bool too_deep_ = false;
  MathNames names_;
};

// The $…$ of one paragraph after another.
class InlineScan {
 public:
  InlineScan(std::string_view text, SourcePlace start, Report& report)
      : text_(text), cursor_(text, start), report_(report) {}

  void run() {
    while (i_ < text_.size()) {
      if (i_ >= paragraph_end_) start_paragraph();
      step();
    }
  }

 private:
  void start_paragraph() {
    in_code_ = false;
    paragraph_end_ = i_;
    while (paragraph_end_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', paragraph_end_), text_.size());
      const bool blank = is_blank(text_.substr(paragraph_end_, end - paragraph_end_));
      paragraph_end_ = std::min(end + 1, text_.size());
      if (blank) return;
    }
  }

  void step() {
    const char c = text_[i_];
    if (c == '\\' && !in_code_) {
      i_ += 2;
    } else if (c == '`') {
      in_code_ = !in_code_;
      i_ = std::min(text_.find_first_not_of('`', i_), text_.size());
    } else if (c == '$' && !in_code_) {
      dollar();
    } else {
      ++i_;
    }
  }

  void dollar() {
    const SourcePlace place = cursor_.advance_to(i_);
    if (text_.substr(i_, 2) == "$$") {
      report_.error(place, "display mathematics stands in a fence", "write ```math ID, the formula, ```");
      const std::size_t end = std::min(text_.find("$$", i_ + 2), paragraph_end_);
      i_ = std::min(end + 2, paragraph_end_);
      return;
    }
    std::size_t end = i_ + 1;
    while (end < paragraph_end_ && text_[end] != '$') end += text_[end] == '\\' ? 2 : 1;
    if (end >= paragraph_end_) {
      report_.warning(place, "this $ has no partner in its paragraph", "write \\$ for a dollar sign");
      i_ = paragraph_end_;
      return;
    }
    const std::string_view tex = text_.substr(i_ + 1, end - i_ - 1);
    if (is_space(tex.front()) || is_space(tex.back())) {
      report_.warning(place, "is this a formula? It begins or ends with a space",
                      "write \\$ for a dollar sign");
    } else {
      read_math(tex, {place.line, place.column + 1}, report_);
    }
    i_ = end + 1;
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  std::string_view text_;
  PlaceCursor cursor_;
  Report& report_;
  std::size_t i_ = 0;
  std::size_t paragraph_end_ = 0;
  bool in_code_ = false;
};

}  // namespace

MathNames read_math(std::string_view tex, SourcePlace start, Report& report) {
  return MathScan(tex, start, report).run();
}

void check_inline_math(std::string_view markdown, SourcePlace start, Report& report) {
  InlineScan(markdown, start, report).run();
}

}  // namespace polhode
