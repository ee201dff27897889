// SPDX-License-Identifier: MIT
#include "render/drawing/plots/meter_plots.h"

#include "physics/body/euler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

constexpr int kSamplesPerTurn = 64;
constexpr double kFewestSamples = 240, kMostSamples = 2000;
constexpr int kDriftPoints = 32;  // rounding errors scatter: the largest of each stretch, or it were a blot
constexpr double kDots = 0.26, kDashes = 0.6, kSolid = 0.0;

/// The samples of one motion over the window of the plots.
struct Samples {
  std::vector<double> t_s;
  std::vector<RigidBodyState> states;  ///< without attitude if that is not required
};

struct Window {
  double begin_s, end_s;
};

/// The multiple of the span that holds t; where two meet, the one nearer to the start.
Window window_of(const SceneModel& model, double t_s) {
  const double n = t_s > 0.0 ? std::ceil(t_s / model.span_s) - 1.0 : std::floor(t_s / model.span_s);
  Window window{n * model.span_s, (n + 1.0) * model.span_s};
  const bool holds_t = window.begin_s <= t_s && t_s <= window.end_s && window.begin_s < window.end_s;
  if (!holds_t) window = {std::min(0.0, t_s), std::max(model.span_s, t_s)};  // too far for double
  return {std::max(window.begin_s, -model.reach_s), std::min(window.end_s, model.reach_s)};
}

int sample_count(const SceneModel& model, const Window& window) {
  const double turns =
      (window.end_s - window.begin_s) * model.scene.w0_B.stableNorm() / (2.0 * std::numbers::pi);
  const double wanted = kSamplesPerTurn * turns;
  return static_cast<int>(wanted > kFewestSamples ? std::min(wanted, kMostSamples) : kFewestSamples);
}

Samples samples_of(const SceneModel& model, double t_s) {
  const Window window = window_of(model, t_s);
  const int count = sample_count(model, window);
  Samples samples;
  for (int i = 0; i <= count; ++i)
    samples.t_s.push_back(std::lerp(window.begin_s, window.end_s, static_cast<double>(i) / count));
  samples.states.resize(samples.t_s.size());
  if (model.needs.attitude)
    model.motion->at(samples.t_s, samples.states);
  else
    for (std::size_t i = 0; i < samples.t_s.size(); ++i)
      samples.states[i].w_B = model.motion->w_B_at(samples.t_s[i]);
  return samples;
}

/// One number of each state.
template <class Quantity>
std::vector<double> values_of(const Samples& samples, const Quantity& quantity) {
  std::vector<double> values;
  values.reserve(samples.states.size());
  for (const RigidBodyState& state : samples.states) values.push_back(quantity(state));
  return values;
}

TimePlot omega_plot(const Samples& samples) {
  TimePlot plot{.title = "Angular velocity in the body", .unit = "rad/s", .t = samples.t_s};
  constexpr const char* kLabels[] = {"$\\omega_1$", "$\\omega_2$", "$\\omega_3$"};
  constexpr double kDashOf[] = {kDots, kDashes, kSolid};
  for (int i = 0; i < 3; ++i)
    plot.series.push_back({kLabels[i], kOmegaRole,
                           values_of(samples, [i](const RigidBodyState& s) { return s.w_B[i]; }),
                           kDashOf[i]});
  return plot;
}

TimePlot energy_plot(const PrincipalMoments& I, const Samples& samples) {
  TimePlot plot{.title = "Kinetic energy", .unit = "J", .t = samples.t_s};
  const auto energy = [&](const RigidBodyState& s) { return kinetic_energy(I, s.w_B); };
  plot.series.push_back({"$T$", kTRole, values_of(samples, energy), kSolid});
  return plot;
}

TimePlot momentum_plot(const PrincipalMoments& I, const Samples& samples, bool with_components) {
  TimePlot plot{.title = "Angular momentum", .unit = "kg m²/s", .t = samples.t_s};
  const auto size = [&](const RigidBodyState& s) { return angular_momentum_B(I, s.w_B).stableNorm(); };
  plot.series.push_back({"$|\\vec L|$", kLRole, values_of(samples, size), kSolid});
  if (!with_components) return plot;
  constexpr const char* kLabels[] = {"$L_x$", "$L_y$", "$L_z$"};
  constexpr double kDashOf[] = {kDots, kDashes, 2.0 * kDashes};
  for (int i = 0; i < 3; ++i)
    plot.series.push_back(
        {kLabels[i], kLRole,
         values_of(samples, [&, i](const RigidBodyState& s) { return angular_momentum_S(I, s)[i]; }),
         kDashOf[i]});
  return plot;
}

/// |value/start − 1|; 0 if nothing changed, whatever the start is.
double relative_change(double value, double start) {
  return value == start ? 0.0 : std::abs((value - start) / start);
}

