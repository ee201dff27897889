// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/steered_state.h"

#include "base/spelling.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/toml_text.h"
#include "lessons/reader/scene/scene_keys.h"
#include "lessons/reader/scene/scene_values.h"
#include "physics/body/torque_text.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

/// As TOML has it, in as many bytes, so that places stay: "w " for ω, brackets for (…), hyphens for other
/// signs of minus.
std::string plain(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kPlain[] = {
      {"\\omega", " omega"}, {"ω", "w "}, {"−", "  -"}, {"–", "  -"}};
  std::string made(text);
  for (const auto& [typed, meant] : kPlain)
    for (std::size_t at = made.find(typed); at != made.npos; at = made.find(typed, at + 1))
      made.replace(at, typed.size(), meant);
  if (made.find('"') != made.npos || made.find('\'') != made.npos) return made;  // what is quoted stays
  std::replace(made.begin(), made.end(), '(', '[');
  std::replace(made.begin(), made.end(), ')', ']');
  return made;
}

/// Parts behind a `;` begin a line of their own, as TOML has it. A `;` between quotes stays.
std::string on_lines(std::string_view text) {
  std::string lines = plain(text);
  char quote = 0;
  for (char& c : lines) {
    if (quote != 0) {
      if (c == quote || c == '\n') quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ';') {
      c = '\n';
    }
  }
  return lines;
}

constexpr const char* kForm = "write it as omega = [0.1, 3, 0.1]; t = 0.4";

/// Of a place in the lines, in the text as it was typed.
int column_of(SourcePlace place, const SourceText& lines, std::string_view text) {
  return SourceText(text).place_of(lines.offset_of(place)).column;
}

class StateReader {
 public:
  explicit StateReader(Report& report) : report_(report) {}

  std::optional<SteeredState> read(const TomlTable& table, std::string_view where) {
    read_keys(table, where,
              {{"omega", [this](const TomlEntry& e) { take(read_vector(e, report_), state_.w0_B); }},
               {"w", [this](const TomlEntry& e) { spin(e); }},
               {"moments", [this](const TomlEntry& e) { moments(e); }},
               {"attitude", [this](const TomlEntry& e) { attitude(e); }},
               {"torque", [this](const TomlEntry& e) { torque(e); }},
               {"t", [this](const TomlEntry& e) { take(read_number(e, report_), state_.t_s); }}},
              report_);
    const auto is_known = [](const TomlEntry& entry) {
      return entry.key == "w" ||
             std::any_of(kSteered.begin(), kSteered.end(),
                         [&](const SteeredFacts& facts) { return facts.name == entry.key; });
    };
    ok_ = ok_ && std::all_of(table.entries.begin(), table.entries.end(), is_known);
    return ok_ ? std::optional(std::move(state_)) : std::nullopt;
  }

 private:
  void fail(SourcePlace place, std::string message, std::string hint = {}) {
    report_.error(place, std::move(message), std::move(hint));
    ok_ = false;
  }

  template <class T>
  void take(std::optional<T> value, std::optional<T>& into) {
    ok_ = ok_ && value;
    into = std::move(value);
  }

  /// As who types ω has it (plain).
  void spin(const TomlEntry& entry) {
    if (state_.w0_B) return fail(entry.place, "ω is given twice");
    take(read_vector(entry, report_), state_.w0_B);
  }

  void moments(const TomlEntry& entry) {
    take(read_vector(entry, report_), state_.moments);
    if (!state_.moments) return;
    const Vec3& I = *state_.moments;
    if (auto why = why_impossible(I[0], I[1], I[2])) fail(entry.value.place, std::move(*why));
  }

  void attitude(const TomlEntry& entry) {
    if (const auto* name = entry.value.as<std::string>(); name && (*name == "L-up" || *name == "L-down")) {
      state_.attitude = *name == "L-up" ? LPoints::up : LPoints::down;
      return;
    }
    if (entry.value.as<std::string>() != nullptr)
      return fail(entry.value.place, "the attitude is \"L-up\", \"L-down\" or a quaternion",
                  "write attitude = [1, 0, 0, 0]");
    const auto wxyz = read_numbers(entry, 4, report_);
    if (wxyz && std::all_of(wxyz->begin(), wxyz->end(), [](double x) { return x == 0; }))
      return fail(entry.value.place, "the quaternion of an attitude must not be zero");
    ok_ = ok_ && wxyz;
    if (wxyz) state_.attitude = attitude_from(*wxyz);
  }

