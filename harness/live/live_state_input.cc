// LiveState's keys and mouse.
#include <algorithm>
#include <cmath>

#include "harness/live/live_state.h"

namespace rtb {

void LiveState::Handle(const InputEvent& event, double now) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) HandleKey(*key, now);
  if (const auto* mouse = std::get_if<MouseEvent>(&event)) HandleMouse(*mouse);
}

void LiveState::HandleKey(const KeyEvent& key, double now) {
  if (key.key == kKeyShift) {
    held_.NoteShift(key.action != KeyAction::kRelease);
    return;
  }
  const auto motion = FindMotion(key);
  if (motion && !modes_.picker) {
    if (Camera() != nullptr) held_.Note(*motion, key, now);
    return;
  }
  if (key.action == KeyAction::kRelease) return;
  const auto command = FindCommand(key);
  if (modes_.picker && command != LiveCommand::kQuit) {
    HandlePicker(key);
  } else if (key.key == kKeyPageUp || key.key == kKeyPageDown) {
    if (FreeCamera* camera = Camera()) {
      camera->Zoom(key.key == kKeyPageUp ? -1 : 1);
    }
  } else if (command) {
    Apply(*command);
  }
}

void LiveState::HandlePicker(const KeyEvent& key) {
  const std::size_t count = choices_.scenes.size();
  if (key.key == kKeyEscape || key.key == U'l' || count == 0) {
    modes_.picker = false;
  } else if (key.key == kKeyUp) {
    modes_.picked = (modes_.picked + count - 1) % count;
  } else if (key.key == kKeyDown) {
    modes_.picked = (modes_.picked + 1) % count;
  } else if (key.key == kKeyEnter) {
    modes_.picker = false;
    view_.scene = choices_.scenes[modes_.picked];
    Log("scene " + view_.scene);
    Reset();
  }
}

void LiveState::HandleMouse(const MouseEvent& mouse) {
  if (mouse.action == MouseAction::kWheelUp ||
      mouse.action == MouseAction::kWheelDown) {
    if (FreeCamera* camera = Camera()) {
      camera->Zoom(mouse.action == MouseAction::kWheelUp ? -1 : 1);
    }
    return;
  }
  if (mouse.action == MouseAction::kRelease) {
    mouse_.reset();
    return;
  }
  if (mouse.action == MouseAction::kPress) {
    mouse_ = mouse;
    dragging_divider_ =
        view_.split && std::abs(mouse.column - view_.divider) <= 1;
    return;
  }
  if (!mouse_) return;
  if (dragging_divider_) {
    MoveDivider((mouse.column + 0.5) / std::max(view_.grid.columns, 1));
  } else if (FreeCamera* camera = Camera()) {
    // What is under the pointer stays under it.
    const double row = 2 * camera->frame().tan_half_vfov / view_.grid.rows;
    camera->Look((mouse_->column - mouse.column) * row * view_.cell_aspect,
                 (mouse.row - mouse_->row) * row);
  }
  mouse_ = mouse;
}

}  // namespace rtb
