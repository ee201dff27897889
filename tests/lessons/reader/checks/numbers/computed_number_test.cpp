// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/numbers/computed_number.h"

#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/reader.h"
#include "tests/lessons/support.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// T = ½ 2·3² = 9 J, and it stays.
constexpr const char* kScene = "\n```scene\nbody = \"spun\"\nomega = [0, 0, 3]\nshow = [\"omega\"]\n```\n";

std::string lesson(const std::string& body, const std::string& scene = kScene) {
  return "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[body.spun]\nmoments = [1.5, 1.5, 2]\n"
         "[define]\nthird = { means = \"acos(0.5)\", unit = \"rad\" }\n[scene]\nat = 1\n+++\n# S {s}\n" +
         body + "\n" + scene;
}

/// What reading and checking say of a text.
std::vector<std::string> faults(const std::string& text) {
  LessonReading reading = read_lesson(text, "a.md");
  if (!reading.lesson) return testing::lines_of(reading.diagnostics);
  prove_claims(*reading.lesson);
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}
std::vector<std::string> faults_of(const std::string& formula) {
  return faults(lesson("a $" + formula + "$ b"));
}

TEST(ComputedNumbers, StandInTextNotesCalloutsTablesCaptionsAndDisplays) {
  EXPECT_THAT(faults(lesson(
                  "a $\\live{T}$ here[^n]\n\n- $\\live{T}$\n\n[^n]: $\\live{T}$\n\n> [!note] $\\live{T}$\n\n"
                  "| a |\n|---|\n| $\\live{T}$ |\n\n```math e\nT = \\live{T}\n```\n",
                  "\n```scene\ncaption = '$\\live[unit={J}]{T}$'\n```\n")),
              IsEmpty());
  const char* kElsewhere =
      "a computed number stands in text, call-outs, footnotes, captions and displays only";
  for (const std::string& body : {std::string("```ask q\ntype = \"choice\"\nprompt = '$\\live{T}$'\nchoices "
                                              "= [\"a\", \"b\"]\nanswer = 1\n```\n"),
                                  std::string("> [!derivation $\\live{T}$] a\n")})
    EXPECT_THAT(faults(lesson(body)), ElementsAre(HasSubstr(kElsewhere))) << body;
  std::string symbol = lesson("a");
  symbol.insert(symbol.find("[scene]"), "[symbols]\nx = { tex = '\\live{T}' }\n");
  EXPECT_THAT(faults(symbol), ElementsAre(HasSubstr(kElsewhere)));
}

TEST(ComputedNumbers, AreReadAtTheirPlaces) {
  EXPECT_THAT(faults_of("\\live{Tt}"), ElementsAre(HasSubstr("13:10: error:")));
  EXPECT_THAT(faults_of("\\live{omega}"),
              ElementsAre(HasSubstr("13:10: error: a computed number is a scalar")));
  EXPECT_THAT(faults_of("\\live{1/(T-T)}"), ElementsAre(HasSubstr("13:10: error: this has no value")));
  EXPECT_THAT(faults(lesson("a $\\live{T}$", "")), ElementsAre(HasSubstr("needs a scene")));
}

TEST(ComputedNumbers, HaveOptions) {
  for (const char* right :
       {R"(\live[digits=5]{T})", R"(\live[unit={J}]{T})", R"(\live[ digits = 15 , unit = {kg m^2/s^2} ]{T})",
        R"(\live[unit=deg]{third})", R"(\live[unit={1}]{third})", R"(\live[]{T})"})
    EXPECT_THAT(faults_of(right), IsEmpty()) << right;
  const auto refuses = [](const std::string& formula, const std::string& says) {
    EXPECT_THAT(faults_of(formula), ElementsAre(HasSubstr(says))) << formula;
  };
  refuses(R"(\live[digit=5]{T})", "13:10: error: unknown option \"digit\" (did you mean digits?)");
  refuses(R"(\live[digits=0]{T})", "13:17: error: digits is a whole number from 1 to 15");
  refuses(R"(\live[digits=16]{T})", "digits is a whole number from 1 to 15");
  refuses(R"(\live[digits=2.5]{T})", "digits is a whole number from 1 to 15");
  refuses(R"(\live[digits]{T})", "digits is a whole number from 1 to 15");
  refuses(R"(\live[digits=2,digits=3]{T})", "13:19: error: the option digits is there twice");
  refuses(R"(\live[unit={}]{T})", "this unit is empty");
  refuses(R"(\live[unit={cal}]{T})", "13:16: error: unknown unit \"cal\"");
  refuses(R"(\live[unit={rad/s}]{T})",
          "13:16: error: units disagree: the expression is kg m²/s², and \"rad/s\" is 1/s");
  refuses(R"(\live[unit=\text{J}]{T})", "are text that ends with ]");
  refuses(R"(\value[digits=3]{9}{T})", "has the digits that it has");
}

