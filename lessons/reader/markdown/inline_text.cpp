// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/inline_text.h"

#include "base/spelling.h"
#include "lessons/reader/markdown/entities.h"
#include "lessons/reader/markdown/heading.h"
#include "lessons/reader/markdown/inline_marks.h"
#include "lessons/reader/markdown/md4c_answers.h"
#include "render/typeset/characters.h"
#include "render/typeset/line_formulas.h"
#include "render/typeset/math/tree.h"

#include <md4c.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace polhode {
namespace {

/// Before a text that is one paragraph: what follows a word and a space opens no block.
constexpr std::string_view kParagraphOpener = "x ";

}  // namespace

/// Turns md4c's calls into blocks and spans. md4c reads a copy in which letters stand for formulas, and
/// commas for marks of footnotes and citations, so that no mark of Markdown in them counts; its pointers into
/// the copy say where everything is.
class TextReader::Builder {
 public:
  Builder(TextReader& reader, const LocatedText& markdown, Form form)
      : reader_(reader), markdown_(markdown), text_(markdown.text()), form_(form) {}

  RichText run() {
    marks_ = find_inline_marks(markdown_, reader_.report_);
    make_copy();
    MD_PARSER parser{};
    parser.flags = MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_TABLES;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) {
      return static_cast<Builder*>(self)->enter_block(type, detail);
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) {
      return static_cast<Builder*>(self)->leave_block(type);
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) {
      return static_cast<Builder*>(self)->enter_span(type, detail);
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* self) {
      return static_cast<Builder*>(self)->leave_span(type);
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* self) {
      return static_cast<Builder*>(self)->add_text(type, {text, size});
    };
    if (form_ == Form::passage) find_marker_lines();
    const int stopped = md_parse(copy_.data(), static_cast<MD_SIZE>(copy_.size()), &parser, this);
    if (stopped != 0 && !saw_limit_) error(0, "there is not enough memory to read this text");
    if (stopped != 0) return {};
    report_lost_marks(text_.size());
    report_marker_lines();
    if (saw_unread_block_ && !reader_.report_.has_errors())
      error(0, "a heading or fence inside a text is not read", "begin it at the margin");
    for (TextBlock& block : blocks_) block.spans.shrink_to_fit();
    return std::move(blocks_);
  }

 private:
  struct List {
    bool numbered = false;
    unsigned next = 1;
    char delimiter = '.';
  };

  void make_copy() {
    const bool one_paragraph = form_ == Form::line;
    copy_ = one_paragraph ? std::string(kParagraphOpener) : std::string();
    opener_ = copy_.size();
    copy_ += text_;
    for (const InlineMark& mark : marks_)
      std::fill(copy_.begin() + static_cast<std::ptrdiff_t>(opener_ + mark.whole.begin),
                copy_.begin() + static_cast<std::ptrdiff_t>(opener_ + mark.whole.end),
                mark.kind == InlineMark::Kind::formula ? 'x' : ',');
    if (one_paragraph) std::replace(copy_.begin(), copy_.end(), '\n', ' ');
  }

  void error(std::size_t at, std::string message, std::string hint = {}) {
    reader_.report_.error(reader_.source().place_of(markdown_.offset_of(std::min(at, text_.size()))),
                          std::move(message), std::move(hint));
  }
  /// Where the next of these bytes is, or the place reached.
  std::size_t next_of(std::string_view bytes) const {
    const std::size_t found = text_.find(bytes, cursor_);
    return found == std::string_view::npos ? cursor_ : found;
  }
  std::size_t next_line_begin() const {
    const std::size_t found = text_.find_first_not_of(" \t\r\n", cursor_);
    return found == std::string_view::npos ? cursor_ : found;
  }

  // ---- Blocks

  int enter_block(MD_BLOCKTYPE type, void* detail) {
    block_is_open_ = false;
    switch (type) {
      case MD_BLOCK_UL:
        lists_.push_back({});
        break;
      case MD_BLOCK_OL: {
        const auto* list = static_cast<MD_BLOCK_OL_DETAIL*>(detail);
        lists_.push_back({true, list->start, list->mark_delimiter});
        break;
      }
      case MD_BLOCK_LI:
        marker_ = next_marker();
        open_block();
        block_is_open_ = false;  // its paragraph, if it has one, goes on with this block
        item_is_new_ = true;
        break;
      case MD_BLOCK_QUOTE:
        error(next_of(">"), "a quote inside a text is not read", "begin it at the margin");
        break;
      case MD_BLOCK_HR:
        error(next_line_begin(), "a rule inside a text is not read", "begin it at the margin");
        break;
      case MD_BLOCK_TABLE:
        return begin_table(*static_cast<MD_BLOCK_TABLE_DETAIL*>(detail));
      case MD_BLOCK_TR:
        begin_row();
        break;
      case MD_BLOCK_TH:
      case MD_BLOCK_TD:
        begin_cell(static_cast<MD_BLOCK_TD_DETAIL*>(detail)->align);
        break;
      case MD_BLOCK_HTML:
        in_html_ = true;
        error(next_of("<"), "HTML is not read", "write \\< for the sign <");
        break;
      case MD_BLOCK_CODE:
      case MD_BLOCK_H:
        saw_unread_block_ = true;  // read_markdown has reported it
        break;
      default:
        break;
    }
    return 0;
  }

  int leave_block(MD_BLOCKTYPE type) {
    if ((type == MD_BLOCK_UL || type == MD_BLOCK_OL) && !lists_.empty()) lists_.pop_back();
    block_is_open_ = false;
    if (type == MD_BLOCK_HTML) in_html_ = false;
    if (type == MD_BLOCK_TR) cursor_ = std::max(cursor_, std::min(row_line_.end, text_.size()));
    if (type == MD_BLOCK_TH || type == MD_BLOCK_TD) in_cell_ = false;
    if (type == MD_BLOCK_TABLE) cursor_ = std::max(cursor_, next_line(head_line_).end);
    item_is_new_ = item_is_new_ && type != MD_BLOCK_LI;
    return 0;
  }

  std::string next_marker() {
    if (lists_.empty()) return "";
    List& list = lists_.back();
    if (!list.numbered) return lists_.size() == 1 ? "•" : "–";
    return std::to_string(list.next++) + list.delimiter;
  }

  void open_block() {
    blocks_.push_back({static_cast<int>(lists_.size()), std::exchange(marker_, ""), {}});
    block_is_open_ = true;
  }

  // ---- Tables

  struct Line {
    std::size_t begin = 0, end = 0;
  };
  /// The line of the text that this byte is on, without its end.
  Line line_at(std::size_t at) const {
    const std::size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    return {begin, std::min(text_.find('\n', at), text_.size())};
  }
  Line next_line(const Line& line) const { return line_at(std::min(line.end + 1, text_.size())); }

  int begin_table(const MD_BLOCK_TABLE_DETAIL& table) {
    const std::size_t at = next_line_begin();
    const auto refuse = [&](std::string message, std::string hint) {
      error(at, std::move(message), std::move(hint));
      saw_limit_ = true;
      return kStop;
    };
    if (!lists_.empty()) return refuse("a table inside a list is not read", "begin it at the margin");
    if (form_ != Form::passage)
      return refuse("a table stands in text and call-outs only", "write it as text below an empty line");
    if (table.col_count > kMaxTableColumns || table.body_row_count > kMaxTableRows)
      return refuse("a table has at most " + std::to_string(kMaxTableColumns) +
                        " columns, and below its head " + std::to_string(kMaxTableRows) + " rows",
                    "make several tables of it");
    open_block();
    row_line_ = {};
    head_line_ = line_at(at);
    marker_lines_.erase(next_line(head_line_).begin);
    columns_ = table.col_count;
    return 0;
  }

  void begin_row() {
    TextTable& table = blocks_.back().table;
    const bool is_first_below = table.rows.size() == 1;
    row_line_ =
        table.rows.empty() ? head_line_ : next_line(is_first_below ? next_line(head_line_) : row_line_);
    cursor_ = std::max(cursor_, row_line_.begin);
    table.rows.emplace_back();
    const std::size_t cells = cells_in(row_line_), at = text_.find_first_not_of(" \t", row_line_.begin);
    if (cells == columns_) return;
    const std::string has = std::to_string(cells) + (cells == 1 ? " cell" : " cells");
    if (table.rows.size() == 1)
      return error(at, "the head has " + has + ", and the line below it " + std::to_string(columns_),
                   "write --- below each cell of the head");
    error(at, "this row has " + has + ", the head has " + std::to_string(columns_),
          cells < columns_ ? "an empty cell is written | |" : "write \\| for the sign |");
  }

  void begin_cell(MD_ALIGN align) {
    using Align = TextTable::Align;
    TextTable& table = blocks_.back().table;
    if (table.rows.size() == 1)
      table.columns.push_back(align == MD_ALIGN_RIGHT    ? Align::right
                              : align == MD_ALIGN_CENTER ? Align::center
                                                         : Align::left);
    table.rows.back().emplace_back();
    in_cell_ = true;
  }

  /// Of a row: what stands between its bars, which count neither behind a backslash nor in code.
  std::size_t cells_in(const Line& line) const {
    const std::string_view row =
        trimmed(std::string_view(copy_).substr(opener_ + line.begin, line.end - line.begin));
    std::size_t bars = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == '\\') {
        ++i;
      } else if (row[i] == '`') {
        const std::size_t run = std::min(row.find_first_not_of('`', i), row.size()) - i;
        const std::size_t closing = row.find(std::string(run, '`'), i + run);
        i = closing == std::string_view::npos ? i + run - 1 : closing + run - 1;
      } else if (row[i] == '|') {
        ++bars;
      }
    }
    const bool opens = row.starts_with('|'),
               closes = row.size() > 1 && row.ends_with('|') && !row.ends_with("\\|");
    return bars + 1 - (opens ? 1 : 0) - (closes ? 1 : 0);
  }

  /// Lines that stand below the head of a table: if no table comes of one, its author does not see why.
  void find_marker_lines() {
    for (Line line = line_at(0);; line = next_line(line)) {
      const std::string_view words = trimmed(text_.substr(line.begin, line.end - line.begin));
      const bool has_bar = words.find('|') != std::string_view::npos;
      if (has_bar && words.find('-') != std::string_view::npos &&
          words.find_first_not_of("|:- \t") == std::string_view::npos)
        marker_lines_.insert(line.begin);
      if (line.end >= text_.size()) return;
    }
  }

  void report_marker_lines() {
    for (const std::size_t begin : marker_lines_)
      error(text_.find_first_not_of(" \t", begin), "no table comes of this line",
            "write --- for each cell of the head, which stands alone above it, below an empty line");
  }

  std::vector<TextSpan>& current() {
    return in_cell_ ? blocks_.back().table.rows.back().back() : blocks_.back().spans;
  }

  std::vector<TextSpan>& spans() {
    if (in_cell_) return current();
    if (!block_is_open_) {
      if (!item_is_new_) open_block();
      block_is_open_ = true;
      item_is_new_ = false;
    }
    return blocks_.back().spans;
  }

  // ---- Spans

  int enter_span(MD_SPANTYPE type, void* detail) {
    if (type == MD_SPAN_STRONG) ++bold_;
    if (type == MD_SPAN_EM) ++italic_;
    if (type == MD_SPAN_CODE) ++code_;
    if (type == MD_SPAN_IMG)
      error(next_of("!["), "images are not read", "a ```scene fence draws the figure of a step");
    if (type == MD_SPAN_A) {
      const MD_ATTRIBUTE& href = static_cast<MD_SPAN_A_DETAIL*>(detail)->href;
      link_ = href.size > 0 ? as_written({href.text, href.size}) : "#";
      link_at_ = next_of("[");
      link_is_empty_ = true;
    }
    return 0;
  }

  /// A part of the copy, without what stands for formulas there.
  std::string as_written(std::string_view part) const {
    const std::less<const char*> before;
    const bool in_copy =
        !before(part.data(), copy_.data() + opener_) && before(part.data(), copy_.data() + copy_.size());
    if (!in_copy) return std::string(part);
    return std::string(
        text_.substr(static_cast<std::size_t>(part.data() - copy_.data()) - opener_, part.size()));
  }

  int leave_span(MD_SPANTYPE type) {
    if (type == MD_SPAN_STRONG) --bold_;
    if (type == MD_SPAN_EM) --italic_;
    if (type == MD_SPAN_CODE) --code_;
    if (type == MD_SPAN_A) {
      if (link_is_empty_) {
        spans();
        push(new_span(markdown_.span_of(link_at_, std::min(link_at_ + 1, text_.size()))));
        cursor_ = std::max(cursor_, link_at_ + 1);
      }
      link_.clear();
    }
    return saw_limit_ ? kStop : 0;
  }

  int add_text(MD_TEXTTYPE type, std::string_view part) {
    if (saw_limit_) return kStop;
    if (type == MD_TEXT_BR) {
      if (!spans().empty()) spans().back().break_after = true;
      return 0;
    }
    // What md4c writes itself, for line ends, is no part of the copy.
    const std::less<const char*> before;
    const bool in_copy =
        !before(part.data(), copy_.data()) && before(part.data(), copy_.data() + copy_.size());
    if (!in_copy || type == MD_TEXT_SOFTBR) {
      add_plain(" ", {0, 0}, false);
      return 0;
    }
    std::size_t begin = static_cast<std::size_t>(part.data() - copy_.data());
    const std::size_t end = begin + part.size();
    begin = std::max(begin, opener_);
    if (begin < end) add_part(type, begin - opener_, end - opener_);
    return saw_limit_ ? kStop : 0;
  }

  /// Cuts formulas, marks of footnotes and citations out of [begin, end).
  void add_part(MD_TEXTTYPE type, std::size_t begin, std::size_t end) {
    report_lost_marks(begin);
    while (next_mark_ < marks_.size() && marks_[next_mark_].whole.end <= end) {
      const InlineMark mark = marks_[next_mark_++];
      add_words(type, begin, mark.whole.begin);
      add(mark);
      begin = mark.whole.end;
    }
    add_words(type, begin, end);
    cursor_ = std::max(cursor_, end);
  }

  /// Of those that begin before `end` and were in no text: they are in a link's address or the like.
  void report_lost_marks(std::size_t end) {
    for (; next_mark_ < marks_.size() && marks_[next_mark_].whole.begin < end; ++next_mark_) {
      const InlineMark& mark = marks_[next_mark_];
      if (mark.kind == InlineMark::Kind::formula)
        error(mark.whole.begin, "a formula cannot stand here", "write \\$ for a dollar sign");
      else
        error(mark.whole.begin, "a footnote or citation cannot stand here", "write \\[ for the bracket");
    }
  }

  void add(const InlineMark& mark) {
    if (mark.kind == InlineMark::Kind::formula) return add_formula(mark.inside);
    if (mark.kind == InlineMark::Kind::note) return add_note_mark(mark);
    add_citation(mark);
  }

  void add_note_mark(const InlineMark& mark) {
    const std::string id(text_.substr(mark.inside.begin, mark.inside.end - mark.inside.begin));
    if (form_ != Form::passage)
      return error(mark.whole.begin, "the mark of a footnote stands in text and call-outs only");
    if (text_.substr(mark.whole.end, 1) == ":" && begins_line(mark.whole.begin))
      return error(mark.whole.begin, "a footnote begins at the margin, below an empty line or another one");
    if (!is_id(id)) return error(mark.inside.begin, "bad id " + in_quotes(id), std::string(kIdRule));
    add_made(raised_number(reader_.notes_.number_of(id, markdown_.offset_of(mark.inside.begin))), mark);
  }

  bool begins_line(std::size_t at) const {
    const std::size_t before = text_.substr(0, at).find_last_not_of(" \t");
    return before == std::string_view::npos || text_[before] == '\n';
  }

  /// `[cite: KEY]` or `[cite: KEY, where]` is shown as [KEY, where].
  void add_citation(const InlineMark& mark) {
    std::string_view inside = text_.substr(mark.inside.begin, mark.inside.end - mark.inside.begin);
    const std::size_t comma = std::min(inside.find(','), inside.size());
    const std::string key(trimmed_lines(inside.substr(0, comma)));
    const auto found = reader_.citable_.find(key);
    if (found == reader_.citable_.end()) {
      std::vector<std::string> known;
      for (const auto& [name, is_cited] : reader_.citable_) known.push_back(name);
      const std::string hint = known.empty() ? "write [references] in the front matter, and " +
                                                   (is_id(key) ? key : "KEY") + " = \"…\" below"
                                             : suggestion(key, known);
      return error(mark.whole.begin, "no reference " + in_quotes(key) + " to cite", hint);
    }
    found->second = true;
    std::string where;  // in one line
    if (comma < inside.size()) where = trimmed_lines(inside.substr(comma + 1));
    std::replace(where.begin(), where.end(), '\n', ' ');
    const std::string around = std::exchange(link_, std::string(kCiteLink) + key);
    add_made('[' + key + (where.empty() ? "" : ", " + where) + ']', mark);
    link_ = around;
  }

  /// Text that stands for a mark.
  void add_made(std::string text, const InlineMark& mark) {
    TextSpan span = new_span(markdown_.span_of(mark.whole.begin, mark.whole.end));
    span.text = std::move(text);
    spans();
    push(std::move(span));
  }

  void add_words(MD_TEXTTYPE type, std::size_t begin, std::size_t end) {
    if (begin >= end) return;
    const std::string_view words = text_.substr(begin, end - begin);
    if (type == MD_TEXT_HTML) {
      if (!in_html_) error(begin, "HTML is not read", "write \\< for the sign <");
    } else if (type == MD_TEXT_ENTITY && words.front() == '&' && words.back() == ';') {
      add_entity(begin, words, markdown_.span_of(begin, end));
    } else {
      for (std::size_t at = begin; at < end;) {
        const std::size_t piece_end = std::min(end, markdown_.end_of_piece(at));
        const SourceSpan there = markdown_.span_of(at, piece_end);
        add_plain(text_.substr(at, piece_end - at), there, there.end - there.begin == piece_end - at);
        at = piece_end;
      }
    }
  }

  void add_entity(std::size_t begin, std::string_view entity, SourceSpan source) {
    const auto character = entity_character(entity);
    if (!character) {
      error(begin, "unknown character " + std::string(entity), "write the character itself, or \\&");
      return;
    }
    std::string text;
    append_utf8(text, *character);
    add_plain(text, source, false);
  }

  bool continues(const TextSpan& last, SourceSpan source, bool verbatim) const {
    return verbatim && last.kind == TextSpan::Kind::text && last.bold == (bold_ > 0) &&
           last.italic == (italic_ > 0) && last.code == (code_ > 0) && last.link == link_ &&
           !last.break_after && last.source.end == source.begin &&
           last.text.size() == last.source.end - last.source.begin;
  }

  /// A line end has no place of its own: that of the text before it is taken.
  void add_plain(std::string_view words, SourceSpan source, bool verbatim) {
    std::vector<TextSpan>& into = spans();
    if (source.end == 0) {
      const std::uint32_t at = into.empty() ? 0 : into.back().source.end;
      source = {at, at + 1};
      verbatim = true;
    }
    if (!into.empty() && continues(into.back(), source, verbatim)) {
      into.back().text += words;
      into.back().source.end = source.end;
      return;
    }
    TextSpan span = new_span(source);
    span.text = words;
    push(std::move(span));
  }

  void add_formula(SourceSpan formula) {
    auto math =
        reader_.parse_inline(markdown_, formula.begin, formula.end, reader_.macros_, form_ != Form::line);
    if (!math) return;
    TextSpan span = new_span(markdown_.span_of(formula.begin, formula.end));
    span.kind = TextSpan::Kind::math;
    span.text = text_.substr(formula.begin, formula.end - formula.begin);
    span.math = std::move(*math);
    spans();
    push(std::move(span));
  }

  TextSpan new_span(SourceSpan source) const {
    TextSpan span;
    span.bold = bold_ > 0;
    span.italic = italic_ > 0;
    span.code = code_ > 0;
    span.link = link_;
    span.source = source;
    return span;
  }

  void push(TextSpan span) {
    link_is_empty_ = false;
    saw_limit_ = !reader_.take_spans(1, span.source.begin);
    if (!saw_limit_) current().push_back(std::move(span));
  }

  TextReader& reader_;
  const LocatedText& markdown_;
  std::string_view text_;
  Form form_;
  std::vector<InlineMark> marks_;
  std::size_t next_mark_ = 0;
  std::string copy_;
  std::size_t opener_ = 0;  // bytes of the copy before the text
  std::size_t cursor_ = 0;  // in the text, behind what was read last

  RichText blocks_;
  std::vector<List> lists_;
  std::string marker_;                  // of the next block
  bool block_is_open_ = false;          // text goes into the last block
  bool item_is_new_ = false;            // the last block is an item's, still empty
  bool in_cell_ = false;                // text goes into the last cell of the last block
  std::size_t columns_ = 0;             // of the table being read
  Line head_line_, row_line_;           // and its lines
  std::set<std::size_t> marker_lines_;  // where lines begin that stand below a head, those of tables left out
  bool in_html_ = false;                // a block of it, which was reported
  bool saw_unread_block_ = false;
  bool saw_limit_ = false;
  int bold_ = 0, italic_ = 0, code_ = 0;
  std::string link_;
  std::size_t link_at_ = 0;    // where its bracket opens
  bool link_is_empty_ = true;  // no text of it has come
};

