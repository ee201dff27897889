// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/plot_keys.h"

#include "base/numbers.h"
#include "base/spelling.h"
#include "base/utf8.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/expressions/scene_quantities.h"
#include "lessons/claims/motion_words.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/toml_text.h"
#include "lessons/reader/scene/mark_keys.h"
#include "render/typeset/math/tree.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

constexpr int kMaxTitleCharacters = 48;
constexpr const char* kExample =
    "for example { plot = [\"w1\", \"w2\"] }, or { curve = \"x^2\", x = { of = \"w1\", from = -1, to = 1 } }";

class PlotReader {
 public:
  PlotReader(const SceneWords& words, TextReader& texts)
      : words_(words), texts_(texts), report_(texts.report()) {}

  std::optional<std::vector<PlotSpec>> read(const TomlEntry& entry) {
    const auto* list = entry.value.as<TomlArray>();
    const TomlArray alone{entry.value};
    if (list == nullptr && entry.value.as<std::string>() == nullptr &&
        entry.value.as<TomlTable>() == nullptr) {
      report_.error(entry.value.place, in_quotes(entry.key) + " takes a list of plots, found " +
                                           std::string(entry.value.kind()));
      return std::nullopt;
    }
    if (list != nullptr && list->size() > kMaxPlots) {
      report_.error(entry.value.place, in_quotes(entry.key) + " takes at most " + std::to_string(kMaxPlots) +
                                           " plots, found " + std::to_string(list->size()));
      return std::nullopt;
    }
    std::vector<PlotSpec> plots;
    for (const TomlValue& value : list != nullptr ? *list : alone) {
      if (const auto* name = value.as<std::string>())
        add_named({*name, value.place}, plots);
      else if (const auto* table = value.as<TomlTable>())
        add_own(value.place, *table, plots);
      else
        report_.error(value.place, "a plot is a name or a table, found " + std::string(value.kind()),
                      "for example \"energy\", or { plot = [\"w1\", \"w2\"] }");
    }
    return plots;
  }

 private:
  void add_named(const PlacedText& name, std::vector<PlotSpec>& plots) {
    const auto meter = meter_from(name.text);
    if (!meter)
      report_.error(name.place, "unknown meter " + in_quotes(name.text),
                    suggestion(name.text, meter_names()));
    else if (std::find(plots.begin(), plots.end(), PlotSpec(*meter)) != plots.end())
      report_.warning(name.place, "the meter " + in_quotes(name.text) + " is there already");
    else
      plots.emplace_back(*meter);
  }

  void add_own(SourcePlace place, const TomlTable& table, std::vector<PlotSpec>& plots) {
    const TomlEntry *plot = table.find("plot"), *curve = table.find("curve");
    if ((plot == nullptr) == (curve == nullptr)) {
      report_.error(place,
                    plot == nullptr ? "a plot has \"plot\" or \"curve\", this one has neither"
                                    : "a plot has \"plot\" or \"curve\", not both",
                    kExample);
      return;
    }
    OwnPlot own;
    Measure y, x;
    curves_.clear();
    if (plot != nullptr) y = read_curves(*plot, own);
    if (curve != nullptr) y = read_function(*curve, table, own, x);
    if (const TomlEntry* against = table.find("against"); against != nullptr && plot != nullptr)
      x = read_against(*against, own);
    const auto done = [](const TomlEntry&) {};
    std::vector<KeyHandler> keys{{"title", [&](const TomlEntry& e) { read_title(e, own); }},
                                 {"tex", [&](const TomlEntry& e) { read_tex(e, own); }},
                                 {"range", [&](const TomlEntry& e) { read_range(e, own); }},
                                 {"scale", [&](const TomlEntry& e) { read_scale(e, own); }},
                                 {"unit", [&](const TomlEntry& e) {
                                    read_unit(e, {y, curves_}, own.y);
                                  }}};
    for (const char* key : {"plot", "against"})
      if (plot != nullptr) keys.push_back({key, done});
    for (const char* key : {"curve", "x", "var", "level"})
      if (curve != nullptr) keys.push_back({key, done});
    read_keys(table, plot != nullptr ? "a plot of quantities" : "a plot of a function", keys, report_);
    if (own.curves.empty() && !own.function) return;  // it was said why
    own.is_scaled_alike = own.against && y == x && own.y == own.x && !own.is_log;
    if (own.is_log && own.range && !(own.range->first > 0.0))
      report_.error(table.find("range")->value.place,
                    "a logarithmic scale begins above 0, not at " + digits(own.range->first, 6),
                    "write range = [1e-6, 1], or leave it out");
    plots.emplace_back(std::move(own));
  }

