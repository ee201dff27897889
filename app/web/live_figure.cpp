// SPDX-License-Identifier: MIT
#include "app/web/live_figure.h"

#include "app/page/live_numbers.h"
#include "app/page/page.h"
#include "app/page/plot_words.h"
#include "app/session/camera_moves.h"
#include "app/session/command.h"
#include "base/numbers.h"
#include "lessons/reader/reader.h"
#include "physics/method.h"
#include "render/gl/framebuffer.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace polhode {

namespace {

/// Some 2 s of a page that does nothing else meanwhile.
constexpr std::int64_t kCallBudget = 20'000'000;

const char* const kNoScene = "There is no figure here.";
const char* const kNoStep = "The lesson has no such step.";

/// The first error, as a sentence.
std::string first_error(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& found : diagnostics)
    if (found.severity == Severity::error) return found.message;
  return "The lesson cannot be read.";
}

Result<std::shared_ptr<const LoadedLesson>> loaded_of(LessonReading reading, std::string_view file_name) {
  if (!reading.lesson) return failure(first_error(reading.diagnostics));
  return std::make_shared<const LoadedLesson>(
      LoadedLesson{std::move(*reading.lesson), std::string(file_name), {}});
}

}  // namespace

LiveFigure::LiveFigure() = default;
LiveFigure::~LiveFigure() = default;

void LiveFigure::begin_call() {
  left_ = kCallBudget;
  refused_drag_.clear();
}

Effort LiveFigure::effort() {
  return [this](std::int64_t evaluations) {
    left_ = evaluations < left_ ? left_ - evaluations : 0;
    if (left_ == 0) throw BudgetSpent();
  };
}

// Lesson and place.

Status LiveFigure::open_lesson(std::string_view text, std::string_view file_name) {
  const auto loaded = loaded_of(read_stage(text, file_name, ""), file_name);
  if (!loaded) return failure(loaded.error());
  if (Status taken = take(*loaded); !taken) return taken;
  open_stage_ = "";
  return success();
}

/// The lesson with this stage read.
Result<std::shared_ptr<const LoadedLesson>> LiveFigure::with_stage(const std::string& id) const {
  if (!open_stage_ || *open_stage_ == id) return loaded_;
  const std::string file = loaded_->path.string();
  return loaded_of(read_stage(loaded_->lesson.source, file, id), file);
}

/// A slide shows what it goes on from, which may stand in another stage.
Status LiveFigure::read_whole() {
  if (!open_stage_) return success();
  const std::string file = loaded_->path.string();
  const auto loaded = loaded_of(read_lesson(loaded_->lesson.source, file), file);
  if (!loaded) return failure(loaded.error());
  const StepPlace place = session_->place();
  const SceneEdits edits = session_->edits();
  const double t_s = session_->t_s();
  if (Status taken = take(*loaded); !taken) return taken;
  session_->go_to(place);
  if (Status edited = edit(edits); !edited) return edited;
  session_->scrub_to(t_s);
  return success();
}

Status LiveFigure::open_scene(std::string_view scene_toml, std::string_view own_body_toml) {
  std::string text = "+++\nformat = 1\nid = \"scene\"\ntitle = \"A scene\"\n";
  if (!own_body_toml.empty()) text.append("[body.own]\n").append(own_body_toml).append("\n");
  text.append("+++\n\n# A scene {scene}\n\n```scene\n").append(scene_toml).append("\n```\n");
  const auto loaded = loaded_of(read_lesson(text, "scene.md"), "scene.md");
  if (!loaded) return failure(loaded.error());
  return take(*loaded);
}

Status LiveFigure::take(std::shared_ptr<const LoadedLesson> loaded) {
  std::unique_ptr<LessonSession> session;
  try {
    session = std::make_unique<LessonSession>(loaded, effort());
  } catch (const std::domain_error& error) {
    return failure(error.what());
  }
  session->preferences.theme = theme_;
  session->preferences.reduced_motion = true;  // lines that turn into others are the script's affair
  speech_ = std::make_unique<SpeechText>(loaded->lesson, effort());
  session_ = std::move(session);
  loaded_ = std::move(loaded);
  open_stage_.reset();
  ++lesson_number_;
  meter_.reset();
  slide_.reset();
  return success();
}

