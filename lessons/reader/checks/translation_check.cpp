// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/translation_check.h"

#include "base/ascii.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/relation.h"
#include "lessons/diagnostics/report.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/toml_tree.h"
#include "lessons/reader/questions/state_task.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <variant>

namespace polhode {

namespace {

/// TeX with the words of its texts left out, and without blanks that say nothing.
std::string without_words(std::string_view tex) {
  constexpr std::string_view kText = "\\text{";
  std::string rest;
  while (!tex.empty()) {
    if (tex.starts_with(kText)) {
      const std::size_t end = std::min(tex.find('}', kText.size()), tex.size());
      rest += kText;
      tex.remove_prefix(end);
    } else {
      if (tex.front() != ' ' && tex.front() != '\n') rest += tex.front();
      tex.remove_prefix(1);
    }
  }
  return rest;
}

/// "1.75", "1,75" where numbers have commas, "12": those of a line that is no formula, with points.
std::vector<std::string> numbers_of(std::string_view words, Language language) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!is_digit(words[i])) continue;
    std::string number;
    for (; i < words.size(); ++i) {
      const bool is_mark = words[i] == decimal_mark(language) && number.find('.') == number.npos &&
                           i + 1 < words.size() && is_digit(words[i + 1]);
      if (!is_digit(words[i]) && !is_mark) break;
      number += is_mark ? '.' : words[i];
    }
    numbers.push_back(std::move(number));
  }
  return numbers;
}

/// What a text says besides words, sorted: an order of words may be another.
struct Said {
  std::vector<std::string> formulas, numbers, links;
  bool operator==(const Said&) const = default;
};

Said said_in(const RichText& text, Language language) {
  Said said;
  for_each_span(text, [&](const TextSpan& span) {
    if (!span.link.empty()) said.links.push_back(span.link);
    if (span.kind == TextSpan::Kind::math)
      said.formulas.push_back(without_words(span.text));
    else
      for (std::string& number : numbers_of(span.text, language)) said.numbers.push_back(std::move(number));
  });
  for (auto* list : {&said.formulas, &said.numbers, &said.links}) std::sort(list->begin(), list->end());
  // A link may be of several words, with a formula among them.
  said.links.erase(std::unique(said.links.begin(), said.links.end()), said.links.end());
  return said;
}

/// The first of a sorted list that the other lacks; empty: none.
std::string first_missing(const std::vector<std::string>& list, const std::vector<std::string>& other) {
  std::vector<std::string> missing;
  std::set_difference(list.begin(), list.end(), other.begin(), other.end(), std::back_inserter(missing));
  return missing.empty() ? "" : missing.front();
}

/// A scene as it is moved and drawn: what is written in it are words.
Scene without_words(Scene scene) {
  scene.caption.clear();
  scene.label.clear();
  scene.language = Language::en;
  for (PlotSpec& spec : scene.meters)
    if (auto* own = std::get_if<OwnPlot>(&spec)) {
      own->title.clear();
      for (std::string& tex : own->tex) tex = without_words(tex);
    }
  for (ArrowMark& arrow : scene.marks.arrows)
    if (arrow.tex) arrow.tex = without_words(*arrow.tex);
  for (AngleMark& angle : scene.marks.angles) angle.tex = without_words(angle.tex);
  for (AreaMark& area : scene.marks.areas) area.tex = without_words(area.tex);
  for (NoteMark& note : scene.marks.notes) note.text.clear();
  for (Scene& beside : scene.beside) beside = without_words(std::move(beside));
  return scene;
}

std::string name_of(const Block& block) {
  constexpr std::array<std::string_view, std::variant_size_v<Block>> kNames = {
      "a text", "an equation", "a claim", "a call-out", "a question", "a footnote"};
  return std::string(kNames[block.index()]);
}

SourcePlace place_of(const Block& block) {
  return std::visit([](const auto& one) { return one.place; }, block);
}

class TranslationCheck {
 public:
  TranslationCheck(const Lesson& translated, std::string_view file, const Lesson& original,
                   std::string_view original_file)
      : translated_(translated),
        original_(original),
        original_file_(original_file),
        source_(translated.source),
        report_(source_, file) {}

  std::vector<Diagnostic> run() {
    if (translated_.id != original_.id)
      differs({1, 1}, {1, 1}, fmt::format("the id is \"{}\", and \"{}\"", translated_.id, original_.id));
    check_front_matter();
    if (is_as_many("the lesson", "stages", translated_.stages.size(), original_.stages.size(), {1, 1},
                   {1, 1}))
      for (std::size_t i = 0; i < original_.stages.size(); ++i)
        check(translated_.stages[i], original_.stages[i]);
    return report_.take();
  }

