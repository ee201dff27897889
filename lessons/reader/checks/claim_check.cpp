// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/claim_check.h"

#include "base/numbers.h"
#include "lessons/claims/live_claims.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/claims/proof/counterexample_text.h"
#include "lessons/derivation/decided.h"
#include "lessons/diagnostics/report.h"
#include "lessons/notation/tex_items.h"
#include "lessons/notation/tex_sides.h"
#include "lessons/reader/checks/formula_signs.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/name_check.h"
#include "lessons/reader/checks/numbers/number_check.h"
#include "lessons/reader/checks/prompt_check.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/checks/statement_check.h"
#include "lessons/reader/questions/state_keys.h"
#include "render/typeset/math/tree.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>

namespace polhode {
namespace {

std::int64_t nodes_in(const Equality& equality) {
  return static_cast<std::int64_t>(equality.left.nodes.size() + equality.right.nodes.size());
}

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
      check_spoken_names();
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
  /// "angular momentum" is L, and nothing else that has its unit.
  void check_spoken_names() {
    for (const auto& [name, symbol] : lesson_.symbols) {
      if (symbol.means == "I" || symbol.means == "J") continue;
      const std::string& text = symbol.means.empty() ? name : symbol.means;
      const SourceText source(text);
      Report unused(source, "");
      const auto means = read_expression(text, {1, 1}, unused, &lesson_.notation.vocabulary);
      if (!means) continue;
      for (const std::string* words : {&symbol.say, &symbol.note}) {
        const auto said = quantity_of_common_name(*words, lesson_);
        if (!said || !fit(said->type(), means->type()) || may_be_same(*said, *means)) continue;
        report_.error(source_.place_of(std::min(symbol.offset, source_.text().size())),
                      "symbol " + in_quotes(name) + " is said as " + in_quotes(*words) + ", which is " +
                          said->text + ", and means " + text,
                      "say what it is");
        break;
      }
    }
  }

  /// What no proof decides, such as the largest of three moments, may be so in some scene of the lesson.
  bool may_be_same(const Expression& a, const Expression& b) {
    const Equality sides{a, b};
    if (is_provable(sides)) return prover_.settle(sides, Assumption::identity) != Verdict::fails;
    bool is_told = false;
    const Scene* last = nullptr;
    for (const Stage& stage : lesson_.stages)
      for (const Step& step : stage.steps) {
        if (!step.scene || step.scene.get() == last) continue;
        last = step.scene.get();
        const auto live = state_of_first(*step.scene);
        const auto x = live ? live_number(a, *live) : std::nullopt,
                   y = live ? live_number(b, *live) : std::nullopt;
        if (!x || !y) continue;
        is_told = true;
        constexpr double kRounding = 1e-9;
        if (std::abs(*x - *y) <= kRounding * (std::abs(*x) + std::abs(*y))) return true;
      }
    return !is_told;
  }
  /// Of the scene without those beside it, as it begins; nothing if it cannot be.
  std::optional<LiveState> state_of_first(const Scene& scene) const {
    Scene alone = scene;
    alone.beside.clear();
    alone.before = 0;
    try {
      return live_state(make_model(alone, Product::numbers, effort_), 0);
    } catch (const std::domain_error&) {
      return std::nullopt;
    }
  }

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
    if (equation.math.root) check_braces(*equation.math.root, equation);
    if (!is_proved_as_printed(equation, step))
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

