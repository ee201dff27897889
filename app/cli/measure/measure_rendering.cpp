// SPDX-License-Identifier: MIT
#include "app/cli/measure/measure_rendering.h"

#include "app/cli/or_fail.h"
#include "app/cli/progress.h"
#include "app/export/plot_file.h"
#include "app/page/figure_place.h"
#include "base/files/atomic_file.h"
#include "base/numbers.h"
#include "render/figure/make_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace polhode {

namespace {

constexpr int kFrames = 3;                  // the median counts; the first one, which makes buffers, does not
constexpr Quality kReference{0, 4, false};  // 16 samples a pixel of everything, no edge by formula
constexpr double kReferenceChords = 0.1;    // of the usual tolerance
constexpr double kCoarse = 10.0;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Frame {
  Image image;
  double ms = 0, cpu_ms = 0;
};

class FrameMeter {
 public:
  explicit FrameMeter(const RenderingRequest& request)
      : request_(request),
        context_(or_fail(open_context(ContextKind::any))),
        fonts_(or_fail(Fonts::open())),
        renderer_(or_fail(Renderer::create(*context_, fonts_))) {}

  int most_samples() const { return renderer_->most_samples(); }

  Image reference() const { return draw(figure(kReferenceChords * kChordTolerance), kReference); }

  Frame measure(const RenderingSetting& setting) const {
    const Figure shown = figure(setting.chord_tolerance);
    Frame frame{draw(shown, setting.quality), 0, 0};
    std::vector<double> ms, cpu_ms;
    for (int i = 0; i < kFrames; ++i) {
      const auto start = std::chrono::steady_clock::now();
      const std::clock_t cpu_start = std::clock();
      frame.image = draw(shown, setting.quality);
      cpu_ms.push_back(1e3 * static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC);
      ms.push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    frame.ms = median(ms);
    frame.cpu_ms = median(cpu_ms);
    return frame;
  }

 private:
  /// Without the names of things: they are drawn alike at every quality, but where they stand depends on the
  /// points of the curves.
  Figure figure(double chord_tolerance) const {
    const double aspect = static_cast<double>(request_.size.width) / request_.size.height;
    Figure made = make_figure(make_model(request_.scene, ModelFor::figure, {}, chord_tolerance),
                              request_.scene.at_s, aspect);
    for (Pane& pane : made.panes) pane.list.labels.clear();
    return made;
  }
  Image draw(const Figure& figure, const Quality& quality) const {
    return or_fail(renderer_->draw(figure, request_.size, {}, quality));
  }

  const RenderingRequest& request_;
  std::unique_ptr<GlContext> context_;
  Fonts fonts_;
  std::unique_ptr<Renderer> renderer_;  // after the context it draws with
};

std::vector<RenderingRow> measured(const RenderingRequest& request) {
  const FrameMeter meter(request);
  const std::vector<RenderingSetting> settings = rendering_settings(meter.most_samples());
  const ProgressBar bar(static_cast<std::int64_t>(settings.size()) + 1);
  bar.show(0, "reference");
  const Image reference = meter.reference();
  std::vector<RenderingRow> rows;
  for (const RenderingSetting& setting : settings) {
    bar.show(static_cast<std::int64_t>(rows.size()) + 1, setting.name);
    const Frame frame = meter.measure(setting);
    const PixelErrors errors = pixel_errors(frame.image, reference);
    rows.push_back({setting, frame.ms, frame.cpu_ms, errors.rms, errors.max});
  }
  return rows;
}

bool on_front(std::span<const RenderingRow> rows, const RenderingRow& row) {
  return std::none_of(rows.begin(), rows.end(), [&](const RenderingRow& other) {
    return other.cpu_ms_per_frame <= row.cpu_ms_per_frame && other.rms <= row.rms &&
           (other.cpu_ms_per_frame < row.cpu_ms_per_frame || other.rms < row.rms);
  });
}

std::string table_text(const std::vector<RenderingRow>& rows, const std::optional<std::size_t>& recommended) {
  std::string text =
      fmt::format("  {:<16} {:<48} {:>7} {:>7} {:>7} {:>4}\n", "setting", "", "CPU ms", "ms", "rms", "max");
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += fmt::format("{} {:<16} {:<48} {:>7.1f} {:>7.1f} {:>7.3f} {:>4}\n",
                        i == recommended          ? '>'
                        : on_front(rows, rows[i]) ? '*'
                                                  : ' ',
                        rows[i].setting.name, rows[i].setting.words, rows[i].cpu_ms_per_frame,
                        rows[i].ms_per_frame, rows[i].rms, rows[i].max);
  return text;
}

std::string advice_text(const RenderingRequest& request, const std::vector<RenderingRow>& rows,
                        const std::optional<std::size_t>& recommended) {
  if (!request.tolerance) return "";
  if (!recommended) return fmt::format("No setting comes within {:g} levels rms.\n", *request.tolerance);
  return fmt::format("The cheapest within {:g} levels rms is {}: {:.1f} CPU ms a frame.\n",
                     *request.tolerance, rows[*recommended].setting.name,
                     rows[*recommended].cpu_ms_per_frame);
}

std::string json_row(const RenderingRow& row) {
  return fmt::format(
      "{{\"setting\":\"{}\",\"samples\":{},\"supersampling\":{},\"chord_tolerance\":{},\"ms_per_frame\":{},"
      "\"cpu_ms_per_frame\":{},\"rms\":{},\"max\":{}}}",
      row.setting.name, row.setting.quality.samples, row.setting.quality.supersampling,
      digits17(row.setting.chord_tolerance), digits17(row.ms_per_frame), digits17(row.cpu_ms_per_frame),
      digits17(row.rms), row.max);
}

std::string json_text(const std::vector<RenderingRow>& rows, const std::optional<std::size_t>& recommended) {
  std::string text = "{\"rows\":[";
  for (std::size_t i = 0; i < rows.size(); ++i) text += (i == 0 ? "\n" : ",\n") + json_row(rows[i]);
  return text + "\n],\n\"recommended\":" + (recommended ? json_row(rows[*recommended]) : "null") + "}\n";
}

std::string csv_text(const std::vector<RenderingRow>& rows) {
  std::string text = "setting,samples,supersampling,chord_tolerance,ms_per_frame,cpu_ms_per_frame,rms,max\n";
  for (const RenderingRow& row : rows)
    text +=
        fmt::format("{},{},{},{},{},{},{},{}\n", row.setting.name, row.setting.quality.samples,
                    row.setting.quality.supersampling, digits17(row.setting.chord_tolerance),
                    digits17(row.ms_per_frame), digits17(row.cpu_ms_per_frame), digits17(row.rms), row.max);
  return text;
}

PlotLook look_of(const RenderingSetting& setting) {
  if (setting.chord_tolerance != kChordTolerance) return PlotLook::purple;
  return setting.quality.soft_lines ? PlotLook::blue : PlotLook::orange;
}

WorkPrecisionPlot plot_of(const RenderingRequest& request, const std::vector<RenderingRow>& rows,
                          const std::optional<std::size_t>& recommended) {
  WorkPrecisionPlot plot;
  plot.title = "Rendering: time and quality of a frame";
  plot.note = fmt::format("{}, {} × {} px; error against 4 × 4 times as many pixels, averaged", request.of,
                          request.size.width, request.size.height);
  plot.x_label = "CPU time of a frame, ms";
  plot.y_label = "error rms, levels of 8 bits";
  for (const RenderingRow& row : rows)
    plot.series.push_back({.label = row.setting.words,
                           .points = {{row.cpu_ms_per_frame, row.rms}},
                           .emphasized = on_front(rows, row),
                           .look = look_of(row.setting)});
  plot.tolerance = request.tolerance;
  if (recommended) {
    plot.recommended = {rows[*recommended].cpu_ms_per_frame, rows[*recommended].rms};
    plot.recommended_label = "cheapest within the tolerance";
  }
  return plot;
}

}  // namespace

std::vector<RenderingSetting> rendering_settings(int most_samples) {
  std::vector<RenderingSetting> settings;
  const auto add = [&](std::string name, std::string words, const Quality& quality,
                       double chord_tolerance = kChordTolerance) {
    if (quality.samples <= most_samples)
      settings.push_back({std::move(name), std::move(words), quality, chord_tolerance});
  };
  add("draft", "draft: meshes with one sample a pixel", quality_of(QualityLevel::draft));
  add("normal", "normal", quality_of(QualityLevel::normal));
  add("fine", "fine: 2 × 2 times the pixels", quality_of(QualityLevel::fine));
  add(fmt::format("normal-chords-{:g}", kCoarse), fmt::format("normal, curves {:g} times coarser", kCoarse),
      quality_of(QualityLevel::normal), kCoarse * kChordTolerance);
  // The common way, all by samples, to compare with. llvmpipe has 4; other drivers have 8.
  for (const int n : {1, 2, 3})
    for (const int samples : {0, 4, 8}) {
      if (n > 1 && samples > 4) continue;
      std::string name = n > 1 || samples == 0 ? fmt::format("{}x{}", n, n) : "";
      std::string words = n > 1 ? fmt::format("{} × {} times the pixels", n, n) : "one sample a pixel";
      if (samples > 0) {
        name += fmt::format("{}msaa{}", name.empty() ? "" : "-", samples);
        words = n > 1 ? fmt::format("{}, {} samples each", words, samples)
                      : fmt::format("{} samples a pixel", samples);
      }
      add(std::move(name), std::move(words), {samples, n, false});
    }
  return settings;
}

PixelErrors pixel_errors(const Image& image, const Image& reference) {
  double sum = 0.0;
  PixelErrors errors;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const int d = std::abs(image.rgba[i] - reference.rgba[i]);
    errors.max = std::max(errors.max, d);
    sum += d * d;
  }
  errors.rms = std::sqrt(sum / (0.75 * static_cast<double>(image.rgba.size())));
  return errors;
}

