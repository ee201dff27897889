// SPDX-License-Identifier: MIT
#include "tests/layers/rules.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>

namespace polhode::layers {
namespace {

using Names = std::vector<std::string_view>;

/// A layer is the folder its files are in; the first row whose folder starts a path is that file's layer.
struct Layer {
  std::string_view folder;
  Names ours;     ///< what it may include of ours, by how the name starts
  Names outside;  ///< and of other libraries; the C++ standard library is everybody's
  Names never;    ///< but for these headers of it
  bool is_library = true;
};

const Names kPosix = {"dlfcn.h", "fcntl.h", "poll.h", "pwd.h", "signal.h", "spawn.h", "sys/", "unistd.h"};
const Names kConsole = {"iostream", "print"};
const Names kConsoleAndFiles = {"iostream", "print", "filesystem", "fstream"};

Names operator+(Names a, const Names& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Small headers that every layer of render/ and above it shares.
const Names kShared = {"base/result.h", "base/color.h", "base/printable.h"};

const std::vector<Layer>& layers() {
  static const Names kProgram = {"app/", "lessons/", "render/", "physics/"};
  static const Names kProgramLibraries =
      Names{"CLI/", "fmt/", "nlohmann/", "sha256.h", "qpdf/", "Eigen/"} + kPosix;
  static const std::vector<Layer> kLayers = {
      {"physics/", {"physics/"}, {"Eigen/"}, kConsoleAndFiles},
      {"base/result.h", {}, {}, kConsoleAndFiles},
      {"base/color.h", {}, {}, kConsoleAndFiles},
      {"base/printable.h", {}, {}, kConsoleAndFiles},
      {"render/scene/",
       Names{"physics/", "render/scene/", "render/type/"} + kShared,
       {"Eigen/"},
       kConsoleAndFiles},
      {"render/type/", Names{"render/type/"} + kShared, {"ft2build.h", "freetype/", "FT_", "hb"}, kConsole},
      {"render/image/",
       {"render/image/", "base/result.h"},
       Names{"png.h", "zlib.h", "libdeflate.h", "isa-l/", "webp/"} + kPosix,
       kConsole},
      {"render/gl/",
       Names{"render/gl/", "render/scene/", "render/type/", "render/image/", "physics/body/types.h"} +
           kShared,
       Names{"Eigen/", "GL/", "EGL/", "KHR/"} + kPosix, kConsole},
      {"lessons/",
       Names{"lessons/", "physics/", "render/scene/", "render/type/"} + kShared,
       {"Eigen/", "md4c.h", "toml++/"},
       kConsoleAndFiles},
      {"app/window",
       kProgram,
       Names{"GLFW/", "X11/", "imgui", "backends/imgui_impl_glfw.h"} + kProgramLibraries,
       {},
       false},
      {"app/", kProgram, kProgramLibraries, {}, false},
      {"tests/bench/",
       kProgram + Names{"tests/bench/"},
       kProgramLibraries + Names{"benchmark/", "png.h", "EGL/", "mujoco/", "boost/", "gsl/", "arkode/",
                                 "cvode/", "nvector/", "sundials/", "sunnonlinsol/"},
       {},
       false},
      {"tests/window/",
       kProgram + Names{"tests/"},
       Names{"gtest/", "gmock/", "xcb/", "nlohmann/"} + kPosix,
       {},
       false},
      {"tests/oracle/", kProgram + Names{"tests/"}, {"gtest/", "gmock/", "ginac/"}, {}, false},
      {"tests/",
       kProgram + Names{"tests/"},
       kProgramLibraries + Names{"gtest/", "gmock/", "benchmark/", "GL/", "EGL/", "png.h", "zlib.h", "webp/",
                                 "imgui.h", "malloc.h", "poll.h", "spawn.h", "stdlib.h"},
       {},
       false},
  };
  return kLayers;
}

bool starts_with_any(std::string_view name, const Names& starts) {
  return std::ranges::any_of(starts, [&](std::string_view start) { return name.starts_with(start); });
}

const Layer* layer_of(std::string_view path) {
  const auto found =
      std::ranges::find_if(layers(), [&](const Layer& layer) { return path.starts_with(layer.folder); });
  return found == layers().end() ? nullptr : &*found;
}

/// Headers of the C++ standard library have neither a folder nor an ending.
bool is_standard(std::string_view name) {
  return name.find_first_of("./") == name.npos && !name.starts_with("FT_");
}

bool may_include(const Layer& layer, std::string_view name) {
  if (is_standard(name)) return std::ranges::find(layer.never, name) == layer.never.end();
  return starts_with_any(name, layer.ours) || starts_with_any(name, layer.outside);
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Where the comment or literal that opens at `begin` ends (one past), or nothing if none opens there.
std::optional<std::size_t> end_of_blank(std::string_view text, std::size_t begin) {
  const auto past = [&](std::string_view what, std::size_t from) {
    const std::size_t at = text.find(what, from);
    return at == text.npos ? text.size() : at + what.size();
  };
  const std::string_view rest = text.substr(begin);
  if (rest.starts_with("//")) return std::min(text.find('\n', begin), text.size());
  if (rest.starts_with("/*")) return past("*/", begin + 2);
  if (rest.starts_with("R\"")) {
    const std::size_t open = text.find('(', begin);
    if (open == text.npos) return text.size();
    return past(')' + std::string(text.substr(begin + 2, open - begin - 2)) + '"', open);
  }
  const char quote = rest.front();
  if (quote != '"' && quote != '\'') return std::nullopt;
  // Between two digits it separates thousands.
  if (quote == '\'' && begin > 0 && std::isxdigit(static_cast<unsigned char>(text[begin - 1])))
    return std::nullopt;
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == quote || text[i] == '\n')
      return i + 1;
  }
  return text.size();
}

/// Whether the line that holds `place` is an `#include`: its quotes are no literal.
bool on_include_line(std::string_view text, std::size_t place) {
  const std::size_t newline = text.rfind('\n', place);
  const std::string line(text.substr(newline == text.npos ? 0 : newline + 1, 80));
  static const std::regex kInclude(R"(^\s*#\s*include\b)");
  return std::regex_search(line.begin(),
                           line.begin() + std::ptrdiff_t(std::min(line.find('\n'), line.size())), kInclude);
}

void check_printing(const std::string& path, const std::string& code, std::vector<Finding>& findings) {
  static const std::regex kStreams(R"(\bstd::(cout|cerr|clog)\b)");
  static const std::regex kCalls(
      R"((^|[^\w.>])(v?f?printf|f?puts|putchar|perror|exit|_exit|quick_exit|abort|terminate)\s*\()");
  int number = 0;
  for (const std::string& line : lines_of(code)) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, kStreams) || std::regex_search(line, match, kCalls)) {
      findings.push_back({path, number, "a library neither prints nor exits: " + match.str()});
    }
  }
}

}  // namespace

