#include "core/image/orientation.h"

namespace rtb {

// EXIF 2.32, section 4.6.4 A: the value says where row 0 and column 0 of the
// stored image belong. From 5 on rows are columns.
Image Upright(Image image, int orientation) {
  if (orientation < 2 || orientation > 8) return image;
  const bool swap = orientation >= 5;
  const bool from_right = orientation == 2 || orientation == 3 ||
                          orientation == 7 || orientation == 8;
  const bool from_bottom = orientation == 3 || orientation == 4 ||
                           orientation == 6 || orientation == 7;
  Image upright(swap ? image.height() : image.width(),
                swap ? image.width() : image.height());
  for (int y = 0; y < upright.height(); ++y) {
    for (int x = 0; x < upright.width(); ++x) {
      const int column = swap ? y : x;
      const int row = swap ? x : y;
      upright.at(x, y) =
          image.at(from_right ? image.width() - 1 - column : column,
                   from_bottom ? image.height() - 1 - row : row);
    }
  }
  return upright;
}

}  // namespace rtb
