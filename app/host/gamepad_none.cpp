// Gamepad for builds without SDL 2: there is never one.
#include "app/host/gamepad.h"

namespace usar::app {

class Gamepad::Reader {};

Gamepad::Gamepad(QObject* parent) : QObject(parent) {}

Gamepad::~Gamepad() = default;

bool Gamepad::supported() {
    return false;
}

void Gamepad::start() {}

} // namespace usar::app
