#include "core/scene/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <optional>
#include <sstream>
#include <utility>

#include "core/scene/yaml_text.h"

namespace rtb {
namespace {

SourceMark ToSourceMark(const YAML::Mark& mark) {
  return {mark.line + 1, mark.column + 1};
}

/// Builds the tree from yaml-cpp's events. After the first error it takes in
/// nothing more.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& file) : file_(file) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) {
      Stop(ToSourceMark(mark), "a second YAML document begins, expected one",
           "remove the line `---` and what follows it");
    }
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Add(YamlKind::kNull, mark, anchor);
    if (error_ || open_.empty()) return;
    // A value that is not there has the place of its key.
    const Level& level = open_.back();
    if (level.previous == YamlTree::kNoNode) return;
    const SourceMark key = tree_.nodes[level.previous].mark;
    SourceMark& place = tree_.nodes.back().mark;
    if (level.is_map && level.count % 2 == 0 && place.line != key.line) {
      place = key;
    }
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const YamlTree::Id id = Add(YamlKind::kAlias, mark, YAML::NullAnchor);
    if (error_) return;
    tree_.nodes[id].target = anchors_[anchor];
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag,
                YAML::anchor_t anchor, const std::string& value) override {
    const YamlTree::Id id = Add(YamlKind::kScalar, mark, anchor, tag);
    if (error_) return;
    YamlTree::Node& node = tree_.nodes[id];
    node.quoted = tag == "!";
    node.text_begin = static_cast<std::uint32_t>(tree_.text.size());
    node.text_size = static_cast<std::uint32_t>(value.size());
    tree_.text += value;
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                       YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Open(Add(YamlKind::kList, mark, anchor, tag), false);
  }
  void OnSequenceEnd() override { Close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag,
                  YAML::anchor_t anchor, YAML::EmitterStyle::value) override {
    Open(Add(YamlKind::kMap, mark, anchor, tag), true);
  }
  void OnMapEnd() override { Close(); }

  const std::optional<Error>& error() const { return error_; }
  YamlTree& tree() { return tree_; }

 private:
  /// A list or map that is not complete yet.
  struct Level {
    YamlTree::Id id;
    bool is_map;
    YamlTree::Id last = YamlTree::kNoNode;      ///< Its newest child.
    YamlTree::Id previous = YamlTree::kNoNode;  ///< The child before that.
    std::size_t count = 0;
  };

  void Stop(SourceMark mark, std::string what, std::string hint = "") {
    if (error_) return;
    error_ = BadInput(PlaceOf(file_, mark), std::move(what), std::move(hint));
  }

  YamlTree::Id Add(YamlKind kind, const YAML::Mark& mark, YAML::anchor_t anchor,
                   const std::string& tag = "?") {
    const SourceMark place = ToSourceMark(mark);
    if (tag != "?" && tag != "!" && !tag.empty()) {
      Stop(place, "the YAML tag `" + tag + "` is not part of the format",
           "write the value without a tag");
    }
    if (tree_.nodes.size() >= kMaxYamlNodes) {
      Stop(place, "more than " + std::to_string(kMaxYamlNodes) +
                      " values in one file");
    }
    if (error_) return YamlTree::kNoNode;
    const auto id = static_cast<YamlTree::Id>(tree_.nodes.size());
    tree_.nodes.push_back({.kind = kind, .mark = place});
    if (anchor != YAML::NullAnchor) {
      if (anchors_.size() <= anchor) anchors_.resize(anchor + 1);
      anchors_[anchor] = id;
    }
    if (!open_.empty()) Append(id, open_.back());
    return id;
  }

  void Append(YamlTree::Id id, Level& parent) {
    if (parent.last == YamlTree::kNoNode) {
      tree_.nodes[parent.id].first_child = id;
    } else {
      tree_.nodes[parent.last].next = id;
    }
    parent.previous = std::exchange(parent.last, id);
    ++parent.count;
  }

  void Open(YamlTree::Id id, bool is_map) {
    if (error_) return;
    open_.push_back({.id = id, .is_map = is_map});
    if (open_.size() > kMaxYamlDepth) {
      Stop(tree_.nodes[id].mark, "lists and maps are nested more than " +
                                     std::to_string(kMaxYamlDepth) +
                                     " levels deep");
    }
  }
  void Close() {
    if (!error_) open_.pop_back();
  }

  const std::string& file_;
  YamlTree tree_;
  std::vector<Level> open_;
  std::vector<YamlTree::Id> anchors_;  ///< By yaml-cpp's number.
  std::optional<Error> error_;
  int documents_ = 0;
};

/// Feeds the first document, and the start of a second one if there is any.
std::optional<Error> Build(const std::string& text, const std::string& file,
                           TreeBuilder& builder) {
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder) && !builder.error()) {
      parser.HandleNextDocument(builder);
    }
  } catch (const YAML::Exception& e) {
    if (builder.error()) return builder.error();
    const SourceMark mark =
        e.mark.is_null() ? SourceMark{} : ToSourceMark(e.mark);
    return BadInput(PlaceOf(file, mark), "not valid YAML: " + e.msg);
  } catch (const std::exception& e) {
    return BadInput(file, std::string("not readable as YAML: ") + e.what());
  }
  return builder.error();
}

}  // namespace

Result<YamlTree> ParseYaml(const std::string& text, const std::string& file) {
  RTB_RETURN_IF_ERROR(CheckYamlText(text, file));
  TreeBuilder builder(file);
  if (auto error = Build(text, file, builder)) return Fail(*error);
  if (builder.tree().nodes.empty()) {
    return Fail(BadInput(PlaceOf(file, {1, 1}),
                         "the file is empty, expected a scene",
                         "a scene begins with `rtbench_scene: 1`"));
  }
  return std::move(builder.tree());
}

std::string YamlNode::Describe() const {
  switch (kind()) {
    case YamlKind::kNull:
      return "empty";
    case YamlKind::kList:
      return "a list";
    case YamlKind::kMap:
      return "a map";
    case YamlKind::kScalar:
    case YamlKind::kAlias:
      break;
  }
  constexpr std::size_t kLongest = 40;
  std::string shown(text().substr(0, kLongest));
  if (text().size() > kLongest) shown += "...";
  return quoted() ? "the text \"" + shown + "\"" : "`" + shown + "`";
}

std::string PlaceOf(const std::string& file, SourceMark mark) {
  if (mark.line == 0) return file;
  return file + ":" + std::to_string(mark.line) + ":" +
         std::to_string(mark.column);
}

}  // namespace rtb
