// SPDX-License-Identifier: MIT
#include "app/companion/typed_folder.h"

#include "app/exit_codes.h"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <string_view>

namespace polhode {

namespace {

/// What is to be said of a beginning that means nothing.
CommandError refusal(const std::string& reason, const std::string& beginning) {
  return {ExitCode::usage, fmt::format("{}; a folder of this name is ./{}", reason, beginning)};
}

std::string home() {
  if (const char* set = std::getenv("HOME"); set && *set) return set;
  const passwd* user = getpwuid(getuid());
  return user ? user->pw_dir : throw refusal("HOME is not set", "~");
}

std::string home_of(const std::string& name) {
  const passwd* user = getpwnam(name.c_str());
  return user ? user->pw_dir : throw refusal(fmt::format("there is no user called {}", name), '~' + name);
}

/// "HOME" of "$HOME" and "${HOME}"; empty: no name of a variable.
std::string variable_in(std::string_view beginning) {
  beginning.remove_prefix(1);
  if (beginning.starts_with('{') && beginning.ends_with('}'))
    beginning = beginning.substr(1, beginning.size() - 2);
  for (const char c : beginning)
    if (c != '_' && !std::isalnum(static_cast<unsigned char>(c))) return {};
  return std::string(beginning);
}

}  // namespace

std::filesystem::path typed_folder(const std::string& typed) {
  if (typed.empty()) return ".";
  const std::string beginning = typed.substr(0, typed.find('/'));
  const std::string rest = typed.substr(beginning.size());
  if (beginning == "~") return home() + rest;
  if (beginning.starts_with('~')) return home_of(beginning.substr(1)) + rest;
  const std::string variable = beginning.starts_with('$') ? variable_in(beginning) : "";
  if (variable.empty()) return typed;
  const char* value = std::getenv(variable.c_str());
  if (!value || !*value) throw refusal(fmt::format("{} is not set", variable), beginning);
  return value + rest;
}

}  // namespace polhode
