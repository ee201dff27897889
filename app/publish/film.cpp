// SPDX-License-Identifier: MIT
#include "app/publish/film.h"

#include "app/publish/ffmpeg.h"
#include "base/files/atomic_file.h"
#include "base/files/left_behind.h"
#include "base/files/temporary_file.h"
#include "render/image/png.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <numeric>

namespace polhode {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// Measured on pages and scenes at 1080p: text and thin lines as in the PNG to the eye.
constexpr const char *kMp4Quality = "17", *kWebmQuality = "24";

fs::path folder_of(const fs::path& file) {
  return file.parent_path().empty() ? fs::path(".") : file.parent_path();
}

/// A file that goes away with it, unless it is given its final name.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(fs::path path) : path_(std::move(path)) {}
  ~UnfinishedFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  const fs::path& path() const { return path_; }
  /// As ffmpeg takes it: a name is never an option or a protocol.
  std::string url() const { return "file:" + path_.string(); }

  /// Flushed to disk first.
  Status rename_to(const fs::path& final_name) {
    const int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = file >= 0 && ::fsync(file) == 0;
    const int error = errno;
    if (file >= 0) ::close(file);
    if (!flushed) return failure(std::strerror(error));
    if (std::rename(path_.c_str(), final_name.c_str()) != 0) return failure(std::strerror(errno));
    return sync_folder(path_.parent_path());
  }

 private:
  fs::path path_;
};

/// From the header alone.
struct Header {
  Size size;
  bool has_alpha = false;
};

Result<Header> header_of(const fs::path& picture) {
  std::array<std::uint8_t, 26> bytes{};
  std::ifstream file(picture, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file || std::memcmp(&bytes[12], "IHDR", 4) != 0)
    return failure("cannot read the picture " + picture.string());
  const auto number = [&](std::size_t at) {
    return bytes[at] << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
  };
  constexpr std::uint8_t kRgba = 6;
  return Header{{number(16), number(20)}, bytes[25] == kRgba};
}

/// What holds all pictures.
Result<Header> frame_of(const FilmRequest& request) {
  Header all;
  for (const fs::path& picture : request.pictures) {
    Result<Header> header = header_of(picture);
    if (!header) return header;
    all.size = {std::max(all.size.width, header->size.width), std::max(all.size.height, header->size.height)};
    all.has_alpha = all.has_alpha || header->has_alpha;
  }
  return all;
}

Size even(Size size) { return {size.width + size.width % 2, size.height + size.height % 2}; }

/// In the middle of `size`; pixels beyond the edge are those of the edge.
Image extended(const Image& image, Size size) {
  if (image.size == size) return image;
  Image to = Image::blank(size);
  const int left = (size.width - image.size.width) / 2, top = (size.height - image.size.height) / 2;
  std::uint8_t* pixel = to.rgba.data();
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x, pixel += 4)
      std::memcpy(pixel,
                  image.pixel(std::clamp(x - left, 0, image.size.width - 1),
                              std::clamp(y - top, 0, image.size.height - 1)),
                  4);
  return to;
}

void lay_on_white(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    std::uint8_t* pixel = &image.rgba[i];
    const int alpha = pixel[3];
    for (int c = 0; c < 3; ++c)
      pixel[c] = static_cast<std::uint8_t>((pixel[c] * alpha + 255 * (255 - alpha) + 127) / 255);
    pixel[3] = 255;
  }
}

