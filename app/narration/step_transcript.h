// SPDX-License-Identifier: MIT
// What is said to the steps of a stage: their transcript.
#pragma once

#include "app/narration/speech_text.h"
#include "app/narration/step_note.h"

namespace polhode {

/// What the steps from `first` to `last` (from 1) of a stage add, as a reader says it, with the caption of
/// each new figure; as in the lesson's transcript without hints and answers. Before that of each step what
/// its author means to say, which the transcript has not.
std::vector<StepNote> notes_of(const SpeechText& speech, const Stage& stage, int first, int last);

}  // namespace polhode
