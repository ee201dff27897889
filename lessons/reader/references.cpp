// SPDX-License-Identifier: MIT
#include "lessons/reader/references.h"

#include "base/spelling.h"
#include "lessons/reader/front_matter/keys.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace polhode {
namespace {

/// What a reference within the lesson leads to.
struct Target {
  const Stage* stage = nullptr;
  const Equation* equation = nullptr;  ///< null: the stage itself
};

std::string link_to(const Target& target) {
  return '#' + target.stage->id + (target.equation != nullptr ? '/' + target.equation->id : "");
}

bool is_address(std::string_view link) {
  constexpr std::array<std::string_view, 3> kSchemes = {"https://", "http://", "mailto:"};
  return std::any_of(kSchemes.begin(), kSchemes.end(),
                     [&](std::string_view scheme) { return link.starts_with(scheme); });
}

class References {
 public:
  References(std::vector<Stage>& stages, Report& report)
      : stages_(stages), source_(report.source()), report_(report) {
    for (const Stage& stage : stages)
      for (const Equation* equation : equations_of(stage)) equations_[&stage].emplace(equation->id, equation);
  }

  std::vector<OutsideReference> run() {
    // First the titles, which links elsewhere show.
    is_title_ = true;
    for (Stage& stage : stages_) {
      resolve(stage.title_text, stage);
      for (Step& step : stage.steps) resolve(step.title, stage);
    }
    is_title_ = false;
    for (Stage& stage : stages_)
      for (Step& step : stage.steps) {
        for (Block& block : step.blocks) std::visit([&](auto& one) { resolve(one, stage); }, block);
        for (Callout& note : step.notes) resolve(note, stage);
        resolve_recalled(step, stage);
      }
    return std::move(outside_);
  }

 private:
  /// What a slide recalls, as "stage/equation". Numbers in it are of another step, and nobody has them here.
  void resolve_recalled(Step& step, const Stage& stage) {
    if (step.from.empty() || step.from == kRecallsNothing) return;
    const auto target = find(step.from, stage, Wanted::equation, step.place);
    if (!target) return step.from.clear();
    step.from = target->stage->id + '/' + target->equation->id;
    if (target->stage != &stage && !target->equation->math.live.empty())
      report_.error(step.place,
                    "the slide recalls equation " + in_quotes(step.from) +
                        ", whose computed numbers are those of another stage",
                    "recall one without numbers");
  }

  void resolve(Prose& prose, const Stage& stage) { resolve(prose.text, stage); }
  void resolve(Claim&, const Stage&) {}
  void resolve(Footnote& note, const Stage& stage) { resolve(note.text, stage); }
  void resolve(Equation& equation, const Stage& stage) { resolve(equation.math, equation.offset, stage); }
  void resolve(Callout& callout, const Stage& stage) {
    resolve(callout.text, stage);
    resolve(callout.title, stage);
  }
  void resolve(Ask& ask, const Stage& stage) {
    resolve(ask.prompt_text, stage);
    for (RichText& choice : ask.choice_texts) resolve(choice, stage);
    for (RichText& reply : ask.replies) resolve(reply, stage);
    for (RichText& hint : ask.hint_texts) resolve(hint, stage);
    resolve(ask.because, stage);
  }

  void resolve(RichText& text, const Stage& stage) {
    for (TextBlock& block : text) {
      resolve(block.spans, stage);
      for (auto& row : block.table.rows)
        for (TextTable::Cell& cell : row) resolve(cell, stage);
    }
  }

  void resolve(std::vector<TextSpan>& text, const Stage& stage) {
    std::vector<TextSpan> spans;
    spans.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
      const std::string link = text[i].link;
      const bool leads = !link.empty() && !link.starts_with(kCiteLink);
      const auto end = leads ? leads_to(link, place_of(text[i]), stage) : std::nullopt;
      // A link with emphasis or formulas in it has several spans.
      do add(std::move(text[i++]), end, stage, spans);
      while (leads && i < text.size() && text[i].link == link);
    }
    text = std::move(spans);
  }

