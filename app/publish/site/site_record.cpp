// SPDX-License-Identifier: MIT
#include "app/publish/site/site_record.h"

#include "base/files/file_bytes.h"
#include "base/sha256.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace polhode {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kKind = "polhode site";

/// A name is a file of the folder: whoever wrote the record may have meant another.
bool is_plain(const std::string& name) {
  return !name.empty() && name.front() != '.' && name.find('/') == name.npos;
}

std::optional<SiteRecord> record_in(const Json& json) {
  if (!json.is_object() || json.value("kind", Json()) != kKind || !json.contains("files") ||
      !json["files"].is_array())
    return std::nullopt;
  SiteRecord record;
  for (const Json& file : json["files"]) {
    const auto text = [&](const char* key) {
      return file.is_object() && file.contains(key) && file[key].is_string() ? file[key].get<std::string>()
                                                                             : std::string();
    };
    if (!is_plain(text("file"))) return std::nullopt;
    record[text("file")] = {text("made_of"), text("sha256")};
  }
  return record;
}

}  // namespace

Result<std::optional<SiteRecord>> read_site_record(const fs::path& folder) {
  const fs::path path = folder / kSiteRecordName;
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return std::optional<SiteRecord>();
  const auto bytes = read_file_bytes(path);
  if (!bytes) return failure(fmt::format("cannot read {}: {}", path.string(), bytes.error()));
  std::optional<SiteRecord> record = record_in(Json::parse(bytes->begin(), bytes->end(), nullptr, false));
  if (!record)
    return failure(
        fmt::format("{} is not of polhode, or damaged; remove it to make the site anew", path.string()));
  return record;
}

Status write_site_record(const fs::path& folder, const SiteRecord& record, Durability durability) {
  Json files = Json::array();
  for (const auto& [name, file] : record)
    files.push_back({{"file", name}, {"made_of", file.made_of}, {"sha256", file.sha256}});
  const Json json = {{"kind", kKind}, {"files", files}};
  return replace_file_atomically(folder / kSiteRecordName,
                                 bytes_of(json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n'),
                                 durability);
}

bool is_there(const fs::path& folder, const SiteRecord& record, const std::string& file,
              const std::string& made_of) {
  const auto known = record.find(file);
  if (known == record.end() || known->second.made_of != made_of) return false;
  const auto bytes = read_file_bytes(folder / file);
  return bytes && sha256_hex(*bytes) == known->second.sha256;
}

}  // namespace polhode
