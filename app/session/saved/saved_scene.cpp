// SPDX-License-Identifier: MIT
#include "app/session/saved/saved_scene.h"

#include "app/export/trace/trace_rows.h"
#include "lessons/reader/front_matter/front_matter.h"
#include "lessons/reader/front_matter/toml_text.h"
#include "lessons/reader/markdown/markdown.h"
#include "physics/analysis/motion_errors.h"
#include "physics/body/pivot.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace polhode {

namespace {

// The front matter.

std::string key_of(const std::string& name) { return is_id(name) ? name : toml(name); }

/// "tex = 'E', say = \"energy\""
std::string looks_of(const Symbol& symbol) {
  std::string keys = "tex = " + toml(symbol.tex);
  if (!symbol.role.empty()) keys += ", role = " + toml(symbol.role);
  if (!symbol.say.empty()) keys += ", say = " + toml(symbol.say);
  if (!symbol.unit.empty()) keys += ", unit = " + toml(symbol.unit);
  if (!symbol.note.empty()) keys += ", note = " + toml(symbol.note);
  return keys;
}

/// Constants, definitions in their order, other symbols, and what can be assumed.
std::string symbols_of(const Lesson& lesson) {
  const Vocabulary& vocabulary = lesson.notation.vocabulary;
  std::string constants, definitions, symbols, assumptions;
  for (const Vocabulary::Word& word : vocabulary.words()) {
    const auto found = lesson.symbols.find(word.name);
    const std::string looks = found == lesson.symbols.end() ? "" : ", " + looks_of(found->second);
    if (const auto constant = word.constant())
      constants += fmt::format("{} = {{ value = {}{} }}\n", key_of(word.name), toml(constant->second), looks);
    else
      definitions +=
          fmt::format("{} = {{ means = {}{} }}\n", key_of(word.name), toml(word.means.text), looks);
  }
  for (const auto& [name, symbol] : lesson.symbols) {
    if (vocabulary.find(name) != nullptr) continue;
    const std::string means = symbol.means.empty() ? "" : ", means = " + toml(symbol.means);
    symbols += fmt::format("{} = {{ {}{} }}\n", key_of(name), looks_of(symbol), means);
  }
  for (const auto& [name, given] : lesson.assumptions) {
    std::string texts;
    const auto add = [&texts](const std::string& text) { texts += (texts.empty() ? "" : ", ") + toml(text); };
    for (const Setting& setting : given.settings) add(setting.text);
    for (const Bound& bound : given.bounds) add(bound.text);
    for (const std::string_view small : given.small.names()) add(std::string(small));
    assumptions += given.small.empty() ? fmt::format("{} = [{}]\n", key_of(name), texts)
                                       : fmt::format("{} = {{ small = [{}], order = {} }}\n", key_of(name),
                                                     texts, given.small.order);
  }
  const auto table = [](const char* name, const std::string& lines) {
    return lines.empty() ? "" : fmt::format("\n[{}]\n{}", name, lines);
  };
  return table("constants", constants) + table("define", definitions) + table("symbols", symbols) +
         table("assume", assumptions);
}

std::string macros_of(const Lesson& lesson) {
  std::string lines;
  for (const auto& [name, macro] : lesson.macros)
    lines += macro.arguments == 0 ? fmt::format("{} = {}\n", name, toml(macro.body))
                                  : fmt::format("{} = {{ arguments = {}, tex = {} }}\n", name,
                                                macro.arguments, toml(macro.body));
  return lines.empty() ? "" : "\n[macros]\n" + lines;
}

/// What is saved is a stage of the lesson, up to a step: what its links lead to elsewhere in the lesson is in
/// another lesson now, and links without a text, which show a title or a number, have it as their text.
std::string with_links_out(std::string text, const LessonSession& session) {
  const Lesson& lesson = session.lesson();
  const Stage& here = session.stage();
  constexpr std::string_view kOpening = "](#";
  for (std::size_t at = text.find(kOpening); at != text.npos; at = text.find(kOpening, at + 1)) {
    const std::size_t begin = at + kOpening.size(), end = std::min(text.find(')', begin), text.size());
    const std::string id = text.substr(begin, end - begin);
    const auto place = target_of(lesson, lesson.find_stage(id.substr(0, id.find('/'))) != nullptr
                                             ? '#' + id
                                             : '#' + here.id + '/' + id);
    if (!place) continue;
    const Stage& stage = lesson.stages[place->stage];
    if (&stage == &here && place->step <= session.place().step) continue;
    const std::string equation =
        &stage == &here && id.find('/') == id.npos ? '/' + id : id.substr(std::min(id.find('/'), id.size()));
    std::string shown = text[at - 1] != '[' ? "" : stage.title;
    if (!shown.empty() && !equation.empty())
      for (const Equation* one : equations_of(stage))
        if ('/' + one->id == equation) shown = '(' + one->tag + ')';
    text.replace(at, end - at, fmt::format("{}]({}#{}{}", shown, lesson.id, stage.id, equation));
    at += shown.size();
  }
  return text;
}

/// Whether a text has a citation of this key: [cite: KEY], [cite: KEY, ch. 4].
bool cites(const std::string& text, const std::string& key) {
  const std::string opening = "[cite: " + key;
  for (std::size_t at = text.find(opening); at != text.npos; at = text.find(opening, at + 1)) {
    const std::size_t end = at + opening.size();
    if (end < text.size() && (text[end] == ']' || text[end] == ',')) return true;
  }
  return false;
}

/// The sources that a text cites.
std::string references_of(const Lesson& lesson, const std::string& text) {
  std::string lines;
  for (const Reference& reference : lesson.references)
    if (cites(text, reference.key))
      lines += fmt::format("{} = {}\n", key_of(reference.key), toml(reference.text));
  return lines.empty() ? "" : "\n[references]\n" + lines;
}

// The stage.

/// What is saved has its still at the present t.
void leave_out_captions_of_other_stills(Scene& scene, double t_s) {
  for (Scene& other : scene.beside) leave_out_captions_of_other_stills(other, t_s);
  if (!caption_holds(scene, t_s)) leave_out_caption(scene);
}

/// A motion that a hand has made may not reach the lesson's `at`, and who opens what is saved would be
/// refused: then `at` is the present t.
void bring_at_within_reach(const SceneModel& model, double t_s, Scene& scene) {
  if (!is_computable(model, scene.at_s)) scene.at_s = t_s;
  for (std::size_t i = 0; i < scene.beside.size(); ++i)
    bring_at_within_reach(model.beside[i], t_s, scene.beside[i]);
}

/// The scene as it is saved: nothing is pointed at, and only what the saved steps have is highlighted.
Scene saved(const LessonSession& session) {
  Scene scene = session.model()->scene;
  leave_out_captions_of_other_stills(scene, session.t_s());
  bring_at_within_reach(*session.model(), session.t_s(), scene);
  std::set<std::string> terms;
  for (std::size_t i = 0; i <= session.place().step; ++i)
    for (const Equation* equation : blocks_of<Equation>(session.stage().steps[i]))
      terms.insert(equation->math.terms.begin(), equation->math.terms.end());
  const auto saved_of = [&](const std::vector<std::string>& highlight) {
    std::vector<std::string> kept;
    for (const std::string& name : highlight)
      if (overlay_from(name) || terms.count(name) > 0) kept.push_back(name);
    return kept;
  };
  scene.highlight = saved_of(session.lesson_scene().highlight);
  std::map<std::string, Body> bodies{{scene.body.name, scene.body}};
  for (std::size_t i = 0; i < scene.beside.size(); ++i) {
    Scene& other = scene.beside[i];
    other.highlight = saved_of(session.lesson_scene().beside[i].highlight);
    // A body on its pivot has other moments than the same body in the air.
    const std::string name = other.body.name;
    for (int n = 2;
         !bodies.emplace(other.body.name, other.body).second && bodies.at(other.body.name) != other.body;
         ++n) {
      other.body.name = fmt::format("{}-{}", name, n);
    }
  }
  return scene;
}

/// The first word of a fence; empty of all else.
std::string_view kind_of(const SourceText& source, const MarkdownBlock& block) {
  if (block.kind != MarkdownBlock::Kind::fence) return {};
  std::string_view opening = source.line(block.first_line);
  opening.remove_prefix(std::min(opening.find_first_not_of("`~"), opening.size()));
  opening = trimmed(opening);
  return opening.substr(0, opening.find(' '));
}

/// Whether the step that a line belongs to shows this motion.
bool shows_motion(const Stage& stage, int line, const Scene& scene) {
  const auto next = std::find_if(stage.steps.begin(), stage.steps.end(),
                                 [&](const Step& step) { return step.place.line > line; });
  const Step& step = *std::prev(next);
  return step.scene && same_motion(*step.scene, scene);
}

/// Blocks of the stage up to the end of the step, without the heading.
std::vector<MarkdownBlock> blocks_of(const Stage& stage, std::size_t step, const SourceText& source) {
  Report report(source, {});
  TextReader texts(report);
  const int first_line = read_front_matter(texts).next_line;
  std::vector<MarkdownBlock> blocks;
  const bool is_last = step + 1 == stage.steps.size();
  for (const MarkdownBlock& block : read_markdown(source, first_line, report).blocks) {
    if (block.first_line <= stage.place.line) continue;
    const bool is_stage = block.kind == MarkdownBlock::Kind::heading && block.level == 1;
    if (is_last ? is_stage : block.first_line >= stage.steps[step + 1].place.line) break;
    blocks.push_back(block);
  }
  return blocks;
}

/// Whether the block asks for a state that is made of the scene.
bool asks_for_state(const Stage& stage, const MarkdownBlock& block) {
  for (const Step& step : stage.steps)
    for (const Ask* ask : blocks_of<Ask>(step))
      if (ask->task && ask->place.line >= block.first_line && ask->place.line <= block.last_line) return true;
  return false;
}

/// What stands in place of a block that is made of another motion: of this one its rows may not be possible,
/// nor what is to be reached. Empty: the block itself.
std::string_view instead_of(const MarkdownBlock& block, std::string_view kind, const LessonSession& session) {
  const bool is_table = kind == "table";
  if (!is_table && !asks_for_state(session.stage(), block)) return {};
  if (session.has_scene() && shows_motion(session.stage(), block.first_line, session.model()->scene))
    return {};
  return is_table ? "*(A table of other motions is left out here.)*"
                  : "*(A question about another motion is left out here.)*";
}

/// The scene stands where the stage's first one stood; later ones change nothing.
std::string steps_of(const LessonSession& session, std::string scene_keys) {
  const SourceText source(session.lesson().source);
  std::string text;
  for (const MarkdownBlock& block : blocks_of(session.stage(), session.place().step, source)) {
    const std::string_view kind = kind_of(source, block);
    const std::string_view instead = instead_of(block, kind, session);
    if (kind == "scene")
      text += fmt::format("\n```scene\n{}```\n", std::exchange(scene_keys, {}));
    else
      text +=
          fmt::format("\n{}\n", instead.empty() ? source.lines(block.first_line, block.last_line) : instead);
  }
  return text;
}

}  // namespace

