#include "reference/work_folder.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/file.h"
#include "core/base/process.h"
#include "core/image/io.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

/// The last lines of what a program said, as one line.
std::string LastLines(const std::string& text, std::size_t limit = 400) {
  std::string tail =
      text.size() > limit ? text.substr(text.size() - limit) : text;
  std::replace(tail.begin(), tail.end(), '\n', ' ');
  return tail;
}

Result<double> ReadSeconds(const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(const std::string text, ReadFile(file, 100));
  double seconds = 0;
  std::from_chars(text.data(), text.data() + text.size(), seconds);
  return seconds;
}

}  // namespace

Status PrepareWorkFolder(const std::filesystem::path& folder,
                         const std::string& request_hash,
                         const std::vector<WorkFile>& files) {
  const auto key = folder / "request.sha256";
  const auto old = ReadFile(key, 1000);
  if (old && *old == request_hash) return {};
  std::error_code error;
  std::filesystem::remove_all(folder, error);
  if (error) return Fail(Failure(folder.string(), error.message()));
  for (const WorkFile& file : files) {
    RTB_RETURN_IF_ERROR(WriteFileAtomically(folder / file.name, file.bytes));
  }
  return WriteFileAtomically(key, request_hash);
}

Result<double> MakePiece(
    const std::filesystem::path& folder, const std::string& name,
    const std::function<Status(const std::string& output)>& render) {
  const auto finished = folder / (name + ".exr");
  const auto duration = folder / (name + ".seconds");
  std::error_code error;
  if (std::filesystem::exists(finished, error)) return ReadSeconds(duration);
  // A program that outlived an interrupted run may still be writing its own.
  const std::string part =
      name + "." + std::to_string(::getpid()) + ".part.exr";
  const auto start = std::chrono::steady_clock::now();
  RTB_RETURN_IF_ERROR(render(part));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
  RTB_RETURN_IF_ERROR(WriteFileAtomically(duration, PovNumber(seconds)));
  std::filesystem::rename(folder / part, finished, error);
  if (error) {
    return Fail(Failure((folder / part).string(), error.message()));
  }
  return seconds;
}

Result<Image> ReadPiece(const std::filesystem::path& folder,
                        const std::string& name, int width, int height) {
  const auto file = folder / (name + ".exr");
  Result<Image> image = ReadLinear(file);
  if (image && image->width() == width && image->height() == height) {
    return image;
  }
  std::error_code ignored;  // Else every later run would stumble over it.
  std::filesystem::remove(file, ignored);
  return Fail(Failure(
      file.string(),
      image ? "an image of another size than asked for" : image.error().what,
      "it was removed; run the same again"));
}

Status RunRenderer(const std::vector<std::string>& argv,
                   const std::filesystem::path& folder,
                   const std::string& place) {
  ProcessOptions options;
  options.argv = argv;
  options.directory = folder;
  RTB_ASSIGN_OR_RETURN(const ProcessResult result, RunProcess(options));
  if (result.exit_status == 0) return {};
  return Fail(Failure(place, argv.front() + " ended with status " +
                                 std::to_string(result.exit_status) + ": ..." +
                                 LastLines(result.out + result.err)));
}

std::string JoinedWords(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

Status WriteReference(const Image& image, nlohmann::ordered_json provenance,
                      const std::filesystem::path& output) {
  RTB_RETURN_IF_ERROR(WriteExr(output, image, ExrType::kHalf));
  RTB_ASSIGN_OR_RETURN(const std::string hash, Sha256File(output));
  provenance["image"] = {{"width", image.width()},
                         {"height", image.height()},
                         {"type", "half"},
                         {"sha256", hash}};
  // A file name or version text that is not UTF-8 must not throw.
  return WriteFileAtomically(
      output.string() + ".json",
      provenance.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
          "\n");
}

}  // namespace rtb
