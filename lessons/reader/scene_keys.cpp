// SPDX-License-Identifier: MIT
#include "lessons/reader/scene_keys.h"

#include "base/spelling.h"
#include "base/utf8.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/reader.h"
#include "lessons/reader/scene_values.h"
#include "lessons/reader/toml_text.h"
#include "physics/body/pivot.h"
#include "physics/body/torque_text.h"
#include "physics/method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace polhode {
namespace {

constexpr std::size_t kMaxViews = 2;
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
static_assert(kMaxOverlays >= kOverlayCount);

/// With moments about the pivot, where it hangs on one.
Result<Body> body_of(const Scene& scene, const LessonBodies& bodies) {
  if (bodies.drawn_as_box.contains(scene.body.name)) return scene.body;
  return on_its_pivot(scene.body, scene.torque);
}

// One table's keys into one scene.
class SceneKeys {
 public:
  SceneKeys(const LessonBodies& bodies, LessonScene& scene, TextReader& texts)
      : bodies_(bodies),
        scene_(scene.scene),
        caption_(scene.caption),
        shown_(scene.shown),
        texts_(texts),
        report_(texts.report()) {}

  std::vector<PlacedText> read(const TomlTable& table);

  /// All that is known of a key. To add one: a row of the table, which FORMAT.md repeats, and a reader here.
  struct Row {
    SceneKeyFacts facts;
    void (SceneKeys::*read)(const TomlEntry&);
    /// The value; empty where it is as usual.
    std::string (*text)(const Scene&);
  };
  static std::span<const Row> rows();

 private:
  template <class T, class U>
  static void assign(T& target, const std::optional<U>& value) {
    if (value) target = *value;
  }

  void unknown(std::string_view what, const PlacedText& name, const std::vector<std::string>& known) {
    report_.error(name.place, "unknown " + std::string(what) + ' ' + in_quotes(name.text),
                  suggestion(name.text, known));
  }

  void omega(const TomlEntry& entry) { assign(scene_.w0_B, read_vector(entry, report_)); }
  void velocity(const TomlEntry& entry) { assign(scene_.v0_S, read_vector(entry, report_)); }
  void force(const TomlEntry& entry) { assign(scene_.F_S, read_vector(entry, report_)); }
  void at(const TomlEntry& entry) { assign(scene_.at_s, read_number(entry, report_)); }
  void still(const TomlEntry& entry) { assign(scene_.still_s, read_number(entry, report_)); }
  void duration(const TomlEntry& entry) { assign(scene_.duration_s, read_positive_number(entry, report_)); }
  void rate(const TomlEntry& entry) { assign(scene_.rate, read_positive_number(entry, report_)); }

  void body(const TomlEntry& entry) {
    const auto name = read_text(entry, report_);
    if (!name) return;
    if (const auto own = bodies_.named.find(*name); own != bodies_.named.end()) {
      scene_.body = own->second;
    } else if (const auto built_in = find_body(*name)) {
      scene_.body = *built_in;
    } else if (bodies_.complete) {
      std::vector<std::string> known = named_bodies();
      for (const auto& [own_name, own_body] : bodies_.named) known.push_back(own_name);
      unknown("body", {*name, entry.value.place}, known);
    }
  }

  void attitude(const TomlEntry& entry) {
    if (const auto* name = entry.value.as<std::string>()) {
      if (*name == "L-down")
        scene_.attitude = LPoints::down;
      else if (*name == "L-up")
        scene_.attitude = LPoints::up;
      else
        unknown("attitude", {*name, entry.value.place}, {"L-down", "L-up", "[w, x, y, z]"});
      return;
    }
    const auto wxyz = read_numbers(entry, 4, report_);
    if (!wxyz) return;
    if (std::all_of(wxyz->begin(), wxyz->end(), [](double x) { return x == 0; }))
      report_.error(entry.value.place, "the quaternion of an attitude must not be zero");
    else
      scene_.attitude = attitude_from(*wxyz);
  }

  void torque(const TomlEntry& entry) {
    const auto texts = read_texts(entry, kMaxTorqueTerms, report_);
    if (!texts) return;
    Torque torque;
    for (const PlacedText& text : *texts) {
      if (const Result<TorqueTerm> term = parse_torque_term(text.text))
        torque.push_back(*term);
      else
        report_.error(text.place, "torque: " + term.error());
    }
    scene_.torque = std::move(torque);
  }

