// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/varied_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

/// A scene while its numbers are changed. Moments are set one by one, and are those of a body when all are.
struct Changing {
  LessonScene scene;
  Vec3 moments;
};

/// A number's place in a scene.
struct Row {
  VariedNumber facts;
  /// Why the scene has no such number; nothing to be said: it has.
  SceneFault (*why_none)(const LessonScene&, const LessonBodies&);
  double (*get)(const LessonScene&);
  void (*set)(Changing&, double);
};

SceneFault omega_is_free(const LessonScene& scene, const LessonBodies&) {
  if (!scene.start) return {};
  return {"omega follows from the \"start\" of this scene", "vary its spin, theta_deg or precession"};
}

SceneFault moments_are_given(const LessonScene& scene, const LessonBodies& bodies) {
  const Body& body = scene.scene.body;
  if (!body.shape || bodies.drawn.contains(body.name)) return {};
  return {"the moments of " + in_quotes(body.name) + " follow from its shape", "give a body by its moments"};
}

/// Two that stay the same: of a symmetric body those about the axes across that of its symmetry.
template <int i, int k>
SceneFault moments_are_equal(const LessonScene& scene, const LessonBodies& bodies) {
  const PrincipalMoments& I = scene.scene.body.moments;
  if (I[i] == I[k]) return moments_are_given(scene, bodies);
  return {fmt::format("I{} is {:.7g} in this scene, and I{} is {:.7g}", i + 1, I[i], k + 1, I[k]),
          fmt::format("vary I{} alone, or give a body with both the same", i + 1)};
}

SceneFault has_start(const LessonScene& scene, const LessonBodies&) {
  if (scene.start) return {};
  return {"this scene has no \"start\", of which this is a number", "vary omega1, omega2 or omega3"};
}

SceneFault has_precession(const LessonScene& scene, const LessonBodies& bodies) {
  if (!scene.start || std::holds_alternative<double>(scene.start->precession))
    return has_start(scene, bodies);
  return {"the precession of this scene is steady, and follows from its spin", "vary spin or theta_deg"};
}

template <int k>
double omega(const LessonScene& scene) {
  return scene.scene.w0_B[k];
}
template <int k>
void set_omega(Changing& changing, double value) {
  changing.scene.scene.w0_B[k] = value;
}

template <int k>
double moment(const LessonScene& scene) {
  return scene.scene.body.moments.vector()[k];
}
template <int... axes>
void set_moments(Changing& changing, double value) {
  ((changing.moments[axes] = value), ...);
}
/// @throws std::domain_error if no body has these moments
void take_moments(Body& body, const Vec3& I) {
  if (I == body.moments.vector()) return;
  body.moments = PrincipalMoments(I[0], I[1], I[2]);
  if (body.shape) body.shape = equivalent_box(body.moments, body.mass_kg);
}

/// @throws std::domain_error beyond the half turn that it can be
void set_tilt(Changing& changing, double theta_deg) {
  if (theta_deg < 0 || theta_deg > 180) throw std::domain_error("theta_deg lies between 0 and 180");
  changing.scene.start->theta_deg = theta_deg;
}

template <double TopStart::*angle>
double angle_of(const LessonScene& scene) {
  return (*scene.start).*angle;
}
template <double TopStart::*angle>
void set_angle(Changing& changing, double value) {
  (*changing.scene.start).*angle = value;
}

const std::array kRows = std::to_array<Row>({
    {{"omega1", R"(\omega_1)", "ω1", "rad/s"}, omega_is_free, omega<0>, set_omega<0>},
    {{"omega2", R"(\omega_2)", "ω2", "rad/s"}, omega_is_free, omega<1>, set_omega<1>},
    {{"omega3", R"(\omega_3)", "ω3", "rad/s"}, omega_is_free, omega<2>, set_omega<2>},
    {{"I1", "I_1", "I1", "kg m²"}, moments_are_given, moment<0>, set_moments<0>},
    {{"I2", "I_2", "I2", "kg m²"}, moments_are_given, moment<1>, set_moments<1>},
    {{"I3", "I_3", "I3", "kg m²"}, moments_are_given, moment<2>, set_moments<2>},
    {{"I12", "I_1 = I_2", "I1 = I2", "kg m²"}, moments_are_equal<0, 1>, moment<0>, set_moments<0, 1>},
    {{"I13", "I_1 = I_3", "I1 = I3", "kg m²"}, moments_are_equal<0, 2>, moment<0>, set_moments<0, 2>},
    {{"I23", "I_2 = I_3", "I2 = I3", "kg m²"}, moments_are_equal<1, 2>, moment<1>, set_moments<1, 2>},
    {{"theta_deg", R"(\theta)", "θ", "°"}, has_start, angle_of<&TopStart::theta_deg>, set_tilt},
    {{"phi_deg", R"(\varphi)", "φ", "°"},
     has_start,
     angle_of<&TopStart::phi_deg>,
     set_angle<&TopStart::phi_deg>},
    {{"psi_deg", R"(\psi)", "ψ", "°"},
     has_start,
     angle_of<&TopStart::psi_deg>,
     set_angle<&TopStart::psi_deg>},
    {{"spin", R"(\omega_3)", "ω3", "rad/s"},
     has_start,
     angle_of<&TopStart::spin>,
     set_angle<&TopStart::spin>},
    {{"precession", R"(\dot\varphi)", "rate of φ", "rad/s"},
     has_precession,
     [](const LessonScene& scene) { return std::get<double>(scene.start->precession); },
     [](Changing& changing, double value) { changing.scene.start->precession = value; }},
});

