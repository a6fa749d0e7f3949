#include "harness/sweep/identity.h"

#include <map>

#include "core/base/file.h"
#include "encoders/glyphs/glyph_set.h"
#include "harness/encoder_version.h"
#include "harness/inputs.h"
#include "harness/reference_choice.h"
#include "harness/results/unit_json.h"

namespace rtb {
namespace {

Json ToJson(const std::vector<InputFile>& inputs) {
  Json list = Json::array();
  for (const InputFile& input : inputs) {
    list.push_back({input.role, input.name, input.sha256});
  }
  return list;
}

/// The fonts that decoding may open.
Json FontHashes() {
  Json hashes = Json::array();
  for (const std::filesystem::path& font : FontChain({})) {
    hashes.push_back(Sha256File(font).value_or("none"));
  }
  return hashes;
}

/// What units of one scene depend on, read once.
class SceneIdentity {
 public:
  explicit SceneIdentity(const std::filesystem::path& file)
      : scene_(LoadNamedScene(file.string())) {
    const auto inputs =
        scene_ ? SceneInputs(*scene_->scene) : std::vector<InputFile>();
    if (inputs) inputs_ = ToJson(*inputs);
  }

  const Json& inputs() const { return inputs_; }

  /// The reference's name and hash.
  const Json& Reference(const SweepUnit& unit) {
    const UnitConfiguration& c = unit.configuration;
    const std::string key =
        unit.reference + "\n" + c.integrator + "\n" + std::to_string(c.time);
    const auto [at, added] = references_.emplace(key, Json());
    if (added && scene_) at->second = FindReference(unit);
    return at->second;
  }

 private:
  Json FindReference(const SweepUnit& unit) {
    scene_->options.time = unit.configuration.time;
    scene_->options.integrator = unit.configuration.integrator;
    const auto source = FindReferenceSource(unit.reference, *scene_);
    if (!source) return nullptr;
    const std::string hash =
        source->file.empty() ? "" : Sha256File(source->file).value_or("none");
    return {source->name, hash};
  }

  Result<PreparedScene> scene_;
  Json inputs_;
  std::map<std::string, Json> references_;
};

/// The text that is hashed.
Json Facts(const SweepUnit& unit, SceneIdentity& scene, const Json& fonts) {
  Json versions = Json::array();
  for (const std::string& encoder : unit.configuration.encoders) {
    const auto spec = ParseEncoderSpec(encoder);
    versions.push_back(spec ? EncoderVersion(*spec) : "");
  }
  Json facts = {{"schema", kRecordSchema},
                {"program", GetBuildInfo().version},
                {"unit", ConfigurationKey(unit.kind, unit.configuration)},
                {"inputs", scene.inputs()},
                {"versions", versions},
                {"repeat", unit.repeat},
                {"frames", unit.frames},
                {"fps", unit.fps}};
  if (unit.kind == UnitKind::kQuality) {
    facts["reference"] = scene.Reference(unit);
    facts["pictures"] = unit.pictures;
  }
  if (!IsTimed(unit.kind)) facts["fonts"] = fonts;
  return facts;
}

}  // namespace

void Identify(std::vector<SweepUnit>& units) {
  constexpr std::size_t kDigits = 16;
  const Json fonts = FontHashes();
  std::map<std::filesystem::path, std::vector<SweepUnit*>> scenes;
  for (SweepUnit& unit : units) scenes[unit.scene_file].push_back(&unit);
  for (auto& [file, members] : scenes) {
    SceneIdentity scene(file);
    for (SweepUnit* unit : members) {
      const std::string text =
          Facts(*unit, scene, fonts)
              .dump(-1, ' ', false, Json::error_handler_t::replace);
      unit->hash = Sha256(text).substr(0, kDigits);
    }
  }
}

}  // namespace rtb
