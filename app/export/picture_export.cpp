// SPDX-License-Identifier: MIT
#include "app/export/picture_export.h"

#include "app/export/folder/picture_check.h"
#include "app/export/picture_maker.h"
#include "app/export/picture_metadata.h"
#include "app/export/picture_writer.h"
#include "base/files/file_bytes.h"
#include "base/sha256.h"
#include "render/vector/vector_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace fs = std::filesystem;

namespace {

std::unique_ptr<PictureMaker> maker_of(const MakerContext& context) {
  switch (context.options.what) {
    case What::figure:
      return make_figure_maker(context);
    case What::equation:
      return make_equation_maker(context);
    case What::page:
    case What::transcript:
      break;
  }
  return make_page_maker(context);
}

/// What can fail without drawing fails before anything is written: of neighbours that differ in time alone,
/// the first and the last are checked.
Done check_pictures(const ExportPlan& plan, PictureMaker& maker) {
  const auto same_but_time = [&](std::size_t i, std::size_t k) {
    const PlannedPicture &a = plan.pictures[i], &b = plan.pictures[k];
    return a.stage == b.stage && a.step == b.step && a.equation == b.equation;
  };
  for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
    const bool first = i == 0 || !same_but_time(i - 1, i);
    const bool last = i + 1 == plan.pictures.size() || !same_but_time(i, i + 1);
    if (!first && !last) continue;
    if (Done checked = maker.check(plan.pictures[i]); !checked) return checked;
  }
  return done();
}

Result<FolderState> begin(const PictureExport& e, const std::string& renderer) {
  Marker marker{identity_of(e.loaded, e.options), renderer, e.out.resume_all, {}};
  for (const PlannedPicture& picture : e.plan.pictures) marker.files.push_back(picture.file);
  if (const Status made = make_folder(e.out.folder); !made) return Failure{made.error()};
  return begin_in(e.out.folder, marker);
}

/// Pictures that are there already.
struct Keepable {
  bool any = false;
  Checksums recorded;  ///< recorded_checksums

  /// What nobody recorded is what an export left that was interrupted before its manifest.
  bool takes(const std::string& file, const PictureCheck& there) const {
    const auto written = recorded.find(file);
    return there.state == PictureCheck::State::whole &&
           (written == recorded.end() || written->second == there.sha256);
  }
};

Result<Keepable> keepable(const PictureExport& e, const FolderState& before) {
  if (!e.out.skip_existing || !before.ours) return Keepable{};
  Result<Checksums> recorded = recorded_checksums(e.out.folder, identity_of(e.loaded, e.options));
  if (!recorded) return Failure{recorded.error()};
  return Keepable{true, std::move(recorded).value()};
}

/// What a file of outlines says of itself is what a PNG says.
VectorPicture vector_picture(const PictureExport& e, Sheet sheet, const PictureDescription& description,
                             const PngMetadata& metadata) {
  const Background background = background_of(e.options);
  VectorPicture picture{
      .sheet = std::move(sheet),
      .width = static_cast<double>(description.size.width),
      .height = static_cast<double>(description.size.height),
      .px_per_inch = static_cast<double>(e.options.dpi),
      .background = background.kind == Background::Kind::transparent ? Color{0, 0, 0, 0} : sky_of(background),
      .title = description.alt,
      .language = std::string(tag_of(e.loaded.lesson.about.language))};
  for (const auto& [keyword, text] : metadata.text) {
    if (keyword == "Title") picture.description = text;
    if (keyword == "Software") picture.program = text;
    if (keyword == "Author") picture.author += (picture.author.empty() ? "" : ", ") + text;
  }
  return picture;
}

Outcome<std::string> outlines_of(const PictureExport& e, PictureMaker& maker, const Fonts& fonts,
                                 const PlannedPicture& picture, const PictureDescription& description,
                                 const PngMetadata& metadata) try {
  Outcome<Sheet> sheet = maker.sheet(picture);
  if (!sheet) return passed_on(sheet);
  const VectorPicture made = vector_picture(e, std::move(sheet).value(), description, metadata);
  return e.options.format == PictureFormat::svg ? svg_of(made, fonts) : pdf_of(made, fonts);
} catch (const Interrupted&) {
  throw;
} catch (const std::exception& error) {  // of qpdf
  return failure_of(Fault::failed, error.what());
}

/// Outlines cost less than what a check of a file could tell: they are made, and the file that is the same
/// stays as it is.
Done put_outlines(const PictureExport& e, const std::string& name, std::string outlines,
                  const Keepable& keepable, PictureWriter& writer, PicturesMade& made) {
  if (keepable.any) {
    const auto there = read_file_bytes(e.out.folder / name);
    std::string sha256 = sha256_hex(outlines);
    if (there && sha256_hex(*there) == sha256) {
      made.checksums[name] = std::move(sha256);
      ++made.count;
      ++made.kept;
      return done();
    }
  }
  const Status put = writer.put({.name = name, .outlines = std::move(outlines)});
  if (!put) return failed(put);
  ++made.count;
  return done();
}

