// SPDX-License-Identifier: MIT
#include "app/export/folder/manifest.h"

#include "app/export/json_values.h"
#include "base/files/reason_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <functional>
#include <set>
#include <system_error>

namespace polhode {

using Json = nlohmann::ordered_json;

namespace {

const char* name_of(Each each) {
  switch (each) {
    case Each::stage:
      return "stage";
    case Each::step:
      return "step";
    case Each::page:
      return "page";
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
          {"method", text_or_null(file.method)},
          {"sha256", text_or_null(file.sha256)}};
}

/// A line of JSON's indented form, further in.
std::string indented(const Json& json, const std::string& by) {
  std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1 + by.size()))
    text.insert(at + 1, by);
  return by + text;
}

/// In one line.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Counts the files of a manifest and forgets them.
class FileCounter {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    if (depth == 1 && event == Json::parse_event_t::key) in_files_ = parsed == "files";
    const bool begins = event == Json::parse_event_t::object_start ||
                        event == Json::parse_event_t::array_start || event == Json::parse_event_t::value;
    if (!in_files_ || depth < 2) return true;
    if (depth == 2 && begins) ++count_;
    return false;
  }
  std::size_t count() const { return count_; }

 private:
  bool in_files_ = false;
  std::size_t count_ = 0;
};

}  // namespace

std::string options_json(const ExportOptions& options) {
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
  json["quality"] = options.quality ? Json(name_of(*options.quality)) : Json(nullptr);
  // So that what was exported before there was a choice is still the same export.
  if (options.what == What::page && options.profile == Profile::slides) json["profile"] = "slides";
  if (options.text_scale != 1.0) json["text_size"] = options.text_scale;
  if (options.counts_chosen) json["count"] = "chosen";
  json["dpi"] = options.dpi ? Json(options.dpi) : Json(nullptr);
  const bool pixels = options.format == PictureFormat::png;
  if (!pixels) json["format"] = name_of(options.format);
  json["png"] = picture && pixels ? Json(options.png == PngPacking::small ? "small" : "fast") : Json(nullptr);
  return dumped(json);
}

std::string manifest_head(const ExportIdentity& of, const std::string& renderer) {
  Json json;
  json["format"] = kManifestFormat;
  json["lesson"] = {{"id", of.lesson_id}, {"sha256", of.lesson_sha256}};
  json["options"] = Json::parse(of.options);
  json["renderer"] = renderer;
  std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  text.resize(text.size() - 2);  // "\n}": the object goes on
  return text + ",\n \"files\": [";
}

std::string manifest_entry(const ManifestFile& file) { return '\n' + indented(file_json(file), "  "); }

std::string manifest_end(bool empty) { return empty ? "]\n}\n" : "\n ]\n}\n"; }

Result<std::optional<ManifestSummary>> summarize_manifest(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);  // asked once: another process may remove it
  if (!std::filesystem::exists(status)) return std::optional<ManifestSummary>();
  if (!std::filesystem::is_regular_file(status)) return failure(path.string() + " is not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file && errno == ENOENT) return std::optional<ManifestSummary>();
  if (!file) return failure("cannot read " + path.string() + ": " + reason_of(errno));
  FileCounter counter;
  const Json json = shallow_json(file, std::ref(counter));
  const bool whole = json.is_object() && json.contains("format") && json["format"] == kManifestFormat &&
                     json.contains("lesson") && json["lesson"].is_object() && json.contains("options") &&
                     json["options"].is_object();
  const auto text = [](const Json& of, const char* name) {
    return of.contains(name) && of[name].is_string() ? of[name].get<std::string>() : std::string();
  };
  if (!whole) return failure(path.string() + " is not a manifest of polhode");
  return std::optional(
      ManifestSummary{{text(json["lesson"], "id"), text(json["lesson"], "sha256"), dumped(json["options"])},
                      text(json, "renderer"),
                      counter.count()});
}

Result<Checksums> checksums_in_manifest(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return failure("cannot read " + path.string() + ": " + reason_of(errno));
  Checksums checksums;
  // One entry after the other is looked at and forgotten: a manifest may list a million files.
  const auto take = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth != 2 || event != Json::parse_event_t::object_end) return true;
    const auto text = [&](const char* name) {
      return parsed.contains(name) && parsed[name].is_string() ? parsed[name].get<std::string>() : "";
    };
    checksums[text("file")] = text("sha256");
    return false;
  };
  if (shallow_json(file, take).is_discarded())
    return failure(path.string() + " is not a manifest of polhode");
  return checksums;
}

std::string first_difference(const std::string& options_there, const std::string& options_here) {
  const Json there = Json::parse(options_there), here = Json::parse(options_here);
  for (const auto& [name, value] : here.items()) {
    const Json old = there.contains(name) ? there[name] : Json(nullptr);
    if (old != value) return fmt::format("{} is {} there and {} here", name, dumped(old), dumped(value));
  }
  for (const auto& [name, value] : there.items())
    if (!here.contains(name)) return fmt::format("{} is {} there", name, dumped(value));
  return "it knows other options";
}

std::string join_renderers(const std::vector<std::string>& renderers) {
  std::set<std::string> all;
  for (const std::string& renderer : renderers)
    for (std::size_t begin = 0; begin < renderer.size();) {
      const std::size_t end = std::min(renderer.find(kBetweenRenderers, begin), renderer.size());
      all.insert(renderer.substr(begin, end - begin));
      begin = end + kBetweenRenderers.size();
    }
  return fmt::format("{}", fmt::join(all, kBetweenRenderers));
}

std::vector<std::string> tex_shown(const Stage& stage, int step) {
  std::vector<std::string> tex;
  for (std::size_t i = 0; i < static_cast<std::size_t>(step) && i < stage.steps.size(); ++i)
    for (const Equation* equation : blocks_of<Equation>(stage.steps[i])) tex.push_back(equation->tex);
  return tex;
}

}  // namespace polhode
