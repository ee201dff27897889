// SPDX-License-Identifier: MIT
#include "app/publish/zip_file.h"

#include <archive.h>
#include <archive_entry.h>

namespace polhode {

namespace {

struct EntryDeleter {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

constexpr int kPermissions = 0644;  // of who unpacks it

}  // namespace

/// Where libarchive's bytes go, and what was said when they could not. libarchive is not told: once it knows
/// of a failure it no longer gives back all of its memory. What comes behind one goes nowhere.
struct ZipFile::Sink {
  const AppendBytes& append;
  Status status = success();

  static la_ssize_t write(archive* /*of*/, void* self, const void* bytes, std::size_t count) {
    auto& sink = *static_cast<Sink*>(self);
    if (sink.status) sink.status = sink.append({static_cast<const std::uint8_t*>(bytes), count});
    return static_cast<la_ssize_t>(count);
  }
};

ZipFile::ZipFile(const AppendBytes& append)
    : sink_(std::make_unique<Sink>(Sink{append})), archive_(archive_write_new()) {
  if (archive_ == nullptr) return;
  archive_write_set_format_zip(archive_);
  archive_write_set_bytes_in_last_block(archive_, 1);  // or zeros would stand behind the end
  archive_write_open(archive_, sink_.get(), nullptr, Sink::write, nullptr);
}

ZipFile::~ZipFile() {
  if (archive_ == nullptr) return;
  if (sink_->status) sink_->status = failure("the archive was not finished");  // nothing more is written
  archive_write_free(archive_);
}

Status ZipFile::failed() const {
  if (!sink_->status) return sink_->status;
  const char* why = archive_ == nullptr ? nullptr : archive_error_string(archive_);
  return failure(why == nullptr ? "no memory for a zip archive" : why);
}

Status ZipFile::add(const std::string& name, std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<archive_entry, EntryDeleter> entry(archive_entry_new());
  if (archive_ == nullptr || entry == nullptr) return failed();
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), kPermissions);
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
  if (archive_write_header(archive_, entry.get()) != ARCHIVE_OK) return failed();
  const la_ssize_t written = archive_write_data(archive_, bytes.data(), bytes.size());
  return written == static_cast<la_ssize_t>(bytes.size()) && sink_->status ? success() : failed();
}

Status ZipFile::finish() {
  if (archive_ == nullptr || archive_write_close(archive_) != ARCHIVE_OK) return failed();
  if (!sink_->status) return failed();
  archive_write_free(archive_);
  archive_ = nullptr;
  return success();
}

}  // namespace polhode
