#include "harness/measure/converged_image.h"

#include <optional>

#include "core/image/io.h"
#include "harness/inputs.h"
#include "harness/measure/cache.h"

namespace rtb {
namespace {

RenderOptions ConvergedOptions(const PreparedScene& scene, double time) {
  RenderOptions options;
  options.time = time;
  options.threads = scene.options.threads;
  options.integrator = scene.options.integrator;
  options.spp = ConvergedSpp(options.integrator);
  return options;
}

/// All that the image depends on, a line each.
Result<std::string> InputsOf(const PreparedScene& scene, PixelSize size,
                             const RenderOptions& options) {
  RTB_ASSIGN_OR_RETURN(const std::vector<InputFile> files,
                       SceneInputs(*scene.scene));
  std::string text = "program " + ProgramIdentity() + "\n";
  for (const InputFile& file : files) {
    text += file.role + " " + file.sha256 + "\n";
  }
  return text + "backend " + scene.backend->name() + "\nintegrator " +
         options.integrator + "\nspp " + std::to_string(options.spp) +
         "\ntime " + ExactText(options.time) + "\nsize " +
         std::to_string(size.width) + "x" + std::to_string(size.height) + "\n";
}

/// The image of a file that holds one of that size. Anything else, half a file
/// of another program's making too, is no image and will be made anew.
std::optional<Image> ReadCached(const std::filesystem::path& file,
                                PixelSize size) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  auto image = ReadLinear(file);
  if (!image || PixelSize{image->width(), image->height()} != size) {
    return std::nullopt;
  }
  return *std::move(image);
}

}  // namespace

int ConvergedSpp(const std::string& integrator) {
  return integrator == "path" ? kSelfReferencePathSpp : kSelfReferenceSpp;
}

Result<Image> ConvergedImage(const PreparedScene& scene, double time,
                             PixelSize size,
                             const std::filesystem::path& cache) {
  const RenderOptions options = ConvergedOptions(scene, time);
  if (cache.empty()) return RenderImage(*scene.backend, size, options);
  RTB_ASSIGN_OR_RETURN(const std::string inputs,
                       InputsOf(scene, size, options));
  const std::filesystem::path file =
      cache / CacheName("converged", inputs, ".exr");
  if (auto cached = ReadCached(file, size)) return *std::move(cached);
  RTB_ASSIGN_OR_RETURN(Image image, RenderImage(*scene.backend, size, options));
  Status written = WriteExr(file, image, ExrType::kFloat);
  if (written) return image;
  written.error().hint = "set RTBENCH_CACHE to a folder that can be written";
  return Fail(std::move(written.error()));
}

}  // namespace rtb
