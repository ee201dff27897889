// SPDX-License-Identifier: MIT
#include "app/session/saved/save_as.h"

#include "app/export/picture_export.h"
#include "app/export/picture_maker.h"
#include "app/export/picture_metadata.h"
#include "app/session/answers/answer_report.h"
#include "app/session/answers/progress.h"
#include "app/session/saved/saved_scene.h"
#include "base/files/atomic_file.h"
#include "render/image/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace fs = std::filesystem;

namespace {

const Equation* last_equation(const Step& step) {
  const auto equations = blocks_of<Equation>(step);
  return equations.empty() ? nullptr : equations.back();
}

const Ask* asked_derivation(const LessonSession& session) {
  const std::vector<const Ask*> asked = session.questions();
  const auto derives =
      std::find_if(asked.begin(), asked.end(), [](const Ask* ask) { return ask->derivation != nullptr; });
  return derives == asked.end() ? nullptr : *derives;
}

/// Where the step asks for one, as far as the reader has come, line by line. The line that it begins with is
/// the lesson's, and no derivation alone.
std::optional<Equation> derivation_of(const LessonSession& session) {
  const Lesson& lesson = session.lesson();
  const Ask* derives = asked_derivation(session);
  if (derives == nullptr) return std::nullopt;
  std::string lines;
  for (const ShownDerivedLine& line : session.shown_derivation().lines)
    if (line.certainty == Certainty::proved) lines += "\\\\ &" + line.tex;
  if (lines.empty()) return std::nullopt;
  Equation derivation;
  derivation.id = derives->id;
  derivation.tex = "\\begin{aligned} &" + derives->derivation->start.tex + lines + " \\end{aligned}";
  auto math = parse_math(derivation.tex, lesson.macros, lesson.about.language);
  if (!math) return std::nullopt;
  derivation.math = std::move(math).value();
  return derivation;
}

What what_of(SaveAs what) {
  if (what == SaveAs::figure) return What::figure;
  return what == SaveAs::equation ? What::equation : What::page;
}

/// "07-poinsot-step3", as export names it.
std::string stem_of(const LessonSession& session) {
  return fmt::format("{:02}-{}-step{}", session.place().stage + 1, session.stage().id,
                     session.place().step + 1);
}

/// A name that is not taken yet; one that cannot be looked at is left to the writing to refuse.
fs::path free_name(const fs::path& folder, const std::string& stem, const std::string& ending) {
  std::error_code error;
  fs::path path = folder / (stem + ending);
  for (int i = 2; fs::exists(fs::symlink_status(path, error)) && !error; ++i)
    path = folder / fmt::format("{}-{}{}", stem, i, ending);
  return path;
}

Result<fs::path> write_text(const fs::path& path, const std::string& text) {
  const Status written = write_file_atomically(path, bytes_of(text));
  if (!written) return failure(written.error());
  return path;
}

/// A figure stands before the studio; in the dark window before the ground that it has there.
std::string figure_background(Theme theme) {
  if (theme == Theme::paper) return "studio";
  const Color& ground = colors_of(theme).backdrop;
  const auto byte = [](float part) { return std::lround(255 * part); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(ground.r), byte(ground.g), byte(ground.b));
}

ExportOptions export_options_of(const LessonSession& session, SaveAs what, const SaveOptions& chosen) {
  ExportOptions options;
  options.what = what_of(what);
  options.each = Each::step;
  options.size = chosen.size;
  options.at_s = session.t_s();
  options.theme = session.preferences.theme;
  options.profile = Profile::page;
  options.text_scale = session.preferences.text_scale;
  if (what == SaveAs::equation) options.dpi = kDefaultEquationDpi;
  const bool is_figure = what == SaveAs::figure, is_on_dark = is_figure && options.theme == Theme::dark;
  options.background = chosen.transparent ? (is_on_dark ? "transparent-dark" : "transparent")
                       : is_figure        ? figure_background(options.theme)
                                          : "paper";
  return options;
}

/// Made by export's own maker.
Outcome<fs::path> save_picture(const LessonSession& session, SaveAs what, const SaveOptions& chosen,
                               const fs::path& folder, Renderer& renderer) {
  const ExportOptions options = export_options_of(session, what, chosen);
  const Equation* equation = what == SaveAs::equation ? last_equation(session.step()) : nullptr;
  std::optional<Equation> derivation;
  if (what == SaveAs::equation && equation == nullptr) derivation = derivation_of(session);
  if (derivation) equation = &*derivation;
  const PlannedPicture picture{.stage = &session.stage(),
                               .number = static_cast<int>(session.place().stage) + 1,
                               .step = static_cast<int>(session.place().step) + 1,
                               .scene = session.model() ? &session.model()->scene : nullptr,
                               .equation = equation,
                               .frame = {},
                               .file = {}};
  const MakerContext context{session.lesson(), options, renderer};
  const auto maker = what == SaveAs::figure     ? make_figure_maker(context)
                     : what == SaveAs::equation ? make_equation_maker(context)
                                                : make_page_maker(context);
  if (const Done checked = maker->check(picture); !checked) return passed_on(checked);
  const auto words = maker->describe(picture);
  if (!words) return passed_on(words);
  const PngMetadata metadata =
      picture_metadata(session.lesson(), session.stage(), words->alt, words->t_s, options.dpi);
  const std::string kind = what == SaveAs::figure ? "-figure" : equation ? "-" + equation->id : "";
  const fs::path path = free_name(folder, stem_of(session) + kind, ".png");
  const auto image = maker->draw(picture);
  if (!image) return passed_on(image);
  if (const Status written = write_png(path, *image, metadata); !written) return failed(written);
  return path;
}

}  // namespace

bool can_save_as(const LessonSession& session, SaveAs what) {
  if (what == SaveAs::page) return true;
  if (what == SaveAs::equation) return last_equation(session.step()) != nullptr || derivation_of(session);
  if (what == SaveAs::answers) return !questions_of(session.lesson()).empty();
  return session.model() != nullptr;
}

bool saves_derivation(const LessonSession& session) {
  return last_equation(session.step()) == nullptr && asked_derivation(session) != nullptr;
}

fs::path slides_path(const LessonSession& session, const fs::path& folder, const std::string& ending) {
  return free_name(folder, session.lesson().id + "-slides", ending);
}

Result<fs::path> save_as(const LessonSession& session, SaveAs what, const SaveOptions& options,
                         const fs::path& folder, Renderer& renderer) {
  if (!can_save_as(session, what))
    return failure(what == SaveAs::equation  ? (saves_derivation(session) ? "this derivation has no line yet"
                                                                          : "this step has no equation")
                   : what == SaveAs::answers ? "this lesson has no questions"
                                             : "this step has no figure");
  if (const Status made = make_folder(folder); !made) return failure(made.error());
  if (what == SaveAs::trace)
    return write_text(free_name(folder, stem_of(session), ".csv"), trace_of(session));
  if (what == SaveAs::scene) {
    const fs::path path = free_name(folder, stem_of(session) + "-scene", ".md");
    return write_text(path, lesson_of(session, path.stem().string()));
  }
  if (what == SaveAs::answers) {
    const auto report = answer_report(session.lesson(), session.answers(), options.student);
    if (!report) return failure(report.error());
    return write_text(free_name(folder, session.lesson().id + "-answers", ".txt"), *report);
  }
  const auto picture = save_picture(session, what, options, folder, renderer);
  if (!picture) return failure(picture.error().text);
  return *picture;
}

}  // namespace polhode
