// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/motion_table.h"

#include "base/utf8.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/diagnostics/source_text.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace polhode {
namespace {

using Cell = TextTable::Cell;

constexpr const char* kColumnForm = "for example { head = '$T$', of = \"T\", unit = \"J\", digits = 3 }";
constexpr const char* kRowForm = "for example { head = \"coin\", body = \"coin\" }";

TextSpan formula_span(Math math, std::string tex) {
  TextSpan span;
  span.kind = TextSpan::Kind::math;
  span.math = std::move(math);
  span.text = std::move(tex);
  return span;
}

TextSpan words_span(std::string text) {
  TextSpan span;
  span.text = std::move(text);
  return span;
}

class MotionTableReader {
 public:
  MotionTableReader(const LessonScene& scene, const LessonBodies& bodies, const SceneWords& words,
                    TextReader& texts)
      : scene_(scene), bodies_(bodies), words_(words), texts_(texts), report_(texts.report()) {}

  RichText read(const TomlTable& table, SourcePlace fence) {
    const TomlArray *columns = nullptr, *rows = nullptr;
    read_keys(
        table, "a table",
        {{"columns", [&](const TomlEntry& e) { columns = tables_of(e, kMaxTableColumns, kColumnForm); }},
         {"rows", [&](const TomlEntry& e) { rows = tables_of(e, kMaxTableRows, kRowForm); }},
         {"at",
          [&](const TomlEntry& e) {
            if (const auto t_s = read_number(e, report_)) at_s_ = *t_s;
          }}},
        report_);
    for (const char* key : {"columns", "rows"})
      if (table.find(key) == nullptr)
        report_.error(fence, "the table lacks " + in_quotes(key),
                      "write columns = [{ head = \"body\" }, { of = \"T\" }] and rows = [{ head = \"coin\", "
                      "body = \"coin\" }]");
    if (columns == nullptr) return {};
    for (const TomlValue& column : *columns) read_column(*column.as<TomlTable>(), column.place);
    const auto has_number = [](const Column& column) { return column.is_number; };
    if (std::none_of(columns_.begin(), columns_.end(), has_number))
      report_.error(table.find("columns")->value.place, "nothing of this table is computed",
                    "give a column \"of\", or write it in Markdown");
    if (rows == nullptr) return {};
    for (const TomlValue& row : *rows) read_row(*row.as<TomlTable>(), row.place);
    TextBlock block;
    block.table = std::move(table_);
    return {std::move(block)};
  }

 private:
  struct Column {
    bool is_number = false;
    std::optional<ComputedNumber> number;  ///< nothing: of words, or it could not be read
  };

  /// A list of 1 to `most` tables; null, and a report, if it is none.
  const TomlArray* tables_of(const TomlEntry& entry, std::size_t most, const char* form) {
    const std::string key = in_quotes(entry.key);
    const auto* list = entry.value.as<TomlArray>();
    if (list == nullptr) {
      report_.error(entry.value.place,
                    key + " takes a list of tables, found " + std::string(entry.value.kind()), form);
      return nullptr;
    }
    for (const TomlValue& value : *list)
      if (value.as<TomlTable>() == nullptr) {
        report_.error(value.place,
                      key + " takes a list of tables, found " + std::string(value.kind()) + " in it", form);
        return nullptr;
      }
    if (list->empty())
      report_.error(entry.value.place, key + " is empty", form);
    else if (list->size() > most)
      report_.error(entry.value.place,
                    "a table has at most " + std::to_string(most) + ' ' + entry.key + ", found " +
                        std::to_string(list->size()),
                    "make several tables of it");
    else
      return list;
    return nullptr;
  }

  void read_column(const TomlTable& table, SourcePlace place) {
    Column column;
    std::optional<Cell> head;
    std::optional<PlacedText> of;
    LiveNumber written;
    SourcePlace unit_place;
    read_keys(table, "a column",
              {{"head", [&](const TomlEntry& e) { head = read_cell(e); }},
               {"of", [&](const TomlEntry& e) { of = read_line(e); }},
               {"unit",
                [&](const TomlEntry& e) {
                  written.unit = read_text(e, report_).value_or("");
                  unit_place = e.value.place;
                }},
               {"digits", [&](const TomlEntry& e) { written.digits = read_digits(e); }}},
              report_);
    column.is_number = table.find("of") != nullptr;
    if (!column.is_number)
      for (const char* key : {"unit", "digits"})
        if (const TomlEntry* entry = table.find(key))
          report_.error(entry->place, in_quotes(key) + " belongs to a column of numbers",
                        "say which: of = \"T\", or leave it out");
    if (!column.is_number && table.find("head") == nullptr)
      report_.error(place, "a column has a \"head\", or says which numbers it is \"of\"", kColumnForm);
    if (of) {
      written.expression = of->text;
      column.number = read_quantity(*of, written, unit_place);
    }
    if (column.number && !head) {
      const std::string tex = tex_of(column.number->expression, &texts_.vocabulary());
      if (auto math = parse_math(tex)) head = Cell{formula_span(std::move(*math), tex)};
    }
    if (!head) head.emplace();
    if (column.number) add_unit(written.unit, *head);
    if (table_.rows.empty()) table_.rows.emplace_back();
    table_.rows.front().push_back(std::move(*head));
    table_.columns.push_back(column.is_number ? TextTable::Align::right : TextTable::Align::left);
    columns_.push_back(std::move(column));
  }

