// SPDX-License-Identifier: MIT
// Fences of scenes, and of tables, whose rows change a scene.
#include "base/spelling.h"
#include "lessons/reader/scene/motion_table.h"
#include "lessons/reader/scene/varied_scene.h"
#include "lessons/reader/stage_builder.h"
#include "render/scene/model/scene_needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace polhode {

void StageBuilder::add_scene(const Fence& fence) {
  if (step_has_scene_) {
    report_.error(fence.place, "this step has a scene already", "start a new step with --- first");
    return;
  }
  has_scene_ = step_has_scene_ = true;
  scene_line_ = fence.place.line;
  const auto table = parse_toml(source_.lines(fence.first_line, fence.last_line), fence.first_line, report_);
  if (!table) return;
  scene_.same.clear();
  scene_.from.clear();
  std::vector<PlacedText> names =
      read_scene_keys(*table, front_.bodies, front_.words(), scene_, texts_, fence.place);
  std::move(names.begin(), names.end(), std::back_inserter(highlighted_));
  std::vector<LessonScene> shown = side_by_side(scene_, front_.bodies, front_.words(), texts_, highlighted_);
  for (std::size_t i = 0; i < std::min(shown.size(), shown_.size()); ++i)  // steps share what stays
    if (shown[i].scene.caption == shown_[i].scene.caption) shown[i].caption = shown_[i].caption;
  warn_of_hidden_caption(*table, shown);
  shown_ = std::move(shown);
  vary_scene();
}

/// The caption that scenes side by side have in common stands below those without one of their own.
void StageBuilder::warn_of_hidden_caption(const TomlTable& table, const std::vector<LessonScene>& shown) {
  const TomlEntry* entry = table.find("caption");
  if (entry == nullptr || !scene_.scenes || scene_.scene.caption.empty()) return;
  const auto is_own = [&](const LessonScene& one) { return one.scene.caption != scene_.scene.caption; };
  if (std::all_of(shown.begin(), shown.end(), is_own))
    report_.warning(entry->place, "this caption is not shown: each of the scenes has one of its own",
                    "leave it out, or those of the scenes");
}

/// What `vary` asks for, where the scene has such numbers and all can be as far as their ranges go.
void StageBuilder::vary_scene() {
  varied_.reset();
  std::vector<Variation>& numbers = scene_.scene.vary;
  if (numbers.empty() || scene_.fault_said) return;
  const std::vector<SourcePlace>& places = scene_.vary_places;
  if (scene_.scenes) {
    report_.error(places.front(), "a scene is varied, or has others beside it, not both",
                  "write scenes = [] or vary = {}");
    return;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Variation& number = numbers[i];
    const auto value = number_of(scene_, front_.bodies, number.number);
    if (!value) {
      report_.error(places[i], in_quotes(number.number) + " cannot be varied: " + value.error().message,
                    value.error().hint);
      return;
    }
    number.value = *value;
    if (number.from <= number.value && number.value <= number.to) continue;
    report_.error(places[i], fmt::format("{} is {:.7g} in this scene, beyond its range from {:.7g} to {:.7g}",
                                         in_quotes(number.number), number.value, number.from, number.to));
    return;
  }
  auto varied = std::make_shared<const VariedScene>(scene_, front_.bodies);
  if (check_ends(*varied)) varied_ = std::move(varied);
}

/// False, and a report, if a scene cannot be at a corner of the ranges.
bool StageBuilder::check_ends(const VariedScene& varied) {
  const std::vector<Variation>& numbers = scene_.scene.vary;
  for (unsigned corner = 0; corner < 1U << numbers.size(); ++corner) {
    std::vector<double> values;
    std::string named;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      values.push_back((corner >> i & 1U) != 0 ? numbers[i].to : numbers[i].from);
      named += fmt::format("{}{} = {:.7g}", i > 0 ? ", " : "", numbers[i].number, values.back());
    }
    const auto scene = varied.at(values);
    if (scene) continue;
    report_.error(scene_.vary_places.front(),
                  fmt::format("at {} there is no such scene: {}", named, scene.error()),
                  "make the range smaller");
    return false;
  }
  if (const auto strip = varied.strip(); !strip) {
    report_.error(scene_.vary_places.front(), strip.error(), "make the range smaller");
    return false;
  }
  return true;
}

void StageBuilder::add_table(const Fence& fence) {
  const std::string_view text = source_.lines(fence.first_line, fence.last_line);
  auto keys = parse_toml(text, fence.first_line, report_);
  if (!keys) return;
  tables_.push_back({std::move(*keys), step().blocks.size()});
  step().blocks.push_back(Prose{std::string(text), {}, fence.place});
}

void StageBuilder::read_tables() {
  for (const WaitingTable& waiting : tables_) {
    auto& table = std::get<Prose>(step().blocks[waiting.block]);
    if (!has_scene_) {
      report_.error(table.place, "the numbers of a table need a scene, which its rows change",
                    "add a ```scene fence to this step or above it");
      continue;
    }
    table.text =
        read_motion_table(waiting.keys, table.place, shown_.front(), front_.bodies, front_.words(), texts_);
    for (const TextBlock& block : table.text)
      parts_ += static_cast<int>(block.table.rows.size() * block.table.columns.size());
  }
  tables_.clear();
}

void StageBuilder::check_shown() {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    Scene scene = i == 0 ? *step().scene : step().scene->beside[i - 1];
    scene.language = Language::en;  // as all diagnostics are
    for (const PlacedText& name : shown_[i].shown)
      if (const std::string unseen = what_is_unseen(*overlay_from(name.text), scene); !unseen.empty())
        report_.warning(name.place, "in the scene of line " + std::to_string(scene_line_) + ' ' +
                                        in_quotes(name.text) + ' ' + unseen);
  }
}

}  // namespace polhode
