// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/mark_keys.h"

#include "base/numbers.h"
#include "base/spelling.h"
#include "base/utf8.h"
#include "lessons/claims/expressions/scene_quantities.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/front_matter.h"
#include "lessons/reader/front_matter/toml_text.h"

#include <initializer_list>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace polhode {
namespace {

/// What an overlay shows, by the fingerprint of the quantity.
const std::map<std::string, Overlay>& overlays_by_fingerprint() {
  static const std::map<std::string, Overlay> kOverlays = [] {
    std::map<std::string, Overlay> all;
    for (const auto& [name, overlay] : {std::pair("omega", Overlay::omega), std::pair("L", Overlay::L),
                                        std::pair("N", Overlay::N), std::pair("F", Overlay::F)}) {
      const SourceText source(name);
      Report report(source, "");
      all.emplace(scene_quantity(*read_expression(name, {1, 1}, report), "", "", "").fingerprint, overlay);
    }
    return all;
  }();
  return kOverlays;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t") == text.npos; }

/// What a list is called in messages, and what stands in it.
struct Kind {
  std::string one;      ///< "an arrow"
  std::string example;  ///< a table
};

class MarkReader {
 public:
  MarkReader(Kind kind, const SceneWords& words, TextReader& texts)
      : kind_(std::move(kind)), words_(words), texts_(texts), report_(texts.report()) {}

  /// Has `read` read each table of a list, or one that stands alone. Whether there is a list.
  template <class Read>
  bool read_list(const TomlEntry& entry, const Read& read) {
    const auto* list = entry.value.as<TomlArray>();
    const TomlArray alone{entry.value};
    if (list == nullptr && entry.value.as<TomlTable>() == nullptr) {
      report_.error(
          entry.value.place,
          in_quotes(entry.key) + " takes a list of tables, found " + std::string(entry.value.kind()),
          "for example " + entry.key + " = [" + kind_.example + ']');
      return false;
    }
    if (list != nullptr && list->size() > kMaxMarks) {
      report_.error(entry.value.place, in_quotes(entry.key) + " takes at most " + std::to_string(kMaxMarks) +
                                           ", found " + std::to_string(list->size()));
      return false;
    }
    for (const TomlValue& value : list != nullptr ? *list : alone) {
      if (const auto* table = value.as<TomlTable>())
        read(value.place, *table);
      else
        report_.error(value.place, kind_.one + " is a table, found " + std::string(value.kind()),
                      "for example " + kind_.example);
    }
    return true;
  }

  /// Handles the keys of one table. Whether those that are needed are there.
  bool read_table(SourcePlace place, const TomlTable& table, const std::vector<KeyHandler>& handlers,
                  std::initializer_list<const char*> needed) {
    read_keys(table, kind_.one, handlers, report_);
    bool all = true;
    for (const char* key : needed)
      if (table.find(key) == nullptr) {
        report_.error(place, kind_.one + " has " + in_quotes(key) + ", this one has none",
                      "for example " + kind_.example);
        all = false;
      }
    return all;
  }

  KeyHandler vector(const char* key, std::optional<MarkVector>& vector) {
    return {key, [this, &vector](const TomlEntry& entry) { vector = read_vector(entry); }};
  }

  std::optional<MarkVector> read_vector(const TomlEntry& entry,
                                        std::optional<Dimension>* dimension = nullptr) {
    const auto text = read_text(entry, report_);
    if (!text) return std::nullopt;
    auto read = read_quantity({*text, entry.value.place}, words_, texts_);
    if (!read) return std::nullopt;
    if (!read->quantity.is_vector) {
      report_.error(entry.value.place,
                    in_quotes(entry.key) + " takes a vector, " + in_quotes(*text) + " is none",
                    "for example \"e3\", \"L\" or \"ddt(e3)\"");
      return std::nullopt;
    }
    if (dimension != nullptr) *dimension = read->dimension;
    MarkVector vector{std::move(read->quantity)};
    vector.is_number = read->dimension.value_or(Dimension{}) == Dimension{};
    const auto overlay = overlays_by_fingerprint().find(vector.quantity.fingerprint);
    if (overlay != overlays_by_fingerprint().end()) vector.overlay = overlay->second;
    return vector;
  }

  /// The name of a mark; empty: none.
  std::optional<std::string> read_name(const TomlEntry& entry) {
    auto tex = read_text(entry, report_);
    if (!tex) return tex;
    if (!is_plain_line(*tex)) {
      report_.error(entry.value.place, in_quotes(entry.key) + " is one line without control characters");
      return std::nullopt;
    }
    if (is_blank(*tex)) return "";
    add(texts_.label(located_string(texts_.source(), entry.value.place, *tex)));
    return tex;
  }

  std::optional<std::string> read_note(const TomlEntry& entry) {
    auto text = read_text(entry, report_);
    if (!text) return text;
    if (!is_plain_line(*text) || is_blank(*text)) {
      report_.error(entry.value.place, "a note is one line of text without control characters");
      return std::nullopt;
    }
    if (count_characters(*text) > kMaxNoteCharacters) {
      report_.error(entry.value.place, "a note has at most " + std::to_string(kMaxNoteCharacters) +
                                           " characters, found " + std::to_string(count_characters(*text)));
      return std::nullopt;
    }
    add(texts_.caption(located_string(texts_.source(), entry.value.place, *text)));
    return text;
  }

  /// Empty if there is none such.
  std::string read_role(const TomlEntry& entry) {
    const auto name = read_text(entry, report_);
    const auto& roles = color_roles();
    if (!name || std::find(roles.begin(), roles.end(), *name) != roles.end()) return name.value_or("");
    report_.error(entry.value.place, "unknown role " + in_quotes(*name), suggestion(*name, roles));
    return "";
  }

  Report& report() { return report_; }
  RichText take() { return std::move(written_); }

 private:
  void add(RichText text) {
    for_each_span(text, [this](const TextSpan& span) {
      if (!span.math.live.empty())
        report_.error(texts_.source().place_of(span.source.begin), std::string(kNoNumbersHere));
    });
    std::move(text.begin(), text.end(), std::back_inserter(written_));
  }

  Kind kind_;
  const SceneWords& words_;
  TextReader& texts_;
  Report& report_;
  RichText written_;
};

/// Whether a value that a key has is known.
bool is_read(const TomlTable& table, const char* key, bool has_value) {
  return has_value || table.find(key) == nullptr;
}

std::optional<double> read_length(const TomlEntry& entry, Report& report) {
  const auto length = read_positive_number(entry, report);
  if (!length || (*length >= kLeastArrowLength && *length <= kMostArrowLength)) return length;
  report.error(entry.value.place, "\"length\" must lie between " + digits(kLeastArrowLength, 3) + " and " +
                                      digits(kMostArrowLength, 3) + ": the length of a unit vector is 1");
  return std::nullopt;
}

/// 0 to 1.
double read_part(const TomlEntry& entry, Report& report) {
  const auto part = read_number(entry, report);
  if (part && *part >= 0 && *part <= 1) return *part;
  if (part)
    report.error(entry.value.place, in_quotes(entry.key) + " lies between 0, the tail, and 1, the tip");
  return 1;
}

class ArrowReader {
 public:
  ArrowReader(MarkReader& reader, SourcePlace place, const TomlTable& table)
      : reader_(reader), place_(place), table_(table) {}

  std::optional<ArrowMark> read() {
    std::optional<MarkVector> of, at, like;
    std::optional<Dimension> measure, like_measure;
    std::optional<std::string> tex;
    std::optional<double> length;
    std::string role;
    double name_at = 1;
    Report& report = reader_.report();
    const bool has_all = reader_.read_table(
        place_, table_,
        {{"of", [&](const TomlEntry& e) { of = reader_.read_vector(e, &measure); }},
         reader_.vector("at", at),
         {"tex", [&](const TomlEntry& e) { tex = reader_.read_name(e); }},
         {"length", [&](const TomlEntry& e) { length = read_length(e, report); }},
         {"like", [&](const TomlEntry& e) { like = reader_.read_vector(e, &like_measure); }},
         {"role", [&](const TomlEntry& e) { role = reader_.read_role(e); }},
         {"name_at", [&](const TomlEntry& e) { name_at = read_part(e, report); }}},
        {"of"});
    const TomlEntry* like_entry = table_.find("like");
    if (like_entry != nullptr && table_.find("length") != nullptr)
      report.error(like_entry->place, "an arrow has a length, or is drawn like another, not both",
                   "leave out \"length\" or \"like\"");
    if (measure && like_measure && *measure != *like_measure)
      report.error(like_entry->value.place, "units disagree: " + in_quotes(like->quantity.text) + " is in " +
                                                unit_name(*like_measure) + ", " +
                                                in_quotes(of->quantity.text) + " in " + unit_name(*measure));
    if (!has_all || !of || !is_read(table_, "at", at.has_value()) ||
        !is_read(table_, "like", like.has_value()))
      return std::nullopt;
    if (!role.empty()) of->quantity.role = role;
    return ArrowMark{std::move(*of), std::move(at), std::move(tex), length, std::move(like), role, name_at};
  }

 private:
  static std::string unit_name(const Dimension& dimension) {
    const std::string name = usual_unit(dimension);
    return name.empty() ? "pure numbers" : name;
  }

  MarkReader& reader_;
  SourcePlace place_;
  const TomlTable& table_;
};

/// The two vectors of what lies between them, and the keys that it has besides.
std::optional<std::pair<MarkVector, MarkVector>> read_ends(MarkReader& reader, SourcePlace place,
                                                           const TomlTable& table, const char* lies,
                                                           std::vector<KeyHandler> handlers) {
  std::optional<MarkVector> from, to;
  handlers.insert(handlers.begin(), {reader.vector("from", from), reader.vector("to", to)});
  if (!reader.read_table(place, table, handlers, {"from", "to"}) || !from || !to) return std::nullopt;
  if (from->quantity.fingerprint != to->quantity.fingerprint)
    return std::pair(std::move(*from), std::move(*to));
  reader.report().error(
      table.find("to")->value.place,
      std::string(lies) + " between two vectors, and both are " + in_quotes(to->quantity.text));
  return std::nullopt;
}

using Keys = std::vector<std::pair<std::string, std::string>>;  ///< with their values as TOML

std::string table_text(const Keys& keys) {
  std::string text;
  for (const auto& [key, value] : keys) text += (text.empty() ? "{ " : ", ") + key + " = " + value;
  return text + " }";
}

template <class Mark, class KeysOf>
std::string list_text(const std::vector<Mark>& marks, const KeysOf& keys_of) {
  std::string text;
  for (const Mark& mark : marks) text += (text.empty() ? "[" : ", ") + table_text(keys_of(mark));
  return text.empty() ? "[]" : text + ']';
}

std::string toml_of(const MarkVector& vector) { return toml(vector.quantity.text); }

void add_if(Keys& keys, const char* key, const std::optional<MarkVector>& vector) {
  if (vector) keys.emplace_back(key, toml_of(*vector));
}

}  // namespace

RichText read_trails(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"a trail", "{ of = \"e3\", on = \"sphere\" }"}, words, texts);
  std::vector<TrailMark> trails;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    std::optional<MarkVector> of;
    bool on_sphere = false;
    std::string role;
    const auto on = [&](const TomlEntry& e) {
      const auto name = read_text(e, reader.report());
      on_sphere = name == "sphere";
      if (name && !on_sphere)
        reader.report().error(e.value.place, "unknown \"on\" " + in_quotes(*name),
                              "write \"sphere\", or leave it out: the path of the tip");
    };
    const auto read_role = [&](const TomlEntry& e) { role = reader.read_role(e); };
    if (!reader.read_table(place, table, {reader.vector("of", of), {"on", on}, {"role", read_role}},
                           {"of"}) ||
        !of)
      return;
    if (!role.empty()) of->quantity.role = role;
    trails.push_back({std::move(*of), on_sphere, std::move(role)});
  });
  if (is_list) marks.trails = std::move(trails);
  return reader.take();
}