/// Draws and puts. @throws Interrupted
Done put_pictures(const PictureExport& e, PictureMaker& maker, const Fonts& fonts, const Keepable& keepable,
                  const TellProgress& tell, const InterruptWatch& watch, PictureWriter& writer,
                  PicturesMade& made) {
  const PlannedPicture* before = nullptr;  // the one put last
  for (std::size_t place = 0; place < e.plan.pictures.size() && !watch.interrupted(); ++place) {
    if (!e.out.shard.takes(place)) continue;
    const PlannedPicture& picture = e.plan.pictures[place];
    tell(made.count, picture.file);
    const Outcome<PictureDescription> description = maker.describe(picture);
    if (!description) return passed_on(description);
    PngMetadata metadata =
        picture_metadata(e.loaded.lesson, *picture.stage, description->alt, description->t_s, e.options.dpi);
    if (e.options.format != PictureFormat::png) {
      Outcome<std::string> outlines = outlines_of(e, maker, fonts, picture, *description, metadata);
      if (!outlines) return passed_on(outlines);
      Done put = put_outlines(e, picture.file, std::move(outlines).value(), keepable, writer, made);
      if (!put) return put;
      continue;
    }
    if (keepable.any) {
      PictureCheck there = check_picture(e.out.folder / picture.file, description->size, metadata);
      if (keepable.takes(picture.file, there)) {
        made.checksums[picture.file] = std::move(there.sha256);
        ++made.count;
        ++made.kept;
        continue;
      }
    }
    std::optional<Image> image;  // none: that of the picture before
    if (!before || !maker.same_bytes(*before, picture)) {
      Outcome<Image> drawn = maker.draw(picture);
      if (!drawn) return passed_on(drawn);
      image = std::move(drawn).value();
    }
    const Status put =
        writer.put({.name = picture.file, .image = std::move(image), .metadata = std::move(metadata)});
    if (!put) return failed(put);
    ++made.count;
    before = &picture;
  }
  return done();
}

/// Draws and writes until all are there or someone interrupts.
Outcome<PicturesMade> write_pictures(const PictureExport& e, PictureMaker& maker, const Fonts& fonts,
                                     const Keepable& keepable, const TellProgress& tell,
                                     const InterruptWatch& watch) {
  PictureWriter writer(e.out.folder, e.options.png, e.out.durability);
  PicturesMade made;
  try {
    const Done put = put_pictures(e, maker, fonts, keepable, tell, watch, writer, made);
    if (!put) return passed_on(put);
  } catch (const Interrupted&) {  // what was put is written
  }
  if (const Status finished = writer.finish(); !finished) return failed(finished);
  made.checksums.insert(writer.checksums().begin(), writer.checksums().end());
  made.interrupted = made.count < e.out.shard.size(e.plan.pictures.size());
  return made;
}

Outcome<ManifestFile> manifest_file(const PlannedPicture& picture, PictureMaker& maker,
                                    const Checksums& checksums) {
  Outcome<PictureDescription> made = maker.describe(picture);
  if (!made) return passed_on(made);
  const auto checksum = checksums.find(picture.file);
  return ManifestFile{picture.file,
                      picture.stage->id,
                      picture.step,
                      picture.frame,
                      made->t_s,
                      made->size,
                      std::move(made->tex),
                      std::move(made->alt),
                      std::move(made->method),
                      checksum == checksums.end() ? "" : checksum->second};
}

/// Of the pictures of a shard. Needs nothing remembered of their drawing but checksums, which are also in the
/// manifests of shards, so that anyone can write the manifest of all.
Status write_manifest(const PictureExport& e, PictureMaker& maker, const Shard& shard,
                      const std::string& renderer, const Checksums& checksums, const std::string& name) {
  const auto fill = [&](const AppendBytes& append) -> Status {
    std::string text = manifest_head(identity_of(e.loaded, e.options), renderer);
    const auto flush = [&] {
      Status appended = append(bytes_of(text));
      text.clear();
      return appended;
    };
    bool empty = true;
    for (std::size_t place = 0; place < e.plan.pictures.size(); ++place) {
      if (!shard.takes(place)) continue;
      const Outcome<ManifestFile> file = manifest_file(e.plan.pictures[place], maker, checksums);
      if (!file) return failure(file.error().text);
      if (!empty) text += kManifestComma;
      text += manifest_entry(*file);
      empty = false;
      constexpr std::size_t kPiece = 1 << 16;
      if (text.size() < kPiece) continue;
      if (Status flushed = flush(); !flushed) return flushed;
    }
    text += manifest_end(empty);
    return flush();
  };
  return replace_file_in_pieces(e.out.folder / name, fill, Durability::sync);
}

/// A manifest promises the pictures: someone may have removed some, or the folder, meanwhile.
Status check_all_are_there(const PictureExport& e, const Shard& shard) {
  for (std::size_t place = 0; place < e.plan.pictures.size(); ++place) {
    const fs::path file = e.out.folder / e.plan.pictures[place].file;
    std::error_code error;
    if (shard.takes(place) && !fs::is_regular_file(file, error))
      return failure(fmt::format("{} is gone: it was removed while the export went on", file.string()));
  }
  return success();
}

