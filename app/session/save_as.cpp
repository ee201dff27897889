// SPDX-License-Identifier: MIT
#include "app/session/save_as.h"

#include "app/export/picture_export.h"
#include "app/export/picture_maker.h"
#include "app/export/picture_metadata.h"
#include "app/session/saved_scene.h"
#include "base/files/atomic_file.h"
#include "render/image/png.h"

#include <fmt/format.h>

namespace polhode {

namespace fs = std::filesystem;

namespace {

const Equation* last_equation(const Step& step) {
  const auto equations = blocks_of<Equation>(step);
  return equations.empty() ? nullptr : equations.back();
}

What what_of(TakeAway what) {
  if (what == TakeAway::figure) return What::figure;
  return what == TakeAway::equation ? What::equation : What::page;
}

/// "07-poinsot-step3", as export names it.
std::string stem_of(const Companion& companion) {
  return fmt::format("{:02}-{}-step{}", companion.place().stage + 1, companion.stage().id,
                     companion.place().step + 1);
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
  const Status written =
      write_file_atomically(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (!written) return failure(written.error());
  return path;
}

ExportOptions export_options_of(const Companion& companion, TakeAway what, const TakeAwayOptions& chosen) {
  ExportOptions options;
  options.what = what_of(what);
  options.each = Each::step;
  options.size = chosen.size;
  options.at_s = companion.t_s();
  options.theme = companion.preferences.theme;
  options.text_scale = companion.preferences.text_scale;
  if (what == TakeAway::equation) options.dpi = kDefaultEquationDpi;
  options.background = chosen.transparent ? "transparent" : what == TakeAway::figure ? "studio" : "paper";
  return options;
}

/// Made by export's own maker.
Outcome<fs::path> take_picture(const Companion& companion, TakeAway what, const TakeAwayOptions& chosen,
                               const fs::path& folder, Renderer& renderer) {
  const ExportOptions options = export_options_of(companion, what, chosen);
  const Equation* equation = what == TakeAway::equation ? last_equation(companion.step()) : nullptr;
  const PlannedPicture picture{.stage = &companion.stage(),
                               .number = static_cast<int>(companion.place().stage) + 1,
                               .step = static_cast<int>(companion.place().step) + 1,
                               .scene = companion.model() ? &companion.model()->scene : nullptr,
                               .equation = equation,
                               .frame = {},
                               .file = {}};
  const MakerContext context{companion.lesson(), options, renderer};
  const auto maker = what == TakeAway::figure     ? make_figure_maker(context)
                     : what == TakeAway::equation ? make_equation_maker(context)
                                                  : make_page_maker(context);
  if (const Done checked = maker->check(picture); !checked) return passed_on(checked);
  const auto words = maker->describe(picture);
  if (!words) return passed_on(words);
  const PngMetadata metadata =
      picture_metadata(companion.lesson(), companion.stage(), words->alt, words->t_s, options.dpi);
  const std::string kind = what == TakeAway::figure ? "-figure" : equation ? "-" + equation->id : "";
  const fs::path path = free_name(folder, stem_of(companion) + kind, ".png");
  const auto image = maker->draw(picture);
  if (!image) return passed_on(image);
  if (const Status written = write_png(path, *image, metadata); !written) return failed(written);
  return path;
}

}  // namespace

bool can_take_away(const Companion& companion, TakeAway what) {
  if (what == TakeAway::page) return true;
  if (what == TakeAway::equation) return last_equation(companion.step()) != nullptr;
  return companion.model() != nullptr;
}

Result<fs::path> take_away(const Companion& companion, TakeAway what, const TakeAwayOptions& options,
                           const fs::path& folder, Renderer& renderer) {
  if (!can_take_away(companion, what))
    return failure(what == TakeAway::equation ? "this step has no equation" : "this step has no figure");
  if (const Status made = make_folder(folder); !made) return failure(made.error());
  if (what == TakeAway::trace)
    return write_text(free_name(folder, stem_of(companion), ".csv"), trace_of(companion));
  if (what == TakeAway::scene)
    return write_text(free_name(folder, stem_of(companion) + "-scene", ".md"), lesson_of(companion));
  const auto picture = take_picture(companion, what, options, folder, renderer);
  if (!picture) return failure(picture.error().text);
  return *picture;
}

}  // namespace polhode
