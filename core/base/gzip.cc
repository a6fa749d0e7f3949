#include "core/base/gzip.h"

#include <zlib.h>

#include "core/base/check.h"

namespace rtb {

std::string Gzip(std::string_view bytes) {
  constexpr int kWindow = 15 + 16;  // The largest; 16: with gzip's header.
  constexpr int kMemory = 9;
  z_stream stream{};
  RTB_CHECK_EQ(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindow,
                            kMemory, Z_DEFAULT_STRATEGY),
               Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  RTB_CHECK_LE(bytes.size(), std::size_t{1} << 31);
  // zlib takes what it reads by a pointer that is not const.
  stream.next_in =
      reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // NOLINT
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  RTB_CHECK_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace rtb