std::string own_body_of(const Body& body, const Torque& torque) {
  const auto reads_as_it = [&](const Body& written) {
    const auto read = on_its_pivot(written, torque);
    return read && *read == body;
  };
  if (const auto built_in = find_body(body.name); built_in && reads_as_it(*built_in)) return {};
  std::string lines = fmt::format("\n[body.{}]\n", body.name);
  if (body.shape && reads_as_it(make_body(body.name, body.shape->kind, body.shape->size_m, body.mass_kg)))
    return lines + fmt::format("shape = \"{}\"\nsize_m = {}\nmass_kg = {}\n", name_of(body.shape->kind),
                               toml(body.shape->size_m), toml(body.mass_kg));
  lines += fmt::format("moments = {}\n", toml(body.moments.vector()));
  if (body.mass_kg != 1.0) lines += fmt::format("mass_kg = {}\n", toml(body.mass_kg));
  if (!body.shape) return lines;
  lines += fmt::format("draw = \"{}\"\n", name_of(body.shape->kind));
  if (body.shape != equivalent_box(body.moments, body.mass_kg))
    lines += fmt::format("size_m = {}\n", toml(body.shape->size_m));
  return lines;
}

std::string lesson_of(const LessonSession& session, std::string_view id) {
  const Lesson& lesson = session.lesson();
  const Stage& stage = session.stage();
  std::string text = fmt::format("+++\nformat = 1\nid = \"{}\"\ntitle = {}\n",
                                 is_id(id) ? id : std::string_view(stage.id), toml(lesson.title)),
              keys;
  if (lesson.notation.xyz_are_body_axes) text += "axes = \"xyz\"\n";
  if (!lesson.about.outcomes.empty()) {  // questions refer to them
    std::vector<std::string> outcomes;
    for (const std::string& outcome : lesson.about.outcomes) outcomes.push_back(toml(outcome));
    text += fmt::format("outcomes = [{}]\n", fmt::join(outcomes, ", "));
  }
  if (session.has_scene()) {
    const Scene scene = saved(session);
    keys = scene_keys_text(scene, session.t_s());
    std::set<std::string> written;
    for (const Scene* shown : shown_scenes(scene))
      if (written.insert(shown->body.name).second) text += own_body_of(shown->body, shown->torque);
  }
  const SourceText source(lesson.source);
  const std::string steps =
      with_links_out(fmt::format("{}\n", source.line(stage.place.line)) + steps_of(session, keys), session);
  return text + macros_of(lesson) + references_of(lesson, steps) + symbols_of(lesson) + "+++\n\n" + steps;
}

std::string trace_of(const LessonSession& session) {
  const SceneModel* model = session.model();
  if (!model) return {};
  const auto [from_s, to_s] = session.time_line();
  const Problem problem = problem_of(model->scene);
  const double frames = std::round((to_s - from_s) / (model->rate * kFrameSeconds));
  const int lines = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(kMostTraceLines - 1)));
  const TraceColumns columns = usual_trace_columns();
  std::string csv = trace_csv_header(columns);
  for (int i = 0; i <= lines; ++i) {
    const double t_s = std::lerp(from_s, to_s, static_cast<double>(i) / lines);
    const RigidBodyState state = model->motion->at(t_s);
    if (!is_finite(state)) break;
    csv += csv_line(trace_row(columns, problem, t_s, state));
  }
  return csv;
}

}  // namespace polhode
