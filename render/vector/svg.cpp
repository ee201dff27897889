// SPDX-License-Identifier: MIT
#include "base/markup.h"
#include "render/vector/vector_path.h"

#include <fmt/format.h>

namespace polhode {

namespace {

/// "#b04a00", the opacity apart.
std::string paint(std::string_view what, const Color& color) {
  if (color.a <= 0) return fmt::format(" {}=\"none\"", what);
  std::string text = fmt::format(" {}=\"{}\"", what, hex(color));
  if (color.a < 1) text += fmt::format(" {}-opacity=\"{}\"", what, coordinate(color.a));
  return text;
}

std::string data_of(const std::vector<OutlineStep>& steps) {
  std::string data;
  const auto add = [&](char letter, const OutlineStep& step, std::size_t first) {
    data += letter;
    for (std::size_t i = first; i < step.to.size(); ++i) {
      if (i > first) data += ' ';
      data += coordinate(step.to[i].x()) + ' ' + coordinate(step.to[i].y());
    }
  };
  for (const OutlineStep& step : steps) switch (step.kind) {
      case OutlineStep::Kind::move:
        add('M', step, 2);
        break;
      case OutlineStep::Kind::line:
        add('L', step, 2);
        break;
      case OutlineStep::Kind::cubic:
        add('C', step, 0);
        break;
      case OutlineStep::Kind::close:
        data += 'Z';
        break;
    }
  return data;
}

}  // namespace

std::string svg_of(const VectorPicture& picture, const Fonts& fonts) {
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{}pt\" height=\"{}pt\" viewBox=\"0 "
      "0 "
      "{} {}\" role=\"img\" xml:lang=\"{}\">\n<title>{}</title>\n",
      side_length(picture.width, picture.px_per_inch), side_length(picture.height, picture.px_per_inch),
      coordinate(picture.width), coordinate(picture.height), escaped(picture.language),
      escaped(picture.title));
  if (!picture.description.empty()) svg += fmt::format("<desc>{}</desc>\n", escaped(picture.description));
  if (picture.background.a > 0)
    svg += fmt::format("<rect width=\"100%\" height=\"100%\"{}/>\n", paint("fill", picture.background));
  for (const VectorPath& path : paths_of(picture.sheet, fonts)) {
    svg += "<path" + paint("fill", path.fill);
    if (path.width > 0)
      svg += paint("stroke", path.stroke) +
             fmt::format(" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"",
                         coordinate(path.width));
    if (path.dash > 0) svg += fmt::format(" stroke-dasharray=\"{}\"", coordinate(path.dash));
    svg += " d=\"" + data_of(path.steps) + "\"/>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace polhode