  void torque(const TomlEntry& entry) {
    const auto texts = read_texts(entry, 1, report_);
    ok_ = ok_ && texts;
    if (!texts) return;
    if (texts->empty())
      return fail(entry.value.place, "the torque is missing", "write torque = \"body:0,0,0\"");
    const Result<TorqueTerm> term = parse_torque_term(texts->front().text);
    if (!term) return fail(entry.value.place, "torque: " + term.error());
    if (!is_constant(*term))
      return fail(entry.value.place, "only a constant torque is steered",
                  "write \"body:0.1,0,0\" or \"space:0.1,0,0\"");
    state_.torque = *term;
  }

  Report& report_;
  SteeredState state_;
  bool ok_ = true;
};

}  // namespace

std::string words_of(const SteeredParts& parts) {
  std::string words;
  for (std::size_t i = 0; i < kSteered.size(); ++i)
    if (parts.contains(static_cast<Steered>(i)))
      words += (words.empty() ? "" : ", ") + std::string(kSteered[i].words.in(Language::en));
  return words;
}

SteeredParts SteeredState::parts() const {
  SteeredParts parts;
  if (w0_B) parts.insert(Steered::omega);
  if (moments) parts.insert(Steered::moments);
  if (attitude) parts.insert(Steered::attitude);
  if (torque) parts.insert(Steered::torque);
  if (t_s) parts.insert(Steered::t);
  return parts;
}

bool is_constant(const TorqueTerm& term) {
  return std::holds_alternative<SpaceTorque>(term) || std::holds_alternative<BodyTorque>(term);
}

TorqueTerm constant_torque(const Torque& torque) {
  const auto found = std::find_if(torque.begin(), torque.end(), is_constant);
  return found != torque.end() ? *found : TorqueTerm(BodyTorque{});
}

Torque with_constant(Torque torque, const TorqueTerm& constant) {
  const auto found = std::find_if(torque.begin(), torque.end(), is_constant);
  if (found != torque.end())
    *found = constant;
  else
    torque.push_back(constant);
  return torque;
}

const Vec3& components_of(const TorqueTerm& constant) {
  if (const auto* in_space = std::get_if<SpaceTorque>(&constant)) return in_space->N_S;
  return std::get<BodyTorque>(constant).N_B;
}

Scene steered(Scene scene, const SteeredState& state) {
  scene.beside.clear();
  scene.before = 0;
  scene.attitude = state.attitude.value_or(attitude_spec(scene));
  if (state.moments) {
    const Vec3& I = *state.moments;
    scene.body = Body{"own-body", PrincipalMoments(I[0], I[1], I[2]), std::nullopt};
  }
  if (state.w0_B) scene.w0_B = *state.w0_B;
  if (state.torque) scene.torque = with_constant(std::move(scene.torque), *state.torque);
  return scene;
}

std::optional<SteeredState> read_steered_state(const TomlTable& table, std::string_view where,
                                               Report& report) {
  return StateReader(report).read(table, where);
}

Result<SteeredState, UnreadableState> parse_state(std::string_view text) {
  const auto refuse = [](std::string message, std::string hint, int column = 0) {
    return Failure<UnreadableState>{{std::move(message), std::move(hint), column}};
  };
  if (text.size() > kMaxStateBytes)
    return refuse("a state is said in at most " + std::to_string(kMaxStateBytes) + " bytes", "");
  if (const auto wrong = why_not_text(text)) return refuse(wrong->message, wrong->hint);
  const std::string lines = on_lines(text);
  const SourceText source(lines);
  Report report(source, "");
  const auto table = parse_toml(lines, 1, report);
  const auto state = table ? read_steered_state(*table, "a state", report) : std::nullopt;
  const std::vector<Diagnostic> found = report.take();
  if (!state || !found.empty()) {
    if (!table || found.empty()) {  // what TOML would have is not what its author had in mind
      const SourcePlace place = found.empty() ? SourcePlace{1, 1} : found.front().place;
      return refuse("this is not written as a state", kForm, column_of(place, source, text));
    }
    const Diagnostic& first = found.front();
    return refuse(first.message, first.hint.empty() ? kForm : first.hint,
                  column_of(first.place, source, text));
  }
  if (state->parts().empty()) return refuse("this says nothing of the state", kForm);
  return *state;
}

std::string text_of(const SteeredState& state) {
  std::string text;
  const auto add = [&text](std::string_view name, const std::string& value) {
    text += (text.empty() ? "" : "; ") + std::string(name) + " = " + value;
  };
  if (state.w0_B) add("omega", toml(*state.w0_B));
  if (state.moments) add("moments", toml(*state.moments));
  if (state.attitude) add("attitude", text_of(*state.attitude));
  if (state.torque) {
    const std::string list = text_of(Torque{*state.torque});
    add("torque", list.substr(1, list.size() - 2));  // without its brackets: there is one
  }
  if (state.t_s) add("t", toml(*state.t_s));
  return text;
}

}  // namespace polhode
