// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/claim_check.h"

#include "base/numbers.h"
#include "lessons/claims/live_claims.h"
#include "lessons/claims/proof/counterexample_text.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/checks/claim_kind_check.h"
#include "lessons/reader/checks/derivation_check.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/name_check.h"
#include "lessons/reader/checks/numbers/number_check.h"
#include "lessons/reader/checks/printed_claim_check.h"
#include "lessons/reader/checks/prompt_check.h"
#include "lessons/reader/checks/spoken_name_check.h"
#include "lessons/reader/checks/statement_check.h"
#include "lessons/reader/questions/state_keys.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace polhode {
namespace {

std::int64_t nodes_in(const ClaimLine& line) {
  return nodes_in(line.equality) + (line.conclusion ? nodes_in(*line.conclusion) : 0);
}

/// A counterexample calls constants by their names: as the lesson prints them.
void print_constants(const Vocabulary& vocabulary, Counterexample& counterexample) {
  for (const Vocabulary::Word& word : vocabulary.words()) {
    if (!word.constant() || word.tex.empty()) continue;
    const std::string name = name_in_tex(word.name);
    for (std::size_t at = 0; (at = counterexample.state_tex.find(name, at)) != std::string::npos;)
      counterexample.state_tex.replace(at, name.size(), word.tex), at += word.tex.size();
  }
}

void prove(Claim& claim, const Prover& prover, const Vocabulary& vocabulary, const Effort& effort) {
  for (ClaimLine& line : claim.lines) {
    spend(effort, kClaimLineEvaluations + kClaimNodeEvaluations * nodes_in(line));
    // Inequalities and conditions are written out in symbols; what holds to an order is expanded.
    const bool writes_out =
        line.relation != Relation::equal || (line.conclusion && claim.kind != ClaimKind::non_sequitur);
    if (writes_out) spend(effort, kWrittenOutEvaluations);
    Judgement judgement = judge(line, claim.kind, prover, claim.given);
    const bool has_angle =
        line.equality.left.uses(Operation::acos) || line.equality.right.uses(Operation::acos);
    const bool searched = judgement.verdict == Verdict::fails || judgement.verdict == Verdict::not_refuted ||
                          claim.kind == ClaimKind::is_false || has_angle;
    if (searched && !judgement.counterexample) spend(effort, kVainSearchEvaluations);
    if (judgement.counterexample) print_constants(vocabulary, *judgement.counterexample);
    line.judgement = std::move(judgement);
  }
}

class ClaimCheck {
 public:
  ClaimCheck(const Lesson& lesson, std::string_view file, const Effort& effort)
      : lesson_(lesson),
        source_(lesson.source),
        report_(source_, file),
        effort_(effort),
        number_check_(lesson, report_, effort),
        statement_check_(lesson, report_, effort) {}

  std::vector<Diagnostic> run() {
    SourcePlace place;
    try {
      if (reads_words_) check_spoken_names(lesson_, source_, prover_, report_, effort_);
      for (const Stage& stage : lesson_.stages) {
        equations_ = equations_of(stage);
        statement_check_.begin_stage(stage);
        for (const Step& step : stage.steps) {
          still_.reset();
          model_.reset();
          shown_.reset();
          if (&step == &stage.steps.front()) check_text(stage.title_text, step);
          check_text(step.title, step);
          for (const Block& block : step.blocks) {
            if (report_.is_full()) return report_.take();
            check_block(block, step, place);
          }
          for (const Callout& note : step.notes) {
            if (report_.is_full()) return report_.take();
            check_block(Block(note), step, place);
          }
          check_captions(step);
          if (step.scene && step.scene != scene_) check_labels(step);
          if (step.scene && step.scene != scene_) check_names(step);
          scene_ = step.scene;
        }
      }
    } catch (const BudgetSpent&) {
      const Diagnostic all = too_long_to_check("", place);
      report_.error(place, all.message, all.hint);
    }
    return report_.take();
  }

 private:
  void check_block(const Block& block, const Step& step, SourcePlace& place) {
    place = std::visit([](const auto& b) { return b.place; }, block);
    try {
      check_numbers(numbers_in(block), step);
      std::visit([&](const auto& b) { check(b, step); }, block);
    } catch (const std::domain_error& error) {
      report_.error(place, std::string("this cannot be checked: ") + error.what());
    }
  }

  template <class Other>
  void check(const Other&, const Step&) {}

