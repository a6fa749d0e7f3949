#include "core/base/file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>

#include <array>

#include "core/base/check.h"
#include "core/base/posix.h"

namespace rtb {

Result<std::string> ReadFile(const std::filesystem::path& file,
                             std::size_t limit) {
  const UniqueFd fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd.valid()) {
    return Fail(BadInput(file.string(), "cannot be read: " + ErrnoText()));
  }
  struct stat info {};
  if (::fstat(fd.get(), &info) == 0 && S_ISDIR(info.st_mode)) {
    return Fail(BadInput(file.string(), "is a folder, expected a file"));
  }
  std::string bytes;
  const std::size_t one_more = limit == SIZE_MAX ? limit : limit + 1;
  if (const int code = ReadAll(fd.get(), one_more, &bytes)) {
    return Fail(Failure(file.string(), "cannot be read: " + ErrnoText(code)));
  }
  if (bytes.size() > limit) {
    return Fail(BadInput(file.string(), "is longer than the " +
                                            std::to_string(limit) +
                                            " bytes accepted here"));
  }
  return bytes;
}

std::string Sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  RTB_CHECK_EQ(EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size,
                          EVP_sha256(), nullptr),
               1);
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    text += "0123456789abcdef"[digest[i] >> 4];
    text += "0123456789abcdef"[digest[i] & 15];
  }
  return text;
}

Result<std::string> Sha256File(const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(file));
  return Sha256(bytes);
}

}  // namespace rtb
