// SPDX-License-Identifier: MIT
#include "render/vector/pdf_file.h"
#include "render/vector/vector_path.h"

#include <fmt/format.h>

#include <map>

namespace polhode {

namespace {

using Object = PdfObject;

constexpr double kPointsPerInch = 72;

/// Opacities are states by name, of fills and strokes alike.
class Opacities {
 public:
  /// Operators that set it.
  std::string use(float alpha) {
    const auto [known, is_new] = names_.try_emplace(coordinate(alpha), fmt::format("/A{}", names_.size()));
    return known->second + " gs ";
  }
  Object states() const {
    Object all = Object::parse("<< >>");
    for (const auto& [alpha, name] : names_)
      all.set(name, Object::parse(fmt::format("<< /Type /ExtGState /ca {0} /CA {0} >>", alpha)));
    return all;
  }

 private:
  std::map<std::string, std::string> names_;
};

std::string color_in(const Color& color, const char* command) {
  return fmt::format("{} {} {} {} ", coordinate(color.r), coordinate(color.g), coordinate(color.b), command);
}

std::string steps_in(const std::vector<OutlineStep>& steps) {
  std::string content;
  const auto add = [&](const OutlineStep& step, std::size_t first, const char* command) {
    for (std::size_t i = first; i < step.to.size(); ++i)
      content += coordinate(step.to[i].x()) + ' ' + coordinate(step.to[i].y()) + ' ';
    content += command;
  };
  for (const OutlineStep& step : steps) switch (step.kind) {
      case OutlineStep::Kind::move:
        add(step, 2, "m\n");
        break;
      case OutlineStep::Kind::line:
        add(step, 2, "l\n");
        break;
      case OutlineStep::Kind::cubic:
        add(step, 0, "c\n");
        break;
      case OutlineStep::Kind::close:
        content += "h\n";
        break;
    }
  return content;
}

/// Where fill and stroke are both there, they have one opacity.
std::string path_in(const VectorPath& path, Opacities& opacities) {
  const bool fills = path.fill.a > 0, strokes = path.width > 0 && path.stroke.a > 0;
  if (!fills && !strokes) return {};
  std::string content = opacities.use(fills ? path.fill.a : path.stroke.a);
  if (fills) content += color_in(path.fill, "rg");
  if (strokes) {
    content += color_in(path.stroke, "RG") + coordinate(path.width) + " w ";
    content += path.dash > 0 ? fmt::format("[{}] 0 d ", coordinate(path.dash)) : "[] 0 d ";
  }
  return content + '\n' + steps_in(path.steps) + (fills && strokes ? "B\n" : fills ? "f\n" : "S\n");
}

void describe(PdfFile& pdf, const VectorPicture& picture, Object& page, const Object& box) {
  const auto dictionary = [&](const char* text) { return pdf.numbered(Object::parse(text)); };
  Object figure = dictionary("<< /Type /StructElem /S /Figure /K 0 >>");
  figure.set("/Alt", Object::text(picture.title));
  figure.set("/Pg", page);
  Object layout = Object::parse("<< /O /Layout /Placement /Block >>");
  layout.set("/BBox", box);
  figure.set("/A", layout);
  Object document = dictionary("<< /Type /StructElem /S /Document >>");
  document.set("/K", Object::array({figure}));
  figure.set("/P", document);
  Object tree = dictionary("<< /Type /StructTreeRoot /ParentTreeNextKey 1 >>");
  tree.set("/K", document);
  document.set("/P", tree);
  Object parents = Object::parse("<< >>");
  parents.set("/Nums", Object::array({Object::integer(0), pdf.numbered(Object::array({figure}))}));
  tree.set("/ParentTree", pdf.numbered(parents));
  Object root = pdf.root();
  root.set("/StructTreeRoot", tree);
  root.set("/Lang", Object::text(picture.language));
  root.set("/MarkInfo", Object::parse("<< /Marked true >>"));
  root.set("/ViewerPreferences", Object::parse("<< /DisplayDocTitle true >>"));
  Object info = dictionary("<< >>");
  info.set("/Title", Object::text(picture.description.empty() ? picture.title : picture.description));
  if (!picture.author.empty()) info.set("/Author", Object::text(picture.author));
  if (!picture.program.empty()) info.set("/Creator", Object::text(picture.program));
  pdf.trailer().set("/Info", info);
}

}  // namespace

std::string pdf_of(const VectorPicture& picture, const Fonts& fonts) {
  const double points = kPointsPerInch / picture.px_per_inch;
  PdfFile pdf;
  Opacities opacities;
  // Pixels from above, as the sheet has them.
  std::string content = fmt::format("/Figure << /MCID 0 >> BDC\nq {0:.8f} 0 0 -{0:.8f} 0 {1} cm 1 J 1 j\n",
                                    points, side_length(picture.height, picture.px_per_inch));
  if (picture.background.a > 0)
    content += opacities.use(picture.background.a) + color_in(picture.background, "rg") +
               fmt::format("0 0 {} {} re f\n", coordinate(picture.width), coordinate(picture.height));
  for (const VectorPath& path : paths_of(picture.sheet, fonts)) content += path_in(path, opacities);
  content += "Q\nEMC\n";
  Object page = pdf.numbered(Object::parse("<< /Type /Page /Tabs /S /StructParents 0 /Resources << >> >>"));
  const Object box = Object::parse(fmt::format("[0 0 {} {}]", side_length(picture.width, picture.px_per_inch),
                                               side_length(picture.height, picture.px_per_inch)));
  page.set("/MediaBox", box);
  page.get("/Resources").set("/ExtGState", opacities.states());
  page.set("/Contents", pdf.stream(content));
  describe(pdf, picture, page, box);
  pdf.add_page(page);
  std::string bytes;
  pdf.write([&](const unsigned char* data, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(data), count);
  });
  return bytes;
}

}  // namespace polhode
