// Encoder `external:COMMAND`: whatever a program prints for an image file.
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/process.h"
#include "core/base/scratch_folder.h"
#include "core/image/io.h"
#include "encoders/parameters.h"
#include "encoders/parse/command_words.h"
#include "encoders/parse/parse.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr char kInput[] = "{input}";
constexpr char kColumns[] = "{cols}";
constexpr char kRows[] = "{rows}";

const EncoderParameter& CommandParameter() {
  static const EncoderParameter parameter{
      "command", "", "program and arguments",
      "the rest of the SPEC; {input} is a PNG, {cols} and {rows} the grid"};
  return parameter;
}

const EncoderParameter& SamplesParameter() {
  static const EncoderParameter parameter{
      "samples", "8x16", "WxH", "pixels of the PNG in each cell, 1..64"};
  return parameter;
}

const EncoderParameter& TimeoutParameter() {
  static const EncoderParameter parameter{"timeout", "30", "integer >= 1",
                                          "seconds after which it is ended"};
  return parameter;
}

/// Fixed when the encoder is made.
struct Command {
  std::vector<std::string> words;
  int width = 0;
  int height = 0;
  int timeout_seconds = 0;
};

std::string Replaced(std::string text, const std::string& what,
                     const std::string& by) {
  for (std::size_t at = text.find(what); at != text.npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// What a terminal of that many colors tells programs of itself.
std::vector<std::string> Environment(GridSize grid, ColorDepth depth) {
  const char* term = "xterm-256color";
  if (depth == ColorDepth::k16) term = "xterm-16color";
  if (depth == ColorDepth::kMono) term = "xterm-mono";
  const bool truecolor = depth == ColorDepth::kTruecolor;
  return {std::string("TERM=") + term,
          std::string("COLORTERM=") + (truecolor ? "truecolor" : ""),
          "COLUMNS=" + std::to_string(grid.columns),
          "LINES=" + std::to_string(grid.rows)};
}

/// The fragments of a regular plan as the picture they make, sRGB-encoded.
Image Picture(const Fragments& fragments, int width, int height) {
  const GridSize grid = fragments.grid;
  Image image(grid.columns * width, grid.rows * height);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int cell = y / height * grid.columns + x / width;
      const int sample = y % height * width + x % width;
      image.at(x, y) = fragments.cell(cell)[static_cast<std::size_t>(sample)];
    }
  }
  return DisplayEncoded(image, 0, true);
}

/// What a program said before it failed, on one line.
std::string LastWords(const ProcessResult& result) {
  constexpr std::size_t kLongest = 500;
  std::string text = result.err;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (text.size() > kLongest)
    text = "..." + text.substr(text.size() - kLongest);
  return text.empty() ? "" : ": " + text;
}

class External : public PlanEncoder {
 public:
  explicit External(Command command) : command_(std::move(command)) {}

 private:
  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, command_.width, command_.height, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    RTB_ASSIGN_OR_RETURN(const ScratchFolder folder, ScratchFolder::Make());
    const std::filesystem::path input = folder.path() / "input.png";
    RTB_RETURN_IF_ERROR(
        WritePng(input, Picture(fragments, command_.width, command_.height)));
    RTB_ASSIGN_OR_RETURN(const std::string printed,
                         Print(input.string(), fragments.grid, context.depth));
    return ParseAnsi(printed, fragments.grid);
  }

  /// Runs the program.
  Result<std::string> Print(const std::string& input, GridSize grid,
                            ColorDepth depth) const {
    ProcessOptions process;
    for (std::string word : command_.words) {
      word = Replaced(std::move(word), kInput, input);
      word = Replaced(std::move(word), kColumns, std::to_string(grid.columns));
      word = Replaced(std::move(word), kRows, std::to_string(grid.rows));
      process.argv.push_back(std::move(word));
    }
    process.environment = Environment(grid, depth);
    process.timeout_seconds = command_.timeout_seconds;
    RTB_ASSIGN_OR_RETURN(ProcessResult result, RunProcess(process));
    const std::string& name = command_.words.front();
    if (result.exit_status != 0) {
      return Fail(Failure(name, "ended with status " +
                                    std::to_string(result.exit_status) +
                                    LastWords(result)));
    }
    if (result.out.empty()) {
      return Fail(Failure(name, "printed nothing" + LastWords(result)));
    }
    return std::move(result.out);
  }

  Command command_;
};

/// A whole number from 1 to `high`; 0 for what is none.
int Natural(const std::string& text, int high) {
  if (text.empty() || text.size() > 6 ||
      text.find_first_not_of("0123456789") != text.npos) {
    return 0;
  }
  const int number = std::stoi(text);
  return number <= high ? number : 0;
}

Status ReadSamples(const std::string& text, Command& command) {
  const std::size_t x = text.find('x');
  if (x != text.npos) {
    command.width = Natural(text.substr(0, x), 64);
    command.height = Natural(text.substr(x + 1), 64);
  }
  if (command.width > 0 && command.height > 0) return {};
  return Fail(BadInput(
      "samples", "expected WxH with sides from 1 to 64, found '" + text + "'"));
}

/// The words, with a program that is there and a place for the picture.
Status ReadWords(const std::string& text, Command& command) {
  RTB_ASSIGN_OR_RETURN(command.words, CommandWords(text));
  if (command.words.empty()) {
    return Fail(BadInput("command", "is missing",
                         "external:PROGRAM ... {input}, for example "
                         "'external:chafa -s {cols}x{rows} {input}'"));
  }
  if (text.find(kInput) == text.npos) {
    return Fail(BadInput("command", "names no {input}",
                         "write {input} where the program takes its picture"));
  }
  if (FindProgram(command.words.front())) return {};
  return Fail(Missing(command.words.front(), "no such program was found",
                      "install it, or put its folder on PATH"));
}

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  Command command;
  RTB_RETURN_IF_ERROR(ReadWords(ValueOf(CommandParameter(), given), command));
  RTB_RETURN_IF_ERROR(ReadSamples(ValueOf(SamplesParameter(), given), command));
  const std::string& timeout = ValueOf(TimeoutParameter(), given);
  command.timeout_seconds = Natural(timeout, 86400);
  if (command.timeout_seconds == 0) {
    return Fail(
        BadInput("timeout",
                 "expected seconds from 1 to 86400, found '" + timeout + "'"));
  }
  return std::make_unique<External>(std::move(command));
}

}  // namespace

EncoderEntry external_entry() {
  EncoderInfo info{
      "external",
      "what a program prints for an image file",
      8 * 16,
      "the program's",
      {CommandParameter(), SamplesParameter(), TimeoutParameter()}};
  info.needs_parameters = true;
  return {info, Make};
}

}  // namespace rtb
