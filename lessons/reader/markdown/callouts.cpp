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
  const auto found =
      std::find_if(kCallouts.begin(), kCallouts.end(), [&](const auto& names) { return names.name == name; });
  if (found == kCallouts.end()) return std::nullopt;
  return found->kind;
}

/// Byte of the bracket that closes a mark; one in a formula closes nothing.
std::size_t end_of_mark(std::string_view text) {
  bool in_formula = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '$') in_formula = !in_formula;
    if (text[i] == ']' && !in_formula) return i;
  }
  return text.size();
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
        report_.error(place, "a quote opens with the kind of call-out that it is: [!said] or another",
                      suggestion("", callout_names()));
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
      if (callout.kind == Callout::Kind::quote) add_name(callout, titles_[i]);
      if (callout.kind == Callout::Kind::derivation) callout.title = texts_.line(titles_[i]);
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
    const std::size_t end = end_of_mark(text);
    const std::string_view mark = text.substr(0, end + 1);
    const std::string_view inside = trimmed(text.substr(kMarkBegin.size(), end - kMarkBegin.size()));
    const std::size_t blank = std::min(inside.find_first_of(" \t"), inside.size());
    const std::string_view name = inside.substr(0, blank), title = trimmed(inside.substr(blank));
    const auto kind = mark.back() == ']' ? kind_from(name) : std::nullopt;
    if (kind)
      check_title(*kind, title, place);
    else if (mark.back() == ']')
      report_.error(place, "unknown call-out " + in_quotes(mark), suggestion(name, callout_names()));
    else
      report_.error(place, "the kind of this call-out is never closed", "end it with ]");
    const std::string_view rest = trimmed(text.substr(mark.size()));
    callouts_.push_back({kind.value_or(Callout::Kind::said), "", {}, place});
    located_.emplace_back(source_, kind ? rest : mark);
    titles_.emplace_back(source_, title);
  }

  void check_title(Callout::Kind kind, std::string_view title, SourcePlace place) {
    const std::string name(names_of(kind).name);
    if (kind == Callout::Kind::derivation && title.empty())
      report_.error(place, "a derivation has a title, which stands for it on pages",
                    "write [!derivation What is derived]");
    if (kind != Callout::Kind::derivation && kind != Callout::Kind::quote && !title.empty())
      report_.error(place, "only a quote and a derivation have more than their kind in brackets",
                    "write [!" + name + "] " + std::string(title));
  }

  /// Below what is quoted stands who said it.
  void add_name(Callout& callout, const LocatedText& name) {
    RichText who = texts_.line(name);
    if (who.empty() || who.front().spans.empty()) return;
    TextSpan dash;
    dash.text = "— ";
    dash.source = who.front().spans.front().source;
    who.front().spans.insert(who.front().spans.begin(), std::move(dash));
    callout.text.push_back(std::move(who.front()));
  }

  TextReader& texts_;
  const SourceText& source_;
  Report& report_;
  std::vector<Callout> callouts_;
  std::vector<LocatedText> located_;  // their Markdown
  std::vector<LocatedText> titles_;   // what stands in their brackets behind the kind
  bool failed_ = false;
};

}  // namespace

const std::vector<std::string>& callout_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const CalloutNames& callout : kCallouts) names.emplace_back(callout.name);
    return names;
  }();
  return kNames;
}

std::vector<Callout> read_callouts(int first_line, int last_line, TextReader& texts) {
  CalloutReader reader(texts);
  for (int line = first_line; line <= last_line; ++line) reader.read_line(line);
  return reader.take();
}

}  // namespace polhode
