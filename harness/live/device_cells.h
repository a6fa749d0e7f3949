/// @file
/// DeviceCells: pictures whose cells a GPU chooses, so that no sample of them
/// comes to the host.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "encoders/cuda/device_encoder.h"

namespace rtb {

/// A whole picture to draw.
struct DeviceRequest {
  std::string encoder;  ///< SPEC.
  GridSize grid;
  double cell_aspect = 0.5;
  RenderOptions options;
  double exposure = 0;  ///< Stops.
};

/// It, and what it took.
struct DevicePicture {
  CellGrid grid;
  int samples_per_cell = 0;
  RayCounts rays;
};

/// Keeps the device's encoders between pictures. For one thread.
class DeviceCells {
 public:
  using Maker = std::function<Result<std::unique_ptr<DeviceEncoder>>(
      const std::string& name)>;

  /// @param make DeviceEncoder::Make, or what stands in for it.
  explicit DeviceCells(Maker make = DeviceEncoder::Make)
      : make_(std::move(make)) {}

  /// Draws the picture where the backend is a device's and has the encoder;
  /// none where the samples must come to the host.
  /// @param backend no frame of it is under way.
  Result<std::optional<DevicePicture>> Draw(Backend& backend,
                                            const DeviceRequest& request);

 private:
  /// Null for an encoder that the device has not.
  Result<DeviceEncoder*> Find(const std::string& spec);

  Maker make_;
  std::map<std::string, std::unique_ptr<DeviceEncoder>> encoders_;
};

}  // namespace rtb
