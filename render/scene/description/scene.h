// SPDX-License-Identifier: MIT
// A scene as an author states it: plain data, no motion computed, no graphics. model.h turns it into what is
// needed.
#pragma once

#include "base/words/language.h"
#include "physics/body/bodies.h"
#include "physics/body/torque.h"
#include "physics/method_facts.h"
#include "render/scene/description/mark.h"
#include "render/scene/description/meter.h"
#include "render/scene/description/overlay.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace polhode {

enum class View { space, body };  ///< seen from S, or from B (the body stands still)

/// L along −z of space (the invariable plane lies below), along +z, or the attitude given.
enum class LPoints { down, up };
using AttitudeSpec = std::variant<LPoints, Quat>;

/// Where the arrow A of the overlay `transport` is held fixed; free: it moves in both frames (arrow.h).
enum class ArrowHeld { in_space, in_body, free };

/// physics/method.h says what the methods are.
struct MotionSpec {
  std::optional<Method> method = {};     ///< absent: the default_method of body and torque
  std::optional<double> step_s = {};     ///< of fixed-step methods
  std::optional<double> tolerance = {};  ///< of adaptive methods; absent: kDefaultTolerance
  bool ghost = false;                    ///< asks for the exact body beside it
  bool operator==(const MotionSpec&) const = default;
};

/// Where a camera stood, and with which ω and attitude the scene began, when the picture was fitted to it. A
/// hand that then turns the camera, or takes ω, leaves the scale and what is in the middle as they were
/// fitted.
struct CameraFit {
  double azimuth_rad = 0, elevation_rad = 0;
  std::optional<Vec3> w0_B = {};              ///< absent: that of the scene
  std::optional<AttitudeSpec> attitude = {};  ///< likewise
  bool operator==(const CameraFit&) const = default;
};

/// Camera about the middle of what the scene shows over its film, which fills the picture at zoom 1. Angles
/// in radians (degrees exist in lessons only); elevation is measured from the horizontal plane of the view.
/// The distance, in radii of that, says how much larger what is near looks than what is far.
struct CameraSpec {
  double azimuth_rad = 0.6;
  double elevation_rad = 0.35;
  double distance = 4.2;
  double zoom = 1.0;
  std::optional<CameraFit> fitted = {};  ///< absent: the picture is filled as it is
  bool holds_still = false;              ///< what fills the picture is the still; the film may leave it
  bool operator==(const CameraSpec&) const = default;
};

/// What a lesson's camera keeps to: beyond it nothing is seen, and a number is most likely a slip. Of the
/// elevation, up and down; of distance and zoom.
inline constexpr double kMostElevationDeg = 90;
inline constexpr double kLeastCameraScale = 0.1, kMostCameraScale = 100;

/// How finely pictures of a scene are drawn, by name; the renderer says what that is.
enum class QualityLevel { draft, normal, fine };
/// draft | normal | fine.
const char* name_of(QualityLevel level);
std::vector<std::string> quality_level_names();
/// Nothing if unknown.
std::optional<QualityLevel> quality_level_from(std::string_view name);

/// At which t of the motion a caption is true.
enum class CaptionWhen { always, still };

/// What the diagrams that compare methods show.
struct ComparedMethods {
  std::vector<Method> methods{};  ///< these alone; empty: all that serve
  bool by_evaluations = false;    ///< the error against evaluations of the equations of motion, not steps
  bool operator==(const ComparedMethods&) const = default;
};

/// A number of a scene that may be changed within a range (lessons/reader/scene/varied_scene.h): a
/// slider in the window, a filmstrip on paper.
struct Variation {
  std::string number;       ///< as lessons name it: "omega3"
  double from = 0, to = 0;  ///< in the unit of that number; from < to
  double value = 0;         ///< in the scene as it is
  bool operator==(const Variation&) const = default;
};

/// So many scenes are shown side by side at most.
inline constexpr std::size_t kMaxScenes = 3;
inline constexpr std::size_t kMaxVariations = 2;

/// Of a lesson's scene; with others beside it, it is the one whose motion the page speaks of.
struct Scene {
  Body body{"textbook", PrincipalMoments(1.0, 1.75, 2.5), std::nullopt};
  Vec3 w0_B{0.2, 0.1, 3.0};              ///< rad/s at t = 0
  std::optional<AttitudeSpec> attitude;  ///< at t = 0; absent: L down if the plane is shown, else L up
  Torque torque;                         ///< empty: torque-free
  Vec3 v0_S{0, 0, 0};                    ///< m/s at t = 0, of the centre of mass (translation.h)
  Vec3 F_S{0, 0, 0};                     ///< N, constant in space
  ArrowHeld arrow = ArrowHeld::in_space;
  MotionSpec motion;
  std::vector<View> views{View::space};  ///< one, or two side by side
  OverlaySet show;
  ComparedMethods compared;
  Marks marks;  ///< in space, besides the overlays
  Poses poses;  ///< of a body that flies
  CameraSpec camera;
  double at_s = 0.0;  ///< the t of a still, and what lengths and tables that hang on a time are made for
  std::optional<double> still_s;       ///< the t of a still, where that is another
  std::optional<double> duration_s;    ///< what curves over time cover; absent: one polhode period (the
                                       ///< herpolhode: three), else a turn
  std::optional<double> rate;          ///< simulated seconds per shown second; absent: one period in 8 s
  std::vector<std::string> highlight;  ///< overlays to draw bolder; ids of terms wait for pages
  QualityLevel quality = QualityLevel::normal;
  std::string caption;                             ///< one line below the picture
  CaptionWhen caption_when = CaptionWhen::always;  ///< `still`: it speaks of the moment of the still alone
  std::vector<PlotSpec> meters;                    ///< plots of a page
  /// Other scenes, shown beside this one at the same t and at its rate. They have none beside them.
  std::vector<Scene> beside{};
  /// How many scenes of `beside` stand before this one, further left or above; the others stand behind it.
  std::size_t before = 0;
  /// Numbers that a reader may vary. If there are any, the scenes of `beside` are this scene with other
  /// values of the first of them.
  std::vector<Variation> vary{};
  /// The value of that number in this scene, which stands below its picture; written as a caption is.
  std::string label{};
  Language language = Language::en;  ///< of what is written in its pictures: that of its lesson
  bool operator==(const Scene&) const = default;
};

/// The scene and those beside it, in the order in which they stand.
std::vector<const Scene*> shown_scenes(const Scene& scene);

/// The same motion at that time, without what pictures show of it: for its numbers.
Scene without_picture(Scene scene, double at_s);

/// Whether two scenes differ at most in how the same motion is looked at: on the way from one to the other
/// t goes on. All fields but those named in scene.cpp belong to the motion.
bool same_course(Scene a, const Scene& b);
/// Whether the model of one serves the other: they differ at most in the camera and the quality.
bool same_model(Scene a, const Scene& b);

/// The t of a still.
inline double still_time_s(const Scene& scene) { return scene.still_s.value_or(scene.at_s); }

/// Whether what the caption says is meant of t: a caption of the still of no other moment, up to the rounding
/// of t.
bool caption_holds(const Scene& scene, double t_s);
void leave_out_caption(Scene& scene);

}  // namespace polhode
