// SPDX-License-Identifier: MIT
#include "app/publish/html_frame.h"

namespace polhode {

Status append_frame(std::string_view frame, const AppendBytes& append,
                    const std::function<Status(const std::string& name)>& put) {
  for (std::size_t open = frame.find("{{"); open != std::string_view::npos; open = frame.find("{{")) {
    const std::size_t close = frame.find("}}", open);
    Status status = append(bytes_of(frame.substr(0, open)));
    if (status) status = put(std::string(frame.substr(open + 2, close - open - 2)));
    if (!status) return status;
    frame.remove_prefix(close + 2);
  }
  return append(bytes_of(frame));
}

std::string filled_frame(std::string_view frame, const std::map<std::string, std::string>& texts) {
  std::string all;
  const AppendBytes append = [&](std::span<const std::uint8_t> bytes) {
    all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return success();
  };
  static_cast<void>(append_frame(frame, append, [&](const std::string& name) {
    return append(bytes_of(texts.at(name)));
  }));  // a string takes all
  return all;
}

std::string social_head(const std::string& url, const std::string& file, const std::string& title,
                        const std::string& description, const std::string& preview) {
  std::string head;
  const auto add = [&](const char* key, const std::string& name, const std::string& content) {
    if (!content.empty())
      head += "<meta " + std::string(key) + "=\"" + name + "\" content=\"" + escaped(content) + "\"/>\n";
  };
  add("name", "description", description);
  add("property", "og:type", "website");
  add("property", "og:title", title);
  add("property", "og:description", description);
  if (url.empty()) return head;
  head += "<link rel=\"canonical\" href=\"" + escaped(url + file) + "\"/>\n";
  add("property", "og:url", url + file);
  if (preview.empty()) return head;
  add("property", "og:image", url + preview);
  add("property", "og:image:width", std::to_string(kPreviewWidth));
  add("property", "og:image:height", std::to_string(kPreviewHeight));
  add("name", "twitter:card", "summary_large_image");
  return head;
}

}  // namespace polhode
