// SPDX-License-Identifier: MIT
#include "app/session/saved/typed_folder.h"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace polhode {

namespace {

/// What is to be said of a beginning that means nothing.
Failure<std::string> refusal(const std::string& reason, const std::string& beginning) {
  return failure(fmt::format("{}; a folder of this name is ./{}", reason, beginning));
}

Result<std::string> home() {
  if (const char* set = std::getenv("HOME"); set && *set) return std::string(set);
  const passwd* user = getpwuid(getuid());
  if (!user) return refusal("HOME is not set", "~");
  return std::string(user->pw_dir);
}

Result<std::string> home_of(const std::string& name) {
  const passwd* user = getpwnam(name.c_str());
  if (!user) return refusal(fmt::format("there is no user called {}", name), '~' + name);
  return std::string(user->pw_dir);
}

/// How many characters of a text are the name of a variable, as a shell takes it: the longest beginning of
/// letters, digits and underscores that does not begin with a digit.
std::size_t name_length(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  constexpr std::string_view kNames = "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  if (text.empty() || kDigits.find(text.front()) != text.npos) return 0;
  return std::min(text.find_first_not_of(kNames), text.size());
}

/// "HOME" and ".d" of "$HOME.d" and "${HOME}.d".
struct Variable {
  std::string name, rest;
};
std::optional<Variable> variable_in(std::string_view beginning) {
  if (!beginning.starts_with('$')) return std::nullopt;
  const bool is_braced = beginning.starts_with("${");
  beginning.remove_prefix(is_braced ? 2 : 1);
  const std::size_t length = name_length(beginning);
  if (length == 0 || (is_braced && !beginning.substr(length).starts_with('}'))) return std::nullopt;
  return Variable{std::string(beginning.substr(0, length)),
                  std::string(beginning.substr(is_braced ? length + 1 : length))};
}

}  // namespace

Result<std::filesystem::path> typed_folder(const std::string& typed) {
  using Path = std::filesystem::path;
  if (typed.empty()) return Path(".");
  const std::string beginning = typed.substr(0, typed.find('/'));
  const std::string rest = typed.substr(beginning.size());
  if (beginning.starts_with('~')) {
    const Result<std::string> found = beginning == "~" ? home() : home_of(beginning.substr(1));
    if (!found) return failure(found.error());
    return Path(*found + rest);
  }
  const std::optional<Variable> variable = variable_in(beginning);
  if (!variable) return Path(typed);
  const char* value = std::getenv(variable->name.c_str());
  if (!value || !*value) return refusal(fmt::format("{} is not set", variable->name), beginning);
  return Path(value + variable->rest + rest);
}

}  // namespace polhode
