// SPDX-License-Identifier: MIT
// polhode verify, on exports that are whole, hurt, or not finished.
#include "app/export/folder/export_folder.h"
#include "render/image/png.h"
#include "tests/app/export/small_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace polhode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;

class Verify : public testing::Test {
 protected:
  void SetUp() override { make({}); }
  void make(const std::vector<std::string>& more) {
    const ProgramRun run = polhode(small_export(folder(), more));
    ASSERT_EQ(run.code, 0) << run.err;
  }
  fs::path folder() const { return scratch / "out"; }
  fs::path file(const std::string& name) const { return folder() / name; }
  Json json(int code) {
    const ProgramRun run = polhode({"verify", folder(), "--json"});
    EXPECT_EQ(run.code, code) << run.out << run.err;
    return Json::parse(run.out);
  }
  static constexpr const char* kFirst = "01-steady-frame00.png";
  static constexpr const char* kSecond = "01-steady-frame01.png";
  ScratchFolder scratch;
};

TEST_F(Verify, AWholeExportIsCode0) {
  const ProgramRun run = polhode({"verify", folder()});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("12 files of tiny, all there and whole"));
  EXPECT_THAT(run.err, IsEmpty());
  const Json found = json(0);
  EXPECT_EQ(found["ok"], true);
  EXPECT_EQ(found["files"], kSmallFrames);
  EXPECT_TRUE(found["resume"].is_null());
}

TEST_F(Verify, FindsWhatIsMissingTruncatedAndForeign) {
  fs::remove(file(kFirst));
  fs::resize_file(file(kSecond), fs::file_size(file(kSecond)) / 2);
  write_text(file("07-notes.png"), "?");
  const Json found = json(4);
  EXPECT_EQ(found["ok"], false);
  EXPECT_THAT(found["missing"], ElementsAre(kFirst));
  EXPECT_THAT(found["damaged"], ElementsAre(kSecond));
  EXPECT_THAT(found["foreign"], ElementsAre("07-notes.png"));
  const ProgramRun run = polhode({"verify", folder()});
  for (const char* line :
       {"missing: 01-steady-frame00.png\n", "damaged: 01-steady-frame01.png: it is truncated",
        "foreign: 07-notes.png\n", "--skip-existing\n"})
    EXPECT_THAT(run.out, HasSubstr(line));
}

TEST_F(Verify, FindsEveryDamagedByte) {
  const std::string whole = text_of(file(kFirst));
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 40) {
    std::string hurt = whole;
    hurt[at] = static_cast<char>(hurt[at] ^ 4);
    write_text(file(kFirst), hurt);
    EXPECT_EQ(polhode({"verify", folder()}).code, 4) << at;
  }
}

TEST_F(Verify, FindsAPictureUnderTheNameOfAnother) {
  fs::copy_file(file(kFirst), file(kSecond), fs::copy_options::overwrite_existing);
  EXPECT_THAT(json(4)["foreign"], ElementsAre(kSecond));
}

TEST_F(Verify, FindsAManifestThatIsMissingOrDamaged) {
  const std::string manifest = text_of(file(kManifestName));
  write_text(file(kManifestName), manifest.substr(0, manifest.size() / 2));
  EXPECT_THAT(json(4)["damaged"], ElementsAre(kManifestName));
  fs::remove(file(kManifestName));
  EXPECT_THAT(json(4)["missing"], ElementsAre(kManifestName));
}

TEST_F(Verify, PassesOverFilmsAndDecks) {
  for (const char* name : {"a.mp4", "a.gif", "deck.html", "deck.pdf"}) write_text(file(name), "x");
  json(0);
}

TEST_F(Verify, ReportsWhatKilledProcessesLeftAndTheNextExportRemovesIt) {
  const std::string left = ".polhode-12345678-1-0.part";
  write_text(file(left), "");
  json(0);  // another machine may be writing it just now
  fs::last_write_time(file(left), fs::file_time_type::clock::now() - std::chrono::hours(2));
  EXPECT_THAT(json(4)["left_over"], ElementsAre(left));
  make({"--skip-existing"});
  json(0);
}

