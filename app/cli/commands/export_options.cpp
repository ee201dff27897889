// SPDX-License-Identifier: MIT
#include "app/cli/commands/export_options.h"

#include "app/cli/exit_codes.h"
#include "app/cli/numbers.h"
#include "app/cli/typed_shard.h"
#include "app/export/named_sizes.h"
#include "app/page/page.h"
#include "app/publish/deck.h"
#include "app/publish/film.h"
#include "base/spelling.h"
#include "render/gl/passes/background.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polhode {

namespace {

constexpr int kMostDpi = 100'000;
constexpr int kMostJobs = 256;

/// The place of `typed` in `choices`, or `standard` if nothing was typed.
std::size_t choice(std::string_view option, const std::string& typed, const std::vector<std::string>& choices,
                   std::size_t standard = 0) {
  if (typed.empty()) return standard;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i] == typed) return i;
  throw usage(fmt::format("{}: \"{}\" is none of {}{}", option, typed, fmt::join(choices, ", "),
                          did_you_mean(typed, choices)));
}

template <class T>
T read_or_refuse(const std::optional<T>& value, std::string_view option, std::string_view typed,
                 std::string_view form) {
  if (!value) throw usage(fmt::format("{}: \"{}\" is not {}", option, typed, form));
  return *value;
}

struct GivenOption {
  const char* name;
  const std::string& typed;
};

void refuse_given(std::initializer_list<GivenOption> options, const std::string& reason) {
  for (const auto& [name, typed] : options)
    if (!typed.empty()) throw usage(fmt::format("{} {}", name, reason));
}

void check_combination(const TypedExport& typed, What what, Each each) {
  if (each != Each::frame) refuse_given({{"--frames", typed.frames}}, "goes with --each frame");
  if (each != Each::frame && typed.film.empty())
    refuse_given({{"--fps", typed.fps}, {"--seconds", typed.seconds}}, "goes with --each frame or --film");
  if (what == What::transcript)
    refuse_given({{"--each", typed.each},
                  {"--size", typed.size},
                  {"--at", typed.at},
                  {"--background", typed.background},
                  {"--theme", typed.theme},
                  {"--profile", typed.profile},
                  {"--quality", typed.quality},
                  {"--text-size", typed.text_size},
                  {"--dpi", typed.dpi},
                  {"--png", typed.png},
                  {"--format", typed.format},
                  {"--film", typed.film},
                  {"--deck", typed.deck},
                  {"--shard", typed.shard},
                  {"--jobs", typed.jobs},
                  {"--context", typed.context}},
                 "is of pictures; a transcript is text");
  if (what == What::equation) {
    refuse_given({{"--size", typed.size}}, "goes with pages and figures; --dpi sets the size of equations");
    refuse_given({{"--at", typed.at}}, "goes with pages and figures; equations have no time");
    refuse_given({{"--quality", typed.quality}}, "goes with pages and figures; type is the same in all");
  }
  if (what == What::equation)
    refuse_given({{"--text-size", typed.text_size}}, "goes with pages; --dpi sets the size of equations");
  if (what != What::page) refuse_given({{"--profile", typed.profile}}, "goes with pages");
  if (what == What::figure)
    refuse_given({{"--text-size", typed.text_size}},
                 "goes with pages; the type of a figure goes with its size");
  if (each == Each::frame)
    refuse_given({{"--deck", typed.deck}}, "goes with --each stage or step: slides have no frames");
  if (!typed.deck.empty() && !deck_kind_of(typed.deck))
    throw usage(fmt::format("--deck {}: the name has to end in .html, .pdf or .pptx", typed.deck));
  if (what == What::figure)
    refuse_given({{"--theme", typed.theme}}, "goes with pages and equations; a figure has its --background");
}

void check_outlines(const TypedExport& typed, const ExportOptions& options) {
  if (options.format == PictureFormat::png) return;
  const std::string name = "--format " + typed.format;
  if (options.what != What::equation)
    throw usage(name + " goes with --what equation: the outlines of type; pages and figures are pixels");
  if (options.each == Each::frame) throw usage(name + " goes with --each stage or step");
  const std::string reason = "is of pixels, and does not go with " + name;
  refuse_given({{"--png", typed.png}, {"--film", typed.film}, {"--deck", typed.deck}}, reason);
}

