#include <cmath>
#include <string>

#include "core/base/file.h"
#include "core/image/io.h"
#include "encoders/emit/emit.h"
#include "encoders/parse/parse.h"
#include "encoders/registry.h"
#include "harness/cell_shape.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/image_source.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

struct EncodeOptions {
  std::string input;
  SceneRequest scene;
  std::string encoder;
  std::string previous;  ///< Cells of the last frame, or empty.
  ColorDepth depth = ColorDepth::kTruecolor;
  GridSize grid{120, 40};
  Fit fit = Fit::kContain;
  DecodeOptions decode;
  std::string format;  ///< Empty: by the output's extension, else ansi.
  std::string output = "-";
};

/// The picture to encode, exposed.
Result<Image> ReadInput(const EncodeOptions& options) {
  const bool from_stdin = options.input == "-";
  std::string bytes;
  if (from_stdin) {
    RTB_ASSIGN_OR_RETURN(bytes, ReadStandardInput());
  }
  RTB_ASSIGN_OR_RETURN(
      Image image, from_stdin ? ReadLinearFromMemory(bytes, "standard input")
                              : ReadLinear(options.input));
  const auto gain =
      static_cast<float>(std::exp2(options.scene.exposure.value_or(0)));
  for (Rgb& pixel : image.pixels()) pixel *= gain;
  return image;
}

/// The last frame; of no cells when none is given.
Result<CellGrid> ReadPrevious(const EncodeOptions& options) {
  if (options.previous.empty()) return CellGrid();
  RTB_ASSIGN_OR_RETURN(const std::string text, ReadFile(options.previous));
  RTB_ASSIGN_OR_RETURN(CellGrid cells, ParseCellsJson(text, options.previous));
  if (cells.size == options.grid) return cells;
  return Fail(BadInput(options.previous,
                       "has " + std::to_string(cells.size.columns) + " x " +
                           std::to_string(cells.size.rows) +
                           " cells, expected those of --grid",
                       "name the same --grid for all frames"));
}

Result<CellGrid> EncodeFrom(FragmentSource& source, const Encoder& encoder,
                            const EncodeOptions& options) {
  EncodeContext context;
  context.seed = options.scene.options.seed;
  context.threads = options.scene.options.threads;
  context.depth = options.depth;
  RTB_ASSIGN_OR_RETURN(const CellGrid previous, ReadPrevious(options));
  if (!options.previous.empty()) context.previous = &previous;
  RTB_ASSIGN_OR_RETURN(TimedEncoding run,
                       RunEncoder(encoder, source, options.grid,
                                  CellAspect(options.decode), context));
  return std::move(run.encoding.grid);
}

Result<CellGrid> EncodeInput(const EncodeOptions& options) {
  RTB_ASSIGN_OR_RETURN(const auto encoder, MakeEncoder(options.encoder));
  if (options.input.empty()) {
    RTB_ASSIGN_OR_RETURN(const PreparedScene scene,
                         PrepareScene(options.scene));
    SceneSource source = scene.Source();
    return EncodeFrom(source, *encoder, options);
  }
  RTB_ASSIGN_OR_RETURN(const Image image, ReadInput(options));
  ImageSource source(image, options.fit, options.scene.options.threads);
  return EncodeFrom(source, *encoder, options);
}

Status WritePicture(const CellGrid& grid, const EncodeOptions& options) {
  if (options.output == "-" && OutputIsTerminal()) {
    return Fail(
        BadInput("--output", "a PNG does not go to a terminal", "give a file"));
  }
  DecodeOptions decode = options.decode;
  decode.threads = options.scene.options.threads;
  RTB_ASSIGN_OR_RETURN(const Image image, Decode(grid, decode));
  RTB_ASSIGN_OR_RETURN(const std::string png, EncodePng(image));
  return WriteOutput(options.output, png);
}

Result<std::string> FormatOf(const EncodeOptions& options) {
  if (!options.format.empty()) return options.format;
  const std::string extension = LowerExtension(options.output);
  for (const char* format : {"json", "svg", "png", "ansi"}) {
    if (extension == "." + std::string(format)) return format;
  }
  if (extension.empty() || extension == ".ans" || extension == ".txt") {
    return "ansi";
  }
  return Fail(BadInput("--output", "no format has the extension " + extension,
                       "take .ansi, .json, .svg or .png, or name --format"));
}

Status Encode(const EncodeOptions& options) {
  if (options.input.empty() == options.scene.scene.empty()) {
    return Fail(BadInput("encode", "expected either --input or --scene"));
  }
  RTB_ASSIGN_OR_RETURN(const std::string format, FormatOf(options));
  if (format == "png") {  // before the work
    RTB_RETURN_IF_ERROR(RasterSize(options.grid, CellOf(options.decode)));
  }
  RTB_ASSIGN_OR_RETURN(const CellGrid grid, EncodeInput(options));
  if (format == "png") return WritePicture(grid, options);
  if (format == "json") {
    return WriteOutput(options.output, EmitJson(grid));
  }
  if (format == "svg") {
    return WriteOutput(options.output, EmitSvg(grid, options.decode.cell_width,
                                               options.decode.cell_height));
  }
  return WriteOutput(options.output, EmitAnsi(grid, options.depth));
}

void AddOptions(CLI::App& app, EncodeOptions& options) {
  AddText(app, {"--input", "IMAGE|-", "", "Image to encode; - reads stdin"},
          options.input);
  AddSceneOptions(app, options.scene);
  AddText(app,
          {"--encoder", "SPEC", "", "name[:key=value...]; see `list encoders`"},
          options.encoder)
      ->required();
  AddText(app,
          {"--previous", "CELLS.json", "",
           "The last frame, for temporal=Z: what --format=json wrote"},
          options.previous);
  AddColorDepth(app, options.depth);
  AddGrid(app, options.grid, "120x40");
  AddParsed(app,
            {"--fit", "contain|stretch|cover", "contain",
             "How an image of another aspect fits the grid"},
            options.fit, ParseFit);
  AddDecodeOptions(app, options.decode);
  AddWord(app,
          {"--format", "ansi|json|svg|png", "by --output's extension, or ansi",
           "What is written"},
          options.format, {"ansi", "json", "svg", "png"});
  AddText(app, {"--output", "FILE|-", "-", "Where to"}, options.output);
}

}  // namespace

void AddEncode(CLI::App& program, Action& selected) {
  AddCommand<EncodeOptions>(program, selected, "encode",
                            "Encodes an image or a scene as cells", AddOptions,
                            Encode);
}

}  // namespace rtb
