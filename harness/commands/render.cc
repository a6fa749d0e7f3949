#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

#include "core/image/io.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"

namespace rtb {
namespace {

constexpr int kMaxFrames = 100000;

struct RenderCommandOptions {
  SceneRequest scene;
  PixelSize size{960, 640};
  int frames = 0;  ///< 0 = one image under the output's own name.
  double fps = 24;
  std::string output;
  bool quiet = false;
};

/// `name_0007.png` for `name.png`.
std::filesystem::path FrameFile(const std::filesystem::path& output,
                                int frame) {
  char number[16];
  std::snprintf(number, sizeof number, "_%04d", frame);
  std::filesystem::path file = output;
  return file.replace_filename(output.stem().string() + number +
                               output.extension().string());
}

Status RenderTo(const std::filesystem::path& file, const PreparedScene& scene,
                PixelSize size, double time,
                const std::function<void(double)>& progress) {
  RenderOptions options = scene.options;
  options.time = time;
  RTB_ASSIGN_OR_RETURN(const Image image,
                       RenderImage(*scene.backend, size, options, progress));
  return WriteRender(file, image, scene.exposure);
}

Status Render(const RenderCommandOptions& options) {
  RTB_RETURN_IF_ERROR(CheckRenderFile(options.output));
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene, PrepareScene(options.scene));
  const double start = scene.options.time;
  const auto progress = ProgressLine(options.quiet);
  if (options.frames == 0) {
    return RenderTo(options.output, scene, options.size, start,
                    [&](double share) { progress(share, "rendering"); });
  }
  for (int frame = 0; frame < options.frames; ++frame) {
    RTB_RETURN_IF_ERROR(
        RenderTo(FrameFile(options.output, frame), scene, options.size,
                 start + frame / options.fps, [&](double share) {
                   progress((frame + share) / options.frames, "frames");
                 }));
  }
  return {};
}

void AddOptions(CLI::App& app, RenderCommandOptions& options) {
  AddSceneOptions(app, options.scene);
  AddParsed(app, {"--size", "WxH", "960x640", "Pixels of the image"},
            options.size, ParseImageSize);
  CLI::Option* frames = AddInteger(
      app,
      {"--frames", "N", "",
       "Write a sequence NAME_0000.png, NAME_0001.png, ... from --time on"},
      options.frames, 1, kMaxFrames);
  AddParsed(app, {"--fps", "F", "24", "Frames per second of the sequence"},
            options.fps,
            [](const std::string& place, const std::string& text) {
              return ParseNumber(place, text, 0.001, 100000);
            })
      ->needs(frames);
  AddText(app,
          {"--output", "FILE", "",
           ".png or .ppm (ASCII P3) as displayed, .exr linear"},
          options.output)
      ->required();
  AddQuiet(app, options.quiet);
}

}  // namespace

void AddRender(CLI::App& program, Action& selected) {
  AddCommand<RenderCommandOptions>(program, selected, "render",
                                   "Renders an image or a sequence", AddOptions,
                                   Render);
}

}  // namespace rtb
