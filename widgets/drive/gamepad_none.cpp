// Gamepad for builds without SDL 2: there is never one.
#include "widgets/drive/gamepad.h"

namespace usar::widgets {

class Gamepad::Reader {};

Gamepad::Gamepad(QObject* parent) : QObject(parent) {}

Gamepad::~Gamepad() = default;

bool Gamepad::supported() {
    return false;
}

void Gamepad::start() {}

} // namespace usar::widgets