  void resolve(Math& math, std::size_t offset, const Stage& stage) {
    std::map<std::string, ShownReference> shown;
    for (const MathReference& reference : math.references) {
      const SourcePlace place = source_.place_of(offset + reference.offset);
      if (const auto target = find(reference.id, stage, Wanted::equation, place))
        if (auto number = number_of(*target->equation, place))
          shown[reference.id] = {link_to(*target), std::move(*number)};
    }
    if (!shown.empty()) math = with_references(math, shown);
  }

  /// Where a link leads, as it is written from now on.
  struct End {
    std::string link;
    std::optional<Target> target{};  ///< nothing: it leads out of the lesson
  };

  void add(TextSpan span, const std::optional<End>& end, const Stage& stage, std::vector<TextSpan>& spans) {
    if (span.kind == TextSpan::Kind::math) resolve(span.math, span.source.begin, stage);
    if (end) span.link = end->link;
    if (!end || span.kind == TextSpan::Kind::math || !span.text.empty())
      spans.push_back(std::move(span));
    else
      add_shown(*end, span, spans);
  }

  /// What a link without text shows.
  void add_shown(const End& end, const TextSpan& span, std::vector<TextSpan>& spans) {
    const SourcePlace place = place_of(span);
    if (!end.target) return report_.error(place, "a link out of the lesson needs a text", "[text](…)");
    if (is_title_) return report_.error(place, "a link in a title needs a text", "[text](…)");
    TextSpan shown = span;
    if (const Equation* equation = end.target->equation) {
      const auto number = number_of(*equation, place);
      if (!number || !has_room_for(number->size(), place)) return;
      shown.text = '(' + *number + ')';
      spans.push_back(std::move(shown));
      return;
    }
    for (const TextBlock& block : end.target->stage->title_text)
      for (const TextSpan& part : block.spans) {
        if (!has_room_for(part.text.size(), place)) return;
        spans.push_back(part);
        spans.back().link = end.link;
        if (part.kind == TextSpan::Kind::text) spans.back().source = span.source;
      }
  }

  bool has_room_for(std::size_t bytes, SourcePlace place) {
    const bool was_full = shown_bytes_ > kMaxShownReferenceBytes;
    shown_bytes_ += bytes;
    if (!was_full && shown_bytes_ > kMaxShownReferenceBytes)
      report_.error(place, "the links of a lesson without a text show at most " +
                               std::to_string(kMaxShownReferenceBytes) + " bytes in all");
    return shown_bytes_ <= kMaxShownReferenceBytes;
  }

  std::optional<std::string> number_of(const Equation& equation, SourcePlace place) {
    if (!equation.tag.empty()) return equation.tag;
    report_.error(place, "equation " + in_quotes(equation.id) + " has no number to be shown",
                  "give it a \\tag{…}, or the link a text");
    return std::nullopt;
  }

  std::optional<End> leads_to(const std::string& link, SourcePlace place, const Stage& stage) {
    if (is_address(link)) return End{link};
    const std::size_t hash = link.find('#');
    if (hash == link.npos) {
      report_.error(place, "this link leads nowhere: " + in_quotes(link),
                    "write https://…, #stage, #equation, #stage/equation or lesson#stage");
      return std::nullopt;
    }
    const std::string id = link.substr(hash + 1);
    if (hash > 0) return leads_outside(link.substr(0, hash), id, link, place);
    const auto target = find(id, stage, Wanted::any, place);
    return target ? std::optional(End{link_to(*target), target}) : std::nullopt;
  }

  std::optional<End> leads_outside(const std::string& lesson, const std::string& id, const std::string& link,
                                   SourcePlace place) {
    const std::size_t slash = std::min(id.find('/'), id.size());
    const std::string stage = id.substr(0, slash), equation = id.substr(std::min(slash + 1, id.size()));
    if (!is_id(lesson) || !is_id(stage) || (slash < id.size() && !is_id(equation))) {
      report_.error(place, "bad link to another lesson: " + in_quotes(link),
                    "write lesson#stage or lesson#stage/equation");
      return std::nullopt;
    }
    outside_.push_back({lesson, stage, equation, place});
    return End{link};
  }

