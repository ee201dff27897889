// SPDX-License-Identifier: MIT
#include "app/publish/text_edition/reader_page.h"

#include "app/export/picture_metadata.h"
#include "app/narration/number_text.h"
#include "app/narration/still_numbers.h"
#include "app/narration/verdict_row.h"
#include "app/publish/html_frame.h"
#include "app/publish/live/live_assets.h"
#include "app/publish/text_edition/question_html.h"
#include "app/publish/text_edition/reader_assets.h"
#include "app/publish/text_edition/reader_style.h"
#include "base/ascii.h"
#include "base/interrupt.h"
#include "base/words/edition_words.h"
#include "base/words/speech_words.h"
#include "lessons/reader/markdown/footnotes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace polhode {

namespace {

/// Of another lesson; with a link if there is an address. Who reads this page need not read that language.
std::string title_of_other(const ReaderTitle& other, const std::string& address, Language of_page) {
  const std::string title = html_escaped(other.text), lang = lang_of(other.language, of_page);
  std::string html = title;
  if (!address.empty())
    html = fmt::format("<a href=\"{}\"{}>{}</a>", html_escaped(address), lang, title);
  else if (!lang.empty())
    html = fmt::format("<span{}>{}</span>", lang, title);
  const Phrase& language = other.language == Language::de ? words::kInGerman : words::kInEnglish;
  return lang.empty() ? html : fmt::format("{} ({})", html, language.in(of_page));
}

bool is_in(const ReaderEdition& edition, const Stage& stage) {
  const std::vector<std::string>& wanted = edition.stages;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), stage.id) != wanted.end();
}

std::set<std::string> stages_in(const ReaderEdition& edition) {
  std::set<std::string> ids;
  for (const Stage& stage : edition.lesson.stages)
    if (is_in(edition, stage)) ids.insert(stage.id);
  return ids;
}

/// All that the texts of the edition show, as on the stills of their steps.
TextNumbers numbers_in(const ReaderEdition& edition, const Fonts& fonts, const Effort& effort) {
  TextNumbers numbers{PageNumbers(edition.lesson, fonts)};
  StillNumbers stills(effort);
  for (const Stage& stage : edition.lesson.stages) {
    if (!is_in(edition, stage)) continue;
    for (const Step& step : stage.steps) {
      const std::vector<int> ids = numbers_in(step);
      if (ids.empty()) continue;
      const StillNumbers::Values& values = stills.of(edition.lesson, step);
      for (const int id : ids) {
        const auto value = values.find(id);
        numbers.shown.keep(id, value != values.end() ? std::optional(value->second) : std::nullopt);
        if (value == values.end()) continue;
        const int digits = edition.lesson.numbers[static_cast<std::size_t>(id)].written.digits;
        numbers.tex.emplace(id, number_tex(value->second, digits));
      }
    }
  }
  return numbers;
}

/// Of a figure that moves it is said by the figure: one of the still alone, too.
bool has_computed_caption(const Step& step) {
  const std::vector<const Scene*> scenes = shown_scenes(*step.scene);
  const auto is_of_still = [](const Scene* scene) { return scene->caption_when == CaptionWhen::still; };
  return std::any_of(scenes.begin(), scenes.end(), is_of_still) ||
         std::any_of(step.captions.begin(), step.captions.end(),
                     [](const auto& caption) { return caption && !numbers_in(*caption).empty(); });
}

std::string_view class_of(Certainty certainty) {
  switch (certainty) {
    case Certainty::proved:
      return "proved";
    case Certainty::stated:
      return "stated";
    case Certainty::refuted:
      return "refuted";
    case Certainty::open:
      break;
  }
  return "open";
}

/// The steps of an edition, one after the other.
class ReaderText {
 public:
  ReaderText(const ReaderEdition& edition, Renderer& renderer, const Effort& effort)
      : edition_(edition),
        speech_(edition.lesson, effort),
        numbers_(numbers_in(edition, renderer.fonts(), effort)),
        html_(edition.lesson, speech_, numbers_, stages_in(edition)),
        figures_(edition.lesson, speech_, renderer, edition.look, effort) {
    if (edition.place) html_.lead_to(edition.place->lessons);
  }

  std::string outline() const {
    std::string html;
    for_each_stage([&](const Stage& stage, std::size_t number) {
      html += fmt::format("<li value=\"{}\"><a href=\"#{}\">{}</a></li>\n", number, html_escaped(stage.id),
                          html_.line(stage.title_text));
    });
    return html;
  }

