// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/outcome_key.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace polhode {

std::optional<std::vector<int>> read_outcomes(const TomlEntry& entry, std::size_t count, Report& report) {
  const auto refuse = [&](SourcePlace place, std::string message, std::string hint) {
    report.error(place, std::move(message), std::move(hint));
    return std::nullopt;
  };
  if (count == 0)
    return refuse(entry.place, "the lesson names no outcomes",
                  "list them in the front matter: outcomes = [\"…\"]");
  std::vector<const TomlValue*> values{&entry.value};
  if (const auto* list = entry.value.as<TomlArray>()) {
    values.clear();
    for (const TomlValue& value : *list) values.push_back(&value);
  }
  if (values.empty()) return refuse(entry.value.place, "no outcome is named", "leave the key out");
  std::vector<int> outcomes;
  for (const TomlValue* value : values) {
    const auto* number = value->as<std::int64_t>();
    if (number == nullptr || *number < 1 || *number > static_cast<std::int64_t>(count))
      return refuse(value->place,
                    "an outcome is the number of one in the front matter, 1 to " + std::to_string(count),
                    "outcome = 1, or outcome = [1, 2]");
    if (std::find(outcomes.begin(), outcomes.end(), *number) != outcomes.end())
      return refuse(value->place, "outcome " + std::to_string(*number) + " twice", "name it once");
    outcomes.push_back(static_cast<int>(*number));
  }
  std::sort(outcomes.begin(), outcomes.end());
  return outcomes;
}

}  // namespace polhode