  enum class Wanted { any, equation };

  /// What "stage", "equation" or "stage/equation" is, for somebody in `here`.
  std::optional<Target> find(const std::string& id, const Stage& here, Wanted wanted, SourcePlace place) {
    if (report_.is_full()) return std::nullopt;  // what may have been meant takes time to find
    const std::size_t slash = id.find('/');
    if (slash != id.npos) return find_in(id.substr(0, slash), id.substr(slash + 1), place);
    if (const Stage* stage = stage_called(id); stage != nullptr && wanted == Wanted::any)
      return Target{stage, nullptr};
    if (const Equation* equation = equation_called(id, here)) return Target{&here, equation};
    const std::string what = wanted == Wanted::any ? "no stage, and no equation of this one, is called "
                                                   : "no equation of this stage is called ";
    report_.error(place, what + in_quotes(id), hint_on(id, here, wanted));
    return std::nullopt;
  }

  std::optional<Target> find_in(const std::string& stage_id, const std::string& id, SourcePlace place) {
    const Stage* stage = stage_called(stage_id);
    const Equation* equation = stage == nullptr ? nullptr : equation_called(id, *stage);
    if (equation != nullptr) return Target{stage, equation};
    if (stage == nullptr)
      report_.error(place, "no stage is called " + in_quotes(stage_id), suggestion(stage_id, stage_ids()));
    else
      report_.error(place, "no equation of stage " + in_quotes(stage_id) + " is called " + in_quotes(id),
                    suggestion(id, equation_ids(*stage)));
    return std::nullopt;
  }

  /// An equation of that id elsewhere, or a name that may have been meant.
  std::string hint_on(const std::string& id, const Stage& here, Wanted wanted) const {
    for (const Stage& stage : stages_)
      if (equation_called(id, stage) != nullptr)
        return "that of stage " + in_quotes(stage.id) + " is " + (wanted == Wanted::any ? "#" : "") +
               stage.id + '/' + id;
    std::vector<std::string> known = equation_ids(here);
    if (wanted == Wanted::any) {
      const std::vector<std::string> stages = stage_ids();
      known.insert(known.end(), stages.begin(), stages.end());
    }
    return suggestion(id, known);
  }

  const Stage* stage_called(const std::string& id) const {
    const auto found =
        std::find_if(stages_.begin(), stages_.end(), [&](const Stage& stage) { return stage.id == id; });
    return found == stages_.end() ? nullptr : &*found;
  }
  const Equation* equation_called(const std::string& id, const Stage& stage) const {
    const auto all = equations_.find(&stage);
    if (all == equations_.end()) return nullptr;
    const auto found = all->second.find(id);
    return found == all->second.end() ? nullptr : found->second;
  }
  std::vector<std::string> stage_ids() const {
    std::vector<std::string> ids;
    for (const Stage& stage : stages_) ids.push_back(stage.id);
    return ids;
  }
  std::vector<std::string> equation_ids(const Stage& stage) const {
    std::vector<std::string> ids;
    if (const auto all = equations_.find(&stage); all != equations_.end())
      for (const auto& [id, equation] : all->second) ids.push_back(id);
    return ids;
  }

  SourcePlace place_of(const TextSpan& span) const { return source_.place_of(span.source.begin); }

  std::vector<Stage>& stages_;
  const SourceText& source_;
  Report& report_;
  std::map<const Stage*, std::map<std::string, const Equation*>> equations_;
  std::vector<OutsideReference> outside_;
  std::size_t shown_bytes_ = 0;
  bool is_title_ = false;  ///< what is resolved now
};

}  // namespace

std::vector<OutsideReference> resolve_references(std::vector<Stage>& stages, Report& report) {
  return References(stages, report).run();
}

}  // namespace polhode