/// What is compared with its start, for a body and a start of size 1: no square overflows.
struct Conserved {
  double T, L;
  Vec3 L_S;
};

Conserved conserved(const PrincipalMoments& I, const RigidBodyState& state, double w_size) {
  const Vec3 moments = I.vector() / I.vector().maxCoeff(), w_B = state.w_B / w_size;
  const Vec3 L_B = moments.cwiseProduct(w_B);
  return {0.5 * w_B.dot(L_B), L_B.norm(), state.q_SB * L_B};
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// The largest of each group of neighbours, so that no drift is larger than what is drawn. The groups are
/// alike: a last one of few samples would fall off.
TimePlot thinned(const TimePlot& plot, std::size_t most) {
  const std::size_t groups = std::min(most, plot.t.size());
  TimePlot thin = plot;
  thin.t.clear();
  for (TimeSeries& series : thin.series) series.y.clear();
  for (std::size_t i = 0; i < groups; ++i) {
    const std::size_t begin = i * plot.t.size() / groups, end = (i + 1) * plot.t.size() / groups;
    thin.t.push_back(begin == 0 ? plot.t.front() : plot.t[end - 1]);
    for (std::size_t k = 0; k < thin.series.size(); ++k) {
      const auto y = plot.series[k].y.begin();
      // NaN, the motion's answer beyond its reach, is to stay a gap: it is larger than all.
      const auto less = [](double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); };
      thin.series[k].y.push_back(*std::max_element(y + static_cast<std::ptrdiff_t>(begin),
                                                   y + static_cast<std::ptrdiff_t>(end), less));
    }
  }
  return thin;
}

TimePlot drift_plot(const SceneModel& model, const Samples& samples) {
  const PrincipalMoments& I = model.scene.body.moments;
  const double w_size =
      model.scene.w0_B.cwiseAbs().maxCoeff() > 0.0 ? model.scene.w0_B.cwiseAbs().maxCoeff() : 1.0;
  const Conserved start = conserved(I, {model.q0_SB, model.scene.w0_B}, w_size);
  TimePlot plot{.title = "Drift from the start", .unit = "relative; $\\angle$ in rad", .t = samples.t_s};
  plot.log_floor = kDriftFloor;
  std::vector<double> T, L, angle;
  for (const RigidBodyState& state : samples.states) {
    const Conserved now = conserved(I, state, w_size);
    T.push_back(relative_change(now.T, start.T));
    L.push_back(relative_change(now.L, start.L));
    angle.push_back(angle_between(now.L_S, start.L_S));
  }
  plot.series.push_back({"$T$", kTRole, std::move(T), kSolid});
  plot.series.push_back({"$|\\vec L|$", kLRole, std::move(L), kSolid});
  plot.series.push_back({"$\\angle\\vec L$", kLRole, std::move(angle), kDashes});
  return thinned(plot, kDriftPoints);
}

TimePlot own_plot(const OwnPlot& own, const SceneModel& model, const Samples& samples) {
  TimePlot plot{.title = "", .unit = own.curves.front().unit, .t = samples.t_s};
  for (const SceneQuantity& quantity : own.curves) {
    TimeSeries series{'$' + quantity.tex + '$', role_from(quantity.role).value_or(kTRole)};
    for (std::size_t i = 0; i < samples.t_s.size(); ++i) {
      const auto value = quantity.value(model, samples.t_s[i], samples.states[i]);
      series.y.push_back(value ? value->x() : std::numeric_limits<double>::quiet_NaN());
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

TimePlot plot_of(Meter meter, const SceneModel& model, const Samples& samples) {
  const PrincipalMoments& I = model.scene.body.moments;
  switch (meter) {
    case Meter::omega:
      return omega_plot(samples);
    case Meter::energy:
      return energy_plot(I, samples);
    case Meter::momentum:
      return momentum_plot(I, samples, !model.scene.torque.empty());
    case Meter::drift:
      break;
  }
  return drift_plot(model, samples);
}

}  // namespace

std::size_t meter_count(const SceneModel& model) {
  return model.needs.meters ? shown_meters(model.scene).size() : 0;
}

std::vector<TimePlot> meter_plots(const SceneModel& model, double t_s) {
  if (!model.needs.meters) return {};
  const Samples samples = samples_of(model, t_s);
  std::vector<TimePlot> plots;
  for (const PlotSpec& spec : shown_meters(model.scene)) {
    const auto* own = std::get_if<OwnPlot>(&spec);
    plots.push_back(own ? own_plot(*own, model, samples) : plot_of(std::get<Meter>(spec), model, samples));
    plots.back().now = t_s;
  }
  return plots;
}

}  // namespace polhode
