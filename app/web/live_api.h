// SPDX-License-Identifier: MIT
// What a page's script calls: a lesson's figure in a canvas, the same C++ as in the window.
//
// One figure at a time in each instance of the module: the step that is shown. A page has one canvas, which
// it moves to the figure in view, and tells this side which step that is. All judgement is here; the script
// passes on what happened, asks for a picture where it wants one, and copies words into the page.
//
// Texts go in and come out as UTF-8. A `const char*` that comes out is valid until the next call. Calls that
// change something return 1 if it was done and 0 if it was refused, with nothing changed: polhode_message()
// says why, in a sentence for readers. Nothing is thrown, nothing is printed. Times are simulated seconds,
// angles radians, vectors body components; places are canvas pixels (device pixels), y down from the top.
//
// A script calls them as Module._polhode_draw(…), those with texts through
// Module.ccall('polhode_open_lesson', 'number', ['string', 'string'], […]).
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

// Lesson and canvas. Each may come first.

/// Takes the place of the lesson before. What a lesson says is proved where it is exported; here it is only
/// read. `file_name` is for messages.
int polhode_open_lesson(const char* text, const char* file_name);
/// A scene without a lesson, for a sandbox: the lines of a ```scene block as lessons have them (FORMAT.md),
/// `body = "textbook"` and so on, with [body.NAME] as `own_body` or an empty text.
int polhode_open_scene(const char* scene_toml, const char* own_body_toml);
/// Goes to a step; both count from 1. Edits of a scene are kept while another is shown. It is at rest, at the
/// scene's own time. Refused where there is none, or where it has no figure.
int polhode_show(int stage, int step);
/// The same by the id of a stage.
int polhode_show_stage(const char* stage_id, int step);
/// Opens WebGL2 on the canvas that this CSS selector finds, and compiles the shaders: 0.1 s. Call it again
/// after `webglcontextrestored`, and polhode_detach() on `webglcontextlost`. The canvas may be moved in the
/// document and change its size.
int polhode_attach(const char* selector);
void polhode_detach(void);

// Pictures.

enum {
  POLHODE_FIGURE = 0,  ///< figure and plots fill the canvas, without a caption, as on a reader's page
  POLHODE_SLIDE = 1,   ///< the page as in the window and on a deck: text, equations and figure. No page shows
                       ///< it yet: its claims are only read here, and stand there as not proved
};
/// The height of a picture of this width, px: as high as its plots need. 0 without a scene.
int polhode_height_for(int width);
/// Draws the shown step at the present time into the canvas, whose size must be (width, height) px already.
/// Does nothing, and returns 1, if that picture is already there and was not lost. Without a canvas it is
/// refused, but laid out: hands then know where things are. `resolution`, 0 < … ≤ 1: the part of its pixels
/// each way with which space is drawn, then enlarged, while something moves on a slow machine; 1: all.
int polhode_draw(int width, int height, int what, double resolution);
/// 0: on paper (light), 1: dark.
void polhode_set_theme(int dark);

// Time.

void polhode_set_playing(int playing);
/// Real time passes: the motion goes on where it plays. Seconds that a page was hidden are the script's to
/// leave out. Returns 1 if the picture changes by itself (ask for the next frame), else 0.
int polhode_advance(double seconds);
/// Any t at once. Refused where the motion cannot be computed so far.
int polhode_set_time(double t_s);
/// Shown seconds a second, 1/16 … 16.
void polhode_set_speed(double speed);

// Hands. Places are those of the last picture drawn.

