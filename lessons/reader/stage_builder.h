// SPDX-License-Identifier: MIT
// Puts the blocks of a lesson's Markdown together to stages and steps.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/front_matter/front_matter.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/markdown.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace polhode {

/// Give it every block in order, then take the stages.
class StageBuilder {
 public:
  /// `only`: of the stages this one alone is read; null: all.
  StageBuilder(const FrontMatter& front, TextReader& texts, const std::string* only)
      : source_(texts.source()), front_(front), texts_(texts), report_(texts.report()), only_(only) {}

  /// False if a limit is passed: it was reported, and nothing more need be read.
  bool add(const MarkdownBlock& block);
  std::vector<Stage> take();

 private:
  /// A fence with the words of its opening line.
  struct Fence {
    std::vector<PlacedText>
        words;  // the first is the kind; without those of `given` and what stands behind them
    std::vector<PlacedText> given;  // names of assumptions
    SourcePlace place;
    int first_line;  // of the content
    int last_line;
  };
  struct FenceKind;
  static const std::array<FenceKind, 5> kFenceKinds;

  bool start_stage(const MarkdownBlock& heading);
  /// From the line of a rule, or of a step's title, on.
  bool start_step(int line);
  bool add_title(const MarkdownBlock& heading);
  void finish_step();
  void finish_stage();
  void check_claims();
  void check_highlights();
  void check_shown();
  void add_footnotes();

  void add_prose(const MarkdownBlock& prose);
  void take_footnote(const PlacedText& id, LocatedText text);
  void add_quote(const MarkdownBlock& quote);
  void add_fence(const MarkdownBlock& block);
  void add_math(const Fence& fence);
  void take_tag(const Equation& equation);
  std::optional<Claim> claim_printed_in(const Equation& equation, const Fence& fence);
  bool take_given(const Fence& fence, Claim& claim);
  std::optional<ClaimKind> kind_from(const PlacedText& word);
  void add_claim(const Fence& fence);
  void add_scene(const Fence& fence);
  void vary_scene();
  void warn_of_hidden_caption(const TomlTable& table, const std::vector<LessonScene>& shown);
  bool check_ends(const VariedScene& varied);
  void add_table(const Fence& fence);
  void read_tables();
  void add_ask(const Fence& fence);
  bool take_id(const Fence& fence, std::map<std::string, int>& taken, std::string_view what);

  Step& step() { return stages_.back().steps.back(); }
  /// The stage is one of those that are not read: it has its heading, and a step with nothing.
  bool is_closed() const { return only_ != nullptr && !stages_.empty() && stages_.back().id != *only_; }

  const SourceText& source_;
  const FrontMatter& front_;
  TextReader& texts_;
  Report& report_;
  const std::string* only_;
  std::vector<Stage> stages_;
  std::map<std::string, int> stage_lines_;  // ids in use and their lines
  struct Tagged {
    int line = 0;
    std::string tex;
  };
  std::map<std::string, Tagged> tags_;  ///< where each was first, and on what
  int parts_ = 0;
  int steps_with_several_ = 0;
  bool said_text_before_stage_ = false;

  // Of the stage being read.
  LessonScene scene_;                          ///< what its fences have come to
  std::vector<LessonScene> shown_;             ///< the scenes that it puts side by side, or itself
  std::shared_ptr<const VariedScene> varied_;  ///< where it varies numbers
  bool has_scene_ = false;
  bool step_has_scene_ = false;
  int scene_line_ = 1;         ///< of its fence
  bool step_is_empty_ = true;  ///< nothing stands in it, right or wrong
  struct Note {
    PlacedText id;
    LocatedText text;
  };
  std::vector<Note> notes_;  ///< footnotes of the step being read
  /// A table of the step being read, whose rows change its scene, which may stand below.
  struct WaitingTable {
    TomlTable keys;
    std::size_t block = 0;  ///< its place in the step
  };
  std::vector<WaitingTable> tables_;
  std::map<std::string, int> equation_lines_;
  /// What a formula that begins with "=" goes on with: the one above, if that is proved as printed and of the
  /// same kind, or is one side alone, which states nothing.
  struct Above {
    Math math;
    std::optional<ClaimKind> kind;  ///< nothing: it states nothing
    std::vector<std::string> given{};
  };
  std::optional<Above> above_;
  std::map<std::string, int> ask_lines_;
  std::set<std::string> terms_;
  std::vector<PlacedText> claimed_;      // equations that claims name
  std::vector<PlacedText> highlighted_;  // what its scenes highlight
};

}  // namespace polhode
