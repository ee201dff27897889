// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/located_text.h"

#include <algorithm>
#include <optional>

namespace polhode {
namespace {

/// Follows a TOML string through the source beside its value. The value is right already; only the places are
/// wanted.
class StringWalk {
 public:
  StringWalk(std::string_view source, std::size_t at, std::string_view value)
      : source_(source), at_(at), value_(value) {}

  std::optional<LocatedText> run() {
    if (at_ >= source_.size()) return std::nullopt;
    const char quote = source_[at_];
    if (quote != '"' && quote != '\'') return std::nullopt;
    const bool multiline = source_.substr(at_, 3) == std::string(3, quote);
    at_ += multiline ? 3 : 1;
    if (multiline && source_.substr(at_, 2) == "\r\n") at_ += 2;
    if (multiline && source_.substr(at_, 1) == "\n") at_ += 1;
    while (done_ < value_.size()) {
      if (at_ >= source_.size() || !(quote == '"' && source_[at_] == '\\' ? escape() : verbatim()))
        return std::nullopt;
    }
    return std::move(located_);
  }

 private:
  bool verbatim() {
    std::size_t size = 0;
    while (done_ + size < value_.size() && at_ + size < source_.size() &&
           source_[at_ + size] == value_[done_ + size] && source_[at_ + size] != '\\')
      ++size;
    if (size == 0) size = source_[at_] == value_[done_] ? 1 : 0;
    if (size == 0) return false;
    located_.append(value_.substr(done_, size), at_);
    at_ += size;
    done_ += size;
    return true;
  }

  bool escape() {
    const std::size_t begin = at_++;
    const char kind = at_ < source_.size() ? source_[at_] : '\0';
    if (kind == '\n' || kind == '\r' || kind == ' ' || kind == '\t') {  // the line goes on
      at_ = std::min(source_.find_first_not_of(" \t\r\n", at_), source_.size());
      return true;
    }
    at_ += kind == 'u' ? 5 : kind == 'U' ? 9 : kind == 'x' ? 3 : 1;
    std::size_t size = 1;  // of the character it stands for
    while (done_ + size < value_.size() &&
           (static_cast<unsigned char>(value_[done_ + size]) & 0xC0U) == 0x80U)
      ++size;
    located_.append_as(value_.substr(done_, size), begin);
    done_ += size;
    return true;
  }

  std::string_view source_;
  std::size_t at_;
  std::string_view value_;
  std::size_t done_ = 0;
  LocatedText located_;
};

}  // namespace

void LocatedText::append(std::string_view bytes, std::size_t offset) { add_piece(bytes, offset, true); }
void LocatedText::append_as(std::string_view bytes, std::size_t offset) { add_piece(bytes, offset, false); }

void LocatedText::add_piece(std::string_view bytes, std::size_t offset, bool verbatim) {
  pieces_.push_back({text_.size(), offset, verbatim});
  text_ += bytes;
}

const LocatedText::Piece* LocatedText::piece_of(std::size_t at) const {
  const auto next =
      std::upper_bound(pieces_.begin(), pieces_.end(), at,
                       [](std::size_t value, const Piece& piece) { return value < piece.begin; });
  return next == pieces_.begin() ? nullptr : &*std::prev(next);
}

std::size_t LocatedText::offset_of(std::size_t at) const {
  const Piece* piece = piece_of(at);
  return piece == nullptr ? 0 : piece->offset + (piece->verbatim ? at - piece->begin : 0);
}

std::size_t LocatedText::end_of_piece(std::size_t at) const {
  const Piece* piece = piece_of(at);
  return piece == nullptr || piece == &pieces_.back() ? text_.size() : piece[1].begin;
}

SourceSpan LocatedText::span_of(std::size_t begin, std::size_t end) const {
  const std::size_t first = offset_of(begin);
  const std::size_t last = end > begin ? offset_of(end - 1) + 1 : first;
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(std::max(first, last))};
}

LocatedText located_string(const SourceText& source, SourcePlace place, std::string_view value) {
  const std::size_t at = source.offset_of(place);
  if (auto located = StringWalk(source.text(), at, value).run()) return std::move(*located);
  LocatedText all;
  all.append_as(value, at);
  return all;
}

}  // namespace polhode
