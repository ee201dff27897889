// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/prose/quantity_words.h"

#include "base/ascii.h"
#include "lessons/claims/motion_words.h"
#include "lessons/notation/tex_sides.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

/// Stands for the formula of this number in the words of a line.
constexpr char kFormula = '\x01';

struct Said {
  std::string text;  ///< in the language of claims, in brackets where that is needed
  bool is_vector = false;
};

using Pair = std::pair<std::string_view, std::string_view>;

/// What has a name of its own wherever the rotation of a body is written about.
constexpr std::array<Pair, 45> kWords{{
    {"energy", "T"},
    {"kinetic energy", "T"},
    {"rotational energy", "T"},
    {"energy of rotation", "T"},
    {"kinetic energy of rotation", "T"},
    {"kinetic energy of the rotation", "T"},
    {"angular speed", "norm(omega)"},
    {"rate of rotation", "norm(omega)"},
    {"turns per second", "(norm(omega)/(2*pi))"},
    {"turns a second", "(norm(omega)/(2*pi))"},
    {"revolutions per second", "(norm(omega)/(2*pi))"},
    {"number of turns per second", "(norm(omega)/(2*pi))"},
    {"turns per minute", "(30*norm(omega)/pi)"},
    {"turns a minute", "(30*norm(omega)/pi)"},
    {"revolutions per minute", "(30*norm(omega)/pi)"},
    {"one turn", "(2*pi/norm(omega))"},
    {"full turn", "(2*pi/norm(omega))"},
    {"whole turn", "(2*pi/norm(omega))"},
    {"full revolution", "(2*pi/norm(omega))"},
    {"one revolution", "(2*pi/norm(omega))"},
    {"time of one turn", "(2*pi/norm(omega))"},
    {"angular velocity", "omega"},
    {"omega", "omega"},
    {"ω", "omega"},
    {"ω₁", "w1"},
    {"ω₂", "w2"},
    {"ω₃", "w3"},
    {"i₁", "I1"},
    {"i₂", "I2"},
    {"i₃", "I3"},
    {"l", "L"},
    {"angular momentum", "L"},
    {"torque", "N"},
    {"vertical", "ez"},
    {"axis 1", "e1"},
    {"axis 2", "e2"},
    {"axis 3", "e3"},
    {"period of the polhode", "period"},
    {"rate of precession", "precession"},
    {"precession rate", "precession"},
    {"rate of precession in the body", "body_precession"},
    {"half angle of the body cone", "body_cone"},
    {"half-angle of the body cone", "body_cone"},
    {"half angle of the space cone", "space_cone"},
    {"half-angle of the space cone", "space_cone"},
}};

/// The larger and the smaller of two, without a function that says so.
std::string larger(const std::string& a, const std::string& b) {
  return "((" + a + " + " + b + " + sqrt((" + a + " - " + b + ")^2))/2)";
}
std::string smaller(const std::string& a, const std::string& b) {
  return "((" + a + " + " + b + " - sqrt((" + a + " - " + b + ")^2))/2)";
}

/// What is said of a rotation about one of the axes; # is its number.
constexpr std::array<Pair, 14> kAboutAxis{{{"moment", "I#"},
                                           {"moment of inertia", "I#"},
                                           {"principal moment", "I#"},
                                           {"spin", "w#"},
                                           {"rate", "w#"},
                                           {"rate of turn", "w#"},
                                           {"angular speed", "w#"},
                                           {"angular velocity", "w#"},
                                           {"angular momentum", "(I#*w#)"},
                                           {"momentum", "(I#*w#)"},
                                           {"energy", "(I#*w#^2/2)"},
                                           {"kinetic energy", "(I#*w#^2/2)"},
                                           {"energy of the spin", "(I#*w#^2/2)"},
                                           {"energy of rotation", "(I#*w#^2/2)"}}};

constexpr std::array<Pair, 16> kFactors{{{"half of ", "0.5"},
                                         {"half ", "0.5"},
                                         {"one half of ", "0.5"},
                                         {"twice ", "2"},
                                         {"double ", "2"},
                                         {"three times ", "3"},
                                         {"four times ", "4"},
                                         {"five times ", "5"},
                                         {"ten times ", "10"},
                                         {"a third of ", "1/3"},
                                         {"one third of ", "1/3"},
                                         {"two thirds of ", "2/3"},
                                         {"a quarter of ", "0.25"},
                                         {"a fifth of ", "0.2"},
                                         {"a tenth of ", "0.1"},
                                         {"a hundredth of ", "0.01"}}};

