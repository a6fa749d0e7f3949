#include "harness/live/device_cells.h"

#include "harness/arguments.h"

namespace rtb {

Result<std::optional<DevicePicture>> DeviceCells::Draw(
    Backend& backend, const DeviceRequest& request) {
  auto* const device = dynamic_cast<AheadBackend*>(&backend);
  if (device == nullptr) return std::nullopt;
  RTB_ASSIGN_OR_RETURN(DeviceEncoder* const encoder, Find(request.encoder));
  if (encoder == nullptr) return std::nullopt;
  const SamplePlan plan = encoder->Plan(request.grid, request.cell_aspect);
  RTB_RETURN_IF_ERROR(CheckSampleCount("--grid", plan));
  RTB_RETURN_IF_ERROR(
      encoder->Submit(*device, plan, request.options, request.exposure));
  DevicePicture picture;
  RTB_ASSIGN_OR_RETURN(picture.grid, encoder->Collect(*device));
  picture.samples_per_cell = plan.samples_per_cell;
  picture.rays = device->ray_counts();
  return picture;
}

Result<DeviceEncoder*> DeviceCells::Find(const std::string& spec) {
  const auto found = encoders_.find(spec);
  if (found != encoders_.end()) return found->second.get();
  auto made = make_(spec);
  // Bad input: another encoder, parameters or modifiers.
  if (!made && made.error().kind != ErrorKind::kBadInput) {
    return Fail(made.error());
  }
  auto& kept = encoders_[spec];
  if (made) kept = std::move(*made);
  return kept.get();
}

}  // namespace rtb
