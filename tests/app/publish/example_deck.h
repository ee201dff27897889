// SPDX-License-Identifier: MIT
// Decks to test with, of small pictures in a folder that goes away.
#pragma once

#include "app/publish/deck.h"
#include "render/image/image.h"
#include "tests/app/run_program.h"

namespace polhode {

/// Every slide of another colour (its number times 20, a row of it brighter): slide i of 3 stages with 3, 1
/// and 2 slides is called "s<i>", its stage "Stage <n>", and its notes say "Words of s<i>".
Deck example_deck(const ScratchFolder& folder, Size size = {320, 180});

/// A slide for a picture.
DeckSlide slide_of(const ScratchFolder& folder, const std::string& name, const Image& image);

/// What write_deck leaves; fails the test if it fails.
std::string written(const Deck& deck, DeckKind kind);

/// Whether a program is installed.
bool has_program(const std::string& name);

/// What a command prints, and how it ends.
ProgramRun shell(const std::string& command);

}  // namespace polhode
