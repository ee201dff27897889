// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/scene_keys.h"

#include "base/spelling.h"
#include "base/utf8.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/toml_text.h"
#include "lessons/reader/reader.h"
#include "lessons/reader/scene/camera_keys.h"
#include "lessons/reader/scene/mark_keys.h"
#include "lessons/reader/scene/motion_keys.h"
#include "lessons/reader/scene/plot_keys.h"
#include "lessons/reader/scene/scene_values.h"
#include "lessons/reader/scene/varied_scene.h"
#include "physics/body/torque_text.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace polhode {
namespace {

constexpr std::size_t kMaxViews = 2;
static_assert(kMaxOverlays >= kOverlayCount);

// One table's keys into one scene.
class SceneKeys {
 public:
  /// Where the table stands: what it may say.
  enum class Of { front_matter, fence, scenes, row };

  /// `begin` is where the table begins.
  SceneKeys(const LessonBodies& bodies, const SceneWords& words, LessonScene& scene, TextReader& texts, Of of,
            SourcePlace begin)
      : bodies_(bodies),
        words_(words),
        of_(of),
        begin_(begin),
        lesson_scene_(scene),
        scene_(scene.scene),
        caption_(scene.caption),
        shown_(scene.shown),
        texts_(texts),
        report_(texts.report()) {}

  std::vector<PlacedText> read(const TomlTable& table);

  /// All that is known of a key. To add one: a row of the table and a reader here; the rest stands in
  /// ARCHITECTURE.md, "To add one".
  struct Row {
    SceneKeyFacts facts;
    void (SceneKeys::*read)(const TomlEntry&);
    /// The value; empty where the scene leaves it to what follows from the rest.
    std::string (*text)(const Scene&);
    /// Of the motion, which rows of tables can change too; of the picture; or of all scenes side by side or
    /// none, which is not said in their own tables.
    enum class Speaks { of_motion, of_picture, of_all } speaks;
  };
  static std::span<const Row> rows();

 private:
  /// A key that does not belong into this table is an error.
  void read(const Row& row, const TomlEntry& entry) {
    const std::string key = in_quotes(entry.key);
    const bool shows_several = entry.key == "scenes" || entry.key == "vary";
    if (of_ == Of::row && row.speaks != Row::Speaks::of_motion)
      report_.error(entry.place, key + " is of a picture, and the rows of a table are motions",
                    "a row has " + motion_keys());
    else if (of_ == Of::scenes && shows_several)
      report_.error(entry.place, "a scene beside others has no " + key + " of its own");
    else if (of_ == Of::scenes && row.speaks == Row::Speaks::of_all)
      report_.error(entry.place, key + " is the same for all scenes side by side",
                    "write it beside \"scenes\", not in it");
    else if (of_ == Of::front_matter && shows_several)
      report_.error(entry.place, key + " belongs to a step", "write it in a ```scene fence");
    else
      (this->*row.read)(entry);
  }

  /// "body, omega, …": the keys of the motion.
  static std::string motion_keys();
  /// But of numbers of a start, which a scene has not any more.
  static std::string text_of_variations(const Scene& scene);
  /// Of the scenes side by side: tables of what differs from the first, which is written by itself.
  static std::string text_of_scenes(const Scene& scene);

  template <class T, class U>
  static void assign(T& target, const std::optional<U>& value) {
    if (value) target = *value;
  }