  using Measure = std::optional<Dimension>;

  /// A scalar.
  std::optional<ReadQuantity> read_scalar(const PlacedText& text) {
    auto read = read_quantity(text, words_, texts_);
    if (!read || !read->quantity.is_vector) return read;
    const std::string component = "comp(" + text.text + ", 1)";
    report_.error(text.place, "a plot is of scalars, " + in_quotes(text.text) + " is a vector",
                  "plot a component, " + in_quotes(component) + " on the axes of the body, or its length, " +
                      in_quotes("norm(" + text.text + ")"));
    return std::nullopt;
  }

  /// The quantities of a plot, and what they are measured in.
  Measure read_curves(const TomlEntry& entry, OwnPlot& own) {
    const auto list = read_texts(entry, kMaxCurves, report_);
    if (!list) return {};
    if (list->empty())
      report_.error(entry.value.place, "nothing is plotted", "for example plot = [\"w1\", \"w2\"]");
    Measure common;
    for (const PlacedText& text : *list) {
      auto read = read_scalar(text);
      if (!read) continue;
      if (common && read->dimension && *common != *read->dimension) {
        report_.error(
            text.place,
            "units disagree: " + to_string(*common) + " and " + to_string(*read->dimension) + " on one axis",
            "give " + in_quotes(text.text) + " a plot of its own");
        continue;
      }
      if (!common) {
        common = read->dimension;
        own.y = {read->quantity.unit, 1};
      }
      curves_.push_back(read->expression);
      own.curves.push_back(std::move(read->quantity));
    }
    return common;
  }

  /// "w1", or { of = "w1", unit = "deg/s" }.
  Measure read_against(const TomlEntry& entry, OwnPlot& own) {
    if (const auto* name = entry.value.as<std::string>()) {
      auto read = read_scalar({*name, entry.value.place});
      if (!read) return {};
      own.x = {read->quantity.unit, 1};
      own.against = std::move(read->quantity);
      return read->dimension;
    }
    const auto* table = entry.value.as<TomlTable>();
    if (table == nullptr) {
      report_.error(entry.value.place,
                    "\"against\" takes a string or a table, found " + std::string(entry.value.kind()),
                    "for example against = \"w1\", or { of = \"w1\", unit = \"deg/s\" }");
      return {};
    }
    auto read = read_of(entry, *table, own.x);
    read_keys(*table, in_quotes("against"), {{"of", was_read}, {"unit", was_read}}, report_);
    if (!read) return {};
    own.against = std::move(read->quantity);
    return read->dimension;
  }

  /// The keys `of` and `unit`.
  std::optional<ReadQuantity> read_of(const TomlEntry& entry, const TomlTable& table, PlotUnit& unit) {
    const TomlEntry* of = table.find("of");
    if (of == nullptr) {
      report_.error(entry.value.place, in_quotes(entry.key) + " lacks \"of\", the quantity on this axis");
      return std::nullopt;
    }
    const auto text = read_text(*of, report_);
    auto read = text ? read_scalar({*text, of->value.place}) : std::nullopt;
    if (!read) return std::nullopt;
    unit = {read->quantity.unit, 1};
    if (const TomlEntry* own = table.find("unit"))
      read_unit(*own, {read->dimension, {read->expression}}, unit);
    return read;
  }

  static void was_read(const TomlEntry&) {}