std::string background_name(const std::string& typed, What what) {
  if (what == What::page) {
    if (!typed.empty() && typed != "paper")
      throw usage(
          fmt::format("--background {}: a page has the paper of its --theme; --background goes with "
                      "--what figure and --what equation",
                      typed));
    return "paper";
  }
  if (typed.empty()) return what == What::figure ? "studio" : "paper";
  if (what == What::equation && typed == "transparent-dark")
    throw usage(
        "--background transparent-dark: goes with --what figure; equations are transparent in the --theme "
        "dark");
  std::vector<std::string> names = export_words().background;
  names.emplace_back("#rrggbb");
  if (!background_from(typed))
    throw usage(fmt::format("--background: \"{}\" is none of {}{}", typed, fmt::join(names, ", "),
                            did_you_mean(typed, names)));
  return typed;
}

void check_film(const std::string& file, const FrameRate& rate) {
  if (file.empty()) return;
  const auto kind = film_kind_of(file);
  if (!kind) throw usage(fmt::format("--film: \"{}\" is no .mp4, .webm, .gif or .apng", file));
  if (*kind == FilmKind::gif && rate.frames > kMostGifFrames * rate.seconds)
    throw usage(
        fmt::format("--fps {}: a GIF has at most {} frames a second", to_string(rate), kMostGifFrames));
}

Size size_of(const std::string& typed, What what) {
  if (const auto named = named_size(typed)) return named->size;
  const Size size = picture_size("--size", typed, kMaxImageSide);
  if (what == What::page && (size.width < kSmallestPage.width || size.height < kSmallestPage.height))
    throw usage(fmt::format("--size {}: a page has at least {}x{} pixels", typed, kSmallestPage.width,
                            kSmallestPage.height));
  return size;
}

int dpi_of(const std::string& typed, const std::string& typed_size, What what, PictureFormat format) {
  const bool sets_size = what == What::equation;
  const auto named = named_size(typed_size);
  const int of_equations = format == PictureFormat::png ? kDefaultEquationDpi : kDefaultOutlineDpi;
  if (typed.empty()) return sets_size ? of_equations : named ? named->dpi : 0;
  return static_cast<int>(whole_number("--dpi", typed, sets_size ? kFewestEquationDpi : 1, kMostDpi));
}

double text_scale_of(const std::string& typed) {
  if (typed.empty()) return 1.0;
  const double scale = finite_number("--text-size", typed);
  if (scale < kLeastTextScale || scale > kMostTextScale)
    throw usage(fmt::format("--text-size {}: it has to be from {} to {}; 1 is normal", typed, kLeastTextScale,
                            kMostTextScale));
  return scale;
}

/// With --skip-existing, and without the options named in `left_out`, which have a value each.
std::vector<std::string> resume_words(const TypedExport& typed, const std::vector<std::string>& left_out) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < typed.words.size(); ++i) {
    const bool left = std::find(left_out.begin(), left_out.end(), typed.words[i]) != left_out.end();
    if (left)
      ++i;
    else
      words.push_back(typed.words[i]);
  }
  words.emplace_back("--skip-existing");
  return words;
}

Durability durability_of(const std::string& typed) {
  return choice("--sync", typed, export_words().sync) == 1 ? Durability::sync : Durability::rename_only;
}

ContextKind context_of(const std::string& typed) {
  constexpr ContextKind kKinds[] = {ContextKind::any, ContextKind::osmesa, ContextKind::egl};
  return kKinds[choice("--context", typed, export_words().context)];
}

bool is_of_both_themes(const std::string& typed) {
  return choice("--theme", typed, export_words().theme) == export_words().theme.size() - 1;
}

/// Of pages of text.
bool has_both_themes(const TypedExport& typed) {
  const bool both = is_of_both_themes(typed.theme);
  if (both && typed.live)
    throw usage("--theme both: does not go with --live, whose figures are on one ground");
  return both;
}

Theme theme_of(const std::string& typed) {
  if (is_of_both_themes(typed))
    throw usage("--theme both: only the figures of --reader and --site are drawn in both");
  return static_cast<Theme>(choice("--theme", typed, export_words().theme));
}

std::optional<QualityLevel> quality_of(const std::string& typed) {
  if (typed.empty()) return std::nullopt;
  return static_cast<QualityLevel>(choice("--quality", typed, export_words().quality));
}

bool has_ending(const std::string& file, std::initializer_list<std::string_view> endings) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::vector<std::string> names_of_sizes() {
  std::vector<std::string> names;
  for (const NamedSize& size : named_sizes()) names.push_back(size.name);
  return names;
}

}  // namespace