  void omega(const TomlEntry& entry) { assign(scene_.w0_B, read_vector(entry, report_)); }
  void velocity(const TomlEntry& entry) { assign(scene_.v0_S, read_vector(entry, report_)); }
  void force(const TomlEntry& entry) {
    const auto* name = entry.value.as<std::string>();
    lesson_scene_.falls = name != nullptr && *name == "weight";
    if (lesson_scene_.falls)
      scene_.F_S = Vec3::Zero();
    else if (name != nullptr)
      report_unknown("force", {*name, entry.value.place}, {"weight", "[x, y, z]"}, report_);
    else
      assign(scene_.F_S, read_vector(entry, report_));
  }
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
      report_unknown("body", {*name, entry.value.place}, known, report_);
    }
  }

  void attitude(const TomlEntry& entry) {
    if (const auto read = read_attitude(entry, report_)) scene_.attitude = read;
  }

  void start(const TomlEntry& entry) { lesson_scene_.start = read_top_start(entry, report_); }

  void torque(const TomlEntry& entry) {
    const auto texts = read_texts(entry, kMaxTorqueTerms, report_);
    if (!texts) return;
    Torque torque;
    bool weighs = false;
    for (const PlacedText& text : *texts) {
      if (text.text == "weight") {
        if (weighs) report_.error(text.place, "\"weight\" is there already");
        weighs = true;
      } else if (const Result<TorqueTerm> term = parse_torque_term(text.text)) {
        torque.push_back(*term);
      } else {
        const bool has_numbers = text.text.find(':') != text.text.npos;
        report_.error(text.place, "torque: " + term.error(),
                      has_numbers ? "" : "or \"weight\": gravity on a body with a pivot_m");
      }
    }
    if (weighs && has_heavy(torque))
      report_.error(entry.value.place, "\"weight\" and \"heavy\" are both gravity", "leave one out");
    scene_.torque = std::move(torque);
    lesson_scene_.weighs = weighs;
  }

  /// The first of the keys that the table has; null: none.
  static const TomlEntry* first_of(const TomlTable& table, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (const TomlEntry* entry = table.find(key)) return entry;
    return nullptr;
  }

  /// A start is ω and attitude in one: a later scene may change either of them, or both by another start.
  void take_start_apart(const TomlTable& table) {
    const TomlEntry* part = first_of(table, {"omega", "attitude"});
    if (part == nullptr) return;
    if (const TomlEntry* start = table.find("start"))
      report_.error(start->place, "a scene has a start, or omega and attitude, not both",
                    "leave out " + in_quotes(part->key) + ", or write it in place of the start");
    if (!lesson_scene_.start) return;
    const Scene before = finished(lesson_scene_, bodies_);
    scene_.w0_B = before.w0_B;
    scene_.attitude = before.attitude;
    lesson_scene_.start.reset();
  }

  /// Said where a table names what is at fault, or where it is shown first; not again on steps that go on
  /// with it.
  void say(const SceneFault& fault, const TomlEntry* named) {
    if (named == nullptr && (lesson_scene_.fault_said || of_ == Of::front_matter)) return;
    report_.error(named != nullptr ? named->value.place : begin_, fault.message, fault.hint);
    lesson_scene_.fault_said = true;
  }

  void check_scene(const TomlTable& table) {
    if (!lesson_scene_.scenes) check_held(table);  // else each of them is held against it
    check_pushed(table);
  }

  void check_held(const TomlTable& table) {
    const FinishedScene finished = finish(lesson_scene_, bodies_);
    const bool is_of_top = lesson_scene_.weighs || lesson_scene_.start;
    const bool may_follow =
        of_ == Of::front_matter && !(table.find("body") != nullptr && table.find("torque") != nullptr);
    const bool is_known = bodies_.complete || !lesson_scene_.weighs;  // else the body's fault was said
    if (!finished.of_weight && !finished.of_start) {
      lesson_scene_.fault_said = false;
    } else if (!(is_of_top && may_follow) && is_known) {
      if (finished.of_weight) say(*finished.of_weight, first_of(table, {"torque", "body"}));
      if (finished.of_start) say(*finished.of_start, first_of(table, {"start", "torque", "body"}));
    }
  }

  void check_pushed(const TomlTable& table) {
    const bool is_free = !lesson_scene_.weighs && !has_heavy(scene_.torque);
    const bool is_pushed = !scene_.v0_S.isZero(0.0) || !scene_.F_S.isZero(0.0) || lesson_scene_.falls;
    const TomlEntry* named = first_of(table, {"force", "velocity", "torque"});
    if (named != nullptr && !is_free && is_pushed)
      report_.error(
          named->value.place,
          "a body that is held at a pivot does not follow a velocity or force of its centre of mass",
          "leave them out, or write velocity = [0, 0, 0] and force = [0, 0, 0]");
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
      report_unknown("arrow", {*name, entry.value.place}, {"space", "body", "free"}, report_);
  }

  void views(const TomlEntry& entry) {
    const auto names = read_texts(entry, kMaxViews, report_);
    if (!names) return;
    std::vector<View> views;
    for (const PlacedText& name : *names) {
      if (name.text != "space" && name.text != "body") {
        report_unknown("view", name, {"space", "body"}, report_);
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
        report_unknown("overlay", name, overlay_names(), report_);
      else if (shown.contains(*overlay))
        report_.warning(name.place, in_quotes(name.text) + " is shown already");
      else {
        shown.insert(*overlay);
        shown_.push_back(name);
      }
    }
    scene_.show = shown;
  }

  /// By the reader of its key.
  template <class Read>
  void marks(const TomlEntry& entry, const Read& read) {
    lesson_scene_.labels[entry.key] =
        std::make_shared<const RichText>(read(entry, words_, scene_.marks, texts_));
  }
  void trails(const TomlEntry& entry) { marks(entry, read_trails); }
  void arrows(const TomlEntry& entry) { marks(entry, read_arrows); }
  void angles(const TomlEntry& entry) { marks(entry, read_angles); }
  void areas(const TomlEntry& entry) { marks(entry, read_areas); }
  void lines(const TomlEntry& entry) { marks(entry, read_lines); }
  void planes(const TomlEntry& entry) { marks(entry, read_planes); }
  void notes(const TomlEntry& entry) { marks(entry, read_notes); }
  void motion(const TomlEntry& entry) { scene_.motion = read_motion(entry, report_); }
  void compare(const TomlEntry& entry) { assign(scene_.compared, read_compared(entry, report_)); }
  void camera(const TomlEntry& entry) { assign(scene_.camera, read_camera(entry, report_)); }

  void poses(const TomlEntry& entry) {
    const TomlTable* table = read_table(entry, "poses = { count = 5, over = 0.8 }", report_);
    if (table == nullptr) return;
    if (table->entries.empty()) {
      scene_.poses = {};
      return;
    }
    std::optional<double> count, over_s;
    read_keys(*table, "poses",
              {{"count", [&](const TomlEntry& e) { count = read_positive_number(e, report_); }},
               {"over", [&](const TomlEntry& e) { over_s = read_positive_number(e, report_); }}},
              report_);
    for (const char* key : {"count", "over"})
      if (table->find(key) == nullptr)
        report_.error(entry.value.place, "poses need " + in_quotes(key),
                      "write poses = { count = 5, over = 0.8 }");
    if (!count || !over_s) return;
    if (*count != std::floor(*count) || *count > kMostPoses)
      report_.error(table->find("count")->value.place,
                    fmt::format("\"count\" is a whole number from 1 to {}", kMostPoses));
    else
      scene_.poses = {static_cast<int>(*count), *over_s};
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
      report_unknown("quality", {*name, entry.value.place}, quality_level_names(), report_);
    }
  }

  void same(const TomlEntry& entry) {
    const auto why = read_text(entry, report_);
    if (!why) return;
    if (of_ == Of::front_matter)
      report_.error(entry.place, "a picture stays from one step to the next",
                    "write it in a step's ```scene");
    else if (is_blank(*why))
      report_.error(entry.value.place, "it does not say why the picture stays",
                    "same = \"a question about it\"");
    else
      lesson_scene_.same = *why;
  }

  void from(const TomlEntry& entry) {
    const auto id = read_text(entry, report_);
    if (!id) return;
    if (of_ == Of::front_matter)
      report_.error(entry.place, "what a slide recalls is of one step", "write it in a step's ```scene");
    else
      lesson_scene_.from = *id;
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

  void caption_when(const TomlEntry& entry) {
    const auto when = read_text(entry, report_);
    if (!when) return;
    if (*when == "still" || *when == "always")
      scene_.caption_when = *when == "still" ? CaptionWhen::still : CaptionWhen::always;
    else
      report_unknown("moment", {*when, entry.value.place}, {"always", "still"}, report_);
  }

  void meters(const TomlEntry& entry) { assign(scene_.meters, read_plots(entry, words_, texts_)); }

  void scenes(const TomlEntry& entry) {
    static constexpr const char* kExample =
        "write scenes = [{ omega = [0, 0.1, 3] }, { omega = [0, 3, 0.1] }]";
    const auto* list = entry.value.as<TomlArray>();
    if (list == nullptr) {
      report_.error(entry.value.place,
                    "\"scenes\" takes a list of tables, found " + std::string(entry.value.kind()), kExample);
      return;
    }
    const auto no_table = std::find_if(
        list->begin(), list->end(), [](const TomlValue& value) { return value.as<TomlTable>() == nullptr; });
    if (no_table != list->end()) {
      report_.error(no_table->place,
                    "\"scenes\" takes a list of tables, found " + std::string(no_table->kind()) + " in it",
                    kExample);
    } else if (list->size() == 1 || list->size() > kMaxScenes) {
      report_.error(entry.value.place,
                    "two or three scenes can stand side by side, found " + std::to_string(list->size()),
                    list->size() == 1 ? "write its keys beside the others, without \"scenes\"" : "");
    } else {
      lesson_scene_.scenes = list->empty() ? nullptr : std::make_shared<const TomlArray>(*list);
    }
  }

  void vary(const TomlEntry& entry) {
    scene_.vary.clear();
    lesson_scene_.vary_places.clear();
    const TomlTable* table = read_table(entry, "vary = { omega3 = { from = 1, to = 9 } }", report_);
    if (table == nullptr) return;
    if (table->entries.size() > kMaxVariations)
      report_.error(entry.value.place,
                    "at most two numbers can be varied, found " + std::to_string(table->entries.size()));
    std::vector<KeyHandler> numbers;
    for (const VariedNumber& number : varied_numbers())
      numbers.push_back({std::string(number.name), [this](const TomlEntry& e) { vary_number(e); }});
    TomlTable in_order = *table;  // of the text: the first is that of the filmstrip
    std::sort(in_order.entries.begin(), in_order.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    read_keys(in_order, "\"vary\"", numbers, report_);
  }

  void vary_number(const TomlEntry& entry) {
    const auto* table = entry.value.as<TomlTable>();
    std::optional<double> from, to;
    if (table != nullptr)
      read_keys(*table, in_quotes(entry.key),
                {{"from", [&](const TomlEntry& e) { from = read_number(e, report_); }},
                 {"to", [&](const TomlEntry& e) { to = read_number(e, report_); }}},
                report_);
    if (table == nullptr || table->find("from") == nullptr || table->find("to") == nullptr)
      report_.error(entry.value.place, in_quotes(entry.key) + " is varied from a number to a larger one",
                    "write " + entry.key + " = { from = 1, to = 9 }");
    if (!from || !to) return;
    if (*from < *to && scene_.vary.size() < kMaxVariations) {
      scene_.vary.push_back({entry.key, *from, *to, 0});
      lesson_scene_.vary_places.push_back(entry.place);
    } else if (*from >= *to) {
      report_.error(table->find("to")->value.place,
                    "\"to\" must be larger than \"from\", which is " + toml(*from));
    }
  }

  const LessonBodies& bodies_;
  const SceneWords& words_;
  const Of of_;
  const SourcePlace begin_;
  LessonScene& lesson_scene_;
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
  // No std::to_array: clang 14 destroys the temporary array at each call, made or not.
  static const Row kRows[] = {
      {{"body", "name of a body", R"(`"textbook"`)"},
       &SceneKeys::body,
       [](const Scene& scene) { return toml(scene.body.name.c_str()); },
       Row::Speaks::of_motion},
      {{"omega", "`[ω1, ω2, ω3]`, rad/s, body axes, at t = 0", "`[0.2, 0.1, 3.0]`"},
       &SceneKeys::omega,
       [](const Scene& scene) { return toml(scene.w0_B); },
       Row::Speaks::of_motion},
      {{"attitude", R"(`"L-down"`, `"L-up"`, or the quaternion `[w, x, y, z]` body → space)",
        "L down with `plane`, else up"},
       &SceneKeys::attitude,
       [](const Scene& scene) { return scene.attitude ? text_of(*scene.attitude) : ""; },
       Row::Speaks::of_motion},
      {{"start",
        "`{ theta_deg, phi_deg, psi_deg, spin, precession }`: how a top is set going, in place of `omega` "
        "and `attitude` (Tops, below)",
        "none"},
       &SceneKeys::start,
       [](const Scene&) { return std::string(); },  // a scene has the ω and attitude that it stands for
       Row::Speaks::of_motion},
      {{"torque",
        fmt::format(
            R"(a string or up to {}: `"weight"` (Tops, below) `"space:x,y,z"` `"body:x,y,z"` `"heavy:MGR,ax,ay,az"` `"damping:C"` `"sink:C"`)",
            kMaxTorqueTerms),
        "none"},
       &SceneKeys::torque,
       [](const Scene& scene) { return text_of(scene.torque); },
       Row::Speaks::of_motion},
      {{"velocity",
        "`[x, y, z]`, m/s, space axes: velocity of the centre of mass at t = 0; the mass is the body's "
        "`mass_kg`, else 1 kg",
        "`[0, 0, 0]`"},
       &SceneKeys::velocity,
       [](const Scene& scene) { return toml(scene.v0_S); },
       Row::Speaks::of_motion},
      {{"force",
        R"(`[x, y, z]`, N, space axes: a constant force on the centre of mass; or `"weight"`, that of its mass, along −z)",
        "`[0, 0, 0]`"},
       &SceneKeys::force,
       [](const Scene& scene) { return toml(scene.F_S); },
       Row::Speaks::of_motion},
      {{"arrow", R"(what holds the arrow A of `transport`: `"space"`, `"body"`, or nothing: `"free"`)",
        R"(`"space"`)"},
       &SceneKeys::arrow,
       [](const Scene& scene) { return text_of(scene.arrow); },
       Row::Speaks::of_motion},
      {{"motion",
        R"(a method (below), or `{ method = "rk4", step = 0.02 }`, `{ method = "dormand-prince-8", tolerance = 1e-10 }`; step in s; `ghost = true` draws the exact body, translucent, beside the computed one)",
        R"(without torque `"exact"`, for a symmetric top under its weight alone `"lagrange-top"`, else `"dormand-prince-8"`)"},
       &SceneKeys::motion,
       [](const Scene& scene) { return text_of(scene.motion); },
       Row::Speaks::of_motion},
      {{"views", R"(`"space"`, `"body"`, or both in a list)", R"(`"space"`)"},
       &SceneKeys::views,
       [](const Scene& scene) { return text_of(scene.views); },
       Row::Speaks::of_picture},
      {{"show", fmt::format("list of overlays, at most {}", kMaxOverlays), "none"},
       &SceneKeys::show,
       [](const Scene& scene) { return text_of(scene.show); },
       Row::Speaks::of_picture},
      {{"compare",
        R"(which methods `order-plot` and `method-table` show, and against what `order-plot` draws the error: `{ methods = ["rk4", "splitting"], against = "evaluations" }`, or `"steps"`)",
        "all that serve, steps"},
       &SceneKeys::compare,
       [](const Scene& scene) { return text_of(scene.compared); },
       Row::Speaks::of_picture},
      {{"trails", R"(paths of tips: `[{ of = "e3", on = "sphere", role }]` (Marks, below))", "none"},
       &SceneKeys::trails,
       [](const Scene& scene) { return text_of(scene.marks.trails); },
       Row::Speaks::of_picture},
      {{"arrows", R"~(vectors: `[{ of = "ddt(e3)", at = "e3", tex, name_at, length, like, role }]` (Marks))~",
        "none"},
       &SceneKeys::arrows,
       [](const Scene& scene) { return text_of(scene.marks.arrows); },
       Row::Speaks::of_picture},
      {{"angles", R"(arcs: `[{ from = "ez", to = "e3", tex = '\theta', at }]` (Marks))", "none"},
       &SceneKeys::angles,
       [](const Scene& scene) { return text_of(scene.marks.angles); },
       Row::Speaks::of_picture},
      {{"areas", R"(parallelograms: `[{ from = "omega", to = "L", tex, role }]` (Marks))", "none"},
       &SceneKeys::areas,
       [](const Scene& scene) { return text_of(scene.marks.areas); },
       Row::Speaks::of_picture},
      {{"lines", R"(dashed lines: `[{ from = "omega", to = "e3" }]` (Marks))", "none"},
       &SceneKeys::lines,
       [](const Scene& scene) { return text_of(scene.marks.lines); },
       Row::Speaks::of_picture},
      {{"planes", R"(discs: `[{ normal = "L", through = "omega" }]` (Marks))", "none"},
       &SceneKeys::planes,
       [](const Scene& scene) { return text_of(scene.marks.planes); },
       Row::Speaks::of_picture},
      {{"notes", R"(lines of text: `[{ text = "nose", at = "e3", role }]` (Marks))", "none"},
       &SceneKeys::notes,
       [](const Scene& scene) { return text_of(scene.marks.notes); },
       Row::Speaks::of_picture},
      {{"poses",
        fmt::format(
            "the body of a scene with `velocity` or `force` as it was before, pale: `{{ count = 5, over = "
            "0.8 }}`, 1 to {} times, evenly over the last 0.8 s, none before t = 0; `{{}}` for none",
            kMostPoses),
        "none"},
       &SceneKeys::poses,
       [](const Scene& scene) {
         return scene.poses.count == 0
                    ? "{}"
                    : fmt::format("{{ count = {}, over = {} }}", scene.poses.count, toml(scene.poses.over_s));
       },
       Row::Speaks::of_picture},
      {{"camera",
        fmt::format(
            "`{{ azimuth_deg, elevation_deg, distance, zoom, hold, fitted }}`: it stands at this angle"
            " from x towards y (1 towards 2 where the body is at rest) and so far above, and what the scene"
            " shows over its whole film fills the picture, or with `hold = \"still\"` what the still shows;"
            " the larger the distance (from 1.3), the less what is near looks larger; zoom makes all larger"
            " than that; `{{}}` is the default again; `fitted = {{ azimuth_deg, elevation_deg, omega, "
            "attitude }}` "
            "keeps the frame that fills the"
            " picture from there, of the scene that begins with that ω and attitude; elevation −{0} to {0}, "
            "distance and"
            " zoom {1} to {2}",
            kMostElevationDeg, kLeastCameraScale, kMostCameraScale),
        "34.4°, 20°, 4.2, 1"},
       &SceneKeys::camera,
       [](const Scene& scene) { return text_of(scene.camera); },
       Row::Speaks::of_picture},
      {{"at", "the t of a still, s", "0"},
       &SceneKeys::at,
       [](const Scene& scene) { return toml(scene.at_s); },
       Row::Speaks::of_all},
      {{"still",
        "the t of a still, s, where lengths of arrows under torque and the methods' tables are to be those "
        "of `at`",
        "`at`"},
       &SceneKeys::still,
       [](const Scene& scene) { return scene.still_s ? toml(*scene.still_s) : ""; },
       Row::Speaks::of_all},
      {{"duration", "what curves over time cover, s", "one polhode period or turn"},
       &SceneKeys::duration,
       [](const Scene& scene) { return scene.duration_s ? toml(*scene.duration_s) : ""; },
       Row::Speaks::of_all},
      {{"rate", "simulated seconds per shown second",
        "one polhode period (or turn; under torque four turns) in 8 s"},
       &SceneKeys::rate,
       [](const Scene& scene) { return scene.rate ? toml(*scene.rate) : ""; },
       Row::Speaks::of_all},
      {{"highlight",
        fmt::format(
            R"(overlays, which are drawn bolder, or ids of `\term`s of the stage, which are marked on its pages; at most {})",
            kMaxHighlights),
        "none"},
       &SceneKeys::highlight,
       [](const Scene& scene) { return toml_list(scene.highlight); },
       Row::Speaks::of_picture},
      {{"quality",
        R"(how finely pictures are drawn: `"draft"` (solid bodies with jagged edges), `"normal"` or `"fine"` (2 × 2 times the pixels); `export --quality` overrides it)",
        R"(`"normal"`)"},
       &SceneKeys::quality,
       [](const Scene& scene) { return toml(name_of(scene.quality)); },
       Row::Speaks::of_all},
      {{"caption",
        fmt::format("one line below the picture, at most {} characters; formulas between `$` without macros, "
                    "computed numbers too, else plain text",
                    kMaxCaptionCharacters),
        "none"},
       &SceneKeys::caption,
       [](const Scene& scene) { return !scene.caption.empty() ? toml(scene.caption) : ""; },
       Row::Speaks::of_picture},
      {{"caption_when",
        R"(when the caption is true: `"always"`, or `"still"`: at the t of the still alone, so that it is left out while the motion plays and in films; a new caption is one for always)",
        R"(`"always"`)"},
       &SceneKeys::caption_when,
       [](const Scene& scene) { return toml(scene.caption_when == CaptionWhen::still ? "still" : "always"); },
       Row::Speaks::of_picture},
      {{"meters",
        fmt::format(
            R"(plots beside the figure of a page: a list of up to {} of `"omega"` (ω in the body), `"energy"` (T), `"momentum"` (\|L\|, under torque also L in space), `"drift"` (of T, \|L\| and the direction of L from their start), each against time over `duration`, and of plots of your own (Plots, below))",
            kMaxPlots),
        "none"},
       &SceneKeys::meters,
       [](const Scene& scene) { return plots_text(scene.meters); },
       Row::Speaks::of_picture},
      {{"scenes", "two or three tables of these keys: scenes side by side (below); `[]` for none", "none"},
       &SceneKeys::scenes,
       text_of_scenes,
       Row::Speaks::of_all},
      {{"vary",
        "one or two numbers of the scene, `{ omega3 = { from = 1, to = 9 } }`: a slider in the window, a "
        "filmstrip on paper (below); `{}` for none",
        "none"},
       &SceneKeys::vary,
       text_of_variations,
       Row::Speaks::of_all},
      {{"same",
        R"(why the picture is that of the step before: `"a question about it"`; of this step alone, which `lint` then does not warn of)",
        "the picture changes"},
       &SceneKeys::same,
       [](const Scene&) { return std::string(); },
       Row::Speaks::of_all},
      {{"from",
        R"(the formula that the slide recalls at its foot, "from before", and the page to read at its top: `"EQUATION"` of this stage, `"STAGE/EQUATION"`, or `"none"`; of this step alone)",
        "of slides that of the nearest earlier step of the stage that has one: its first with a number, else "
        "its first; of pages to read none, for it stands on a page before"},
       &SceneKeys::from,
       [](const Scene&) { return std::string(); },
       Row::Speaks::of_all},
  };
  return kRows;
}

std::string SceneKeys::motion_keys() {
  std::string names;
  for (const Row& row : rows())
    if (row.speaks == Row::Speaks::of_motion)
      names += (names.empty() ? "" : ", ") + std::string(row.facts.name);
  return names;
}

/// The plots are those of the first, where nothing else is said.
Scene without_plots(Scene scene) {
  scene.meters.clear();
  return scene;
}

std::string SceneKeys::text_of_scenes(const Scene& scene) {
  if (scene.beside.empty() || !scene.vary.empty()) return {};
  const Scene like_first = without_plots(scene);
  std::string text = "[\n  {},\n";
  for (const Scene& other : scene.beside) {
    const Scene complete = completed(other);
    std::string keys;
    for (const Row& row : rows()) {
      if (row.speaks == Row::Speaks::of_all) continue;
      const bool is_default_again = row.facts.name == "caption_when" && other.caption != scene.caption;
      const std::string inherited = row.text(is_default_again ? usual() : like_first);
      if (row.text(other) == inherited) continue;
      const std::string value = row.text(other);
      keys += (keys.empty() ? "" : ", ") + std::string(row.facts.name) + " = ";
      keys += !value.empty() ? value : row.facts.name == "caption" ? toml("") : row.text(complete);
    }
    text += keys.empty() ? "  {},\n" : "  { " + keys + " },\n";
  }
  return text + ']';
}

std::string SceneKeys::text_of_variations(const Scene& scene) {
  std::string text;
  for (const Variation& number : scene.vary)
    if (!is_of_start(number.number))
      text += (text.empty() ? "{ " : ", ") + number.number + " = { from = " + toml(number.from) +
              ", to = " + toml(number.to) + " }";
  return text.empty() ? text : text + " }";
}

std::vector<PlacedText> SceneKeys::read(const TomlTable& table) {
  constexpr std::array<std::string_view, 2> kOfRow{"head", "at"};  // its table reads them
  const auto is_of_row = [&](std::string_view key) {
    return of_ == Of::row && std::ranges::find(kOfRow, key) != kOfRow.end();
  };
  const auto read_key = [&](const TomlEntry& entry) {
    if (is_of_row(entry.key)) return true;
    const auto row = std::ranges::find(rows(), entry.key, [](const Row& one) { return one.facts.name; });
    if (row == rows().end()) return false;
    read(*row, entry);
    return true;
  };
  const auto known = [&] {
    std::vector<std::string> names;
    for (const Row& row : rows())
      if ((of_ != Of::row || row.speaks == Row::Speaks::of_motion) && !is_of_row(row.facts.name))
        names.emplace_back(row.facts.name);
    if (of_ == Of::row) names.insert(names.end(), kOfRow.begin(), kOfRow.end());
    return names;
  };
  take_start_apart(table);
  if (table.find("caption") != nullptr) scene_.caption_when = CaptionWhen::always;
  read_keys(table, of_ == Of::row ? "a row" : "the scene", read_key, known, report_);
  check_scene(table);
  return std::move(highlighted_);
}

}  // namespace

