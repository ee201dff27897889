// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/choice_list.h"

#include "base/ascii.h"
#include "base/sha256.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

namespace polhode {
namespace {

/// What a line of a list opens with.
struct Marker {
  std::size_t size = 0;  ///< in bytes, with the blank behind it
  int number = 0;        ///< of "1. "
  bool has_box = false, is_right = false;
};

std::optional<Marker> marker_of(std::string_view line) {
  if (line.starts_with("- ")) {
    Marker marker{.size = 2};
    const std::string_view box = line.substr(2, 3);
    marker.has_box = box == "[ ]" || box == "[x]" || box == "[X]";
    marker.is_right = marker.has_box && box[1] != ' ';
    if (marker.has_box) marker.size += box.size();
    return marker;
  }
  constexpr std::size_t kMostDigits = 3;
  std::size_t digits = 0;
  while (digits < line.size() && digits <= kMostDigits && is_digit(line[digits])) ++digits;
  if (digits == 0 || digits > kMostDigits || !line.substr(digits).starts_with(". ")) return std::nullopt;
  return Marker{.size = digits + 2, .number = std::stoi(std::string(line.substr(0, digits)))};
}

std::size_t blanks_before(std::string_view line) {
  return std::min(line.find_first_not_of(" \t"), line.size());
}

/// How often a text of three quotes stands in a line: each opens or closes a string of several lines.
std::size_t count_of(std::string_view line, std::string_view quotes) {
  std::size_t count = 0;
  for (std::size_t at = line.find(quotes); at != line.npos; at = line.find(quotes, at + quotes.size()))
    ++count;
  return count;
}

class ListReader {
 public:
  ListReader(int first, int last, Report& report)
      : first_(first), last_(last), source_(report.source()), report_(report) {}

  ChoiceList read() {
    list_.place = {first_, 1};
    list_.is_numbered = marker_of(source_.line(first_))->number > 0;
    for (int line = first_; line <= last_; ++line) take(line);
    end_reply();
    return std::move(list_);
  }

 private:
  void take(int number) {
    const std::string_view line = source_.line(number);
    if (const auto marker = marker_of(line)) return take_item(*marker, number);
    const bool is_blank = blanks_before(line) == line.size();
    if (is_blank || blanks_before(line) > 0) {
      reply_.push_back(number);
      return;
    }
    report_.error({number, 1}, "below a list of choices stand choices and replies only",
                  "indent a reply by two blanks; keys stand above the list");
  }

  void take_item(const Marker& marker, int number) {
    end_reply();
    const std::string_view line = source_.line(number);
    ChoiceList::Item item;
    item.place = {number, 1};
    item.is_right = marker.is_right;
    const int expected = static_cast<int>(list_.items.size()) + 1;
    if ((marker.number > 0) != list_.is_numbered)
      report_.error(item.place, "one list has both boxes and numbers",
                    "- [ ] and - [x] mark choices, 1. 2. 3. an order");
    else if (list_.is_numbered && marker.number != expected)
      report_.error(item.place, "an order is numbered 1, 2, 3 …: this is number " + std::to_string(expected));
    else if (!list_.is_numbered && !marker.has_box)
      report_.error(item.place, "a choice begins with its box", "- [x] the right one, - [ ] the others");
    std::string_view text = line.substr(marker.size);
    text.remove_prefix(blanks_before(text));
    if (text.empty()) report_.error(item.place, "this choice is empty");
    item.text = LocatedText(source_, text);
    list_.items.push_back(std::move(item));
  }

  void end_reply() {
    const auto is_blank = [&](int line) {
      return blanks_before(source_.line(line)) == source_.line(line).size();
    };
    while (!reply_.empty() && is_blank(reply_.back())) reply_.pop_back();
    reply_.erase(reply_.begin(), std::find_if_not(reply_.begin(), reply_.end(), is_blank));
    std::size_t indent = std::string_view::npos;
    for (const int line : reply_)
      if (!is_blank(line)) indent = std::min(indent, blanks_before(source_.line(line)));
    LocatedText& reply = list_.items.empty() ? unread_ : list_.items.back().reply;
    for (const int line : reply_) {
      const std::string_view whole = source_.line(line);
      if (line != reply_.front()) reply.append("\n", source_.begin_of(line) - 1);
      if (is_blank(line)) continue;
      const std::string_view text = whole.substr(indent);
      reply.append(text, source_.offset_of(text));
    }
    reply_.clear();
  }

  int first_, last_;
  const SourceText& source_;
  Report& report_;
  ChoiceList list_;
  std::vector<int> reply_;  ///< lines of the one being read
  LocatedText unread_;
};

}  // namespace

int first_line_of_list(const SourceText& source, int first, int last) {
  bool in_string = false;
  for (int number = first; number <= last; ++number) {
    const std::string_view line = source.line(number);
    if (!in_string && marker_of(line)) return number;
    if ((count_of(line, "'''") + count_of(line, "\"\"\"")) % 2 == 1) in_string = !in_string;
  }
  return last + 1;
}

ChoiceList read_choice_list(int first, int last, Report& report) {
  return ListReader(first, last, report).read();
}

std::vector<std::size_t> shuffled_order(std::string_view lesson_id, std::string_view stage_id,
                                        std::string_view ask_id, std::size_t count) {
  std::string name(lesson_id);
  name.append("/").append(stage_id).append("/").append(ask_id);
  const std::string digest = sha256_hex(name);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Fisher and Yates, each draw from 16 bits of the digest: of at most 16 choices none is favoured by more
  // than 16/65536.
  constexpr std::size_t kDigits = 4;
  for (std::size_t left = count; left > 1; --left) {
    const std::size_t at = (count - left) * kDigits % digest.size();
    const std::size_t drawn = std::stoul(digest.substr(at, kDigits), nullptr, 16) % left;
    std::swap(order[left - 1], order[drawn]);
  }
  return order;
}

}  // namespace polhode
