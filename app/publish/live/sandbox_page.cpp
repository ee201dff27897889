// SPDX-License-Identifier: MIT
#include "app/publish/live/sandbox_page.h"

#include "app/export/picture_metadata.h"
#include "app/publish/html_frame.h"
#include "app/publish/html_text.h"
#include "app/publish/live/live_assets.h"
#include "app/publish/text_edition/reader_figure.h"
#include "app/publish/text_edition/reader_style.h"
#include "lessons/reader/checks/lesson_check.h"

#include <fmt/format.h>

#include <map>

namespace polhode {

namespace {

/// px: two scenes side by side, as wide as the page, as assets/web/sandbox.js draws them.
constexpr Size kPoster{1280, 589};

Status append_sandbox(const LiveParts& live, const ReaderPicture& poster, const std::string& style,
                      const AppendBytes& append) {
  const std::string script = std::string("\n") + live_assets::kLiveJs + live_assets::kSandboxJs;
  const std::map<std::string, std::string> texts = {
      {"policy",
       fmt::format("default-src 'none'; img-src data:; style-src {}; script-src {} {}; base-uri 'none'; "
                   "form-action 'none'",
                   policy_hash(style), policy_hash(script), live_policy(live))},
      {"program", html_escaped(program_name_and_version())},
      {"style", style},
      {"width", std::to_string(poster.size.width)},
      {"height", std::to_string(poster.size.height)},
      {"alt", html_escaped(poster.alt)},
      {"poster", poster.source},
      {"live", live_elements(live, Language::en)},
      {"script", script},
  };
  return append_frame(live_assets::kSandboxHtml, append,
                      [&](const std::string& name) { return append(bytes_of(texts.at(name))); });
}

}  // namespace

Done write_sandbox(const std::filesystem::path& file, const LiveProgram& program, Renderer& renderer,
                   Durability durability, const std::string& program_file) {
  const LessonReading reading = check_lesson(live_assets::kSandboxMd, "sandbox.md");
  if (!reading.lesson) return failure_of(Fault::failed, to_string(reading.diagnostics.front()));
  const Lesson& lesson = *reading.lesson;
  const SpeechText speech(lesson);
  ReaderFigures figures(lesson, speech, renderer, {});
  const Stage& stage = lesson.stages.front();
  const Outcome<ReaderPicture> poster =
      figures.moment(stage, 1, still_time_s(*stage.steps.front().scene), kPoster);
  if (!poster) return passed_on(poster);
  const LiveParts live{program, live_assets::kSandboxMd, program_file};
  const std::string style = reader_style(lesson) + live_assets::kLiveCss + live_assets::kSandboxCss;
  const Status written = write_file_in_pieces(
      file, [&](const AppendBytes& append) { return append_sandbox(live, *poster, style, append); },
      durability);
  if (!written) return failed(written);
  return done();
}

std::vector<std::string> sandbox_sources() {
  using namespace live_assets;
  return {program_name_and_version(), kLiveCss, kLiveJs, kSandboxCss, kSandboxHtml, kSandboxJs, kSandboxMd,
          reader_style(Lesson())};
}

}  // namespace polhode