  /// What the front matter says of the lesson.
  std::string about() const {
    const About& about = edition_.lesson.about;
    std::string html;
    if (!about.authors.empty())
      html += fmt::format("<p class=\"authors\">{}</p>\n",
                          html_escaped(fmt::format("{}", fmt::join(about.authors, ", "))));
    const auto list = [&](const std::string& heading, const std::vector<std::string>& lines) {
      if (lines.empty()) return;
      html += fmt::format("<h2>{}</h2>\n<ul>\n", heading);
      for (const std::string& line : lines) html += "<li>" + line_or_lesson(line) + "</li>\n";
      html += "</ul>\n";
    };
    list(said(words::kOutcomes), about.outcomes);
    list(said(words::kPrerequisites), about.prerequisites);
    if (edition_.live) html += live_without_script(edition_.lesson.about.language);
    return html;
  }

  std::string begin(const Stage& stage, std::size_t number) {
    html_.number_notes_of(&stage);
    figure_ = nullptr;
    return fmt::format(
        "<section class=\"stage\" aria-labelledby=\"{0}\">\n<h2 id=\"{0}\"><span "
        "class=\"number\">{1}</span> {2}</h2>\n",
        html_escaped(stage.id), number, html_.line(stage.title_text));
  }
  static std::string end() { return "</section>\n"; }

  /// @param step from 1
  Outcome<std::string> step(const Stage& stage, int step) {
    const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
    Outcome<std::string> text = text_of(stage, step);
    if (!text) return text;
    Outcome<std::string> figure = figure_of(stage, step);
    if (!figure) return figure;
    std::string html =
        fmt::format("<div class=\"step{}\" id=\"{}\">\n", figure->empty() ? "" : " with-figure",
                    html_escaped(step_id(stage, static_cast<std::size_t>(step))));
    if (!of.title.empty()) html += "<h3>" + html_.line(of.title) + "</h3>\n";
    // A question is about its figure, which is met before it and its hints.
    const std::string said = "<div class=\"text\">\n" + *text + "</div>\n";
    return html + (blocks_of<Ask>(of).empty() ? said + *figure : *figure + said) + "</div>\n";
  }

  /// What the lesson cites, at the end.
  std::string references() const {
    std::string html;
    for (const Reference& reference : edition_.lesson.references)
      if (reference.is_cited)
        html += fmt::format("<li id=\"{}{}\"><span class=\"key\">[{}]</span> {}</li>\n", kCiteLink,
                            html_escaped(reference.key), html_escaped(reference.key),
                            html_escaped(reference.text));
    return html.empty() ? html
                        : "<section class=\"references\" aria-labelledby=\"page.references\">\n<h2 "
                          "id=\"page.references\">" +
                              said(words::kReferences) + "</h2>\n<ul>\n" + html + "</ul>\n</section>\n";
  }

  /// What can be looked for.
  std::vector<ReaderEntry> entries() const {
    std::vector<ReaderEntry> all;
    for_each_stage([&](const Stage& stage, std::size_t) {
      all.push_back({ReaderEntry::Kind::stage, stage.id, html_.line(stage.title_text),
                     speech_.words(stage.title_text)});
      for (std::size_t i = 0; i < stage.steps.size(); ++i) {
        const Step& step = stage.steps[i];
        if (!step.title.empty())
          all.push_back({ReaderEntry::Kind::step, step_id(stage, i + 1), html_.line(step.title),
                         speech_.words(step.title)});
        for (const Equation* equation : blocks_of<Equation>(step))
          all.push_back({ReaderEntry::Kind::equation, equation_id(stage, *equation),
                         html_.formula_in_line(equation->math, equation->tex), speech_.words(*equation)});
      }
    });
    return all;
  }

  template <class Do>
  void for_each_stage(const Do& act) const {
    for (std::size_t i = 0; i < edition_.lesson.stages.size(); ++i)
      if (is_in(edition_, edition_.lesson.stages[i])) act(edition_.lesson.stages[i], i + 1);
  }

 private:
  Language language() const { return edition_.lesson.about.language; }

  /// A line of the front matter; one that is the id of another lesson is its title, with a link in a site.
  std::string line_or_lesson(const std::string& line) const {
    const auto other = edition_.titles.find(line);
    if (other == edition_.titles.end()) return html_escaped(line);
    return title_of_other(other->second, html_.address_of(line), language());
  }
  std::string said(const Phrase& phrase) const { return html_escaped(phrase.in(language())); }
  std::string time(double t_s, int digits) const {
    return html_.line(with_decimals(fmt::format("$t$ = {:.{}g} s", t_s, digits), language()));
  }

