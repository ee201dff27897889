// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/heading.h"

#include <algorithm>
#include <cctype>

namespace polhode {
namespace {

constexpr std::size_t kMaxWords = 16;  // more than any fence has
constexpr std::size_t kMaxSlugBytes = 40;

// An id made of the title's letters, to propose.
std::string slug(std::string_view title) {
  std::string id;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U && std::isalnum(byte) != 0)
      id += static_cast<char>(std::tolower(byte));
    else if (!id.empty() && id.back() != '-')
      id += '-';
    if (id.size() == kMaxSlugBytes) break;
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id.empty() ? "stage-id" : id;
}

/// Without the marks of a heading before it, and the blanks around it.
std::string_view text_of_heading(std::string_view line) {
  const std::string_view text = trimmed(line);
  return trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
}

}  // namespace

Heading read_heading(int number, TextReader& texts) {
  Report& report = texts.report();
  const std::string_view line = texts.source().line(number);
  const SourcePlace start{number, 1};
  const auto place_of = [&](std::string_view part) {
    return advanced(start, line, static_cast<std::size_t>(part.data() - line.data()));
  };
  const std::string_view text = text_of_heading(line);
  Heading heading;
  const std::size_t brace = text.rfind('{');
  if (text.empty() || text.back() != '}' || brace == std::string_view::npos) {
    heading.title = text;
    report.error(start, "this heading has no stage id in braces at its end",
                 "end it with {" + slug(text) + "}");
    return heading;
  }
  const std::string_view title = trimmed(text.substr(0, brace));
  const std::string_view id = trimmed(text.substr(brace + 1, text.size() - brace - 2));
  heading.title = title;
  heading.id_place = place_of(id);
  if (title.empty()) report.error(start, "this stage has no title", "# Title {" + slug(id) + "}");
  heading.title_text = texts.line(LocatedText(texts.source(), title));
  if (is_id(id))
    heading.id = id;
  else
    report.error(heading.id_place, "bad stage id " + in_quotes(id), std::string(kIdRule));
  return heading;
}

RichText read_step_title(int number, TextReader& texts) {
  const std::string_view title = text_of_heading(texts.source().line(number));
  if (title.empty()) texts.report().error({number, 1}, "this step has no title", "## Title, or --- alone");
  if (title.ends_with('}'))
    texts.report().error(texts.source().place_of(title.substr(std::min(title.rfind('{'), title.size()))),
                         "a step has no id", "leave out the braces; links lead to stages and equations");
  return texts.line(LocatedText(texts.source(), title));
}

std::vector<PlacedText> read_words(std::string_view line, std::size_t begin, int number) {
  constexpr std::string_view kBlank = " \t\r";
  std::vector<PlacedText> words;
  begin = line.find_first_not_of(kBlank, std::min(begin, line.size()));
  while (begin != std::string_view::npos && words.size() < kMaxWords) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    words.push_back({std::string(line.substr(begin, end - begin)), advanced({number, 1}, line, begin)});
    begin = line.find_first_not_of(kBlank, end);
  }
  return words;
}

std::string_view trimmed_lines(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

}  // namespace polhode
