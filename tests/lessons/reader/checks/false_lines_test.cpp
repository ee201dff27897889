// SPDX-License-Identifier: MIT
// Lines that a reader would see as false, and that were once called proved. Each was found by an attacker.
#include "lessons/reader/checks/claim_check.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::complaints_of;

std::string math(const std::string& kind, const std::string& tex) {
  return "```math a " + kind + "\n" + tex + "\n```\n";
}

struct FalseLine {
  const char *name, *body, *tables;
  const char* scene = "show = [\"omega\"]";
};

class FalseLines : public ::testing::TestWithParam<FalseLine> {};

TEST_P(FalseLines, AreNotCalledProved) {
  const FalseLine& line = GetParam();
  const std::string scene = "```scene\n" + std::string(line.scene) + "\n```\n";
  EXPECT_THAT(complaints_of(line.body + scene, line.tables), ::testing::Not(::testing::IsEmpty()))
      << line.body;
}

const FalseLine kFalseLines[] = {
    {"TwoArrows",
     "```math a identity\nT = 5T \\Rightarrow \\vec N = 0 \\Rightarrow 2T = \\vec\\omega\\cdot\\vec L\n```\n",
     ""},
    {"TwoArrowsFree",
     "```math a free\n\\frac{dT}{dt} = 0 \\Rightarrow \\vec N = 0 \\Rightarrow \\frac{d\\vec L}{dt} = "
     "0\n```\n",
     ""},
    {"GoesOnFromAPart",
     "```math a\n\\proved{2T}+1\n```\n```math b identity\n= \\vec\\omega\\cdot\\vec L\n```\n", ""},
    {"NumberUnderACondition", "```math a free\n\\vec N = 0 \\Rightarrow T = \\live[unit={J}]{T}\n```\n", ""},
    {"NumberBesideAnother",
     "```math a identity\n2T = \\vec\\omega\\cdot\\vec L,\\quad \\omega_1 = \\live[unit={rad/s}]{w1}\n```\n",
     ""},
    {"NumberWhereItsConditionFails",
     "```math a identity\n\\omega_2 = 0\\cdot\\omega_1 = \\live[unit={rad/s}]{w2} \\quad (\\omega_2 = "
     "0)\n```\n",
     ""},
    {"NumberOfADriftingMethod",
     "```math a free\n\\frac{dT}{dt} = 0\\cdot\\frac{dT}{dt} = \\live[unit={W}]{ddt(T)}\n```\n", "",
     "motion = { method = \"explicit-euler\", step = 0.05 }\nat = 3"},
    {"NumberOfABodyThatSlips",
     "```math a law\n\\frac{dT}{dt} = \\vec\\omega\\cdot\\vec N = \\live[unit={W}]{dot(omega, N)}\n```\n", "",
     "torque = \"sink:0.01\""},
    {"CosineOfAConstant", "```math a identity\n\\cos\\gamma = c\n```\n",
     "[constants]\nc = { value = 2, tex = 'c' }\n[define]\ngam = { means = \"acos(c)\", tex = '\\gamma' }\n"},
    {"NotEqual",
     "```math a\n2T \\ne \\vec\\omega\\cdot\\vec L\n```\n```claim a identity\n2*T = dot(omega, L)\n```\n",
     ""},
    {"OtherWords",
     "```math a\n3T = \\vec\\omega\\cdot\\vec L\n```\n```claim a identity in-other-words\n2*T = dot(omega, "
     "L)\n```\n",
     ""},
    {"GoesOnFromASimilarSign", "```math a\nT \\simeq 0\n```\n```math b identity\n= 0\\cdot T\n```\n", ""},
    {"GoesOnFromAnArrow", "```math a\nT \\triangleq 0\n```\n```math b identity\n= 0\\cdot T\n```\n", ""},
    {"InverseCosine", "```math a identity\n\\cos^{-1}\\theta = \\frac{1}{u}\n```\n",
     "[define]\nu = { means = \"dot(ez, e3)\", tex = 'u' }\ntheta = { means = \"acos(u)\", tex = '\\theta' "
     "}\n"},
    {"OfAnInstant",
     "```math a non-sequitur\n\\frac{d\\vec L}{dt} = 0 \\quad\\text{does not give}\\quad \\frac{d^2\\vec "
     "L}{dt^2} = 0\n```\n",
     ""},
    {"SymbolAsIndex", "```math a identity\n\\sum_k k\\,I_k = k\\,I_1 + k\\,I_2 + k\\,I_3\n```\n",
     "[symbols]\nk = { tex = 'k', say = \"k\" }\n"},
    {"TwinsInOtherType", "```math a identity\nE = \\frac{1}{2}\\mathit{E}\n```\n",
     "[symbols]\na = { tex = 'E', means = 'T' }\nb = { tex = '\\mathit{E}', means = '2*T' }\n"},
    {"UnitsInAnInequality", "```math a identity\nT + 1 > 0\n```\n", ""},
    {"UnitsInASum", "```math a identity\nI_1 + \\omega_1 = \\omega_1 + I_1\n```\n", ""},
    {"DegreesOfARadian", "Text.\n", "[define]\nth = { means = \"acos(dot(ez, e3))\", unit = \"deg\" }\n"},
    {"ConstantInGrams", "Text.\n", "[constants]\nm0 = { value = 300, unit = \"g\" }\n"},
    {"HertzOfAnL", "It is $\\live[unit={Hz}]{norm(L)/I1}$.\n", ""},
    {"DegreesOfARatio", "It is $\\live[unit={deg}]{I1/I2}$.\n", ""},
    {"NumberInACaption", "Text.\n", "", "caption = '$T = \\live[unit={J}]{2*T}$'"},
    {"NothingLeftOfANumber", "It is $\\value[unit={J}]{0\\cdot10^{6}}{2*T}$.\n", ""},
    {"NumberInANote", "Text.\n", "", "notes = [{ text = '$\\live{T}$', at = \"e3\" }]"},
    {"MeasuredOverNoTime", "```math a measured\n2T = \\vec\\omega\\cdot\\vec L\n```\n", "",
     "duration = 1e-14"},
    {"PowerOfABrace", "```math a identity\n\\underbrace{T}_{T}^{2} = T\n```\n", ""},
    {"DecimalComma", "```math a identity\n\\frac{5T}{T} = 5{,}0 = 0\n```\n", ""},
    {"ZeroToTheZero", "```math a identity\n0^0 = 1\n```\n", ""},
    {"SignAsASymbol", "Text.\n", "[define]\na = { means = \"2*T\", tex = '\\pm' }\n"},
    {"InfinityAsASymbol", "Text.\n", "[define]\na = { means = \"2*T\", tex = '\\infty' }\n"},
    {"BoldDigitAsASymbol", "Text.\n", "[define]\na = { means = \"2*T\", tex = '\\mathbf 2' }\n"},
    // What stands around a number, in formulas that are no equation as a whole.
    {"FactorBeforeANumber", "It is $2\\live{T}$.\n", ""},
    {"FactorTimesANumber", "It is $2\\cdot\\live{T}$.\n", ""},
    {"FactorBehindANumber", "It is $\\live{T}\\,\\omega_1$.\n", ""},
    {"PrefixBehindANumber", "It is $\\live{T}\\,\\text{kJ}$.\n", ""},
    {"UprightPrefixBehindANumber", "It is $\\live{T}\\,\\mathrm{kJ}$.\n", ""},
    {"OtherUnitBehindANumber", "It is $\\live{T}\\,\\text{W}$.\n", ""},
    {"SecondUnitBehindANumber", "It is $\\live[unit={J}]{T}\\,\\text{s}$.\n", ""},
    {"PrefixBehindTheFormula", "It is $\\live{T}$ kJ.\n", ""},
    {"UnitBehindTheFormula", "It is $\\live{norm(L)}$&nbsp;kg\u00a0m².\n", ""},
    {"DegreesBehindTheFormula", "It is $\\live{acos(dot(ez, e3))}$°.\n", ""},
    {"MillionsBehindTheFormula", "It is $\\live{T}$ million.\n", ""},
    {"SignBeforeTheFormula", "It is −$\\live{T}$ J.\n", ""},
    {"DigitBeforeTheFormula", "It is 2$\\live{T}$ J.\n", ""},
    {"PowerOfTenBehindTheFormula", "It is $\\live{T}$ × 10³ J.\n", ""},
    {"TwoFormulas", "Here $T =$ $\\live{2*T}$ J.\n", ""},
    {"SignInWords", "Here $T$ = $\\live{2*T}$ J.\n", ""},
    {"PowerOfANumber", "It is $\\live{T}^2$.\n", ""},
    {"MinusANumber", "It is $-\\live{T}$.\n", ""},
    {"RootOfANumber", "It is $\\sqrt{\\live{T}}$.\n", ""},
    {"LengthOfANumber", "It is $|\\live{w1}|$.\n", ""},
    {"NumberInAnIndex", "It is $T_{\\live{T}}$.\n", ""},
    {"NumberInALabel", "It is $\\underbrace{\\live{T}}_{5T}$.\n", ""},
    {"WordsBeforeANumber", "Here $T \\text{ is } \\live{2*T}$.\n", ""},
    {"OtherSignBesideANumber", "Here $T \\sim \\live{2*T}$.\n", ""},
    {"NumberInFront", "Here $\\live{2*T} = T$.\n", ""},
    {"TwoNumbers", "Here $\\live{T} = \\live{2*T}$.\n", ""},
    {"NumbersInTheWrongOrder", "Here $\\live{I3} < \\live{I1}$.\n", ""},
    {"NumberBehindWhatIsNotRead", "Here $\\Delta t = T = \\live{2*T}$.\n", ""},
    {"NumberWithAFactorInAChain", "Here $T = 2\\cdot\\live{T}$.\n", ""},
    {"NumberBesideAProvedPart",
     "```math a identity\n\\proved{2T = \\vec\\omega\\cdot\\vec L},\\quad T = \\live{2*T}\n```\n", ""},
    {"NumberPulledBack", "It is $5\\hspace{-1em}\\live{T}$.\n", ""},
    {"NumberInWhite", "It is $\\textcolor{white}{3}\\live{T}$.\n", ""},
    {"CaptionOfTheSecondScene", "Text.\n", "",
     "scenes = [{ caption = 'a' }, { caption = '$T = \\live{2*T}$' }]"},
    {"HalfBeforeTheFormula", "It is ½$\\live{T}$ J.\n", ""},
    {"HalfBehindTheFormula", "It is $\\live{T}$½ J.\n", ""},
    {"FactorBeforeABracket", "It is 2($\\live{T}$) J.\n", ""},
    {"PowerBehindABracket", "It is ($\\live{T}$)² J.\n", ""},
    {"FormulaThatBeginsWithASign", "Here $T$ $= \\live{2*T}$ J.\n", ""},
    {"PercentOfAnEnergy", "It is $\\live{T}\\,\\%$.\n", ""},
    {"TitleOfAPlot", "Text.\n", "", "meters = [{ plot = \"T\", title = '$\\omega_1$' }]"},
    {"NoteAtATip", "Text.\n", "", "notes = [{ text = '$\\vec L$', at = \"omega\" }]"},
    {"ConstantWithASymbol", "Text.\n", "[constants]\nc = 3\n[symbols]\nc = { tex = '\\omega_1' }\n"},
    {"QuantityAsAnotherInText", "Text.\n", "[symbols]\nw1 = { tex = '\\omega_{\\text{2}}' }\n"},
    {"QuantityAsAnotherUnderALongArrow", "Text.\n", "[symbols]\nomega = { tex = '\\overrightarrow{L}' }\n"},
    {"QuantityAsAnotherInUprightType", "Text.\n", "[symbols]\nw1 = { tex = '\\mathrm{T}' }\n"},
    {"RelationInAnIndex", "Text.\n", "[define]\na = { means = \"2*T\", tex = 'T_{=5}' }\n"},
    {"IndexThatNobodySees", "Text.\n", "[define]\na = { means = \"2*T\", tex = 'T_{\\cdot}' }\n"},
    {"GoesOnFromAQuantity", "```math a\nT\n```\n\nand so\n\n```math b\n= \\live{2*T}\\,\\text{J}\n```\n", ""},
    {"ComponentsOfAVector", "Here $\\vec\\omega = (\\live{w2}, \\live{w1}, \\live{w3})$.\n", ""},
    {"ComponentsOfATensor",
     "Here $\\mathbf I = \\begin{pmatrix} \\live{I2} & 0 & 0 \\\\ 0 & \\live{I1} & 0 \\\\ 0 & 0 & \\live{I3} "
     "\\end{pmatrix}$.\n",
     ""},
    {"UnitInWords", "It is $\\live{T}$ kilojoules.\n", ""},
    {"DegreesInWords", "It is $\\live{acos(dot(ez, e3))}$ degrees.\n", ""},
    {"UnitInWordsOfAHead",
     "```table\ncolumns = [{ head = \"\" }, { head = \"energy in kJ\", of = \"T\" }]\nrows = [{ head = \"a\" "
     "}]\n```\n",
     ""},
    {"QuotientAsAHead",
     "```table\ncolumns = [{ head = \"\" }, { head = '$T/\\text{kJ}$', of = \"T\" }]\nrows = [{ head = \"a\" "
     "}]\n```\n",
     ""},
    {"FunctionNamedAsAnother", "Text.\n", "",
     "meters = [{ curve = \"2*x\", x = { of = \"w1\", from = -1, to = 1 }, tex = '\\omega_1' }]"},
    {"UnitInTheTitleOfAPlot", "Text.\n", "", "meters = [{ plot = \"T\", title = '$T$ in kJ' }]"},
    {"ArrowTheOtherWay", "Text.\n", "", "arrows = [{ of = \"-1*L\", tex = '\\vec L' }]"},
    {"LabelAsAVerdict", "> [!note] Here $2T = 5T$.\n", "[labels]\nnote = \"✓ always true\"\n"},
    // Captions that stand once.
    {"CaptionOfAFilmstrip", "Text.\n", "",
     "vary = { omega3 = { from = 1, to = 9 } }\ncaption = 'With $T = \\live[unit={J}]{T}$'"},
    {"TypedCaptionOfAFilmstrip", "Text.\n", "",
     "vary = { omega3 = { from = 1, to = 9 } }\ncaption = 'Spin $\\value{3.0}{w3}$'"},
    {"CaptionOfTwoScenes", "Text.\n", "",
     "scenes = [{ omega = [1, 0, 0] }, { omega = [2, 0, 0] }]\ncaption = 'Spin $\\live{w1}$'"},
    // Heads of tables.
    {"HeadOfAComputedColumn",
     "```table\ncolumns = [{ head = \"\" }, { head = '$T$', of = \"2*T\" }]\nrows = [{ head = \"a\" "
     "}]\n```\n",
     ""},
    {"PlainHeadOfAComputedColumn",
     "```table\ncolumns = [{ head = \"\" }, { head = \"T\", of = \"2*T\" }]\nrows = [{ head = \"a\" "
     "}]\n```\n",
     ""},
    {"UnitInAComputedHead",
     "```table\ncolumns = [{ head = \"\" }, { head = \"energy (kJ)\", of = \"T\" }]\nrows = [{ head = \"a\" "
     "}]\n```\n",
     ""},
    {"SecondUnitInAComputedHead",
     "```table\ncolumns = [{ head = \"\" }, { head = \"energy (kJ)\", of = \"T\", unit = \"J\" }]\nrows = [{ "
     "head "
     "= \"a\" }]\n```\n",
     ""},
    {"HeadOfATypedTable", "| a | $T$ |\n|---|---|\n| b | $\\live{2*T}$ |\n", ""},
    {"HeadOfARow", "| a | b |\n|---|---|\n| $T$ | $\\live{2*T}$ |\n", ""},
    {"UnitInTheHeadOfATypedTable", "| a | energy (kJ) |\n|---|---|\n| b | $\\live{T}$ |\n", ""},
    // Names that read as something else.
    {"CurveNamedAsAnother", "Text.\n", "", "meters = [{ plot = [\"T\"], tex = ['\\omega_1'] }]"},
    {"DefinedCurveNamedAsAnother", "Text.\n", "[define]\nE = { means = \"2*T\", tex = 'E' }\n",
     "meters = [{ plot = [\"E\"], tex = ['T'] }]"},
    {"ArrowNamedAsAnother", "Text.\n", "", "arrows = [{ of = \"omega\", tex = '\\vec L' }]"},
    {"AngleNamedAsAnother", "Text.\n", "[define]\nth = { means = \"acos(dot(ez, e3))\", tex = '\\theta' }\n",
     "angles = [{ from = \"omega\", to = \"L\", tex = '\\theta' }]"},
    {"FootnoteAsAPower", "It is $\\live{T}$[^n].\n\n[^n]: Words.\n", ""},
    {"ConstantAsEnergy", "Text.\n", "[constants]\nc = { value = 2, tex = 'E' }\n"},
    {"ConstantAsAQuantity", "Text.\n",
     "[constants]\nc = 3\n[symbols]\ns = { tex = '\\omega_1', means = 'c' }\n"},
    {"NamedConstantAsAQuantity", "Text.\n", "[constants]\nc = { value = 3, tex = '\\omega_1' }\n"},
    {"ConstantAsAnotherName", "Text.\n",
     "[constants]\nb = { value = 3, tex = 'u' }\n[define]\nu = \"2*T\"\n"},
    {"SymbolAsADifferential", "Text.\n", "[define]\nx = { means = \"2*T\", tex = 'dT' }\n"},
    {"SymbolAsAnUprightDifferential", "Text.\n", "[define]\nx = { means = \"2*T\", tex = '\\mathrm{d}t' }\n"},
    {"RoleWithoutTex", "Text.\n", "[define]\nx = { means = \"2*T\", role = \"L\" }\n"},
    // What is printed is not what is read.
    {"WhiteFactorAboveAClaim",
     "```math a\n\\textcolor{white}{2}T = \\vec\\omega\\cdot\\vec L\n```\n```claim a identity\n2*T = "
     "dot(omega, "
     "L)\n```\n",
     ""},
    {"PrintedOverAboveAClaim",
     "```math a\n2T = \\vec\\omega\\cdot\\vec L\\hspace{-2em}5T\n```\n```claim a identity\n2*T = dot(omega, "
     "L)\n```\n",
     ""},
    {"ChainOfThinSpaces", "```math a identity\n2T = 5\\!\\hspace{0.001em}\\!\\hspace{0.001em}\\!2T\n```\n",
     ""},
    {"LinesOverOneAnother",
     "```math a identity\n\\begin{aligned} T &= T \\\\[-1.3em] T &= T \\end{aligned}\n```\n", ""},
    {"SmallTypeAsAnIndex", "```math a identity\nT\\,I_1 = T{\\scriptstyle I_1}\n```\n", ""},
    {"BraceThatStates", "```math a identity\n\\underbrace{2T}_{\\text{vanishes}} = 2T\n```\n", ""},
    {"BraceThatStatesInUpperCase", "```math a identity\n\\underbrace{2T}_{\\text{IS CONSTANT}} = 2T\n```\n",
     ""},
    {"BraceWithARelation", "```math a identity\n\\underbrace{2T}_{=0} = 2T\n```\n", ""},
    {"ArrowWithALetter", "```math a free\n\\vec N = 0 \\xRightarrow{0} \\frac{dT}{dt} = 0\n```\n", ""},
    {"ArrowThatStates",
     "```math a free\n\\vec N = 0 \\xRightarrow{\\text{T is constant}} \\frac{dT}{dt} = 0\n```\n", ""},
};

