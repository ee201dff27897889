// SPDX-License-Identifier: MIT
// Collects what is wrong with one lesson.
#pragma once

#include "lessons/diagnostics/diagnostic.h"
#include "lessons/diagnostics/source_text.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// So many errors, and so many warnings, are kept; one more error says that the rest is left out.
inline constexpr std::size_t kMaxDiagnostics = 100;

/// Diagnostics of one text; every place is moved into the text, and nothing is said twice at one place. Holds
/// a reference: the text must live longer.
class Report {
 public:
  Report(const SourceText& source, std::string_view file) : source_(source), file_(file) {}

  void error(SourcePlace place, std::string message, std::string hint = {});
  void warning(SourcePlace place, std::string message, std::string hint = {});
  const SourceText& source() const { return source_; }
  bool has_errors() const { return !errors_.empty(); }
  /// Nothing more is kept: a reader may stop.
  bool is_full() const { return errors_.size() > kMaxDiagnostics; }
  /// All of them in the order of their places.
  std::vector<Diagnostic> take();

 private:
  Diagnostic make(Severity severity, SourcePlace place, std::string message, std::string hint) const;
  static void add(Diagnostic diagnostic, std::vector<Diagnostic>& all);

  const SourceText& source_;
  std::string file_;
  std::vector<Diagnostic> errors_;
  std::vector<Diagnostic> warnings_;
};

/// A name in quotes, printable, shortened if it is very long.
std::string in_quotes(std::string_view name);

}  // namespace polhode
