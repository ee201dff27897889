// SPDX-License-Identifier: MIT
// The trade between speed and quality of pictures, measured: what a frame of a scene costs at each quality of
// the renderer, and drawn the common way by samples, and how far it is from the same frame drawn 4 x 4 times
// finer and averaged. The frame is without the names of things.
//
// Errors are in levels of 8 bits as displayed (sRGB values, as the file has them), over the channels red,
// green, blue of all pixels. Cost: CPU time of all threads, and wall time, from the figure to the image in
// memory; medians.
#pragma once

#include "app/cli/exit_codes.h"
#include "render/gl/renderer.h"
#include "render/scene/model/model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace polhode {

struct RenderingSetting {
  std::string name;   ///< "normal", "msaa4", "2x2-msaa4", "normal-chords-10": a tag without spaces
  std::string words;  ///< for a person
  Quality quality;
  double chord_tolerance = kChordTolerance;  ///< of curves, make_model
};

struct RenderingRow {
  RenderingSetting setting;
  double ms_per_frame = 0;      ///< wall time
  double cpu_ms_per_frame = 0;  ///< of all threads
  double rms = 0;               ///< levels
  int max = 0;                  ///< levels
};

/// What is measured on a driver with so many samples at most, the renderer's usual setting among them.
std::vector<RenderingSetting> rendering_settings(int most_samples);

/// Root of the mean squared difference and the largest one, of red, green and blue; sizes are equal.
struct PixelErrors {
  double rms = 0;
  int max = 0;
};
PixelErrors pixel_errors(const Image& image, const Image& reference);

/// The row with rms <= tolerance that costs the least CPU time.
std::optional<std::size_t> cheapest_within(std::span<const RenderingRow> rows, double tolerance);

struct RenderingRequest {
  Scene scene{};
  std::string of = "Poinsot’s construction";  ///< what scene that is: "stage ellipsoid of euler-equations"
  Size size{1920, 1080};
  std::optional<double> tolerance{};  ///< rms, levels; asks for a recommendation
  std::string csv{}, plot{};          ///< files to write; empty: none
  bool json = false;                  ///< instead of the table
};

/// Poinsot's construction with labels, for those who name no scene.
Scene usual_rendering_scene();

/// `polhode measure --rendering`. @throws CommandError
ExitCode measure_rendering(const RenderingRequest& request);

}  // namespace polhode
