// SPDX-License-Identifier: MIT
#include "tests/app/publish/firefox.h"

#include "tests/app/publish/browser.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <map>
#include <stdexcept>
#include <thread>

namespace polhode {

using Json = nlohmann::json;

namespace {

constexpr int kPatience_ms = 90'000;  // a busy machine takes half a minute to start a browser

/// No one looks for updates, and nothing but the page asks the network. Marionette takes any free port, and
/// writes it into the profile.
constexpr const char* kPreferences = R"(
user_pref("marionette.port", 0);
user_pref("accessibility.force_disabled", -1);
user_pref("accessibility.tabfocus", 7);
user_pref("app.update.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("browser.startup.homepage_override.mstone", "ignore");
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("extensions.update.enabled", false);
user_pref("layout.css.devPixelsPerPx", "1.0");
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
user_pref("services.settings.server", "data:,");
user_pref("toolkit.telemetry.enabled", false);
)";

/// Keeps what the page asks for; of requests those count that belong to a tab.
constexpr const char* kWatch = R"(
  const window = Services.wm.getMostRecentWindow("navigator:browser");
  if (!window.watched) {
    window.watched = [];
    // From now on there is a tree for those who do not see the page; it lasts as long as this is held.
    window.accessibility = Cc["@mozilla.org/accessibilityService;1"].getService(Ci.nsIAccessibilityService);
    Services.obs.addObserver((channel) => {
      channel.QueryInterface(Ci.nsIHttpChannel);
      if (channel.loadInfo.browsingContextID) window.watched.push("request of " + channel.URI.spec);
    }, "http-on-modify-request");
  }
  window.watched.length = 0;
  Services.console.reset();
)";

/// Without what is said of a formula of which only the beginning has come: Firefox lays out pages as they
/// come.
constexpr const char* kComplaints = R"(
  const window = Services.wm.getMostRecentWindow("navigator:browser");
  const said = Services.console.getMessageArray()
    .filter((m) => m instanceof Ci.nsIScriptError && m.sourceName.startsWith("file:"))
    .filter((m) => !m.errorMessage.startsWith("Invalid markup: Incorrect number of children"))
    .map((m) => m.errorMessage);
  return [...said, ...window.watched];
)";

constexpr const char* kFormulas = R"(
  const service = Cc["@mozilla.org/accessibilityService;1"].getService(Ci.nsIAccessibilityService);
  const window = Services.wm.getMostRecentWindow("navigator:browser");
  const names = [];
  const walk = (node) => {
    if (service.getStringRole(node.role) === "math") { names.push(node.name); return; }
    for (let child = node.firstChild; child; child = child.nextSibling) walk(child);
  };
  const page = service.getAccessibleFor(window.gBrowser.selectedBrowser);
  if (page) walk(page);
  return names;
)";

}  // namespace

