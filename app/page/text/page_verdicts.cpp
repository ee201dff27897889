// SPDX-License-Identifier: MIT
#include "app/page/text/page_verdicts.h"

#include "base/words/verdict_words.h"

namespace polhode {

Verdicts verdicts_of(const PageRequest& request) {
  Verdicts verdicts;
  for (int i = 0; i < request.step; ++i) {
    const Step& step = request.stage.steps[static_cast<std::size_t>(i)];
    const FiguredStep* before = figured(request, i + 1);
    const SceneModel* model = i + 1 == request.step ? request.model : before ? before->model : nullptr;
    for (const Block& block : step.blocks)
      if (const auto* claim = std::get_if<Claim>(&block))
        verdicts.emplace(claim, verdict_row(*claim, step.scene ? &*step.scene : nullptr, model,
                                            request.lesson.about.language));
  }
  return verdicts;
}

bool is_beside(const Claim& claim, const VerdictRow& row) {
  const Certainty certainty = row.certainty;
  const bool holds = certainty == Certainty::proved || certainty == Certainty::stated;
  return claim.origin == Claim::Origin::beside && holds;
}

std::string in_a_line(const RichText& title) {
  std::string line;
  for_each_span(title, [&](const TextSpan& span) {
    line += span.kind == TextSpan::Kind::math ? '$' + span.text + '$' : span.text;
  });
  return line;
}

EarlierLabel label_of_earlier(const Verdicts& verdicts, const Equation& equation, const Step& step,
                              Language language) {
  EarlierLabel label;
  label.title = in_a_line(step.title);
  for (const Block& block : step.blocks) {
    const auto* claim = std::get_if<Claim>(&block);
    if (!claim || claim->equation != equation.id) continue;
    const auto known = verdicts.find(claim);  // of another stage none is
    const VerdictRow row =
        known != verdicts.end() ? known->second : verdict_row(*claim, step.scene.get(), nullptr, language);
    if (is_beside(*claim, row)) continue;  // its word would seem to be of the formula
    label.in_short =
        row.word + (claim->given.empty() ? "" : std::string(words::kUnderAnAssumption.in(language)));
    const bool is_of_what_holds = row.certainty == Certainty::proved && !row.note.empty();
    label.word = is_of_what_holds ? row.word : label.in_short;
    // The page shows another motion by now.
    if (claim->kind == ClaimKind::measured && row.certainty == Certainty::stated)
      label.word = label.in_short = words::kCheckedOnAMotion.in(language);
    if (is_of_what_holds) label.note = row.note;
    return label;
  }
  return label;
}

}  // namespace polhode