TEST_F(Verify, SaysHowToFinishAnUnfinishedExport) {
  fs::remove_all(folder());
  make({"--shard", "2/3"});
  const Json found = json(4);
  EXPECT_EQ(found["finished"], false);
  EXPECT_EQ(found["files"], kSmallFrames);
  EXPECT_EQ(found["missing"].size(), 1 + kSmallFrames - kSmallFrames / 3);
  EXPECT_THAT(found["shards_finished"], ElementsAre("2-of-3"));
  EXPECT_THAT(found["foreign"], IsEmpty());
  const std::string command = found["resume"];
  EXPECT_EQ(command.find("--shard"), std::string::npos);
  EXPECT_EQ(std::system((command + " 2>/dev/null").c_str()), 0) << command;
  json(0);
}

TEST_F(Verify, OffersNothingForCopyingButAnExportByThisProgram) {
  fs::remove_all(folder());
  make({"--shard", "2/3"});
  const Json genuine = Json::parse(text_of(file(kMarkerName)));
  const std::vector<Json> planted = {
      {"sh", "-c", "rm -rf ~; echo \u001b[2J"},
      {"/tmp/evil/sh", "export", "tiny", "--skip-existing"},
      {"polhode", "compare", "a", "b", "--skip-existing"},
      {"polhode", "export", "tiny", "--wrapper", "sh", "--skip-existing"},
      {"polhode", "export", "tiny\u001b[2J", "--output", "x", "--skip-existing"},
      {"polhode", "export", "tiny", "--output", "x"},
      {1, 2, 3}};
  for (const Json& resume : planted) {
    Json marker = genuine;
    marker["resume"] = resume;
    write_text(file(kMarkerName), marker.dump());
    const std::string offered = json(4)["resume"];
    EXPECT_THAT(offered, HasSubstr("polhode export tiny --output ")) << resume;
    EXPECT_THAT(offered,
                testing::AllOf(Not(HasSubstr("rm -rf")), Not(HasSubstr("evil")), Not(HasSubstr("wrapper"))));
    EXPECT_THAT(polhode({"verify", folder()}).out, Not(HasSubstr("\x1b")));
  }
  Json marker = genuine;
  marker["resume"][0] = "/tmp/evil/polhode";
  write_text(file(kMarkerName), marker.dump());
  EXPECT_THAT(json(4)["resume"], Not(HasSubstr("evil"))) << "the program is the one that verifies";
  marker["resume"] = nullptr;
  for (const char* option : {"output \u001b", "output", "skip-existing"}) {
    marker["options"] = {{option, "/etc"}};
    write_text(file(kMarkerName), marker.dump());
    EXPECT_TRUE(json(4)["resume"].is_null()) << option;
  }
}

// A film or deck of that name would be written over.
TEST_F(Verify, OffersToMakeThePicturesAlone) {
  const Json genuine = Json::parse(text_of(file(kManifestName)));
  fs::remove(file(kFirst));
  const std::string precious = scratch / "precious.html";
  const std::vector<Json> planted = {
      {"polhode", "export", "tiny", "--output", "x", "--deck", precious, "--skip-existing"},
      {"polhode", "export", "tiny", "--deck=" + precious, "--output", "x", "--skip-existing"},
      {"polhode", "export", "tiny", "--film", precious, "--film=" + precious, "--skip-existing"}};
  for (const Json& resume : planted) {
    Json manifest = genuine;
    manifest["resume"] = resume;
    write_text(file(kManifestName), manifest.dump());
    EXPECT_THAT(json(4)["resume"].get<std::string>(),
                testing::AllOf(HasSubstr(" export tiny --output " + folder().string()),
                               testing::EndsWith(" --skip-existing"), Not(HasSubstr("precious"))));
  }
  for (const char* option : {"deck", "film"}) {
    Json manifest = genuine;
    manifest["options"][option] = precious;
    write_text(file(kManifestName), manifest.dump());
    EXPECT_TRUE(json(4)["resume"].is_null());
  }
}