  /// Said where a table names the torque or the body, not again on steps that go on with both.
  void check_pivot(const TomlTable& table) {
    const TomlEntry* torque = table.find("torque");
    const TomlEntry* named = torque != nullptr ? torque : table.find("body");
    if (named == nullptr) return;
    if (const auto body = body_of(scene_, bodies_); !body)
      report_.error(
          named->value.place, body.error(),
          "let the axis of \"heavy\" be that of 1, 2 or 3, or give the body by moments about the pivot");
  }

  void arrow(const TomlEntry& entry) {
    const auto name = read_text(entry, report_);
    if (!name) return;
    if (*name == "space")
      scene_.arrow = ArrowHeld::in_space;
    else if (*name == "body")
      scene_.arrow = ArrowHeld::in_body;
    else if (*name == "free")
      scene_.arrow = ArrowHeld::free;
    else
      unknown("arrow", {*name, entry.value.place}, {"space", "body", "free"});
  }

  void motion_method(const TomlEntry& entry, MotionSpec& motion) {
    const auto name = read_text(entry, report_);
    if (!name) return;
    if (const auto method = method_from(*name))
      motion.method = *method;
    else
      unknown("motion", {*name, entry.value.place}, method_names());
  }

  void motion(const TomlEntry& entry) {
    MotionSpec motion;
    if (const auto* table = entry.value.as<TomlTable>()) {
      read_keys(
          *table, "motion",
          {{"method", [&](const TomlEntry& e) { motion_method(e, motion); }},
           {"step", [&](const TomlEntry& e) { assign(motion.step_s, read_positive_number(e, report_)); }},
           {"tolerance",
            [&](const TomlEntry& e) { assign(motion.tolerance, read_positive_number(e, report_)); }},
           {"ghost", [&](const TomlEntry& e) { assign(motion.ghost, read_flag(e, report_)); }}},
          report_);
      check_control(*table, motion);
    } else {
      motion_method(entry, motion);
    }
    check_step_given(entry, motion);
    scene_.motion = motion;
  }

  /// A step and a tolerance each belong to methods of one kind.
  void check_control(const TomlTable& table, const MotionSpec& motion) {
    const StepControl control = motion.method ? facts_of(*motion.method).control : StepControl::adaptive;
    const std::string owner =
        motion.method ? in_quotes(name_of(*motion.method)) + " has none" : "and no method is named";
    if (motion.step_s && control != StepControl::fixed)
      report_.error(table.find("step")->place, "a step is of methods with a fixed step, " + owner,
                    "write method = \"rk4\", or leave the step out");
    if (motion.tolerance && control != StepControl::adaptive)
      report_.error(table.find("tolerance")->place, "a tolerance is of adaptive methods, " + owner,
                    "write method = \"dormand-prince-8\", or leave the tolerance out");
  }

  void check_step_given(const TomlEntry& entry, const MotionSpec& motion) {
    const TomlTable* table = entry.value.as<TomlTable>();
    const bool given = table != nullptr && table->find("step") != nullptr;
    if (!motion.method || facts_of(*motion.method).control != StepControl::fixed || given) return;
    const std::string name = in_quotes(name_of(*motion.method));
    report_.error(entry.value.place, name + " needs a step in seconds",
                  "write motion = { method = " + name + ", step = 0.02 }");
  }

  void views(const TomlEntry& entry) {
    const auto names = read_texts(entry, kMaxViews, report_);
    if (!names) return;
    std::vector<View> views;
    for (const PlacedText& name : *names) {
      if (name.text != "space" && name.text != "body") {
        unknown("view", name, {"space", "body"});
        continue;
      }
      const View view = name.text == "space" ? View::space : View::body;
      if (!views.empty() && views.front() == view) {
        report_.error(name.place, "the view " + in_quotes(name.text) + " is there already");
        continue;
      }
      views.push_back(view);
    }
    if (names->empty())
      report_.error(entry.value.place, "\"views\" needs at least one view", "\"space\" or \"body\"");
    if (!views.empty()) scene_.views = std::move(views);
  }