TEST(ComputedNumbers, WhatIsTypedIsChecked) {
  for (const char* right : {"9", "9.0", "9.00", "+9", "0.9\\cdot10^{1}", "9\\times10^0"})
    EXPECT_THAT(faults_of(fmt::format("\\value{{{}}}{{T}}", right)), IsEmpty()) << right;
  EXPECT_THAT(faults_of(R"(\value[unit={°}]{60.0}{third})"), IsEmpty());
  EXPECT_THAT(faults_of(R"(\value{1.047}{third})"), IsEmpty());
  EXPECT_THAT(
      faults_of(R"(\value{1.048}{third})"),
      ElementsAre(
          "13:18: error: this number is 1.0472 at t = 1 s, and 1.048 is typed (write \\value{1.047})"));
  EXPECT_THAT(faults_of(R"(\value{8}{T})"), ElementsAre(HasSubstr("(write \\value{9})")));
  EXPECT_THAT(faults_of(R"(\value{-9}{T})"), ElementsAre(HasSubstr("(write \\value{9})")));
  EXPECT_THAT(faults_of(R"(\value{9.1\cdot10^{3}}{1000*T})"),
              ElementsAre(HasSubstr("(write \\value{9.0\\cdot10^{3}})")));
  for (const char* wrong : {"x", "1.2.3", "", "1+1", "9\\cdot10", "\\frac{9}{1}", "9^2"})
    EXPECT_THAT(faults_of(fmt::format("\\value{{{}}}{{T}}", wrong)),
                ElementsAre(HasSubstr("\\value shows a number as it is typed")))
        << wrong;
}

// Half a unit of the last digit is allowed, and no more.
TEST(ComputedNumbers, TypedOnesMayBeRoundedEitherWayInTheMiddle) {
  const auto instead = [](const std::string& typed, double value) {
    ComputedNumber number;
    number.written.typed = typed;
    return right_instead(number, value).value_or("right");
  };
  EXPECT_EQ(instead("0.75", 0.745), "right");
  EXPECT_EQ(instead("0.74", 0.745), "right");
  EXPECT_EQ(instead("0.75", 0.7449), "0.74");
  EXPECT_EQ(instead("1500", 1500.4), "right");
  EXPECT_EQ(instead("1500", 1500.6), "1501");
  EXPECT_EQ(instead("1.5e3", 1549), "right");
  EXPECT_EQ(instead("1.5e3", 1551), "1.6\\cdot10^{3}");
  EXPECT_EQ(instead("-0.1", 0.001), "0.0");
  EXPECT_EQ(instead("2.0e-3", 0.00206), "2.1\\cdot10^{-3}");
}

// On a top that falls the tilt is another at the still than at the start: it is the still that counts.
TEST(ComputedNumbers, TypedOnesAreThoseOfTheStill) {
  const std::string text =
      lesson("$\\value[unit={rad}]{0}{w1}$",
             "\n```scene\nbody = \"spun\"\nomega = [0, 0, 3]\ntorque = \"body:1.5,0,0\"\nat = 0\n```\n");
  EXPECT_THAT(faults(text), ElementsAre(HasSubstr("units disagree")));
  const auto at = [](const char* time, const char* typed) {
    return faults(lesson(
        fmt::format("$\\value{{{}}}{{w3}}$", typed),
        fmt::format("\n```scene\nbody = \"spun\"\nomega = [0, 0, 3]\ntorque = \"body:0,0,2\"\nat = {}\n```\n",
                    time)));
  };
  EXPECT_THAT(at("0", "3.0"), IsEmpty());  // dω3/dt = 2/2 = 1 rad/s²
  EXPECT_THAT(at("0.5", "3.5"), IsEmpty());
  EXPECT_THAT(at("0.5", "3.0"), SizeIs(1));
}