class NameReader {
 public:
  NameReader(const std::vector<TextSpan>& spans, const Lesson& lesson, bool by_symbols = true)
      : lesson_(lesson), by_symbols_(by_symbols) {
    for (const TextSpan& span : spans) {
      if (span.kind == TextSpan::Kind::math) {
        words_ += {' ', kFormula, static_cast<char>('0' + formulas_.size()), ' '};
        formulas_.push_back(&span.math);
      } else {
        words_ += in_small_letters(span.text);
        if (span.break_after) words_ += ' ';
      }
    }
    words_ = in_one_line(words_);
  }

  std::optional<Expression> whole(VectorsSaid vectors) const {
    auto said = formulas_.size() > 9 ? std::nullopt : read(words_);
    if (said && vectors == VectorsSaid::as_vectors) said->is_vector = false;
    return said ? expression(*said) : std::nullopt;
  }

  std::optional<Expression> at_end(VectorsSaid vectors) const {
    if (formulas_.size() > 9) return std::nullopt;
    const std::string_view all(words_);
    for (std::size_t begin = 0; begin < all.size(); ++begin) {
      if (begin > 0 && all[begin - 1] != ' ') continue;
      auto said = read(all.substr(begin));
      if (!said) continue;
      if (vectors == VectorsSaid::as_vectors) said->is_vector = false;
      return goes_on_with_name(all.substr(0, begin)) ? std::nullopt : expression(*said);
    }
    return std::nullopt;
  }

