// SPDX-License-Identifier: MIT
#include "app/manifest.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

namespace polhode {

using Json = nlohmann::ordered_json;

namespace {

const char* name_of(Each each) {
  switch (each) {
    case Each::stage:
      return "stage";
    case Each::step:
      return "step";
    case Each::frame:
      break;
  }
  return "frame";
}

const char* name_of(What what) {
  switch (what) {
    case What::page:
      return "page";
    case What::equation:
      return "equation";
    case What::figure:
      return "figure";
    case What::transcript:
      break;
  }
  return "transcript";
}

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }
Json count_or_null(int count) { return count > 0 ? Json(count) : Json(nullptr); }

Json file_json(const ManifestFile& file) {
  return {{"file", file.file},
          {"stage", text_or_null(file.stage)},
          {"step", count_or_null(file.step)},
          {"frame", file.frame ? Json(*file.frame) : Json(nullptr)},
          {"t", number_or_null(file.t_s)},
          {"width", count_or_null(file.size.width)},
          {"height", count_or_null(file.size.height)},
          {"tex", file.tex},
          {"alt", file.alt},
          {"method", text_or_null(file.method)}};
}

/// "size is 640x360 there and 1280x720 here", of the first option that differs.
std::string first_difference(const Json& there, const Json& here) {
  for (const auto& [name, value] : here.items()) {
    const Json old = there.is_object() && there.contains(name) ? there[name] : Json(nullptr);
    if (old != value)
      return fmt::format("{} is {} there and {} here", name,
                         old.dump(-1, ' ', false, Json::error_handler_t::replace), value.dump());
  }
  return "it knows other options";
}

}  // namespace

Json to_json(const ExportOptions& options) {
  const bool film = options.each == Each::frame;
  const bool picture = options.what != What::transcript;
  const bool sized = picture && options.what != What::equation;
  const bool themed = picture && options.what != What::figure;
  Json json;
  json["stage"] = options.stages;
  json["each"] = picture ? Json(name_of(options.each)) : Json(nullptr);
  json["what"] = name_of(options.what);
  json["size"] = sized ? Json(fmt::format("{}x{}", options.size.width, options.size.height)) : Json(nullptr);
  json["fps"] = film ? Json(to_string(options.fps)) : Json(nullptr);
  json["seconds"] = film ? Json(options.seconds) : Json(nullptr);
  json["at"] = options.at_s ? Json(*options.at_s) : Json(nullptr);
  json["frames"] =
      options.frames ? Json(fmt::format("{}:{}", options.frames->begin, options.frames->end)) : Json(nullptr);
  json["background"] = picture ? Json(options.background) : Json(nullptr);
  json["theme"] = themed ? Json(options.theme == Theme::dark ? "dark" : "paper") : Json(nullptr);
  json["dpi"] = options.dpi ? Json(options.dpi) : Json(nullptr);
  json["png"] = picture ? Json(options.png == PngPacking::small ? "small" : "fast") : Json(nullptr);
  return json;
}

std::string to_text(const Manifest& manifest) {
  Json json;
  json["format"] = 1;
  json["lesson"] = {{"id", manifest.lesson_id}, {"sha256", manifest.lesson_sha256}};
  json["options"] = manifest.options;
  json["renderer"] = manifest.renderer;
  json["files"] = Json::array();
  for (const ManifestFile& file : manifest.files) json["files"].push_back(file_json(file));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::vector<std::string> tex_shown(const Stage& stage, int step) {
  std::vector<std::string> tex;
  for (std::size_t i = 0; i < static_cast<std::size_t>(step) && i < stage.steps.size(); ++i)
    for (const Block& block : stage.steps[i].blocks)
      if (const auto* equation = std::get_if<Equation>(&block)) tex.push_back(equation->tex);
  return tex;
}

Status may_export_into(const std::filesystem::path& folder, const std::string& lesson_sha256,
                       const Json& options) {
  const std::filesystem::path path = folder / kManifestName;
  std::ifstream file(path, std::ios::binary);
  if (!file) return success();
  std::error_code not_a_file;
  const Json old =
      std::filesystem::is_regular_file(path, not_a_file) ? Json::parse(file, nullptr, false) : Json();
  const char* advice = "choose another folder, or remove it first";
  if (!old.is_object() || !old.contains("lesson") || !old.contains("options"))
    return failure(fmt::format("{} is not a manifest of polhode; {}", path.string(), advice));
  if (old["options"] != options)
    return failure(fmt::format("{} holds an export made with other options ({}); {}", folder.string(),
                               first_difference(old["options"], options), advice));
  const Json& lesson = old["lesson"];
  if (!lesson.is_object() || !lesson.contains("sha256") || lesson["sha256"] != lesson_sha256)
    return failure(fmt::format("{} holds an export of another lesson text; {}", folder.string(), advice));
  return success();
}

}  // namespace polhode
