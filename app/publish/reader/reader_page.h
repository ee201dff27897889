// SPDX-License-Identifier: MIT
// The text edition of a lesson: one file of HTML for any browser, phone or screen reader, to be read without
// network and without script. Headings, prose, formulas as MathML, figures as pictures with alternative
// texts, what was proved in plain words, questions with their answers. Bytes depend on the lesson and the
// look alone, and on the driver that draws.
#pragma once

#include "app/publish/live/live_program.h"
#include "app/publish/reader/reader_figure.h"
#include "base/files/atomic_file.h"
#include "base/outcome.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// What makes figures move, once they are pressed.
struct LiveParts {
  LiveProgram program;
  std::string lesson_text;  ///< that `lesson` was read from
};

struct ReaderEdition {
  const Lesson& lesson;
  std::vector<std::string> stages{};  ///< ids; empty: all. Nothing leads to the others
  ReaderFigures::Look look{};       ///< of the figures: texts follow the reader's own wish for light or dark
  std::optional<LiveParts> live{};  ///< absent: figures are pictures, and nothing else
};

/// Told which of the edition's steps comes next, from 0, and the stage it is of; false stops.
using ReaderProgress = std::function<bool(std::size_t step, const Stage& stage)>;

enum class ReaderEnd { written, stopped };

std::size_t steps_of(const ReaderEdition& edition);

/// The file appears whole or not at all: if `go_on`, which may be empty, says false, or `effort` throws
/// Interrupted, it is stopped, and what stood under the name stays. One figure is in memory at a time.
Outcome<ReaderEnd> write_reader(const std::filesystem::path& file, const ReaderEdition& edition,
                                Renderer& renderer, Durability durability = Durability::rename_only,
                                const ReaderProgress& go_on = {}, const Effort& effort = {});

}  // namespace polhode