Status LiveFigure::show(std::size_t stage, std::size_t step) {
  if (!session_) return failure("No lesson is open.");
  if (stage < 1 || stage > session_->lesson().stages.size()) return failure(kNoStep);
  const std::string id = session_->lesson().stages[stage - 1].id;
  const auto loaded = with_stage(id);
  if (!loaded) return failure(loaded.error());
  const std::vector<Step>& steps = (*loaded)->lesson.stages[stage - 1].steps;
  if (step < 1 || step > steps.size()) return failure(kNoStep);
  if (steps[step - 1].scene == nullptr) return failure(kNoScene);
  if (*loaded != loaded_) {
    if (Status taken = take(*loaded); !taken) return taken;
    open_stage_ = id;
  }
  try {
    session_->go_to({stage - 1, step - 1});
  } catch (const std::domain_error& error) {
    return failure(error.what());
  }
  session_->set_playing(false);
  if (session_->edits().empty()) session_->reset_time();
  hand_.let_go();
  return success();
}

Status LiveFigure::show(std::string_view stage_id, std::size_t step) {
  if (!session_) return failure("No lesson is open.");
  const Stage* stage = session_->lesson().find_stage(stage_id);
  if (stage == nullptr) return failure("The lesson has no such stage.");
  return show(static_cast<std::size_t>(stage - session_->lesson().stages.data()) + 1, step);
}

// Pictures.

Result<const Fonts*> LiveFigure::fonts() {
  if (!fonts_) {
    Result<Fonts> opened = Fonts::open();
    if (!opened) return failure(opened.error());
    fonts_ = std::move(opened).value();
  }
  return &*fonts_;
}

Status LiveFigure::attach(std::unique_ptr<GlContext> context) {
  detach();
  const Result<const Fonts*> type = fonts();
  if (!type) return failure(type.error());
  auto drawing = std::make_unique<Drawing>();
  drawing->context = std::move(context);
  Result<Gl> gl = Gl::load(*drawing->context);
  if (!gl) return failure(gl.error());
  drawing->gl = std::make_unique<const Gl>(*gl);
  auto renderer = Renderer::create(*drawing->context, **type);
  if (!renderer) return failure(renderer.error());
  drawing->renderer = std::move(renderer).value();
  drawing_ = std::move(drawing);
  return success();
}

void LiveFigure::detach() {
  drawing_.reset();
  drawn_.reset();
}

int LiveFigure::height_for(int width) const {
  return model() && width > 0 ? picture_size_of(*model(), width).height : 0;
}

Status LiveFigure::lay_out(Size size, Picture what, double resolution) {
  if (!model()) return failure(kNoScene);
  if (size.width < 1 || size.height < 1) return failure("A picture has pixels.");
  if (!(resolution > 0) || resolution > 1)
    return failure("A part of the pixels is meant, above 0 and up to 1.");
  if (what == Picture::slide)
    if (Status whole = read_whole(); !whole) return whole;
  const Key key{
      session_->place(),  session_->model_number(), lesson_number_,  size,  what, resolution, session_->t_s(),
      session_->camera(), model()->scene.quality,   session_->lit(), theme_};
  if (laid_out_ == key) return success();
  Result<Page> page = compose(key);
  if (!page) return failure(page.error());
  page_ = std::move(page).value();
  laid_out_ = key;
  return success();
}

Status LiveFigure::draw(Size size, Picture what, double resolution) {
  if (Status composed = lay_out(size, what, resolution); !composed) return composed;
  if (!drawing_) return failure("There is no canvas to draw in.");
  if (drawn_ == laid_out_) return success();
  Drawing& on = *drawing_;
  if (!on.picture || on.picture->size() != size) {
    on.picture.reset();
    auto made = Framebuffer::create(*on.gl, size, 0);
    if (!made) return failure(made.error());
    on.picture = std::move(made).value();
  }
  const Background paper{Background::Kind::color, colors_of(theme_).paper};
  if (Status painted = on.renderer->paint(page_.sheet, page_.insets, paper, *on.picture); !painted)
    return failure(painted.error());
  on.picture->show();
  drawn_ = laid_out_;
  return success();
}

Result<Image> LiveFigure::read() const {
  if (!drawing_ || !drawing_->picture || !drawn_) return failure("Nothing was drawn.");
  return drawing_->picture->read();
}

Result<Page> LiveFigure::compose(const Key& key) {
  const Result<const Fonts*> type = fonts();
  if (!type) return failure(type.error());
  PageRequest request{.lesson = session_->lesson(),
                      .stage = session_->stage(),
                      .number = static_cast<int>(key.place.stage) + 1,
                      .step = static_cast<int>(key.place.step) + 1,
                      .model = model(),
                      .t_s = key.t_s,
                      .size = key.size,
                      .theme = key.theme,
                      .profile = key.what == Picture::slide ? Profile::slides : Profile::page,
                      .runs = key.what == Picture::slide};
  if (key.what == Picture::figure) {
    Page page = compose_picture(request, **type);
    for (Inset& inset : page.insets) inset.resolution = key.resolution;
    return page;
  }
  return compose_slide(request, key);
}

