/// @file
/// SuiteReader: what the parts of the suite's reading share. Errors gather in
/// the ReadContext, as in the scene loader.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/yaml_reader.h"
#include "core/scene/yaml_scalars.h"
#include "harness/sweep/suite.h"

namespace rtb {

/// A suite under construction.
class SuiteReader {
 public:
  SuiteReader(std::filesystem::path file, const DataFolders& folders,
              ReadContext& context)
      : file_(std::move(file)), folders_(folders), context_(context) {}

  /// Reads the whole file; the context says whether that went well.
  Suite Read(YamlNode root);

 private:
  /// The keys of a matrix over what `matrix` holds already.
  void ReadMatrix(MapReader& map, SuiteMatrix& matrix);
  void ReadExclude(MapReader& map, SuiteMatrix& matrix);
  void ReadTemporal(MapReader& root, Suite& suite);
  void ReadLive(MapReader& root, Suite& suite);
  /// The whole list of matrices, or the top level alone.
  void ReadMatrices(MapReader& root, Suite& suite);
  /// Whether the top level, without `matrix`, says enough.
  void CheckTopLevel(MapReader& root, Suite& suite);

  SuiteScene ToScene(YamlNode node);
  std::string ToEncoder(YamlNode node);
  std::string ToBackend(YamlNode node);
  std::string ToReference(YamlNode node, SuiteMatrix& matrix);
  std::uint64_t ToSeed(YamlNode node);
  ColorDepth ToColor(YamlNode node);
  GridSize ToGrid(YamlNode node);
  UnitKind ToKind(YamlNode node);
  std::string ToWord(YamlNode node, std::string_view label,
                     const std::vector<std::string>& words);
  /// What stands for a value of `key` in an exclude rule.
  std::string ToExcluded(YamlNode node, const std::string& key);

  /// The list under `key`, if it is there, in place of `values`.
  template <class T, class Read>
  void List(MapReader& map, std::string_view key, std::vector<T>& values,
            Read read) {
    const auto node = map.Find(key);
    if (!node) return;
    values.clear();
    for (const YamlNode& item : ItemsOf(*node, key, 1, kMostItems, context_)) {
      values.push_back(read(item));
    }
  }
  void Scenes(MapReader& map, std::vector<SuiteScene>& scenes);
  void Encoders(MapReader& map, std::vector<std::string>& encoders);
  void Grid(MapReader& map, GridSize& grid);
  /// Notes an error where a list that has no default was not given.
  void RequireLists(const MapReader& map, const SuiteMatrix& matrix);

  static constexpr std::size_t kMostItems = 10000;

  std::filesystem::path file_;
  const DataFolders& folders_;
  ReadContext& context_;
};

}  // namespace rtb