TEST(ComputedNumbers, AreAsManyAsALessonMayHave) {
  std::string text;
  for (std::size_t i = 0; i < kMaxNumbers; ++i)
    text += "$\\live{T}$" + std::string(i % 100 == 99 ? "\n\n---\n\n" : " ");
  text += "a";
  EXPECT_THAT(read_lesson(lesson(text), "a.md").diagnostics, IsEmpty());
  EXPECT_THAT(faults(lesson(text + " $\\live{T}$")), ElementsAre(HasSubstr("at most 1000 computed numbers")));
}

// The examples of the format.
TEST(ComputedNumbers, AreWrittenAsTheFormatSays) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  for (const char* heading : {"\n### Tables\n", "\n### Computed numbers\n"}) {
    const std::string opening = "\n````markdown\n";
    const std::size_t begin = format.find(opening, format.find(heading)) + opening.size();
    std::string text = lesson(format.substr(begin, format.find("\n````\n", begin) - begin));
    text.insert(text.find("[scene]"), "theta = { means = \"acos(dot(ez, e3))\", unit = \"rad\" }\n");
    EXPECT_THAT(faults(text), IsEmpty()) << heading;
  }
}

TEST(ComputedNumbers, AreProvedAtTheEndOfAChain) {
  const auto said = [](const std::string& number) {
    return faults(lesson("```math e identity\n2T = \\vec\\omega\\cdot\\vec L = " + number + "\n```\n"));
  };
  EXPECT_THAT(said("\\live[unit={J}]{2*T}"), IsEmpty());
  EXPECT_THAT(said("\\value[unit={J}]{18}{2*T}"), IsEmpty());
  EXPECT_THAT(said("\\value[unit={J}]{9}{T}"), SizeIs(1)) << "not 2T";
}

// 2026-11-23: what stood behind a number was taken for its unit, and a rounded number for a bound.
TEST(ComputedNumbers, ProveNothingByWhatStandsAroundThem) {
  const auto said = [](const std::string& tex) {
    return faults(lesson("```math e identity\n" + tex + "\n```\n"));
  };
  for (const char* behind : {R"(\ \mathrm{mJ})", R"(\ \text{or more})", R"(\,\text{J})", R"(\ \text{m}^2)"})
    EXPECT_THAT(said(R"(2T = \vec\omega\cdot\vec L = \live[unit={J}]{2*T})" + std::string(behind)), SizeIs(1))
        << behind;
  for (const char* bound : {R"(2T \le \value[unit={J}]{18}{2*T})", R"(T \ge \live{T})", R"(0 < \live{T})"})
    EXPECT_THAT(said(bound), ElementsAre(HasSubstr("a rounded number is neither"))) << bound;
  EXPECT_THAT(said(R"(T = \live{T})"), ElementsAre(HasSubstr("only a computed number stands here")));
}

TEST(ComputedNumbers, OfRadiansAreNotInHertz) {
  const auto said = [](const std::string& number) { return faults(lesson("It is $" + number + "$.\n")); };
  EXPECT_THAT(said("\\live[unit={rad/s}]{w1}"), IsEmpty());
  EXPECT_THAT(said("\\live[unit={Hz}]{w1/(2*pi)}"), IsEmpty());
  for (const char* rate : {"w1", "norm(omega)", "2*body_precession"})
    EXPECT_THAT(said("\\live[unit={Hz}]{" + std::string(rate) + "}"),
                ElementsAre(HasSubstr("by 2*pi, in Hz")));
}

/// A table of one row, whose number is |ω|.
std::string table_of(const std::string& head) {
  return lesson(
      "a\n\n```table\ncolumns = [{ head = \"case\" }, { head = \"rate\", of = \"norm(omega)\", unit = "
      "\"rad/s\" }]\nrows = [{ head = '" +
      head + "', at = 1 }]\n```\n");
}

// 29 November 2026: the assertions of the standard library found that the dimension of h was read, which a
// step of any size does not have.
TEST(ComputedNumbers, HaveTheDimensionThatTheHeadOfTheirRowSaysIfItSaysOne) {
  EXPECT_THAT(faults(table_of("$h$")), IsEmpty());
  EXPECT_THAT(faults(table_of("$|\\vec\\omega|$")), IsEmpty());
  EXPECT_THAT(faults(table_of("$T$")), ElementsAre(HasSubstr("the head of a row says")));
}

}  // namespace
}  // namespace polhode