TEST_F(Verify, SaysHowToFinishThePicturesOfAFilm) {
  for (const auto& [each, picture] :
       {std::pair{"frame", "03-rolling-frame3.png"}, std::pair{"step", "03-rolling-step1.png"}}) {
    fs::remove_all(folder());
    fs::create_directories(file(picture));  // the export stops there
    const ProgramRun run =
        polhode({"export", test_lesson("tiny.md"), "--film", scratch / "f.mp4", "-o", folder(), "--what",
                 "figure", "--size", "48x27", "--fps", "3", "--seconds", "1", "--each", each});
    ASSERT_EQ(run.code, 1) << run.err;
    fs::remove(file(picture));
    const std::string command = json(4)["resume"];
    EXPECT_THAT(command, Not(HasSubstr("f.mp4")));
    EXPECT_EQ(std::system((command + " 2>/dev/null").c_str()), 0) << command;
    json(0);
  }
}

TEST_F(Verify, WritesOutWhatSteersATerminal) {
  write_text(file("\x1b[31mred.png"), "?");
  const ProgramRun run = polhode({"verify", folder()});
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.out, testing::AllOf(Not(HasSubstr("\x1b")), HasSubstr("foreign: \\u001b[31mred.png\n")));
}

TEST_F(Verify, ReadsTranscripts) {
  ASSERT_EQ(polhode({"export", test_lesson("tiny.md"), "-o", scratch / "text", "--what", "transcript"}).code,
            0);
  EXPECT_EQ(polhode({"verify", scratch / "text"}).code, 0);
  fs::resize_file(scratch / "text/tiny.txt", 0);
  EXPECT_EQ(polhode({"verify", scratch / "text"}).code, 4);
}

// HOSTILE F3: a transcript that was cut or changed was called whole.
TEST_F(Verify, FindsATranscriptThatIsCutOrChanged) {
  const fs::path text = scratch / "text";
  ASSERT_EQ(polhode({"export", test_lesson("tiny.md"), "-o", text, "--what", "transcript"}).code, 0);
  const std::string whole = text_of(text / "tiny.txt");
  std::string changed = whole;
  changed[whole.size() / 2] ^= 1;
  for (const std::string& hurt : {whole.substr(0, whole.size() - 1), whole + "\n", changed}) {
    write_text(text / "tiny.txt", hurt);
    const ProgramRun run = polhode({"verify", text});
    EXPECT_EQ(run.code, 4);
    EXPECT_THAT(run.out, HasSubstr("damaged: tiny.txt: its bytes are not those that were written"));
  }
  write_text(text / "tiny.txt", whole);
  EXPECT_EQ(polhode({"verify", text}).code, 0);
}

