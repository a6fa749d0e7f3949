#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <sys/mman.h>

#include <exception>
#include <system_error>

#include "core/base/file.h"
#include "core/base/posix.h"
#include "core/image/io.h"
#include "core/image/orientation.h"
#include "core/image/raster.h"

namespace rtb {
namespace {

/// One line of what a library says of `path`, about `name` instead.
std::string Reworded(std::string message, const std::string& path,
                     const std::string& name) {
  for (auto at = message.find(path); at != std::string::npos;
       at = message.find(path, at + name.size())) {
    message.replace(at, path.size(), name);
  }
  return message.substr(0, message.find('\n'));
}

/// A path to an open file.
std::string DescriptorPath(const UniqueFd& fd) {
  return "/proc/self/fd/" + std::to_string(fd.get());
}

/// @param path where the image is; @param name what Errors call it.
Result<Image> ReadPath(const std::string& path, const std::string& name,
                       Codes codes) try {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path, &config);
  if (!input) {
    return Fail(BadInput(name, "is not an image that can be read: " +
                                   Reworded(OIIO::geterror(), path, name)));
  }
  input->threads(1);  // no threads but those that a caller asked for
  auto image = ReadRaster(*input, name, codes);
  if (!image) {
    image.error().what = Reworded(image.error().what, path, name);
    return image;
  }
  return Upright(*std::move(image),
                 input->spec().get_int_attribute("Orientation", 1));
} catch (const std::exception& error) {
  return Fail(Failure(name, std::string("cannot be read: ") + error.what()));
}

/// A file's bytes, wherever they come from.
Result<Image> ReadBytes(const std::string& bytes, const std::string& name,
                        Codes codes) {
  // Not every reader takes memory, but all take a path: a nameless file.
  const UniqueFd fd(::memfd_create("image", MFD_CLOEXEC));
  const int code = fd.valid() ? WriteAll(fd.get(), bytes) : errno;
  if (code) return Fail(Failure(name, "cannot be kept: " + ErrnoText(code)));
  return ReadPath(DescriptorPath(fd), name, codes);
}

Result<Image> ReadImage(const std::filesystem::path& file, Codes codes) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    // A pipe can be read but once, yet readers of several formats take a look.
    RTB_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(file));
    return ReadBytes(bytes, file.string(), codes);
  }
  const UniqueFd fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd.valid()) {
    return Fail(BadInput(file.string(), "cannot be read: " + ErrnoText()));
  }
  // OpenImageIO takes what follows a question mark for options.
  const bool plain = file.string().find('?') == std::string::npos;
  return ReadPath(plain ? file.string() : DescriptorPath(fd), file.string(),
                  codes);
}

}  // namespace

Result<Image> ReadLinear(const std::filesystem::path& file) {
  return ReadImage(file, Codes::kSrgb);
}

Result<Image> ReadLinearFromMemory(const std::string& bytes,
                                   const std::string& name) {
  return ReadBytes(bytes, name, Codes::kSrgb);
}

Result<Image> ReadValues(const std::filesystem::path& file) {
  return ReadImage(file, Codes::kValues);
}

}  // namespace rtb