enum {
  POLHODE_DOWN = 0,    ///< the tip of omega within `reach` is taken, and the motion stops; else the camera
  POLHODE_MOVE = 1,    ///< with a button or finger down: drags what is held. Without: looks what is there
  POLHODE_UP = 2,      ///< or the pointer was cancelled
  POLHODE_DOUBLE = 3,  ///< the camera of the lesson again
};
/// Returns what is held or lies under the pointer: 0 nothing, 1 the figure (a drag turns it), 2 the tip of
/// omega (a drag puts it elsewhere, with T kept). A drag over the picture's height turns by half a turn, as
/// in the window. `reach`, px: 12 css px for a mouse, 24 for a finger.
int polhode_pointer(int kind, double x, double y, double reach);
/// Notches of a wheel, > 0 nearer; of two fingers log(ratio of their distances)/log(1.1).
void polhode_zoom(double notches);
/// As a drag by (dx, dy) in a picture of height 1: for keys and buttons; the window's keys have 1/24.
void polhode_turn(double dx, double dy);
/// A command of the window by its key as app/session/command.cpp has it ("Space", "Shift+Right", "R", "G",
/// "Ctrl+Z", "[", "Z"…), of the groups Time and Body. Refused where there is none.
int polhode_key(const char* key);

// What is changed of the scene. Several changes between two polhode_begin_change() are undone at once.

void polhode_begin_change(void);
int polhode_set_omega(double w1, double w2, double w3);  ///< rad/s at t = 0
/// From body to space at t = 0, scalar first; of any length but 0.
int polhode_set_attitude(double w, double x, double y, double z);
int polhode_set_moments(double I1, double I2, double I3);  ///< kg m²
int polhode_set_body(const char* name);                    ///< of `bodies` in the state
int polhode_vary(int number, double value);                ///< of `vary` in the state, from 0; in its unit
/// By name, of `methods` in the state; empty: the default one. `step` is the step in s of fixed-step methods,
/// the tolerance of adaptive ones; 0: the usual one.
int polhode_set_method(const char* name, double step);
int polhode_show_overlay(const char* name, int shown);  ///< of `overlays` in the state; "ghost" too
int polhode_set_camera(double azimuth_rad, double elevation_rad, double zoom);
int polhode_undo(void);
int polhode_reset(void);  ///< the lesson's scene, camera and time again
/// Lights a symbol or term of the lesson by its id, wherever it is drawn; empty: none.
void polhode_light(const char* id);

// What is said. Objects as JSON; numbers with all their digits; what cannot be computed is null.

/// The last refusal; empty after a call that was not refused.
const char* polhode_message(void);
/// { "t", "omega": [3], "quaternion": [w, x, y, z] (body to space), "L": [3] (space), "T", "L_norm",
///   "terms": {"inertial": [3], "gyroscopic": [3], "torque": [3]} (I·ω̇ + ω×(I·ω) = N, body axes; N m),
///   "omega0": [3], "attitude0": [w, x, y, z] (at t = 0, as a hand has left it; null: as the lesson has it),
///   "moments": [3], "body", "torque_free",
///   "camera": {"azimuth", "elevation", "zoom"},
///   "in_space" (there is something to turn; false: diagrams alone), "following",
///   "stage" (from 1), "stage_id", "step" (from 1), "changed" (something is not the lesson's), "can_undo",
///   "playing", "speed", "rate" (simulated seconds a shown one), "from", "to" (the time line's),
///   "duration", "still" (the t of a still), "period" (of the polhode, null: none), "flips": [t…],
///   "method": {"name", "step", "tolerance", "control": "none"|"fixed"|"adaptive", "why", "usual_step"},
///   "error": {"omega", "attitude"} (of the method against the closed form at t; null: there is none, or it
///   is), "drift": {"T", "L", "L_direction"} (since the start), "vary": [{"number", "from", "to", "value",
///   "label", "unit", "tex"}], "overlays": [{"name", "shown", "words", "unseen" (why nothing of it would be
///   seen here; empty: it would)}], "tips": [{"x", "y"}] (of omega in the last picture), "message" }
/// Without a scene null.
const char* polhode_state(void);
/// { "bodies": [{"name", "moments": [3]}], "methods": [{"name", "words", "keeps", "control", "why_not"}] }
/// `why_not` is null where the method serves the present scene. Not to be asked for in every frame.
const char* polhode_choices(void);
/// { "alt" (what the picture shows now), "captions": [{"text"}] (words for a screen reader),
///   "readouts": [{"name", "value"}] (ω, |ω|, T, |L|, angle of ω and L, error: as the window's panel says
///   them) }
const char* polhode_words(void);

#ifdef __cplusplus
}
#endif
