// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/keys.h"

#include "base/spelling.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr std::size_t kMaxIdBytes = 64;

void expected(std::string_view what, const TomlEntry& entry, const TomlValue& found, Report& report) {
  report.error(found.place,
               in_quotes(entry.key) + " takes " + std::string(what) + ", found " + std::string(found.kind()));
}

std::optional<double> finite_number(const TomlValue& value, const TomlEntry& entry, std::string_view what,
                                    Report& report) {
  if (const auto* integer = value.as<std::int64_t>()) return static_cast<double>(*integer);
  const auto* number = value.as<double>();
  if (number == nullptr) {
    expected(what, entry, value, report);
    return std::nullopt;
  }
  if (std::isfinite(*number)) return *number;
  report.error(value.place, in_quotes(entry.key) + " must be finite, found " +
                                (std::isnan(*number) ? "nan"
                                 : *number > 0       ? "inf"
                                                     : "-inf"));
  return std::nullopt;
}

}  // namespace

bool is_id(std::string_view text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  return !text.empty() && text.size() <= kMaxIdBytes && std::all_of(text.begin(), text.end(), allowed);
}

std::optional<std::string> read_text(const TomlEntry& entry, Report& report) {
  if (const auto* text = entry.value.as<std::string>()) return *text;
  expected("a string", entry, entry.value, report);
  return std::nullopt;
}

std::optional<bool> read_flag(const TomlEntry& entry, Report& report) {
  if (const auto* flag = entry.value.as<bool>()) return *flag;
  expected("true or false", entry, entry.value, report);
  return std::nullopt;
}

std::optional<double> read_number(const TomlEntry& entry, Report& report) {
  return finite_number(entry.value, entry, "a number", report);
}

std::optional<double> read_positive_number(const TomlEntry& entry, Report& report) {
  const auto number = read_number(entry, report);
  if (!number || *number > 0) return number;
  report.error(entry.value.place, in_quotes(entry.key) + " must be greater than 0");
  return std::nullopt;
}

std::optional<std::vector<double>> read_numbers(const TomlEntry& entry, std::size_t count, Report& report) {
  const std::string what = "a list of " + std::to_string(count) + " numbers";
  const auto* list = entry.value.as<TomlArray>();
  if (list == nullptr) {
    expected(what, entry, entry.value, report);
    return std::nullopt;
  }
  if (list->size() != count) {
    report.error(entry.value.place,
                 in_quotes(entry.key) + " takes " + what + ", found " + std::to_string(list->size()));
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const TomlValue& value : *list) {
    if (const auto number = finite_number(value, entry, what, report)) numbers.push_back(*number);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

std::optional<Vec3> read_vector(const TomlEntry& entry, Report& report) {
  const auto numbers = read_numbers(entry, 3, report);
  if (!numbers) return std::nullopt;
  return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

const TomlTable* read_table(const TomlEntry& entry, std::string_view form, Report& report) {
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr)
    report.error(entry.value.place,
                 in_quotes(entry.key) + " takes a table, found " + std::string(entry.value.kind()),
                 "write " + std::string(form));
  return table;
}

void report_unknown(std::string_view what, const PlacedText& name, const std::vector<std::string>& known,
                    Report& report) {
  report.error(name.place, "unknown " + std::string(what) + ' ' + in_quotes(name.text),
               suggestion(name.text, known));
}

std::optional<std::vector<PlacedText>> read_texts(const TomlEntry& entry, std::size_t max_count,
                                                  Report& report) {
  if (const auto* text = entry.value.as<std::string>())
    return std::vector{PlacedText{*text, entry.value.place}};
  const auto* list = entry.value.as<TomlArray>();
  if (list == nullptr) {
    expected("a string or a list of strings", entry, entry.value, report);
    return std::nullopt;
  }
  if (list->size() > max_count) {
    report.error(entry.value.place, in_quotes(entry.key) + " takes at most " + std::to_string(max_count) +
                                        " names, found " + std::to_string(list->size()));
    return std::nullopt;
  }
  std::vector<PlacedText> texts;
  for (const TomlValue& value : *list) {
    if (const auto* text = value.as<std::string>()) {
      texts.push_back({*text, value.place});
    } else {
      expected("a list of strings", entry, value, report);
    }
  }
  if (texts.size() != list->size()) return std::nullopt;
  return texts;
}

void read_keys(const TomlTable& table, std::string_view where, const std::vector<KeyHandler>& handlers,
               Report& report) {
  const auto read = [&](const TomlEntry& entry) {
    const auto handler = std::find_if(handlers.begin(), handlers.end(),
                                      [&entry](const KeyHandler& h) { return h.name == entry.key; });
    if (handler == handlers.end()) return false;
    handler->read(entry);
    return true;
  };
  const auto known = [&] {
    std::vector<std::string> names;
    for (const KeyHandler& h : handlers) names.push_back(h.name);
    return names;
  };
  read_keys(table, where, read, known, report);
}

void read_keys(const TomlTable& table, std::string_view where,
               const std::function<bool(const TomlEntry&)>& read,
               const std::function<std::vector<std::string>()>& known, Report& report) {
  for (const TomlEntry& entry : table.entries)
    if (!read(entry))
      report.error(entry.place, "unknown key " + in_quotes(entry.key) + " in " + std::string(where),
                   suggestion(entry.key, known()));
}

}  // namespace polhode
