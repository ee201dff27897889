// SPDX-License-Identifier: MIT
// The HTML deck: assets/deck/deck.html with style, script and slides put in. The page works without its
// script too, as one slide with its notes below the other.
#include "app/export/picture_metadata.h"
#include "app/publish/deck.h"
#include "app/publish/deck_assets.h"
#include "app/publish/deck_picture.h"
#include "app/publish/html_frame.h"
#include "app/publish/html_text.h"
#include "app/publish/live/live_assets.h"
#include "base/words/deck_words.h"
#include "base/words/page_words.h"
#include "render/image/png.h"
#include "render/image/webp.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <map>
#include <thread>

namespace polhode {

namespace {

/// Some element's text, and where it is to go.
class Sink {
 public:
  explicit Sink(const AppendBytes& append) : append_(append) {}
  Status operator()(std::string_view text) const { return append_(bytes_of(text)); }

 private:
  const AppendBytes& append_;
};

/// The page of a printed slide is as large as the first one's picture.
std::string style_of(const Deck& deck, Size first) {
  const PageColors& colors = colors_of(deck.theme);
  const PaperSize paper = paper_size(first, deck.dpi);
  return fmt::format(
             "\n:root {{ --paper: {}; --ink: {}; --quiet: {}; --accent: {}; --panel: {}; --line: {}; }}\n",
             hex(colors.paper), hex(colors.ink), hex(colors.quiet), hex(colors.accent), hex(colors.panel),
             hex(colors.line)) +
         deck_assets::kDeckCss +
         (deck.live ? std::string(live_assets::kLiveCss) + live_assets::kSlidesCss : std::string()) +
         fmt::format("@page {{ size: {:.4f}in {:.4f}in; margin: 0; }}\n", paper.width_in, paper.height_in);
}

const char* class_of(StepNote::Kind kind) {
  switch (kind) {
    case StepNote::Kind::text:
      return "text";
    case StepNote::Kind::item:
      return "item";
    case StepNote::Kind::equation:
      return "equation";
    case StepNote::Kind::callout:
      return "callout";
    case StepNote::Kind::question:
      return "question";
    case StepNote::Kind::note:
      return "note";
    case StepNote::Kind::to_say:
      return "to-say";
    case StepNote::Kind::figure:
      break;
  }
  return "figure";
}

/// The text of a note, its links as such.
std::string linked_html(const StepNote& note) {
  std::string html;
  std::size_t at = 0;
  const std::string_view text = note.text;
  for (const NoteLink& link : note.links) {
    html += html_escaped(text.substr(at, link.begin - at));
    html += fmt::format("<a href=\"{}\">{}</a>", html_escaped(link.to),
                        html_escaped(text.substr(link.begin, link.end - link.begin)));
    at = link.end;
  }
  return html + html_escaped(text.substr(at));
}

std::string_view notes_label(Language language) {
  for (const NamedPhrase& phrase : words::kDeck)
    if (phrase.name == "notes") return phrase.words.in(language);
  return {};
}

std::string notes_html(const std::vector<StepNote>& notes, Language language) {
  std::string html;
  for (const StepNote& note : notes)
    html += fmt::format("<p class=\"{}\">{}</p>\n", class_of(note.kind), linked_html(note));
  return html.empty() ? fmt::format("<p class=\"text\">{}</p>\n", words::kNoNotes.in(language)) : html;
}

std::string heading_html(const DeckSlide& slide, const std::string& id, std::size_t number) {
  const std::string part =
      slide.part.empty() ? "" : fmt::format(" <span class=\"step\">{}</span>", html_escaped(slide.part));
  return fmt::format("<h2><a href=\"#{}\"><span class=\"number\">{}</span>{}{}</a></h2>\n", id, number,
                     html_escaped(slide.title), part);
}

/// As an `img` has it.
struct EncodedPicture {
  Size size;
  std::string source;
};

/// WebP has the same pixels in 0.6 of the bytes; what is too large for it stays PNG.
Result<EncodedPicture> encoded(const std::filesystem::path& file) {
  const Result<DeckPicture> picture = read_deck_picture(file);
  if (!picture) return failure(picture.error());
  const Size size = picture->png.header.size;
  if (std::max(size.width, size.height) > kMaxWebpSide)
    return EncodedPicture{size, "data:image/png;base64," + base64(picture->bytes)};
  const Result<PngFile> png = decode_png(picture->bytes);
  if (!png) return failure("cannot use " + file.string() + ": " + png.error());
  const Result<std::vector<std::uint8_t>> webp = encode_webp(png->image);
  if (!webp) return failure("cannot use " + file.string() + ": " + webp.error());
  return EncodedPicture{size, "data:image/webp;base64," + base64(*webp)};
}

/// The pictures of a deck in their order; each of a few threads encodes one of the next.
class Pictures {
 public:
  /// @param like a picture of the deck, by whose size the memory for all is guessed
  Pictures(const Deck& deck, Size like) : deck_(deck) {
    const auto pixels = static_cast<std::size_t>(like.width) * static_cast<std::size_t>(like.height);
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t threads = std::clamp<std::size_t>(kMostPixels / pixels, 1, cores);
    while (ahead_.size() < std::min(threads, deck.slides.size())) start_next();
  }