  void show(const TomlEntry& entry) {
    const auto names = read_texts(entry, static_cast<std::size_t>(kMaxOverlays), report_);
    if (!names) return;
    OverlaySet shown;
    shown_.clear();
    for (const PlacedText& name : *names) {
      const auto overlay = overlay_from(name.text);
      if (!overlay)
        unknown("overlay", name, overlay_names());
      else if (shown.contains(*overlay))
        report_.warning(name.place, in_quotes(name.text) + " is shown already");
      else {
        shown.insert(*overlay);
        shown_.push_back(name);
      }
    }
    scene_.show = shown;
  }

  void elevation(const TomlEntry& entry, CameraSpec& camera) {
    const auto degrees = read_number(entry, report_);
    if (!degrees) return;
    if (std::abs(*degrees) <= kMostElevationDeg)
      camera.elevation_rad = *degrees * kRadiansPerDegree;
    else
      report_.error(entry.value.place, "\"elevation_deg\" must lie between -90 and 90");
  }

  void camera(const TomlEntry& entry) {
    const auto* table = entry.value.as<TomlTable>();
    if (table == nullptr) {
      report_.error(entry.value.place, "\"camera\" takes a table, found " + std::string(entry.value.kind()),
                    "write camera = { azimuth_deg = 35, elevation_deg = 20 }");
      return;
    }
    CameraSpec camera;
    const auto azimuth = [&](const TomlEntry& e) {
      if (const auto degrees = read_number(e, report_)) {
        camera.azimuth_rad = std::remainder(*degrees, 360.0) * kRadiansPerDegree;
      }
    };
    read_keys(*table, "the camera",
              {{"azimuth_deg", azimuth},
               {"elevation_deg", [&](const TomlEntry& e) { elevation(e, camera); }},
               {"distance", [&](const TomlEntry& e) { assign(camera.distance, scale(e)); }},
               {"zoom", [&](const TomlEntry& e) { assign(camera.zoom, scale(e)); }}},
              report_);
    scene_.camera = camera;
  }

  /// Of the camera: what lies outside shows nothing, and is most likely a slip.
  std::optional<double> scale(const TomlEntry& entry) {
    const auto number = read_positive_number(entry, report_);
    if (!number || (*number >= kLeastCameraScale && *number <= kMostCameraScale)) return number;
    report_.error(entry.value.place, in_quotes(entry.key) + " must lie between 0.1 and 100");
    return std::nullopt;
  }

  void highlight(const TomlEntry& entry) {
    auto names = read_texts(entry, kMaxHighlights, report_);
    if (!names) return;
    scene_.highlight.clear();
    for (PlacedText& name : *names) {
      if (!is_id(name.text) && !overlay_from(name.text)) {
        report_.error(name.place, in_quotes(name.text) + " can be neither a term nor an overlay",
                      std::string(kIdRule));
        continue;
      }
      scene_.highlight.push_back(name.text);
      highlighted_.push_back(std::move(name));
    }
  }

  void quality(const TomlEntry& entry) {
    const auto name = read_text(entry, report_);
    if (!name) return;
    if (const auto level = quality_level_from(*name)) {
      scene_.quality = *level;
    } else {
      unknown("quality", {*name, entry.value.place}, {"draft", "normal", "fine"});
    }
  }

  void caption(const TomlEntry& entry) {
    auto text = read_text(entry, report_);
    if (!text) return;
    if (!is_plain_line(*text)) {
      report_.error(entry.value.place, "a caption is one line without control characters");
    } else if (count_characters(*text) > static_cast<int>(kMaxCaptionCharacters)) {
      report_.error(entry.value.place, "a caption has at most " + std::to_string(kMaxCaptionCharacters) +
                                           " characters, found " + std::to_string(count_characters(*text)));
    } else {
      caption_ = std::make_shared<const RichText>(
          texts_.caption(located_string(texts_.source(), entry.value.place, *text)));
      scene_.caption = std::move(*text);
    }
  }