std::unique_ptr<Firefox> Firefox::start(int width, int height) {
  std::string program;
  for (const char* name : {"/usr/bin/firefox-esr", "/usr/bin/firefox"})
    if (program.empty() && access(name, X_OK) == 0) program = name;
  if (program.empty()) return nullptr;
  std::unique_ptr<Firefox> browser(new Firefox);
  write_text(browser->home_ / "user.js", kPreferences);
  browser->process_ = fork();
  if (browser->process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setpgid(0, 0);
    const int nothing = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
    setenv("HOME", browser->home_.path().c_str(), 1);
    // Beyond what a screen may be: pages of 4K are looked at too.
    setenv("MOZ_HEADLESS_WIDTH", "4000", 1);
    setenv("MOZ_HEADLESS_HEIGHT", "2400", 1);
    execl(program.c_str(), program.c_str(), "--headless", "--marionette", "--remote-allow-system-access",
          "--profile", browser->home_.path().c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  browser->connect();
  browser->call("WebDriver:NewSession", {{"capabilities", {{"alwaysMatch", Json::object()}}}});
  browser->resize(width, height);
  browser->value_inside(kWatch);
  return browser;
}

Firefox::~Firefox() {
  if (socket_ >= 0) close(socket_);
  if (process_ <= 0) return;
  kill(-process_, SIGKILL);
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Firefox::connect() {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + std::chrono::milliseconds(kPatience_ms);
  while (socket_ < 0) {
    if (Clock::now() > last) throw std::runtime_error("Firefox does not start");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const std::filesystem::path file = home_ / "MarionetteActivePort";
    const std::string port = std::filesystem::exists(file) ? text_of(file) : "";
    if (port.empty()) continue;
    const int tried = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(std::stoi(port)));
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(tried, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0)
      socket_ = tried;
    else
      close(tried);
  }
  receive();  // which protocol it speaks
}

/// "12:[1,5,null,{}]"
Json Firefox::receive() {
  for (;;) {
    if (const std::size_t colon = received_.find(':'); colon != std::string::npos) {
      const std::size_t length = std::stoul(received_.substr(0, colon)), end = colon + 1 + length;
      if (received_.size() >= end) {
        Json message = Json::parse(received_.substr(colon + 1, length));
        received_.erase(0, end);
        return message;
      }
    }
    pollfd ready{socket_, POLLIN, 0};
    if (poll(&ready, 1, kPatience_ms) <= 0) throw std::runtime_error("Firefox does not answer");
    std::array<char, 65536> buffer{};
    const ssize_t count = read(socket_, buffer.data(), buffer.size());
    if (count <= 0) throw std::runtime_error("Firefox has gone");
    received_.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

Json Firefox::call(const std::string& command, const Json& parameters) {
  const std::string text = Json::array({0, ++last_id_, command, parameters}).dump();
  const std::string framed = std::to_string(text.size()) + ':' + text;
  for (std::size_t sent = 0; sent < framed.size();) {
    const ssize_t count = write(socket_, framed.data() + sent, framed.size() - sent);
    if (count <= 0) throw std::runtime_error("Firefox does not listen");
    sent += static_cast<std::size_t>(count);
  }
  for (;;) {
    const Json message = receive();
    if (message.at(0) != 1 || message.at(1) != last_id_) continue;
    if (!message.at(2).is_null()) throw std::runtime_error(command + ": " + message.at(2).dump());
    return message.at(3);
  }
}

Json Firefox::value_inside(const std::string& script) {
  call("Marionette:SetContext", {{"value", "chrome"}});
  Json made = call("WebDriver:ExecuteScript", {{"script", script}, {"args", Json::array()}});
  call("Marionette:SetContext", {{"value", "content"}});
  return made["value"];
}

void Firefox::open(const std::filesystem::path& file) {
  call("WebDriver:Navigate", {{"url", "about:blank"}});
  value_inside(kWatch);
  call("WebDriver:Navigate", {{"url", "file://" + std::filesystem::absolute(file).string()}});
}

/// A window has a frame, and is never narrower than its buttons need: the page's own room is set.
void Firefox::resize(int width, int height) {
  value_inside(
      "const browser = Services.wm.getMostRecentWindow('navigator:browser').gBrowser.selectedBrowser;"
      "for (const [name, px] of [['width', " +
      std::to_string(width) + "], ['height', " + std::to_string(height) +
      "]]) { for (const bound of ['min-', 'max-', '']) browser.style.setProperty(bound + name, px + 'px'); "
      "}");
  const Json wanted = {width, height};
  for (int i = 0; i < 100 && value_of("[innerWidth, innerHeight]") != wanted; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

void Firefox::prefer(const std::string& color_scheme) {
  value_inside(
      "Services.wm.getMostRecentWindow('navigator:browser').gBrowser.selectedBrowser.browsingContext"
      ".prefersColorSchemeOverride = " +
      Json(color_scheme).dump() + ";");
}

void Firefox::press(const std::string& key) {
  static const std::map<std::string, std::string> kNamed = {
      {"Tab", "\uE004"}, {"Enter", "\uE007"}, {"Escape", "\uE00C"}};
  constexpr std::string_view kShift = "Shift+";
  const bool shift = key.starts_with(kShift);
  const std::string name = shift ? key.substr(kShift.size()) : key;
  const auto found = kNamed.find(name);
  Json actions = Json::array();
  const auto act = [&](const char* type, const std::string& value) {
    actions.push_back({{"type", type}, {"value", value}});
  };
  if (shift) act("keyDown", "\uE008");
  for (const char* type : {"keyDown", "keyUp"}) act(type, found != kNamed.end() ? found->second : name);
  if (shift) act("keyUp", "\uE008");
  call("WebDriver:PerformActions",
       {{"actions", Json::array({{{"type", "key"}, {"id", "keyboard"}, {"actions", actions}}})}});
}

Json Firefox::value_of(const std::string& expression) {
  return call("WebDriver:ExecuteScript",
              {{"script", "return (" + expression + ");"}, {"args", Json::array()}})["value"];
}

/// The tree comes in pieces from the page's process, some time after the page.
std::vector<std::string> Firefox::names_of_formulas() {
  const auto count = value_of("document.getElementsByTagName('math').length").get<std::size_t>();
  std::vector<std::string> names;
  for (int i = 0; i < 100; ++i) {
    std::vector<std::string> now = value_inside(kFormulas).get<std::vector<std::string>>();
    if (now.size() == count || (!now.empty() && i > 20 && now == names)) return now;
    names = std::move(now);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return names;
}

std::string Firefox::screenshot() {
  const Json shot = call("WebDriver:TakeScreenshot", {{"full", false}, {"hash", false}});
  return Browser::data_in("," + shot["value"].get<std::string>());
}

std::vector<std::string> Firefox::complaints() {
  return value_inside(kComplaints).get<std::vector<std::string>>();
}

}  // namespace polhode
