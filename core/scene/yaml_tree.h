/// @file
/// YamlTree: a YAML text as a plain, compact tree in which every node knows
/// its place. It is built from yaml-cpp's events, so that limits hold while
/// the text is read: depth, number of nodes, one document, no tags. Aliases
/// stay references: the tree is never larger than its text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// @name Limits on a YAML text; past them ParseYaml answers with an Error.
/// @{
inline constexpr std::size_t kMaxYamlBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxYamlNodes = std::size_t{16} << 20;
inline constexpr std::size_t kMaxYamlDepth = 256;
/// @}

enum class YamlKind : std::uint8_t { kNull, kScalar, kList, kMap, kAlias };

/// The nodes of one YAML document. A map's children alternate: key, value.
class YamlTree {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNoNode = UINT32_MAX;

  struct Node {
    YamlKind kind = YamlKind::kNull;
    bool quoted = false;
    SourceMark mark;
    Id first_child = kNoNode;
    Id next = kNoNode;    ///< The next child of the same parent.
    Id target = kNoNode;  ///< Of an alias.
    std::uint32_t text_begin = 0;
    std::uint32_t text_size = 0;
  };

  std::vector<Node> nodes;  ///< The root is the first.
  std::string text;         ///< All scalars, one after the other.
};

/// A node of a YamlTree, which must outlive it. An alias shows the content of
/// its target, under its own mark.
class YamlNode {
 public:
  YamlNode(const YamlTree& tree, YamlTree::Id id)
      : tree_(&tree), id_(id), content_(id) {
    if (Here().kind == YamlKind::kAlias) content_ = Here().target;
  }

  YamlKind kind() const { return Content().kind; }
  bool is_scalar() const { return kind() == YamlKind::kScalar; }
  bool is_list() const { return kind() == YamlKind::kList; }
  bool is_map() const { return kind() == YamlKind::kMap; }
  /// Whether a scalar was written in quotes (or as a block): surely a text.
  bool quoted() const { return Content().quoted; }
  SourceMark mark() const { return Here().mark; }
  /// A scalar's text.
  std::string_view text() const {
    return std::string_view(tree_->text)
        .substr(Content().text_begin, Content().text_size);
  }

  bool HasChildren() const {
    return Content().first_child != YamlTree::kNoNode;
  }
  YamlNode FirstChild() const { return {*tree_, Content().first_child}; }
  bool HasNext() const { return Here().next != YamlTree::kNoNode; }
  YamlNode Next() const { return {*tree_, Here().next}; }

  /// What the node is, for messages: `the number-like text 3`, `a list`, ...
  std::string Describe() const;

 private:
  const YamlTree::Node& Here() const { return tree_->nodes[id_]; }
  const YamlTree::Node& Content() const { return tree_->nodes[content_]; }

  const YamlTree* tree_;
  YamlTree::Id id_;
  YamlTree::Id content_;
};

/// Reads one YAML document.
/// @param file names the text in errors.
Result<YamlTree> ParseYaml(const std::string& text, const std::string& file);

/// `file:line:column`, as far as the mark is known.
std::string PlaceOf(const std::string& file, SourceMark mark);

}  // namespace rtb