std::string code_of(std::string_view text) {
  std::string code(text);
  for (std::size_t i = 0; i < text.size();) {
    const auto end = end_of_blank(text, i);
    const bool is_operand = text[i] == '"' && on_include_line(text, i);
    if (end && !is_operand) {
      std::replace_if(
          code.begin() + std::ptrdiff_t(i), code.begin() + std::ptrdiff_t(*end),
          [](char c) { return c != '\n'; }, ' ');
    }
    i = end ? *end : i + 1;
  }
  return code;
}

std::vector<Include> includes_of(std::string_view text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>|(\w+)))re");
  std::vector<Include> includes;
  int number = 0;
  for (const std::string& line : lines_of(code_of(text))) {
    ++number;
    std::smatch match;
    if (!std::regex_search(line, match, kInclude)) continue;
    includes.push_back({match[1].str() + match[2].str() + match[3].str(), number});
  }
  return includes;
}

std::vector<Finding> broken_rules(const std::string& path, std::string_view text) {
  const Layer* layer = layer_of(path);
  if (!layer) return {{path, 1, "in no layer: give its folder a row in tests/layers/rules.cpp"}};

  std::vector<Finding> findings;
  for (const Include& include : includes_of(text)) {
    if (may_include(*layer, include.name)) continue;
    findings.push_back({path, include.line, std::string(layer->folder) + " may not include " + include.name});
  }
  if (layer->is_library) check_printing(path, code_of(text), findings);
  if (path.ends_with(".h") && text.find("#pragma once") == text.npos) {
    findings.push_back({path, 1, "a header begins with #pragma once"});
  }
  return findings;
}

bool names_licence(std::string_view text) {
  const std::vector<std::string> lines = lines_of(text.substr(0, 400));
  const std::size_t place = !lines.empty() && lines[0].starts_with("#!") ? 1 : 0;
  return place < lines.size() && lines[place].find("SPDX-License-Identifier: MIT") != std::string::npos;
}

}  // namespace polhode::layers