  void check(const Equation& equation, const Step& step) {
    check_braces(equation, lesson_, source_, prover_, report_, effort_);
    if (reads_words_ && !is_proved_as_printed(equation, step))
      statement_check_.check_display(equation, text_before(equation, step), [&] { return motions_of(step); });
    if (equation.math.live.empty() || !step.scene) return;
    const auto at = std::find(equations_.begin(), equations_.end(), &equation);
    const Math* above =
        at == equations_.begin() || at == equations_.end() ? nullptr : &(*std::prev(at))->math;
    const Claim* proved = nullptr;
    for (const Claim* claim : blocks_of<Claim>(step))
      if (claim->equation == equation.id && claim->origin == Claim::Origin::formula) proved = claim;
    // What does not hold, or not of this motion, is said of the claim.
    if (proved != nullptr &&
        (!holds(*proved) || (proved->kind == ClaimKind::free && !step.scene->torque.empty())))
      return;
    if (model_of(step) != nullptr)
      number_check_.check_formula(equation.math, above, motion_of(step), proved != nullptr);
  }

  /// The prose that stands directly before a display; null if there is none.
  static const RichText* text_before(const Equation& equation, const Step& step) {
    const RichText* text = nullptr;
    for (const Block& block : step.blocks) {
      if (std::get_if<Equation>(&block) == &equation) return text;
      const auto* prose = std::get_if<Prose>(&block);
      text = prose == nullptr ? nullptr : &prose->text;
    }
    return nullptr;
  }

  static bool is_proved_as_printed(const Equation& equation, const Step& step) {
    const auto claims = blocks_of<Claim>(step);
    return std::any_of(claims.begin(), claims.end(), [&](const Claim* claim) {
      return claim->equation == equation.id && claim->origin == Claim::Origin::formula;
    });
  }

  static bool holds(const Claim& claim) {
    return std::all_of(claim.lines.begin(), claim.lines.end(), [](const ClaimLine& line) {
      return line.judgement && line.judgement->verdict == Verdict::holds;
    });
  }

  void check(const Prose& prose, const Step& step) { check_text(prose.text, step); }
  void check(const Callout& callout, const Step& step) { check_text(callout.text, step); }
  void check(const Footnote& note, const Step& step) { check_text(note.text, step); }

  /// What stands around the numbers of a text.
  enum class TextOf { lesson, prompt, choice };
  void check_text(const RichText& text, const Step& step, TextOf of = TextOf::lesson) {
    if (!reads_words_) return check_computed(text, step);
    const auto motions = [&] { return motions_of(step); };
    if (of == TextOf::choice)
      statement_check_.check_choice(text, motions);
    else
      statement_check_.check_text(text, motions);
    if (of != TextOf::prompt)
      statement_check_.check_typed_numbers(text, motions);  // what is given is the question's
    if (step.scene && !step.scene->beside.empty() && !numbers_in(text).empty())
      statement_check_.check_whose(text, motions_of(step), step.scene->before);
    check_computed(text, step);
  }

  /// What is printed around numbers that are computed.
  void check_computed(const RichText& text, const Step& step) {
    if (numbers_in(text).empty()) return;
    number_check_.check_computed_tables(text);
    if (step.scene && model_of(step) != nullptr) number_check_.check_text(text, motion_of(step));
  }

  void check(const Ask& ask, const Step& step) {
    check_text(ask.prompt_text, step, TextOf::prompt);
    for (const auto* texts : {&ask.replies, &ask.hint_texts})
      for (const RichText& text : *texts) check_text(text, step);
    // A choice that is wrong may say what is not so.
    for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
      if (ask.type == Question::Type::order || ask.answers == std::vector{static_cast<int>(i) + 1})
        check_text(ask.choice_texts[i], step, TextOf::choice);
    check_text(ask.because, step);
    if (reads_words_)
      check_prompt(
          ask, lesson_, prover_, [&] { return motions_of(step); }, report_, effort_);
    if (ask.derivation) check_derivation(ask, *ask.derivation, prover_, report_, effort_);
    if (ask.task) check_state_task(ask, report_, effort_);
    const auto& answer = ask.expression;
    if (answer && prover_.settle({*answer, *answer}, LawsAssumed::identity, ask.given) != Verdict::holds)
      report_.error(ask.place, "the answer of question " + in_quotes(ask.id) + " is nowhere defined");
  }