const ExportWords& export_words() {
  static const ExportWords kWords = {
      .what = {"page", "equation", "figure", "transcript"},
      .each = {"stage", "step", "frame", "page"},
      .size = names_of_sizes(),
      .background = {"studio", "paper", "white", "transparent", "transparent-dark"},
      .theme = {"paper", "dark", "both"},
      .profile = {"page", "slides"},
      .quality = quality_level_names(),
      .png = {"fast", "small"},
      .format = {"png", "svg", "pdf"},
      .sync = {"end", "frame"},
      .context = {"auto", "osmesa", "egl"},
      .with = {"html", "pdf", "pptx", "mp4"}};
  return kWords;
}

namespace {

/// What goes with one page of HTML alone.
void refuse_all_of_pictures(const TypedExport& typed, const std::string& reason) {
  refuse_given({{"--what", typed.what},
                {"--profile", typed.profile},
                {"--each", typed.each},
                {"--size", typed.size},
                {"--background", typed.background},
                {"--dpi", typed.dpi},
                {"--fps", typed.fps},
                {"--seconds", typed.seconds},
                {"--at", typed.at},
                {"--frames", typed.frames},
                {"--text-size", typed.text_size},
                {"--png", typed.png},
                {"--format", typed.format},
                {"--film", typed.film},
                {"--deck", typed.deck},
                {"--output", typed.folder},
                {"--shard", typed.shard},
                {"--jobs", typed.jobs}},
               reason);
  if (typed.skip_existing) throw usage("--skip-existing " + reason);
  if (typed.count_chosen) throw usage("--count-chosen " + reason);
}

void check_html(std::string_view option, const std::string& file) {
  if (!has_ending(file, {".html", ".htm"}))
    throw usage(fmt::format("{} {}: the name has to end in .html", option, file));
}

/// A figure that moves begins at the time of its scene, and takes the place of its slide.
void check_live(const TypedExport& typed, const ExportOptions& options) {
  if (!typed.live) return;
  const bool are_slides = options.what == What::page && options.profile == Profile::slides;
  if (deck_kind_of(typed.deck) != DeckKind::html || !are_slides || options.each == Each::frame)
    throw usage(
        "--live goes with --reader, --site and a --deck FILE.html of slides; a --sandbox is live anyway");
  refuse_given({{"--at", typed.at}, {"--text-size", typed.text_size}}, "does not go with --live");
}

}  // namespace

ReaderOutput reader_output(const TypedExport& typed) {
  refuse_all_of_pictures(typed, "does not go with --reader, which makes one file of text and figures");
  check_html("--reader", typed.reader);
  const bool both = has_both_themes(typed);
  return {.file = typed.reader,
          .stages = typed.stages,
          .live = typed.live,
          .theme = both ? Theme::paper : theme_of(typed.theme),
          .in_both_themes = both,
          .quality = quality_of(typed.quality),
          .durability = durability_of(typed.sync),
          .context = context_of(typed.context)};
}

const std::string& lesson_of(const TypedExport& typed) {
  if (typed.lessons.empty()) throw usage("LESSON is required");
  if (typed.lessons.size() > 1)
    throw usage(
        fmt::format("unexpected argument \"{}\": only --site takes more than one lesson", typed.lessons[1]));
  return typed.lessons.front();
}

SiteOutput site_output(const TypedExport& typed) {
  const std::string reason = "does not go with --site, which makes pages of whole lessons";
  refuse_all_of_pictures(typed, reason);
  refuse_given({{"--reader", typed.reader}, {"--sandbox", typed.sandbox}}, reason);
  if (!typed.stages.empty()) throw usage("--stage " + reason);
  const bool both = has_both_themes(typed);
  SiteOutput out{.folder = typed.site,
                 .url = typed.url,
                 .with = {},
                 .live = typed.live,
                 .theme = both ? Theme::paper : theme_of(typed.theme),
                 .in_both_themes = both,
                 .quality = quality_of(typed.quality),
                 .durability = durability_of(typed.sync),
                 .context = context_of(typed.context)};
  if (!out.url.empty() && !out.url.starts_with("https://") && !out.url.starts_with("http://"))
    throw usage(fmt::format("--url {}: it has to begin with https:// or http://", out.url));
  if (!out.url.empty() && out.url.back() != '/') out.url += '/';
  for (const std::string& word : typed.with) {
    const auto kind = static_cast<SiteCopy>(choice("--with", word, export_words().with));
    if (std::find(out.with.begin(), out.with.end(), kind) == out.with.end()) out.with.push_back(kind);
  }
  std::sort(out.with.begin(), out.with.end());
  return out;
}