  void meters(const TomlEntry& entry) {
    const auto names = read_texts(entry, static_cast<std::size_t>(kMeterCount), report_);
    if (!names) return;
    std::vector<Meter> meters;
    for (const PlacedText& name : *names) {
      const auto meter = meter_from(name.text);
      if (!meter)
        unknown("meter", name, meter_names());
      else if (std::find(meters.begin(), meters.end(), *meter) != meters.end())
        report_.warning(name.place, "the meter " + in_quotes(name.text) + " is there already");
      else
        meters.push_back(*meter);
    }
    scene_.meters = std::move(meters);
  }

  const LessonBodies& bodies_;
  Scene& scene_;
  std::shared_ptr<const RichText>& caption_;
  std::vector<PlacedText>& shown_;
  TextReader& texts_;
  Report& report_;
  std::vector<PlacedText> highlighted_;
};

const Scene& usual() {
  static const Scene kUsual;
  return kUsual;
}

std::span<const SceneKeys::Row> SceneKeys::rows() {
  static const std::array kRows = std::to_array<Row>({
      {{"body", "name of a body", R"(`"textbook"`)"},
       &SceneKeys::body,
       [](const Scene& scene) { return scene.body != usual().body ? toml(scene.body.name.c_str()) : ""; }},
      {{"omega", "`[ω1, ω2, ω3]`, rad/s, body axes, at t = 0", "`[0.2, 0.1, 3.0]`"},
       &SceneKeys::omega,
       [](const Scene& scene) { return scene.w0_B != usual().w0_B ? toml(scene.w0_B) : ""; }},
      {{"attitude", R"(`"L-down"`, `"L-up"`, or the quaternion `[w, x, y, z]` body → space)",
        "L down with `plane`, else up"},
       &SceneKeys::attitude,
       [](const Scene& scene) { return scene.attitude ? text_of(*scene.attitude) : ""; }},
      {{"torque",
        R"(a string or up to 4: `"space:x,y,z"` `"body:x,y,z"` `"heavy:MGR,ax,ay,az"` `"damping:C"` `"sink:C"`)",
        "none"},
       &SceneKeys::torque,
       [](const Scene& scene) { return !scene.torque.empty() ? text_of(scene.torque) : ""; }},
      {{"velocity",
        "`[x, y, z]`, m/s, space axes: velocity of the centre of mass at t = 0; the mass is the body's "
        "`mass_kg`, else 1 kg",
        "`[0, 0, 0]`"},
       &SceneKeys::velocity,
       [](const Scene& scene) { return scene.v0_S != usual().v0_S ? toml(scene.v0_S) : ""; }},
      {{"force", "`[x, y, z]`, N, space axes: a constant force on the centre of mass", "`[0, 0, 0]`"},
       &SceneKeys::force,
       [](const Scene& scene) { return scene.F_S != usual().F_S ? toml(scene.F_S) : ""; }},
      {{"arrow", R"(what holds the arrow A of `transport`: `"space"`, `"body"`, or nothing: `"free"`)",
        R"(`"space"`)"},
       &SceneKeys::arrow,
       [](const Scene& scene) { return scene.arrow != usual().arrow ? text_of(scene.arrow) : ""; }},
      {{"motion",
        R"(a method (below), or `{ method = "rk4", step = 0.02 }`, `{ method = "dormand-prince-8", tolerance = 1e-10 }`; step in s; `ghost = true` draws the exact body, translucent, beside the computed one)",
        R"(without torque `"exact"`, with it `"dormand-prince-8"`)"},
       &SceneKeys::motion,
       [](const Scene& scene) { return scene.motion != usual().motion ? text_of(scene.motion) : ""; }},
      {{"views", R"(`"space"`, `"body"`, or both in a list)", R"(`"space"`)"},
       &SceneKeys::views,
       [](const Scene& scene) { return scene.views != usual().views ? text_of(scene.views) : ""; }},
      {{"show", "list of overlays, at most 40", "none"},
       &SceneKeys::show,
       [](const Scene& scene) { return scene.show != usual().show ? text_of(scene.show) : ""; }},
      {{"camera",
        "`{ azimuth_deg, elevation_deg, distance, zoom }`; elevation −90 to 90, distance and zoom 0.1 to 100",
        "34°, 20°, 4.2, 1"},
       &SceneKeys::camera,
       [](const Scene& scene) { return scene.camera != usual().camera ? text_of(scene.camera) : ""; }},
      {{"at", "the t of a still, s", "0"},
       &SceneKeys::at,
       [](const Scene& scene) { return scene.at_s != usual().at_s ? toml(scene.at_s) : ""; }},
      {{"still",
        "the t of a still, s, where lengths of arrows under torque and the methods' tables are to be those "
        "of `at`",
        "`at`"},
       &SceneKeys::still,
       [](const Scene& scene) { return still_time_s(scene) != scene.at_s ? toml(still_time_s(scene)) : ""; }},
      {{"duration", "what curves over time cover, s", "one polhode period or turn"},
       &SceneKeys::duration,
       [](const Scene& scene) { return scene.duration_s ? toml(*scene.duration_s) : ""; }},
      {{"rate", "simulated seconds per shown second",
        "one polhode period (or turn; under torque four turns) in 8 s"},
       &SceneKeys::rate,
       [](const Scene& scene) { return scene.rate ? toml(*scene.rate) : ""; }},
      {{"highlight",
        R"(overlays, which are drawn bolder, or ids of `\term`s of the stage, which are marked on its pages; at most 4)",
        "none"},
       &SceneKeys::highlight,
       [](const Scene& scene) { return !scene.highlight.empty() ? toml_list(scene.highlight) : ""; }},
      {{"quality",
        R"(how finely pictures are drawn: `"draft"` (solid bodies with jagged edges), `"normal"` or `"fine"` (2 × 2 times the pixels); `export --quality` overrides it)",
        R"(`"normal"`)"},
       &SceneKeys::quality,
       [](const Scene& scene) {
         return scene.quality != usual().quality ? toml(name_of(scene.quality)) : "";
       }},
      {{"caption",
        "one line in the picture, at most 120 characters; formulas between `$` without macros, else plain "
        "text",
        "none"},
       &SceneKeys::caption,
       [](const Scene& scene) { return !scene.caption.empty() ? toml(scene.caption) : ""; }},
      {{"meters",
        R"(plots against time beside the figure of a page, over `duration`: a list of `"omega"` (ω in the body), `"energy"` (T), `"momentum"` (\|L\|, under torque also L in space), `"drift"` (of T, \|L\| and the direction of L from their start); `[]` for none)",
        R"(`["omega", "drift"]`, under torque `["omega", "energy", "momentum"]`)"},
       &SceneKeys::meters,
       [](const Scene& scene) { return scene.meters ? text_of(*scene.meters) : ""; }},
  });
  return kRows;
}

std::vector<PlacedText> SceneKeys::read(const TomlTable& table) {
  std::vector<KeyHandler> handlers;
  for (const Row& row : rows())
    handlers.push_back(
        {std::string(row.facts.name), [this, &row](const TomlEntry& e) { (this->*row.read)(e); }});
  read_keys(table, "the scene", handlers, report_);
  check_pivot(table);
  return std::move(highlighted_);
}

}  // namespace

Quat attitude_from(const std::vector<double>& wxyz) {
  // Scaled first: squares of the largest and smallest numbers are not finite or zero.
  double largest = 0;
  for (double x : wxyz) largest = std::max(largest, std::abs(x));
  return Quat(wxyz[0] / largest, wxyz[1] / largest, wxyz[2] / largest, wxyz[3] / largest).normalized();
}

Scene finished(const Scene& scene, const LessonBodies& bodies) {
  Scene finished = scene;
  if (auto body = body_of(scene, bodies)) finished.body = std::move(body).value();
  return finished;
}

std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        LessonScene& scene, TextReader& texts) {
  return SceneKeys(bodies, scene, texts).read(table);
}

std::vector<SceneKeyFacts> scene_key_facts() {
  std::vector<SceneKeyFacts> facts;
  for (const SceneKeys::Row& row : SceneKeys::rows()) facts.push_back(row.facts);
  return facts;
}

std::string scene_keys_text(Scene scene, double still_s) {
  scene.still_s = still_s;
  std::string text;
  for (const SceneKeys::Row& row : SceneKeys::rows())
    if (const std::string value = row.text(scene); !value.empty())
      text += std::string(row.facts.name) + " = " + value + '\n';
  return text;
}

}  // namespace polhode