  /// A function of the variable `x`, for which the expression has a word of its own.
  Measure read_function(const TomlEntry& entry, const TomlTable& table, OwnPlot& own, Measure& x) {
    PlotFunction function;
    function.variable = "x";
    if (const TomlEntry* var = table.find("var")) {
      if (const auto name = read_text(*var, report_)) function.variable = *name;
    }
    const bool has_x = read_axis(entry, table, function, own, x);
    auto words = words_with(function, table, entry);
    const auto text = read_text(entry, report_);
    if (!has_x || !words || !text) return {};

    std::map<int, Dimension> dimensions;
    if (words_.dimensions != nullptr) dimensions = *words_.dimensions;
    const int variable = static_cast<int>(words->constants()->size()) - 1;
    if (x) dimensions[variable] = *x;
    const SourcePlace place =
        texts_.source().place_of(located_string(texts_.source(), entry.value.place, *text).offset_of(0));
    auto read = read_with_dimension({*text, entry.value.place}, place, *words, dimensions);
    if (!read) return {};
    auto& [expression, dimension] = *read;
    if (expression.type() == ExpressionType::vector) {
      report_.error(place, "a plot is of scalars, " + in_quotes(*text) + " is a vector");
      return {};
    }
    const auto speaks = [&](const ExpressionNode& node) {
      return node.operation == Operation::constant && node.integer == variable;
    };
    if (std::none_of(expression.nodes.begin(), expression.nodes.end(), speaks)) {
      report_.error(place, "this does not depend on " + in_quotes(function.variable),
                    "write it in the word for the variable, or say with var = \"…\" which word that is");
      return {};
    }
    own.y = {dimension ? usual_unit(*dimension) : "", 1};
    function.text = *text;
    function.tex = tex_of(expression, &*words);
    auto made = function_of_constant(std::move(expression), variable);
    function.fingerprint = std::move(made.fingerprint);
    function.values = std::move(made.values);
    if (const TomlEntry* level = table.find("level")) read_level(*level, dimension, function, own);
    own.function = std::move(function);
    return dimension;
  }

  /// x = { of = "u", from = -1, to = 1 }, the ends in its unit.
  bool read_axis(const TomlEntry& entry, const TomlTable& table, PlotFunction& function, OwnPlot& own,
                 Measure& dimension) {
    constexpr const char* kForm = "for example x = { of = \"u\", from = -1, to = 1 }";
    const TomlEntry* axis = table.find("x");
    if (axis == nullptr) {
      report_.error(entry.place, "a curve needs an axis \"x\"", kForm);
      return false;
    }
    const auto* keys = axis->value.as<TomlTable>();
    if (keys == nullptr) {
      report_.error(axis->value.place, "\"x\" takes a table, found " + std::string(axis->value.kind()),
                    kForm);
      return false;
    }
    auto of = read_of(*axis, *keys, own.x);
    std::optional<double> from, to;
    read_keys(*keys, in_quotes("x"),
              {{"of", was_read},
               {"unit", was_read},
               {"from", [&](const TomlEntry& e) { from = read_number(e, report_); }},
               {"to", [&](const TomlEntry& e) { to = read_number(e, report_); }}},
              report_);
    for (const char* key : {"from", "to"})
      if (keys->find(key) == nullptr)
        report_.error(axis->value.place, "\"x\" lacks " + in_quotes(key), kForm);
    if (!of || !from || !to) return false;
    if (!(*from < *to)) {
      report_.error(keys->find("to")->value.place, "\"to\" must be greater than \"from\"");
      return false;
    }
    function.from = *from / own.x.per_si;
    function.to = *to / own.x.per_si;
    dimension = of->dimension;
    function.of = std::move(of->quantity);
    return true;
  }

  /// The lesson's words and the variable, which is printed as what it stands for where that has a name.
  std::optional<Vocabulary> words_with(const PlotFunction& function, const TomlTable& table,
                                       const TomlEntry& entry) {
    const TomlEntry* var = table.find("var");
    const SourcePlace place = var != nullptr ? var->value.place : entry.value.place;
    Vocabulary words = words_.vocabulary != nullptr ? *words_.vocabulary : Vocabulary();
    std::string why = why_no_word(function.variable);
    if (why.empty() && words.find(function.variable) != nullptr) why = "the lesson has this word already";
    if (!why.empty()) {
      report_.error(place, "no word for a variable " + in_quotes(function.variable) + ": " + why,
                    "choose another: var = \"s\"");
      return std::nullopt;
    }
    if (words.constants() && words.constants()->size() >= kMaxConstants) {
      report_.error(place, "a variable takes the place of a constant, and the lesson has all " +
                               std::to_string(kMaxConstants) + " of them");
      return std::nullopt;
    }
    const auto* named = words.find(function.of.text);
    words.add_constant(function.variable, 0, named != nullptr ? named->tex : function.variable);
    return words;
  }

