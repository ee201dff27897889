// SPDX-License-Identifier: MIT
// A flat drawing as a file of outlines: sharp at any size, and no fonts are needed to show it. Type stands
// where a renderer puts it at the same resolution (render/drawing/type_grid.h), so that file and picture
// agree to the last pixel's edge. Bytes depend on what is given alone, and on the fonts.
#pragma once

#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"

#include <string>

namespace polhode {

struct VectorPicture {
  Sheet sheet;
  double width = 0, height = 0;  ///< px
  double px_per_inch = 0;        ///< of the sheet's pixels; positive
  Color background{0, 0, 0, 0};  ///< alpha 0: none
  std::string title;             ///< what it says, for those who do not see it
  std::string description{};     ///< where it is from
  std::string author{};          ///< may be empty
  std::string language = "en";   ///< BCP 47, of title and description
  std::string program{};         ///< that made it
};

/// SVG 1.1, in UTF-8; well-formed as XML, whatever the texts are. Its size is in points.
std::string svg_of(const VectorPicture& picture, const Fonts& fonts);

/// A PDF of one page as large as the picture, tagged as a figure with its alternative text.
/// @throws std::exception of qpdf
std::string pdf_of(const VectorPicture& picture, const Fonts& fonts);

}  // namespace polhode
