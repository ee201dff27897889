// SPDX-License-Identifier: MIT
#include "app/export/picture_export.h"

#include "app/cli/or_fail.h"
#include "app/export/picture_check.h"
#include "app/export/picture_maker.h"
#include "app/export/picture_metadata.h"
#include "app/export/picture_writer.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace fs = std::filesystem;

namespace {

/// What all makers draw with.
struct Studio {
  explicit Studio(ContextKind kind)
      : context(or_fail(open_context(kind))), renderer(or_fail(Renderer::create(*context))) {}
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;  // after the context it draws with
};

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
void check_pictures(const ExportPlan& plan, PictureMaker& maker) {
  const auto same_but_time = [&](std::size_t i, std::size_t k) {
    const PlannedPicture &a = plan.pictures[i], &b = plan.pictures[k];
    return a.stage == b.stage && a.step == b.step && a.equation == b.equation;
  };
  for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
    const bool first = i == 0 || !same_but_time(i - 1, i);
    const bool last = i + 1 == plan.pictures.size() || !same_but_time(i, i + 1);
    if (first || last) maker.check(plan.pictures[i]);
  }
}

FolderState begin(const PictureExport& e, const std::string& renderer) {
  Marker marker{identity_of(e.loaded, e.options), renderer, e.out.resume_all, {}};
  for (const PlannedPicture& picture : e.plan.pictures) marker.files.push_back(picture.file);
  make_folder(e.out.folder);
  return or_fail(begin_in(e.out.folder, marker));
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

Keepable keepable(const PictureExport& e, const FolderState& before) {
  if (!e.out.skip_existing || !before.ours) return {};
  return {true, or_fail(recorded_checksums(e.out.folder, identity_of(e.loaded, e.options)))};
}

/// Draws and puts. @throws Interrupted
void put_pictures(const PictureExport& e, PictureMaker& maker, const Keepable& keepable,
                  const TellProgress& tell, const InterruptWatch& watch, PictureWriter& writer,
                  PicturesMade& made) {
  const PlannedPicture* before = nullptr;  // the one put last
  for (std::size_t place = 0; place < e.plan.pictures.size() && !watch.interrupted(); ++place) {
    if (!e.out.shard.takes(place)) continue;
    const PlannedPicture& picture = e.plan.pictures[place];
    tell(made.count, picture.file);
    const PictureDescription description = maker.describe(picture);
    PngMetadata metadata =
        picture_metadata(e.loaded.lesson, *picture.stage, description.alt, description.t_s, e.options.dpi);
    if (keepable.any) {
      PictureCheck there = check_picture(e.out.folder / picture.file, description.size, metadata);
      if (keepable.takes(picture.file, there)) {
        made.checksums[picture.file] = std::move(there.sha256);
        ++made.count;
        ++made.kept;
        continue;
      }
    }
    const bool repeats = before && maker.same_bytes(*before, picture);
    or_fail(writer.put(
        {picture.file, repeats ? std::nullopt : std::optional(maker.draw(picture)), std::move(metadata)}));
    ++made.count;
    before = &picture;
  }
}

/// Draws and writes until all are there or someone interrupts.
PicturesMade write_pictures(const PictureExport& e, PictureMaker& maker, const Keepable& keepable,
                            const TellProgress& tell, const InterruptWatch& watch) {
  PictureWriter writer(e.out.folder, e.options.png, e.out.durability);
  PicturesMade made;
  try {
    put_pictures(e, maker, keepable, tell, watch, writer, made);
  } catch (const Interrupted&) {  // what was put is written
  }
  or_fail(writer.finish());
  made.checksums.insert(writer.checksums().begin(), writer.checksums().end());
  made.interrupted = made.count < e.out.shard.size(e.plan.pictures.size());
  return made;
}

ManifestFile manifest_file(const PlannedPicture& picture, PictureMaker& maker, const Checksums& checksums) {
  PictureDescription made = maker.describe(picture);
  const auto checksum = checksums.find(picture.file);
  return {picture.file,
          picture.stage->id,
          picture.step,
          picture.frame,
          made.t_s,
          made.size,
          std::move(made.tex),
          std::move(made.alt),
          std::move(made.method),
          checksum == checksums.end() ? "" : checksum->second};
}

/// Of the pictures of a shard. Needs nothing remembered of their drawing but checksums, which are also in the
/// manifests of shards, so that anyone can write the manifest of all.
void write_manifest(const PictureExport& e, PictureMaker& maker, const Shard& shard,
                    const std::string& renderer, const Checksums& checksums, const std::string& name) {
  const auto fill = [&](const AppendBytes& append) -> Status {
    std::string text = manifest_head(identity_of(e.loaded, e.options), renderer);
    const auto flush = [&] {
      const Status appended = append({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
      text.clear();
      return appended;
    };
    bool empty = true;
    for (std::size_t place = 0; place < e.plan.pictures.size(); ++place) {
      if (!shard.takes(place)) continue;
      if (!empty) text += kManifestComma;
      text += manifest_entry(manifest_file(e.plan.pictures[place], maker, checksums));
      empty = false;
      constexpr std::size_t kPiece = 1 << 16;
      if (text.size() < kPiece) continue;
      if (Status flushed = flush(); !flushed) return flushed;
    }
    text += manifest_end(empty);
    return flush();
  };
  bool interrupted = false;
  const auto fill_or_say = [&](const AppendBytes& append) -> Status {
    try {
      return fill(append);
    } catch (const std::exception& error) {
      return failure(error.what());
    } catch (const Interrupted&) {
      interrupted = true;
      return failure("interrupted");
    }
  };
  Status written = replace_file_in_pieces(e.out.folder / name, fill_or_say, Durability::sync);
  if (interrupted) throw Interrupted();
  or_fail(std::move(written));
}

/// A manifest promises the pictures: someone may have removed some, or the folder, meanwhile.
void check_all_are_there(const PictureExport& e, const Shard& shard) {
  for (std::size_t place = 0; place < e.plan.pictures.size(); ++place) {
    const fs::path file = e.out.folder / e.plan.pictures[place].file;
    std::error_code error;
    if (shard.takes(place) && !fs::is_regular_file(file, error))
      throw CommandError(ExitCode::failed,
                         fmt::format("{} is gone: it was removed while the export went on", file.string()));
  }
}

bool has_manifest_of_this(const PictureExport& e) {
  const auto state = look_into(e.out.folder, identity_of(e.loaded, e.options));
  return state && state->finished;
}

/// A shard's manifest; and that of all, if this is the last.
void finish_shard(const PictureExport& e, PictureMaker& maker, PicturesMade& made) {
  write_manifest(e, maker, e.out.shard, made.renderer, made.checksums, shard_manifest_name(e.out.shard));
  const auto of_all = or_fail(summarize_shards(e.out.folder, identity_of(e.loaded, e.options),
                                               e.out.shard.count, e.plan.pictures.size()));
  // Some may be missing because another shard found all of them, or a process without shards came by.
  made.finished = of_all || has_manifest_of_this(e);
  if (!of_all) return;
  made.renderer = of_all->renderer;
  check_all_are_there(e, Shard{});
  write_manifest(e, maker, Shard{}, made.renderer, of_all->checksums, kManifestName);
}

/// After a shard was made again in a folder that was finished. Other bytes come from another driver. It
/// vouches for its own pictures alone: what the manifest says of the others stays, even where they are
/// damaged.
void refresh_manifest(const PictureExport& e, PictureMaker& maker, const PicturesMade& made) {
  const FolderLock lock(e.out.folder);
  const fs::path path = e.out.folder / kManifestName;
  const auto there = or_fail(summarize_manifest(path));
  Checksums of_all = or_fail(checksums_in_manifest(path));
  const auto is_listed = [&](const auto& file) {
    const auto listed = of_all.find(file.first);
    return listed != of_all.end() && listed->second == file.second;
  };
  if (std::all_of(made.checksums.begin(), made.checksums.end(), is_listed)) return;
  for (const auto& [file, sha256] : made.checksums) of_all[file] = sha256;
  write_manifest(e, maker, Shard{}, join_renderers({there ? there->renderer : "", made.renderer}), of_all,
                 kManifestName);
}

void finish(const PictureExport& e, PictureMaker& maker, const FolderState& before, PicturesMade& made) {
  check_all_are_there(e, e.out.shard);
  or_fail(sync_folder(e.out.folder));                                  // a manifest promises the pictures
  or_fail(look_into(e.out.folder, identity_of(e.loaded, e.options)));  // and that nobody else is at them
  // A folder that was finished still is after a shard of it was made again.
  made.finished = e.out.shard.whole() || before.finished;
  if (e.out.shard.whole())
    write_manifest(e, maker, Shard{}, made.renderer, made.checksums, kManifestName);
  else if (before.finished)
    refresh_manifest(e, maker, made);
  else
    finish_shard(e, maker, made);
  if (made.finished) remove_traces(e.out.folder);
}

/// `made` is told what there is also where this throws. @throws Interrupted
void make_pictures(const PictureExport& e, const TellProgress& tell, const InterruptWatch& watch,
                   PicturesMade& made) {
  const Studio studio(e.out.context);
  const auto maker = maker_of({e.loaded.lesson, e.options, *studio.renderer, until_interrupted()});
  check_pictures(e.plan, *maker);
  const std::string mine = studio.renderer->driver();
  const FolderState before = begin(e, mine);
  made = write_pictures(e, *maker, keepable(e, before), tell, watch);
  if (made.interrupted) return;
  const bool kept_all = made.kept == made.count, kept_none = made.kept == 0;
  made.renderer = made.count == 0 ? ""
                  : kept_none     ? mine
                  : kept_all      ? before.renderer
                                  : join_renderers({before.renderer, mine});
  finish(e, *maker, before, made);
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw CommandError(ExitCode::failed,
                       fmt::format("cannot make folder {}: {}", folder.string(), error.message()));
}

ExportIdentity identity_of(const LoadedLesson& loaded, const ExportOptions& options) {
  return {loaded.lesson.id, loaded.sha256, to_json(options)};
}

PicturesMade make_pictures(const PictureExport& e, const TellProgress& tell, const InterruptWatch& watch) {
  PicturesMade made;
  try {
    make_pictures(e, tell, watch, made);
  } catch (const Interrupted&) {
    made.interrupted = true;
  }
  return made;
}

}  // namespace polhode
