// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/about_keys.h"

#include "base/spelling.h"
#include "base/utf8.h"
#include "lessons/reader/markdown/callouts.h"
#include "render/typeset/characters.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace polhode {
namespace {

bool check_line(const std::string& text, const std::string& key, SourcePlace place, Report& report) {
  if (!is_blank(text) && is_plain_line(text)) return true;
  report.error(place, in_quotes(key) + " is one line of text without control characters");
  return false;
}

void read_line(const TomlEntry& entry, std::string& into, Report& report) {
  auto text = read_text(entry, report);
  if (text && check_line(*text, entry.key, entry.value.place, report)) into = curled(*text);
}

void read_lines(const TomlEntry& entry, std::vector<std::string>& into, Report& report) {
  const auto lines = read_texts(entry, kMaxAboutLines, report);
  if (!lines) return;
  for (const PlacedText& line : *lines)
    if (check_line(line.text, entry.key, line.place, report)) into.push_back(curled(line.text));
}

void read_next(const TomlEntry& entry, AboutKeys& keys, Report& report) {
  const auto id = read_text(entry, report);
  if (!id) return;
  if (!is_id(*id))
    return report.error(entry.value.place, "bad lesson id " + in_quotes(*id), std::string(kIdRule));
  keys.about.next = *id;
  keys.next = {{.lesson = *id, .place = entry.value.place}};
}

/// The table of an entry; says so if it is none.
const TomlTable* table_of(const TomlEntry& entry, const std::string& usage, Report& report) {
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr)
    report.error(entry.value.place,
                 in_quotes(entry.key) + " takes a table, found " + std::string(entry.value.kind()), usage);
  return table;
}

/// The signs and words that pages have for verdicts.
bool is_like_verdict(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<std::string_view, 7> kWords{
      "✓", "✔", "✗", "✘", "always true", "proved", "true in every"};
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return text.find(word) != text.npos; });
}

void read_labels(const TomlEntry& entry, About& about, Report& report) {
  const TomlTable* table = table_of(entry, "write [labels], and said = \"…\" below", report);
  if (table == nullptr) return;
  std::vector<KeyHandler> handlers;
  for (const CalloutNames& names : kCallouts) {
    if (names.kind == Callout::Kind::notes) continue;  // they stand beside nothing
    handlers.push_back(
        {std::string(names.name), [&about, &report, kind = names.kind](const TomlEntry& label) {
           std::string text;
           read_line(label, text, report);
           if (count_characters(text) > kMaxLabelCharacters)
             report.error(label.value.place,
                          "a label has at most " + std::to_string(kMaxLabelCharacters) + " characters");
           else if (is_like_verdict(text))
             report.error(label.value.place, "this label reads as what is said of a formula that is proved",
                          "give the formula a kind, ```math ID identity, and the page says it");
           else if (!text.empty())
             about.labels[kind] = std::move(text);
         }});
  }
  read_keys(*table, "[labels]", handlers, report);
}

void read_references(const TomlEntry& entry, AboutKeys& keys, Report& report) {
  const TomlTable* table = table_of(entry, "write [references], and KEY = \"…\" below", report);
  if (table == nullptr) return;
  if (table->entries.size() > kMaxReferences)
    return report.error(entry.place,
                        "a lesson has at most " + std::to_string(kMaxReferences) + " references");
  for (const TomlEntry& one : table->entries) {
    if (!is_id(one.key)) {
      report.error(one.place, "bad key of a reference " + in_quotes(one.key), std::string(kIdRule));
      continue;
    }
    Reference reference{one.key, "", false};
    read_line(one, reference.text, report);
    keys.references.push_back(std::move(reference));
    keys.reference_places.push_back({one.key, one.place});
  }
}

}  // namespace

void read_language(const TomlEntry& entry, About& about, Report& report) {
  const auto tag = read_text(entry, report);
  if (!tag) return;
  if (const auto language = language_from(*tag)) {
    about.language = *language;
    return;
  }
  std::string known;
  for (const Language language : kLanguages)
    known += (known.empty() ? "" : " or ") + in_quotes(std::string(tag_of(language)));
  report.error(entry.value.place, "unknown language " + in_quotes(*tag), "a lesson is in " + known);
}

std::vector<KeyHandler> about_key_handlers(AboutKeys& keys, Report& report) {
  About& about = keys.about;
  return {{"author", [&](const TomlEntry& e) { read_lines(e, about.authors, report); }},
          {"licence", [&](const TomlEntry& e) { read_line(e, about.licence, report); }},
          {"outcomes", [&](const TomlEntry& e) { read_lines(e, about.outcomes, report); }},
          {"prerequisites", [&](const TomlEntry& e) { read_lines(e, about.prerequisites, report); }},
          {"next", [&](const TomlEntry& e) { read_next(e, keys, report); }},
          {"labels", [&](const TomlEntry& e) { read_labels(e, about, report); }},
          {"references", [&](const TomlEntry& e) { read_references(e, keys, report); }}};
}

}  // namespace polhode
