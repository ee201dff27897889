// SPDX-License-Identifier: MIT
#include "render/typeset/math/commands.h"

#include <unordered_map>

namespace polhode {
namespace {

using Action = MathCommand::Action;
constexpr auto kOrd = MathClass::ordinary;
constexpr auto kBin = MathClass::binary;
constexpr auto kRel = MathClass::relation;
constexpr auto kOpen = MathClass::opening;
constexpr auto kClose = MathClass::closing;
constexpr auto kPunct = MathClass::punctuation;
constexpr auto kInner = MathClass::inner;

struct Symbol {
  std::string_view name;
  char32_t character;
  MathClass atom = kOrd;
};

constexpr Symbol kSymbols[] = {
    // Greek
    {"alpha", U'α'},
    {"beta", U'β'},
    {"gamma", U'γ'},
    {"delta", U'δ'},
    {"epsilon", U'ϵ'},
    {"varepsilon", U'ε'},
    {"zeta", U'ζ'},
    {"eta", U'η'},
    {"theta", U'θ'},
    {"vartheta", U'ϑ'},
    {"iota", U'ι'},
    {"kappa", U'κ'},
    {"varkappa", U'ϰ'},
    {"lambda", U'λ'},
    {"mu", U'μ'},
    {"nu", U'ν'},
    {"xi", U'ξ'},
    {"omicron", U'ο'},
    {"pi", U'π'},
    {"varpi", U'ϖ'},
    {"rho", U'ρ'},
    {"varrho", U'ϱ'},
    {"sigma", U'σ'},
    {"varsigma", U'ς'},
    {"tau", U'τ'},
    {"upsilon", U'υ'},
    {"phi", U'ϕ'},
    {"varphi", U'φ'},
    {"chi", U'χ'},
    {"psi", U'ψ'},
    {"omega", U'ω'},
    {"Gamma", U'Γ'},
    {"Delta", U'Δ'},
    {"Theta", U'Θ'},
    {"Lambda", U'Λ'},
    {"Xi", U'Ξ'},
    {"Pi", U'Π'},
    {"Sigma", U'Σ'},
    {"Upsilon", U'Υ'},
    {"Phi", U'Φ'},
    {"Psi", U'Ψ'},
    {"Omega", U'Ω'},
    // ordinary
    {"partial", U'∂'},
    {"nabla", U'∇'},
    {"hbar", U'ℏ'},
    {"hslash", U'ℏ'},
    {"ell", U'ℓ'},
    {"imath", U'ı'},
    {"jmath", U'ȷ'},
    {"Re", U'ℜ'},
    {"Im", U'ℑ'},
    {"wp", U'℘'},
    {"aleph", U'ℵ'},
    {"infty", U'∞'},
    {"emptyset", U'∅'},
    {"varnothing", U'∅'},
    {"forall", U'∀'},
    {"exists", U'∃'},
    {"nexists", U'∄'},
    {"neg", U'¬'},
    {"lnot", U'¬'},
    {"top", U'⊤'},
    {"bot", U'⊥'},
    {"angle", U'∠'},
    {"measuredangle", U'∡'},
    {"triangle", U'△'},
    {"square", U'□'},
    {"Box", U'□'},
    {"blacksquare", U'■'},
    {"prime", U'′'},
    {"backslash", U'\\'},
    {"degree", U'°'},
    {"surd", U'√'},
    {"flat", U'♭'},
    {"natural", U'♮'},
    {"sharp", U'♯'},
    {"clubsuit", U'♣'},
    {"diamondsuit", U'♢'},
    {"heartsuit", U'♡'},
    {"spadesuit", U'♠'},
    {"dagger", U'†', kBin},
    {"dag", U'†', kBin},
    {"ddagger", U'‡', kBin},
    {"ddag", U'‡', kBin},
    {"S", U'§'},
    {"P", U'¶'},
    {"pounds", U'£'},
    {"copyright", U'©'},
    {"%", U'%'},
    {"#", U'#'},
    {"&", U'&'},
    {"$", U'$'},
    {"_", U'_'},
    // binary operators
    {"pm", U'±', kBin},
    {"mp", U'∓', kBin},
    {"times", U'×', kBin},
    {"div", U'÷', kBin},
    {"cdot", U'⋅', kBin},
    {"ast", U'∗', kBin},
    {"star", U'⋆', kBin},
    {"circ", U'∘', kBin},
    {"bullet", U'∙', kBin},
    {"oplus", U'⊕', kBin},
    {"ominus", U'⊖', kBin},
    {"otimes", U'⊗', kBin},
    {"oslash", U'⊘', kBin},
    {"odot", U'⊙', kBin},
    {"wedge", U'∧', kBin},
    {"land", U'∧', kBin},
    {"vee", U'∨', kBin},
    {"lor", U'∨', kBin},
    {"cap", U'∩', kBin},
    {"cup", U'∪', kBin},
    {"uplus", U'⊎', kBin},
    {"sqcap", U'⊓', kBin},
    {"sqcup", U'⊔', kBin},
    {"setminus", U'∖', kBin},
    {"smallsetminus", U'∖', kBin},
    {"wr", U'≀', kBin},
    {"amalg", U'⨿', kBin},
    {"diamond", U'⋄', kBin},
    {"ltimes", U'⋉', kBin},
    {"rtimes", U'⋊', kBin},
    {"dotplus", U'∔', kBin},
    {"lhd", U'⊲', kBin},
    {"rhd", U'⊳', kBin},
    {"triangleleft", U'◁', kBin},
    {"triangleright", U'▷', kBin},
    // relations
    {"le", U'≤', kRel},
    {"leq", U'≤', kRel},
    {"ge", U'≥', kRel},
    {"geq", U'≥', kRel},
    {"leqslant", U'⩽', kRel},
    {"geqslant", U'⩾', kRel},
    {"lesssim", U'≲', kRel},
    {"gtrsim", U'≳', kRel},
    {"lessgtr", U'≶', kRel},
    {"lt", U'<', kRel},
    {"gt", U'>', kRel},
    {"ll", U'≪', kRel},
    {"gg", U'≫', kRel},
    {"lll", U'⋘', kRel},
    {"ggg", U'⋙', kRel},
    {"ne", U'≠', kRel},
    {"neq", U'≠', kRel},
    {"equiv", U'≡', kRel},
    {"approx", U'≈', kRel},
    {"approxeq", U'≊', kRel},
    {"sim", U'∼', kRel},
    {"simeq", U'≃', kRel},
    {"cong", U'≅', kRel},
    {"propto", U'∝', kRel},
    {"varpropto", U'∝', kRel},
    {"doteq", U'≐', kRel},
    {"coloneqq", U'≔', kRel},
    {"coloneq", U'≔', kRel},
    {"eqqcolon", U'≕', kRel},
    {"triangleq", U'≜', kRel},
    {"asymp", U'≍', kRel},
    {"in", U'∈', kRel},
    {"ni", U'∋', kRel},
    {"notin", U'∉', kRel},
    {"subset", U'⊂', kRel},
    {"supset", U'⊃', kRel},
    {"subseteq", U'⊆', kRel},
    {"supseteq", U'⊇', kRel},
    {"subsetneq", U'⊊', kRel},
    {"supsetneq", U'⊋', kRel},
    {"sqsubseteq", U'⊑', kRel},
    {"sqsupseteq", U'⊒', kRel},
    {"prec", U'≺', kRel},
    {"succ", U'≻', kRel},
    {"preceq", U'⪯', kRel},
    {"succeq", U'⪰', kRel},
    {"perp", U'⟂', kRel},
    {"parallel", U'∥', kRel},
    {"nparallel", U'∦', kRel},
    {"mid", U'∣', kRel},
    {"nmid", U'∤', kRel},
    {"vdash", U'⊢', kRel},
    {"dashv", U'⊣', kRel},
    {"models", U'⊨', kRel},
    {"because", U'∵', kRel},
    {"therefore", U'∴', kRel},
    {"bowtie", U'⋈', kRel},
    {"smile", U'⌣', kRel},
    {"frown", U'⌢', kRel},
    // arrows
    {"to", U'→', kRel},
    {"rightarrow", U'→', kRel},
    {"leftarrow", U'←', kRel},
    {"gets", U'←', kRel},
    {"leftrightarrow", U'↔', kRel},
    {"uparrow", U'↑', kRel},
    {"downarrow", U'↓', kRel},
    {"updownarrow", U'↕', kRel},
    {"nearrow", U'↗', kRel},
    {"searrow", U'↘', kRel},
    {"swarrow", U'↙', kRel},
    {"nwarrow", U'↖', kRel},
    {"Rightarrow", U'⇒', kRel},
    {"Leftarrow", U'⇐', kRel},
    {"Leftrightarrow", U'⇔', kRel},
    {"Uparrow", U'⇑', kRel},
    {"Downarrow", U'⇓', kRel},
    {"Updownarrow", U'⇕', kRel},
    {"longrightarrow", U'⟶', kRel},
    {"longleftarrow", U'⟵', kRel},
    {"longleftrightarrow", U'⟷', kRel},
    {"Longrightarrow", U'⟹', kRel},
    {"Longleftarrow", U'⟸', kRel},
    {"Longleftrightarrow", U'⟺', kRel},
    {"mapsto", U'↦', kRel},
    {"longmapsto", U'⟼', kRel},
    {"hookrightarrow", U'↪', kRel},
    {"hookleftarrow", U'↩', kRel},
    {"rightharpoonup", U'⇀', kRel},
    {"rightharpoondown", U'⇁', kRel},
    {"leftharpoonup", U'↼', kRel},
    {"leftharpoondown", U'↽', kRel},
    {"rightleftharpoons", U'⇌', kRel},
    {"rightleftarrows", U'⇄', kRel},
    {"circlearrowleft", U'↺', kRel},
    {"circlearrowright", U'↻', kRel},
    {"curvearrowleft", U'↶', kRel},
    {"curvearrowright", U'↷', kRel},
    {"nrightarrow", U'↛', kRel},
    {"nRightarrow", U'⇏', kRel},
    {"leadsto", U'⇝', kRel},
    {"rightsquigarrow", U'⇝', kRel},
    // delimiters
    {"{", U'{', kOpen},
    {"}", U'}', kClose},
    {"lbrace", U'{', kOpen},
    {"rbrace", U'}', kClose},
    {"lbrack", U'[', kOpen},
    {"rbrack", U']', kClose},
    {"langle", U'⟨', kOpen},
    {"rangle", U'⟩', kClose},
    {"lvert", U'|', kOpen},
    {"rvert", U'|', kClose},
    {"vert", U'|'},
    {"lVert", U'‖', kOpen},
    {"rVert", U'‖', kClose},
    {"Vert", U'‖'},
    {"|", U'‖'},
    {"lfloor", U'⌊', kOpen},
    {"rfloor", U'⌋', kClose},
    {"lceil", U'⌈', kOpen},
    {"rceil", U'⌉', kClose},
    {"lgroup", U'⟮', kOpen},
    {"rgroup", U'⟯', kClose},
    // dots and punctuation
    {"ldots", U'…', kInner},
    {"dots", U'…', kInner},
    {"dotsc", U'…', kInner},
    {"mathellipsis", U'…', kInner},
    {"cdots", U'⋯', kInner},
    {"dotsb", U'⋯', kInner},
    {"dotsm", U'⋯', kInner},
    {"dotsi", U'⋯', kInner},
    {"vdots", U'⋮'},
    {"ddots", U'⋱', kInner},
    {"ldotp", U'.', kPunct},
};

struct Large {
  std::string_view name;
  char32_t character;
  Limits limits = Limits::in_display;
};
constexpr Large kLarge[] = {
    {"sum", U'∑'},
    {"prod", U'∏'},
    {"coprod", U'∐'},
    {"int", U'∫', Limits::beside},
    {"iint", U'∬', Limits::beside},
    {"iiint", U'∭', Limits::beside},
    {"oint", U'∮', Limits::beside},
    {"oiint", U'∯', Limits::beside},
    {"oiiint", U'∰', Limits::beside},
    {"bigcap", U'⋂'},
    {"bigcup", U'⋃'},
    {"bigsqcup", U'⨆'},
    {"bigvee", U'⋁'},
    {"bigwedge", U'⋀'},
    {"bigodot", U'⨀'},
    {"bigoplus", U'⨁'},
    {"bigotimes", U'⨂'},
    {"biguplus", U'⨄'},
};

struct Named {
  std::string_view name;
  std::string_view text;
  Limits limits = Limits::beside;
};
constexpr Named kNamed[] = {
    {"sin", "sin"},
    {"cos", "cos"},
    {"tan", "tan"},
    {"cot", "cot"},
    {"sec", "sec"},
    {"csc", "csc"},
    {"arcsin", "arcsin"},
    {"arccos", "arccos"},
    {"arctan", "arctan"},
    {"sinh", "sinh"},
    {"cosh", "cosh"},
    {"tanh", "tanh"},
    {"coth", "coth"},
    {"exp", "exp"},
    {"ln", "ln"},
    {"log", "log"},
    {"lg", "lg"},
    {"arg", "arg"},
    {"dim", "dim"},
    {"deg", "deg"},
    {"hom", "hom"},
    {"ker", "ker"},
    {"tr", "tr"},
    {"det", "det", Limits::in_display},
    {"gcd", "gcd", Limits::in_display},
    {"lim", "lim", Limits::in_display},
    {"liminf", "lim inf", Limits::in_display},
    {"limsup", "lim sup", Limits::in_display},
    {"max", "max", Limits::in_display},
    {"min", "min", Limits::in_display},
    {"inf", "inf", Limits::in_display},
    {"sup", "sup", Limits::in_display},
    {"Pr", "Pr", Limits::in_display},
};

struct Accent {
  std::string_view name;
  char32_t character;
  bool wide = false;
};
constexpr Accent kAccents[] = {
    {"hat", 0x0302},
    {"check", 0x030C},
    {"tilde", 0x0303},
    {"acute", 0x0301},
    {"grave", 0x0300},
    {"dot", 0x0307},
    {"ddot", 0x0308},
    {"dddot", 0x20DB},
    {"ddddot", 0x20DC},
    {"breve", 0x0306},
    {"bar", 0x0304},
    {"mathring", 0x030A},
    {"vec", 0x20D7},
    {"widehat", 0x0302, true},
    {"widetilde", 0x0303, true},
    {"overrightarrow", 0x20D7, true},
    {"overleftarrow", 0x20D6, true},
    {"overleftrightarrow", 0x20E1, true},
};

constexpr double kMu = 1.0 / 18.0;
/// Between words of TeX Gyre Pagella.
constexpr double kWordSpace = 0.25;
struct Amount {
  std::string_view name;
  Action action;
  double amount = 0;
};
constexpr double of(Alphabet a) { return static_cast<double>(a); }
constexpr double of(Face f) { return static_cast<double>(f); }
constexpr Amount kAmounts[] = {
    {",", Action::space, 3 * kMu},
    {"thinspace", Action::space, 3 * kMu},
    {":", Action::space, 4 * kMu},
    {">", Action::space, 4 * kMu},
    {"medspace", Action::space, 4 * kMu},
    {";", Action::space, 5 * kMu},
    {"thickspace", Action::space, 5 * kMu},
    {"!", Action::space, -3 * kMu},
    {"negthinspace", Action::space, -3 * kMu},
    {" ", Action::space, kWordSpace},
    {"space", Action::space, kWordSpace},
    {"enspace", Action::space, 0.5},
    {"quad", Action::space, 1.0},
    {"qquad", Action::space, 2.0},
    {"displaystyle", Action::style, 0},
    {"textstyle", Action::style, 1},
    {"scriptstyle", Action::style, 2},
    {"scriptscriptstyle", Action::style, 3},
    {"mathnormal", Action::alphabet, of(Alphabet::normal)},
    {"mathrm", Action::alphabet, of(Alphabet::upright)},
    {"mathup", Action::alphabet, of(Alphabet::upright)},
    {"symup", Action::alphabet, of(Alphabet::upright)},
    {"mathbf", Action::alphabet, of(Alphabet::bold)},
    {"symbf", Action::alphabet, of(Alphabet::bold)},
    {"mathit", Action::alphabet, of(Alphabet::italic)},
    {"symit", Action::alphabet, of(Alphabet::italic)},
    {"boldsymbol", Action::alphabet, of(Alphabet::bold_italic)},
    {"bm", Action::alphabet, of(Alphabet::bold_italic)},
    {"symbfit", Action::alphabet, of(Alphabet::bold_italic)},
    {"mathbfit", Action::alphabet, of(Alphabet::bold_italic)},
    {"mathcal", Action::alphabet, of(Alphabet::script)},
    {"mathscr", Action::alphabet, of(Alphabet::script)},
    {"mathbb", Action::alphabet, of(Alphabet::blackboard)},
    {"mathfrak", Action::alphabet, of(Alphabet::fraktur)},
    {"mathsf", Action::alphabet, of(Alphabet::sans)},
    {"mathtt", Action::alphabet, of(Alphabet::mono)},
    {"text", Action::text, of(Face::serif)},
    {"textrm", Action::text, of(Face::serif)},
    {"textnormal", Action::text, of(Face::serif)},
    {"mbox", Action::text, of(Face::serif)},
    {"textbf", Action::text, of(Face::serif_bold)},
    {"textit", Action::text, of(Face::serif_italic)},
    {"emph", Action::text, of(Face::serif_italic)},
    {"textsf", Action::text, of(Face::sans)},
    {"texttt", Action::text, of(Face::mono)},
    {"frac", Action::fraction, -1},
    {"dfrac", Action::fraction, 0},
    {"cfrac", Action::fraction, 0},
    {"tfrac", Action::fraction, 1},
    {"binom", Action::binomial, -1},
    {"dbinom", Action::binomial, 0},
    {"tbinom", Action::binomial, 1},
    {"over", Action::infix_over},
    {"choose", Action::infix_choose},
    {"atop", Action::infix_atop},
    {"sqrt", Action::radical},
    {"left", Action::left},
    {"middle", Action::middle},
    {"right", Action::right},
    {"begin", Action::begin},
    {"end", Action::end},
    {"operatorname", Action::operator_name},
    {"textcolor", Action::text_color},
    {"color", Action::color},
    {"term", Action::term},
    {"proved", Action::proved},
    {"live", Action::live},
    {"value", Action::value},
    {"tag", Action::tag},
    {"eqref", Action::reference},
    {"boxed", Action::box},
    {"fbox", Action::box},
    {"phantom", Action::phantom, 3},
    {"hphantom", Action::phantom, 1},
    {"vphantom", Action::phantom, 2},
    {"overset", Action::overset},
    {"underset", Action::underset},
    {"stackrel", Action::stackrel},
    {"not", Action::negate},
    {"hspace", Action::hspace},
    {"mspace", Action::hspace},
    {"substack", Action::substack},
    {"\\", Action::row_end},
    {"cr", Action::row_end},
    {"newline", Action::row_end},
    {"hline", Action::line},
    {"notag", Action::nothing},
    {"nonumber", Action::nothing},
    {"/", Action::nothing},
    {"relax", Action::nothing},
};

constexpr MathCommand kOthers[] = {
    {.name = "overline", .action = Action::bar, .character = U'-'},
    {.name = "underline", .action = Action::bar, .character = U'_'},
    {.name = "overbrace", .action = Action::brace, .character = U'⏞'},
    {.name = "underbrace", .action = Action::brace, .character = U'⏟'},
    {.name = "cancel", .action = Action::cancel, .character = U'/'},
    {.name = "bcancel", .action = Action::cancel, .character = U'\\'},
    {.name = "xcancel", .action = Action::cancel, .character = U'x'},
    {.name = "xrightarrow", .action = Action::arrow, .character = U'→'},
    {.name = "xleftarrow", .action = Action::arrow, .character = U'←'},
    {.name = "xleftrightarrow", .action = Action::arrow, .character = U'↔'},
    {.name = "xRightarrow", .action = Action::arrow, .character = U'⇒'},
    {.name = "xLeftarrow", .action = Action::arrow, .character = U'⇐'},
    {.name = "limits", .action = Action::limits, .limits = Limits::above_below},
    {.name = "nolimits", .action = Action::limits, .limits = Limits::beside},
    {.name = "displaylimits", .action = Action::limits, .limits = Limits::in_display},
    {.name = "mathord", .action = Action::atom, .atom = kOrd},
    {.name = "mathop", .action = Action::atom, .atom = MathClass::large},
    {.name = "mathbin", .action = Action::atom, .atom = kBin},
    {.name = "mathrel", .action = Action::atom, .atom = kRel},
    {.name = "mathopen", .action = Action::atom, .atom = kOpen},
    {.name = "mathclose", .action = Action::atom, .atom = kClose},
    {.name = "mathpunct", .action = Action::atom, .atom = kPunct},
    {.name = "mathinner", .action = Action::atom, .atom = kInner},
    {.name = "big", .action = Action::big, .amount = 1},
    {.name = "bigl", .action = Action::big, .atom = kOpen, .amount = 1},
    {.name = "bigm", .action = Action::big, .atom = kRel, .amount = 1},
    {.name = "bigr", .action = Action::big, .atom = kClose, .amount = 1},
    {.name = "Big", .action = Action::big, .amount = 2},
    {.name = "Bigl", .action = Action::big, .atom = kOpen, .amount = 2},
    {.name = "Bigm", .action = Action::big, .atom = kRel, .amount = 2},
    {.name = "Bigr", .action = Action::big, .atom = kClose, .amount = 2},
    {.name = "bigg", .action = Action::big, .amount = 3},
    {.name = "biggl", .action = Action::big, .atom = kOpen, .amount = 3},
    {.name = "biggm", .action = Action::big, .atom = kRel, .amount = 3},
    {.name = "biggr", .action = Action::big, .atom = kClose, .amount = 3},
    {.name = "Bigg", .action = Action::big, .amount = 4},
    {.name = "Biggl", .action = Action::big, .atom = kOpen, .amount = 4},
    {.name = "Biggm", .action = Action::big, .atom = kRel, .amount = 4},
    {.name = "Biggr", .action = Action::big, .atom = kClose, .amount = 4},
    {.name = "implies", .action = Action::macro, .text = "\\;\\Longrightarrow\\;"},
    {.name = "impliedby", .action = Action::macro, .text = "\\;\\Longleftarrow\\;"},
    {.name = "iff", .action = Action::macro, .text = "\\;\\Longleftrightarrow\\;"},
    {.name = "colon",
     .action = Action::macro,
     .text = "\\mspace{2mu}\\mathpunct{}\\!\\mathord{:}\\mspace{6mu}"},
    {.name = "bmod", .action = Action::macro, .text = "\\mathbin{\\text{mod}}"},
    {.name = "varGamma", .action = Action::macro, .text = "\\mathit{\\Gamma}"},
    {.name = "varDelta", .action = Action::macro, .text = "\\mathit{\\Delta}"},
    {.name = "varTheta", .action = Action::macro, .text = "\\mathit{\\Theta}"},
    {.name = "varLambda", .action = Action::macro, .text = "\\mathit{\\Lambda}"},
    {.name = "varXi", .action = Action::macro, .text = "\\mathit{\\Xi}"},
    {.name = "varPi", .action = Action::macro, .text = "\\mathit{\\Pi}"},
    {.name = "varSigma", .action = Action::macro, .text = "\\mathit{\\Sigma}"},
    {.name = "varUpsilon", .action = Action::macro, .text = "\\mathit{\\Upsilon}"},
    {.name = "varPhi", .action = Action::macro, .text = "\\mathit{\\Phi}"},
    {.name = "varPsi", .action = Action::macro, .text = "\\mathit{\\Psi}"},
    {.name = "varOmega", .action = Action::macro, .text = "\\mathit{\\Omega}"},
};

std::vector<MathCommand> all_commands() {
  std::vector<MathCommand> all;
  for (const Symbol& s : kSymbols) all.push_back({.name = s.name, .character = s.character, .atom = s.atom});
  for (const Large& l : kLarge)
    all.push_back({.name = l.name,
                   .action = Action::large_operator,
                   .character = l.character,
                   .atom = MathClass::large,
                   .limits = l.limits});
  for (const Named& n : kNamed)
    all.push_back({.name = n.name,
                   .action = Action::named_operator,
                   .atom = MathClass::large,
                   .limits = n.limits,
                   .text = n.text});
  for (const Accent& a : kAccents)
    all.push_back({.name = a.name, .action = Action::accent, .character = a.character, .wide = a.wide});
  for (const Amount& a : kAmounts) all.push_back({.name = a.name, .action = a.action, .amount = a.amount});
  all.insert(all.end(), std::begin(kOthers), std::end(kOthers));
  return all;
}

struct Tables {
  std::vector<MathCommand> all = all_commands();
  std::unordered_map<std::string_view, const MathCommand*> by_name;
  std::unordered_map<char32_t, const MathCommand*> by_character;  // the first that makes it

