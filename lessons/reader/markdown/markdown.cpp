// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/markdown.h"

#include "lessons/reader/markdown/md4c_answers.h"
#include "lessons/reader/reader.h"

#include <md4c.h>

#include <algorithm>
#include <array>
#include <functional>

namespace polhode {
namespace {

constexpr std::size_t kMaxMarginSpaces = 3;  // four would be indented code in CommonMark

std::string_view without_margin(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  return begin > kMaxMarginSpaces ? std::string_view{} : line.substr(begin);
}

// Length of the run of ` or ~ that opens or closes a fence, 0 if the line does neither.
std::size_t fence_run(std::string_view line) {
  line = without_margin(line);
  if (line.empty() || (line[0] != '`' && line[0] != '~')) return 0;
  const std::size_t run = std::min(line.find_first_not_of(line[0]), line.size());
  return run >= 3 ? run : 0;
}

bool closes_fence(std::string_view line, std::string_view opening) {
  const std::size_t run = fence_run(line);
  if (run == 0 || run < fence_run(opening)) return false;
  line = without_margin(line);
  return line[0] == without_margin(opening)[0] && is_blank(line.substr(run));
}

bool is_blank_at(std::string_view line, std::size_t i) {
  return i >= line.size() || line[i] == ' ' || line[i] == '\t' || line[i] == '\r';
}

// Bytes of the mark of a quote or list item at the start of a line, 0 if there is none.
std::size_t container_mark(std::string_view line) {
  if (line.empty()) return 0;
  if (line[0] == '>') return 1;
  if (line[0] == '-' || line[0] == '+' || line[0] == '*') return is_blank_at(line, 1) ? 1 : 0;
  std::size_t digits = 0;
  while (digits < 9 && digits < line.size() && line[digits] >= '0' && line[digits] <= '9') ++digits;
  const bool item = digits > 0 && digits < line.size() && (line[digits] == '.' || line[digits] == ')');
  return item && is_blank_at(line, digits + 1) ? digits + 1 : 0;
}

bool is_line_of(std::string_view line, char mark) {
  return std::all_of(line.begin(), line.end(), [mark](char c) { return c == mark || is_blank({&c, 1}); });
}

struct LinePrefix {
  std::size_t size = 0;  // bytes before the line's own content
  int containers = 0;    // quotes and list items it opens
};

// Stops after `limit` + 1 containers, so that asking at each of them whether a rule follows stays linear.
LinePrefix prefix_of(std::string_view line, int limit) {
  LinePrefix prefix;
  while (prefix.containers <= limit) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t", prefix.size), line.size());
    const std::string_view rest = line.substr(begin);
    const std::size_t mark = container_mark(rest);
    prefix.size = begin;
    if (mark == 0 || is_rule_line(rest)) break;
    prefix.size += mark;
    ++prefix.containers;
  }
  return prefix;
}

void blank_out(std::string& text, std::size_t begin, std::size_t end) {
  static constexpr auto kIsInlineMark = [] {
    std::array<bool, 256> is_mark{};
    for (const char c : std::string_view("*_`[]()!&\\<>~|@$:")) is_mark[static_cast<unsigned char>(c)] = true;
    return is_mark;
  }();
  for (std::size_t i = begin; i < end; ++i)
    if (kIsInlineMark[static_cast<unsigned char>(text[i])]) text[i] = 'x';
}

// Where the inline content of a line begins: after what makes blocks.
std::size_t inline_begin(std::string_view line) {
  const std::size_t begin = prefix_of(line, kMaxNesting).size;
  const std::string_view rest = line.substr(begin);
  if (rest.empty()) return begin;
  if (is_rule_line(rest) || is_line_of(rest, '=') || is_line_of(rest, '-')) return line.size();
  const bool may_be_fence = rest[0] == '`' || rest[0] == '~';
  const std::size_t run = may_be_fence ? std::min(rest.find_first_not_of(rest[0]), rest.size()) : 0;
  return run >= 3 ? begin + run : begin;
}

template <class F>
void for_each_line(std::string_view text, F&& f) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    f(begin, end);
    begin = end + 1;
  }
}

// Turns md4c's calls into blocks. md4c gives places for text only; a block without text (a rule, an empty
// fence) is found by looking for its line from the cursor, the first line that no block before it has taken.
class BlockCollector {
 public:
  BlockCollector(const SourceText& source, int first_line, Report& report)
      : source_(source), report_(report), cursor_(first_line), free_line_(first_line) {}