TEST_F(Verify, FindsAWholePictureThatWasNotWrittenByThisExport) {
  std::string bytes = text_of(file(kFirst));
  auto png = decode_png(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
  ASSERT_TRUE(png.ok());
  png->image.rgba[0] ^= 1;
  ASSERT_TRUE(write_png(file(kFirst), png->image, png->metadata).ok());
  EXPECT_EQ(json(4)["reasons"][kFirst], "its bytes are not those that were written");
}

TEST_F(Verify, FindsAManifestThatListsAFileTwiceOrAnImpossibleSize) {
  const std::string whole = text_of(file(kManifestName));
  Json manifest = Json::parse(whole);
  manifest["files"].push_back(manifest["files"][0]);
  write_text(file(kManifestName), manifest.dump());
  EXPECT_THAT(json(4)["damaged"], ElementsAre(kManifestName));
  manifest = Json::parse(whole);
  manifest["files"][0]["width"] = manifest["files"][0]["width"].get<std::int64_t>() + (std::int64_t{1} << 32);
  write_text(file(kManifestName), manifest.dump());
  EXPECT_THAT(json(4)["foreign"], ElementsAre(kFirst));
}

TEST_F(Verify, DoesNotReadAManifestOfAnotherFormat) {
  for (const Json& format : {Json(2), Json("1"), Json(nullptr)}) {
    Json manifest = Json::parse(text_of(file(kManifestName)));
    manifest["format"] = format;
    write_text(file(kManifestName), manifest.dump());
    const Json found = json(4);
    EXPECT_THAT(found["damaged"], ElementsAre(kManifestName)) << format;
    EXPECT_EQ(found["reasons"][kManifestName], "it is not a manifest of polhode");
    EXPECT_EQ(polhode(small_export(folder())).code, 1) << format;
  }
}

// HOSTILE F11: it was read whole, and took as much memory.
TEST_F(Verify, FindsAFileThatIsLongerThanItsPictureCanBe) {
  fs::resize_file(file(kFirst), std::uintmax_t{1} << 30);
  EXPECT_EQ(json(4)["reasons"][kFirst], "it is larger than it can be");
  const fs::path text = scratch / "text";
  ASSERT_EQ(polhode({"export", test_lesson("tiny.md"), "-o", text, "--what", "transcript"}).code, 0);
  fs::resize_file(text / "tiny.txt", std::uintmax_t{1} << 30);
  EXPECT_THAT(polhode({"verify", text}).out, HasSubstr("damaged: tiny.txt: it is larger than it can be"));
}

// Found by hand beside the fuzzer: printing and copying such a value went as deep as it does, and ended the
// program.
TEST_F(Verify, TakesARecordThatNestsAsDeepAsItLikes) {
  const Json whole = Json::parse(text_of(file(kManifestName)));
  constexpr int kDeep = 200'000;
  const std::string deep = std::string(kDeep, '[') + std::string(kDeep, ']');
  for (const char* key : {"options", "files", "lesson"})
    for (const char* name : {kManifestName, kMarkerName}) {
      Json record = whole;
      if (std::string_view(key) == "files")
        record[key] = Json::array({"DEEP"});
      else
        record[key]["stage"] = "DEEP";
      std::string text = record.dump();
      text.replace(text.find("\"DEEP\""), 6, deep);
      write_text(file(name), text);
      EXPECT_LE(polhode({"verify", folder()}).code, 4) << key << ' ' << name;
      EXPECT_LE(polhode(small_export(folder())).code, 1) << key << ' ' << name;
      write_text(file(kManifestName), whole.dump());
      fs::remove(file(kMarkerName));
    }
}

TEST_F(Verify, FindsAManifestWithoutTheChecksumOfAFile) {
  const Json whole = Json::parse(text_of(file(kManifestName)));
  for (const bool erased : {true, false}) {
    Json manifest = whole;
    if (erased)
      manifest["files"][1].erase("sha256");
    else
      manifest["files"][1]["sha256"] = nullptr;
    write_text(file(kManifestName), manifest.dump());
    const Json found = json(4);
    EXPECT_THAT(found["damaged"], ElementsAre(kManifestName));
    EXPECT_EQ(found["reasons"][kManifestName], std::string("it has no sha256 of ") + kSecond);
  }
  Json manifest = whole;
  for (Json& one : manifest["files"]) one["sha256"] = nullptr;
  write_text(file(kManifestName), manifest.dump());
  EXPECT_THAT(json(4)["damaged"], ElementsAre(kManifestName));
}

TEST_F(Verify, FindsAMarkerThatListsAFileTwice) {
  fs::remove_all(folder());
  make({"--shard", "2/3"});
  Json marker = Json::parse(text_of(file(kMarkerName)));
  marker["files"].push_back(marker["files"][0]);
  write_text(file(kMarkerName), marker.dump());
  EXPECT_THAT(json(4)["damaged"], ElementsAre(kMarkerName));
}

TEST_F(Verify, TakesManifestsOfBeforeThereWereChecksums) {
  Json manifest = Json::parse(text_of(file(kManifestName)));
  for (Json& one : manifest["files"]) one.erase("sha256");
  write_text(file(kManifestName), manifest.dump());
  json(0);
}

TEST_F(Verify, AFolderThatCannotBeReadIsCode1) {
  const ProgramRun run = polhode({"verify", scratch / "none"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("none"));
}

}  // namespace
}  // namespace polhode