RichText TextReader::passage(const LocatedText& markdown) { return read(markdown, Form::passage); }
RichText TextReader::note(const LocatedText& markdown) { return read(markdown, Form::note); }
RichText TextReader::line(const LocatedText& markdown) { return read(markdown, Form::line); }

RichText TextReader::read(const LocatedText& markdown, Form form) {
  const std::size_t size = markdown.text().size();
  if (size > kMaxPassageBytes) {
    report_.error(source().place_of(markdown.offset_of(0)),
                  "this text has " + std::to_string(size) + " bytes, at most " +
                      std::to_string(kMaxPassageBytes) + " stand together",
                  "put it into several steps with ---");
    return {};
  }
  return Builder(*this, markdown, form).run();
}

RichText TextReader::caption(const LocatedText& text) {
  TextBlock block;
  std::size_t at = 0;
  const auto add = [&](std::size_t begin, std::size_t end, bool math) {
    if (begin >= end) return;
    if (math) {
      if (auto formula = formula_in_figure(text, begin, end)) block.spans.push_back(std::move(*formula));
      return;
    }
    TextSpan span;
    span.text = text.text().substr(begin, end - begin);
    span.source = text.span_of(begin, end);
    block.spans.push_back(std::move(span));
  };
  const auto add_words = [&](std::size_t begin, std::size_t end) {
    for (std::size_t dollar; (dollar = text.text().find("\\$", begin)) < end; begin = dollar + 1)
      add(begin, dollar, false);  // without the backslash
    add(begin, end, false);
  };
  for (const SourceSpan& formula : formulas_of_line(text.text())) {
    add_words(at, formula.begin - 1);
    add(formula.begin, formula.end, true);
    at = formula.end + 1;
  }
  add_words(at, text.text().size());
  return {std::move(block)};
}

