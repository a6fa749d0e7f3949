#include "harness/inputs.h"

#include <algorithm>
#include <memory>

#include "core/base/file.h"
#include "encoders/glyphs/font.h"
#include "encoders/glyphs/shape.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

/// Gathers files in the order in which they are named, each once.
class FileList {
 public:
  void Add(const std::string& role, const fs::path& file) {
    const Entry entry{role, file};
    const bool known =
        std::find(entries_.begin(), entries_.end(), entry) != entries_.end();
    if (!file.empty() && !known) entries_.push_back(entry);
  }

  void AddMeshes(const std::vector<Object>& objects) {
    for (const Object& object : objects) {
      if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
        Add("mesh", mesh->file);
      }
      AddMeshes(object.children);
    }
  }

  void AddImages(const Scene& scene) {
    if (const auto* image =
            std::get_if<ImageBackground>(&scene.background.kind)) {
      Add("image", image->file);
    }
    for (const Material& material : scene.materials) {
      if (const auto* image = std::get_if<ImageTexture>(&material.texture)) {
        Add("image", image->file);
      }
      if (material.bump) Add("image", material.bump->file);
    }
  }

  Status Hash(std::vector<InputFile>& inputs) const {
    for (const auto& [role, file] : entries_) {
      RTB_ASSIGN_OR_RETURN(InputFile input, HashedInput(role, file));
      inputs.push_back(std::move(input));
    }
    return {};
  }

 private:
  using Entry = std::pair<std::string, fs::path>;
  std::vector<Entry> entries_;
};

/// How many fonts of the chain are opened: for each glyph without a shape of
/// its own, all up to the first that has it (as GlyphSet does).
Result<std::size_t> CountOpened(const std::set<char32_t>& glyphs,
                                MaskSource masks,
                                const std::vector<fs::path>& chain) {
  std::vector<std::unique_ptr<Font>> fonts;
  for (const char32_t glyph : glyphs) {
    if (masks == MaskSource::kGeometric && ShapeOf(glyph)) continue;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (i == fonts.size()) {
        RTB_ASSIGN_OR_RETURN(auto font, Font::Open(chain[i]));
        fonts.push_back(std::move(font));
      }
      if (fonts[i]->Has(glyph)) break;
    }
  }
  return fonts.size();
}

}  // namespace

Result<InputFile> HashedInput(const std::string& role, const fs::path& file) {
  RTB_ASSIGN_OR_RETURN(const std::string sha256, Sha256File(file));
  return InputFile{role, file.filename().string(), sha256};
}

Result<std::vector<InputFile>> SceneInputs(const Scene& scene) {
  std::vector<InputFile> inputs = {
      {"scene", scene.file.filename().string(), scene.sha256}};
  FileList files;
  files.AddMeshes(scene.objects);
  files.AddImages(scene);
  RTB_RETURN_IF_ERROR(files.Hash(inputs));
  return inputs;
}

Result<std::vector<InputFile>> FontInputs(const std::set<char32_t>& glyphs,
                                          const DecodeOptions& options) {
  const std::vector<fs::path> chain = FontChain(options.font);
  RTB_ASSIGN_OR_RETURN(const std::size_t opened,
                       CountOpened(glyphs, options.masks, chain));
  std::vector<InputFile> inputs;
  for (std::size_t i = 0; i < opened; ++i) {
    RTB_ASSIGN_OR_RETURN(InputFile input, HashedInput("font", chain[i]));
    inputs.push_back(std::move(input));
  }
  return inputs;
}

Status CheckFont(const DecodeOptions& options) {
  if (options.font.empty()) return {};
  const auto font = Font::Open(options.font);
  if (font) return {};
  return Fail(font.error());
}

}  // namespace rtb