 private:
  static std::string in_small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }

  static std::string in_one_line(const std::string& text) {
    std::string line;
    for (std::string_view rest(text); !rest.empty();) {
      if (take_blank(rest)) {
        if (!line.empty() && line.back() != ' ') line += ' ';
        continue;
      }
      line += rest.front();
      rest.remove_prefix(1);
    }
    while (!line.empty() && (line.back() == ' ' || line.back() == ',')) line.pop_back();
    return line;
  }

  std::optional<Expression> expression(const Said& said) const {
    Vocabulary words = lesson_.notation.vocabulary;
    std::map<int, Dimension> dimensions;
    add_motion_words(words, dimensions);
    const std::string text = said.is_vector ? "norm(" + said.text + ')' : said.text;
    const SourceText source(text);
    Report unused(source, "");
    return read_expression(text, {1, 1}, unused, &words);
  }

  static std::string number(const Said& said) {
    return said.is_vector ? "norm(" + said.text + ')' : said.text;
  }
  static Said scalar(std::string text) { return {'(' + std::move(text) + ')', false}; }

  std::optional<Said> read(std::string_view words, int depth = 0) const {
    words = without_blanks(words);
    if (words.empty() || depth > 8) return std::nullopt;
    if (by_symbols_)
      if (auto said = by_lesson(words)) return said;
    for (const std::string_view article :
         {"the ", "its ", "an ", "a ", "total ", "whole ", "body's ", "our ", "this "})
      if (words.starts_with(article))
        if (auto said = read(words.substr(article.size()), depth + 1)) return said;
    if (words.size() == 2 && words[0] == kFormula) return formula(words[1]);
    // Energy may be that of the flight, too.
    for (const std::string_view behind :
         {" of the body", " of a body", " of this body", " vector", " in space"})
      if (words.ends_with(behind) && words.find("energy") == words.npos)
        if (auto said = read(words.substr(0, words.size() - behind.size()), depth + 1)) return said;
    if (auto said = with_factor(words, depth)) return said;
    if (auto said = of_others(words, depth)) return said;
    if (auto said = of_axis(words)) return said;
    if (auto said = moment(words)) return said;
    for (const auto& [name, text] : kWords)
      if (words == name && is_common(name, text)) return Said{std::string(text), is_vector(text)};
    // "the moment $I_2$": whatever the word is, the formula says it.
    if (words.size() > 3 && words[words.size() - 2] == kFormula && is_noun(words.substr(0, words.size() - 3)))
      return formula(words.back());
    return std::nullopt;
  }

  static bool is_axis(std::string_view text) {
    return text == "e1" || text == "e2" || text == "e3" || text == "ez";
  }
  static bool is_vector(std::string_view text) {
    return is_axis(text) || text == "omega" || text == "L" || text == "N";
  }

  static bool is_noun(std::string_view word) {
    constexpr std::array<std::string_view, 9> kNouns{"moment",         "momentum",         "energy",
                                                     "kinetic energy", "angular momentum", "component",
                                                     "length",         "torque",           "angular speed"};
    return std::find(kNouns.begin(), kNouns.end(), word) != kNouns.end();
  }

  /// Where a lesson calls something of its own "total energy", the word "energy" alone is not T. Axes are the
  /// same whatever else is called after them.
  bool is_common(std::string_view name, std::string_view text) const {
    if (!by_symbols_) return name != "energy";  // of a top it has another part
    if (is_axis(text)) return true;
    return std::none_of(lesson_.symbols.begin(), lesson_.symbols.end(), [&](const auto& symbol) {
      return find_quantity(symbol.first) == nullptr && is_named_by(in_small_letters(symbol.second.say), name);
    });
  }

  /// Whether a name is one for a thing of this kind: "total energy" for an energy, "angle between the energy
  /// ellipsoid and axis 3" for neither an energy nor an axis.
  static bool is_named_by(std::string_view say, std::string_view kind) {
    constexpr std::array<std::string_view, 11> kBehindNoun{" of ",    " between ", " from ",   " to ",
                                                           " along ", " about ",   " around ", " in ",
                                                           " on ",    " with ",    " by "};
    std::size_t noun_end = say.size();
    for (const std::string_view preposition : kBehindNoun)
      noun_end = std::min(noun_end, say.find(preposition));
    for (std::size_t at = 0; (at = say.find(kind, at)) < noun_end; ++at) {
      const std::size_t end = at + kind.size();
      const bool begins = at == 0 || !is_letter(say[at - 1]),
                 ends = end == say.size() || !is_letter(say[end]);
      if (begins && ends) return true;
    }
    return false;
  }

  std::optional<Said> by_lesson(std::string_view words) const {
    for (const auto& [name, symbol] : lesson_.symbols) {
      if (in_small_letters(symbol.say) != words) continue;
      const std::string text = symbol.means.empty() ? name : symbol.means;
      const SourceText source(text);
      Report unused(source, "");
      const auto means = read_expression(text, {1, 1}, unused, &lesson_.notation.vocabulary);
      if (!means) return std::nullopt;
      return Said{'(' + text + ')', means->type() == ExpressionType::vector};
    }
    return std::nullopt;
  }

  std::optional<Said> formula(char digit) const {
    const auto side = read_side(*formulas_[static_cast<std::size_t>(digit - '0')], lesson_.notation);
    if (!side) return std::nullopt;
    return Said{'(' + side->text + ')', side->type() == ExpressionType::vector};
  }

  std::optional<Said> with_factor(std::string_view words, int depth) const {
    for (const auto& [words_of, factor] : kFactors)
      if (words.starts_with(words_of))
        if (const auto of = read(words.substr(words_of.size()), depth + 1))
          return scalar(std::string(factor) + '*' + number(*of));
    return std::nullopt;
  }

  /// "ratio of" a "to" b.
  template <class Make>
  std::optional<Said> of_two(std::string_view words, std::string_view before, std::string_view between,
                             int depth, const Make& make) const {
    if (!words.starts_with(before)) return std::nullopt;
    words.remove_prefix(before.size());
    for (std::size_t at = 0; (at = words.find(between, at)) != words.npos; ++at) {
      auto a = read(words.substr(0, at), depth + 1);
      // "of the smallest to the largest moment"
      if (!a && words.ends_with(" moment")) a = read(std::string(words.substr(0, at)) + " moment", depth + 1);
      const auto b = read(words.substr(at + between.size()), depth + 1);
      if (a && b) return make(*a, *b);
    }
    return std::nullopt;
  }

  std::optional<Said> of_others(std::string_view words, int depth) const {
    const auto with = [](const char* sign) {
      return [sign](const Said& a, const Said& b) -> std::optional<Said> {
        return scalar(number(a) + sign + number(b));
      };
    };
    const auto angle = [](const Said& a, const Said& b) -> std::optional<Said> {
      if (!a.is_vector || !b.is_vector) return std::nullopt;
      return scalar("acos(dot(" + a.text + ", " + b.text + ")/(norm(" + a.text + ")*norm(" + b.text + ")))");
    };
    const auto mean = [](const Said& a, const Said& b) -> std::optional<Said> {
      return scalar('(' + number(a) + " + " + number(b) + ")/2");
    };
    const auto component = [](const Said& a, const Said& b) -> std::optional<Said> {
      if (!a.is_vector || !b.is_vector) return std::nullopt;
      const bool is_unit = b.text.starts_with('e');  // an axis
      return scalar("dot(" + a.text + ", " + b.text + ')' + (is_unit ? "" : "/norm(" + b.text + ')'));
    };
    if (auto said = of_two(words, "ratio of ", " to ", depth, with("/"))) return said;
    if (auto said = of_two(words, "ratio of ", " and ", depth, with("/"))) return said;
    if (auto said = of_two(words, "sum of ", " and ", depth, with(" + "))) return said;
    if (auto said = of_two(words, "product of ", " and ", depth, with("*"))) return said;
    if (auto said = of_two(words, "mean of ", " and ", depth, mean)) return said;
    for (const std::string_view between : {"angle between ", "angle of "})
      if (auto said = of_two(words, between, " and ", depth, angle)) return said;
    if (auto said = of_two(words, "angle from ", " to ", depth, angle)) return said;
    if (auto said = of_two(words, "component of ", " along ", depth, component)) return said;
    for (const std::string_view by : {" divided by ", " over "})
      if (auto said = of_two(words, "", by, depth, with("/"))) return said;
    constexpr std::array<Pair, 3> kOrdinals{{{"first", "e1"}, {"second", "e2"}, {"third", "e3"}}};
    for (const auto& [ordinal, axis_of] : kOrdinals) {
      const std::string before = std::string(ordinal) + " component of ";
      if (!words.starts_with(before)) continue;
      const auto of = read(words.substr(before.size()), depth + 1);
      return of && of->is_vector
                 ? std::optional(scalar("dot(" + of->text + ", " + std::string(axis_of) + ')'))
                 : std::nullopt;
    }
    constexpr std::string_view kVertical = "vertical component of ";
    if (words.starts_with(kVertical))
      if (const auto of = read(words.substr(kVertical.size()), depth + 1); of && of->is_vector)
        return scalar("dot(" + of->text + ", ez)");
    if (words.starts_with("ratio ")) return read(words.substr(6), depth + 1);
    for (const std::string_view root :
         {"square of ", "length of ", "magnitude of ", "absolute value of ", "norm of ", "size of "}) {
      if (!words.starts_with(root)) continue;
      const auto of = read(words.substr(root.size()), depth + 1);
      if (!of) return std::nullopt;
      if (root == "square of ") return scalar(number(*of) + "^2");
      return of->is_vector ? scalar(number(*of)) : scalar("sqrt(" + of->text + "^2)");
    }
    return std::nullopt;
  }

  static std::optional<Said> of_axis(std::string_view words) {
    const bool is_axis = words.size() > 1 && words.back() >= '1' && words.back() <= '3';
    if (!is_axis) return std::nullopt;
    const char axis = words.back();
    words.remove_suffix(1);
    for (const std::string_view about : {" about axis ", " about the axis "}) {
      if (!words.ends_with(about)) continue;
      words.remove_suffix(about.size());
      for (const auto& [name, pattern] : kAboutAxis) {
        if (words != name) continue;
        std::string text(pattern);
        std::replace(text.begin(), text.end(), '#', axis);
        return Said{std::move(text), false};
      }
    }
    return std::nullopt;
  }

  static std::optional<Said> moment(std::string_view words) {
    for (const std::string_view of : {" moment of inertia", " principal moment", " moment"}) {
      if (!words.ends_with(of)) continue;
      words.remove_suffix(of.size());
      const std::string most = larger("I1", larger("I2", "I3")), least = smaller("I1", smaller("I2", "I3"));
      if (words == "largest" || words == "greatest") return Said{most, false};
      if (words == "smallest" || words == "least") return Said{least, false};
      if (of != " moment") {
        if (words == "first") return Said{"I1", false};
        if (words == "second") return Said{"I2", false};
        if (words == "third") return Said{"I3", false};
      }
      if (words == "intermediate" || words == "middle")
        return scalar("I1 + I2 + I3 - " + most + " - " + least);
      return std::nullopt;
    }
    return std::nullopt;
  }

  const Lesson& lesson_;
  bool by_symbols_;
  std::string words_;
  std::vector<const Math*> formulas_;
};

}  // namespace

