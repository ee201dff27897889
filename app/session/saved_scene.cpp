// SPDX-License-Identifier: MIT
#include "app/session/saved_scene.h"

#include "app/export/trace/trace_rows.h"
#include "lessons/reader/front_matter.h"
#include "lessons/reader/markdown/markdown.h"
#include "physics/body/torque_text.h"
#include "render/scene/model/rotor.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace polhode {

namespace {

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

// TOML.

/// The shortest decimal that reads back as the same double, with the dot or exponent of a float.
std::string toml(double value) {
  std::string digits = fmt::format("{}", value);
  if (digits.find_first_of(".e") == digits.npos) digits += ".0";
  return digits;
}

std::string toml(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (double value : values) texts.push_back(toml(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string toml(const Vec3& v) { return toml(std::vector<double>{v[0], v[1], v[2]}); }

/// TeX is most readable between single quotes, which cannot hold one.
std::string toml(const std::string& text) {
  if (text.find_first_of("'\n\r\t") == text.npos) return '\'' + text + '\'';
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      quoted += c;
  }
  return quoted + '"';
}

std::string toml(const char* name) { return fmt::format("\"{}\"", name); }

std::string list_of_names(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return '[' + list + ']';
}

// Numbers that the reader turns into others: the text is sought that gives the ones there are.

/// What reads as this angle: whole 1e-4° of a writable camera, else some ulps from the quotient.
double degrees_that_read_as(double angle_rad) {
  constexpr double kParts = 1e4;
  const auto reads = [&](double degrees) {
    return std::remainder(degrees, 360.0) * (std::numbers::pi / 180) == angle_rad;
  };
  const double near = angle_rad * kDegreesPerRadian, whole = std::round(near * kParts) / kParts;
  if (reads(whole)) return whole;
  double above = near, below = near;
  for (int ulps = 0; ulps < 8; ++ulps) {
    if (reads(above)) return above;
    if (reads(below)) return below;
    above = std::nextafter(above, 1e9);
    below = std::nextafter(below, -1e9);
  }
  return near;
}

/// A direction is read by dividing it by its length, which may move the last digits of a unit vector: of what
/// is an ulp or none beside a multiple of it, some reads as itself.
template <class Reads>
std::vector<double> that_reads(const std::vector<double>& unit, const Reads& reads) {
  constexpr int kMultiples = 100;
  const auto sides = static_cast<int>(std::pow(3, unit.size()));
  for (int factor = 1; factor <= kMultiples; ++factor)
    for (int side = 0; side < sides; ++side) {
      std::vector<double> beside;
      for (int rest = side; beside.size() < unit.size(); rest /= 3) {
        const double x = factor * unit[beside.size()];
        beside.push_back(rest % 3 == 0 ? x : std::nextafter(x, rest % 3 == 1 ? HUGE_VAL : -HUGE_VAL));
      }
      if (reads(beside)) return beside;
    }
  return unit;
}

std::vector<double> wxyz_that_read_as(const Quat& q) {
  const std::vector<double> short_one = wxyz_in_short(q);
  const auto reads = [&](const std::vector<double>& v) { return attitude_from(v) == q; };
  return reads(short_one) ? short_one : that_reads({q.w(), q.x(), q.y(), q.z()}, reads);
}

std::string text_of(const HeavyTop& top) {
  const auto text = [&](const std::vector<double>& axis) {
    return fmt::format("heavy:{},{}", top.mgr, fmt::join(axis, ","));
  };
  return text(that_reads({top.axis_B[0], top.axis_B[1], top.axis_B[2]}, [&](const auto& axis) {
    const Result<TorqueTerm> read = parse_torque_term(text(axis));
    return read && *read == TorqueTerm(top);
  }));
}

std::string text_of(const SpaceTorque& torque) { return fmt::format("space:{}", fmt::join(torque.N_S, ",")); }
std::string text_of(const BodyTorque& torque) { return fmt::format("body:{}", fmt::join(torque.N_B, ",")); }
std::string text_of(const LinearDamping& damping) { return fmt::format("damping:{}", damping.c); }
std::string text_of(const EnergySink& sink) { return fmt::format("sink:{}", sink.c); }

// Values of keys.

std::string value_of(const AttitudeSpec& attitude) {
  if (const auto* q = std::get_if<Quat>(&attitude)) return toml(wxyz_that_read_as(*q));
  return toml(std::get<LPoints>(attitude) == LPoints::down ? "L-down" : "L-up");
}

std::string value_of(const Torque& torque) {
  std::vector<std::string> terms;
  for (const TorqueTerm& term : torque)
    terms.push_back(std::visit([](const auto& one) { return text_of(one); }, term));
  return list_of_names(terms);
}

std::string value_of(ArrowHeld arrow) {
  if (arrow == ArrowHeld::in_space) return toml("space");
  return toml(arrow == ArrowHeld::in_body ? "body" : "free");
}

std::string value_of(const MotionSpec& motion) {
  std::vector<std::string> keys;
  if (motion.method) keys.push_back(fmt::format("method = \"{}\"", name_of(*motion.method)));
  if (motion.step_s) keys.push_back("step = " + toml(*motion.step_s));
  if (motion.tolerance) keys.push_back("tolerance = " + toml(*motion.tolerance));
  if (motion.ghost) keys.push_back("ghost = true");
  return fmt::format("{{ {} }}", fmt::join(keys, ", "));
}

std::string value_of(const std::vector<View>& views) {
  std::vector<std::string> names;
  for (View view : views) names.emplace_back(view == View::space ? "space" : "body");
  return list_of_names(names);
}

std::string value_of(const OverlaySet& shown) {
  std::vector<std::string> names;
  for (const std::string& name : overlay_names())
    if (shown.contains(*overlay_from(name))) names.push_back(name);
  return list_of_names(names);
}

std::string value_of(const CameraSpec& camera) {
  const CameraSpec usual;
  std::vector<std::string> keys;
  if (camera.azimuth_rad != usual.azimuth_rad)
    keys.push_back("azimuth_deg = " + toml(degrees_that_read_as(camera.azimuth_rad)));
  if (camera.elevation_rad != usual.elevation_rad)
    keys.push_back("elevation_deg = " + toml(degrees_that_read_as(camera.elevation_rad)));
  if (camera.distance != usual.distance) keys.push_back("distance = " + toml(camera.distance));
  if (camera.zoom != usual.zoom) keys.push_back("zoom = " + toml(camera.zoom));
  return fmt::format("{{ {} }}", fmt::join(keys, ", "));
}

std::string value_of(const std::vector<Meter>& meters) {
  std::vector<std::string> names;
  for (Meter meter : meters) names.emplace_back(name_of(meter));
  return list_of_names(names);
}

// The front matter.

const char* name_of_shape(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::box:
      return "box";
    case ShapeKind::ellipsoid:
      return "ellipsoid";
    case ShapeKind::cylinder:
      return "cylinder";
    case ShapeKind::t_handle:
      break;
  }
  return "t-handle";
}

std::string symbols_of(const Lesson& lesson) {
  std::string lines;
  for (const auto& [name, symbol] : lesson.symbols) {
    lines += fmt::format("{} = {{ tex = {}", is_id(name) ? name : toml(name), toml(symbol.tex));
    if (!symbol.role.empty()) lines += ", role = " + toml(symbol.role);
    if (!symbol.say.empty()) lines += ", say = " + toml(symbol.say);
    if (!symbol.unit.empty()) lines += ", unit = " + toml(symbol.unit);
    lines += " }\n";
  }
  return lines.empty() ? "" : "\n[symbols]\n" + lines;
}

std::string macros_of(const Lesson& lesson) {
  std::string lines;
  for (const auto& [name, macro] : lesson.macros)
    lines += macro.arguments == 0 ? fmt::format("{} = {}\n", name, toml(macro.body))
                                  : fmt::format("{} = {{ arguments = {}, tex = {} }}\n", name,
                                                macro.arguments, toml(macro.body));
  return lines.empty() ? "" : "\n[macros]\n" + lines;
}

// The stage.

/// The scene as it is saved: nothing is pointed at, and only what the saved steps have is highlighted.
Scene saved(const LessonSession& session) {
  Scene scene = session.model()->scene;
  std::set<std::string> terms;
  for (std::size_t i = 0; i <= session.place().step; ++i)
    for (const Equation* equation : blocks_of<Equation>(session.stage().steps[i]))
      terms.insert(equation->math.terms.begin(), equation->math.terms.end());
  scene.highlight.clear();
  for (const std::string& name : session.lesson_scene().highlight)
    if (overlay_from(name) || terms.count(name) > 0) scene.highlight.push_back(name);
  return scene;
}

bool is_scene(const SourceText& source, const MarkdownBlock& block) {
  if (block.kind != MarkdownBlock::Kind::fence) return false;
  std::string_view opening = source.line(block.first_line);
  opening.remove_prefix(std::min(opening.find_first_not_of("`~"), opening.size()));
  return trimmed(opening) == "scene";
}

/// Blocks of the stage up to the end of the step, without the heading.
std::vector<MarkdownBlock> blocks_of(const Stage& stage, std::size_t step, const SourceText& source) {
  Report report(source, {});
  TextReader texts(report);
  const int first_line = read_front_matter(texts).next_line;
  std::vector<MarkdownBlock> blocks;
  bool inside = false;
  std::size_t rules = 0;
  for (const MarkdownBlock& block : read_markdown(source, first_line, report).blocks) {
    if (block.kind == MarkdownBlock::Kind::heading) {
      if (inside) break;
      inside = block.first_line == stage.place.line;
    } else if (inside) {
      if (block.kind == MarkdownBlock::Kind::rule && rules++ == step) break;
      blocks.push_back(block);
    }
  }
  return blocks;
}

/// The scene stands where the stage's first one stood; later ones change nothing.
std::string steps_of(const LessonSession& session, std::string scene_keys) {
  const SourceText source(session.lesson().source);
  std::string text;
  for (const MarkdownBlock& block : blocks_of(session.stage(), session.place().step, source)) {
    if (is_scene(source, block))
      text += fmt::format("\n```scene\n{}```\n", std::exchange(scene_keys, {}));
    else
      text += fmt::format("\n{}\n", source.lines(block.first_line, block.last_line));
  }
  return text;
}

}  // namespace

std::string scene_keys_of(const Scene& scene, double t_s) {
  const Scene usual;
  std::string keys;
  const auto add = [&](bool differs, const char* key, const auto& value) {
    if (differs) keys += fmt::format("{} = {}\n", key, value());
  };
  add(scene.body != usual.body, "body", [&] { return toml(scene.body.name.c_str()); });
  add(scene.w0_B != usual.w0_B, "omega", [&] { return toml(scene.w0_B); });
  add(scene.attitude.has_value(), "attitude", [&] { return value_of(*scene.attitude); });
  add(!scene.torque.empty(), "torque", [&] { return value_of(scene.torque); });
  add(scene.v0_S != usual.v0_S, "velocity", [&] { return toml(scene.v0_S); });
  add(scene.F_S != usual.F_S, "force", [&] { return toml(scene.F_S); });
  add(scene.arrow != usual.arrow, "arrow", [&] { return value_of(scene.arrow); });
  add(scene.motion != usual.motion, "motion", [&] { return value_of(scene.motion); });
  add(scene.views != usual.views, "views", [&] { return value_of(scene.views); });
  add(scene.show != usual.show, "show", [&] { return value_of(scene.show); });
  add(scene.camera != usual.camera, "camera", [&] { return value_of(scene.camera); });
  add(scene.at_s != usual.at_s, "at", [&] { return toml(scene.at_s); });
  add(t_s != scene.at_s, "still", [&] { return toml(t_s); });
  add(scene.duration_s.has_value(), "duration", [&] { return toml(*scene.duration_s); });
  add(scene.rate.has_value(), "rate", [&] { return toml(*scene.rate); });
  add(!scene.highlight.empty(), "highlight", [&] { return list_of_names(scene.highlight); });
  add(scene.quality != usual.quality, "quality", [&] { return toml(name_of(scene.quality)); });
  add(!scene.caption.empty(), "caption", [&] { return toml(scene.caption); });
  add(scene.meters.has_value(), "meters", [&] { return value_of(*scene.meters); });
  return keys;
}

std::string own_body_of(const Body& body, const Torque& torque) {
  const auto reads_as_it = [&](const Body& written) {
    const auto read = on_its_pivot(written, torque);
    return read && *read == body;
  };
  if (const auto built_in = find_body(body.name); built_in && reads_as_it(*built_in)) return {};
  std::string lines = fmt::format("\n[body.{}]\n", body.name);
  if (body.shape && reads_as_it(make_body(body.name, body.shape->kind, body.shape->size_m, body.mass_kg)))
    return lines + fmt::format("shape = \"{}\"\nsize_m = {}\nmass_kg = {}\n", name_of_shape(body.shape->kind),
                               toml(body.shape->size_m), toml(body.mass_kg));
  lines += fmt::format("moments = {}\n", toml(body.moments.vector()));
  return body.shape == equivalent_box(body.moments) ? lines + "draw = \"box\"\n" : lines;
}

std::string lesson_of(const LessonSession& session) {
  const Lesson& lesson = session.lesson();
  const Stage& stage = session.stage();
  std::string text = fmt::format("+++\nformat = 1\nid = \"{}\"\ntitle = {}\n", stage.id, toml(lesson.title)),
              keys;
  if (session.has_scene()) {
    const Scene scene = saved(session);
    keys = scene_keys_of(scene, session.t_s());
    text += own_body_of(scene.body, scene.torque);
  }
  text += macros_of(lesson) + symbols_of(lesson) + "+++\n\n";
  const SourceText source(lesson.source);
  return text + fmt::format("{}\n", source.line(stage.place.line)) + steps_of(session, keys);
}

std::string trace_of(const LessonSession& session) {
  const SceneModel* model = session.model();
  if (!model) return {};
  const auto [from_s, to_s] = session.time_line();
  const Problem problem = problem_of(model->scene);
  const double frames = std::round((to_s - from_s) / (model->rate * kFrameSeconds));
  const int lines = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(kMostTraceLines - 1)));
  std::string csv = trace_csv_header();
  for (int i = 0; i <= lines; ++i) {
    const TraceRow row =
        trace_row(problem, *model->motion, std::lerp(from_s, to_s, static_cast<double>(i) / lines));
    if (overflowed(row)) break;
    csv += csv_line(row);
  }
  return csv;
}

}  // namespace polhode