 private:
  /// What is said of both, the translation's first; it ends with what the original has.
  void differs(SourcePlace place, SourcePlace of_original, const std::string& what) {
    report_.error(place, fmt::format("{} in {}:{}", what, original_file_, of_original.line),
                  "a translation differs in words alone");
  }

  bool is_as_many(const std::string& of, const char* what, std::size_t here, std::size_t there,
                  SourcePlace place, SourcePlace of_original) {
    if (here != there)
      differs(place, of_original, fmt::format("{} has {} {}, and {}", of, here, what, there));
    return here == there;
  }

  void check(const Stage& here, const Stage& there) {
    if (here.id != there.id)
      return differs(here.place, there.place,
                     fmt::format("the stage is \"{}\", and \"{}\"", here.id, there.id));
    check_text(here.title_text, there.title_text, here.place, there.place, "this title");
    if (!is_as_many("this stage", "steps", here.steps.size(), there.steps.size(), here.place, there.place))
      return;
    for (std::size_t i = 0; i < here.steps.size(); ++i) check(here.steps[i], there.steps[i]);
  }

  void check(const Step& here, const Step& there) {
    check_text(here.title, there.title, here.place, there.place, "this title");
    if (is_as_many("this step", "parts", here.blocks.size(), there.blocks.size(), here.place, there.place))
      for (std::size_t i = 0; i < here.blocks.size(); ++i) check(here.blocks[i], there.blocks[i]);
    if (is_as_many("this step", "notes", here.notes.size(), there.notes.size(), here.place, there.place))
      for (std::size_t i = 0; i < here.notes.size(); ++i) check(Block(here.notes[i]), Block(there.notes[i]));
    check_scenes(here, there);
    if (here.from != there.from)
      differs(here.place, there.place,
              fmt::format("this step goes on from \"{}\", and from \"{}\"", here.from, there.from));
    if (here.same.empty() != there.same.empty())
      differs(here.place, there.place,
              "why its picture stays is said of this step in one of the two, and not");
  }

  void check_scenes(const Step& here, const Step& there) {
    if ((here.scene == nullptr) != (there.scene == nullptr))
      return differs(here.place, there.place,
                     here.scene ? "this step has a scene, and none" : "this step has no scene, and one");
    if (!here.scene || (here.scene == seen_ && there.scene == seen_there_)) return;
    seen_ = here.scene;
    seen_there_ = there.scene;
    if (!(without_words(*here.scene) == without_words(*there.scene)))
      differs(here.place, there.place, "the scene of this step is not that");
    if (!is_as_many("this step", "captions", here.captions.size(), there.captions.size(), here.place,
                    there.place))
      return;
    for (std::size_t i = 0; i < here.captions.size(); ++i) {
      static const RichText kNone;
      check_text(here.captions[i] ? *here.captions[i] : kNone, there.captions[i] ? *there.captions[i] : kNone,
                 here.place, there.place, "a caption of this step");
    }
  }

  void check(const Block& here, const Block& there) {
    const SourcePlace place = place_of(here), of_original = place_of(there);
    if (here.index() != there.index())
      return differs(place, of_original, fmt::format("here is {}, and {}", name_of(here), name_of(there)));
    std::visit([&]<class Kind>(const Kind& one) { check(one, std::get<Kind>(there), place, of_original); },
               here);
  }

  void check(const Prose& here, const Prose& there, SourcePlace place, SourcePlace of_original) {
    check_text(here.text, there.text, place, of_original, "this text");
  }
  void check(const Footnote& here, const Footnote& there, SourcePlace place, SourcePlace of_original) {
    check_text(here.text, there.text, place, of_original, "this footnote");
  }
  void check(const Callout& here, const Callout& there, SourcePlace place, SourcePlace of_original) {
    if (here.kind != there.kind)
      return differs(place, of_original,
                     fmt::format("this call-out is \"{}\", and \"{}\"", names_of(here.kind).name,
                                 names_of(there.kind).name));
    check_text(here.text, there.text, place, of_original, "this call-out");
    check_text(here.title, there.title, place, of_original, "the title of this call-out");
  }
  void check(const Equation& here, const Equation& there, SourcePlace place, SourcePlace of_original) {
    if (here.id != there.id)
      return differs(place, of_original,
                     fmt::format("the equation is \"{}\", and \"{}\"", here.id, there.id));
    if (here.tag != there.tag)
      differs(place, of_original,
              fmt::format("the equation has the number \"{}\", and \"{}\"", here.tag, there.tag));
    if (without_words(here.tex) != without_words(there.tex))
      differs(place, of_original, fmt::format("equation \"{}\" is not that", here.id));
  }