bool goes_on_with_name(std::string_view before) {
  before = without_blanks(before);
  const std::string_view word = before.substr(before.rfind(' ') + 1);
  constexpr std::array<std::string_view, 28> kGoingOn{
      "of",      "and",   "to",    "by",    "between", "over",   "than", "from",   "per",  "times",
      "squared", "along", "plus",  "minus", "with",    "or",     "rate", "change", "mean", "kinetic",
      "its",     "half",  "twice", "as",    "about",   "around", "in",   "for"};
  return std::find(kGoingOn.begin(), kGoingOn.end(), word) != kGoingOn.end();
}

std::vector<TextSpan> stretches_of(const std::string& line) {
  std::vector<TextSpan> stretches;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t open = line.find('$', at);
    const std::size_t close = open == line.npos ? open : line.find('$', open + 1);
    if (close == line.npos || open > at) {
      stretches.emplace_back().text = line.substr(at, close == line.npos ? close : open - at);
      if (close == line.npos) break;
    }
    TextSpan formula;
    formula.text = line.substr(open + 1, close - open - 1);
    if (auto math = parse_math(formula.text)) {
      formula.kind = TextSpan::Kind::math;
      formula.math = std::move(*math);
    }
    stretches.push_back(std::move(formula));
    at = close + 1;
  }
  return stretches;
}