  /// "kinetic energy" below a brace is what the brace holds.
  void check_braces(const MathNode& node, const Equation& equation) {
    using Kind = MathNode::Kind;
    const bool is_labelled =
        node.kind == Kind::scripts && without_groups(node.children[0]).kind == Kind::brace;
    for (std::size_t script = 1; is_labelled && script < node.children.size(); ++script) {
      Math label, inside;
      label.root = std::make_shared<const MathNode>(node.children[script]);
      inside.root = std::make_shared<const MathNode>(without_groups(node.children[0]).children.front());
      const std::string words = words_of_formula(label);
      const auto said = words.empty() ? std::nullopt : quantity_of_common_name(words, lesson_);
      const auto held = said ? read_side(inside, lesson_.notation) : std::nullopt;
      if (!held || (fit(said->type(), held->type()) && may_be_same(*said, *held))) continue;
      report_.error(source_.place_of(std::min(equation.offset + node.span.begin, source_.text().size())),
                    in_quotes(words) + " at a brace is " + said->text + ", and it holds something else",
                    "say what it holds");
    }
    for (const MathNode& child : node.children) check_braces(child, equation);
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
    const auto motions = [&] { return motions_of(step); };
    if (of == TextOf::choice)
      statement_check_.check_choice(text, motions);
    else
      statement_check_.check_text(text, motions);
    if (of != TextOf::prompt)
      statement_check_.check_typed_numbers(text, motions);  // what is given is the question's
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
    check_prompt(
        ask, lesson_, prover_, [&] { return motions_of(step); }, report_, effort_);
    if (ask.derivation) check_derivation(ask, *ask.derivation);
    if (ask.task) check_state_task(ask, report_, effort_);
    const auto& answer = ask.expression;
    if (answer && prover_.settle({*answer, *answer}, Assumption::identity, ask.given) != Verdict::holds)
      report_.error(ask.place, "the answer of question " + in_quotes(ask.id) + " is nowhere defined");
  }

  /// Every line of it holds, and the last is the goal.
  void check_derivation(const Ask& ask, const Derivation& derivation) {
    const auto check_line = [&](const DerivedLine& line, const char* which) {
      for (const Equality& link : line.links) {
        spend(effort_, kClaimLineEvaluations + kClaimNodeEvaluations * nodes_in(link));
        if (is_provable(link) &&
            prover_.settle(link, derivation.assumption, derivation.given) == Verdict::holds)
          continue;
        report_.error(ask.place,
                      "the " + std::string(which) + " of question " + in_quotes(ask.id) +
                          " does not hold: " + line.typed,
                      "modulo = \"motion\" lets it use Euler's law, \"free\" that there is no torque");
        return false;
      }
      return true;
    };
    bool all = check_line(derivation.start, "start") && check_line(derivation.goal, "goal");
    for (const DerivedLine& fact : derivation.facts) all = all && check_line(fact, "fact");
    for (const WorkedLine& worked : derivation.worked) all = all && check_line(worked.line, "solution");
    Derivation unsolved = derivation;  // no line is decided by being one of the solution
    unsolved.worked.clear();
    for (const WorkedLine& worked : derivation.worked)
      for (const Equality& link : worked.line.links)
        if (all && !is_decided(link, unsolved, prover_))
          report_.error(ask.place,
                        "a line of the solution of question " + in_quotes(ask.id) +
                            " would hold with any factor, for both its sides are 0: " + worked.line.typed,
                        "write each term as what was put in for it, (I2 - I3) w1 w2 w3 for I1 w1 w1'");
    if (all && !is_goal(derivation, derivation.worked.back().line, prover_))
      report_.error(ask.place,
                    "the last line of the solution of question " + in_quotes(ask.id) + " is not its goal",
                    "it says the same in the goal's quantities");
    const std::vector<WorkedLine>& worked = derivation.worked;
    const auto first_goal = std::find_if(worked.begin(), worked.end(), [&](const WorkedLine& one) {
      return is_goal(derivation, one.line, prover_);
    });
    if (all && first_goal < worked.end() - 1)
      report_.warning(
          ask.place,
          "the solution of question " + in_quotes(ask.id) +
              " is at its goal before its last line, and nobody sees the rest: " + first_goal->line.typed,
          "leave out this line or those behind it, or make one line of them: a = b = c");
  }

