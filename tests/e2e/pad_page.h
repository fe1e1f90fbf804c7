// A window with a robot that a gamepad drives.
#pragma once

#include <utility>

#include <SDL.h>

#include "tests/e2e/drive_page.h"

/// Plugged in from its making to its end.
class VirtualPad {
public:
    VirtualPad() : index_(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0)) {
        stick_ = SDL_JoystickOpen(index_);
        for (int axis = 0; axis < 4; ++axis)
            SDL_JoystickSetVirtualAxis(stick_, axis, 0);
    }
    ~VirtualPad() { unplug(); }
    void unplug() {
        if (!stick_)
            return;
        for (int device = 0; device < SDL_NumJoysticks(); ++device)
            if (SDL_JoystickGetDeviceInstanceID(device) == SDL_JoystickInstanceID(stick_)) {
                SDL_JoystickDetachVirtual(device);
                break;
            }
        SDL_JoystickClose(std::exchange(stick_, nullptr));
    }
    bool made() const { return stick_ != nullptr; }
    /// -1..1, as SDL counts: to the right and down.
    void push(SDL_GameControllerAxis axis, double share) {
        SDL_JoystickSetVirtualAxis(stick_, axis, static_cast<Sint16>(share * 32767.0));
    }
    void press(SDL_GameControllerButton button, bool down) {
        SDL_JoystickSetVirtualButton(stick_, button, down ? 1 : 0);
    }

private:
    int index_;
    SDL_Joystick* stick_ = nullptr;
};

/// With a P2DX that the person has taken.
struct PadPage : DrivePage {
    bool ready() {
        if (!QTest::qWaitFor([this] { return hasStartPoses(); }, soon_ms) || !spawnClass("P2DX"))
            return false;
        openDock();
        bool started = false;
        QObject::connect(&window().drive().gamepad(), &usar::widgets::Gamepad::started, &window(),
                         [&] { started = true; });
        return takeControl() && QTest::qWaitFor([&] { return started; }, soon_ms);
    }
    QString padName() { return window().drive().gamepad().name(); }
};
