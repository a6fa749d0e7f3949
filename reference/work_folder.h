/// @file
/// The folder in which a reference grows: pieces of the work, each rendered by
/// a program run of its own, that stay there when the work is interrupted; and
/// the finished image with its provenance.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace rtb {

/// A file of the work folder.
struct WorkFile {
  std::string name;
  std::string bytes;
};

/// Makes the folder ready, with `files` in it. What is there already stays if
/// it belongs to the request of that hash, else it is removed.
Status PrepareWorkFolder(const std::filesystem::path& folder,
                         const std::string& request_hash,
                         const std::vector<WorkFile>& files);

/// Lets `render(file name)` write the piece `name`.exr, unless it lies there.
/// @return the seconds that this took, now or then.
Result<double> MakePiece(
    const std::filesystem::path& folder, const std::string& name,
    const std::function<Status(const std::string& output)>& render);

/// Reads a finished piece; one that is not an image of that size is removed,
/// so that the next run makes it again.
Result<Image> ReadPiece(const std::filesystem::path& folder,
                        const std::string& name, int width, int height);

/// Runs a program in a folder.
/// @param place what an Error names.
Status RunRenderer(const std::vector<std::string>& argv,
                   const std::filesystem::path& folder,
                   const std::string& place);

/// Words with spaces between.
std::string JoinedWords(const std::vector<std::string>& words);

/// Writes the image as half-float EXR and, beside it, its provenance, to which
/// the image's size and hash are added.
Status WriteReference(const Image& image, nlohmann::ordered_json provenance,
                      const std::filesystem::path& output);

}  // namespace rtb
