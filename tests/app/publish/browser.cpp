// SPDX-License-Identifier: MIT
#include "tests/app/publish/browser.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <stdexcept>
#include <thread>

namespace polhode {

using Json = nlohmann::json;

namespace {

constexpr int kPatience_ms = 90'000;  // a busy machine takes half a minute to start Chromium

/// The first of these in PATH; empty: none.
std::string chromium() {
  const char* path = std::getenv("PATH");
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::string folders = path ? path : "/usr/bin:/bin";
    for (std::size_t begin = 0; begin <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', begin), folders.size());
      const std::string file = folders.substr(begin, end - begin) + '/' + name;
      if (access(file.c_str(), X_OK) == 0) return file;
      begin = end + 1;
    }
  }
  return {};
}

/// In the child: Chromium reads commands from 3 and answers on 4.
[[noreturn]] void become(const std::string& program, std::vector<std::string> words, int from, int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  const int read_end = fcntl(from, F_DUPFD, 10), write_end = fcntl(to, F_DUPFD, 10);
  dup2(read_end, 3);
  dup2(write_end, 4);
  const int nothing = ::open("/dev/null", O_WRONLY);
  dup2(nothing, STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  _exit(127);
}

struct Key {
  std::string code;
  int number;  ///< Windows virtual key code
  std::string text;
};

Key key_of(const std::string& key) {
  static const std::map<std::string, Key> kNamed = {{"ArrowRight", {"ArrowRight", 39, ""}},
                                                    {"ArrowLeft", {"ArrowLeft", 37, ""}},
                                                    {"ArrowUp", {"ArrowUp", 38, ""}},
                                                    {"ArrowDown", {"ArrowDown", 40, ""}},
                                                    {"PageDown", {"PageDown", 34, ""}},
                                                    {"PageUp", {"PageUp", 33, ""}},
                                                    {"Home", {"Home", 36, ""}},
                                                    {"End", {"End", 35, ""}},
                                                    {"Enter", {"Enter", 13, "\r"}},
                                                    {"Escape", {"Escape", 27, ""}},
                                                    {"Backspace", {"Backspace", 8, ""}},
                                                    {"Tab", {"Tab", 9, ""}},
                                                    {" ", {"Space", 32, " "}},
                                                    {"?", {"Slash", 191, "?"}}};
  if (const auto found = kNamed.find(key); found != kNamed.end()) return found->second;
  const char c = key.at(0);
  const bool digit = c >= '0' && c <= '9';
  const char upper = static_cast<char>(std::toupper(c));
  return {std::string(digit ? "Digit" : "Key") + upper, upper, key};
}

std::string decoded(const std::string& base64) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char c : base64) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string::npos) break;
    group = group << 6 | static_cast<unsigned>(digit);
    if ((bits += 6) >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 0xFF);
  }
  return bytes;
}

}  // namespace