Quat attitude_from(const std::vector<double>& wxyz) {
  // Scaled first: squares of the largest and smallest numbers are not finite or zero.
  double largest = 0;
  for (double x : wxyz) largest = std::max(largest, std::abs(x));
  return Quat(wxyz[0] / largest, wxyz[1] / largest, wxyz[2] / largest, wxyz[3] / largest).normalized();
}

std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        const SceneWords& words, LessonScene& scene, TextReader& texts,
                                        std::optional<SourcePlace> fence) {
  using Of = SceneKeys::Of;
  return SceneKeys(bodies, words, scene, texts, fence ? Of::fence : Of::front_matter,
                   fence.value_or(SourcePlace{}))
      .read(table);
}

std::vector<LessonScene> side_by_side(const LessonScene& scene, const LessonBodies& bodies,
                                      const SceneWords& words, TextReader& texts,
                                      std::vector<PlacedText>& highlighted) {
  if (!scene.scenes) return std::vector<LessonScene>(1, scene);  // a list would be copied
  std::vector<LessonScene> scenes;
  for (const TomlValue& entry : *scene.scenes) {
    LessonScene& one = scenes.emplace_back(scene);
    one.scenes = nullptr;
    if (scenes.size() > 1) one.scene = without_plots(std::move(one.scene));
    SceneKeys keys(bodies, words, one, texts, SceneKeys::Of::scenes, entry.place);
    std::vector<PlacedText> names = keys.read(*entry.as<TomlTable>());
    std::move(names.begin(), names.end(), std::back_inserter(highlighted));
  }
  return scenes;
}