  std::optional<ComputedNumber> read_quantity(const PlacedText& of, const LiveNumber& written,
                                              SourcePlace unit_place) {
    const SourcePlace place =
        texts_.source().place_of(located_string(texts_.source(), of.place, of.text).offset_of(0));
    auto number = texts_.computed_number(written, place, unit_place);
    if (!number || !has_value_on_motions(number->expression, place, report_)) return std::nullopt;
    number->written.unit.clear();  // it stands in the head
    return number;
  }

  /// " (rad/s)", behind the words of a head.
  static void add_unit(const std::string& unit, Cell& head) {
    std::string tex = unit_tex(unit);
    if (tex.starts_with("\\,")) tex.erase(0, 2);
    auto math = parse_math(tex);
    if (tex.empty() || !math) return;
    head.push_back(words_span(" ("));
    head.push_back(formula_span(std::move(*math), tex));
    head.push_back(words_span(")"));
  }

  int read_digits(const TomlEntry& entry) {
    const auto* digits = entry.value.as<std::int64_t>();
    if (digits != nullptr && *digits >= 1 && *digits <= kMaxLiveDigits) return static_cast<int>(*digits);
    report_.error(entry.value.place, "digits is a whole number from 1 to " + std::to_string(kMaxLiveDigits));
    return 0;
  }

  std::optional<PlacedText> read_line(const TomlEntry& entry) {
    auto text = read_text(entry, report_);
    if (!text) return std::nullopt;
    if (is_plain_line(*text) && !is_blank(*text)) return PlacedText{std::move(*text), entry.value.place};
    report_.error(entry.value.place, "an expression is one line of text without control characters");
    return std::nullopt;
  }

  std::optional<Cell> read_cell(const TomlEntry& entry) {
    const auto text = read_text(entry, report_);
    return text ? std::optional(cell_of({*text, entry.value.place})) : std::nullopt;
  }

  Cell cell_of(const PlacedText& text) {
    RichText line = texts_.line(located_string(texts_.source(), text.place, text.text));
    return line.empty() ? Cell() : std::move(line.front().spans);
  }

  void read_row(const TomlTable& table, SourcePlace place) {
    auto row = std::make_shared<TableRow>();
    row->place = place;
    const TomlEntry* at = table.find("at");
    const auto at_s = at != nullptr ? read_number(*at, report_) : std::nullopt;
    row->scene = scene_of(table, place, at_s.value_or(at_s_));
    std::vector<Cell> words = words_of(table, place);
    auto next_words = words.begin();
    std::vector<Cell>& cells = table_.rows.emplace_back();
    for (const Column& column : columns_) {
      Cell& cell = cells.emplace_back();
      if (!column.is_number && next_words != words.end()) cell = std::move(*next_words++);
      if (!column.number) continue;
      ComputedNumber number = *column.number;
      number.row = row;
      if (auto math = texts_.formula_of(std::move(number))) {
        std::string tex = "\\live{" + column.number->written.expression + '}';
        // Whoever puts the value into this text, to be copied, is told that all of it is the number.
        math->live.front().whole = {0, static_cast<std::uint32_t>(tex.size())};
        cell.push_back(formula_span(std::move(*math), std::move(tex)));
      }
    }
  }

  /// What stands in the columns of words: a text, or one for each of them.
  std::vector<Cell> words_of(const TomlTable& table, SourcePlace place) {
    const auto columns = static_cast<std::size_t>(std::count_if(
        columns_.begin(), columns_.end(), [](const Column& column) { return !column.is_number; }));
    const TomlEntry* head = table.find("head");
    const auto texts =
        head != nullptr ? read_texts(*head, kMaxTableColumns, report_) : std::vector<PlacedText>();
    if (!texts) return {};
    if (texts->size() != columns)
      report_.error(head != nullptr ? head->value.place : place,
                    "the head of a row has a text for each column without \"of\": there are " +
                        std::to_string(columns) + ", and " + std::to_string(texts->size()) +
                        (texts->size() == 1 ? " text" : " texts"),
                    columns == 1 ? "write head = \"coin\"" : "");
    std::vector<Cell> cells;
    for (const PlacedText& text : *texts) cells.push_back(cell_of(text));
    return cells;
  }

  /// The motion of a row, without what pictures show of it.
  Scene scene_of(const TomlTable& changes, SourcePlace place, double at_s) {
    Scene scene = finished(changed_motion(scene_, changes, place, bodies_, words_, texts_), bodies_);
    scene = without_picture(std::move(scene), at_s);
    // Nothing is followed further than to that time.
    scene.duration_s = std::max(std::abs(at_s), std::numeric_limits<double>::min());
    scene.attitude = attitude_spec(scene);
    return scene;
  }

  const LessonScene& scene_;
  const LessonBodies& bodies_;
  const SceneWords& words_;
  TextReader& texts_;
  Report& report_;
  double at_s_ = 0;
  std::vector<Column> columns_;
  TextTable table_;
};

}  // namespace

RichText read_motion_table(const TomlTable& table, SourcePlace fence, const LessonScene& scene,
                           const LessonBodies& bodies, const SceneWords& words, TextReader& texts) {
  return MotionTableReader(scene, bodies, words, texts).read(table, fence);
}

}  // namespace polhode