std::optional<std::size_t> cheapest_within(std::span<const RenderingRow> rows, double tolerance) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].rms <= tolerance && (!best || rows[i].cpu_ms_per_frame < rows[*best].cpu_ms_per_frame))
      best = i;
  return best;
}

Scene usual_rendering_scene() {
  using O = Overlay;
  Scene scene;
  scene.w0_B = Vec3(0.2, 1.1, 1.6);
  scene.show = {O::energy_ellipsoid, O::omega,      O::L,     O::polhode, O::polhode_family,
                O::separatrix,       O::herpolhode, O::plane, O::labels,  O::values};
  scene.at_s = 1.1;
  return scene;
}

ExitCode measure_rendering(const RenderingRequest& request) {
  const std::vector<RenderingRow> rows = measured(request);
  std::optional<std::size_t> recommended;
  if (request.tolerance) recommended = cheapest_within(rows, *request.tolerance);
  if (request.json)
    fmt::print("{}", json_text(rows, recommended));
  else
    fmt::print(
        "{}* on the Pareto front; rms and max in levels of 8 bits as displayed, against 16 samples a "
        "pixel\n{}",
        table_text(rows, recommended), advice_text(request, rows, recommended));
  if (!request.csv.empty()) or_fail(write_file_atomically(request.csv, bytes_of(csv_text(rows))));
  if (!request.plot.empty()) or_fail(write_plot(request.plot, plot_of(request, rows, recommended)));
  return ExitCode::done;
}

}  // namespace polhode
