// SPDX-License-Identifier: MIT
// What stands in the text column of a page, and how large: the present step whole, and of the steps before it
// as much as there is room for.
#pragma once

#include "app/page/page.h"
#include "app/page/text/text_column.h"

namespace polhode {

struct FittedText {
  Stack stack;
  double scale = 1;          ///< of the type's normal size
  double formula_scale = 1;  ///< of the display that had to be set smallest to fit the column's width
  std::vector<const Equation*> equations;  ///< that stand there
  int whole_from = 1;                      ///< the first step that is there whole
  Vec2 corner{0, 0};                       ///< of the column, px of the page
  /// Of a page that scrolls, px: what of the column is higher than its place, and what of it is above that,
  /// which `corner` has in it. At first the present step is read from its beginning, or to its end.
  double overflow = 0, hidden = 0;
  double new_from = 0, new_to = 0;  ///< likewise: where the present step stands in the stack, if not alone
  /// Of a page to read: where each of its steps begins in the stack.
  std::vector<double> step_tops{};
  LongestNumbers in_captions{};        ///< of a page that runs
  SlideType type{};                    ///< of a slide
  const Equation* recalled = nullptr;  ///< likewise: the one at its foot, that it goes on from
};

/// `em` is the normal size of prose. Everything at its normal size if that fits in width and height; else a
/// little smaller; else less of what came before (of the earliest steps first their equations alone, then
/// nothing); else much smaller. Sets no more of the earlier steps than a page can hold.
/// The error says which text cannot be set, or that the step has more than a page holds.
/// Of a page that scrolls: everything, at its normal size.
Result<FittedText> fit_text(const PageRequest& request, double width, double height, double em,
                            const Fonts& fonts);

/// How high the text is of pages to read that end with the request's step: whole steps alone, at their normal
/// size, from that step on, from the one before it on, and so forth, up to the first that is higher than
/// `height`; not empty. Errors as of fit_text.
Result<std::vector<double>> heights_of_pages(const PageRequest& request, double width, double height,
                                             double em, const Fonts& fonts);

/// The answers that stand at the foot of a page to read whose first step is `first`, where nobody else tells
/// them: on the first page of a stage those to the stage before, so that they are not seen beside their
/// questions, and on the last page of the lesson its own. As set_lines has them; empty: none.
std::string answers_at_foot(const PageRequest& request, int first);

/// Moves the column of a page that scrolls.
void scroll_to(FittedText& text, double hidden);

/// The step alone, its type `scale` times its normal size, or smaller if it has to be; at the foot the
/// equation that was come to before it. Errors as of fit_text.
Result<FittedText> fit_slide(const PageRequest& request, double scale, double width, double height, double em,
                             const Fonts& fonts);
/// Whether it fits at the scale of the request's slide_type, no display smaller than `least_formula` of its
/// size; if it has to recall, with the equation that the lesson says it goes on from.
Result<bool> fits_slide(const PageRequest& request, double width, double height, double em,
                        double least_formula, bool has_to_recall, const Fonts& fonts);

/// As compose_picture (page.h), with the captions of a text that was set for the request.
Page compose_picture(const PageRequest& request, const FittedText& text, const Fonts& fonts);

}  // namespace polhode