const Row* find_row(std::string_view name) {
  const auto row =
      std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.facts.name == name; });
  return row == kRows.end() ? nullptr : &*row;
}

/// "$\omega_3$ = −3 rad/s"
std::string label_of(const VariedNumber& number, double value) {
  const std::string_view minus = value < 0 ? "−" : "", blank = number.unit == "°" ? "" : " ";
  return fmt::format("${}$ = {}{:.4g}{}{}", number.tex, minus, std::abs(value), blank, number.unit);
}

}  // namespace

std::span<const VariedNumber> varied_numbers() {
  static const std::vector<VariedNumber> kNumbers = [] {
    std::vector<VariedNumber> numbers;
    for (const Row& row : kRows) numbers.push_back(row.facts);
    return numbers;
  }();
  return kNumbers;
}

const VariedNumber* find_varied_number(std::string_view name) {
  const Row* row = find_row(name);
  return row == nullptr ? nullptr : &row->facts;
}

bool is_of_start(std::string_view name) {
  const auto why_none = find_row(name)->why_none;
  return why_none == has_start || why_none == has_precession;
}

Result<double, SceneFault> number_of(const LessonScene& scene, const LessonBodies& bodies,
                                     std::string_view name) {
  const Row& row = *find_row(name);
  if (SceneFault fault = row.why_none(scene, bodies); !fault.message.empty())
    return Failure<SceneFault>{fault};
  return row.get(scene);
}

VariedScene::VariedScene(LessonScene scene, const LessonBodies& bodies)
    : written_(std::move(scene)), alone_(finished(written_, bodies)) {
  alone_.vary.clear();
  const std::string& name = written_.scene.body.name;
  if (const auto own = bodies.named.find(name); own != bodies.named.end()) own_.named.insert(*own);
  if (const auto pivot = bodies.pivots_m.find(name); pivot != bodies.pivots_m.end())
    own_.pivots_m.insert(*pivot);
  if (bodies.drawn.contains(name)) own_.drawn.insert(name);
}

Result<Scene> VariedScene::at(const std::vector<double>& values) const {
  Changing changing{written_, written_.scene.body.moments.vector()};
  LessonScene& scene = changing.scene;
  LessonBodies own = own_;
  try {
    for (std::size_t i = 0; i < values.size(); ++i)
      find_row(written_.scene.vary[i].number)->set(changing, values[i]);
    take_moments(scene.scene.body, changing.moments);
  } catch (const std::domain_error& error) {
    return failure(error.what());
  }
  // What is held at its pivot is looked up by its name.
  if (const auto body = own.named.find(scene.scene.body.name); body != own.named.end())
    body->second = scene.scene.body;
  auto made = finished_or_fault(scene, own);
  if (!made) return failure(made.error().message);
  made->vary.clear();
  return std::move(made).value();
}

Result<Scene> VariedScene::strip() const {
  const Variation& first = written_.scene.vary.front();
  const VariedNumber& number = *find_varied_number(first.number);
  Scene strip = alone_;
  strip.vary = written_.scene.vary;
  strip.label = label_of(number, first.value);
  std::vector<double> others{first.from, first.to};
  if (first.value == first.from || first.value == first.to)
    (first.value == first.from ? others.front() : others.back()) = 0.5 * (first.from + first.to);
  strip.before = first.value == first.from ? 0 : first.value == first.to ? 2 : 1;
  std::sort(others.begin(), others.end());
  for (const double value : others) {
    std::vector<double> values;
    for (const Variation& one : written_.scene.vary) values.push_back(one.value);
    values.front() = value;
    Result<Scene> other = at(values);
    if (!other)
      return failure(fmt::format("\"{}\" cannot be {:.7g}: {}", first.number, value, other.error()));
    other->meters.clear();
    other->label = label_of(number, value);
    strip.beside.push_back(std::move(other).value());
  }
  return strip;
}

}  // namespace polhode