  /// Each caption's numbers are those of its own scene; one that stands once below all has to be so of all.
  void check_captions(const Step& step) {
    if (!step.scene) return;
    const std::vector<const Scene*> shown = shown_scenes(*step.scene);
    const RichText* first = caption_of(step, step.scene->before);
    if (first != nullptr) {
      check_numbers(numbers_in(*first), step);
      check_text(*first, step);
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
      models.push_back(make_model(alone, Product::figure, effort_));
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

  /// Numbers that an author typed into the captions, on the motions that they stand below.
  void check_typed_captions(const Step& step, const std::vector<const Scene*>& shown) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const RichText* caption = caption_of(step, i);
      if (caption == nullptr || !number_check_.has_typed_numbers(*caption)) continue;
      Scene alone = *shown[i];
      alone.beside.clear();
      alone.before = 0;
      const SceneModel model = make_model(alone, Product::figure, effort_);
      number_check_.check_typed(*caption, model, still_time_s(*step.scene), step.place);
    }
  }

  /// Of the scene's marks and plots, and of those beside it.
  void check_names(const Step& step) {
    for (const Scene* shown : shown_scenes(*step.scene)) {
      if (!has_names(*shown)) continue;
      Scene alone = *shown;
      alone.beside.clear();
      alone.before = 0;
      polhode::check_names(lesson_, make_model(alone, Product::numbers, effort_), step.place, report_);
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
    if (claim.origin == Claim::Origin::beside) check_against_formula(claim);
    if (claim.origin == Claim::Origin::part) check_is_not_empty(claim);
    check_live_numbers(claim, step);
    check_kind(claim);
    for (const ClaimLine& line : claim.lines) {
      if (report_.is_full()) return;
      if (claim.kind == ClaimKind::measured)
        check_measured(claim, line, step);
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

  /// Whether a claim that is written beside a formula says what the formula says.
  void check_against_formula(const Claim& claim) {
    const auto named = std::find_if(equations_.begin(), equations_.end(),
                                    [&](const Equation* e) { return e->id == claim.equation; });
    if (named == equations_.end() || !(*named)->math.root) return;
    const Math* above = named == equations_.begin() ? nullptr : &(*std::prev(named))->math;
    const auto read = read_equation((*named)->math, lesson_.notation, above);
    if (read)
      compare(claim, *read);
    else if (hidden_part(*(*named)->math.root) != nullptr)
      report_.warning(claim.place,
                      "a colour, a phantom or a space that goes back may hide a part of this formula",
                      "mark parts with \\term{id}{…}, and leave spaces to TeX");
    else if (says_no_equality(*(*named)->math.root))
      report_.warning(claim.place, "the formula has a sign that no claim stands for",
                      "claim what = < > \\le \\ge or \\approx says, and write the formula so");
    else {
      check_is_not_empty(claim);
      compare_relations(claim, (*named)->math);
      if (!claim.in_other_words) compare_letters(claim, (*named)->math);
      if (!claim.in_other_words) compare_factors(claim, (*named)->math);
    }
  }

  void compare(const Claim& claim, const ReadEquation& formula) {
    std::vector<const EquationLink*> links;
    for (const EquationSentence& sentence : formula.sentences)
      for (const EquationLink& link : sentence.links) links.push_back(&link);
    const std::string as_printed = "write ```math " + claim.equation + ' ' +
                                   std::string(name_of(claim.kind)) + ", and leave out the claim";
    std::set<const EquationLink*> claimed;
    for (const ClaimLine& line : claim.lines) {
      const std::size_t before = claimed.size();
      for (const EquationLink* link : links)
        if (line.relation == link->relation &&
            (is_same(line.equality, link->equality, !is_order(line.relation)) ||
             (line.conclusion && is_same(*line.conclusion, link->equality, true))))
          claimed.insert(link);
      if (claimed.size() == before && !claim.in_other_words)
        report_.warning(line.place, "the formula does not say this", as_printed);
    }
    if (claimed.empty() && claim.in_other_words)
      report_.warning(claim.place, "the formula can be read, and says something else", as_printed);
    if (claimed.size() == links.size())
      report_.warning(claim.place, "the formula itself can be proved, as it is printed", as_printed);
    else if (!claimed.empty())
      report_.warning(claim.place,
                      "of the " + std::to_string(links.size()) + " equalities that the formula states only " +
                          std::to_string(claimed.size()) + " are claimed",
                      as_printed);
  }

  /// Whether two equalities have the same sides, in either order if that is all the same.
  bool is_same(const Equality& a, const Equality& b, bool in_any_order) const {
    spend(effort_, kClaimLineEvaluations + kClaimNodeEvaluations * (nodes_in(a) + nodes_in(b)));
    const auto same = [&](const Expression& x, const Expression& y) {
      if (!fit(x.type(), y.type())) return false;
      const Equality sides{x, y};
      return is_provable(sides) && prover_.settle(sides, Assumption::identity) == Verdict::holds;
    };
    return (same(a.left, b.left) && same(a.right, b.right)) ||
           (in_any_order && same(a.left, b.right) && same(a.right, b.left));
  }

  /// What an author chose to claim, by hand or with \proved, is to say something.
  void check_is_not_empty(const Claim& claim) {
    for (const ClaimLine& line : claim.lines)
      if (!line.conclusion && !line.is_number && is_mere_rearrangement(line.equality))
        report_.error(line.place, "this says nothing: both sides are the same",
                      "claim what the formula says, or let it stand without a kind");
  }

  /// "a > b" above "a = b" would be said to be proved.
  void compare_relations(const Claim& claim, const Math& formula) {
    std::set<Relation> unclaimed = relations_in(*formula.root);
    for (const ClaimLine& line : claim.lines) unclaimed.erase(line.relation);
    if (!unclaimed.empty())
      report_.warning(claim.place,
                      "the formula says " + in_quotes(sign_of(*unclaimed.begin())) +
                          " of two things, and no line of the claim does",
                      "claim what is printed");
  }

  void compare_letters(const Claim& claim, const Math& formula) {
    const std::set<std::string> shown = letters_in(formula, lesson_.notation);
    std::set<std::string> unseen, claimed;
    const auto look = [&](const Equality& equality) {
      for (const Expression* side : {&equality.left, &equality.right})
        for (const std::string& letter : letters_in(*side)) {
          claimed.insert(letter);
          if (!shown.contains(letter)) unseen.insert(letter);
        }
    };
    for (const ClaimLine& line : claim.lines) {
      look(line.equality);
      if (line.conclusion) look(*line.conclusion);
    }
    constexpr const char* kHint = "claim what is printed, or end the fence's line with in-other-words";
    if (!unseen.empty())
      return report_.warning(
          claim.place, "the claim speaks of " + joined(unseen) + ", which the formula does not show", kHint);
    std::set<std::string> unclaimed = shown;
    for (const std::string& letter : claimed) unclaimed.erase(letter);
    unclaimed.merge(operators_in(*formula.root));
    if (!unclaimed.empty())
      report_.warning(claim.place,
                      "the formula shows " + joined(unclaimed) + ", of which the claim does not speak",
                      kHint);
  }

  /// "T = w·L/3" above "T = w·L/2": the letters are the same.
  void compare_factors(const Claim& claim, const Math& formula) {
    const std::set<double> shown = factors_in(*formula.root);
    std::set<double> claimed;
    const auto look = [&](const Expression& side) {
      for (const ExpressionNode& node : side.nodes)
        if (node.operation == Operation::number) add_factor(node.number.value, claimed);
    };
    for (const ClaimLine& line : claim.lines)
      for (const Equality* one : {&line.equality, line.conclusion ? &*line.conclusion : nullptr}) {
        if (one == nullptr) continue;
        look(one->left);
        look(one->right);
      }
    if (shown != claimed)
      report_.warning(claim.place, "the formula has other numbers than the claim",
                      "claim what is printed, or end the fence's line with in-other-words");
  }

  static std::string joined(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
  }

  /// What a definition defines stands alone on a side; a law, and what is measured, could be otherwise.
  void check_kind(const Claim& claim) {
    const auto is_name = [](const Expression& side) {
      return std::all_of(side.text.begin(), side.text.end(),
                         [](unsigned char c) { return std::isalnum(c) || c == '_'; }) &&
             std::isalpha(static_cast<unsigned char>(side.text.front()));
    };
    const bool is_all_identity =
        claim.kind == ClaimKind::measured &&
        std::all_of(claim.lines.begin(), claim.lines.end(),
                    [&](const ClaimLine& line) { return !line.conclusion && is_identity(line.equality); });
    if (is_all_identity && !claim.lines.empty())
      report_.error(claim.place,
                    "this measures nothing: it holds by what its quantities are, on every motion",
                    "its kind is identity");
    for (const ClaimLine& line : claim.lines) {
      const Equality& sides = line.equality;
      if (claim.kind == ClaimKind::definition && !line.goes_on && line.is_side_by_side &&
          !is_name(sides.left) && !is_name(sides.right))
        report_.error(line.place, "this defines nothing: no side is a quantity alone",
                      "its kind is identity, or write what it defines alone on a side");
      if (claim.kind == ClaimKind::law && !line.goes_on && is_identity(sides))
        report_.error(line.place, "this is no law: it holds by what its quantities are",
                      "its kind is identity, or definition");
    }
  }

  bool is_identity(const Equality& sides) const {
    spend(effort_, kClaimLineEvaluations + kClaimNodeEvaluations * nodes_in(sides));
    return is_provable(sides) && prover_.settle(sides, Assumption::identity) == Verdict::holds;
  }

  void check_measured(const Claim& claim, const ClaimLine& line, const Step& step) {
    if (!step.scene) {
      report_.error(line.place, "a measured claim needs a scene to be measured on");
      return;
    }
    const SceneModel* model = model_of(step);
    if (!model) return;
    for (const double t_s : {0.0, model->span_s}) {
      const auto live = claim.given.empty() ? std::nullopt : live_state(*model, t_s);
      if (!live || holds_on(claim.given, *live)) continue;
      report_.error(line.place, "this is measured on a motion on which what is given does not hold",
                    "show a body and a torque of which it does, or leave out \"given\"");
      return;
    }
    constexpr double kLeastTurn_rad = 0.01;
    if (model->span_s * model->scene.w0_B.norm() < kLeastTurn_rad) {
      report_.error(line.place, "this measures nothing: the motion lasts " + digits(model->span_s, 3) + " s",
                    "give the scene a longer duration");
      return;
    }
    const auto measured = measure(line.equality, line.within, *model, claim.given);
    if (!measured)
      report_.error(line.place, "this cannot be measured: the motion or a side has no value somewhere");
    else if (measured->tolerance > kDecisive)
      report_.error(line.place,
                    "this measures nothing: allowed are " + digits(measured->tolerance, 3) + " of the terms",
                    line.within ? "at most " + digits(kDecisive, 3) + " decides anything"
                                : "shorten the step of the motion");
    else if (!measured->decides())
      report_.error(line.place,
                    "this measures nothing: the terms cancel down to " + digits(measured->side, 3) +
                        " of their size, and " + digits(measured->allowed, 3) + " of it is allowed",
                    line.within ? "a hundredth of the sides decides: write within " +
                                      digits(0.9 * kDecisive * measured->side, 1)
                                : "prove the claim, or measure it on a motion where its sides are larger");
    else if (!measured->holds())
      report_.error(line.place, "the claim (measured) fails: at t = " + digits(measured->t_s, 3) +
                                    " s both sides differ by " + digits(measured->residual, 3) +
                                    " of their terms, allowed are " + digits(measured->tolerance, 3));
  }

  /// Null if the scene cannot be: whoever checks the scenes says so.
  const SceneModel* model_of(const Step& step) {
    try {
      if (!model_) {
        Scene measured = *step.scene;
        measured.beside.clear();  // claims are about the first
        measured.before = 0;
        model_.emplace(make_model(measured, Product::figure, effort_));
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
          shown_->push_back(make_model(alone, Product::numbers, effort_));
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
