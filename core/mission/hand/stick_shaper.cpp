#include "core/mission/hand/stick_shaper.h"

#include <cmath>

namespace usar::mission {

Stick StickShaper::follow(const Stick& asked, Seconds dt) {
    const double most = std::max(0.0, dt.count()) / rise.count();
    const auto follow = [most](double now, double wanted) {
        const double from = now * wanted > 0.0 ? now : 0.0; // A change of direction begins at rest.
        if (std::abs(wanted) <= std::abs(from))
            return wanted;
        return from + std::clamp(wanted - from, -most, most);
    };
    const Stick to = clamped(asked);
    now_ = {follow(now_.forward, to.forward), follow(now_.left, to.left), follow(now_.turn, to.turn),
            follow(now_.up, to.up)};
    return now_;
}

} // namespace usar::mission