  void check(const Claim& here, const Claim& there, SourcePlace place, SourcePlace of_original) {
    const auto lines = [](const Claim& claim) {
      std::vector<std::string> all;
      for (const ClaimLine& line : claim.lines) {
        all.push_back(line.equality.left.text + ' ' + std::string(sign_of(line.relation)) + ' ' +
                      line.equality.right.text);
        if (line.conclusion)
          all.back() += " => " + line.conclusion->left.text + " = " + line.conclusion->right.text;
        if (line.within) all.back() += fmt::format(" within {}", *line.within);
      }
      return all;
    };
    const bool is_same = here.equation == there.equation && here.kind == there.kind &&
                         here.origin == there.origin && lines(here) == lines(there) &&
                         printed_conditions(here.given) == printed_conditions(there.given) &&
                         printed_small(here.given) == printed_small(there.given);
    if (!is_same) differs(place, of_original, "what is claimed here is not what is claimed");
  }

  void check(const Ask& here, const Ask& there, SourcePlace place, SourcePlace of_original) {
    if (here.id != there.id)
      return differs(place, of_original,
                     fmt::format("the question is \"{}\", and \"{}\"", here.id, there.id));
    const auto fails = [&](const std::string& what) {
      differs(place, of_original, fmt::format("question \"{}\" has another {} than", here.id, what));
    };
    if (here.type != there.type) return fails("type");
    if (here.outcomes != there.outcomes) fails("outcome");
    if (here.answers != there.answers || !has_same_answer(here, there)) fails("right answer");
    if (here.modulo != there.modulo || here.letters != there.letters ||
        printed_conditions(here.given) != printed_conditions(there.given))
      fails("condition");
    if (here.plays.has_value() != there.plays.has_value() ||
        (here.plays && (here.plays->from_s != there.plays->from_s || here.plays->to_s != there.plays->to_s)))
      fails("interval to play");
    check_text(here.prompt_text, there.prompt_text, place, of_original, "the prompt");
    check_text(here.because, there.because, place, of_original, "why the answer is right");
    check_texts(here.choice_texts, there.choice_texts, place, of_original, "choice");
    check_texts(here.replies, there.replies, place, of_original, "reply");
    check_texts(here.hint_texts, there.hint_texts, place, of_original, "hint");
  }

  static bool has_same_answer(const Ask& here, const Ask& there) {
    const auto text = [](const std::optional<Expression>& expression) {
      return expression ? expression->text : std::string();
    };
    if (text(here.expression) != text(there.expression)) return false;
    if ((here.number == nullptr) != (there.number == nullptr) ||
        (here.task == nullptr) != (there.task == nullptr) ||
        (here.derivation == nullptr) != (there.derivation == nullptr))
      return false;
    if (here.number &&
        (text(here.number->expression) != text(there.number->expression) ||
         (!here.number->expression && here.number->value != there.number->value) ||
         here.number->unit != there.number->unit || here.number->within != there.number->within))
      return false;
    if (!here.task) return true;
    const auto goals = [](const StateTask& task) {
      std::vector<std::string> all;
      for (const StateGoal& goal : task.goals)
        all.push_back(goal.number.written.expression + ' ' + range_of(goal));
      return all;
    };
    return goals(*here.task) == goals(*there.task) && here.task->change == there.task->change;
  }

  void check_texts(const std::vector<RichText>& here, const std::vector<RichText>& there, SourcePlace place,
                   SourcePlace of_original, const std::string& what) {
    if (!is_as_many("this question", (what + 's').c_str(), here.size(), there.size(), place, of_original))
      return;
    for (std::size_t i = 0; i < here.size(); ++i)
      check_text(here[i], there[i], place, of_original, fmt::format("{} {}", what, i + 1));
  }

  void check_text(const RichText& here, const RichText& there, SourcePlace place, SourcePlace of_original,
                  const std::string& what) {
    if (here.empty() != there.empty())
      return differs(place, of_original,
                     here.empty() ? what + " is missing, and not" : what + " is there, and not");
    const Said said = said_in(here, translated_.about.language),
               meant = said_in(there, original_.about.language);
    if (said == meant) return;
    const auto tell = [&](const std::vector<std::string>& one, const std::vector<std::string>& other,
                          const char* name) {
      if (const std::string lost = first_missing(other, one); !lost.empty())
        differs(place, of_original,
                fmt::format("{} lacks the {} {} that stands", what, name, in_quotes(lost)));
      else if (const std::string added = first_missing(one, other); !added.empty())
        differs(place, of_original,
                fmt::format("{} has the {} {}, which does not stand", what, name, in_quotes(added)));
    };
    tell(said.formulas, meant.formulas, "formula");
    tell(said.numbers, meant.numbers, "number");
    tell(said.links, meant.links, "link");
  }

