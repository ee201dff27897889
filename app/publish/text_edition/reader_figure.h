// SPDX-License-Identifier: MIT
// The figures of a text edition: drawn for its width, without captions, and packed to be read on a screen.
#pragma once

#include "app/export/picture_maker.h"
#include "app/narration/speech_text.h"
#include "app/page/page.h"
#include "app/page/page_theme.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// As an `img` has it.
struct ReaderPicture {
  Size size;
  std::string source;  ///< "data:image/webp;base64,…"
  std::string dark{};  ///< the same on dark ground, for a reader who prefers that; empty: there is none
  std::string alt;
  double t_s = 0;
};

/// px. Shown at up to half of it where pixels are small, it is as sharp as the screen.
inline constexpr int kReaderPictureWidth = 960;
/// Of moments of a motion, which stand two in a row.
inline constexpr int kReaderMomentWidth = 560;
/// So many moments tell how a motion goes.
inline constexpr int kReaderMoments = 4;

class ReaderFigures {
 public:
  struct Look {
    Theme theme = Theme::paper;
    std::optional<QualityLevel> quality{};  ///< absent: the scenes'
    bool both = false;                      ///< drawn on dark ground too: twice the time and the size
  };

  /// All outlive it. `effort` is told what motions cost.
  ReaderFigures(const Lesson& lesson, const SpeechText& speech, Renderer& renderer, const Look& look,
                const Effort& effort = {});

  /// The model of a step's scene. Precondition: it has one.
  /// @throws what `effort` throws
  const SceneModel& model_of(const Step& step) { return models_.of(*step.scene); }

  /// The still of a step (from 1), with its plots. Precondition: it has a scene.
  /// Fails where the motion cannot be computed so far, or the driver refuses.
  Outcome<ReaderPicture> still(const Stage& stage, int step);
  /// Its picture at a time, of any size.
  Outcome<ReaderPicture> moment(const Stage& stage, int step, double t_s, Size size);
  /// kReaderMoments moments of its motion, evenly from the first to the last instant.
  Outcome<std::vector<ReaderPicture>> moments(const Stage& stage, int step, const PlayedInterval& interval);

  /// What stands below the picture, lines with formulas between dollars: one that all scenes have in common,
  /// or one for each; empty ones are left out. A scene of a filmstrip has its label in the picture.
  std::vector<std::string> captions(const Step& step);

 private:
  /// Without captions, which stand below the pictures.
  std::vector<SceneInWords> words_of_scenes(const Step& step) const;
  /// What an `img` shows of it on the ground of a theme.
  Outcome<std::string> source(const PageRequest& request);

  const Lesson& lesson_;
  const SpeechText& speech_;
  Renderer& renderer_;
  Look look_;
  ModelOfScene models_;
};

}  // namespace polhode