RichText read_arrows(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"an arrow", "{ of = \"ddt(e3)\", at = \"e3\" }"}, words, texts);
  std::vector<ArrowMark> arrows;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    if (auto arrow = ArrowReader(reader, place, table).read()) arrows.push_back(std::move(*arrow));
  });
  if (is_list) marks.arrows = std::move(arrows);
  return reader.take();
}

RichText read_angles(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"an angle", "{ from = \"ez\", to = \"e3\", tex = '\\theta' }"}, words, texts);
  std::vector<AngleMark> angles;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    std::string tex;
    std::optional<MarkVector> at;
    auto ends = read_ends(reader, place, table, "an angle lies",
                          {{"tex", [&](const TomlEntry& e) { tex = reader.read_name(e).value_or(""); }},
                           reader.vector("at", at)});
    if (ends && is_read(table, "at", at.has_value()))
      angles.push_back({std::move(ends->first), std::move(ends->second), std::move(tex), std::move(at)});
  });
  if (is_list) marks.angles = std::move(angles);
  return reader.take();
}

RichText read_areas(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"an area", "{ from = \"omega\", to = \"L\" }"}, words, texts);
  std::vector<AreaMark> areas;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    AreaMark area;
    auto ends = read_ends(reader, place, table, "an area lies",
                          {{"tex", [&](const TomlEntry& e) { area.tex = reader.read_name(e).value_or(""); }},
                           {"role", [&](const TomlEntry& e) { area.role = reader.read_role(e); }}});
    if (!ends) return;
    std::tie(area.from, area.to) = std::move(*ends);
    areas.push_back(std::move(area));
  });
  if (is_list) marks.areas = std::move(areas);
  return reader.take();
}