  MarkdownReading run(int first_line) {
    offset_ = source_.begin_of(first_line);
    copy_ = without_inline_marks(source_.text().substr(offset_));
    MD_PARSER parser{};
    parser.flags = MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_NOHTML;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) {
      return static_cast<BlockCollector*>(self)->enter(type, detail);
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) {
      return static_cast<BlockCollector*>(self)->leave(type);
    };
    parser.enter_span = parser.leave_span = [](MD_SPANTYPE, void*, void*) { return 0; };
    parser.text = [](MD_TEXTTYPE, const MD_CHAR* text, MD_SIZE, void* self) {
      return static_cast<BlockCollector*>(self)->text(text);
    };
    const int stopped = md_parse(copy_.data(), static_cast<MD_SIZE>(copy_.size()), &parser, this);
    reading_.complete = stopped == 0;
    if (reading_.complete) {
      add_prose_before(source_.line_count() + 1);
    } else if (!report_.has_errors()) {
      report_.error({1, 1}, "there is not enough memory to read this lesson");
    }
    return std::move(reading_);
  }

 private:
  int enter(MD_BLOCKTYPE type, void* detail) {
    if (type == MD_BLOCK_DOC || type == MD_BLOCK_P) return 0;
    const bool outermost = depth_ == 0;
    if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) {
      ++depth_;  // its items count the nesting
      return 0;
    }
    if (type == MD_BLOCK_QUOTE || type == MD_BLOCK_LI) {
      if (++containers_ > kMaxNesting) return refuse_nesting();
    }
    ++depth_;
    if (!outermost) return enter_inner(type);
    return enter_outermost(type, detail);
  }

  int enter_outermost(MD_BLOCKTYPE type, void* detail) {
    block_ = {};
    if (type == MD_BLOCK_H) {
      block_.kind = MarkdownBlock::Kind::heading;
      block_.level = static_cast<int>(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level);
      first_text_line_ = 0;
      return 0;
    }
    if (type == MD_BLOCK_HR) {
      block_.kind = MarkdownBlock::Kind::rule;
      block_.first_line = find_line([](std::string_view line) { return is_rule_line(line); });
    } else if (type == MD_BLOCK_CODE) {
      block_.kind = MarkdownBlock::Kind::fence;
      block_.first_line = find_line([](std::string_view line) { return fence_run(line) > 0; });
    } else {
      block_.kind = MarkdownBlock::Kind::quote;
      block_.first_line =
          find_line([](std::string_view line) { return without_margin(line).substr(0, 1) == ">"; });
    }
    block_.last_line = block_.first_line;
    return 0;
  }

  // Something that has a meaning of its own only at the margin.
  int enter_inner(MD_BLOCKTYPE type) {
    if (type == MD_BLOCK_CODE) {
      const int line = find_line([](std::string_view text) {
        return text.find("```") != std::string_view::npos || text.find("~~~") != std::string_view::npos;
      });
      report_.error({line, 1}, "a fence inside a list or quote is not read",
                    "put an empty line before it and begin it at the margin");
      cursor_ = std::min(line + 1, source_.line_count());
    }
    if (type == MD_BLOCK_H) {
      const int line =
          find_line([](std::string_view text) { return text.find('#') != std::string_view::npos; });
      report_.error({line, 1}, "a heading inside a list or quote starts no stage", "begin it at the margin");
    }
    return 0;
  }

  int leave(MD_BLOCKTYPE type) {
    if (type == MD_BLOCK_DOC || type == MD_BLOCK_P) return 0;
    if (type == MD_BLOCK_QUOTE || type == MD_BLOCK_LI) --containers_;
    if (--depth_ > 0 || type == MD_BLOCK_UL || type == MD_BLOCK_OL) return 0;
    finish_block();
    return add(block_);
  }

  void finish_block() {
    switch (block_.kind) {
      case MarkdownBlock::Kind::heading:
        finish_heading();
        break;
      case MarkdownBlock::Kind::fence:
        finish_fence();
        break;
      case MarkdownBlock::Kind::quote:
        block_.last_line = std::max(block_.first_line, cursor_ - 1);
        while (block_.last_line < source_.line_count() &&
               without_margin(source_.line(block_.last_line + 1)).substr(0, 1) == ">") {
          ++block_.last_line;
        }
        break;
      default:
        break;
    }
    cursor_ = std::max(cursor_, block_.last_line + 1);
  }

  void finish_heading() {
    const auto is_heading = [](std::string_view line) { return heading_level(line) > 0; };
    block_.first_line = first_text_line_ > 0 ? first_text_line_ : find_line(is_heading);
    block_.underlined = !is_heading(source_.line(block_.first_line));
    block_.last_line = block_.underlined ? std::min(cursor_, source_.line_count()) : block_.first_line;
  }

  void finish_fence() {
    const std::string_view opening = source_.line(block_.first_line);
    int line = block_.first_line + 1;
    while (line <= source_.line_count() && !closes_fence(source_.line(line), opening)) ++line;
    block_.closed = line <= source_.line_count();
    block_.last_line = std::min(line, source_.line_count());
  }

  int text(const char* text) {
    // Line ends come from md4c's own constants, not from the copy.
    const std::less<const char*> before;
    if (before(text, copy_.data()) || !before(text, copy_.data() + copy_.size())) return 0;
    const int line = source_.line_of(offset_ + static_cast<std::size_t>(text - copy_.data()));
    if (first_text_line_ == 0) first_text_line_ = line;
    cursor_ = std::max(cursor_, line + 1);
    return 0;
  }

  template <class Is>
  int find_line(Is is_wanted) const {
    for (int line = cursor_; line <= source_.line_count(); ++line) {
      if (is_wanted(source_.line(line))) return line;
    }
    return std::min(cursor_, source_.line_count());
  }

  int add(const MarkdownBlock& block) {
    add_prose_before(block.first_line);
    if (reading_.blocks.size() >= static_cast<std::size_t>(kMaxParts)) {
      report_.error({block.first_line, 1}, "a lesson has at most " + std::to_string(kMaxParts) + " parts");
      return kStop;
    }
    reading_.blocks.push_back(block);
    free_line_ = block.last_line + 1;
    return 0;
  }

  // What lies between two other blocks is prose.
  void add_prose_before(int end_line) {
    int first = free_line_;
    int last = end_line - 1;
    while (first <= last && is_blank(source_.line(first))) ++first;
    while (last >= first && is_blank(source_.line(last))) --last;
    if (first > last) return;
    MarkdownBlock prose;
    prose.first_line = first;
    prose.last_line = last;
    reading_.blocks.push_back(prose);
  }

  int refuse_nesting() {
    report_.error({std::min(cursor_, source_.line_count()), 1},
                  "quotes and lists are nested deeper than " + std::to_string(kMaxNesting));
    return kStop;
  }

  const SourceText& source_;
  Report& report_;
  std::string copy_;
  std::size_t offset_ = 0;   // of the copy in the source
  int cursor_;               // first line not yet taken by a block or its text
  int free_line_;            // first line after the last block that is not prose
  int depth_ = 0;            // of blocks, paragraphs not counted
  int containers_ = 0;       // quotes and list items among them
  int first_text_line_ = 0;  // of the heading being read
  MarkdownBlock block_;      // outermost one being read
  MarkdownReading reading_;
};

}  // namespace

