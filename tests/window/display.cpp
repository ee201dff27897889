// SPDX-License-Identifier: MIT
#include "tests/window/display.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <xcb/xcb.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace polhode::window_test {

namespace {

/// What xcb hands out is freed by free().
struct Free {
  void operator()(void* answer) const { std::free(answer); }
};
template <class T>
std::unique_ptr<T, Free> owned(T* answer) {
  return std::unique_ptr<T, Free>(answer);
}

/// The server writes its number and a line end once it listens.
std::string number_from(int pipe) {
  std::string said;
  std::array<char, 16> buffer{};
  pollfd ready{pipe, POLLIN, 0};
  while (said.find('\n') == std::string::npos) {
    const int patience_ms = static_cast<int>(std::chrono::milliseconds(kPatience).count());
    if (poll(&ready, 1, patience_ms) <= 0) throw std::runtime_error("Xvfb does not start");
    const ssize_t count = read(pipe, buffer.data(), buffer.size());
    if (count <= 0) throw std::runtime_error("Xvfb cannot start");
    said.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return said.substr(0, said.find('\n'));
}

}  // namespace

struct Display::Connection {
  explicit Connection(const std::string& display) : to(xcb_connect(display.c_str(), nullptr)) {
    if (xcb_connection_has_error(to)) throw std::runtime_error("cannot reach " + display);
    root = xcb_setup_roots_iterator(xcb_get_setup(to)).data->root;
  }
  ~Connection() { xcb_disconnect(to); }

  xcb_atom_t atom(const char* name) const {
    const auto cookie = xcb_intern_atom(to, 0, static_cast<std::uint16_t>(std::strlen(name)), name);
    const auto answer = owned(xcb_intern_atom_reply(to, cookie, nullptr));
    return answer ? answer->atom : xcb_atom_t{XCB_ATOM_NONE};
  }
  std::string property(xcb_window_t window, const char* name) const {
    const auto cookie = xcb_get_property(to, 0, window, atom(name), XCB_GET_PROPERTY_TYPE_ANY, 0, 1024);
    const auto answer = owned(xcb_get_property_reply(to, cookie, nullptr));
    if (!answer) return {};
    const auto length = static_cast<std::size_t>(xcb_get_property_value_length(answer.get()));
    return {static_cast<const char*>(xcb_get_property_value(answer.get())), length};
  }

  xcb_connection_t* to;
  xcb_window_t root;
};

std::string Display::why_not() {
  for (const char* program : {"Xvfb", "xdotool"})
    if (!is_installed(program)) return std::string(program) + " is not installed";
  return {};
}

Display::Display(Size size, const std::vector<std::string>& more_arguments) : size_(size) {
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
  std::vector<std::string> words = {
      "Xvfb",      "-displayfd", std::to_string(pipe[1]),
      "-screen",   "0",          std::to_string(size.width) + 'x' + std::to_string(size.height) + "x24",
      "-nolisten", "tcp",        "-noreset",
      "-r"};  // no key repeats because a busy machine lets it go late
  words.insert(words.end(), more_arguments.begin(), more_arguments.end());
  server_ = std::make_unique<Child>(Start{.words = words, .err = scratch_ / "err", .kept_open = pipe[1]});
  close(pipe[1]);
  name_ = ':' + number_from(pipe[0]);
  close(pipe[0]);
  connection_ = std::make_unique<Connection>(name_);
}

Display::~Display() = default;

void Display::act(const std::vector<std::string>& commands) const {
  std::vector<std::string> words = {"xdotool"};
  words.insert(words.end(), commands.begin(), commands.end());
  output_of(words, {{"DISPLAY", name_}});
}

Image Display::picture() const {
  const auto width = static_cast<std::uint16_t>(size_.width),
             height = static_cast<std::uint16_t>(size_.height);
  const auto cookie = xcb_get_image(connection_->to, XCB_IMAGE_FORMAT_Z_PIXMAP, connection_->root, 0, 0,
                                    width, height, ~std::uint32_t{0});
  const auto answer = owned(xcb_get_image_reply(connection_->to, cookie, nullptr));
  Image image = Image::blank(size_);
  if (!answer || static_cast<std::size_t>(xcb_get_image_data_length(answer.get())) != image.rgba.size())
    throw std::runtime_error("the display cannot be read");
  const std::uint8_t* bgrx = xcb_get_image_data(answer.get());  // of 24 bits, little-endian
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = bgrx[i + 2];
    image.rgba[i + 1] = bgrx[i + 1];
    image.rgba[i + 2] = bgrx[i];
    image.rgba[i + 3] = 255;
  }
  last_picture_ = image;
  return image;
}

std::vector<unsigned> Display::windows_of(pid_t process) const {
  std::vector<unsigned> windows;
  const auto cookie = xcb_query_tree(connection_->to, connection_->root);
  const auto tree = owned(xcb_query_tree_reply(connection_->to, cookie, nullptr));
  if (!tree) return windows;
  const xcb_window_t* children = xcb_query_tree_children(tree.get());
  for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
    const std::string id = connection_->property(children[i], "_NET_WM_PID");
    std::uint32_t owner = 0;
    if (id.size() == sizeof owner) std::memcpy(&owner, id.data(), sizeof owner);
    if (owner == static_cast<std::uint32_t>(process) && !title_of(children[i]).empty())
      windows.push_back(children[i]);
  }
  return windows;
}

std::optional<unsigned> Display::window_of(pid_t process) const {
  const std::vector<unsigned> windows = windows_of(process);
  return windows.empty() ? std::nullopt : std::optional(windows.front());
}

Box Display::box_of(unsigned window) const {
  const auto answer =
      owned(xcb_get_geometry_reply(connection_->to, xcb_get_geometry(connection_->to, window), nullptr));
  if (!answer) return {};
  return {answer->x, answer->y, answer->width, answer->height};
}

std::string Display::title_of(unsigned window) const { return connection_->property(window, "_NET_WM_NAME"); }

void Display::ask_to_close(unsigned window) const {
  xcb_client_message_event_t message{};
  message.response_type = XCB_CLIENT_MESSAGE;
  message.format = 32;
  message.window = window;
  message.type = connection_->atom("WM_PROTOCOLS");
  message.data.data32[0] = connection_->atom("WM_DELETE_WINDOW");
  xcb_send_event(connection_->to, 0, window, XCB_EVENT_MASK_NO_EVENT,
                 reinterpret_cast<const char*>(&message));
  xcb_flush(connection_->to);
}

}  // namespace polhode::window_test