/// Its text is laid out once for all times.
Result<Page> LiveFigure::compose_slide(const PageRequest& asked, const Key& key) {
  const Fonts& type = *fonts_;
  PageRequest request = asked;
  const auto is_of = [&](const Key& kept) {
    return kept.place == key.place && kept.model_number == key.model_number &&
           kept.lesson_number == key.lesson_number && kept.size == key.size && kept.theme == key.theme;
  };
  if (!slide_ || !is_of(slide_->key)) {
    slide_.reset();
    const Result<SlideType> stage_type = slide_type_of(request, type);
    if (!stage_type) return failure(stage_type.error());
    request.slide_type = &*stage_type;
    Result<FittedText> text = text_of_page(request, type);
    if (!text) return failure(text.error());
    slide_ = Slide{key, *stage_type, std::move(text).value()};
  }
  request.slide_type = &slide_->type;
  Page page = compose_page(request, slide_->text, type);
  for (Inset& inset : page.insets) inset.resolution = key.resolution;
  return page;
}

// Hands.

FigureHand::On LiveFigure::point_down(const Vec2& at, double reach) {
  if (!session_ || !at.allFinite()) return FigureHand::On::nothing;
  last_ = at;
  return hand_.take(*session_, page_.insets, at, reach);
}

FigureHand::On LiveFigure::point_move(const Vec2& at, double reach) {
  if (!session_ || !at.allFinite()) return FigureHand::On::nothing;
  if (hand_.held() == FigureHand::On::nothing) return FigureHand::under(*session_, page_.insets, at, reach);
  const Vec2 by = at - last_;
  last_ = at;
  refused_drag_ = hand_.drag(*session_, page_.insets, at, by.x(), by.y());
  return hand_.held();
}

void LiveFigure::point_twice() {
  if (model()) session_->set_camera(session_->lesson_scene().camera);
}

void LiveFigure::zoom(double notches) {
  if (model()) session_->set_camera(zoomed(model()->scene.camera, notches));
}

void LiveFigure::turn(double dx, double dy) {
  if (model()) session_->set_camera(orbited(model()->scene.camera, dx, dy, 1.0));
}

Status LiveFigure::press_key(std::string_view key) {
  const auto command = command_of(key);
  if (!session_ || !command) return failure("No command has this key.");
  const std::string_view group = facts_of(*command).group;
  if ((group != "Time" && group != "Body") || !do_command(*session_, *command))
    return failure("This key is a command of the window alone.");
  return success();
}

// Time.

void LiveFigure::set_theme(Theme theme) {
  theme_ = theme;
  if (session_) session_->preferences.theme = theme;
}

void LiveFigure::set_playing(bool playing) {
  if (session_) session_->set_playing(playing);
}

bool LiveFigure::advance(double seconds) {
  if (!session_) return false;
  try {
    session_->advance(seconds);
  } catch (const BudgetSpent&) {
    session_->set_playing(false);
    throw;
  }
  return session_->is_moving();
}

Status LiveFigure::set_time(double t_s) {
  if (!model()) return failure(kNoScene);
  session_->scrub_to(t_s);
  if (session_->t_s() == t_s) return success();
  return failure("The motion cannot be followed to t = " + digits(t_s, 4) + " s.");
}

void LiveFigure::set_speed(double speed) {
  if (session_) session_->set_speed(speed);
}

// Changes.

void LiveFigure::begin_change() {
  if (session_) session_->begin_change();
}

Status LiveFigure::edit(const SceneEdits& edits) { return session_->set_edits(edits); }

Status LiveFigure::set_omega(const Vec3& w0_B) {
  if (!model()) return failure(kNoScene);
  if (!w0_B.allFinite()) return failure("Each component of ω has to be a number.");
  SceneEdits edits = session_->edits();
  edits.w0_B = w0_B;
  return edit(edits);
}

Status LiveFigure::set_attitude(const Quat& q_SB) {
  if (!model()) return failure(kNoScene);
  if (!q_SB.coeffs().allFinite() || !(q_SB.norm() > 0) || !std::isfinite(q_SB.norm()))
    return failure("An attitude has four numbers, not all of them 0.");
  SceneEdits edits = session_->edits();
  edits.attitude = q_SB.normalized();
  return edit(edits);
}

