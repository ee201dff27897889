// SPDX-License-Identifier: MIT
// The computed numbers of a page: what stands in their places, and where those stand that run with the time.
//
// A text is laid out once for all times. A number that stands still is put into its formula, which closes up
// behind it. One that runs gets the room of the widest that the motion comes to, and stands at its right end,
// so that nothing else moves.
#pragma once

#include "lessons/reader/lesson.h"
#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"
#include "render/typeset/rich_text.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// The room of a running number in a display list.
struct LiveRoom {
  int id = 0;        ///< into Lesson::numbers
  Vec2 at{0, 0};     ///< left end of its baseline
  double width = 0;  ///< px
  double size = 0;   ///< em
  Color color;
};

class PageNumbers {
 public:
  PageNumbers(const Lesson& lesson, const Fonts& fonts) : lesson_(&lesson), fonts_(&fonts) {}

  const Lesson& lesson() const { return *lesson_; }

  /// It stands still; dots where there is no value, in a ```table a dash.
  void keep(int id, std::optional<double> value);
  /// It runs, and comes to these values. Precondition: there is one.
  void run(int id, const std::vector<double>& values);

  /// With what stands for the numbers; those that are not known have dots.
  Math put_into(const Math& math) const;
  /// In the columns of a ```table the decimal points stand below each other.
  RichText put_into(RichText text) const;
  /// Takes what holds the rooms of running numbers out of the list.
  std::vector<LiveRoom> take_rooms(DisplayList& list) const;

 private:
  struct Shown {
    std::string tex;  ///< of one that runs the widest
    bool runs = false;
    double width_em = 0;  ///< of the room of one that runs
  };
  double width_em(const std::string& tex) const;
  std::map<int, double> rooms_behind(const TextTable& table) const;

  const Lesson* lesson_;
  const Fonts* fonts_;
  std::map<int, Shown> shown_;
};

/// The number in its room, smaller where it is too wide; dots where there is none.
PlacedType live_number_in(const LiveRoom& room, const ComputedNumber& number, std::optional<double> value,
                          Language language, const Fonts& fonts);

/// The values that these numbers come to over the interval of the scene, evenly in time, and at its still.
std::map<int, std::vector<double>> values_over(const SceneModel& model, const Lesson& lesson,
                                               const std::vector<int>& ids);

/// The longest of what each number of the step's captions comes to, as TeX: what keeps a caption still while
/// its numbers run.
using LongestNumbers = std::map<int, std::string>;
LongestNumbers longest_in_captions(const Lesson& lesson, const Step& step, const SceneModel& model);
/// The captions of a step's scenes at one time, in the order in which they stand, each with its numbers put
/// in, of its own motion: lines with formulas between `$`, as set_line has them. What its numbers lack of the
/// longest is blank: before each, so that all that is between them stands still, or behind the caption, which
/// then has no gaps and begins where it began.
enum class CaptionBlanks { before_numbers, behind };
std::vector<std::string> captions_at(const Lesson& lesson, const Step& step, const SceneModel& model,
                                     double t_s, const LongestNumbers& longest = {},
                                     CaptionBlanks blanks = CaptionBlanks::before_numbers);
/// The same of the lesson's captions, whichever the models have: what rooms are kept for. The step has a
/// scene.
std::vector<std::string> lesson_captions_at(const Lesson& lesson, const Step& step, const SceneModel& model,
                                            double t_s, const LongestNumbers& longest = {},
                                            CaptionBlanks blanks = CaptionBlanks::before_numbers);

}  // namespace polhode
