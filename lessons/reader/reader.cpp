// SPDX-License-Identifier: MIT
#include "lessons/reader/reader.h"

#include "lessons/diagnostics/report.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/front_matter.h"
#include "lessons/reader/markdown/markdown.h"
#include "lessons/reader/references.h"
#include "lessons/reader/stage_builder.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// True if nothing can be read at all; says so.
bool refuse_whole(std::string_view bytes, Report& report, const SourceText& source) {
  if (bytes.size() > kMaxLessonBytes) {
    report.error({1, 1},
                 "this lesson has too many bytes, at most " + std::to_string(kMaxLessonBytes) + " are read");
    return true;
  }
  if (const auto wrong = why_not_text(bytes)) {
    report.error(source.place_of(wrong->offset), wrong->message, wrong->hint);
    return true;
  }
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    report.error({1, 1}, "this lesson is empty", "a lesson starts with a line +++ and its front matter");
    return true;
  }
  return false;
}

std::vector<Stage> read_stages(const FrontMatter& front, TextReader& texts, const std::string* only) {
  const SourceText& source = texts.source();
  Report& report = texts.report();
  const MarkdownReading markdown = read_markdown(source, front.next_line, report);
  StageBuilder builder(front, texts, only);
  for (const MarkdownBlock& block : markdown.blocks) {
    if (!builder.add(block) || report.is_full()) return {};
  }
  if (!markdown.complete) return {};
  std::vector<Stage> stages = builder.take();
  if (stages.empty() && !report.has_errors()) {
    report.error({source.line_count(), 1}, "this lesson has no stage",
                 "a stage starts with # Title {stage-id}");
  }
  return stages;
}

void note_citations(AboutKeys& about, const std::map<std::string, bool>& cited, Report& report) {
  for (std::size_t i = 0; i < about.references.size(); ++i) {
    Reference& reference = about.references[i];
    reference.is_cited = cited.at(reference.key);
    if (!reference.is_cited)
      report.warning(about.reference_places[i].place,
                     "reference " + in_quotes(reference.key) + " is cited nowhere",
                     "write [cite: " + reference.key + "] in a text, or leave it out");
  }
  std::sort(about.references.begin(), about.references.end(),
            [](const Reference& a, const Reference& b) { return a.key < b.key; });
}

/// What a lesson defines and writes nowhere is left from an earlier text, or misspelt where it is meant.
void note_unused_macros(const MathMacros& macros, const SourceText& source, Report& report) {
  const std::string_view text = source.text();
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto ends_at = [&](std::size_t at) { return at == text.size() || !is_letter(text[at]); };
  const std::size_t table = std::min(text.find("macros"), text.size());
  for (const auto& [name, macro] : macros) {
    const std::string command = '\\' + name;
    bool is_used = false;
    for (std::size_t at = 0; !is_used && (at = text.find(command, at)) != text.npos; at += command.size())
      is_used = ends_at(at + command.size());
    if (is_used) continue;
    std::size_t at = table;  // its key, the first of that name there
    while ((at = text.find(name, at)) != text.npos && (is_letter(text[at - 1]) || !ends_at(at + name.size())))
      ++at;
    report.warning(source.place_of(std::min(at, text.size())),
                   "macro " + in_quotes(name) + " is used nowhere", "leave it out");
  }
}

/// `only`: what read_stage() asks for; null: all.
LessonReading read(std::string_view text, std::string_view file_name, const std::string* only) {
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) text.remove_prefix(kByteOrderMark.size());
  const SourceText source(text.substr(0, kMaxLessonBytes));
  Report report(source, file_name);
  LessonReading reading;
  if (!refuse_whole(text, report, source)) {
    TextReader texts(report);
    FrontMatter front = read_front_matter(texts, only == nullptr ? Meanings::checked : Meanings::known);
    std::vector<Stage> stages = read_stages(front, texts, only);
    std::vector<OutsideReference> others = std::move(front.about.next);
    if (only == nullptr) {
      const std::vector<OutsideReference> linked = resolve_references(stages, report);
      others.insert(others.end(), linked.begin(), linked.end());
      note_citations(front.about, texts.citable(), report);
      note_unused_macros(texts.macros(), source, report);
    }
    if (!report.has_errors()) {
      reading.lesson = Lesson{std::move(front.id),
                              std::move(front.title),
                              std::move(front.symbols),
                              std::move(texts.macros()),
                              std::move(front.notation),
                              std::move(front.assumptions),
                              std::move(stages),
                              std::string(text),
                              std::move(front.about.about),
                              std::move(front.about.references),
                              std::move(others),
                              texts.take_numbers()};
    }
  }
  reading.diagnostics = report.take();
  return reading;
}

}  // namespace

LessonReading read_lesson(std::string_view text, std::string_view file_name) {
  return read(text, file_name, nullptr);
}

LessonReading read_stage(std::string_view text, std::string_view file_name, const std::string& stage_id) {
  return read(text, file_name, &stage_id);
}

}  // namespace polhode
