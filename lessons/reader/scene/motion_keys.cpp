// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/motion_keys.h"

#include "base/spelling.h"
#include "physics/method.h"

#include <utility>

namespace polhode {
namespace {

void read_method(const TomlEntry& entry, MotionSpec& motion, Report& report) {
  const auto name = read_text(entry, report);
  if (!name) return;
  if (const auto method = method_from(*name))
    motion.method = *method;
  else
    report_unknown("motion", {*name, entry.value.place}, method_names(), report);
}

/// A step and a tolerance each belong to methods of one kind.
void check_control(const TomlTable& table, const MotionSpec& motion, Report& report) {
  const StepControl control = motion.method ? facts_of(*motion.method).control : StepControl::adaptive;
  const std::string owner =
      motion.method ? in_quotes(name_of(*motion.method)) + " has none" : "and no method is named";
  if (motion.step_s && control != StepControl::fixed)
    report.error(table.find("step")->place, "a step is of methods with a fixed step, " + owner,
                 "write method = \"rk4\", or leave the step out");
  if (motion.tolerance && control != StepControl::adaptive)
    report.error(table.find("tolerance")->place, "a tolerance is of adaptive methods, " + owner,
                 "write method = \"dormand-prince-8\", or leave the tolerance out");
}

void check_step_given(const TomlEntry& entry, const MotionSpec& motion, Report& report) {
  const TomlTable* table = entry.value.as<TomlTable>();
  const bool given = table != nullptr && table->find("step") != nullptr;
  if (!motion.method || facts_of(*motion.method).control != StepControl::fixed || given) return;
  const std::string name = in_quotes(name_of(*motion.method));
  report.error(entry.value.place, name + " needs a step in seconds",
               "write motion = { method = " + name + ", step = 0.02 }");
}

}  // namespace

MotionSpec read_motion(const TomlEntry& entry, Report& report) {
  MotionSpec motion;
  if (const auto* table = entry.value.as<TomlTable>()) {
    read_keys(
        *table, "motion",
        {{"method", [&](const TomlEntry& e) { read_method(e, motion, report); }},
         {"step", [&](const TomlEntry& e) { motion.step_s = read_positive_number(e, report); }},
         {"tolerance", [&](const TomlEntry& e) { motion.tolerance = read_positive_number(e, report); }},
         {"ghost", [&](const TomlEntry& e) { motion.ghost = read_flag(e, report).value_or(motion.ghost); }}},
        report);
    check_control(*table, motion, report);
  } else {
    read_method(entry, motion, report);
  }
  check_step_given(entry, motion, report);
  return motion;
}

std::optional<ComparedMethods> read_compared(const TomlEntry& entry, Report& report) {
  static constexpr const char* kForm =
      "compare = { methods = [\"rk4\", \"splitting\"], against = \"evaluations\" }";
  const TomlTable* table = read_table(entry, kForm, report);
  if (table == nullptr) return std::nullopt;
  ComparedMethods compared;
  const auto against = [&](const TomlEntry& e) {
    const auto name = read_text(e, report);
    compared.by_evaluations = name == "evaluations";
    if (name && !compared.by_evaluations && *name != "steps")
      report.error(e.value.place, "unknown \"against\" " + in_quotes(*name),
                   "write \"evaluations\" or \"steps\"");
  };
  const auto methods = [&](const TomlEntry& e) {
    const auto names = read_texts(e, method_names().size(), report);
    for (const PlacedText& name : names.value_or(std::vector<PlacedText>())) {
      if (const auto method = method_from(name.text))
        compared.methods.push_back(*method);
      else
        report_unknown("method", name, method_names(), report);
    }
  };
  read_keys(*table, "\"compare\"", {{"methods", methods}, {"against", against}}, report);
  return compared;
}

}  // namespace polhode