  Result<EncodedPicture> next() {
    Result<EncodedPicture> picture = ahead_.front().get();
    ahead_.pop_front();
    if (started_ < deck_.slides.size()) start_next();
    return picture;
  }

 private:
  /// In the making at a time: of each pixel some 20 bytes are held.
  static constexpr std::size_t kMostPixels = 10'000'000;

  void start_next() {
    ahead_.push_back(std::async(std::launch::async, encoded, deck_.slides[started_++].png));
  }

  const Deck& deck_;
  std::size_t started_ = 0;
  std::deque<std::future<Result<EncodedPicture>>> ahead_;
};

Status append_slide(const DeckSlide& slide, const EncodedPicture& picture, std::size_t number, bool live,
                    Language language, const Sink& sink) {
  const bool moves = live && !slide.live.empty();
  const std::string id = html_escaped(slide.png.stem().string());
  Status status =
      sink(fmt::format("<section class=\"slide\" id=\"{}\" data-stage=\"{}\" aria-label=\"{}\">\n{}"
                       "{}<img width=\"{}\" height=\"{}\" decoding=\"sync\" alt=\"{}\" src=\"",
                       id, slide.stage, html_escaped(name_of(slide)), heading_html(slide, id, number),
                       moves ? "<figure" + slide.live + " data-slide>" : "", picture.size.width,
                       picture.size.height, html_escaped(slide.alt)));
  if (status) status = sink(picture.source);
  if (status)
    status =
        sink(fmt::format("\">{}\n<div class=\"notes\" tabindex=\"0\" role=\"region\" "
                         "aria-label=\"{}\">\n{}</div>\n</section>\n",
                         moves ? "</figure>" : "", notes_label(language), notes_html(slide.notes, language)));
  return status;
}

Status append_slides(const Deck& deck, Size first, const Sink& sink, const DeckProgress& go_on) {
  Pictures pictures(deck, first);
  for (std::size_t i = 0; i < deck.slides.size(); ++i) {
    if (!go_on(i)) return failure("stopped");
    const Result<EncodedPicture> picture = pictures.next();
    if (!picture) return failure(picture.error());
    if (Status status =
            append_slide(deck.slides[i], *picture, i + 1, deck.live.has_value(), deck.language, sink);
        !status)
      return status;
  }
  return success();
}

}  // namespace

Status append_html_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on) try {
  Size first{16, 9};
  if (!deck.slides.empty()) {
    const Result<DeckPicture> picture = read_deck_picture(deck.slides.front().png);
    if (!picture) return failure(picture.error());
    first = picture->png.header.size;
  }
  const std::string style = style_of(deck, first);
  const std::string script = std::string("\n") + deck_assets::kDeckJs;
  const std::string figures = std::string("\n") + live_assets::kLiveJs + live_assets::kFiguresJs;
  // Nothing is fetched, and nothing runs but what is written here, whatever the texts say.
  const std::string policy = fmt::format(
      "default-src 'none'; img-src data:; style-src {}; script-src {}{}; base-uri 'none'; "
      "form-action 'none'",
      policy_hash(style), policy_hash(script),
      deck.live ? ' ' + policy_hash(figures) + ' ' + live_policy(*deck.live) : "");
  std::map<std::string, std::string> texts = {
      {"language", std::string(tag_of(deck.language))},
      {"policy", policy},
      {"scheme", deck.theme == Theme::dark ? "dark" : "light"},
      {"paper", hex(colors_of(deck.theme).paper)},
      {"program", html_escaped(program_name_and_version())},
      {"title", html_escaped(deck.title)},
      {"author", deck.author.empty()
                     ? ""
                     : fmt::format("<meta name=\"author\" content=\"{}\">\n", html_escaped(deck.author))},
      {"style", style},
      {"script", script},
      {"without", deck.live ? live_without_script(deck.language) : ""},
      {"live",
       deck.live ? live_elements(*deck.live, deck.language) + "<script>" + figures + "</script>\n" : ""},
  };
  for (const NamedPhrase& phrase : words::kDeck) texts.emplace(phrase.name, phrase.words.in(deck.language));
  texts.emplace("words", html_escaped(json_of(words::kDeckScript, deck.language)));
  const Sink sink(append);
  return append_frame(deck_assets::kDeckHtml, append, [&](const std::string& name) {
    return name == "slides" ? append_slides(deck, first, sink, go_on) : sink(texts.at(name));
  });
} catch (const std::exception& error) {  // no memory, no thread
  return failure(error.what());
}

}  // namespace polhode
