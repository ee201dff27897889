// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/callouts.h"

#include "base/spelling.h"
#include "lessons/reader/markdown/heading.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

constexpr std::string_view kMarkBegin = "[!";

// Without the > of the quote, which a continued line may lack.
std::string_view quoted_part(std::string_view line) {
  const std::size_t mark = line.find_first_not_of(" \t");
  if (mark == std::string_view::npos || line[mark] != '>') return line;
  line.remove_prefix(mark + 1);
  if (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  return line;
}

std::optional<Callout::Kind> kind_from(std::string_view name) {
  if (name == "said") return Callout::Kind::said;
  if (name == "meant") return Callout::Kind::meant;
  return std::nullopt;
}

class CalloutReader {
 public:
  explicit CalloutReader(TextReader& texts)
      : texts_(texts), source_(texts.source()), report_(texts.report()) {}

  void read_line(int number) {
    const std::string_view line = source_.line(number);
    std::string_view part = quoted_part(line);
    const std::string_view text = trimmed(part);
    const SourcePlace place =
        advanced({number, 1}, line, static_cast<std::size_t>(text.data() - line.data()));
    if (text.substr(0, kMarkBegin.size()) == kMarkBegin) {
      start(text, place);
      return;
    }
    if (callouts_.empty()) {
      if (!text.empty() && !failed_) {
        report_.error(place, "a quote opens with [!said] or [!meant]");
        failed_ = true;
      }
      return;
    }
    // The line end before it.
    located_.back().append("\n", source_.begin_of(number) - 1);
    located_.back().append(part, source_.offset_of(part));
  }

  std::vector<Callout> take() {
    for (std::size_t i = 0; i < callouts_.size(); ++i) {
      Callout& callout = callouts_[i];
      callout.markdown = trimmed_lines(located_[i].text());
      if (callout.markdown.empty()) report_.error(callout.place, "this call-out is empty");
      callout.text = texts_.passage(located_[i]);
    }
    return std::move(callouts_);
  }

 private:
  void start(std::string_view text, SourcePlace place) {
    if (callouts_.size() == kMaxCallouts) {
      if (!failed_)
        report_.error(place, "a quote has at most " + std::to_string(kMaxCallouts) + " call-outs");
      failed_ = true;
      return;
    }
    const std::size_t end = std::min(text.find(']'), text.size());
    const std::string_view mark = text.substr(0, end + 1);
    const std::string_view name = text.substr(kMarkBegin.size(), end - kMarkBegin.size());
    const auto kind = mark.back() == ']' ? kind_from(name) : std::nullopt;
    if (!kind)
      report_.error(place, "unknown call-out " + in_quotes(mark), suggestion(name, {"said", "meant"}));
    const std::string_view rest = trimmed(text.substr(mark.size()));
    callouts_.push_back({kind.value_or(Callout::Kind::said), "", {}, place});
    located_.emplace_back(source_, kind ? rest : mark);
  }

  TextReader& texts_;
  const SourceText& source_;
  Report& report_;
  std::vector<Callout> callouts_;
  std::vector<LocatedText> located_;  // their Markdown
  bool failed_ = false;
};

}  // namespace

std::vector<Callout> read_callouts(int first_line, int last_line, TextReader& texts) {
  CalloutReader reader(texts);
  for (int line = first_line; line <= last_line; ++line) reader.read_line(line);
  return reader.take();
}

}  // namespace polhode