  Outcome<std::string> text_of(const Stage& stage, int step) {
    const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
    std::string html;
    for (const Block& block : of.blocks) {
      if (const auto* prose = std::get_if<Prose>(&block)) html += html_.blocks(prose->text);
      if (const auto* equation = std::get_if<Equation>(&block)) html += equation_html(stage, of, *equation);
      if (const auto* claim = std::get_if<Claim>(&block)) html += claim_html(stage, of, *claim);
      if (const auto* callout = std::get_if<Callout>(&block)) html += callout_html(*callout);
      if (const auto* note = std::get_if<Footnote>(&block)) html += note_html(stage, *note);
      const auto* ask = std::get_if<Ask>(&block);
      if (ask == nullptr) continue;
      const Outcome<std::string> shown = moments_html(stage, step, *ask);
      if (!shown) return passed_on(shown);
      html += question_html(html_, stage, *ask, *shown);
    }
    return html;
  }

  std::string equation_html(const Stage& stage, const Step& step, const Equation& equation) {
    const std::string id = html_escaped(equation_id(stage, equation));
    std::string html = fmt::format("<div class=\"equation\" id=\"{}\"><div class=\"formula\">{}</div>", id,
                                   html_.formula(equation.math, equation.tex));
    if (!equation.tag.empty())
      html += fmt::format(" <a class=\"tag\" href=\"#{}\" aria-label=\"{}\">({})</a>", id,
                          words::kEquationLabel.with(language(), {html_escaped(equation.tag)}),
                          html_escaped(equation.tag));
    html += "</div>\n";
    for (const Claim* claim : blocks_of<Claim>(step))
      if (claim->equation == equation.id) html += verdict_html(step, *claim, "");
    return html;
  }

  /// A claim about an equation of the same step stands below that.
  std::string claim_html(const Stage& stage, const Step& step, const Claim& claim) {
    for (const Equation* equation : blocks_of<Equation>(step))
      if (equation->id == claim.equation) return {};
    const Equation* of = find_equation(edition_.lesson, stage.id + '/' + claim.equation);
    if (of == nullptr) return verdict_html(step, claim, "");
    return verdict_html(
        step, claim,
        fmt::format("<a href=\"#{}\">{}</a>: ", html_escaped(equation_id(stage, *of)),
                    of->tag.empty() ? said(words::kEquationAbove)
                                    : words::kEquationInBrackets.with(language(), {html_escaped(of->tag)})));
  }

  std::string verdict_html(const Step& step, const Claim& claim, const std::string& of) {
    const SceneModel* model = step.scene ? &figures_.model_of(step) : nullptr;
    const VerdictRow row = verdict_row(claim, step.scene.get(), model, language());
    const std::string_view mark = row.certainty == Certainty::proved    ? "✓ "
                                  : row.certainty == Certainty::refuted ? "✗ "
                                                                        : "";
    const std::string_view comma = row.note.empty() || row.example.empty() ? "" : ", ";
    std::string html = fmt::format("<div class=\"verdict {}\">", class_of(row.certainty));
    if (!row.claimed.empty()) {  // the verdict is about that, and stands below it
      html += "<p>" + capitalized(row.claimed_is) + ":</p>\n<ul class=\"claimed\">\n";
      for (const std::string& tex : row.claimed)
        html += "<li><div class=\"formula\">" + html_.line('$' + tex + '$') + "</div></li>\n";
      html += "</ul>\n";
    }
    // Seen, the chip's frame parts the two; heard, a comma does.
    const std::string note = row.note + std::string(comma) + row.example;
    html += fmt::format(
        "<p>{}<strong class=\"chip\"><span "
        "aria-hidden=\"true\">{}</span>{}</strong>{}<span class=\"heard\">.</span></p>\n",
        of, mark, html_escaped(row.word),
        note.empty() ? "" : "<span class=\"heard\">,</span> " + html_.line(note));
    return html + live_html(step, claim, model) + "</div>\n";
  }

  /// What both sides come to at the moment of the figure.
  std::string live_html(const Step& step, const Claim& claim, const SceneModel* model) const {
    if (model == nullptr || claim.in_other_words || !can_be_shown(claim, *step.scene)) return {};
    const double t_s = still_time_s(*step.scene);
    const auto live = is_computable(*model, t_s) ? live_state(*model, t_s) : std::nullopt;
    if (!live) return {};
    std::string rows;
    for (const std::string& row : live_rows(claim, *live, step.scene->views.front(), language()))
      if (!row.empty()) rows += (rows.empty() ? "" : "; ") + html_.line(row);
    return rows.empty()
               ? rows
               : "<p class=\"live\">" + words::kInTheFigure.with(language(), {time(t_s, 4), rows}) + "</p>\n";
  }