RichText read_lines(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"a line", "{ from = \"omega\", to = \"e3\" }"}, words, texts);
  std::vector<LineMark> lines;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    if (auto ends = read_ends(reader, place, table, "a line lies", {}))
      lines.push_back({std::move(ends->first), std::move(ends->second)});
  });
  if (is_list) marks.lines = std::move(lines);
  return reader.take();
}

RichText read_planes(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"a plane", "{ normal = \"L\", through = \"omega\" }"}, words, texts);
  std::vector<PlaneMark> planes;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    std::optional<MarkVector> normal, through;
    if (reader.read_table(place, table, {reader.vector("normal", normal), reader.vector("through", through)},
                          {"normal"}) &&
        normal && is_read(table, "through", through.has_value()))
      planes.push_back({std::move(*normal), std::move(through)});
  });
  if (is_list) marks.planes = std::move(planes);
  return reader.take();
}

RichText read_notes(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts) {
  MarkReader reader({"a note", "{ text = \"nose\", at = \"e3\" }"}, words, texts);
  std::vector<NoteMark> notes;
  const bool is_list = reader.read_list(entry, [&](SourcePlace place, const TomlTable& table) {
    std::optional<std::string> text;
    std::optional<MarkVector> at;
    std::string role;
    const bool has_all =
        reader.read_table(place, table,
                          {{"text", [&](const TomlEntry& e) { text = reader.read_note(e); }},
                           reader.vector("at", at),
                           {"role", [&](const TomlEntry& e) { role = reader.read_role(e); }}},
                          {"text", "at"});
    if (has_all && text && at) notes.push_back({std::move(*text), std::move(*at), std::move(role)});
  });
  if (is_list) marks.notes = std::move(notes);
  return reader.take();
}