INSTANTIATE_TEST_SUITE_P(Of2026, FalseLines, ::testing::ValuesIn(kFalseLines),
                         [](const auto& line) { return std::string(line.param.name); });

// A rule that refuses everything would pass, too.
TEST(TrueLines, AreCalledProved) {
  const std::string scene = "```scene\nshow = [\"omega\"]\n```\n";
  struct Case {
    const char *kind, *tex;
  };
  for (const Case& one : {Case{"identity", "2T = \\vec\\omega\\cdot\\vec L = \\live[unit={J}]{2*T}"},
                          Case{"identity", "\\cos^2\\theta = u^2"}, Case{"identity", "T \\ge 0"},
                          Case{"free", "\\vec N = 0 \\Rightarrow \\frac{dT}{dt} = 0"}})
    EXPECT_THAT(complaints_of(math(one.kind, one.tex) + scene,
                              "[define]\nu = { means = \"dot(ez, e3)\", tex = 'u' }\n"
                              "theta = { means = \"acos(u)\", tex = '\\theta', unit = \"rad\" }\n"),
                ::testing::IsEmpty())
        << one.tex;
}

// Nor may it refuse what an honest author writes around a number.
TEST(TrueLines, AroundNumbersAreAccepted) {
  const std::string scene = "```scene\nshow = [\"omega\"]\n```\n";
  for (const char* text :
       {"It is $\\live{T}$ J.\n",
        "It is $\\live[unit={kJ}]{T}$.\n",
        "It is $\\value{31}{10*3.1}\\,\\%$.\n",
        "See 2 ($\\live{T}$ J), ($\\live{T}$).\n",
        "The energy $= \\live{T}$ J.\n",
        "It is $\\live{norm(L)}$&nbsp;kg m²/s, no less.\n",
        "It is $\\live{T}\\,\\mathrm{kg\\,m^2/s^2}$.\n",
        "It is $\\live{T}\\ \\text{J}$.\n",
        "It is $\\live{norm2(L)}\\,\\mathrm{kg^2\\,m^4/s^2}$.\n",
        "At $\\value{31}{10*3.1}$ %.\n",
        "A rate of $\\live{w1}\\ \\text{s}^{-1}$.\n",
        "Here $T = 2\\cdot\\live{T/2}$.\n",
        "Here $T_{\\text{end}} = \\frac{|\\vec L|^2}{2I_3} = \\live{norm2(L)/(2*I3)}$.\n",
        "Here $I_1 = \\live{I1/I3}\\,I_3$.\n",
        "Here $\\live{I1} \\le \\live{I3}$.\n",
        "Here $\\vec\\omega = (\\live{w1}, \\live{w2}, \\live{w3})$ and $\\vec L = (\\live{dot(L, ex)}, "
        "\\live{dot(L, "
        "ey)}, \\live{dot(L, ez)})$.\n",
        "It leans by $\\live[unit={deg}]{acos(dot(ez, e3))}$, turns at $\\live{w1}$ radians per second, has "
        "$\\live{T}$ "
        "joules in all.\n",
        "```math a\n2T\n```\n\nand so\n\n```math b\n= \\live{2*T}\\,\\text{J}\n```\n",
        "```table\ncolumns = [{ head = \"\" }, { head = '$T/\\text{J}$', of = \"T\" }, { head = \"energy in "
        "J\", of = "
        "\"T\" }]\nrows = [{ head = \"a\" }]\n```\n",
        "It grows by a factor $e^{\\value{3.0}{3}}$.\n",
        "Here $(\\live{w1}, \\live{w2}, \\live{w3})\\,\\text{rad/s}$.\n",
        "Here $\\mathbf I = \\begin{pmatrix} \\live{I1} & 0 & 0 \\\\ 0 & \\live{I2} & 0 \\\\ 0 & 0 & "
        "\\live{I3} \\end{pmatrix}$ in kg m².\n",
        "They are $\\live{I1}$, $\\live{I2}$ and $\\live{I3}$ kg m² – three of them.\n",
        "It is $\\live{I3/I1}$-fold, and 2 of them are $\\live{2*I3/I1}$-fold.\n",
        "| a | $T$ (J) |\n|---|---|\n| b | $\\live{T}$ |\n",
        "| a | b |\n|---|---|\n| $T$ | $\\live{T}$ |\n",
        "```table\ncolumns = [{ head = \"\" }, { head = '$2T$', of = \"dot(omega, L)\", unit = \"J\" }, { "
        "head = "
        "\"energy (J)\", of = \"T\" }, { head = 'change of $T$', of = \"2*T\" }]\nrows = [{ head = \"a\" "
        "}]\n```\n",
        "```math a identity\n2T = \\underbrace{\\vec\\omega\\cdot\\vec L}_{\\text{of the spin}}\n```\n",
        "```math a identity\nT\\!\\cdot 2 = 2\\,T\n```\n"})
    EXPECT_THAT(complaints_of(text + scene), ::testing::IsEmpty()) << text;
  for (const char* shown :
       {"vary = { omega3 = { from = 1, to = 9 } }\ncaption = 'With $I_3 = \\live[unit={kg m²}]{I3}$'",
        "scenes = [{ omega = [1, 0, 0] }, { omega = [2, 0, 0] }]\ncaption = 'Of $\\live{I1}$ kg m²'"})
    EXPECT_THAT(complaints_of("Text.\n```scene\n" + std::string(shown) + "\n```\n"), ::testing::IsEmpty())
        << shown;
  EXPECT_THAT(
      complaints_of("Text.\n" + scene,
                    "[constants]\nE0 = { value = 2, tex = 'E_0', unit = \"J\" }\n[define]\nE = { means = "
                    "\"T + E0\", tex = 'E' }\ndel = { means = \"T - E0\", tex = '\\delta' }\n"),
      ::testing::IsEmpty());
}

}  // namespace
}  // namespace polhode