ReaderOutput sandbox_output(const TypedExport& typed) {
  const std::string reason = "does not go with --sandbox, which makes one page of its own";
  refuse_all_of_pictures(typed, reason);
  refuse_given({{"LESSON", typed.lessons.empty() ? std::string() : typed.lessons.front()},
                {"--reader", typed.reader},
                {"--theme", typed.theme},
                {"--quality", typed.quality}},
               reason);
  if (!typed.stages.empty()) throw usage("--stage " + reason);
  check_html("--sandbox", typed.sandbox);
  return {.file = typed.sandbox,
          .live = true,
          .quality = {},
          .durability = durability_of(typed.sync),
          .context = context_of(typed.context)};
}

ExportOptions export_options(const TypedExport& typed) {
  ExportOptions options;
  options.what = static_cast<What>(choice("--what", typed.what, export_words().what));
  options.stages = typed.stages;
  options.profile = static_cast<Profile>(choice("--profile", typed.profile, export_words().profile, 1));
  const auto each_of_kind = [&] {
    if (!typed.film.empty()) return Each::frame;
    if (options.what != What::page) return Each::stage;
    return options.profile == Profile::slides ? Each::step : Each::page;
  };
  options.each = static_cast<Each>(
      choice("--each", typed.each, export_words().each, static_cast<std::size_t>(each_of_kind())));
  check_combination(typed, options.what, options.each);
  if (options.each == Each::page && (options.what != What::page || options.profile == Profile::slides))
    throw usage("--each page goes with --profile page; a slide has one step");
  options.format = static_cast<PictureFormat>(choice("--format", typed.format, export_words().format));
  check_outlines(typed, options);
  if (!typed.size.empty()) options.size = size_of(typed.size, options.what);
  if (!typed.fps.empty())
    options.fps = read_or_refuse(frame_rate_from(typed.fps), "--fps", typed.fps,
                                 "a frame rate; write it like 25 or 30000/1001, terms from 1 to 1000000");
  check_film(typed.film, options.fps);
  if (!typed.seconds.empty()) options.seconds = finite_number("--seconds", typed.seconds);
  if (options.seconds < 0) throw usage(fmt::format("--seconds: {} is negative", typed.seconds));
  if (!typed.at.empty()) options.at_s = finite_number("--at", typed.at);
  if (!typed.frames.empty())
    options.frames = read_or_refuse(frame_range_from(typed.frames), "--frames", typed.frames,
                                    "a range A:B with 0 <= A < B, like 0:48");
  options.background = background_name(typed.background, options.what);
  options.theme = theme_of(typed.theme);
  options.quality = quality_of(typed.quality);
  options.text_scale = text_scale_of(typed.text_size);
  options.dpi = dpi_of(typed.dpi, typed.size, options.what, options.format);
  options.png = static_cast<PngPacking>(choice("--png", typed.png, export_words().png));
  check_live(typed, options);
  options.counts_chosen = typed.count_chosen;
  if (options.counts_chosen && (options.what != What::page || options.stages.empty()))
    throw usage("--count-chosen goes with --stage and pages");
  if (options.counts_chosen && typed.live) throw usage("--count-chosen does not go with --live");
  return options;
}

ExportOutput export_output(const TypedExport& typed) {
  ExportOutput out;
  out.film = typed.film;
  out.deck = typed.deck;
  out.live = typed.live;
  out.folder = typed.folder;
  out.keep_folder = !typed.folder.empty();
  if (!out.keep_folder) {
    const std::string& file = typed.film.empty() ? typed.deck : typed.film;
    if (file.empty())
      throw usage(
          "--output DIR is needed: where the files go (or --film, --deck, --reader or --sandbox FILE)");
    out.folder = file + ".parts";
  }
  out.skip_existing = typed.skip_existing;
  out.shard = shard_from(typed.shard);
  if (!out.shard.whole())
    refuse_given(
        {{"--film", typed.film}, {"--deck", typed.deck}},
        "needs the pictures of all shards; give it after them, with --skip-existing in place of --shard");
  if (!typed.jobs.empty()) out.jobs = static_cast<int>(whole_number("--jobs", typed.jobs, 1, kMostJobs));
  out.resume = resume_words(typed, {});
  out.resume_all = resume_words(typed, {"--shard", "--jobs"});
  out.durability = durability_of(typed.sync);
  out.context = context_of(typed.context);
  return out;
}

}  // namespace polhode
