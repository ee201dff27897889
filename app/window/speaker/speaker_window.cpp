// SPDX-License-Identifier: MIT
#include "app/window/speaker/speaker_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace polhode {

ScreenFrame frame_of_window(GLFWwindow* window) {
  ScreenFrame frame;
  glfwGetFramebufferSize(window, &frame.size.width, &frame.size.height);
  frame.size = {std::max(1, frame.size.width), std::max(1, frame.size.height)};
  float scale_x = 1, scale_y = 1;
  glfwGetWindowContentScale(window, &scale_x, &scale_y);
  ImGui::GetIO().DisplayFramebufferScale = {1, 1};
  frame.scale = std::clamp(static_cast<double>(std::max(scale_x, scale_y)), 1.0, 4.0);
  return frame;
}

Result<std::unique_ptr<SpeakerWindow>> SpeakerWindow::open(Display& audience, LessonSession& session) {
  auto display = SecondDisplay::open(audience, "polhode — speaker");
  if (!display) return failure(display.error());
  auto screen = ScreenOfSpeaker::create(audience.screen());
  if (!screen) return failure(screen.error());
  return std::unique_ptr<SpeakerWindow>(
      new SpeakerWindow(audience, session, std::move(display).value(), std::move(screen).value()));
}

SpeakerWindow::SpeakerWindow(Display& audience, LessonSession& session,
                             std::unique_ptr<SecondDisplay> display, std::unique_ptr<ScreenOfSpeaker> screen)
    : session_(session),
      display_(std::move(display)),
      screen_(std::move(screen)),
      control_input_(display_->window(), [this, &audience](std::string_view key, bool is_repeated) {
        const bool is_done = audience.screen().press_from_afar(session_, key, is_repeated);
        ImGui::SetCurrentContext(screen_->imgui());
        return is_done;
      }) {
  ImGui::SetCurrentContext(screen_->imgui());
  input_.imgui = screen_->imgui();
  listen(display_->window(), input_);
  ImGui_ImplGlfw_InitForOther(display_->window(), false);
}

SpeakerWindow::~SpeakerWindow() {
  ImGui::SetCurrentContext(screen_->imgui());
  ImGui_ImplGlfw_Shutdown();
}

bool SpeakerWindow::is_closed() const { return glfwWindowShouldClose(display_->window()) == GLFW_TRUE; }

double SpeakerWindow::wakes_at_s() const {
  return is_behind_ || input_.settling > 0 ? drawn_s_ : drawn_s_ + screen_->seconds_to_wake();
}

Result<bool> SpeakerWindow::draw(double now_s) {
  ImGui::SetCurrentContext(screen_->imgui());
  ImGui_ImplGlfw_NewFrame();
  const bool is_used = input_.settling > 0;
  control_input_.feed(input_.waiting);
  ScreenFrame frame = frame_of_window(display_->window());
  frame.seconds = drawn_s_ > 0 ? now_s - drawn_s_ : 0;
  drawn_s_ = now_s;
  is_behind_ = false;
  if (const Status drawn = screen_->draw(session_, frame); !drawn) return failure(drawn.error());
  display_->present(screen_->picture());
  input_.settling = input_.waiting.empty() ? std::max(0, input_.settling - 1) : kSettlingFrames;
  return is_used;
}

}  // namespace polhode
