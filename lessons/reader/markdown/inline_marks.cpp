// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/inline_marks.h"

#include "render/typeset/characters.h"

#include <algorithm>

namespace polhode {
namespace {

// The $…$ of one paragraph after another.
class InlineScan {
 public:
  InlineScan(const LocatedText& markdown, Report& report)
      : markdown_(markdown), text_(markdown.text()), report_(report) {}

  std::vector<InlineMark> run() {
    while (i_ < text_.size()) {
      if (i_ >= paragraph_end_) start_paragraph();
      step();
    }
    return std::move(found_);
  }

 private:
  void start_paragraph() {
    paragraph_end_ = i_;
    while (paragraph_end_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', paragraph_end_), text_.size());
      const bool blank = is_blank(text_.substr(paragraph_end_, end - paragraph_end_));
      paragraph_end_ = std::min(end + 1, text_.size());
      if (blank) return;
    }
  }

  void step() {
    if (text_[i_] == '\\')
      i_ += 2;
    else if (text_[i_] == '`')
      pass_code();
    else if (text_[i_] == '$')
      dollar();
    else if (text_[i_] == '[')
      bracket();
    else
      ++i_;
  }

  /// A code span ends at a run of as many backticks; without such a run these are text.
  void pass_code() {
    const std::size_t after = std::min(text_.find_first_not_of('`', i_), text_.size());
    const std::size_t run = after - i_;
    std::size_t at = after;
    while ((at = text_.find('`', at)) < paragraph_end_) {
      const std::size_t end = std::min(text_.find_first_not_of('`', at), text_.size());
      if (end - at == run) {
        i_ = end;
        return;
      }
      at = end;
    }
    i_ = after;
  }

  SourcePlace place_of(std::size_t at) const { return report_.source().place_of(markdown_.offset_of(at)); }

  void dollar() {
    if (text_.substr(i_, 2) == "$$") {
      report_.error(place_of(i_), "display mathematics stands in a fence",
                    "write ```math ID, the formula, ```");
      const std::size_t end = std::min(text_.find("$$", i_ + 2), paragraph_end_);
      i_ = std::min(end + 2, paragraph_end_);
      return;
    }
    std::size_t end = i_ + 1;
    while (end < paragraph_end_ && text_[end] != '$') end += text_[end] == '\\' ? 2 : 1;
    if (end >= paragraph_end_) {
      report_.warning(place_of(i_), "this $ has no partner in its paragraph", "write \\$ for a dollar sign");
      i_ = paragraph_end_;
      return;
    }
    const auto byte = [this](std::size_t at) { return static_cast<unsigned char>(text_[at]); };
    if (is_space(byte(i_ + 1)) || is_space(byte(end - 1))) {
      report_.warning(place_of(i_), "is this a formula? It begins or ends with a space",
                      "write \\$ for a dollar sign");
    } else {
      add(InlineMark::Kind::formula, 1, end);
    }
    i_ = end + 1;
  }

  void bracket() {
    const std::string_view rest = text_.substr(i_, paragraph_end_ - i_);
    const bool is_citation = rest.substr(0, kCitationOpening.size()) == kCitationOpening;
    const bool is_note = rest.substr(0, kNoteOpening.size()) == kNoteOpening;
    std::size_t end = rest.size();
    if ((is_citation || is_note) && i_ >= never_closed_) end = std::min(rest.find(']'), rest.size());
    if (end == rest.size()) {
      if (is_citation || is_note) never_closed_ = paragraph_end_;
      ++i_;
      return;
    }
    if (is_note)
      add(InlineMark::Kind::note, kNoteOpening.size(), i_ + end);
    else
      add(InlineMark::Kind::citation, kCitationOpening.size(), i_ + end);
    i_ += end + 1;
  }

  /// That begins here with so many bytes, and is closed by the byte at `end`.
  void add(InlineMark::Kind kind, std::size_t opening, std::size_t end) {
    const auto at = [](std::size_t offset) { return static_cast<std::uint32_t>(offset); };
    found_.push_back({kind, {at(i_), at(end + 1)}, {at(i_ + opening), at(end)}});
  }

  const LocatedText& markdown_;
  std::string_view text_;
  Report& report_;
  std::size_t i_ = 0;
  std::size_t paragraph_end_ = 0;
  std::size_t never_closed_ = 0;  // up to here no bracket is
  std::vector<InlineMark> found_;
};

}  // namespace

std::vector<InlineMark> find_inline_marks(const LocatedText& markdown, Report& report) {
  return InlineScan(markdown, report).run();
}

}  // namespace polhode