RichText TextReader::label(const LocatedText& tex) {
  TextBlock block;
  if (auto formula = formula_in_figure(tex, 0, tex.text().size())) block.spans.push_back(std::move(*formula));
  return {std::move(block)};
}

/// Figures are set without the lesson's macros and numbers.
std::optional<TextSpan> TextReader::formula_in_figure(const LocatedText& text, std::size_t begin,
                                                      std::size_t end) {
  auto parsed = parse_inline(text, begin, end, {});
  if (!parsed) return std::nullopt;
  if (!parsed->references.empty())
    report_.error(source().place_of(text.offset_of(begin + parsed->references.front().offset)),
                  "\\eqref stands in texts and displays only");
  TextSpan span;
  span.text = text.text().substr(begin, end - begin);
  span.source = text.span_of(begin, end);
  span.kind = TextSpan::Kind::math;
  span.math = std::move(*parsed);
  return span;
}

bool TextReader::take_spans(std::size_t count, std::size_t offset) {
  const bool was_full = spans_ > kMaxLessonSpans;
  spans_ += count;
  if (spans_ <= kMaxLessonSpans) return true;
  if (!was_full)
    report_.error(source().place_of(offset), "the texts of a lesson have at most " +
                                                 std::to_string(kMaxLessonSpans) + " pieces of one kind");
  return false;
}

}  // namespace polhode
