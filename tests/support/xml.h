// SPDX-License-Identifier: MIT
// Documents read strictly, as XML without a DTD: whatever a browser would mend is an error here.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::test {

struct XmlNode {
  std::string name;  ///< empty: a text
  std::string text;
  std::map<std::string, std::string> attributes{};
  std::vector<XmlNode> children{};

  std::string attribute(const std::string& key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? "" : found->second;
  }
  bool has_class(std::string_view wanted) const {
    const std::string all = ' ' + attribute("class") + ' ';
    return all.find(' ' + std::string(wanted) + ' ') != std::string::npos;
  }
};

/// Itself and all below it, in their order.
template <class Do>
void for_each_node(const XmlNode& node, const Do& act) {
  act(node);
  for (const XmlNode& child : node.children) for_each_node(child, act);
}

inline std::vector<const XmlNode*> all_named(const XmlNode& root, std::string_view name) {
  std::vector<const XmlNode*> found;
  for_each_node(root, [&](const XmlNode& node) {
    if (node.name == name) found.push_back(&node);
  });
  return found;
}

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  /// The one element of the document. What script and style hold is text, whatever it is.
  /// @throws std::runtime_error with the place
  XmlNode run() {
    if (text_.starts_with("<?xml ")) at_ = text_.find("?>") + 2;
    blanks();
    skip("<!DOCTYPE html>");
    blanks();
    XmlNode root = element();
    blanks();
    if (at_ != text_.size()) fail("something behind the root");
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(why + " at \"" + std::string(text_.substr(at_, 60)) + '"');
  }
  bool skip(std::string_view what) {
    if (!text_.substr(at_).starts_with(what)) return false;
    at_ += what.size();
    return true;
  }
  void expect(std::string_view what) {
    if (!skip(what)) fail("no " + std::string(what));
  }
  void blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  std::string word() {
    const std::size_t begin = at_;
    const auto is_of_name = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
             c == ':';
    };
    while (at_ < text_.size() && is_of_name(text_[at_])) ++at_;
    if (begin == at_) fail("no name");
    return std::string(text_.substr(begin, at_ - begin));
  }
  std::string characters(char end) {
    static constexpr std::array<std::pair<std::string_view, char>, 5> kReferences = {
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}}};
    std::string all;
    while (at_ < text_.size() && text_[at_] != end) {
      if (text_[at_] == '<') fail("a bare <");
      if (text_[at_] != '&') {
        all += text_[at_++];
        continue;
      }
      const auto* const found = std::find_if(kReferences.begin(), kReferences.end(),
                                             [&](const auto& known) { return skip(known.first); });
      if (found == kReferences.end()) fail("a bare &");
      all += found->second;
    }
    return all;
  }

  XmlNode element() {
    expect("<");
    XmlNode node{word(), {}};
    for (blanks(); !skip(">"); blanks()) {
      if (skip("/>")) return node;
      const std::string key = word();
      expect("=\"");
      if (!node.attributes.emplace(key, characters('"')).second) fail("twice " + key);
      expect("\"");
    }
    const std::string close = "</" + node.name + '>';
    if (node.name == "script" || node.name == "style") {
      const std::size_t end = text_.find(close, at_);
      if (end == std::string_view::npos) fail("no " + close);
      node.children.push_back({"", std::string(text_.substr(at_, end - at_))});
      at_ = end;
    }
    while (!skip(close)) {
      if (at_ >= text_.size()) fail("no " + close);
      if (text_[at_] == '<')
        node.children.push_back(element());
      else
        node.children.push_back({"", characters('<')});
    }
    return node;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

inline XmlNode read_xml(std::string_view text) { return XmlReader(text).run(); }

}  // namespace polhode::test
