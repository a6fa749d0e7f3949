#include "harness/provenance.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "reference/blender_export.h"
#include "reference/pov_export.h"
#include "reference/reference.h"

namespace rtb {
namespace {

/// What stands at a place of the provenance; null where there is nothing.
nlohmann::json At(const nlohmann::json& provenance, const char* place) {
  const nlohmann::json::json_pointer pointer(place);
  return provenance.contains(pointer) ? provenance.at(pointer)
                                      : nlohmann::json();
}

std::string Text(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool NamesImages(const Scene& scene) {
  if (std::holds_alternative<ImageBackground>(scene.background.kind)) {
    return true;
  }
  return std::any_of(
      scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return m.bump || std::holds_alternative<ImageTexture>(m.texture);
      });
}

bool ShowsScene(const nlohmann::json& provenance, const std::string& renderer,
                const Scene& scene, double time) {
  // The file's hash does not tell whether a mesh's or an image's has changed.
  const bool whole = scene.meshes.empty() && !NamesImages(scene);
  if (whole && At(provenance, "/scene/sha256") == scene.sha256) return true;
  if (renderer == "cycles") {
    const auto exported = ExportBlender(scene, time);
    return exported && At(provenance, "/export_sha256") == Sha256(*exported);
  }
  const auto exported = ExportPov(scene, time);
  return exported && At(provenance, "/sdl_sha256") == Sha256(*exported);
}

/// What of the provenance is not as expected; empty where all is.
std::string Misfit(const nlohmann::json& provenance,
                   const std::string& renderer, const Scene& scene,
                   double time) {
  const auto differs = [&](const char* place, const nlohmann::json& expected) {
    const nlohmann::json found = At(provenance, place);
    return found == expected ? std::string()
                             : Text(found) + ", expected " + Text(expected);
  };
  std::string wrong = differs("/schema", kProvenanceSchema);
  if (!wrong.empty()) return "has provenance of schema " + wrong;
  wrong = differs("/renderer", renderer);
  if (!wrong.empty()) return "was rendered by " + wrong;
  wrong = differs("/settings/time", time);
  if (!wrong.empty()) return "shows time " + wrong;
  if (!ShowsScene(provenance, renderer, scene, time)) {
    return "shows another version of this scene";
  }
  return {};
}

}  // namespace

Status CheckProvenance(const std::filesystem::path& image,
                       const std::string& renderer, const Scene& scene,
                       double time) {
  const std::string place = image.string();
  const auto text = ReadFile(place + ".json");
  if (!text) return Fail(BadInput(place, "has no provenance beside it"));
  const auto provenance = nlohmann::json::parse(*text, nullptr, false);
  if (!provenance.is_object()) {
    return Fail(BadInput(place, "has provenance that is no JSON object"));
  }
  const std::string misfit = Misfit(provenance, renderer, scene, time);
  if (!misfit.empty()) return Fail(BadInput(place, misfit));
  RTB_ASSIGN_OR_RETURN(const std::string sha256, Sha256File(image));
  if (At(provenance, "/image/sha256") == sha256) return {};
  return Fail(
      BadInput(place, "is not the image that its provenance describes"));
}

}  // namespace rtb