  /// Each caption's numbers are those of its own scene; one that stands once below all has to be so of all.
  void check_captions(const Step& step) {
    if (!step.scene) return;
    const std::vector<const Scene*> shown = shown_scenes(*step.scene);
    const RichText* first = caption_of(step, step.scene->before);
    if (first != nullptr) {
      check_numbers(numbers_in(*first), step);
      check_computed(*first, step);
    }
    check_typed_captions(step, shown);
    std::vector<SceneModel> models;
    models.reserve(shown.size());
    const bool is_shared = shown.size() > 1 && std::all_of(shown.begin(), shown.end(), [&](const Scene* one) {
                             return one->caption == shown.front()->caption;
                           });
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const RichText* caption = caption_of(step, i);
      const std::vector<int> ids = caption == nullptr ? std::vector<int>() : numbers_in(*caption);
      if (ids.empty() || (caption == first && !is_shared)) continue;
      Scene alone = *shown[i];
      alone.beside.clear();
      alone.before = 0;
      models.push_back(make_model(alone, ModelFor::figure, effort_));
      if (caption == first) continue;
      MotionNumbers motion(models.back(), still_time_s(*step.scene), effort_);
      for (const int id : ids) check_number(lesson_.numbers[static_cast<std::size_t>(id)], motion, step);
      number_check_.check_text(*caption, {models.back(), motion, still_time_s(*step.scene)});
    }
    if (!is_shared || models.empty()) return;
    std::vector<const SceneModel*> of_all;
    for (const SceneModel& model : models) of_all.push_back(&model);
    number_check_.check_shared(numbers_in(*first), of_all);
  }

  /// Lines of text in the figure: those of the first scene, or of what all show.
  void check_labels(const Step& step) {
    if (!step.scene->beside.empty()) return;  // whose they are is not kept
    for (const auto& label : step.labels)
      if (label) check_text(*label, step);
  }