  std::string callout_html(const Callout& callout) const {
    using Kind = Callout::Kind;
    const std::string_view label = label_of(edition_.lesson, callout.kind);
    std::string html = fmt::format("<div class=\"callout {}\">\n<p class=\"label\">{}</p>\n",
                                   names_of(callout.kind).name, html_escaped(label));
    if (!callout.title.empty()) html += "<div class=\"title\">" + html_.blocks(callout.title) + "</div>\n";
    const std::string text = html_.blocks(callout.text);
    html += callout.kind == Kind::quote ? "<blockquote>" + text + "</blockquote>\n" : text;
    return html + "</div>\n";
  }

  std::string note_html(const Stage& stage, const Footnote& note) const {
    return fmt::format(
        "<div class=\"note\" role=\"note\" id=\"{}\"><span class=\"mark\">{}</span> {}</div>\n",
        html_escaped(note_id(stage, note.number)), raised_number(note.number), html_.blocks(note.text));
  }

  static std::string img(const ReaderPicture& picture) {
    const std::string image =
        fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\"/>", picture.size.width,
                    picture.size.height, html_escaped(picture.alt), picture.source);
    return picture.dark.empty() ? image
                                : fmt::format(
                                      "<picture><source media=\"screen and (prefers-color-scheme: "
                                      "dark)\" srcset=\"{}\"/>{}</picture>",
                                      picture.dark, image);
  }

  /// Steps that go on with a scene have no figure of their own.
  Outcome<std::string> figure_of(const Stage& stage, int step) {
    const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
    if (!of.scene || of.scene.get() == figure_) return std::string();
    figure_ = of.scene.get();
    const Outcome<ReaderPicture> picture = figures_.still(stage, step);
    if (!picture) return passed_on(picture);
    std::string html =
        "<figure" + (edition_.live ? live_attributes(stage, step) : "") + ">\n" + img(*picture) + '\n';
    const std::vector<std::string> captions = figures_.captions(of);
    const std::string open =
        edition_.live && has_computed_caption(of) ? "<figcaption data-computed>" : "<figcaption>";
    if (captions.size() == 1) html += open + html_.line(captions.front()) + "</figcaption>\n";
    if (captions.size() > 1) {
      html += open + "<ol>\n";
      for (const std::string& caption : captions) html += "<li>" + html_.line(caption) + "</li>\n";
      html += "</ol></figcaption>\n";
    }
    return html + "</figure>\n";
  }

  /// What a prediction is held against.
  Outcome<std::string> moments_html(const Stage& stage, int step, const Ask& ask) {
    const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
    if (!ask.plays || !of.scene) return std::string();
    const Outcome<std::vector<ReaderPicture>> moments = figures_.moments(stage, step, *ask.plays);
    if (!moments) return passed_on(moments);
    std::string html = "<div class=\"moments\">\n";
    for (const ReaderPicture& picture : *moments)
      html +=
          fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", img(picture), time(picture.t_s, 3));
    return html + "</div>\n";
  }

  const ReaderEdition& edition_;
  SpeechText speech_;
  TextNumbers numbers_;
  LessonHtml html_;
  ReaderFigures figures_;
  const Scene* figure_ = nullptr;  ///< that was shown last in the stage
};

/// How the page is found on the web, and how it looks where it is linked to.
std::string head_of(const ReaderEdition& edition) {
  if (!edition.place) return {};
  const ReaderPlace& place = *edition.place;
  const std::string outcomes = fmt::format("{}", fmt::join(edition.lesson.about.outcomes, "; "));
  const Lesson& lesson = edition.lesson;
  const std::string page = page_name(lesson.id, lesson.about.language) + ".html";
  std::string head = social_head(place.url, page, lesson.title, outcomes, place.preview);
  for (const Language language : place.languages)
    head += fmt::format("<link rel=\"alternate\" hreflang=\"{}\" href=\"{}{}.html\"/>\n", tag_of(language),
                        html_escaped(place.url), html_escaped(page_name(lesson.id, language)));
  return head;
}

std::string link_to_index(const ReaderEdition& edition) {
  if (!edition.place) return {};
  std::string html = fmt::format("<p class=\"site\"><a href=\"{}\">{}</a>", kSiteIndex,
                                 words::kAllLessons.in(edition.lesson.about.language));
  for (const Language language : edition.place->languages)
    html += fmt::format(" · <a href=\"{}.html\" lang=\"{}\" hreflang=\"{}\">{}</a>",
                        html_escaped(page_name(edition.lesson.id, language)), tag_of(language),
                        tag_of(language), words::kInAnotherLanguage.in(language));
  return html + "</p>\n";
}