  struct Typed {
    Expression expression;
    Measure dimension;
  };
  std::optional<Typed> read_with_dimension(const PlacedText& text, SourcePlace place, const Vocabulary& words,
                                           const std::map<int, Dimension>& dimensions) {
    auto expression = read_expression(text.text, place, report_, &words);
    if (!expression) return std::nullopt;
    if (!has_value_on_motions(*expression, place, report_)) return std::nullopt;
    const DimensionReading reading = dimension_of(*expression, dimensions);
    if (reading.fault) {
      report_.error(advanced(place, text.text, reading.fault->begin), reading.fault->message);
      return std::nullopt;
    }
    return Typed{std::move(*expression), reading.dimension};
  }

  void read_level(const TomlEntry& entry, const Measure& dimension, PlotFunction& function, OwnPlot& own) {
    const auto text = read_text(entry, report_);
    auto read = text ? read_scalar({*text, entry.value.place}) : std::nullopt;
    if (!read) return;
    if (dimension && read->dimension && *dimension != *read->dimension) {
      report_.error(entry.value.place, "units disagree: the curve is in " + to_string(*dimension) +
                                           ", its level in " + to_string(*read->dimension));
      return;
    }
    if (!read->quantity.unit.empty()) own.y = {read->quantity.unit, 1};
    function.level = std::move(read->quantity);
  }

  void read_title(const TomlEntry& entry, OwnPlot& own) {
    const auto text = read_text(entry, report_);
    if (!text) return;
    if (!is_plain_line(*text) || is_blank(*text)) {
      report_.error(entry.value.place, "a title is one line of text without control characters");
    } else if (count_characters(*text) > kMaxTitleCharacters) {
      report_.error(entry.value.place, "the title of a plot has at most " +
                                           std::to_string(kMaxTitleCharacters) + " characters, found " +
                                           std::to_string(count_characters(*text)));
    } else {
      const RichText title = texts_.caption(located_string(texts_.source(), entry.value.place, *text));
      for_each_span(title, [&](const TextSpan& span) {
        if (!span.math.live.empty()) report_.error(entry.value.place, std::string(kNoNumbersHere));
      });
      own.title = *text;
    }
  }

  /// One for each curve.
  void read_tex(const TomlEntry& entry, OwnPlot& own) {
    const auto list = read_texts(entry, kMaxCurves, report_);
    if (!list) return;
    const std::size_t curves = own.function ? 1 : own.curves.size();
    if (list->size() != curves && curves > 0)
      report_.error(entry.value.place, "\"tex\" names each curve: there are " + std::to_string(curves) +
                                           ", and " + std::to_string(list->size()) + " names");
    for (const PlacedText& name : *list) {
      const LocatedText located = located_string(texts_.source(), name.place, name.text);
      const auto formula = texts_.formula(located);
      if (!formula) continue;
      if (!formula->live.empty()) report_.error(name.place, std::string(kNoNumbersHere));
      if (!parse_math(name.text))
        report_.error(name.place, "macros cannot be used in the names of curves", "write them out");
      own.tex.push_back(name.text);
    }
  }

  void read_range(const TomlEntry& entry, OwnPlot& own) {
    if (const auto* name = entry.value.as<std::string>()) {
      own.is_tight = *name == "tight";
      if (!own.is_tight)
        report_.error(entry.value.place, "unknown range " + in_quotes(*name),
                      "write \"tight\", or [lowest, highest]");
      return;
    }
    const auto ends = read_numbers(entry, 2, report_);
    if (!ends) return;
    if ((*ends)[0] < (*ends)[1])
      own.range = std::pair((*ends)[0], (*ends)[1]);
    else
      report_.error(entry.value.place, "a range is [lowest, highest], and the second is not greater");
  }

  void read_scale(const TomlEntry& entry, OwnPlot& own) {
    const auto name = read_text(entry, report_);
    if (!name) return;
    own.is_log = *name == "log";
    if (!own.is_log)
      report_.error(entry.value.place, "unknown scale " + in_quotes(*name),
                    "write \"log\", or leave it out: it is linear");
  }

  struct Measured {
    Measure dimension;
    std::vector<Expression> quantities;
  };

  void read_unit(const TomlEntry& entry, const Measured& of, PlotUnit& unit) {
    const auto text = read_text(entry, report_);
    if (!text) return;
    const auto scaled = scaled_unit(*text);
    for (const Expression& quantity : of.quantities)
      if (const std::string why = why_not_in(quantity, *text); scaled && !why.empty())
        return report_.error(entry.value.place, why);
    if (!scaled)
      report_.error(entry.value.place, "unknown unit " + in_quotes(*text),
                    "units are kg g m s N J W Hz rad deg, with powers and prefixes: \"mJ\", \"deg/s\"");
    else if (of.dimension && scaled->dimension != *of.dimension)
      report_.error(entry.value.place, "units disagree: this is in " + to_string(*of.dimension) +
                                           ", not in " + in_quotes(*text));
    else
      unit = {*text == "1" ? "" : *text, 1 / scaled->size};
  }