std::unique_ptr<Browser> Browser::start(int width, int height, Graphics graphics) {
  const std::string program = chromium();
  if (program.empty()) return nullptr;
  std::unique_ptr<Browser> browser(new Browser);
  std::array<int, 2> commands{}, answers{};
  if (pipe2(commands.data(), O_CLOEXEC) != 0 || pipe2(answers.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("cannot make a pipe");
  std::vector<std::string> words = {
      program, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--no-first-run",
      "--hide-scrollbars", "--disable-background-networking", "--disable-component-update",
      "--disable-extensions",
      // with a mouse, as on a desktop
      "--blink-settings=primaryHoverType=2,availableHoverTypes=2,primaryPointerType=4,availablePointerTypes="
      "4",
      "--user-data-dir=" + browser->home_.path().string(),
      "--window-size=" + std::to_string(width) + "," + std::to_string(height), "--remote-debugging-pipe",
      "about:blank"};
  if (graphics == Graphics::webgl)
    words.insert(words.end() - 1, {"--use-angle=swiftshader", "--enable-unsafe-swiftshader"});
  else
    words.insert(words.end() - 1, "--disable-gpu");
  browser->process_ = fork();
  if (browser->process_ == 0) become(program, words, commands[0], answers[1]);
  close(commands[0]);
  close(answers[1]);
  browser->to_ = commands[1];
  browser->from_ = answers[0];

  const Json targets = browser->call("Target.getTargets");
  for (const Json& target : targets["targetInfos"])
    if (target["type"] == "page")
      browser->session_ = browser->call("Target.attachToTarget",
                                        {{"targetId", target["targetId"]}, {"flatten", true}})["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Log", "Network"})
    browser->call(std::string(domain) + ".enable");
  browser->resize(width, height);
  return browser;
}

Browser::~Browser() {
  if (process_ > 0) {
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (to_ >= 0) close(to_);
  if (from_ >= 0) close(from_);
}

Json Browser::receive() {
  for (;;) {
    if (const std::size_t end = received_.find('\0'); end != std::string::npos) {
      Json message = Json::parse(received_.substr(0, end));
      received_.erase(0, end + 1);
      return message;
    }
    pollfd ready{from_, POLLIN, 0};
    if (poll(&ready, 1, kPatience_ms) <= 0) throw std::runtime_error("Chromium does not answer");
    std::array<char, 65536> buffer{};
    const ssize_t count = read(from_, buffer.data(), buffer.size());
    if (count <= 0) throw std::runtime_error("Chromium has gone");
    received_.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

Json Browser::call(const std::string& method, const Json& parameters) {
  Json command = {{"id", ++last_id_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) command["sessionId"] = session_;
  const std::string text = command.dump();
  // With the final zero.
  if (write(to_, text.c_str(), text.size() + 1) != static_cast<ssize_t>(text.size() + 1))
    throw std::runtime_error("Chromium does not listen");
  for (;;) {
    const Json message = receive();
    if (message.contains("method")) note(message);
    if (message.value("id", 0) != last_id_) continue;
    if (message.contains("error")) throw std::runtime_error(method + ": " + message["error"].dump());
    return message["result"];
  }
}

void Browser::note(const Json& event) {
  const std::string method = event["method"];
  const Json& parameters = event["params"];
  if (method == "Page.loadEventFired") ++loads_;
  if (method == "Runtime.exceptionThrown") complaints_.push_back(parameters["exceptionDetails"].dump());
  if (method == "Log.entryAdded") complaints_.push_back(parameters["entry"]["text"]);
  if (method == "Network.requestWillBeSent") {
    const std::string url = parameters["request"]["url"];
    if (!url.starts_with("file:") && !url.starts_with("data:")) complaints_.push_back("request of " + url);
  }
}

void Browser::wait_for_load() {
  while (loads_ == 0)
    if (const Json message = receive(); message.contains("method")) note(message);
}

void Browser::open(const std::filesystem::path& file, const std::string& hash) {
  call("Page.navigate", {{"url", "about:blank"}});
  loads_ = 0;
  wait_for_load();
  loads_ = 0;
  call("Page.navigate", {{"url", "file://" + std::filesystem::absolute(file).string() + hash}});
  wait_for_load();
}

void Browser::reload() {
  loads_ = 0;
  call("Page.reload");
  wait_for_load();
}

void Browser::press(const std::string& key) {
  constexpr std::string_view kShift = "Shift+";
  const bool shift = key.starts_with(kShift);
  const std::string name = shift ? key.substr(kShift.size()) : key;
  const Key found = key_of(name);
  Json event = {{"type", found.text.empty() ? "rawKeyDown" : "keyDown"},
                {"key", name},
                {"code", found.code},
                {"windowsVirtualKeyCode", found.number},
                {"modifiers", shift ? 8 : 0}};
  if (!found.text.empty()) event["text"] = found.text;
  call("Input.dispatchKeyEvent", event);
  event["type"] = "keyUp";
  event.erase("text");
  call("Input.dispatchKeyEvent", event);
}

void Browser::click(double x, double y) {
  for (const char* type : {"mousePressed", "mouseReleased"})
    call("Input.dispatchMouseEvent",
         {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"clickCount", 1}});
}

void Browser::swipe(double from_x, double to_x, double y) {
  const auto touch = [&](const char* type, const Json& points) {
    call("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
  };
  touch("touchStart", {{{"x", from_x}, {"y", y}}});
  for (int i = 1; i <= 4; ++i) touch("touchMove", {{{"x", from_x + (to_x - from_x) * i / 4}, {"y", y}}});
  touch("touchEnd", Json::array());
}

void Browser::tap(double x, double y) {
  call("Input.dispatchTouchEvent", {{"type", "touchStart"}, {"touchPoints", {{{"x", x}, {"y", y}}}}});
  call("Input.dispatchTouchEvent", {{"type", "touchEnd"}, {"touchPoints", Json::array()}});
}

void Browser::spread(const Vec2& about, double from_px, double to_px) {
  const auto touch = [&](const char* type, double apart) {
    call("Input.dispatchTouchEvent", {{"type", type},
                                      {"touchPoints",
                                       {{{"x", about.x() - apart / 2}, {"y", about.y()}, {"id", 0}},
                                        {{"x", about.x() + apart / 2}, {"y", about.y()}, {"id", 1}}}}});
  };
  touch("touchStart", from_px);
  constexpr int kMoves = 3;
  for (int i = 1; i <= kMoves; ++i) touch("touchMove", from_px + (to_px - from_px) * i / kMoves);
  call("Input.dispatchTouchEvent", {{"type", "touchEnd"}, {"touchPoints", Json::array()}});
}

void Browser::drag(const Vec2& from, const Vec2& to) {
  const auto mouse = [&](const char* type, const Vec2& at, int buttons) {
    call("Input.dispatchMouseEvent", {{"type", type},
                                      {"x", at.x()},
                                      {"y", at.y()},
                                      {"button", "left"},
                                      {"buttons", buttons},
                                      {"clickCount", 1}});
  };
  mouse("mousePressed", from, 1);
  for (int i = 1; i <= kMovesOfADrag; ++i) mouse("mouseMoved", from + (to - from) * i / kMovesOfADrag, 1);
  mouse("mouseReleased", to, 0);
}

void Browser::forbid_scripts() { call("Emulation.setScriptExecutionDisabled", {{"value", true}}); }

void Browser::prefer(const std::string& color_scheme) {
  call("Emulation.setEmulatedMedia",
       {{"features", {{{"name", "prefers-color-scheme"}, {"value", color_scheme}}}}});
}

void Browser::resize(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Browser::become_phone(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 2}, {"mobile", true}});
  call("Emulation.setTouchEmulationEnabled", {{"enabled", true}, {"maxTouchPoints", 5}});
}

Json Browser::value_of(const std::string& expression) {
  const Json result =
      call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  if (result.contains("exceptionDetails")) throw std::runtime_error(result["exceptionDetails"].dump());
  return result["result"].value("value", Json());
}

Json Browser::wait_for(const std::string& expression, const Json& value) {
  constexpr int kTries = 500;
  Json found;
  for (int i = 0; i < kTries && (found = value_of(expression)) != value; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return found;
}

std::vector<std::string> Browser::names_of_formulas() {
  const Json tree = call("Accessibility.getFullAXTree");
  std::map<std::string, const Json*> nodes;  // by their ids: they come generation by generation
  for (const Json& node : tree["nodes"]) nodes.emplace(node["nodeId"], &node);
  std::vector<std::string> names, open;
  if (!tree["nodes"].empty()) open.push_back(tree["nodes"][0]["nodeId"]);
  while (!open.empty()) {
    const auto found = nodes.find(open.back());
    open.pop_back();
    if (found == nodes.end()) continue;
    const Json& node = *found->second;
    if (!node.value("ignored", false) && node["role"]["value"] == "MathMLMath")
      names.push_back(node.value("name", Json::object()).value("value", ""));
    const Json children = node.value("childIds", Json::array());
    for (auto child = children.rbegin(); child != children.rend(); ++child) open.push_back(*child);
  }
  return names;
}

std::string Browser::screenshot() {
  return decoded(call("Page.captureScreenshot", {{"format", "png"}})["data"]);
}

std::string Browser::data_in(const std::string& address) {
  return decoded(address.substr(address.find(',') + 1));
}

std::string Browser::print() {
  return decoded(call("Page.printToPDF", {{"preferCSSPageSize", true}, {"printBackground", true}})["data"]);
}

}  // namespace polhode