std::string link_to_next(const ReaderEdition& edition) {
  if (!edition.place || edition.place->next.empty()) return {};
  const ReaderPlace& place = *edition.place;
  const Language language = edition.lesson.about.language;
  const std::string link = title_of_other(place.next_title, place.next + ".html", language);
  return "<p class=\"site next\">" + words::kNextLesson.with(language, {link}) + "</p>\n";
}

/// The error, where it is no full disk.
struct Stop {
  bool stopped = false;
  std::optional<Error> error{};
};

Status append_stages(ReaderText& text, const AppendBytes& append, const ReaderProgress& go_on, Stop& stop) {
  Status status = success();
  std::size_t count = 0;
  text.for_each_stage([&](const Stage& stage, std::size_t number) {
    if (status) status = append(bytes_of(text.begin(stage, number)));
    for (std::size_t i = 1; status && i <= stage.steps.size(); ++i) {
      stop.stopped = go_on && !go_on(count++, stage);
      if (stop.stopped) {
        status = failure("stopped");
        return;
      }
      const Outcome<std::string> step = text.step(stage, static_cast<int>(i));
      if (!step) stop.error = step.error();
      status = step ? append(bytes_of(*step)) : failure(step.error().text);
    }
    if (status) status = append(bytes_of(ReaderText::end()));
  });
  return status;
}

Status append_reader(const ReaderEdition& edition, Renderer& renderer, const AppendBytes& append,
                     const ReaderProgress& go_on, const Effort& effort, Stop& stop) try {
  const Lesson& lesson = edition.lesson;
  ReaderText text(edition, renderer, effort);
  const LiveParts* live = edition.live ? &*edition.live : nullptr;
  std::string style = reader_style(lesson), script = std::string("\n") + reader_assets::kReaderJs;
  if (live != nullptr) {
    style += live_assets::kLiveCss;
    script += std::string(live_assets::kLiveJs) + live_assets::kFiguresJs;
  }
  // Nothing is fetched, and nothing runs but what is written here, whatever the lesson says.
  const std::string policy = fmt::format(
      "default-src 'none'; img-src data:; style-src {}; script-src {}{}; base-uri 'none'; form-action 'none'",
      policy_hash(style), policy_hash(script), live != nullptr ? ' ' + live_policy(*live) : "");
  const std::map<std::string, std::string> texts = {
      {"language", std::string(tag_of(lesson.about.language))},
      {"to-the-text", std::string(words::kToTheText.in(lesson.about.language))},
      {"contents", std::string(words::kContents.in(lesson.about.language))},
      {"words", html_escaped(json_of(words::kEditionScript, lesson.about.language))},
      {"policy", policy},
      {"program", html_escaped(program_name_and_version())},
      {"title", html_escaped(lesson.title)},
      {"style", style},
      {"script", script},
      {"about", text.about()},
      {"live", live != nullptr ? live_elements(*live, lesson.about.language) : ""},
      {"outline", text.outline()},
      {"references", text.references()},
      {"head", head_of(edition)},
      {"index", link_to_index(edition)},
      {"next", link_to_next(edition)},
  };
  return append_frame(reader_assets::kReaderHtml, append, [&](const std::string& name) {
    return name == "stages" ? append_stages(text, append, go_on, stop) : append(bytes_of(texts.at(name)));
  });
} catch (const Interrupted&) {
  stop.stopped = true;
  return failure("stopped");
} catch (const std::exception& error) {  // no memory
  return failure(error.what());
}

}  // namespace

std::string page_name(const std::string& lesson_id, Language language) {
  return language == Language::en ? lesson_id : lesson_id + '.' + std::string(tag_of(language));
}

std::vector<ReaderEntry> entries_of(const ReaderEdition& edition, Renderer& renderer, const Effort& effort) {
  return ReaderText(edition, renderer, effort).entries();
}

std::size_t steps_of(const ReaderEdition& edition) {
  std::size_t count = 0;
  for (const Stage& stage : edition.lesson.stages)
    if (is_in(edition, stage)) count += stage.steps.size();
  return count;
}

Outcome<ReaderEnd> write_reader(const std::filesystem::path& file, const ReaderEdition& edition,
                                Renderer& renderer, Durability durability, const ReaderProgress& go_on,
                                const Effort& effort) {
  Stop stop;
  const Status written = write_file_in_pieces(
      file,
      [&](const AppendBytes& append) {
        return append_reader(edition, renderer, append, go_on, effort, stop);
      },
      durability);
  if (stop.stopped) return ReaderEnd::stopped;
  if (stop.error) return Failure{*stop.error};
  if (!written) return failed(written);
  return ReaderEnd::written;
}

}  // namespace polhode