  /// What an author typed into the captions, on the motions that they stand below: all along these, where
  /// that is not said to be so at the still alone.
  void check_typed_captions(const Step& step, const std::vector<const Scene*>& shown) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const RichText* caption = caption_of(step, i);
      if (caption == nullptr) continue;
      std::optional<SceneModel> model;
      const auto motion = [&] {
        if (!model) {
          Scene alone = *shown[i];
          alone.beside.clear();
          alone.before = 0;
          model.emplace(make_model(alone, ModelFor::figure, effort_));
        }
        return std::vector<ShownMotion>{{*model, still_time_s(*step.scene)}};
      };
      const bool is_always = shown[i]->caption_when == CaptionWhen::always;
      const SaidOf when = is_always ? SaidOf::start_or_all_times : SaidOf::some_time;
      const auto is_same = [&](const Scene* one) { return one->caption == shown[i]->caption; };
      const bool is_shared = shown.size() > 1 && std::all_of(shown.begin(), shown.end(), is_same);
      const StatementCheck::Motions motions =
          is_shared ? StatementCheck::Motions([&] { return motions_of(step); }) : motion;
      if (reads_words_ &&
          (i == 0 || !is_shared)) {  // one that stands once below all is so of each, or says of which
        const SaidOfMotions of = is_shared ? SaidOfMotions::each : SaidOfMotions::one;
        statement_check_.check_text(*caption, motions, when, of);
        statement_check_.check_typed_numbers(*caption, motions, when, of);
      }
      if (reads_words_ && is_always) check_values_always(*caption, motion);
      if (!number_check_.has_typed_numbers(*caption)) continue;
      number_check_.check_typed(*caption, motion().front().model, still_time_s(*step.scene), step.place);
    }
  }

  /// A number that is typed below a film is so as long as it plays.
  void check_values_always(const RichText& caption, const StatementCheck::Motions& motions) {
    const auto is_typed = [&](int id) { return lesson_.numbers[static_cast<std::size_t>(id)].is_typed(); };
    const std::vector<int> all = numbers_in(caption);
    if (std::none_of(all.begin(), all.end(), is_typed)) return;
    const ShownMotion motion = motions().front();
    for (const TextBlock& block : caption) {
      const Sentences sentences(block.spans, lesson_.notation);
      for (std::size_t i = 0; i < block.spans.size(); ++i) {
        if (block.spans[i].math.live.empty() ||
            said_of(sentences.standing_of(i), SaidOf::start_or_all_times) == SaidOf::some_time)
          continue;
        for (const LiveNumber& live : block.spans[i].math.live)
          if (is_typed(live.id))
            check_value_always(lesson_.numbers[static_cast<std::size_t>(live.id)], motion);
      }
    }
  }

  void check_value_always(const ComputedNumber& number, const ShownMotion& motion) {
    if (has_motion_words(number.expression)) return;
    MotionNumbers start(motion.model, 0, effort_);
    if (const auto value = value_of(number, start); value && !right_instead(number, *value)) return;
    for (const double t_s : times_of(motion, SaidOf::all_times)) {
      MotionNumbers numbers(motion.model, t_s, effort_);
      const auto value = value_of(number, numbers);
      if (!value || !right_instead(number, *value)) continue;
      report_.error(number.place,
                    "this caption stands below the motion as long as it plays, and at t = " + digits(t_s, 3) +
                        " s its number is " + digits(*value, kDigitsOfHint),
                    "write \\live{…}, say when it is so, or caption_when = \"still\"");
      return;
    }
  }

  /// Of the scene's marks and plots, and of those beside it.
  void check_names(const Step& step) {
    for (const Scene* shown : shown_scenes(*step.scene)) {
      if (!has_names(*shown)) continue;
      Scene alone = *shown;
      alone.beside.clear();
      alone.before = 0;
      polhode::check_names(lesson_, make_model(alone, ModelFor::numbers, effort_), step.place, report_);
    }
  }

  /// Every number has a value on the still of its step, and what is typed is that.
  void check_numbers(const std::vector<int>& ids, const Step& step) {
    check_tables(ids);
    for (const int id : ids) {
      if (report_.is_full()) return;
      const ComputedNumber& number = lesson_.numbers[static_cast<std::size_t>(id)];
      if (number.row) continue;
      if (!step.scene) {
        report_.error(number.place, "a computed number needs a scene",
                      "add a ```scene fence to this step or above it");
        continue;
      }
      if (!model_of(step)) return;
      check_number(number, still_of(step), step);
    }
  }

  /// What a row's motion does not have is a dash there, and its author may not know.
  void check_tables(const std::vector<int>& ids) {
    for (const int id : ids)
      if (lesson_.numbers[static_cast<std::size_t>(id)].row)
        spend_on(lesson_.numbers[static_cast<std::size_t>(id)]);
    const std::map<int, double> values = values_in_tables(lesson_.numbers, ids, effort_);
    for (const int id : ids) {
      const ComputedNumber& number = lesson_.numbers[static_cast<std::size_t>(id)];
      if (!number.row || values.contains(id)) continue;
      report_.warning(number.row->place,
                      in_quotes(number.written.expression) +
                          " is not defined on the motion of this row at t = " +
                          digits(number.row->scene.at_s, 3) + " s, and the table has a dash there",
                      "leave the row out, or give the column another \"of\"");
    }
  }

  void spend_on(const ComputedNumber& number) const {
    spend(effort_, kClaimNodeEvaluations * static_cast<std::int64_t>(number.expression.nodes.size()));
  }

  void check_number(const ComputedNumber& number, MotionNumbers& motion, const Step& step) {
    spend_on(number);
    const auto value = value_of(number, motion);
    if (!value)
      report_.error(number.place, "this has no value on the scene's motion");
    else if (const auto right = number.is_typed() ? right_instead(number, *value) : std::nullopt)
      report_.error(number.place,
                    "this number is " + digits(*value, kDigitsOfHint) +
                        " at t = " + digits(still_time_s(*step.scene), 3) + " s, and " +
                        number.written.typed + " is typed",
                    "write \\value{" + *right + "}");
  }

  /// A number of the scene's motion beside what holds for other motions would be false.
  void check_live_numbers(const Claim& claim, const Step& step) {
    const auto named = std::find_if(equations_.begin(), equations_.end(),
                                    [&](const Equation* e) { return e->id == claim.equation; });
    if (named == equations_.end() || (*named)->math.live.empty() || !step.scene) return;
    const Torque& torque = step.scene->torque;
    const auto is_sink = [](const TorqueTerm& term) { return std::holds_alternative<EnergySink>(term); };
    const bool has_sink = std::any_of(torque.begin(), torque.end(), is_sink);
    const bool is_of_rigid_body = claim.kind == ClaimKind::motion || claim.kind == ClaimKind::law;
    if ((claim.kind == ClaimKind::free && !torque.empty()) || (is_of_rigid_body && has_sink)) {
      report_.error(
          claim.place,
          claim.kind == ClaimKind::free
              ? "a computed number is of a motion on which a torque acts, and this is of those without one"
              : "a computed number is of a body that loses energy inside, which obeys other equations",
          "show a motion of which it holds, or leave the number out");
      return;
    }
    if (claim.given.empty()) return;
    const SceneModel* model = model_of(step);
    if (model == nullptr) return;
    // At the still, and as long as films and the window show it.
    for (int i = -1; i < kMeasuredTimes; ++i) {
      const double t_s = i < 0 ? still_time_s(*step.scene) : model->span_s * i / (kMeasuredTimes - 1);
      const auto live = live_state(*model, t_s);
      if (!live || holds_on(claim.given, *live)) continue;
      report_.error(claim.place,
                    "a computed number is of a motion on which what is given does not hold at t = " +
                        digits(t_s, 3) + " s",
                    "show a body, a torque and a duration of which it does");
      return;
    }
  }

  void check(const Claim& claim, const Step& step) {
    if (claim.origin == Claim::Origin::beside)
      check_against_formula(claim, equations_, lesson_, prover_, report_, effort_);
    if (claim.origin == Claim::Origin::part) check_is_not_empty(claim, report_);
    check_live_numbers(claim, step);
    check_kind(claim, prover_, report_, effort_);
    for (const ClaimLine& line : claim.lines) {
      if (report_.is_full()) return;
      if (claim.kind == ClaimKind::measured)
        measure(claim, line, step);
      else if (const auto& judgement = line.judgement;
               judgement && judgement->verdict == Verdict::not_refuted)
        report_.warning(line.place, "this is not proved: " + judgement->message,
                        "write the difference of the sides as a sum of squares");
      else if (judgement && judgement->verdict != Verdict::holds)
        report_.error(line.place,
                      "the claim (" + std::string(name_of(claim.kind)) + ") fails: " + judgement->message,
                      judgement->hint);
    }
  }

  void measure(const Claim& claim, const ClaimLine& line, const Step& step) {
    if (!step.scene)
      report_.error(line.place, "a measured claim needs a scene to be measured on");
    else if (const SceneModel* model = model_of(step))
      check_measured(claim, line, *model, report_);
  }

  /// Null if the scene cannot be: whoever checks the scenes says so.
  const SceneModel* model_of(const Step& step) {
    try {
      if (!model_) {
        Scene measured = *step.scene;
        measured.beside.clear();  // claims are about the first
        measured.before = 0;
        model_.emplace(make_model(measured, ModelFor::figure, effort_));
      }
      return &*model_;
    } catch (const std::domain_error&) {
      return nullptr;
    }
  }

  /// Those side by side, of which a text may speak.
  std::vector<ShownMotion> motions_of(const Step& step) {
    if (!step.scene) return {};
    if (!shown_) {
      shown_.emplace();
      for (const Scene* one : shown_scenes(*step.scene)) {
        Scene alone = *one;
        alone.beside.clear();
        alone.before = 0;
        try {
          shown_->push_back(make_model(alone, ModelFor::numbers, effort_));
        } catch (const std::domain_error&) {  // who checks the scenes says so
        }
      }
    }
    std::vector<ShownMotion> motions;
    for (const SceneModel& model : *shown_) motions.push_back({model, still_time_s(*step.scene)});
    return motions;
  }

  NumbersMotion motion_of(const Step& step) { return {*model_, still_of(step), still_time_s(*step.scene)}; }

  /// The numbers of the scene's motion at its still. Precondition: there is a model of it.
  MotionNumbers& still_of(const Step& step) {
    if (!still_) still_.emplace(*model_, still_time_s(*step.scene), effort_);
    return *still_;
  }

  static constexpr int kDigitsOfHint = 6;

  const Lesson& lesson_;
  /// What sentences say is read in English alone; of another language it is known by the lesson's original,
  /// which has the same formulas and numbers (translation_check.h).
  const bool reads_words_ = lesson_.about.language == Language::en;
  SourceText source_;
  Report report_;
  const Effort& effort_;
  NumberCheck number_check_;
  StatementCheck statement_check_;
  Prover prover_;
  std::vector<const Equation*> equations_;        // of the stage
  std::shared_ptr<const Scene> scene_;            // of the step before
  std::optional<SceneModel> model_;               // of the step
  std::optional<std::vector<SceneModel>> shown_;  // all that the step shows side by side
  std::optional<MotionNumbers> still_;            // at its still, once they were asked for
};

}  // namespace

std::optional<SourcePlace> prove_claims(Lesson& lesson, const Effort& effort) {
  const Prover prover;
  for (Stage& stage : lesson.stages)
    for (Step& step : stage.steps)
      for (Block& block : step.blocks)
        if (auto* claim = std::get_if<Claim>(&block)) try {
            prove(*claim, prover, lesson.notation.vocabulary, effort);
          } catch (const BudgetSpent&) {
            return claim->place;
          }
  return std::nullopt;
}

std::vector<Diagnostic> check_claims(const Lesson& lesson, std::string_view file_name, const Effort& effort) {
  return ClaimCheck(lesson, file_name, effort).run();
}

}  // namespace polhode