  Tables() {
    for (const MathCommand& c : all) {
      by_name.emplace(c.name, &c);
      if (c.action == Action::symbol || c.action == Action::large_operator)
        by_character.emplace(c.character, &c);
    }
  }
};

const Tables& tables() {
  static const Tables kTables;
  return kTables;
}

struct Environment {
  std::string_view name;
  MathGrid::Kind kind;
  char32_t left = 0, right = 0;
};
constexpr Environment kEnvironments[] = {
    {"matrix", MathGrid::Kind::matrix},
    {"pmatrix", MathGrid::Kind::matrix, U'(', U')'},
    {"bmatrix", MathGrid::Kind::matrix, U'[', U']'},
    {"Bmatrix", MathGrid::Kind::matrix, U'{', U'}'},
    {"vmatrix", MathGrid::Kind::matrix, U'|', U'|'},
    {"Vmatrix", MathGrid::Kind::matrix, U'‖', U'‖'},
    {"smallmatrix", MathGrid::Kind::small},
    {"cases", MathGrid::Kind::cases, U'{'},
    {"rcases", MathGrid::Kind::cases, 0, U'}'},
    {"aligned", MathGrid::Kind::aligned},
    {"align", MathGrid::Kind::aligned},
    {"align*", MathGrid::Kind::aligned},
    {"alignedat", MathGrid::Kind::aligned},
    {"alignat", MathGrid::Kind::aligned},
    {"split", MathGrid::Kind::aligned},
    {"gathered", MathGrid::Kind::gathered},
    {"gather", MathGrid::Kind::gathered},
    {"gather*", MathGrid::Kind::gathered},
    {"array", MathGrid::Kind::array},
};

struct NamedColor {
  std::string_view name;
  unsigned rgb;
};
/// Each reads as text on paper: at least 5.2 : 1 against FBFAF6, white and yellow aside.
constexpr NamedColor kColors[] = {
    {"black", 0x23262B},  {"gray", 0x5F6570},   {"red", 0xB3261E},    {"orange", 0xA84300},
    {"brown", 0x7A4A1E},  {"green", 0x1B7038},  {"teal", 0x006B62},   {"cyan", 0x00687D},
    {"blue", 0x0B5CA8},   {"violet", 0x6B3FA0}, {"purple", 0x7D2E8C}, {"magenta", 0xA3256F},
    {"yellow", 0xE3B505}, {"white", 0xFFFFFF},
};

constexpr std::pair<char32_t, char32_t> kNegations[] = {
    {U'=', U'≠'}, {U'<', U'≮'}, {U'>', U'≯'}, {U'≤', U'≰'}, {U'≥', U'≱'}, {U'∈', U'∉'},
    {U'∋', U'∌'}, {U'≡', U'≢'}, {U'∼', U'≁'}, {U'≈', U'≉'}, {U'≃', U'≄'}, {U'≅', U'≇'},
    {U'⊂', U'⊄'}, {U'⊃', U'⊅'}, {U'⊆', U'⊈'}, {U'⊇', U'⊉'}, {U'∃', U'∄'}, {U'∥', U'∦'},
    {U'∣', U'∤'}, {U'→', U'↛'}, {U'←', U'↚'}, {U'⇒', U'⇏'}, {U'⇔', U'⇎'}, {U'⊢', U'⊬'},
};

template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

}  // namespace

const std::vector<std::string_view>& math_command_names() {
  static const std::vector<std::string_view> kNames = names_of(tables().all);
  return kNames;
}

const MathCommand* math_command(std::string_view name) {
  const auto found = tables().by_name.find(name);
  return found == tables().by_name.end() ? nullptr : found->second;
}

std::string_view name_of_symbol(char32_t character) {
  const auto found = tables().by_character.find(character);
  return found == tables().by_character.end() ? std::string_view() : found->second->name;
}

TypedSymbol typed_symbol(char32_t c) {
  switch (c) {
    case U'-':
    case U'−':
      return {U'−', kBin};
    case U'+':
      return {c, kBin};
    case U'*':
      return {U'∗', kBin};
    case U'·':
      return {U'⋅', kBin};
    case U'=':
    case U'<':
    case U'>':
    case U':':
      return {c, kRel};
    case U'(':
    case U'[':
      return {c, kOpen};
    case U')':
    case U']':
    case U'!':
    case U'?':
      return {c, kClose};
    case U',':
    case U';':
      return {c, kPunct};
    case U'/':
    case U'.':
    case U'|':
      return {c, kOrd};
    case U'`':
      return {U'‘', kOrd};
    default:
      break;
  }
  if (c < 0x80) return {c, kOrd};
  const auto found = tables().by_character.find(c);
  return {c, found == tables().by_character.end() ? kOrd : found->second->atom};
}

char32_t delimiter_of(char32_t c) {
  if (c == U'<') return U'⟨';
  if (c == U'>') return U'⟩';
  constexpr std::u32string_view kDelimiters = U"()[]{}|/\\⟨⟩‖⌊⌋⌈⌉⟮⟯↑↓↕⇑⇓⇕";
  return kDelimiters.find(c) == std::u32string_view::npos ? 0 : c;
}

char32_t negated(char32_t relation) {
  for (const auto& [plain, struck] : kNegations)
    if (plain == relation) return struck;
  return 0;
}

std::optional<MathGrid> math_environment(std::string_view name) {
  for (const Environment& e : kEnvironments) {
    if (e.name != name) continue;
    MathGrid grid;
    grid.kind = e.kind;
    grid.left = e.left;
    grid.right = e.right;
    return grid;
  }
  return std::nullopt;
}

const std::vector<std::string_view>& math_environment_names() {
  static const std::vector<std::string_view> kNames = names_of(kEnvironments);
  return kNames;
}

std::optional<Color> named_color(std::string_view name) {
  for (const NamedColor& color : kColors)
    if (color.name == name) return color_from_hex(color.rgb);
  return std::nullopt;
}

const std::vector<std::string_view>& color_names() {
  static const std::vector<std::string_view> kNames = names_of(kColors);
  return kNames;
}

}  // namespace polhode
