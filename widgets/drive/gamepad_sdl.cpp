#include "widgets/drive/gamepad.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include <QThread>

#include "core/base/hand_over.h"

namespace usar::widgets {

namespace {

constexpr std::chrono::milliseconds look_every{8};
constexpr double dead_zone = 0.18; // Worn sticks rest up to this far from the center.

/// State of a pad at one moment.
struct PadState {
    Stick stick{};
    bool stop = false;
    bool take = false;
};

double axis(SDL_GameController* pad, SDL_GameControllerAxis which) {
    return std::clamp(SDL_GameControllerGetAxis(pad, which) / 32767.0, -1.0, 1.0);
}

/// Reads the pad. The signs are inverted, because SDL's axes point right and down.
PadState read(SDL_GameController* pad) {
    double turn = -axis(pad, SDL_CONTROLLER_AXIS_LEFTX);
    double forward = -axis(pad, SDL_CONTROLLER_AXIS_LEFTY);
    double left = -axis(pad, SDL_CONTROLLER_AXIS_RIGHTX);
    double up = -axis(pad, SDL_CONTROLLER_AXIS_RIGHTY);
    applyDeadZone(turn, forward, dead_zone);
    applyDeadZone(left, up, dead_zone);
    return {{forward, left, turn, up},
            SDL_GameControllerGetButton(pad, SDL_CONTROLLER_BUTTON_B) != 0,
            SDL_GameControllerGetButton(pad, SDL_CONTROLLER_BUTTON_START) != 0};
}

} // namespace

/// The reading thread. It polls states instead of using events, because SDL has one event queue for the whole program.
class Gamepad::Reader {
public:
    explicit Reader(Gamepad& owner) : owner_(owner), thread_(QThread::create([this] { run(); })) {
        thread_->setObjectName("gamepad");
        thread_->start();
    }
    ~Reader() {
        {
            const std::lock_guard lock(mutex_);
            over_ = true;
        }
        wake_.notify_all();
        thread_->wait();
    }

private:
    /// Runs a call with the owner in the owner's thread.
    template <class Call>
    void tell(Call call) {
        QMetaObject::invokeMethod(&owner_, HandedOver([&owner = owner_, call = std::move(call)] { call(owner); }));
    }
    void run();
    void look();
    void findPad();
    void losePad();

    Gamepad& owner_;
    std::unique_ptr<QThread> thread_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool over_ = false;
    SDL_GameController* pad_ = nullptr; ///< used by the reading thread only, as is `state_`
    PadState state_;
};

void Gamepad::Reader::run() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");               // The program has its own.
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1"); // SDL does not know our window.
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0)
        return;
    SDL_JoystickEventState(SDL_IGNORE);
    SDL_GameControllerEventState(SDL_IGNORE);
    tell([](Gamepad& owner) { emit owner.started(); });
    std::unique_lock lock(mutex_);
    while (!over_) {
        lock.unlock();
        look();
        lock.lock();
        wake_.wait_for(lock, look_every, [this] { return over_; });
    }
    if (pad_)
        SDL_GameControllerClose(pad_);
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void Gamepad::Reader::look() {
    SDL_JoystickUpdate();
    if (pad_ && !SDL_GameControllerGetAttached(pad_))
        losePad();
    if (!pad_)
        findPad();
    if (!pad_)
        return;
    const PadState now = read(pad_);
    const PadState before = std::exchange(state_, now);
    if (!(now.stick == before.stick))
        tell([stick = now.stick](Gamepad& owner) { emit owner.moved(stick); });
    if (now.stop && !before.stop)
        tell([](Gamepad& owner) { emit owner.stopPressed(); });
    if (now.take && !before.take)
        tell([](Gamepad& owner) { emit owner.takePressed(); });
}

void Gamepad::Reader::findPad() {
    for (int device = 0; device < SDL_NumJoysticks(); ++device) {
        if (!SDL_IsGameController(device))
            continue;
        pad_ = SDL_GameControllerOpen(device);
        if (!pad_)
            continue;
        state_ = {};
        return tell([name = QString::fromUtf8(SDL_GameControllerName(pad_))](Gamepad& owner) {
            owner.name_ = name;
            emit owner.plugged(name);
        });
    }
}

void Gamepad::Reader::losePad() {
    SDL_GameControllerClose(std::exchange(pad_, nullptr));
    tell([](Gamepad& owner) { emit owner.unplugged(std::exchange(owner.name_, QString())); });
}

Gamepad::Gamepad(QObject* parent) : QObject(parent) {}

Gamepad::~Gamepad() = default;

bool Gamepad::supported() {
    return true;
}

void Gamepad::start() {
    if (!reader_)
        reader_ = std::make_unique<Reader>(*this);
}

} // namespace usar::widgets