std::optional<char> axis_of_name(const std::string& name) {
  const auto math = parse_math(name);
  std::string words = math ? words_of_formula(*math) : "";
  if (words.empty()) words = name;
  const std::size_t at = words.find("axis ");
  const bool is_one = at != words.npos && words.find("axis ", at + 1) == words.npos && at + 5 < words.size();
  char axis = '\0';
  if (is_one && (at + 6 == words.size() || !is_digit(words[at + 6]))) axis = words[at + 5];
  if (name.size() == 1) axis = name[0];
  if (name.size() > 2 && name[name.size() - 2] == '_' && name.find('_') == name.size() - 2 &&
      name.find_first_of(" +-=/") == name.npos)
    axis = name.back();
  return axis >= '1' && axis <= '3' ? std::optional(axis) : std::nullopt;
}

std::string axes_in(const Expression& expression) {
  std::string axes;
  const std::string& text = expression.text;
  for (std::size_t i = 1; i < text.size(); ++i) {
    const bool is_axis = text[i] >= '1' && text[i] <= '3';
    const bool ends =
        i + 1 == text.size() || (!is_letter(text[i + 1]) && !is_digit(text[i + 1]) && text[i + 1] != '_');
    const bool is_index = is_letter(text[i - 1]) || (i > 1 && text[i - 1] == ' ' && text[i - 2] == ',');
    if (is_axis && ends && is_index) axes += text[i];
  }
  return axes;
}

std::optional<Expression> quantity_said(const std::vector<TextSpan>& name, const Lesson& lesson,
                                        VectorsSaid vectors) {
  return NameReader(name, lesson).whole(vectors);
}

std::optional<Expression> quantity_of_common_name(const std::string& name, const Lesson& lesson) {
  return NameReader(stretches_of(name), lesson, false).whole(VectorsSaid::as_vectors);
}

std::optional<Expression> quantity_said_at_end(const std::vector<TextSpan>& line, const Lesson& lesson,
                                               VectorsSaid vectors) {
  return NameReader(line, lesson).at_end(vectors);
}

}  // namespace polhode