bool has_manifest_of_this(const PictureExport& e) {
  const auto state = inspect_folder(e.out.folder, identity_of(e.loaded, e.options));
  return state && state->finished;
}

/// A shard's manifest; and that of all, if this is the last.
Status finish_shard(const PictureExport& e, PictureMaker& maker, PicturesMade& made) {
  Status written =
      write_manifest(e, maker, e.out.shard, made.renderer, made.checksums, shard_manifest_name(e.out.shard));
  if (!written) return written;
  const auto summary = summarize_shards(e.out.folder, identity_of(e.loaded, e.options), e.out.shard.count,
                                        e.plan.pictures.size());
  if (!summary) return failure(summary.error());
  const auto& of_all = *summary;
  // Some may be missing because another shard found all of them, or a process without shards came by.
  made.finished = of_all || has_manifest_of_this(e);
  if (!of_all) return success();
  made.renderer = of_all->renderer;
  if (Status there = check_all_are_there(e, Shard{}); !there) return there;
  return write_manifest(e, maker, Shard{}, made.renderer, of_all->checksums, kManifestName);
}

/// After a shard was made again in a folder that was finished. Other bytes come from another driver. It
/// vouches for its own pictures alone: what the manifest says of the others stays, even where they are
/// damaged.
Status refresh_manifest(const PictureExport& e, PictureMaker& maker, const PicturesMade& made) {
  const FolderLock lock(e.out.folder);
  const fs::path path = e.out.folder / kManifestName;
  const auto there = summarize_manifest(path);
  if (!there) return failure(there.error());
  auto of_all = checksums_in_manifest(path);
  if (!of_all) return failure(of_all.error());
  const auto is_listed = [&](const auto& file) {
    const auto listed = of_all->find(file.first);
    return listed != of_all->end() && listed->second == file.second;
  };
  if (std::all_of(made.checksums.begin(), made.checksums.end(), is_listed)) return success();
  for (const auto& [file, sha256] : made.checksums) (*of_all)[file] = sha256;
  return write_manifest(e, maker, Shard{}, join_renderers({*there ? (*there)->renderer : "", made.renderer}),
                        *of_all, kManifestName);
}

Status finish(const PictureExport& e, PictureMaker& maker, const FolderState& before, PicturesMade& made) {
  if (Status there = check_all_are_there(e, e.out.shard); !there) return there;
  if (Status synced = sync_folder(e.out.folder); !synced) return synced;  // before they are promised
  const auto still_ours = inspect_folder(e.out.folder, identity_of(e.loaded, e.options));
  if (!still_ours) return failure(still_ours.error());
  // A folder that was finished still is after a shard of it was made again.
  made.finished = e.out.shard.whole() || before.finished;
  Status listed = e.out.shard.whole()
                      ? write_manifest(e, maker, Shard{}, made.renderer, made.checksums, kManifestName)
                  : before.finished ? refresh_manifest(e, maker, made)
                                    : finish_shard(e, maker, made);
  if (listed && made.finished) remove_traces(e.out.folder);
  return listed;
}

/// `made` is told what there is also where this throws. @throws Interrupted
Done make_pictures(const PictureExport& e, const TellProgress& tell, const InterruptWatch& watch,
                   PicturesMade& made) {
  const auto context = open_context(e.out.context);
  if (!context) return failed(context);
  const auto fonts = Fonts::open();
  if (!fonts) return failed(fonts);
  const auto renderer = Renderer::create(**context, *fonts);
  if (!renderer) return failed(renderer);
  const auto maker = maker_of({e.loaded.lesson, e.options, **renderer, until_interrupted()});
  if (Done checked = check_pictures(e.plan, *maker); !checked) return checked;
  const std::string mine = (*renderer)->driver();
  const Result<FolderState> before = begin(e, mine);
  if (!before) return failed(before);
  const Result<Keepable> kept = keepable(e, *before);
  if (!kept) return failed(kept);
  Outcome<PicturesMade> written = write_pictures(e, *maker, *fonts, *kept, tell, watch);
  if (!written) return passed_on(written);
  made = std::move(written).value();
  if (made.interrupted) return done();
  const bool kept_all = made.kept == made.count, kept_none = made.kept == 0;
  made.renderer = made.count == 0 ? ""
                  : kept_none     ? mine
                  : kept_all      ? before->renderer
                                  : join_renderers({before->renderer, mine});
  if (const Status finished = finish(e, *maker, *before, made); !finished) return failed(finished);
  return done();
}

}  // namespace

Status make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) return failure(fmt::format("cannot make folder {}: {}", folder.string(), error.message()));
  return success();
}

ExportIdentity identity_of(const LoadedLesson& loaded, const ExportOptions& options) {
  return {loaded.lesson.id, loaded.sha256, options_json(options)};
}

Outcome<PicturesMade> make_pictures(const PictureExport& e, const TellProgress& tell,
                                    const InterruptWatch& watch) {
  PicturesMade made;
  try {
    const Done all = make_pictures(e, tell, watch, made);
    if (!all) return passed_on(all);
  } catch (const Interrupted&) {
    made.interrupted = true;
  }
  return made;
}

}  // namespace polhode
