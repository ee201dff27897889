// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/type_check.h"

#include "lessons/diagnostics/report.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <memory>
#include <set>

namespace polhode {
namespace {

class TypeCheck {
 public:
  TypeCheck(const Lesson& lesson, const Fonts& fonts, std::string_view file)
      : lesson_(lesson), fonts_(fonts), source_(lesson.source), report_(source_, file) {}

  std::vector<Diagnostic> run() {
    title();
    for (const auto& [name, symbol] : lesson_.symbols) formula(symbol.math, symbol.offset);
    for (const Stage& stage : lesson_.stages) {
      text(stage.title_text, heading());
      for (const Step& step : stage.steps) check(step);
    }
    return report_.take();
  }

 private:
  TextStyle heading() const {
    TextStyle style = body_;
    style.bold = true;
    return style;
  }

  void title() {
    TextSpan span;
    span.text = lesson_.title;
    span.source = {0, static_cast<std::uint32_t>(lesson_.title.size())};
    const auto offset = std::min(lesson_.source.find(lesson_.title), lesson_.source.size());
    if (const auto set = set_text({TextBlock{.indent = 0, .marker = {}, .spans = {span}}}, body_, fonts_);
        !set)
      report(set.error(), offset);
  }

  void check(const Step& step) {
    text(step.title, heading());
    for (const Block& block : step.blocks) std::visit([this](const auto& b) { check(b); }, block);
    for (const Callout& note : step.notes) check(note);
    for (const auto& caption : step.captions)
      if (caption) in_figure(caption);
    for (const auto& label : step.labels) in_figure(label);
  }

  /// Once: steps that go on with it share it.
  void in_figure(const std::shared_ptr<const RichText>& written) {
    if (!set_.insert(written).second) return;
    TextStyle sans = body_;
    sans.sans = true;
    text(*written, sans);
  }

  void check(const Prose& prose) { text(prose.text, body_); }
  void check(const Callout& callout) {
    text(callout.text, body_);
    text(callout.title, body_);
  }
  void check(const Footnote& note) { text(note.text, body_); }
  void check(const Equation& equation) { formula(equation.math, equation.offset); }
  void check(const Claim&) {}
  void check(const Ask& ask) {
    text(ask.prompt_text, body_);
    for (const RichText& choice : ask.choice_texts) text(choice, body_);
    for (const RichText& reply : ask.replies) text(reply, body_);
    for (const RichText& hint : ask.hint_texts) text(hint, body_);
    text(ask.because, body_);
  }

  void text(const RichText& text, const TextStyle& style) {
    if (const auto set = set_text(text, style, fonts_); !set) report(set.error(), 0);
  }

  void formula(const Math& math, std::size_t offset) {
    MathStyle style;
    style.display = true;
    if (const auto set = set_math(math, style, fonts_); !set) report(set.error(), offset);
  }

  void report(const std::vector<TypeError>& errors, std::size_t offset) {
    for (const TypeError& error : errors)
      report_.error(source_.place_of(std::min(offset + error.offset, source_.text().size())), error.message,
                    error.hint);
  }

  const Lesson& lesson_;
  const Fonts& fonts_;
  SourceText source_;
  Report report_;
  TextStyle body_ = [] {
    TextStyle style;
    style.width = 640.0;
    return style;
  }();
  std::set<std::shared_ptr<const RichText>> set_;
};

}  // namespace

std::vector<Diagnostic> check_type(const Lesson& lesson, const Fonts& fonts, std::string_view file_name) {
  return TypeCheck(lesson, fonts, file_name).run();
}

}  // namespace polhode