Status LiveFigure::set_moments(const Vec3& moments) {
  if (!model()) return failure(kNoScene);
  Result<Body> body = body_with_moments(moments);
  if (!body) return failure(body.error());
  SceneEdits edits = session_->edits();
  edits.body = std::move(body).value();
  return edit(edits);
}

Status LiveFigure::set_body(std::string_view name) {
  if (!model()) return failure(kNoScene);
  SceneEdits edits = session_->edits();
  if (name == session_->lesson_scene().body.name) {
    edits.body.reset();
    return edit(edits);
  }
  edits.body = find_body(name);
  if (!edits.body) return failure("No body has this name.");
  return edit(edits);
}

Status LiveFigure::vary(std::size_t number, double value) {
  if (!model()) return failure(kNoScene);
  return session_->vary(number, value);
}

Status LiveFigure::set_method(std::string_view name, double step) {
  if (!model()) return failure(kNoScene);
  SceneEdits edits = session_->edits();
  MotionSpec motion{.ghost = model()->scene.motion.ghost};
  if (!name.empty()) {
    motion.method = method_from(name);
    if (!motion.method) return failure("No method has this name.");
    const StepControl control = facts_of(*motion.method).control;
    if (control == StepControl::fixed) motion.step_s = step > 0 ? step : table_step_s(model()->scene);
    if (control == StepControl::adaptive && step > 0) motion.tolerance = step;
  }
  edits.motion = motion;
  return edit(edits);
}

Status LiveFigure::show_overlay(std::string_view name, bool shown) {
  if (!model()) return failure(kNoScene);
  SceneEdits edits = session_->edits();
  if (name == "ghost") {
    edits.motion = model()->scene.motion;
    edits.motion->ghost = shown;
    return edit(edits);
  }
  const auto overlay = overlay_from(name);
  if (!overlay) return failure("Nothing of this name can be shown.");
  set_shown(edits, session_->lesson_scene(), *overlay, shown);
  return edit(edits);
}

Status LiveFigure::set_camera(double azimuth_rad, double elevation_rad, double zoom) {
  if (!model()) return failure(kNoScene);
  if (!std::isfinite(azimuth_rad) || !std::isfinite(elevation_rad) || !std::isfinite(zoom))
    return failure("A camera has two angles and a zoom.");
  CameraSpec camera = model()->scene.camera;
  const bool stays = camera.azimuth_rad == azimuth_rad && camera.elevation_rad == elevation_rad;
  if (!stays) camera = turned_from_here(camera);
  camera.azimuth_rad = azimuth_rad;
  camera.elevation_rad = elevation_rad;
  camera.zoom = zoom;
  session_->set_camera(camera);
  return success();
}

Status LiveFigure::undo() {
  if (!session_ || !session_->undo()) return failure("There is nothing to undo.");
  return success();
}

Status LiveFigure::reset() {
  if (!model()) return failure(kNoScene);
  session_->reset_edits();
  session_->set_playing(false);
  session_->reset_time();
  return success();
}

void LiveFigure::light(std::string_view id) {
  if (session_) session_->light(std::string(id));
}

// What is said.

const AccuracyReading& LiveFigure::accuracy() {
  if (!meter_ || meter_of_ != session_->model_number()) {
    meter_ = std::make_unique<AccuracyMeter>(*model());
    meter_of_ = session_->model_number();
    accuracy_.reset();
  }
  if (!accuracy_ || accuracy_at_s_ != session_->t_s()) {
    accuracy_ = meter_->errors_at(*model(), session_->t_s());
    accuracy_at_s_ = session_->t_s();
  }
  return *accuracy_;
}

std::string LiveFigure::alt_text_now() {
  const Scene& scene = model()->scene;
  const Result<const Fonts*> type = fonts();
  return figure_in_words(*model(), speech_->words_of_scenes(session_->step(), scene), session_->t_s(),
                         *speech_, type ? *type : nullptr);
}

std::vector<std::string> LiveFigure::captions_now() {
  const double t_s = session_->t_s();
  const std::vector<const SceneModel*> shown = shown_models(*model());
  const std::vector<std::string> captions = captions_at(session_->lesson(), session_->step(), *model(), t_s);
  std::vector<std::string> said;
  for (std::size_t i = 0; i < captions.size(); ++i)
    if (!captions[i].empty() && caption_holds(shown[i]->scene, t_s))
      said.push_back(speech_->words_of_line(captions[i]));
  return said;
}

}  // namespace polhode