/// The same file under two names: pictures that repeat are linked.
bool same_file(const fs::path& a, const fs::path& b) {
  struct stat of_a {
  }, of_b{};
  return ::stat(a.c_str(), &of_a) == 0 && ::stat(b.c_str(), &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
         of_a.st_ino == of_b.st_ino;
}

class Film {
 public:
  Film(const FilmRequest& request, const Header& frame, const InterruptWatch& watch,
       const std::function<void(std::int64_t)>& show)
      : request_(request),
        watch_(watch),
        show_(show),
        kind_(*film_kind_of(request.file)),
        frame_(frame),
        made_(folder_of(request.file) / temporary_name(0)),
        palette_(folder_of(request.file) / temporary_name(1)) {
    if (kind_ == FilmKind::mp4 || kind_ == FilmKind::webm) frame_.size = even(frame_.size);
  }

  Status make() {
    if (kind_ == FilmKind::gif)
      if (Status status = run(join({input(), {"-vf", "palettegen"}, palette_output()})); !status)
        return status;
    if (Status status = run(join({input(), encoding(), {made_.url()}})); !status) return status;
    return made_.rename_to(request_.file);
  }

 private:
  static Words join(std::initializer_list<Words> parts) {
    Words all;
    for (const Words& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
  }

  std::string rate() const { return fmt::format("{}/{}", request_.rate.frames, request_.rate.seconds); }

  /// Pictures a second.
  std::string pace() const {
    const std::int64_t seconds = request_.rate.seconds * request_.frames_each;
    const std::int64_t common = std::gcd(request_.rate.frames, seconds);
    return fmt::format("{}/{}", request_.rate.frames / common, seconds / common);
  }

  Words input() const {
    return {"-f",         "rawvideo",    "-pixel_format",
            "rgba",       "-video_size", fmt::format("{}x{}", frame_.size.width, frame_.size.height),
            "-framerate", pace(),        "-i",
            "pipe:0"};
  }

  Words palette_output() const {
    return {"-frames:v", "1", "-c:v", "png", "-f", "image2pipe", palette_.url()};
  }

  /// The frames themselves say what their colours are: from ffmpeg 7 on nothing else is heard.
  Words yuv(const char* format) const {
    return {"-vf", fmt::format(
                       "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int,"
                       "format={},setparams=colorspace=bt709:color_primaries=bt709:color_trc=bt709:range=tv,"
                       "fps={}",
                       format, rate())};
  }

  Words title() const { return {"-metadata", "title=" + request_.title}; }

  Words encoding() const {
    switch (kind_) {
      case FilmKind::mp4:
        return join({yuv("yuv420p"),
                     {"-c:v", "libx264", "-preset", "medium", "-crf", kMp4Quality, "-movflags", "+faststart"},
                     title(),
                     {"-f", "mp4"}});
      case FilmKind::webm:
        return join({yuv(frame_.has_alpha ? "yuva420p" : "yuv420p"),
                     {"-c:v", "libvpx-vp9", "-crf", kWebmQuality, "-b:v", "0", "-row-mt", "1", "-cpu-used",
                      "4", "-auto-alt-ref", frame_.has_alpha ? "0" : "1"},
                     title(),
                     {"-f", "webm"}});
      case FilmKind::gif:
        return {"-i", palette_.url(), "-lavfi", "[0:v][1:v]paletteuse=diff_mode=rectangle", "-loop",
                "0",  "-f",           "gif"};
      case FilmKind::apng:
        break;
    }
    return join(
        {{"-c:v", "apng", "-pix_fmt", frame_.has_alpha ? "rgba" : "rgb24", "-pred", "sub", "-plays", "0"},
         title(),
         {"-f", "apng"}});
  }

  /// That of a GIF has one bit, which would fray all edges.
  bool keeps_alpha() const { return kind_ == FilmKind::webm || kind_ == FilmKind::apng; }

  Result<Image> frame(const fs::path& picture) const {
    Result<PngFile> file = read_png(picture);
    if (!file) return failure(file.error());
    Image image = extended(file->image, frame_.size);
    if (frame_.has_alpha && !keeps_alpha()) lay_on_white(image);
    return image;
  }

  Status run(const Words& arguments) const {
    Result<Ffmpeg> ffmpeg = Ffmpeg::start(arguments, watch_);
    if (!ffmpeg) return failure(ffmpeg.error());
    const fs::path* before = nullptr;
    Result<Image> image = Image();
    std::int64_t count = 0;
    for (const fs::path& picture : request_.pictures) {
      show_(count);
      if (!before || !same_file(*before, picture)) image = frame(picture);
      if (!image) return failure(image.error());
      before = &picture;
      if (!ffmpeg->feed(image->rgba)) break;
      ++count;
    }
    if (Status ended = ffmpeg->finish(); !ended) return ended;
    if (count < std::ssize(request_.pictures)) return failure("ffmpeg ended before the last picture");
    return success();
  }

  const FilmRequest& request_;
  const InterruptWatch& watch_;
  const std::function<void(std::int64_t)>& show_;
  FilmKind kind_;
  Header frame_;
  UnfinishedFile made_, palette_;
};

}  // namespace

std::optional<FilmKind> film_kind_of(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".mp4") return FilmKind::mp4;
  if (extension == ".webm") return FilmKind::webm;
  if (extension == ".gif") return FilmKind::gif;
  if (extension == ".apng") return FilmKind::apng;
  return std::nullopt;
}

Status write_film(const FilmRequest& request, const InterruptWatch& watch,
                  const std::function<void(std::int64_t)>& show) {
  const auto cannot = [&](const std::string& why) {
    return failure(fmt::format("cannot make the film {}: {}", request.file.string(), why));
  };
  std::error_code error;
  fs::create_directories(folder_of(request.file), error);
  if (error) return cannot(error.message());
  remove_left_behind_in(folder_of(request.file));
  const Result<Header> frame = frame_of(request);
  if (!frame) return cannot(frame.error());
  const Status made = Film(request, *frame, watch, show).make();
  return made ? success() : Status(cannot(made.error()));
}

}  // namespace polhode
