// SPDX-License-Identifier: MIT
#include "render/drawing/plots/meter_plots.h"

#include "base/angles.h"
#include "base/words/figure_words.h"
#include "physics/body/euler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

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

TimePlot omega_plot(const Samples& samples, Language language) {
  TimePlot plot{
      .title = std::string(words::kAngularVelocityInTheBody.in(language)), .unit = "rad/s", .t = samples.t_s};
  constexpr const char* kLabels[] = {"$\\omega_1$", "$\\omega_2$", "$\\omega_3$"};
  constexpr double kDashOf[] = {kDots, kDashes, kSolid};
  for (int i = 0; i < 3; ++i)
    plot.series.push_back({kLabels[i], kBodyAxisRoles[static_cast<std::size_t>(i)],
                           values_of(samples, [i](const RigidBodyState& s) { return s.w_B[i]; }),
                           kDashOf[i]});
  return plot;
}

TimePlot energy_plot(const PrincipalMoments& I, const Samples& samples, Language language) {
  TimePlot plot{.title = std::string(words::kKineticEnergy.in(language)), .unit = "J", .t = samples.t_s};
  const auto energy = [&](const RigidBodyState& s) { return kinetic_energy(I, s.w_B); };
  plot.series.push_back({"$T$", kTRole, values_of(samples, energy), kSolid});
  return plot;
}

TimePlot momentum_plot(const PrincipalMoments& I, const Samples& samples, bool with_components,
                       Language language) {
  TimePlot plot{
      .title = std::string(words::kAngularMomentum.in(language)), .unit = "kg m²/s", .t = samples.t_s};
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
  const Language language = model.scene.language;
  TimePlot plot{.title = std::string(words::kDrift.in(language)),
                .unit = std::string(words::kRelativeAngleInRad.in(language)),
                .t = samples.t_s};
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

// Plots of the lesson's own.

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// In the units of an axis.
double value_of(const SceneQuantity& quantity, const PlotUnit& unit, const SceneModel& model, double t_s,
                const RigidBodyState& state) {
  const auto value = quantity.value(model, t_s, state);
  return value ? value->x() * unit.per_si : kNone;
}

std::vector<double> values_of(const SceneQuantity& quantity, const PlotUnit& unit, const SceneModel& model,
                              const Samples& samples) {
  std::vector<double> values;
  values.reserve(samples.t_s.size());
  for (std::size_t i = 0; i < samples.t_s.size(); ++i)
    values.push_back(value_of(quantity, unit, model, samples.t_s[i], samples.states[i]));
  return values;
}

/// Angles of −π to π, such as atan2 gives, go on where they come round: a curve of φ over several turns is
/// not torn. Between neighbours nothing that is sampled at all turns by three quarters.
void join_turns(std::vector<double>& angles, double turn) {
  double turns = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double step = angles[i] + turns - angles[i - 1];
    if (std::abs(step) > 0.75 * turn) turns -= std::copysign(turn, step);
    angles[i] += turns;
  }
}

bool is_unit_of_angles(std::string_view unit) {
  return unit == "rad" || unit == "deg" || unit == "°" || unit == "mrad";
}

/// The role of the body axis that a name is of: of `T_2`, `\omega_2^2` or "row 2", but not of the sum 2T.
/// Empty where it is of none, or of several.
std::string axis_role_of(const std::string& name) {
  char axis = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool is_index =
        name[i] == '_' || (name[i] == ' ' && i + 2 == name.size() - 1 && name.back() == '}');
    if (!is_index || i + 1 == name.size()) continue;
    const std::size_t at = name[i + 1] == '{' ? i + 2 : i + 1;
    const bool is_one = at < name.size() && name[at] >= '1' && name[at] <= '3' &&
                        (at == i + 1 || (at + 1 < name.size() && name[at + 1] == '}'));
    if (!is_one || (axis != 0 && axis != name[at])) return {};
    axis = name[at];
  }
  return axis == 0 ? std::string() : std::string("axis-") + axis;
}

