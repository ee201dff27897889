// SPDX-License-Identifier: MIT
// What a reader has changed of a scene's motion to bring it to a goal: ω, the moments, the attitude, a
// constant torque, the time. It is written as in a scene's keys, `omega = [0.1, 3, 0.1]; t = 0.4`, so that
// what was reached by hand can be kept, and judged again without a window.
#pragma once

#include "base/result.h"
#include "base/words/phrase.h"
#include "lessons/reader/front_matter/keys.h"
#include "render/scene/description/scene.h"

#include <array>
#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// What of a motion can be steered.
enum class Steered { omega, moments, attitude, torque, t };
struct SteeredFacts {
  std::string_view name;  ///< in lessons and answers
  Phrase words;           ///< in sentences
  std::string_view form;  ///< how it is written
};
/// In the order of the enumeration.
inline constexpr std::array<SteeredFacts, 5> kSteered = {
    {{"omega", {"ω", "ω"}, "omega = [0.1, 3, 0.1]"},
     {"moments", {"the moments of inertia", "die Trägheitsmomente"}, "moments = [1, 2, 2.5]"},
     {"attitude", {"the attitude", "die Lage"}, "attitude = [1, 0, 0, 0]"},
     {"torque", {"the torque", "das Drehmoment"}, "torque = \"body:0.1,0,0\""},
     {"t", {"the time", "die Zeit"}, "t = 0.4"}}};
constexpr const SteeredFacts& facts_of(Steered part) { return kSteered[static_cast<std::size_t>(part)]; }

class SteeredParts {
 public:
  void insert(Steered part) { parts_.set(static_cast<std::size_t>(part)); }
  bool contains(Steered part) const { return parts_.test(static_cast<std::size_t>(part)); }
  bool empty() const { return parts_.none(); }
  bool operator==(const SteeredParts&) const = default;

 private:
  std::bitset<kSteered.size()> parts_;
};
/// "ω, the torque"
std::string words_of(const SteeredParts& parts);

/// What is absent is as in the scene.
struct SteeredState {
  std::optional<Vec3> w0_B{};     ///< rad/s at t = 0
  std::optional<Vec3> moments{};  ///< kg m²; those of a body
  std::optional<AttitudeSpec> attitude{};
  std::optional<TorqueTerm> torque{};  ///< a SpaceTorque or BodyTorque
  std::optional<double> t_s{};
  bool operator==(const SteeredState&) const = default;

  SteeredParts parts() const;
};

/// Whether readers can change it: it is constant in space or in the body.
bool is_constant(const TorqueTerm& term);
/// The constant torque that a reader changes: the first of the scene's, or one in the body that is 0.
TorqueTerm constant_torque(const Torque& torque);
/// The torque with that one replaced, or added behind the others.
Torque with_constant(Torque torque, const TorqueTerm& constant);
const Vec3& components_of(const TorqueTerm& constant);

/// The scene of the motion that is meant, with nothing beside it; of the time nothing is said there.
Scene steered(Scene scene, const SteeredState& state);

/// Keys of a table, as in `solution`. Nothing, and reports, where one of them is wrong.
std::optional<SteeredState> read_steered_state(const TomlTable& table, std::string_view where,
                                               Report& report);

/// Why a text is no such state.
struct UnreadableState {
  std::string message, hint;
  int column = 0;  ///< from 1, of characters; 0: the whole
};
inline constexpr std::size_t kMaxStateBytes = 4096;
/// Reads "omega = [0.1, 3, 0.1]; t = 0.4": a `;` or a new line stands between.
Result<SteeredState, UnreadableState> parse_state(std::string_view text);
/// That reads back as the same numbers. Empty of nothing.
std::string text_of(const SteeredState& state);

}  // namespace polhode