LessonScene changed_motion(LessonScene scene, const TomlTable& table, SourcePlace begin,
                           const LessonBodies& bodies, const SceneWords& words, TextReader& texts) {
  SceneKeys(bodies, words, scene, texts, SceneKeys::Of::row, begin).read(table);
  return scene;
}

std::vector<SceneKeyFacts> scene_key_facts() {
  std::vector<SceneKeyFacts> facts;
  for (const SceneKeys::Row& row : SceneKeys::rows()) facts.push_back(row.facts);
  return facts;
}

namespace {

/// Whether a lesson need not say it. One may have a body of its own by the name of the default.
bool is_default(const SceneKeys::Row& row, const Scene& scene) {
  if (row.facts.name == "body") return scene.body == usual().body;
  return row.text(scene) == row.text(usual());
}

}  // namespace

std::string scene_keys_text(Scene scene, double still_s) {
  scene.still_s = still_s != scene.at_s ? std::optional(still_s) : std::nullopt;
  std::string text;
  for (const SceneKeys::Row& row : SceneKeys::rows())
    if (!is_default(row, scene)) text += std::string(row.facts.name) + " = " + row.text(scene) + '\n';
  return text;
}

std::string all_scene_keys_text(const Scene& scene) {
  const Scene complete = completed(scene);
  std::string text;
  for (const SceneKeys::Row& row : SceneKeys::rows()) {
    const std::string value = row.text(complete);
    if (!value.empty())
      text += std::string(row.facts.name) + " = " + value + (is_default(row, scene) ? "  # default\n" : "\n");
  }
  return text;
}

}  // namespace polhode