/// Gives it a logarithmic axis, which begins at its range or at the least that is drawn; what is not above 0
/// leaves a gap.
void make_logarithmic(TimePlot& plot) {
  constexpr double kMostDecades = 1e-16;
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (TimeSeries& series : plot.series)
    for (double& value : series.y) {
      if (!(value > 0.0)) value = kNone;
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  plot.log_floor = plot.range       ? plot.range->first
                   : largest == 0.0 ? 1.0
                                    : std::max(least, kMostDecades * largest);
}

/// Those with a colour keep it; others have what is left, the ink of text first. Each has its own dashes
/// besides, for print and for those who see no colours.
void give_looks(std::vector<TimeSeries>& series, const std::vector<std::string>& roles) {
  constexpr std::array kSpare = {"", "polhode", "N", "herpolhode", "L", "omega"};
  constexpr std::array kDashOf = {kSolid, kDashes, kDots, 2.0 * kDashes, 4.0 * kDashes, 1.5 * kDots};
  std::size_t next = 0;
  const auto is_taken = [&](const char* role) {
    return std::find(roles.begin(), roles.end(), role) != roles.end() && *role != '\0';
  };
  for (std::size_t i = 0; i < series.size(); ++i) {
    std::string role = roles[i];
    if (role.empty()) {
      while (next < kSpare.size() && is_taken(kSpare[next])) ++next;
      role = next < kSpare.size() ? kSpare[next++] : "";
    }
    series[i].role = role_from(role).value_or(kTRole);
    series[i].dash = kDashOf[i % kDashOf.size()];
  }
}

/// Of the ith curve.
std::string label_of(const OwnPlot& own, std::size_t i, const std::string& tex) {
  return '$' + (i < own.tex.size() ? own.tex[i] : tex) + '$';
}

TimePlot plot_of_quantities(const OwnPlot& own, const SceneModel& model, const Samples& samples, double t_s) {
  TimePlot plot{.title = own.title, .unit = own.y.unit, .t = samples.t_s, .now = t_s};
  plot.is_tight = own.is_tight;
  plot.range = own.range;
  std::vector<std::string> roles;
  for (std::size_t i = 0; i < own.curves.size(); ++i) {
    plot.series.push_back(
        {.label = label_of(own, i, own.curves[i].tex), .y = values_of(own.curves[i], own.y, model, samples)});
    std::string role = own.curves[i].role;
    if (role.empty()) role = axis_role_of(i < own.tex.size() ? own.tex[i] : own.curves[i].tex);
    roles.push_back(std::move(role));
  }
  // Who says a range, −180 to 180, wants to see them come round.
  if (is_unit_of_angles(own.y.unit) && !own.range && !own.against)
    for (TimeSeries& series : plot.series) join_turns(series.y, 2 * std::numbers::pi * own.y.per_si);
  if (own.is_log) make_logarithmic(plot);
  give_looks(plot.series, roles);
  if (!own.against) return plot;

  const RigidBodyState now = model.motion->at(t_s);
  plot.is_path = true;
  plot.is_scaled_alike = own.is_scaled_alike;
  plot.t = values_of(*own.against, own.x, model, samples);
  plot.x_label = '$' + own.against->tex + '$';
  plot.x_unit = own.x.unit;
  plot.now = value_of(*own.against, own.x, model, t_s, now);
  for (const SceneQuantity& curve : own.curves) plot.y_now.push_back(value_of(curve, own.y, model, t_s, now));
  for (TimeSeries& series : plot.series)
    if (own.curves.size() == 1) series.dash = kSolid;
  if (plot.title.empty()) {
    for (const TimeSeries& series : plot.series)
      plot.title += (plot.title.empty() ? "" : ", ") + series.label;
    plot.title = words::kAgainst.with(model.scene.language, {plot.title, plot.x_label});
  }
  return plot;
}

constexpr int kFunctionPoints = 300;

/// What is worth seeing of a function, which may have poles: the range around its level if it has one, else
/// that of most of its values. Nothing where it has no values.
std::optional<std::pair<double, double>> range_of(std::vector<double> y, double level) {
  std::erase_if(y, [](double value) { return !std::isfinite(value); });
  if (y.empty()) return std::nullopt;
  std::sort(y.begin(), y.end());
  const auto part = [&](double p) {
    return y[static_cast<std::size_t>(p * static_cast<double>(y.size() - 1))];
  };
  const double middle = part(0.5);
  if (std::isfinite(level) && level >= y.front()) {
    // As much above the level as it is high above the bottom; where it lies at the bottom, some of the curve.
    const double height = std::max(level - y.front(), 0.1 * (middle - y.front()));
    return std::pair(y.front() - 0.2 * height,
                     std::min(std::max(y.back(), level), level + height) + 0.1 * height);
  }
  const double low = std::max(y.front(), middle - 2.0 * (part(0.9) - middle)),
               high = std::min(y.back(), middle + 2.0 * (middle - part(0.1)));
  const double beside = 0.05 * (high - low);
  return std::pair(std::isfinite(level) ? std::min(low, level) - beside : low - beside, high + beside);
}

/// The line at the level goes on through all x.
TimePlot plot_of_function(const OwnPlot& own, const SceneModel& model, double t_s) {
  const PlotFunction& f = *own.function;
  const RigidBodyState start = model.motion->at(0.0), now = model.motion->at(t_s);
  std::vector<double> x;
  for (int i = 0; i <= kFunctionPoints; ++i)
    x.push_back(std::lerp(f.from, f.to, static_cast<double>(i) / kFunctionPoints));
  TimePlot plot{.title = own.title, .unit = own.y.unit};
  std::vector<double> y = f.values(model, x);
  for (double& value : y) value *= own.y.per_si;
  for (double& value : x) value *= own.x.per_si;
  double level = kNone;
  plot.series.push_back({.label = label_of(own, 0, f.tex), .y = y});
  if (f.level) {
    level = value_of(*f.level, own.y, model, 0.0, start);
    plot.series.push_back({.label = '$' + f.level->tex + '$',
                           .y = std::vector<double>(x.size(), value_of(*f.level, own.y, model, t_s, now))});
  }
  give_looks(plot.series, {"", f.level ? f.level->role : ""});
  plot.t = std::move(x);
  plot.x_label = '$' + f.of.tex + '$';
  plot.x_unit = own.x.unit;
  plot.now = value_of(f.of, own.x, model, t_s, now);
  const bool is_whole = own.is_tight || own.is_log;
  plot.range = own.range ? own.range : is_whole ? std::nullopt : range_of(std::move(y), level);
  if (own.is_log) make_logarithmic(plot);
  plot.is_tight = true;
  return plot;
}

TimePlot own_plot(const OwnPlot& own, const SceneModel& model, const Samples& samples, double t_s) {
  return own.function ? plot_of_function(own, model, t_s) : plot_of_quantities(own, model, samples, t_s);
}

TimePlot plot_of(Meter meter, const SceneModel& model, const Samples& samples) {
  const PrincipalMoments& I = model.scene.body.moments;
  switch (meter) {
    case Meter::omega:
      return omega_plot(samples, model.scene.language);
    case Meter::energy:
      return energy_plot(I, samples, model.scene.language);
    case Meter::momentum:
      return momentum_plot(I, samples, !model.scene.torque.empty(), model.scene.language);
    case Meter::drift:
      break;
  }
  return drift_plot(model, samples);
}

}  // namespace

std::size_t meter_count(const SceneModel& model) {
  return model.needs.meters ? model.scene.meters.size() : 0;
}

std::vector<TimePlot> meter_plots(const SceneModel& model, double t_s) {
  if (!model.needs.meters) return {};
  const Samples samples = samples_of(model, t_s);
  std::vector<TimePlot> plots;
  for (const PlotSpec& spec : model.scene.meters) {
    if (const auto* own = std::get_if<OwnPlot>(&spec)) {
      plots.push_back(own_plot(*own, model, samples, t_s));
    } else {
      plots.push_back(plot_of(std::get<Meter>(spec), model, samples));
      plots.back().now = t_s;
    }
    TimePlot& made = plots.back();
    made.language = model.scene.language;
    made.title = with_decimals_in_formulas(std::move(made.title), made.language);
    for (TimeSeries& series : made.series)
      series.label = with_decimals_in_formulas(std::move(series.label), made.language);
  }
  return plots;
}

}  // namespace polhode
