// SPDX-License-Identifier: MIT
#include "tests/layers/rules.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace polhode::layers {
namespace {

using Names = std::vector<std::string_view>;

/// A room is the folder its files are in; the first row whose folder starts a path is that file's room.
struct Room {
  std::string_view folder;
  Names sees;     ///< rooms whose headers it may reach, directly or through others; its own always
  Names outside;  ///< and of other libraries what it may include; the C++ standard library is everybody's
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

/// Lowest first. Each list is whole: what a room sees through another stands in it too.
const std::vector<Room>& rooms() {
  static const Names kScene = {"render/scene/", "physics/", "base/"};
  static const Names kClaims = Names{"lessons/claims/", "lessons/diagnostics/"} + kScene;
  static const Names kNotation = Names{"lessons/notation/", "render/typeset/"} + kClaims;
  static const Names kDerivation = Names{"lessons/derivation/"} + kNotation;
  static const Names kReader = Names{"lessons/reader/"} + kDerivation;
  static const Names kNarration = Names{"app/narration/"} + kReader;
  static const Names kPage = Names{"app/page/",  "render/figure/", "render/drawing/",
                                   "render/gl/", "render/image/",  "render/palette.h"} +
                             kNarration;
  static const Names kExport = Names{"app/export/", "render/vector/"} + kPage;
  static const Names kSession = Names{"app/session/"} + kExport;
  static const Names kWindow = Names{"app/window/"} + kSession;
  static const Names kProgram = {"app/", "lessons/", "render/", "physics/", "base/"};
  static const Names kFormats = {"fmt/", "nlohmann/", "Eigen/"};
  static const Names kControls = Names{"imgui"} + kFormats + kPosix;
  static const Names kProgramLibraries = Names{"CLI/", "qpdf/"} + kFormats + kPosix;
  static const std::vector<Room> kRooms = {
      {"base/files/", {"base/"}, kPosix, kConsole},
      {"base/", {}, {"Eigen/", "sha256.h", "sys/types.h"}, kConsoleAndFiles},
      {"physics/public/",
       {"physics/body/", "physics/geometry/", "physics/analysis/", "physics/motion.h", "physics/method.h",
        "physics/method_facts.h", "physics/effort.h", "base/result.h", "base/vectors.h"},
       {},
       kConsoleAndFiles},
      {"physics/", {"base/"}, {"Eigen/"}, kConsoleAndFiles},
      {"render/scene/", {"physics/", "base/"}, {"Eigen/"}, kConsoleAndFiles},
      {"render/typeset/", {"base/"}, {"ft2build.h", "freetype/", "FT_", "hb"}, kConsole},
      {"render/figure/", Names{"render/palette.h"} + kScene, {"Eigen/"}, kConsoleAndFiles},
      {"render/drawing/",
       Names{"render/palette.h", "render/typeset/"} + kScene,
       {"Eigen/"},
       kConsoleAndFiles},
      {"render/image/", {"base/"}, Names{"png.h", "zlib.h", "libdeflate.h", "isa-l/", "webp/"}, kConsole},
      {"render/gl/",
       {"render/figure/", "render/drawing/", "render/palette.h", "render/typeset/", "render/image/", "base/"},
       Names{"Eigen/", "GL/", "EGL/", "KHR/", "emscripten/"} + kPosix,
       kConsole},
      {"render/vector/",
       {"render/drawing/", "render/palette.h", "render/typeset/", "base/"},
       {"Eigen/", "fmt/", "qpdf/"},
       kConsoleAndFiles},
      {"render/palette", {"base/"}, {}, kConsoleAndFiles},
      {"lessons/diagnostics/", {"base/"}, {}, kConsoleAndFiles},
      {"lessons/claims/", Names{"lessons/diagnostics/"} + kScene, {"Eigen/"}, kConsoleAndFiles},
      {"lessons/notation/", Names{"render/typeset/"} + kClaims, {"Eigen/"}, kConsoleAndFiles},
      {"lessons/derivation/", kNotation, {"Eigen/"}, kConsoleAndFiles},
      {"lessons/reader/", kDerivation, {"Eigen/", "fmt/", "md4c.h", "toml++/"}, kConsoleAndFiles},
      {"app/narration/", kNarration, {"fmt/"}, kConsoleAndFiles},
      {"app/page/", kPage, {"fmt/"}, kConsole},
      {"app/export/", kExport, kFormats + kPosix, kConsole},
      {"app/publish/", Names{"app/publish/"} + kExport,
       Names{"fmt/", "nlohmann/", "archive", "libdeflate.h"} + kPosix, kConsole},
      {"app/session/", kSession, kFormats + kPosix, kConsole},
      {"app/web/",
       Names{"app/session/", "app/page/", "render/figure/", "render/drawing/", "render/gl/",
             "render/image/image.h", "render/palette.h"} +
           kNarration,
       Names{"emscripten/"} + kFormats, kConsoleAndFiles + Names{"thread", "future"}},
      {"app/window/panels/", kWindow, kControls, kConsole},
      {"app/window/screen/", kWindow, kControls, kConsole},  // drawn off-screen too, without GLFW
      {"app/window/", kWindow, Names{"GLFW/", "X11/", "backends/imgui_impl_glfw.h"} + kControls, kConsole},
      {"app/cli/", kProgram, kProgramLibraries, {}, false},
      {"examples/",
       {},
       {"polhode/body.h", "polhode/motion.h", "polhode/method.h", "polhode/poinsot.h", "polhode/errors.h"},
       {},
       false},
      {"tests/bench/",
       kProgram + Names{"tests/bench/", "tests/support/"},
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
                                 "archive", "arpa/inet.h", "imgui.h", "imgui_internal.h", "malloc.h",
                                 "poll.h", "spawn.h", "stdlib.h"},
       {},
       false},
  };
  return kRooms;
}

bool starts_with_any(std::string_view name, const Names& starts) {
  return std::ranges::any_of(starts, [&](std::string_view start) { return name.starts_with(start); });
}

const Room* room_of(std::string_view path) {
  const auto found =
      std::ranges::find_if(rooms(), [&](const Room& room) { return path.starts_with(room.folder); });
  return found == rooms().end() ? nullptr : &*found;
}

/// Headers of the C++ standard library have neither a folder nor an ending.
bool is_standard(std::string_view name) {
  return name.find_first_of("./") == name.npos && !name.starts_with("FT_");
}

bool may_reach(const Room& room, std::string_view path) {
  return path.starts_with(room.folder) || starts_with_any(path, room.sees);
}

bool may_include(const Room& room, std::string_view name) {
  if (is_standard(name)) return std::ranges::find(room.never, name) == room.never.end();
  return may_reach(room, name) || starts_with_any(name, room.outside);
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

/// Whether the room sees it because it sees a room that does.
bool follows_from_another(const Room& room, std::string_view seen) {
  return std::ranges::any_of(rooms(), [&](const Room& other) {
    return other.folder != room.folder && std::ranges::find(room.sees, other.folder) != room.sees.end() &&
           std::ranges::find(other.sees, seen) != other.sees.end();
  });
}

/// Of each file the includes that are files of ours.
using OwnIncludes = std::map<std::string, std::vector<Include>>;

OwnIncludes own_includes(const std::map<std::string, std::string>& sources) {
  OwnIncludes ours;
  for (const auto& [path, text] : sources)
    for (Include& include : includes_of(text))
      if (sources.contains(include.name)) ours[path].push_back(std::move(include));
  return ours;
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
  const Room* room = room_of(path);
  if (!room) return {{path, 1, "in no room: give its folder a row in tests/layers/rules.cpp"}};

  std::vector<Finding> findings;
  for (const Include& include : includes_of(text)) {
    if (may_include(*room, include.name)) continue;
    findings.push_back({path, include.line, std::string(room->folder) + " may not include " + include.name});
  }
  if (room->is_library) check_printing(path, code_of(text), findings);
  if (path.ends_with(".h") && text.find("#pragma once") == text.npos) {
    findings.push_back({path, 1, "a header begins with #pragma once"});
  }
  return findings;
}

std::vector<Finding> broken_closures(const std::map<std::string, std::string>& sources) {
  const OwnIncludes ours = own_includes(sources);
  std::vector<Finding> findings;
  for (const auto& [path, direct] : ours) {
    const Room* room = room_of(path);
    if (!room) continue;
    for (const Include& first : direct) {
      // From header to header, each once; the way there is for the reader of the message.
      std::vector<std::vector<std::string>> ways = {{first.name}};
      std::set<std::string> seen = {first.name};
      for (std::size_t i = 0; i < ways.size(); ++i) {
        const std::string& reached = ways[i].back();
        if (i > 0 && !may_reach(*room, reached)) {
          std::string way = path;
          for (const std::string& step : ways[i]) way += " -> " + step;
          findings.push_back({path, first.line, std::string(room->folder) + " may not reach " + way});
          break;
        }
        const auto further = ours.find(reached);
        if (further == ours.end()) continue;
        for (const Include& next : further->second) {
          if (!seen.insert(next.name).second) continue;
          std::vector<std::string> way = ways[i];
          way.push_back(next.name);
          ways.push_back(std::move(way));
        }
      }
    }
  }
  return findings;
}

std::vector<Finding> unused_arrows(const std::map<std::string, std::string>& sources) {
  const OwnIncludes ours = own_includes(sources);
  std::map<const Room*, std::set<std::string>> reached;  // by the files of a room, through all headers
  for (const auto& [path, direct] : ours) {
    const Room* room = room_of(path);
    if (!room || !room->is_library) continue;
    std::set<std::string>& of_room = reached[room];
    std::vector<std::string> ways = {path};
    while (!ways.empty()) {
      const auto further = ours.find(ways.back());
      ways.pop_back();
      if (further == ours.end()) continue;
      for (const Include& next : further->second)
        if (of_room.insert(next.name).second) ways.push_back(next.name);
    }
  }
  std::vector<Finding> findings;
  for (const auto& [room, paths] : reached)
    for (const std::string_view seen : room->sees) {
      const bool is_used =
          std::ranges::any_of(paths, [&](const std::string& path) { return path.starts_with(seen); });
      if (!is_used && seen != room->folder && !follows_from_another(*room, seen))
        findings.push_back({"tests/layers/rules.cpp", 1,
                            std::string(room->folder) + " may see " + std::string(seen) + ", and does not"});
    }
  return findings;
}

std::vector<std::string> types_of(std::string_view text) {
  static const std::regex kNamespace(R"(\bnamespace\s*([\w:]*)\s*$)");
  static const std::regex kType(
      R"((?:^|[\s>])(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(\w+)(?:\s+final)?\s*(?::(?!:)[^{]*)?$)");
  static const std::regex kAlias(R"(\busing\s+(\w+)\s*=)");
  static const std::regex kDirective(R"(^\s*#)");
  std::string code;
  bool goes_on = false;  // a directive, in the next line
  for (const std::string& line : lines_of(code_of(text))) {
    const bool is_directive = goes_on || std::regex_search(line, kDirective);
    goes_on = is_directive && line.ends_with('\\');
    if (!is_directive) code += line + '\n';
  }

  std::vector<std::string> types;
  std::vector<std::string> around;  // namespaces, from the outermost; a brace of another kind: empty
  std::string statement;            // as far as it has been read, where all that is around it are namespaces
  const auto in_namespaces = [&] {
    return std::ranges::none_of(around, [](const std::string& name) { return name.empty(); });
  };
  const auto add = [&](const std::string& type) {
    std::string whole;
    for (const std::string& name : around) whole += name + "::";
    if (whole.find("anonymous") == whole.npos) types.push_back(whole + type);
  };
  std::smatch match;
  for (const char c : code) {
    if (c == '{') {
      std::string name;
      if (in_namespaces()) {
        if (std::regex_search(statement, match, kNamespace))
          name = match[1].length() > 0 ? match[1].str() : "(anonymous)";
        else if (std::regex_search(statement, match, kType))
          add(match[1].str());
      }
      around.push_back(name);
      statement.clear();
    } else if (c == '}') {
      if (!around.empty()) around.pop_back();
      statement.clear();
    } else if (!in_namespaces()) {
      continue;
    } else if (c == ';') {
      if (std::regex_search(statement, match, kAlias)) add(match[1].str());
      statement.clear();
    } else {
      statement += c;
    }
  }
  return types;
}

std::vector<Finding> doubled_types(const std::map<std::string, std::string>& sources) {
  std::map<std::string, std::string> first;  // header, by the type
  std::vector<Finding> findings;
  for (const auto& [path, text] : sources) {
    if (!path.ends_with(".h")) continue;
    for (const std::string& type : types_of(text)) {
      const auto [known, is_new] = first.emplace(type, path);
      if (!is_new && known->second != path)
        findings.push_back({path, 1, type + " is defined in " + known->second + " too"});
    }
  }
  return findings;
}

bool names_licence(std::string_view text) {
  const std::vector<std::string> lines = lines_of(text.substr(0, 400));
  const std::size_t place = !lines.empty() && lines[0].starts_with("#!") ? 1 : 0;
  return place < lines.size() && lines[place].find("SPDX-License-Identifier: MIT") != std::string::npos;
}

}  // namespace polhode::layers