  std::vector<Expression> curves_;  ///< of the plot that is read
  const SceneWords& words_;
  TextReader& texts_;
  Report& report_;
};

/// Lists of TeX: backslashes stay as they are between single quotes.
std::string toml_texts(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml(text);
  return '[' + list + ']';
}

/// What unit a plot has that says none.
std::string usual_unit_of(const OwnPlot& own) {
  if (!own.function) return own.curves.front().unit;
  return own.function->level ? own.function->level->unit : "";
}

/// "w1", or with a unit that it has not by itself.
std::string axis_text(const SceneQuantity& of, const PlotUnit& unit, const std::string& more) {
  const std::string own_unit = unit == PlotUnit{of.unit, 1} ? "" : ", unit = " + toml(unit.unit);
  if (own_unit.empty() && more.empty()) return toml(of.text);
  return "{ of = " + toml(of.text) + own_unit + more + " }";
}

std::string text_of(const OwnPlot& own) {
  std::string text;
  if (own.function) {
    const PlotFunction& f = *own.function;
    text = "{ curve = " + toml(f.text);
    if (f.variable != "x") text += ", var = " + toml(f.variable);
    const std::string ends =
        ", from = " + toml(f.from * own.x.per_si) + ", to = " + toml(f.to * own.x.per_si);
    text += ", x = " + axis_text(f.of, own.x, ends);
    if (f.level) text += ", level = " + toml(f.level->text);
  } else {
    std::vector<std::string> curves;
    for (const SceneQuantity& quantity : own.curves) curves.push_back(quantity.text);
    text = "{ plot = " + toml_texts(curves);
    if (own.against) text += ", against = " + axis_text(*own.against, own.x, "");
  }
  if (!own.tex.empty()) text += ", tex = " + toml_texts(own.tex);
  if (own.y.unit != usual_unit_of(own) || own.y.per_si != 1)
    text += ", unit = " + toml(own.y.unit.empty() ? std::string("1") : own.y.unit);
  if (own.is_tight) text += ", range = \"tight\"";
  if (own.is_log) text += ", scale = \"log\"";
  if (own.range) text += ", range = " + toml(std::vector<double>{own.range->first, own.range->second});
  if (!own.title.empty()) text += ", title = " + toml(own.title);
  return text + " }";
}

}  // namespace

std::optional<std::vector<PlotSpec>> read_plots(const TomlEntry& entry, const SceneWords& words,
                                                TextReader& texts) {
  return PlotReader(words, texts).read(entry);
}

int parts_of(const std::vector<PlotSpec>& plots) {
  constexpr std::size_t kBytesOfPart = 128;
  const auto bytes_of = [](const SceneQuantity& quantity) {
    return sizeof(SceneQuantity) + quantity.text.size() + quantity.tex.size() + quantity.fingerprint.size();
  };
  std::size_t bytes = 0;
  for (const PlotSpec& plot : plots) {
    const auto* own = std::get_if<OwnPlot>(&plot);
    if (own == nullptr) continue;
    bytes += sizeof *own;
    for (const SceneQuantity& quantity : own->curves) bytes += bytes_of(quantity);
    for (const std::string& tex : own->tex) bytes += sizeof tex + tex.size();
    if (own->against) bytes += own->against->text.size() + own->against->tex.size();
    if (!own->function) continue;
    const PlotFunction& f = *own->function;
    bytes += f.text.size() + f.tex.size() + bytes_of(f.of) + (f.level ? bytes_of(*f.level) : 0);
  }
  return static_cast<int>(bytes / kBytesOfPart);
}

std::string plots_text(const std::vector<PlotSpec>& plots) {
  std::string text;
  for (const PlotSpec& plot : plots) {
    const auto* meter = std::get_if<Meter>(&plot);
    text += (text.empty() ? "[" : ", ") +
            (meter ? toml(std::string(name_of(*meter)).c_str()) : text_of(std::get<OwnPlot>(plot)));
  }
  return text.empty() ? "[]" : text + ']';
}

}  // namespace polhode