  // ---- The front matter, as TOML

  std::optional<TomlTable> front_matter_of(const SourceText& source, Report& report) const {
    int last = 2;
    while (last <= source.line_count() && trimmed(source.line(last)) != "+++") ++last;
    return parse_toml(source.lines(2, last - 1), 2, report);
  }

  void check_front_matter() {
    const SourceText source(original_.source);
    Report ignored(source, original_file_);
    const auto here = front_matter_of(source_, report_), there = front_matter_of(source, ignored);
    if (here && there) check(*here, *there, {1, 1}, {1, 1}, "");
  }

  static bool is_of_words(std::string_view key) {
    static const std::set<std::string_view> kWords = {"title",   "language", "author",
                                                      "licence", "labels",   "caption"};
    return kWords.contains(key);
  }

  void check(const TomlTable& here, const TomlTable& there, SourcePlace place, SourcePlace of_original,
             const std::string& within) {
    for (const TomlEntry& entry : there.entries)
      if (!is_of_words(entry.key) && here.find(entry.key) == nullptr)
        differs(place, entry.place, fmt::format("{} is missing that stands", in_quotes(within + entry.key)));
    for (const TomlEntry& entry : here.entries) {
      if (is_of_words(entry.key)) continue;
      const TomlEntry* other = there.find(entry.key);
      if (other == nullptr)
        differs(entry.place, of_original, fmt::format("{} does not stand", in_quotes(within + entry.key)));
      else
        check(entry.value, other->value, entry, *other, within + entry.key);
    }
  }

  void check(const TomlValue& here, const TomlValue& there, const TomlEntry& entry, const TomlEntry& other,
             const std::string& name) {
    static const std::set<std::string_view> kTexts = {"say", "note", "outcomes", "prerequisites"};
    const auto *list = here.as<TomlArray>(), *other_list = there.as<TomlArray>();
    const auto *table = here.as<TomlTable>(), *other_table = there.as<TomlTable>();
    if (table != nullptr && other_table != nullptr)
      return check(*table, *other_table, entry.place, other.place, name + '.');
    if (list != nullptr && other_list != nullptr && list->size() == other_list->size()) {
      for (std::size_t i = 0; i < list->size(); ++i) check((*list)[i], (*other_list)[i], entry, other, name);
      return;
    }
    const auto *text = here.as<std::string>(), *other_text = there.as<std::string>();
    if (text != nullptr && other_text != nullptr) {
      const bool is_text = kTexts.contains(entry.key) || name.starts_with("references.");
      if (is_text || without_words(*text) == without_words(*other_text)) return;
    } else if (here.held.index() == there.held.index() && here.as<TomlArray>() == nullptr &&
               are_same_numbers(here, there)) {
      return;
    }
    differs(here.place, there.place, fmt::format("{} is not what it is", in_quotes(name)));
  }

  static bool are_same_numbers(const TomlValue& a, const TomlValue& b) {
    const auto same = [&]<class Kind>(const Kind* one) {
      const auto* other = b.as<Kind>();
      return one != nullptr && other != nullptr && *one == *other;
    };
    return same(a.as<std::int64_t>()) || same(a.as<double>()) || same(a.as<bool>());
  }

  const Lesson& translated_;
  const Lesson& original_;
  std::string original_file_;
  SourceText source_;
  Report report_;
  std::shared_ptr<const Scene> seen_, seen_there_;
};

}  // namespace

std::string original_of(std::string_view file_name) {
  constexpr std::string_view kEnding = ".md";
  if (!file_name.ends_with(kEnding)) return "";
  file_name.remove_suffix(kEnding.size());
  const std::size_t dot = file_name.rfind('.');
  if (dot == file_name.npos || dot == 0 || file_name.find('/', dot) != file_name.npos) return "";
  if (!language_from(file_name.substr(dot + 1))) return "";
  return std::string(file_name.substr(0, dot)) + std::string(kEnding);
}

std::vector<Diagnostic> check_translation(const Lesson& translated, std::string_view file,
                                          const Lesson& original, std::string_view original_file) {
  return TranslationCheck(translated, file, original, original_file).run();
}

}  // namespace polhode
