// SPDX-License-Identifier: MIT
#include "tests/app/publish/example_deck.h"

#include "render/image/png.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

namespace polhode {

namespace {

Image colored(Size size, int level) {
  Image image;
  image.size = size;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (const int value : {level, x % 256, y == 1 ? 255 : 30, 255})
        image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

}  // namespace

DeckSlide slide_of(const ScratchFolder& folder, const std::string& name, const Image& image) {
  DeckSlide slide;
  slide.png = folder / (name + ".png");
  EXPECT_TRUE(write_png(slide.png, image, {{{"Description", "Alt of " + name}}, 0}));
  return slide;
}

Deck example_deck(const ScratchFolder& folder, Size size) {
  Deck deck;
  deck.title = "Examples";
  int number = 0;
  const std::vector<int> counts = {3, 1, 2};
  for (std::size_t stage = 0; stage < counts.size(); ++stage)
    for (int part = 1; part <= counts[stage]; ++part) {
      const std::string name = fmt::format("s{}", ++number);
      DeckSlide slide = slide_of(folder, name, colored(size, 20 * number));
      slide.stage = static_cast<int>(stage) + 1;
      slide.title = fmt::format("Stage {}", slide.stage);
      if (counts[stage] > 1) slide.part = fmt::format("step {} of {}", part, counts[stage]);
      slide.alt = "Alt of " + name;
      slide.notes = {{StepNote::Kind::text, "Words of " + name},
                     {StepNote::Kind::equation, "Equation (5): ω² − 1 equals 0."}};
      deck.slides.push_back(slide);
    }
  return deck;
}

std::string written(const Deck& deck, DeckKind kind) {
  const ScratchFolder folder;
  const Result<DeckEnd> end = write_deck(folder / "deck", kind, deck);
  EXPECT_TRUE(end) << end.error();
  return text_of(folder / "deck");
}

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

ProgramRun shell(const std::string& command) {
  const ScratchFolder scratch;
  const std::string all =
      fmt::format("{{ {}\n}} >'{}' 2>'{}'", command, (scratch / "out").string(), (scratch / "err").string());
  const int status = std::system(all.c_str());
  ProgramRun run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = text_of(scratch / "out");
  run.err = text_of(scratch / "err");
  return run;
}

}  // namespace polhode
