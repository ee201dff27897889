// SPDX-License-Identifier: MIT
#include "lessons/reader/plot_keys.h"

#include "base/spelling.h"
#include "lessons/reader/toml_text.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

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
    if (plots.size() > kMaxPlots)
      report_.error(entry.value.place, in_quotes(entry.key) + " takes at most " + std::to_string(kMaxPlots) +
                                           " plots, found " + std::to_string(plots.size()));
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
    OwnPlot own;
    read_keys(table, "a plot", {{"plot", [&](const TomlEntry& e) { read_curves(e, own); }}}, report_);
    if (table.find("plot") == nullptr)
      report_.error(place, "this plot lacks \"plot\"", "for example { plot = [\"w1\", \"w2\"] }");
    if (!own.curves.empty()) plots.emplace_back(std::move(own));
  }

  void read_curves(const TomlEntry& entry, OwnPlot& own) {
    const auto list = read_texts(entry, kMaxCurves, report_);
    if (!list) return;
    if (list->empty()) report_.error(entry.value.place, "nothing is plotted", "for example [\"w1\", \"w2\"]");
    for (const PlacedText& text : *list) {
      auto read = read_quantity(text, words_, texts_);
      if (!read) continue;
      if (read->quantity.is_vector)
        report_.error(text.place, "a plot is of scalars, " + in_quotes(text.text) + " is a vector",
                      "plot its components: comp(a, 1)");
      else
        own.curves.push_back(std::move(read->quantity));
    }
  }

  const SceneWords& words_;
  TextReader& texts_;
  Report& report_;
};

std::string text_of(const OwnPlot& own) {
  std::vector<std::string> curves;
  for (const SceneQuantity& quantity : own.curves) curves.push_back(quantity.text);
  return "{ plot = " + toml_list(curves) + " }";
}

}  // namespace

std::optional<std::vector<PlotSpec>> read_plots(const TomlEntry& entry, const SceneWords& words,
                                                TextReader& texts) {
  return PlotReader(words, texts).read(entry);
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