int heading_level(std::string_view line) {
  line = without_margin(line);
  const std::size_t level = std::min(line.find_first_not_of('#'), line.size());
  return level >= 1 && level <= 6 && is_blank_at(line, level) ? static_cast<int>(level) : 0;
}

bool is_rule_line(std::string_view line) {
  line = trimmed(without_margin(line));
  if (line.empty() || (line[0] != '-' && line[0] != '*' && line[0] != '_')) return false;
  return is_line_of(line, line[0]) && std::count(line.begin(), line.end(), line[0]) >= 3;
}

std::string without_inline_marks(std::string_view text) {
  std::string copy(text);
  for_each_line(text, [&](std::size_t begin, std::size_t end) {
    blank_out(copy, begin + inline_begin(text.substr(begin, end - begin)), end);
  });
  return copy;
}

std::optional<std::size_t> first_markdown_nested_deeper(std::string_view text, int limit) {
  std::optional<std::size_t> found;
  for_each_line(text, [&](std::size_t begin, std::size_t end) {
    if (found) return;
    const LinePrefix prefix = prefix_of(text.substr(begin, end - begin), limit);
    if (prefix.containers > limit) found = begin + prefix.size - 1;
  });
  return found;
}

MarkdownReading read_markdown(const SourceText& source, int first_line, Report& report) {
  if (first_line > source.line_count()) return {};
  const std::size_t offset = source.begin_of(first_line);
  if (const auto deep = first_markdown_nested_deeper(source.text().substr(offset), kMaxNesting)) {
    report.error(source.place_of(offset + *deep),
                 "quotes and lists are nested deeper than " + std::to_string(kMaxNesting));
    return {{}, false};
  }
  return BlockCollector(source, first_line, report).run(first_line);
}

}  // namespace polhode
