// SPDX-License-Identifier: MIT
// What a claim comes to on the running motion: both sides, and how far apart they are.
//
// Nothing is put in that the claim says: ω and the attitude are the motion's at t, and their rates, with
// those of A and of the centre of mass, are differences of the motion itself at times around t
// (physics/analysis/difference.h). So `ddt(L) = N` compares how L really changes, as computed, with the
// torque.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/claim_state.h"
#include "render/scene/model/model.h"

#include <optional>

namespace polhode {

/// A motion at one time, as claims see it. A is the scene's arrow, v, p, F, m are of the centre of mass, and
/// J is the body's tensor, its components on axes that are turned against the principal ones by kTurnOfAxes.
struct LiveState {
  ClaimState<SizedNumber> state;
  /// What rounding and the differences allow of a residual; and where rates are compared, the method's error
  /// in a step.
  double rounding = 0, method_error = 0;
  /// By what both grow for second rates: these are divided once more by the step of the difference; and of a
  /// step of the method, whose second rate is of one order less.
  double growth_of_second = 1;
};

/// About the axis (1, 1, 1), rad.
inline constexpr double kTurnOfAxes = 0.5;

/// Nothing where the motion cannot be computed. Seven states of the motion, some 10 µs for a closed form.
std::optional<LiveState> live_state(const SceneModel& model, double t_s);

/// The same with all rates 0, for what has none: nothing more is asked of the motion than its state at t.
std::optional<LiveState> still_state(const SceneModel& model, double t_s, const RigidBodyState& state);
/// Whether an expression speaks of rates.
bool has_rates(const Expression& expression);
/// Whether an energy sink lets the body slip, so that rates are not those of what is drawn.
bool loses_energy_inside(const Scene& scene);

/// Both sides of a claim on a motion: of that line whose residual is the largest beside its tolerance.
struct LiveValue {
  bool is_vector = false;
  std::array<double, 3> left{}, right{};  ///< components in the frame of the view; of a scalar the first
  double size = 0;                        ///< of what the sides come from: `residual` is relative to it
  double residual = 0, tolerance = 0;     ///< of inequalities, and of what is proved to an order, 0
};
/// Whether the scene has numbers for what the claim speaks of. p, v, F and m have some only where the centre
/// of mass moves, A only where that arrow is shown. J, a scalar no scene has, counts where the numbers refute
/// what is said of J alone. Where an energy sink lets the body slip, rates have none. A non-sequitur is about
/// another motion than the scene's and is never shown; a measured claim always is. What is given has to hold
/// as the motion begins: of a body of three different moments nothing is shown that assumes I2 = I1.
bool can_be_shown(const Claim& claim, const Scene& scene);
/// What is called small is on a motion at most so much: a component of ω beside |ω|, one of N beside 2T. Of h
/// and k no motion has values.
inline constexpr double kSmallOnMotion = 0.1;
/// Whether what is given holds on a motion at this moment, up to rounding; and what is small is.
bool holds_on(const Given& given, const LiveState& live);
/// Nothing where a side is not defined, and of a non-sequitur. Some µs a line.
std::optional<LiveValue> live_value(const Claim& claim, const LiveState& live, View view);
/// The same of one line.
std::optional<LiveValue> live_value(const ClaimLine& line, const LiveState& live, View view);

/// A scalar on a motion; nothing where it is not defined.
std::optional<double> live_number(const Expression& scalar, const LiveState& live);

/// An expression on a motion.
struct LiveQuantity {
  bool is_vector = false;
  std::array<double, 3> components{};  ///< in the frame of the view; of a scalar the first
};
/// Nothing where it is not defined. What is nothing but rounding is 0.
std::optional<LiveQuantity> live_quantity(const Expression& expression, const LiveState& live, View view);

/// The larger part of a method's tolerance is its error in a step: kStepErrors (ΩH)^order, with step H and
/// the rate Ω = |ω| (by |I₁ − I₂| ≤ I₃ nothing in a free body turns faster).
/// Seen at most, over all methods, three spins, steps from 0.02 to 0.1 s, with and without torque: 0.24.
inline constexpr double kStepErrors = 1;
/// Of an adaptive method, in units of its tolerance: the error of its interpolation is not controlled.
/// Seen: 41.
inline constexpr double kUnitsOfTolerance = 200;

/// A tolerance above this decides nothing: the step is too long.
inline constexpr double kDecisive = 0.01;

/// The largest residual of the equality over the scene's interval from 0 on, and the tolerance there.
struct MeasuredResidual {
  double residual = 0, tolerance = 0, t_s = 0;
  /// Of the terms: the larger side, the largest over the interval, with the rates that Euler's equations give
  /// in the states of the motion; or what is left beside two summands that cancel, if that is less. 0 where
  /// that is rounding, and algebra proves that it is.
  double side = 0;
  /// The largest tolerance over the interval.
  double allowed = 0;
  bool holds() const { return residual <= tolerance; }
  /// Where the terms cancel so far that even the sides are lost in what is allowed, a residual tells nothing:
  /// of a fast top dT/dt is a small difference of large terms, and would pass for 0.
  bool decides() const { return side == 0 || allowed <= kDecisive * side; }
};
/// At so many times, evenly.
inline constexpr int kMeasuredTimes = 25;
/// The worst by residual/tolerance; `within` is the tolerance if there is one. Nothing where the motion or
/// the claim has no values at some time.
std::optional<MeasuredResidual> measure(const Equality& equality, std::optional<double> within,
                                        const SceneModel& model, const Given& given = {});

}  // namespace polhode
