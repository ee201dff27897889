// SPDX-License-Identifier: MIT
#include "lessons/diagnostics/report.h"

#include "base/printable.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace polhode {
namespace {

constexpr std::size_t kMaxQuotedBytes = 48;

}  // namespace

Diagnostic Report::make(Severity severity, SourcePlace place, std::string message, std::string hint) const {
  return {severity, file_, source_.clamp(place), std::move(message), std::move(hint)};
}

/// A text may be read more than once: scenes side by side are, wherever what they share changes.
void Report::add(Diagnostic diagnostic, std::vector<Diagnostic>& all) {
  const auto is_same = [&](const Diagnostic& other) {
    return other.place.line == diagnostic.place.line && other.place.column == diagnostic.place.column &&
           other.message == diagnostic.message;
  };
  if (std::none_of(all.begin(), all.end(), is_same)) all.push_back(std::move(diagnostic));
}

void Report::error(SourcePlace place, std::string message, std::string hint) {
  if (is_full()) return;
  if (errors_.size() == kMaxDiagnostics) {
    message = "too many errors, the rest is left out";
    hint = "";
  }
  add(make(Severity::error, place, std::move(message), std::move(hint)), errors_);
}

void Report::warning(SourcePlace place, std::string message, std::string hint) {
  if (warnings_.size() >= kMaxDiagnostics) return;
  add(make(Severity::warning, place, std::move(message), std::move(hint)), warnings_);
}

std::vector<Diagnostic> Report::take() {
  std::vector<Diagnostic> all = std::move(errors_);
  std::move(warnings_.begin(), warnings_.end(), std::back_inserter(all));
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  return all;
}

std::string in_quotes(std::string_view name) {
  if (name.size() <= kMaxQuotedBytes) return '"' + printable_line(name) + '"';
  std::size_t end = kMaxQuotedBytes;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;  // keep characters whole
  return '"' + printable_line(name.substr(0, end)) + "…\"";
}

}  // namespace polhode