std::string text_of(const std::vector<TrailMark>& trails) {
  return list_text(trails, [](const TrailMark& trail) {
    Keys keys{{"of", toml_of(trail.of)}};
    if (trail.on_sphere) keys.emplace_back("on", toml("sphere"));
    if (!trail.role.empty()) keys.emplace_back("role", toml(trail.role));
    return keys;
  });
}

std::string text_of(const std::vector<ArrowMark>& arrows) {
  return list_text(arrows, [](const ArrowMark& arrow) {
    Keys keys{{"of", toml_of(arrow.of)}};
    add_if(keys, "at", arrow.at);
    if (arrow.tex) keys.emplace_back("tex", toml(*arrow.tex));
    if (arrow.length) keys.emplace_back("length", toml(*arrow.length));
    add_if(keys, "like", arrow.like);
    if (!arrow.role.empty()) keys.emplace_back("role", toml(arrow.role));
    if (arrow.name_at != 1) keys.emplace_back("name_at", toml(arrow.name_at));
    return keys;
  });
}

std::string text_of(const std::vector<AngleMark>& angles) {
  return list_text(angles, [](const AngleMark& angle) {
    Keys keys{{"from", toml_of(angle.from)}, {"to", toml_of(angle.to)}};
    if (!angle.tex.empty()) keys.emplace_back("tex", toml(angle.tex));
    add_if(keys, "at", angle.at);
    return keys;
  });
}

std::string text_of(const std::vector<AreaMark>& areas) {
  return list_text(areas, [](const AreaMark& area) {
    Keys keys{{"from", toml_of(area.from)}, {"to", toml_of(area.to)}};
    if (!area.tex.empty()) keys.emplace_back("tex", toml(area.tex));
    if (!area.role.empty()) keys.emplace_back("role", toml(area.role));
    return keys;
  });
}

std::string text_of(const std::vector<LineMark>& lines) {
  return list_text(lines, [](const LineMark& line) {
    return Keys{{"from", toml_of(line.from)}, {"to", toml_of(line.to)}};
  });
}

std::string text_of(const std::vector<PlaneMark>& planes) {
  return list_text(planes, [](const PlaneMark& plane) {
    Keys keys{{"normal", toml_of(plane.normal)}};
    add_if(keys, "through", plane.through);
    return keys;
  });
}

std::string text_of(const std::vector<NoteMark>& notes) {
  return list_text(notes, [](const NoteMark& note) {
    Keys keys{{"text", toml(note.text)}, {"at", toml_of(note.at)}};
    if (!note.role.empty()) keys.emplace_back("role", toml(note.role));
    return keys;
  });
}

}  // namespace polhode
